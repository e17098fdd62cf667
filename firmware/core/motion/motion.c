#include "motion/motion.h"

#include "motion/bend.h"
#include "common/compiler.h"
#include "motion/inputs.h"

/* What ends a phase; first it has to begin. */
enum { NOT_BEGUN, THE_MOVE, THE_PEG };

bool wb_motion_active(const struct wb_motion *motion)
{
    return motion->phase != WB_PHASE_NONE;
}

bool wb_motion_held(const struct wb_motion *motion)
{
    return motion->stepper.hold;
}

void wb_motion_hold(struct wb_motion *motion)
{
    motion->stepper.hold = true;
}

void wb_motion_resume(struct wb_motion *motion)
{
    motion->stepper.hold = false;
}

void wb_motion_abort(struct wb_motion *motion)
{
    hal_lock(motion->stepper.board);
    wb_stepper_stop(&motion->stepper);
    hal_unlock(motion->stepper.board);
    motion->stepper.hold = false;
    if (wb_motion_active(motion) && motion->waits_for == THE_PEG) {
        motion->peg.position = WB_PEG_UNKNOWN; /* on its way: the next line sends it again, and waits for it */
    }
    motion->phase = WB_PHASE_NONE;
    motion->homed = false;
}

void wb_motion_release(struct wb_motion *motion)
{
    wb_motors_off(&motion->motors, motion->stepper.board);
    motion->homed = false;
    motion->located = false;
}

/* A dry-run move has a quarter of the speed, but no less than the timer can do. */
enum { DRY_SLOWER = 4, SLOWEST = 31 /* steps/s */ };

static bool is_dry(const struct wb_motion *motion)
{
    return motion->line.letter == WB_COMMAND_DRY;
}

/* The speed of a line's move. */
static uint16_t slowed(const struct wb_motion *motion, uint16_t rate)
{
    uint32_t slow = (uint32_t)rate * (100u - motion->slower_by) / 100;
    if (is_dry(motion)) {
        slow /= DRY_SLOWER;
    }
    return slow < SLOWEST ? SLOWEST : (uint16_t)slow;
}

/* Begins a move of an axis; false when it has no steps. */
static bool move_axis(struct wb_motion *motion, const struct wb_settings *settings, struct wb_move *move)
{
    static const WB_FLASH uint8_t RATE[WB_AXES] = {WB_SETTING_FEED_RATE, WB_SETTING_ROTATE_RATE,
                                                   WB_SETTING_BEND_RATE};
    static const WB_FLASH uint8_t ACCELERATION[WB_AXES] = {
        WB_SETTING_FEED_ACCELERATION, WB_SETTING_ROTATE_ACCELERATION, WB_SETTING_BEND_ACCELERATION};
    int32_t inverted = wb_setting(settings, WB_SETTING_INVERTED);
    if (move->steps == 0) {
        return false;
    }
    if (move->rate == 0) {
        move->rate = (uint16_t)wb_setting(settings, RATE[move->axis]);
    }
    if (motion->line.letter != WB_COMMAND_HOME) {
        move->rate = slowed(motion, move->rate);
    }
    move->acceleration = (uint32_t)wb_setting(settings, ACCELERATION[move->axis]);
    move->inverted = (inverted >> move->axis & 1) != 0;
    move->switch_inverted = (inverted & WB_INVERTED_SWITCH) != 0;
    motion->waits_for = THE_MOVE;
    wb_stepper_begin(&motion->stepper, move);
    return true;
}

/* Moves the bend axis to a position. It must not meet its switch; in homing it may come from there. */
static bool move_bend(struct wb_motion *motion, const struct wb_settings *settings, int32_t target)
{
    int32_t home = wb_setting(settings, WB_SETTING_HOME_POSITION);
    struct wb_move move = {.axis = WB_BEND, .readings = WB_SWITCH_READINGS};
    move.steps = target - motion->stepper.position[WB_BEND];
    bool towards = (move.steps < 0) == (home < 0);
    move.until = towards || motion->line.letter != WB_COMMAND_HOME ? WB_UNTIL_PRESSED : WB_UNTIL_COUNT;
    return move_axis(motion, settings, &move);
}

/* Moves the peg; false when it is there. */
static bool move_peg(struct wb_motion *motion, const struct wb_settings *settings, const struct wb_clock *clock,
                     uint8_t target)
{
    if (!wb_peg_move(&motion->peg, &motion->stepper, settings, clock, target)) {
        return false;
    }
    motion->waits_for = THE_PEG;
    return true;
}

/* Begins a phase; false when the line has nothing to do in it. */
static bool begin(struct wb_motion *motion, const struct wb_settings *settings, const struct wb_clock *clock)
{
    const struct wb_line *line = &motion->line;
    void *board = motion->stepper.board;
    /* A switch that is pressed, or whose wire is broken, ends every move. */
    struct wb_move move = {.axis = WB_BEND, .until = WB_UNTIL_PRESSED, .readings = WB_GUARD_READINGS};
    switch (motion->phase) {
    case WB_PHASE_CLEAR_WIRE:
        return move_bend(motion, settings,
                         wb_bend_clear(settings, motion->peg.wire_side, motion->stepper.position[WB_BEND],
                                       wb_bend_near(settings, motion->approach), motion->located));
    case WB_PHASE_RETRACT:
    case WB_PHASE_PEG_IN:
        return move_peg(motion, settings, clock, WB_PEG_IN);
    case WB_PHASE_PEG_OUT:
        motion->approach = line->approach;
        wb_peg_set_wire_side(&motion->peg, board, wb_bend_side(line));
        return move_peg(motion, settings, clock, WB_PEG_OUT);
    case WB_PHASE_PEG_MANUAL:
        return move_peg(motion, settings, clock, line->feed ? WB_PEG_OUT : WB_PEG_IN);
    case WB_PHASE_FEED:
        move.axis = WB_FEED;
        move.steps = line->feed;
        return move_axis(motion, settings, &move);
    case WB_PHASE_ROTATE:
        move.axis = WB_ROTATE;
        move.steps = line->rotate;
        return move_axis(motion, settings, &move);
    case WB_PHASE_APPROACH:
    case WB_PHASE_BEND:
    case WB_PHASE_BACK_OFF:
    case WB_PHASE_RETURN:
    case WB_PHASE_HOME_ZERO:
        return move_bend(motion, settings,
                         wb_bend_target(settings, motion->phase, wb_bend_side(line), line->bend,
                                        wb_bend_near(settings, line->approach)));
    default:
        return wb_homing_move(settings, wb_switch_pressed(settings, board), motion->phase, &move) &&
               move_axis(motion, settings, &move);
    }
}

static uint8_t next_phase(const struct wb_motion *motion)
{
    switch (motion->phase) {
    case WB_PHASE_RETRACT:
        return motion->line.letter == WB_COMMAND_HOME ? WB_PHASE_HOME_RELEASE : WB_PHASE_FEED;
    case WB_PHASE_ROTATE:
        if (wb_bend_side(&motion->line) == 0) {
            return WB_PHASE_NONE;
        }
        return is_dry(motion) ? WB_PHASE_BEND : WB_PHASE_APPROACH;
    case WB_PHASE_BEND:
        return is_dry(motion) ? WB_PHASE_RETURN : WB_PHASE_BACK_OFF;
    case WB_PHASE_RETURN:
    case WB_PHASE_HOME_ZERO:
    case WB_PHASE_PEG_MANUAL:
        return WB_PHASE_NONE;
    default:
        return (uint8_t)(motion->phase + 1);
    }
}

/* What a move that has ended leads to: the phase is over, continues, or has failed. */
static enum wb_motion_result move_ended(struct wb_motion *motion, const struct wb_settings *settings)
{
    uint8_t end = motion->stepper.end;
    if (end == WB_END_STOPPED) {
        return WB_MOTION_RUNNING; /* by a STOP that the main loop is about to see */
    }
    if (end == WB_END_HELD) {
        if (!wb_motion_held(motion)) {
            wb_stepper_resume(&motion->stepper);
        }
        return WB_MOTION_RUNNING;
    }
    if (end == WB_END_LATE) {
        return WB_MOTION_LATE_PULSE;
    }
    if (wb_homing_is_phase(motion->phase)) {
        if (!wb_homing_ended(settings, &motion->stepper, motion->phase)) {
            return WB_MOTION_HOMING_FAILED;
        }
        motion->located = motion->located || motion->phase == WB_PHASE_HOME_LOCATE;
        return WB_MOTION_FINISHED;
    }
    return end == WB_END_SWITCH ? WB_MOTION_HIT_LIMIT : WB_MOTION_FINISHED;
}

/* Whether the phase is finished, continues, or has failed. */
static enum wb_motion_result phase_result(struct wb_motion *motion, const struct wb_settings *settings, uint16_t now)
{
    if (motion->waits_for == THE_PEG) {
        return wb_peg_arrived(&motion->peg, settings, now) ? WB_MOTION_FINISHED : WB_MOTION_RUNNING;
    }
    if (!motion->stepper.moving) {
        return move_ended(motion, settings);
    }
    if (wb_homing_is_phase(motion->phase) && wb_homing_timed_out(&motion->homing, settings, now)) {
        return WB_MOTION_HOMING_FAILED;
    }
    return WB_MOTION_RUNNING;
}

void wb_motion_start(struct wb_motion *motion, const struct wb_line *line, const struct wb_clock *clock)
{
    motion->line = *line;
    if (line->letter == WB_COMMAND_PEG) {
        motion->phase = WB_PHASE_PEG_MANUAL;
    } else {
        /* Only homing can follow a bend that was cut short. */
        motion->phase = motion->peg.wire_side ? WB_PHASE_CLEAR_WIRE : WB_PHASE_RETRACT;
    }
    motion->waits_for = NOT_BEGUN;
    wb_homing_start(&motion->homing, wb_clock_now(clock, motion->stepper.board));
    wb_motors_on(&motion->motors, motion->stepper.board);
}

enum wb_motion_result wb_motion_run(struct wb_motion *motion, const struct wb_settings *settings,
                                    const struct wb_clock *clock)
{
    bool held = wb_motion_held(motion);
    if (held) {
        wb_homing_wait(&motion->homing, wb_clock_now(clock, motion->stepper.board));
    }
    for (;;) {
        if (motion->waits_for == NOT_BEGUN) {
            if (held || begin(motion, settings, clock)) {
                return WB_MOTION_RUNNING;
            }
        } else {
            enum wb_motion_result result =
                phase_result(motion, settings, wb_clock_now(clock, motion->stepper.board));
            if (result != WB_MOTION_FINISHED) {
                return result;
            }
        }
        if (motion->phase == WB_PHASE_RETRACT || motion->phase == WB_PHASE_PEG_IN) {
            wb_peg_set_wire_side(&motion->peg, motion->stepper.board, 0);
        }
        uint8_t next = next_phase(motion);
        if (next == WB_PHASE_NONE) {
            return WB_MOTION_FINISHED;
        }
        motion->phase = next;
        motion->waits_for = NOT_BEGUN;
    }
}

uint32_t wb_motion_end(struct wb_motion *motion)
{
    motion->phase = WB_PHASE_NONE;
    motion->homed = motion->homed || motion->line.letter == WB_COMMAND_HOME;
    return motion->line.n;
}
