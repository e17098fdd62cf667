/* Runs one line: its phases, one after the other, each a move of one axis or of the peg. */
#ifndef WB_MOTION_H
#define WB_MOTION_H

#include <stdbool.h>
#include <stdint.h>

#include "common/clock.h"
#include "common/codes.h"
#include "motion/homing.h"
#include "common/line.h"
#include "motion/motors.h"
#include "motion/peg.h"
#include "common/phase.h"
#include "storage/settings.h"
#include "motion/stepper.h"

/* What becomes of the line; where it fails, the alarm that follows. */
enum wb_motion_result {
    WB_MOTION_RUNNING = WB_ALARM_NONE,
    WB_MOTION_HIT_LIMIT = WB_ALARM_LIMIT,
    WB_MOTION_HOMING_FAILED = WB_ALARM_HOMING,
    WB_MOTION_LATE_PULSE = WB_ALARM_LATE_PULSE,
    WB_MOTION_FINISHED = 0xFF /* every phase is over */
};

/* The slowest that lines can be made, in percent of their speed. */
#define WB_SPEED_MIN 10

struct wb_motion {
    struct wb_stepper stepper;
    struct wb_homing homing;
    struct wb_peg peg;
    struct wb_motors motors;
    struct wb_line line; /* the one that runs */
    int32_t approach;    /* steps: of the line in which the peg came out last */
    uint8_t phase;       /* enum wb_phase */
    uint8_t waits_for;   /* enum: what ends the phase */
    uint8_t slower_by;   /* percent by which moves of lines are slower, 0 to 90, so that a start has all of it; homing is not */
    bool homed;          /* flag: moves are allowed; until an alarm, a release or a change of settings */
    bool located;        /* flag: the position of the bend axis is known; until a release */
};

/* Whether a line runs. */
bool wb_motion_active(const struct wb_motion *motion);
/* Begins a line, while none runs. */
void wb_motion_start(struct wb_motion *motion, const struct wb_line *line, const struct wb_clock *clock);
/* Advances the line that runs. A line that is finished stays so until wb_motion_end. */
enum wb_motion_result wb_motion_run(struct wb_motion *motion, const struct wb_settings *settings,
                                    const struct wb_clock *clock);
/* Ends the line that is finished. Gives its number. */
uint32_t wb_motion_end(struct wb_motion *motion);
/* Slows down and holds; resumes. */
void wb_motion_hold(struct wb_motion *motion);
void wb_motion_resume(struct wb_motion *motion);
bool wb_motion_held(const struct wb_motion *motion);
/* Stops at once and forgets the line. Nothing moves until the machine is homed. */
void wb_motion_abort(struct wb_motion *motion);
/* Turns the motor drivers off, when idle: from now on the positions of the axes are unknown. */
void wb_motion_release(struct wb_motion *motion);

#endif
