#include "safety.h"

bool wb_busy(const struct wb_motion *motion, const struct wb_queue *queue)
{
    return wb_motion_active(motion) || queue->count > 0;
}

uint8_t wb_state(const struct wb_safety *safety, const struct wb_motion *motion, const struct wb_queue *queue)
{
    if (safety->alarm != WB_ALARM_NONE && safety->alarm != WB_ALARM_HOST_LOST &&
        safety->alarm != WB_ALARM_HOLD_INPUT) {
        return WB_STATE_ALARM;
    }
    if (wb_motion_held(motion) || (safety->queue_hold && !wb_motion_active(motion))) {
        return WB_STATE_HOLD;
    }
    return wb_busy(motion, queue) ? WB_STATE_RUN : WB_STATE_IDLE;
}

void wb_safety_on_stop(struct wb_safety *safety, struct wb_motion *motion)
{
    wb_stepper_stop(&motion->stepper);
    safety->stop_requested = true;
}

void wb_safety_handle_stop(struct wb_safety *safety, struct wb_rx *rx, struct wb_motion *motion,
                           struct wb_queue *queue)
{
    void *board = motion->stepper.board;
    hal_lock(board);
    bool requested = safety->stop_requested;
    safety->stop_requested = false;
    if (requested) {
        wb_rx_drop_before_stop(rx);
    }
    hal_unlock(board);
    if (requested) {
        wb_safety_raise(safety, motion, queue, WB_ALARM_STOP);
    }
}

static void hold_by_input(struct wb_safety *safety, struct wb_motion *motion)
{
    wb_motion_hold(motion);
    safety->input_hold = true;
    safety->alarm = WB_ALARM_HOLD_INPUT;
    safety->alarm_pending = true;
}

void wb_safety_handle_inputs(struct wb_safety *safety, const struct wb_inputs *inputs, struct wb_motion *motion,
                             struct wb_queue *queue)
{
    bool pressed = safety->emergency_pressed; /* it may have been released since */
    if (pressed) {
        safety->emergency_pressed = false;
    }
    if (wb_state(safety, motion, queue) == WB_STATE_ALARM) {
        return;
    }
    if (pressed || wb_emergency_is_open(inputs)) {
        wb_safety_raise(safety, motion, queue, WB_ALARM_EMERGENCY);
    } else if (wb_hold_is_open(inputs) && !safety->input_hold) {
        hold_by_input(safety, motion);
    } else if (safety->input_hold && wb_hold_is_closed(inputs) && !wb_busy(motion, queue)) {
        /* There is nothing that would resume by itself. */
        wb_motion_resume(motion);
        safety->input_hold = false;
        safety->alarm = safety->queue_hold ? WB_ALARM_HOST_LOST : WB_ALARM_NONE;
    }
}

void wb_safety_host_lost(struct wb_safety *safety)
{
    safety->queue_hold = true;
    safety->alarm = WB_ALARM_HOST_LOST;
    safety->alarm_pending = true;
}

void wb_safety_raise(struct wb_safety *safety, struct wb_motion *motion, struct wb_queue *queue, uint8_t alarm)
{
    wb_motion_abort(motion);
    wb_queue_clear(queue, motion->stepper.position[WB_FEED], motion->stepper.position[WB_ROTATE]);
    safety->input_hold = false;
    safety->queue_hold = false;
    safety->alarm = alarm;
    safety->alarm_pending = true;
}

bool wb_safety_clear(struct wb_safety *safety, struct wb_motion *motion)
{
    void *board = motion->stepper.board;
    hal_lock(board);
    bool stopped = safety->stop_requested || safety->emergency_pressed;
    if (!stopped) {
        wb_stepper_unlatch(&motion->stepper);
    }
    hal_unlock(board);
    if (!stopped) {
        wb_safety_resume(safety, motion);
        safety->alarm_pending = false;
        motion->homed = false;
    }
    return !stopped;
}

void wb_safety_resume(struct wb_safety *safety, struct wb_motion *motion)
{
    wb_motion_resume(motion);
    safety->input_hold = false;
    safety->queue_hold = false;
    safety->alarm = WB_ALARM_NONE;
}
