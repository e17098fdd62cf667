#include "commands.h"

#include "hal.h"
#include "motion/bend.h"
#include "motion/limits.h"
#include "replies.h"

/* Each command gives the error with which it is refused, or 0 when it was answered. */

static bool busy(const struct wb_controller *c)
{
    return wb_busy(&c->motion, &c->queue);
}

static bool in_alarm(const struct wb_controller *c)
{
    return wb_state(&c->safety, &c->motion, &c->queue) == WB_STATE_ALARM;
}

static uint8_t open_session(struct wb_controller *c, int32_t id)
{
    uint16_t before = c->session.id;
    uint8_t error = wb_session_open(&c->session, id, busy(c));
    if (!error) {
        if (c->session.id != before) {
            c->motion.slower_by = 0;
        }
        wb_send_open(c->board, &c->session, &c->boot);
    }
    return error;
}

/* --- lines */

static uint8_t validate_peg(const struct wb_peg *peg, int32_t out)
{
    if (peg->wire_side) {
        return WB_ERROR_NOT_HOMED; /* not while it presses on the wire */
    }
    return out == 0 || out == 1 ? 0 : WB_ERROR_RANGE;
}

/* Where the peg comes out, if a line says so. In a dry-run move it does not. */
static int32_t approach_of(const struct wb_command *line)
{
    return line->letter == WB_COMMAND_MOVE ? line->field[3] : 0;
}

/* Why a line cannot be accepted; 0 when it can. */
static uint8_t validate(const struct wb_controller *c, const struct wb_command *line)
{
    if (!c->settings.good) {
        return WB_ERROR_SETTINGS;
    }
    if (wb_input_open(&c->inputs, WB_INPUT_EMERGENCY)) {
        return WB_ERROR_EMERGENCY;
    }
    /* A line that began at an open door would have to be resumed by a person at once. */
    if (!busy(c) && wb_input_open(&c->inputs, WB_INPUT_HOLD)) {
        return WB_ERROR_HOLD_INPUT;
    }
    if (line->letter == WB_COMMAND_HOME) {
        return busy(c) ? WB_ERROR_NOT_IDLE : 0;
    }
    if (in_alarm(c)) {
        return WB_ERROR_IN_ALARM;
    }
    if (line->letter == WB_COMMAND_PEG) {
        return validate_peg(&c->motion.peg, line->field[0]);
    }
    if (!c->motion.homed) {
        return WB_ERROR_NOT_HOMED;
    }
    if (!wb_bend_possible(&c->settings, line->field[2], approach_of(line))) {
        return WB_ERROR_RANGE;
    }
    bool allowed = wb_limits_allow_move(&c->settings, &c->queue, line->field[0], line->field[1], line->field[2]) &&
                   wb_limits_allow_bend_axis(&c->settings, approach_of(line));
    return allowed ? 0 : WB_ERROR_SOFT_LIMIT;
}

static void queue_line(struct wb_queue *queue, const struct wb_command *command)
{
    struct wb_line line = {.n = command->n, .letter = command->letter, .feed = command->field[0]};
    if (command->letter == WB_COMMAND_MOVE || command->letter == WB_COMMAND_DRY) {
        line.rotate = command->field[1];
        line.bend = command->field[2];
        line.approach = approach_of(command);
        queue->planned_feed += line.feed;
        queue->planned_rotate += line.rotate;
    }
    wb_queue_push(queue, &line);
}

static uint8_t accept_line(struct wb_controller *c, const struct wb_command *command)
{
    enum wb_order order = wb_session_order(&c->session, command->n);
    if (order == WB_ORDER_GAP) {
        return WB_ERROR_GAP;
    }
    char letter = WB_REPLY_ACCEPTED;
    if (order == WB_ORDER_NEXT) {
        uint8_t error = validate(c, command);
        if (error) {
            return error;
        }
        if (wb_queue_free(&c->queue) == 0) {
            letter = WB_REPLY_FULL;
        } else if (command->letter == WB_COMMAND_HOME && !wb_safety_clear(&c->safety, &c->motion)) {
            return WB_ERROR_IN_ALARM;
        } else {
            queue_line(&c->queue, command);
            c->session.accepted = command->n;
        }
    }
    wb_send_accepted(c->board, &c->session, letter, wb_queue_free(&c->queue));
    return 0;
}

/* --- requests */

static uint8_t pause(struct wb_controller *c)
{
    if (in_alarm(c)) {
        return WB_ERROR_IN_ALARM;
    }
    wb_motion_hold(&c->motion);
    wb_send_status(c);
    return 0;
}

static uint8_t resume(struct wb_controller *c)
{
    if (in_alarm(c)) {
        return WB_ERROR_IN_ALARM;
    }
    if (wb_input_open(&c->inputs, WB_INPUT_HOLD)) {
        return WB_ERROR_HOLD_INPUT;
    }
    wb_safety_resume(&c->safety, &c->motion);
    wb_send_status(c);
    return 0;
}

static uint8_t set_speed(struct wb_controller *c, int32_t percent)
{
    if (percent != 0) {
        if (percent < WB_SPEED_MIN || percent > 100) {
            return WB_ERROR_RANGE;
        }
        c->motion.slower_by = (uint8_t)(100 - percent);
    }
    wb_send_number(c->board, &c->session, WB_REPLY_SPEED, 100u - c->motion.slower_by);
    return 0;
}

static uint8_t set_head(struct wb_controller *c, int32_t position)
{
    if (!c->settings.good) {
        return WB_ERROR_SETTINGS;
    }
    if (busy(c)) {
        return WB_ERROR_NOT_IDLE;
    }
    if (!wb_limits_allow_head(&c->settings, position)) {
        return WB_ERROR_SOFT_LIMIT;
    }
    c->motion.stepper.position[WB_ROTATE] = position;
    c->queue.planned_rotate = position;
    wb_send_status(c);
    return 0;
}

static uint8_t release(struct wb_controller *c)
{
    if (busy(c)) {
        return WB_ERROR_NOT_IDLE;
    }
    wb_motion_release(&c->motion);
    wb_send_status(c);
    return 0;
}

/* --- settings */

static uint8_t read_setting(const struct wb_controller *c, int32_t id)
{
    if (!c->settings.good) {
        return WB_ERROR_SETTINGS;
    }
    if (id < 1 || id > WB_SETTINGS_COUNT) {
        return WB_ERROR_UNKNOWN;
    }
    wb_send_setting(c->board, &c->session, &c->settings, (uint8_t)id);
    return 0;
}

static void settings_changed(struct wb_controller *c, uint8_t id)
{
    c->motion.homed = false; /* positions in steps may mean something else now */
    wb_inputs_configure(&c->inputs, &c->settings);
    wb_send_setting(c->board, &c->session, &c->settings, id);
}

static uint8_t write_setting(struct wb_controller *c, int32_t id, int32_t value)
{
    if (!c->settings.good) {
        return WB_ERROR_SETTINGS;
    }
    if (busy(c)) {
        return WB_ERROR_NOT_IDLE;
    }
    bool known;
    if (!wb_settings_change(&c->settings, c->board, id, value, &known)) {
        return known ? WB_ERROR_RANGE : WB_ERROR_UNKNOWN;
    }
    settings_changed(c, (uint8_t)id);
    return 0;
}

static uint8_t load_defaults(struct wb_controller *c)
{
    if (busy(c)) {
        return WB_ERROR_NOT_IDLE;
    }
    wb_settings_defaults(&c->settings, c->board);
    /* Answered with a setting: a status may also come for another reason. */
    settings_changed(c, 1);
    return 0;
}

uint8_t wb_dispatch(struct wb_controller *c, const struct wb_command *command)
{
    if (command->letter != WB_COMMAND_SESSION && c->session.id == WB_NO_SESSION) {
        return WB_ERROR_NO_SESSION;
    }
    switch (command->letter) {
    case WB_COMMAND_SESSION:
        return open_session(c, command->field[0]);
    case WB_COMMAND_PAUSE:
        return pause(c);
    case WB_COMMAND_RESUME:
        return resume(c);
    case WB_COMMAND_SPEED:
        return set_speed(c, command->field[0]);
    case WB_COMMAND_HEAD:
        return set_head(c, command->field[0]);
    case WB_COMMAND_READ_SETTING:
        return read_setting(c, command->field[0]);
    case WB_COMMAND_WRITE_SETTING:
        return write_setting(c, command->field[0], command->field[1]);
    case WB_COMMAND_LOAD_DEFAULTS:
        return load_defaults(c);
    case WB_COMMAND_RELEASE:
        return release(c);
    case WB_COMMAND_QUERY:
        wb_send_status(c);
        return 0;
    default:
        return accept_line(c, command);
    }
}
