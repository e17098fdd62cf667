#include "controller.h"

#include "boots.h"
#include "flash.h"
#include "hal.h"
#include "motion.h"
#include "replies.h"
#include "wire_side.h"

/* An input counts as open after so many ticks in a row: 4 ms are longer than a disturbance of its wire. */
#define OPEN_TICKS 4

/* Without a valid frame for so long, no other line begins. */
#define TICKS_A_S ((uint16_t)(1000000uL / WB_TICK_US))
#define HOST_LOST_TICKS ((uint16_t)(1000000uL / WB_TICK_US))

void wb_start(struct wb_controller *c, void *board, uint8_t reset)
{
    *c = (struct wb_controller){
        .board = board,
        .stepper = {.board = board},
        .session = WB_NO_SESSION,
        .reset = reset,
        .peg = WB_PEG_UNKNOWN,
        .done_told = true,
        .alarm_told = true,
    };
    wb_settings_load(&c->settings, board);
    c->boots = wb_boots_count(board);
    c->wire_side = wb_wire_side_load(board);
    c->inputs = c->settings.good ? (uint8_t)wb_setting(&c->settings, WB_SETTING_INPUTS) : 0;
    if (reset == WB_RESET_WATCHDOG) {
        wb_motion_alarm(c, WB_ALARM_WATCHDOG);
        c->alarm_told = true; /* the boot frame tells */
    }
}

/* What of the settings an interrupt looks at. */
static void settings_changed(struct wb_controller *c)
{
    c->homed = false; /* positions in steps may mean something else now */
    c->inputs = c->settings.good ? (uint8_t)wb_setting(&c->settings, WB_SETTING_INPUTS) : 0;
    if (!c->inputs) {
        c->hold_open = 0;
        c->emergency_open = 0;
    }
}

/* --- from interrupts */

void wb_on_byte(struct wb_controller *c, uint8_t byte, bool damaged)
{
    if (byte == WB_STOP_BYTE) {
        wb_stepper_cut(&c->stepper);
        c->stop_asked = true;
    }
    uint8_t next = (uint8_t)((c->received_in + 1) % WB_RECEIVED);
    /* No printable byte is 0: it poisons the line in its place. */
    if (next == c->received_out) {
        c->received[(c->received_in + WB_RECEIVED - 1) % WB_RECEIVED] = 0; /* and there a byte is lost */
    } else {
        c->received[c->received_in] = damaged ? 0 : byte;
        c->received_in = next;
    }
    if (byte == WB_STOP_BYTE) {
        c->stop_mark = c->received_in;
    }
}

static void watch_inputs(struct wb_controller *c)
{
    if (!wb_input_open(c, WB_INPUT_HOLD)) {
        c->hold_open = 0;
    } else if (c->hold_open < OPEN_TICKS) {
        c->hold_open++;
    }
    if (!wb_input_open(c, WB_INPUT_EMERGENCY)) {
        c->emergency_open = 0;
    } else if (c->emergency_open < OPEN_TICKS && ++c->emergency_open == OPEN_TICKS) {
        wb_stepper_cut(&c->stepper); /* its motors have no power any more */
    }
}

void wb_on_tick(struct wb_controller *c)
{
    c->ticks++;
    /* Short: a step may wait for it. */
    if (c->inputs) {
        watch_inputs(c);
    }
}

bool wb_input_open(const struct wb_controller *c, uint8_t input)
{
    return (c->inputs & input) && hal_input_open(c->board, input);
}

bool wb_on_step(struct wb_controller *c)
{
    return wb_stepper_pulse(&c->stepper);
}

void wb_on_step_rest(struct wb_controller *c)
{
    wb_stepper_plan(&c->stepper);
}

uint16_t wb_ticks(struct wb_controller *c)
{
    hal_lock(c->board);
    uint16_t ticks = c->ticks;
    hal_unlock(c->board);
    return ticks;
}

uint8_t wb_state(const struct wb_controller *c)
{
    if (c->alarm != WB_ALARM_NONE && c->alarm != WB_ALARM_HOST_LOST && c->alarm != WB_ALARM_HOLD_INPUT) {
        return WB_STATE_ALARM;
    }
    if (c->held || (c->hold_next && c->phase == WB_NO_PHASE)) {
        return WB_STATE_HELD;
    }
    return wb_motion_busy(c) ? WB_STATE_RUNNING : WB_STATE_IDLE;
}

/* --- what the host asks for. Each gives the error with which it is refused, or 0 when it has answered. */

static uint8_t open_session(struct wb_controller *c, int32_t id)
{
    if (id < 1 || id >= (int32_t)WB_NO_SESSION) {
        return WB_ERROR_RANGE;
    }
    if (id != c->session) {
        if (wb_motion_busy(c)) {
            return WB_ERROR_NOT_IDLE;
        }
        c->session = (uint16_t)id;
        c->last = 0;
        c->done = 0;
        c->done_told = true;
    }
    wb_tell_open(c);
    return 0;
}

static bool within(int32_t value, int32_t limit)
{
    return value >= -limit && value <= limit;
}

/* Why a line cannot be made; 0 when it can. */
static uint8_t objection(const struct wb_controller *c, const struct wb_command *line)
{
    const struct wb_settings *settings = &c->settings;
    if (!settings->good) {
        return WB_ERROR_SETTINGS;
    }
    if (wb_input_open(c, WB_INPUT_EMERGENCY)) {
        return WB_ERROR_EMERGENCY;
    }
    /* What begins at an open door would have to be let go on by a person at once. */
    if (!wb_motion_busy(c) && wb_input_open(c, WB_INPUT_HOLD)) {
        return WB_ERROR_HOLD_INPUT;
    }
    if (line->letter == WB_COMMAND_HOME) {
        return wb_motion_busy(c) ? WB_ERROR_NOT_IDLE : 0;
    }
    if (wb_state(c) == WB_STATE_ALARM) {
        return WB_ERROR_IN_ALARM;
    }
    if (line->letter == WB_COMMAND_PEG) {
        if (c->wire_side) {
            return WB_ERROR_NOT_HOMED; /* not while it presses on the wire */
        }
        return line->field[0] == 0 || line->field[0] == 1 ? 0 : WB_ERROR_RANGE;
    }
    if (!c->homed) {
        return WB_ERROR_NOT_HOMED;
    }
    int32_t feed = line->field[0], rotate = line->field[1], bend = line->field[2];
    int32_t turn = wb_setting(settings, WB_SETTING_ROTATE_LIMIT);
    /* Positions are counted in 32 bits: 30 of them are forty kilometres of wire. */
    if (!within(feed, wb_setting(settings, WB_SETTING_FEED_MOST)) || !within(c->fed, INT32_MAX / 2) ||
        !within(rotate, 2 * turn) || !within(c->head + rotate, turn) ||
        !within(bend, wb_setting(settings, WB_SETTING_BEND_LIMIT))) {
        return WB_ERROR_SOFT_LIMIT;
    }
    return 0;
}

/* At once, unless a STOP has come that was not looked at yet. */
static bool leave_alarm(struct wb_controller *c)
{
    hal_lock(c->board);
    bool stopped = c->stop_asked;
    if (!stopped) {
        wb_stepper_unlatch(&c->stepper);
    }
    hal_unlock(c->board);
    if (!stopped) {
        c->alarm = WB_ALARM_NONE;
        c->alarm_told = true;
        c->hold_next = false;
        c->homed = false;
        c->held = false;
        c->input_holds = false;
        c->stepper.hold = false;
    }
    return !stopped;
}

static uint8_t take(struct wb_controller *c, const struct wb_command *command)
{
    if (command->n > c->last) {
        if (command->n - c->last > 1) {
            return WB_ERROR_GAP;
        }
        uint8_t error = objection(c, command);
        if (error) {
            return error;
        }
        if (c->queued == WB_QUEUE) {
            wb_tell_taken(c, WB_REPLY_FULL);
            return 0;
        }
        if (command->letter == WB_COMMAND_HOME && !leave_alarm(c)) {
            return WB_ERROR_IN_ALARM;
        }
        struct wb_line *line = &c->queue[(c->first + c->queued) % WB_QUEUE];
        *line = (struct wb_line){.n = command->n, .letter = command->letter, .feed = command->field[0]};
        if (command->letter == WB_COMMAND_MOVE) {
            line->rotate = command->field[1];
            line->bend = command->field[2];
            c->head += line->rotate;
            c->fed += line->feed;
        }
        c->queued++;
        c->last = command->n;
    }
    wb_tell_taken(c, WB_REPLY_ACCEPTED);
    return 0;
}

static uint8_t pause(struct wb_controller *c)
{
    if (wb_state(c) == WB_STATE_ALARM) {
        return WB_ERROR_IN_ALARM;
    }
    c->held = true;
    c->stepper.hold = true;
    wb_tell_status(c);
    return 0;
}

static uint8_t go_on(struct wb_controller *c)
{
    if (wb_state(c) == WB_STATE_ALARM) {
        return WB_ERROR_IN_ALARM;
    }
    if (wb_input_open(c, WB_INPUT_HOLD)) {
        return WB_ERROR_HOLD_INPUT;
    }
    c->held = false;
    c->input_holds = false;
    c->hold_next = false;
    c->stepper.hold = false;
    c->alarm = WB_ALARM_NONE;
    wb_tell_status(c);
    return 0;
}

static uint8_t head_stands(struct wb_controller *c, int32_t steps)
{
    if (!c->settings.good) {
        return WB_ERROR_SETTINGS;
    }
    if (wb_motion_busy(c)) {
        return WB_ERROR_NOT_IDLE;
    }
    if (!within(steps, wb_setting(&c->settings, WB_SETTING_ROTATE_LIMIT))) {
        return WB_ERROR_SOFT_LIMIT;
    }
    c->stepper.position[WB_ROTATE] = steps;
    c->head = steps;
    wb_tell_status(c);
    return 0;
}

static uint8_t read_setting(struct wb_controller *c, int32_t id)
{
    if (!c->settings.good) {
        return WB_ERROR_SETTINGS;
    }
    if (id < 1 || id > WB_SETTINGS_COUNT) {
        return WB_ERROR_UNKNOWN;
    }
    wb_tell_setting(c, (uint8_t)id);
    return 0;
}

static uint8_t write_setting(struct wb_controller *c, int32_t id, int32_t value)
{
    if (!c->settings.good) {
        return WB_ERROR_SETTINGS;
    }
    if (wb_motion_busy(c)) {
        return WB_ERROR_NOT_IDLE;
    }
    bool known;
    if (!wb_settings_change(&c->settings, c->board, id, value, &known)) {
        return known ? WB_ERROR_RANGE : WB_ERROR_UNKNOWN;
    }
    settings_changed(c);
    wb_tell_setting(c, (uint8_t)id);
    return 0;
}

static uint8_t load_defaults(struct wb_controller *c)
{
    if (wb_motion_busy(c)) {
        return WB_ERROR_NOT_IDLE;
    }
    wb_settings_defaults(&c->settings, c->board);
    settings_changed(c);
    /* A status may come unasked for this; a setting may not. */
    wb_tell_setting(c, 1);
    return 0;
}

static uint8_t release(struct wb_controller *c)
{
    if (wb_motion_busy(c)) {
        return WB_ERROR_NOT_IDLE;
    }
    wb_motion_release(c);
    wb_tell_status(c);
    return 0;
}

static uint8_t obey(struct wb_controller *c, const struct wb_command *command)
{
    if (command->letter != WB_COMMAND_SESSION && c->session == WB_NO_SESSION) {
        return WB_ERROR_NO_SESSION;
    }
    switch (command->letter) {
    case WB_COMMAND_SESSION:
        return open_session(c, command->field[0]);
    case WB_COMMAND_PAUSE:
        return pause(c);
    case WB_COMMAND_GO_ON:
        return go_on(c);
    case WB_COMMAND_HEAD:
        return head_stands(c, command->field[0]);
    case WB_COMMAND_READ_SETTING:
        return read_setting(c, command->field[0]);
    case WB_COMMAND_WRITE_SETTING:
        return write_setting(c, command->field[0], command->field[1]);
    case WB_COMMAND_LOAD_DEFAULTS:
        return load_defaults(c);
    case WB_COMMAND_RELEASE:
        return release(c);
    case WB_COMMAND_QUERY:
        wb_tell_status(c);
        return 0;
    default:
        return take(c, command);
    }
}

static void frame_came(struct wb_controller *c)
{
    static const WB_FLASH uint8_t ERROR[] = {
        [WB_PARSE_UNKNOWN] = WB_ERROR_UNKNOWN, [WB_PARSE_RANGE] = WB_ERROR_RANGE};
    struct wb_command command = {0};
    c->heard = wb_ticks(c);
    enum wb_parsed parsed = wb_parse(c->frame.text, &command);
    uint8_t error = parsed == WB_PARSED ? obey(c, &command) : ERROR[parsed];
    if (error) {
        wb_tell_refusal(c, error, *c->frame.text);
    }
}

/* --- the main loop */

static bool receive(struct wb_controller *c)
{
    /* Every byte may ask for a reply. */
    while (c->received_out != c->received_in) {
        if (hal_send_room(c->board) < WB_REPLY_MOST) {
            return false;
        }
        uint8_t byte = c->received[c->received_out];
        c->received_out = (uint8_t)((c->received_out + 1) % WB_RECEIVED);
        switch (wb_frame_feed(&c->frame, byte, c->session)) {
        case WB_FED_FRAME:
            frame_came(c);
            return c->received_out != c->received_in;
        case WB_FED_DAMAGED:
            wb_tell_refusal(c, c->session == WB_NO_SESSION ? WB_ERROR_NO_SESSION : WB_ERROR_DAMAGED, 0);
            return c->received_out != c->received_in;
        default:
            break;
        }
    }
    return false;
}

static void watch_host(struct wb_controller *c)
{
    uint16_t now = wb_ticks(c);
    if (!wb_motion_busy(c) || c->hold_next) {
        c->heard = c->hold_next ? c->heard : now;
        return;
    }
    if ((uint16_t)(now - c->heard) > HOST_LOST_TICKS) {
        c->hold_next = true;
        c->alarm = WB_ALARM_HOST_LOST;
        c->alarm_told = false;
    }
}

/* Inputs that are open. STOP and the emergency stop latch an alarm, a hold is left by go-on. */
static void see_inputs(struct wb_controller *c)
{
    if (wb_state(c) == WB_STATE_ALARM) {
        return;
    }
    if (c->emergency_open == OPEN_TICKS) {
        wb_motion_alarm(c, WB_ALARM_EMERGENCY);
    } else if (c->hold_open == OPEN_TICKS && !c->input_holds) {
        c->held = true;
        c->input_holds = true;
        c->stepper.hold = true;
        c->alarm = WB_ALARM_HOLD_INPUT;
        c->alarm_told = false;
    } else if (c->input_holds && c->hold_open == 0 && !wb_motion_busy(c)) {
        /* Closed, and there is nothing that would go on by itself. */
        c->held = false;
        c->input_holds = false;
        c->stepper.hold = false;
        c->alarm = c->hold_next ? WB_ALARM_HOST_LOST : WB_ALARM_NONE;
    }
}

/* The motors of a machine that nobody uses get hot for nothing. */
static void watch_rest(struct wb_controller *c)
{
    uint16_t now = wb_ticks(c);
    uint16_t passed = (uint16_t)(now - c->rest_tick);
    c->rest_tick = now;
    uint8_t state = wb_state(c);
    if (!c->motors || !c->settings.good || wb_motion_busy(c) || state == WB_STATE_HELD) {
        c->rest_ticks = 0;
        return;
    }
    c->rest_ticks += passed;
    uint32_t most = (uint32_t)wb_setting(&c->settings, WB_SETTING_RELEASE_S) * TICKS_A_S;
    if (most > 0 && c->rest_ticks > most) {
        wb_motion_release(c);
    }
}

static void tell_news(struct wb_controller *c)
{
    if (!c->boot_told && hal_send_room(c->board) >= WB_REPLY_MOST) {
        wb_tell_boot(c);
        c->boot_told = true;
    }
    if (!c->alarm_told && hal_send_room(c->board) >= WB_REPLY_MOST) {
        wb_tell_one(c, WB_REPLY_ALARM, c->alarm);
        c->alarm_told = true;
    }
    if (!c->done_told && hal_send_room(c->board) >= WB_REPLY_MOST) {
        wb_tell_one(c, WB_REPLY_DONE, c->done);
        c->done_told = true;
    }
}

/* A STOP that has come. Lines that came before it must not leave the alarm that it raises. */
static void see_stop(struct wb_controller *c)
{
    hal_lock(c->board);
    bool asked = c->stop_asked;
    c->stop_asked = false;
    if (asked) {
        c->received_out = c->stop_mark;
    }
    hal_unlock(c->board);
    if (asked) {
        c->frame.poisoned = true;
        wb_motion_alarm(c, WB_ALARM_STOP);
    }
}

bool wb_poll(struct wb_controller *c)
{
    see_stop(c);
    see_inputs(c);
    bool more = receive(c);
    wb_motion_run(c);
    watch_host(c);
    watch_rest(c);
    tell_news(c);
    return more;
}
