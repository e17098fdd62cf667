#include "motion.h"

#include "bend.h"
#include "flash.h"
#include "homing.h"
#include "wire_side.h"

/* What a phase waits for. */
enum { TO_BEGIN, A_MOVE, THE_PEG };

bool wb_motion_busy(const struct wb_controller *c)
{
    return c->phase != WB_NO_PHASE || c->queued > 0;
}

void wb_motion_flush(struct wb_controller *c)
{
    c->queued = 0;
    if (c->phase != WB_NO_PHASE && c->doing == THE_PEG) {
        c->peg = WB_PEG_UNKNOWN; /* on its way: the next line tells it again, and waits for it */
    }
    c->phase = WB_NO_PHASE;
    c->head = c->stepper.position[WB_ROTATE];
    c->fed = c->stepper.position[WB_FEED];
}

void wb_motion_alarm(struct wb_controller *c, uint8_t alarm)
{
    hal_lock(c->board);
    wb_stepper_cut(&c->stepper);
    hal_unlock(c->board);
    wb_motion_flush(c);
    c->stepper.hold = false;
    c->held = false;
    c->input_holds = false;
    c->hold_next = false;
    c->homed = false;
    c->alarm = alarm;
    c->alarm_told = false;
}

void wb_motion_release(struct wb_controller *c)
{
    hal_motors_off(c->board);
    c->motors = false;
    c->homed = false;
    c->placed = false;
}

/* Begins a move of an axis; false when there is none to make. */
static bool drive(struct wb_controller *c, struct wb_move *move)
{
    static const WB_FLASH uint8_t RATE[WB_AXES] = {WB_SETTING_FEED_RATE, WB_SETTING_ROTATE_RATE,
                                                   WB_SETTING_BEND_RATE};
    static const WB_FLASH uint8_t ACCELERATION[WB_AXES] = {
        WB_SETTING_FEED_ACCELERATION, WB_SETTING_ROTATE_ACCELERATION, WB_SETTING_BEND_ACCELERATION};
    int32_t inverted = wb_setting(&c->settings, WB_SETTING_INVERTED);
    if (move->steps == 0) {
        return false;
    }
    if (move->rate == 0) {
        move->rate = (uint16_t)wb_setting(&c->settings, RATE[move->axis]);
    }
    move->acceleration = (uint32_t)wb_setting(&c->settings, ACCELERATION[move->axis]);
    move->inverted = (inverted >> move->axis & 1) != 0;
    move->switch_inverted = (inverted & WB_INVERTED_SWITCH) != 0;
    c->doing = A_MOVE;
    wb_stepper_begin(&c->stepper, move);
    return true;
}

/* The bend axis to a place. It must not meet its switch; in homing it may come from there. */
static bool bend_to(struct wb_controller *c, int32_t target)
{
    int32_t home = wb_setting(&c->settings, WB_SETTING_HOME_POSITION);
    struct wb_move move = {.axis = WB_BEND, .readings = WB_SWITCH_SAMPLES};
    move.steps = target - c->stepper.position[WB_BEND];
    bool towards = (move.steps < 0) == (home < 0);
    move.until = towards || c->line.letter == WB_COMMAND_MOVE ? WB_UNTIL_PRESSED : WB_UNTIL_COUNT;
    return drive(c, &move);
}

/* The peg in or out; false when it is there. */
static bool peg_to(struct wb_controller *c, uint8_t peg)
{
    if (c->peg == peg) {
        return false;
    }
    uint8_t id = peg == WB_PEG_OUT ? WB_SETTING_PEG_OUT_US : WB_SETTING_PEG_IN_US;
    uint16_t width = (uint16_t)wb_setting(&c->settings, id);
    hal_lock(c->board);
    if (!c->stepper.latched) {
        hal_peg(c->board, width);
        c->peg = peg;
    }
    hal_unlock(c->board);
    c->since = wb_ticks(c);
    c->doing = THE_PEG;
    return true;
}

/* Keeps from which side the peg may press on the wire. Before it comes out, and after it is in. */
static void set_wire_side(struct wb_controller *c, int8_t side)
{
    if (c->wire_side != side) {
        c->wire_side = side;
        wb_wire_side_store(c->board, side);
    }
}

/* Begins a phase; false when the line has nothing to do in it. */
static bool begin(struct wb_controller *c)
{
    const struct wb_line *line = &c->line;
    /* Pressed, or its wire broken, it ends every move. */
    struct wb_move move = {.axis = WB_BEND, .until = WB_UNTIL_PRESSED, .readings = WB_GUARD_SAMPLES};
    switch (c->phase) {
    case WB_LEAVES_WIRE:
        return bend_to(c, wb_bend_clear(&c->settings, c->wire_side, c->stepper.position[WB_BEND], c->placed));
    case WB_PEG_CLEARS:
    case WB_PEG_GOES:
        return peg_to(c, WB_PEG_IN);
    case WB_PEG_COMES:
        set_wire_side(c, line->bend < 0 ? -1 : 1);
        return peg_to(c, WB_PEG_OUT);
    case WB_PEG_BY_HAND:
        return peg_to(c, line->feed ? WB_PEG_OUT : WB_PEG_IN);
    case WB_FEEDS:
        move.axis = WB_FEED;
        move.steps = line->feed;
        return drive(c, &move);
    case WB_ROTATES:
        move.axis = WB_ROTATE;
        move.steps = line->rotate;
        return drive(c, &move);
    case WB_GOES_NEAR:
    case WB_SWINGS:
    case WB_BACKS_OFF:
    case WB_RETURNS:
    case WB_GOES_TO_ZERO:
        return bend_to(c, wb_bend_target(&c->settings, c->phase, line->bend));
    default:
        return wb_homing_move(c, c->phase, &move) && drive(c, &move);
    }
}

static uint8_t phase_after(const struct wb_controller *c)
{
    switch (c->phase) {
    case WB_PEG_CLEARS:
        return c->line.letter == WB_COMMAND_HOME ? WB_LEAVES_SWITCH : WB_FEEDS;
    case WB_ROTATES:
        return c->line.bend ? WB_GOES_NEAR : WB_NO_PHASE;
    case WB_RETURNS:
    case WB_GOES_TO_ZERO:
    case WB_PEG_BY_HAND:
        return WB_NO_PHASE;
    default:
        return (uint8_t)(c->phase + 1);
    }
}

static bool homing(const struct wb_controller *c)
{
    return c->phase == WB_LEAVES_WIRE || (c->phase >= WB_LEAVES_SWITCH && c->phase <= WB_SEEKS_SLOW);
}

/* What the end of a move leads to: true when the phase is over. */
static bool move_ended(struct wb_controller *c)
{
    uint8_t end = c->stepper.end;
    if (end == WB_END_CUT) {
        return false; /* a STOP that the main loop is about to see */
    }
    if (end == WB_END_HELD) {
        if (!c->held) {
            wb_stepper_go_on(&c->stepper);
        }
        return false;
    }
    if (end == WB_END_LATE) {
        wb_motion_alarm(c, WB_ALARM_LATE_PULSE);
        return false;
    }
    if (homing(c)) {
        if (!wb_homing_ended(c, c->phase, end)) {
            wb_motion_alarm(c, WB_ALARM_HOMING);
            return false;
        }
        return true;
    }
    if (end == WB_END_SWITCH) {
        wb_motion_alarm(c, WB_ALARM_LIMIT);
        return false;
    }
    return true;
}

/* Whether what the phase waits for is over. */
static bool phase_over(struct wb_controller *c)
{
    if (c->doing == THE_PEG) {
        /* A tick is a little more than a millisecond, and the first one has begun already. */
        return (uint16_t)(wb_ticks(c) - c->since) > wb_setting(&c->settings, WB_SETTING_PEG_TIME_MS);
    }
    if (!c->stepper.moving) {
        return move_ended(c);
    }
    if (homing(c) && wb_homing_late(c)) {
        wb_motion_alarm(c, WB_ALARM_HOMING);
    }
    return false;
}

static void take_line(struct wb_controller *c)
{
    c->line = c->queue[c->first];
    c->first = (uint8_t)((c->first + 1) % WB_QUEUE);
    c->queued--;
    if (c->line.letter == WB_COMMAND_PEG) {
        c->phase = WB_PEG_BY_HAND;
    } else {
        /* Only homing can follow a bend that was ended in its middle. */
        c->phase = c->wire_side ? WB_LEAVES_WIRE : WB_PEG_CLEARS;
    }
    c->doing = TO_BEGIN;
    c->homing_ticks = 0;
    c->homing_tick = wb_ticks(c);
    hal_motors_on(c->board);
    c->motors = true;
}

void wb_motion_run(struct wb_controller *c)
{
    if (c->held) {
        c->homing_tick = wb_ticks(c); /* a pause is no time of homing */
    }
    if (c->phase == WB_NO_PHASE) {
        if (c->queued == 0 || c->held || c->hold_next) {
            return;
        }
        take_line(c);
    }
    while (c->phase != WB_NO_PHASE) {
        if (c->doing == TO_BEGIN) {
            if (c->held || begin(c)) {
                return;
            }
        } else if (!phase_over(c)) {
            return;
        }
        if (c->phase == WB_PEG_CLEARS || c->phase == WB_PEG_GOES) {
            set_wire_side(c, 0);
        }
        uint8_t next = phase_after(c);
        if (next == WB_NO_PHASE && wb_input_open(c, WB_INPUT_EMERGENCY)) {
            return; /* its motors may have had no power at the end: an alarm follows, or it was a disturbance */
        }
        c->phase = next;
        c->doing = TO_BEGIN;
    }
    c->homed = c->homed || c->line.letter == WB_COMMAND_HOME;
    c->done = c->line.n;
    c->done_told = false;
}
