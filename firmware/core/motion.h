/* From lines to moves of one axis at a time, and of the peg. */
#ifndef WB_MOTION_H
#define WB_MOTION_H

#include "controller.h"

/* Every line goes through these in order, and skips what it has not. */
enum wb_phase {
    WB_NO_PHASE,
    WB_LEAVES_WIRE, /* homing only: the peg goes off a wire that it was bending, the way that it came */
    WB_PEG_CLEARS, /* the peg goes in before anything else moves */
    WB_FEEDS,
    WB_ROTATES,
    WB_GOES_NEAR,  /* to the side of the wire from which the peg bends */
    WB_PEG_COMES,
    WB_SWINGS,
    WB_BACKS_OFF,
    WB_PEG_GOES,
    WB_RETURNS,    /* to zero */
    /* homing */
    WB_LEAVES_SWITCH,
    WB_SEEKS_FAST,
    WB_LEAVES_AGAIN,
    WB_SEEKS_SLOW,
    WB_GOES_TO_ZERO,
    /* the peg by hand */
    WB_PEG_BY_HAND
};

/* Whether a line goes on or waits. */
bool wb_motion_busy(const struct wb_controller *c);
/* Begins what comes next, when what went before has ended. */
void wb_motion_run(struct wb_controller *c);
/* Forgets every line; the one that is made is over. */
void wb_motion_flush(struct wb_controller *c);
/* Turns the motor drivers off, at rest: nobody knows any more where the axes are. */
void wb_motion_release(struct wb_controller *c);
/* Latches an alarm: nothing moves until the machine is homed. */
void wb_motion_alarm(struct wb_controller *c, uint8_t alarm);

#endif
