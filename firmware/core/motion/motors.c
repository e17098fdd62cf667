#include "motion/motors.h"

#include "hal.h"

#define TICKS_PER_S ((uint16_t)(1000000uL / WB_TICK_US))

void wb_motors_on(struct wb_motors *motors, void *board)
{
    hal_motors_on(board);
    motors->on = true;
}

void wb_motors_off(struct wb_motors *motors, void *board)
{
    hal_motors_off(board);
    motors->on = false;
}

bool wb_motors_idle_too_long(struct wb_motors *motors, const struct wb_settings *settings, uint16_t now, bool at_rest)
{
    uint16_t passed = (uint16_t)(now - motors->seen_at);
    motors->seen_at = now;
    if (!motors->on || !settings->good || !at_rest) {
        motors->idle = 0;
        return false;
    }
    motors->idle += passed;
    uint32_t limit = (uint32_t)wb_setting(settings, WB_SETTING_RELEASE_S) * TICKS_PER_S;
    return limit > 0 && motors->idle > limit;
}
