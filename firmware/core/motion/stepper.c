#include "motion/stepper.h"

#include "common/compiler.h"

/* The square root, rounded down, bit by bit. */
static uint16_t root(uint32_t square)
{
    uint16_t found = 0;
    for (uint16_t bit = 0x8000; bit; bit = (uint16_t)(bit >> 1)) {
        uint16_t tried = (uint16_t)(found | bit);
        if ((uint32_t)tried * tried <= square) {
            found = tried;
        }
    }
    return found;
}

/* The first interval of a ramp, in 0.5 us: 0.676 f sqrt(2/a), where 0.676 corrects the error of the recurrence's first
 * step. With f = 2 MHz that is 1912017 / sqrt(a). The root is taken of 4096 a, which is 64 times as fine. */
static uint16_t first_interval(uint32_t acceleration /* steps/s^2 */)
{
    uint32_t interval = (uint32_t)1912017 * 64 / root(acceleration << 12);
    return interval > UINT16_MAX ? UINT16_MAX : (uint16_t)interval;
}

static WB_INLINE void end(struct wb_stepper *stepper, enum wb_end how)
{
    hal_timer_stop(stepper->board);
    stepper->moving = false;
    stepper->end = (uint8_t)how;
}

/* Not locked as a whole: its divisions are long, and until the timer starts only a stop can come in between. */
static void start(struct wb_stepper *stepper)
{
    uint16_t first = first_interval(stepper->move.acceleration);
    if (first < stepper->min_interval) {
        first = stepper->min_interval;
    }
    stepper->ramp = 0;
    stepper->remainder = 0;
    stepper->slowing = false;
    stepper->readings = 0;
    stepper->interval = first;
    stepper->moving = true;
    wb_stepper_plan(stepper);
    hal_lock(stepper->board);
    if (stepper->latched) {
        end(stepper, WB_END_STOPPED);
    } else if (stepper->moving) {
        hal_direction(stepper->board, stepper->move.axis, (stepper->move.steps < 0) == stepper->move.inverted);
        hal_timer_start(stepper->board, first);
    }
    hal_unlock(stepper->board);
}

void wb_stepper_begin(struct wb_stepper *stepper, const struct wb_move *move)
{
    stepper->move = *move;
    stepper->remaining = move->steps < 0 ? 0u - (uint32_t)move->steps : (uint32_t)move->steps;
    stepper->min_interval = (uint16_t)((WB_TIMER_HZ + move->rate / 2) / move->rate);
    start(stepper);
}

void wb_stepper_resume(struct wb_stepper *stepper)
{
    start(stepper);
}

WB_INLINE void wb_stepper_stop(struct wb_stepper *stepper)
{
    stepper->latched = true;
    if (stepper->moving) {
        end(stepper, WB_END_STOPPED);
    }
}

void wb_stepper_unlatch(struct wb_stepper *stepper)
{
    stepper->latched = false;
}

/* Whether the switch ends the move now. */
static bool switched(struct wb_stepper *stepper)
{
    const struct wb_move *move = &stepper->move;
    if (move->until == WB_UNTIL_COUNT) {
        return false;
    }
    bool pressed = hal_switch_high(stepper->board) != move->switch_inverted;
    bool wanted = move->until != WB_UNTIL_RELEASED;
    stepper->readings = pressed == wanted ? (uint8_t)(stepper->readings + 1) : 0;
    return stepper->readings >= move->readings;
}

bool wb_stepper_pulse(struct wb_stepper *stepper)
{
    if (!hal_timer_next(stepper->board, stepper->interval)) {
        end(stepper, WB_END_LATE);
        return false;
    }
    if (switched(stepper)) {
        end(stepper, WB_END_SWITCH);
        return false;
    }
    hal_pulse(stepper->board, stepper->move.axis);
    int32_t step = stepper->move.steps < 0 ? -1 : 1;
    stepper->position[stepper->move.axis] += step;
    stepper->remaining--;
    if (stepper->remaining == 0) {
        end(stepper, WB_END_REACHED);
        return false;
    }
    return true;
}

void wb_stepper_plan(struct wb_stepper *stepper)
{
    bool slow = stepper->hold || stepper->remaining <= stepper->ramp;
    if (slow && stepper->ramp == 0) {
        if (stepper->hold) {
            end(stepper, WB_END_HELD);
        }
        return;
    }
    if (!slow && stepper->interval <= stepper->min_interval) {
        return;
    }
    if (slow != stepper->slowing) {
        stepper->slowing = slow;
        stepper->remainder = 0;
    }
    uint32_t twice = 2 * (uint32_t)stepper->interval + stepper->remainder;
    if (slow) {
        uint32_t by = 4 * stepper->ramp - 1;
        uint32_t longer = stepper->interval + twice / by;
        stepper->remainder = twice % by;
        stepper->interval = longer > UINT16_MAX ? UINT16_MAX : (uint16_t)longer;
        stepper->ramp--;
    } else {
        stepper->ramp++;
        uint32_t by = 4 * stepper->ramp + 1;
        uint32_t shorter = stepper->interval - twice / by;
        stepper->remainder = twice % by;
        stepper->interval = shorter < stepper->min_interval ? stepper->min_interval : (uint16_t)shorter;
    }
}
