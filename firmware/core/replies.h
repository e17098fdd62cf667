/* The replies to the host, one function a frame. Each wants room to send WB_REPLY_MAX bytes. */
#ifndef WB_REPLIES_H
#define WB_REPLIES_H

#include <stdint.h>

#include "storage/boot.h"
#include "controller.h"
#include "serial/session.h"
#include "storage/settings.h"

/* A reply with one number: an alarm, or the last line that is done. */
void wb_send_number(void *board, const struct wb_session *session, char letter, uint32_t number);
/* The last line that was accepted, and how many more fit. The letter says whether there was room for this one. */
void wb_send_accepted(void *board, const struct wb_session *session, char letter, uint8_t free_lines);
void wb_send_boot(void *board, const struct wb_boot *boot);
void wb_send_open(void *board, const struct wb_session *session, const struct wb_boot *boot);
void wb_send_setting(void *board, const struct wb_session *session, const struct wb_settings *settings, uint8_t id);
/* An error of the command with this letter; 0 for a line that cannot be read. */
void wb_send_error(void *board, const struct wb_session *session, uint8_t error, char command);
void wb_send_status(const struct wb_controller *controller);

#endif
