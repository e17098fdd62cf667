/* What the controller says, and what it says it with. Every reply wants room for WB_REPLY_MOST bytes. */
#ifndef WB_REPLIES_H
#define WB_REPLIES_H

#include "controller.h"

/* An alarm, or the last line that is made. */
void wb_tell_one(struct wb_controller *c, char letter, uint32_t one);
/* The last line that is taken, and how many more fit: as taken, or as full. */
void wb_tell_taken(struct wb_controller *c, char letter);
void wb_tell_boot(struct wb_controller *c);
void wb_tell_open(struct wb_controller *c);
void wb_tell_status(struct wb_controller *c);
void wb_tell_setting(struct wb_controller *c, uint8_t id);
/* An error of a command by its letter; 0 for a line that cannot be read. */
void wb_tell_refusal(struct wb_controller *c, uint8_t error, char command);

#endif
