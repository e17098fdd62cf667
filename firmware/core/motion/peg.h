/* The peg: a servo moves it in and out. Its side of the wire is stored, so that after a reset in a bend it does not go
 * in while it presses on the wire. */
#ifndef WB_PEG_H
#define WB_PEG_H

#include <stdbool.h>
#include <stdint.h>

#include "common/clock.h"
#include "storage/settings.h"
#include "motion/stepper.h"

enum wb_peg_position { WB_PEG_IN, WB_PEG_OUT, WB_PEG_UNKNOWN };

struct wb_peg {
    uint8_t position;  /* enum wb_peg_position */
    int8_t wire_side;  /* sign of the bend in which it is out; 0 when it is clear of the wire */
    uint16_t moved_at; /* 1.024 ms: time at which the servo was commanded */
};

/* Sends it in or out; false when it is there. Not while a STOP latches the stepper: then it only seems to go. */
bool wb_peg_move(struct wb_peg *peg, const struct wb_stepper *stepper, const struct wb_settings *settings,
                 const struct wb_clock *clock, uint8_t target);
/* Whether it has had its time. `now` in ticks of 1.024 ms. */
bool wb_peg_arrived(const struct wb_peg *peg, const struct wb_settings *settings, uint16_t now);
/* Stores on which side of the wire it is: before it comes out, and after it is in. */
void wb_peg_set_wire_side(struct wb_peg *peg, void *board, int8_t side);

#endif
