/* What stops or holds the machine: STOP, alarms, inputs, a lost host; and the state that follows from them. */
#ifndef WB_SAFETY_H
#define WB_SAFETY_H

#include <stdbool.h>
#include <stdint.h>

#include "motion/inputs.h"
#include "motion/motion.h"
#include "motion/queue.h"
#include "serial/rx.h"

struct wb_safety {
    volatile bool stop_requested;    /* flag: a STOP has come that the main loop has not seen */
    volatile bool emergency_pressed; /* flag: the emergency stop was pressed; the main loop has not seen it */
    uint8_t alarm;                   /* code: WB_ALARM_... */
    bool alarm_pending;              /* flag: `alarm` was not reported to the host */
    bool input_hold;                 /* flag: the hold input holds */
    bool queue_hold;                 /* flag: no other line begins until the host resumes; it was lost */
};

/* Whether a line runs or waits. */
bool wb_busy(const struct wb_motion *motion, const struct wb_queue *queue);
/* One of WB_STATE_... */
uint8_t wb_state(const struct wb_safety *safety, const struct wb_motion *motion, const struct wb_queue *queue);

/* A STOP byte has come. From the serial interrupt: no pulse comes after it. */
void wb_safety_on_stop(struct wb_safety *safety, struct wb_motion *motion);
/* Raises the alarm of a STOP that has come. Lines that came before it are dropped: they must not leave that alarm. */
void wb_safety_handle_stop(struct wb_safety *safety, struct wb_rx *rx, struct wb_motion *motion,
                           struct wb_queue *queue);
/* Acts on inputs that are open, or were. The emergency stop latches an alarm; a hold is left by a resume. */
void wb_safety_handle_inputs(struct wb_safety *safety, const struct wb_inputs *inputs, struct wb_motion *motion,
                             struct wb_queue *queue);
/* The host is lost: the running line is finished, no other begins. */
void wb_safety_host_lost(struct wb_safety *safety);

/* Latches an alarm: everything stops, waiting lines are dropped, and nothing moves until the machine is homed. */
void wb_safety_raise(struct wb_safety *safety, struct wb_motion *motion, struct wb_queue *queue, uint8_t alarm);
/* Leaves the alarm for homing. false when a STOP or the emergency stop has come that was not seen yet. */
bool wb_safety_clear(struct wb_safety *safety, struct wb_motion *motion);
/* Leaves a hold. */
void wb_safety_resume(struct wb_safety *safety, struct wb_motion *motion);

#endif
