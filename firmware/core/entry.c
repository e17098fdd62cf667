#include "entry.h"

#include "commands.h"
#include "common/compiler.h"
#include "hal.h"
#include "replies.h"
#include "serial/reply.h"
#include "storage/wire_side.h"

void wb_start(struct wb_controller *c, void *board, uint8_t reset)
{
    *c = (struct wb_controller){
        .board = board,
        .inputs = {.board = board},
        .session = {.id = WB_NO_SESSION},
        .motion = {.stepper = {.board = board}, .peg = {.position = WB_PEG_UNKNOWN}},
        .boot = {.cause = reset},
    };
    wb_settings_load(&c->settings, board);
    c->boot.count = wb_boot_count(board);
    c->motion.peg.wire_side = wb_wire_side_load(board);
    wb_inputs_configure(&c->inputs, &c->settings);
    if (reset == WB_RESET_WATCHDOG) {
        wb_safety_raise(&c->safety, &c->motion, &c->queue, WB_ALARM_WATCHDOG);
        c->safety.alarm_pending = false; /* the boot frame reports it */
    }
}

/* --- interrupts */

void wb_on_byte(struct wb_controller *c, uint8_t byte, bool damaged)
{
    if (byte == WB_STOP_BYTE) {
        wb_safety_on_stop(&c->safety, &c->motion);
    }
    wb_rx_put(&c->rx, byte, damaged);
}

void wb_on_tick(struct wb_controller *c)
{
    c->clock.ticks++;
    if (wb_inputs_tick(&c->inputs)) {
        wb_stepper_stop(&c->motion.stepper); /* the motors have no power any more */
        c->safety.emergency_pressed = true;
    }
}

bool wb_on_step(struct wb_controller *c)
{
    return wb_stepper_pulse(&c->motion.stepper);
}

void wb_on_step_rest(struct wb_controller *c)
{
    wb_stepper_plan(&c->motion.stepper);
}

bool wb_stepping(const struct wb_controller *c)
{
    return c->motion.stepper.moving;
}

/* --- main loop */

static void handle_frame(struct wb_controller *c)
{
    static const WB_FLASH uint8_t ERROR[] = {
        [WB_PARSE_UNKNOWN] = WB_ERROR_UNKNOWN, [WB_PARSE_RANGE] = WB_ERROR_RANGE};
    const char *payload = c->rx.frame.text;
    struct wb_command command = {0};
    c->session.heard_at = wb_clock_now(&c->clock, c->board);
    enum wb_parsed parsed = wb_parse(payload, &command);
    uint8_t error = parsed == WB_PARSED ? wb_dispatch(c, &command) : ERROR[parsed];
    if (error) {
        wb_send_error(c->board, &c->session, error, *payload);
    }
}

/* One line from the host. true when more bytes wait. */
static bool receive(struct wb_controller *c)
{
    if (hal_send_room(c->board) < WB_REPLY_MAX) {
        return false; /* every line may want a reply */
    }
    switch (wb_rx_next(&c->rx, c->session.id)) {
    case WB_RX_FRAME:
        handle_frame(c);
        break;
    case WB_RX_INVALID:
        wb_send_error(c->board, &c->session,
                      c->session.id == WB_NO_SESSION ? WB_ERROR_NO_SESSION : WB_ERROR_DAMAGED, 0);
        break;
    default:
        return false;
    }
    return wb_rx_waiting(&c->rx);
}

static void run_lines(struct wb_controller *c)
{
    if (!wb_motion_active(&c->motion)) {
        if (c->queue.count == 0 || wb_motion_held(&c->motion) || c->safety.queue_hold) {
            return;
        }
        wb_motion_start(&c->motion, wb_queue_first(&c->queue), &c->clock);
        wb_queue_remove_first(&c->queue);
    }
    enum wb_motion_result result = wb_motion_run(&c->motion, &c->settings, &c->clock);
    if (result == WB_MOTION_FINISHED) {
        /* The motors may have had no power at its end: an alarm follows, or it was a disturbance. */
        if (!wb_input_open(&c->inputs, WB_INPUT_EMERGENCY)) {
            wb_session_done(&c->session, wb_motion_end(&c->motion));
        }
    } else if (result != WB_MOTION_RUNNING) {
        wb_safety_raise(&c->safety, &c->motion, &c->queue, (uint8_t)result);
    }
}

static void watch_host(struct wb_controller *c)
{
    uint16_t now = wb_clock_now(&c->clock, c->board);
    if (!c->safety.queue_hold && wb_session_host_lost(&c->session, now, wb_busy(&c->motion, &c->queue))) {
        wb_safety_host_lost(&c->safety);
    }
}

/* The motors of an idle machine get hot for nothing. */
static void release_idle_motors(struct wb_controller *c)
{
    uint16_t now = wb_clock_now(&c->clock, c->board);
    uint8_t state = wb_state(&c->safety, &c->motion, &c->queue);
    bool at_rest = !wb_busy(&c->motion, &c->queue) && state != WB_STATE_HOLD;
    if (wb_motors_idle_too_long(&c->motion.motors, &c->settings, now, at_rest)) {
        wb_motion_release(&c->motion);
    }
}

static bool has_room(const struct wb_controller *c)
{
    return hal_send_room(c->board) >= WB_REPLY_MAX;
}

/* What was not reported to the host yet. */
static void send_news(struct wb_controller *c)
{
    if (!c->boot.sent && has_room(c)) {
        wb_send_boot(c->board, &c->boot);
        c->boot.sent = true;
    }
    if (c->safety.alarm_pending && has_room(c)) {
        wb_send_number(c->board, &c->session, WB_REPLY_ALARM, c->safety.alarm);
        c->safety.alarm_pending = false;
    }
    if (c->session.done_pending && has_room(c)) {
        wb_send_number(c->board, &c->session, WB_REPLY_DONE, c->session.done);
        c->session.done_pending = false;
    }
}

bool wb_poll(struct wb_controller *c)
{
    wb_safety_handle_stop(&c->safety, &c->rx, &c->motion, &c->queue);
    wb_safety_handle_inputs(&c->safety, &c->inputs, &c->motion, &c->queue);
    bool more = receive(c);
    run_lines(c);
    watch_host(c);
    release_idle_motors(c);
    send_news(c);
    return more;
}
