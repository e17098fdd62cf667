#include "motion/homing.h"

#include "common/phase.h"

/* How far the axis may stand beyond the edge of its switch, in pull-offs. A switch that is still pressed after that is
 * stuck, or its wire is broken: the axis must not run to its other end. */
#define MAX_PULL_OFFS 10

/* The side on which the switch is. */
static int32_t side(const struct wb_settings *settings)
{
    return wb_setting(settings, WB_SETTING_HOME_POSITION) < 0 ? -1 : 1;
}

void wb_homing_start(struct wb_homing *homing, uint16_t now)
{
    homing->elapsed = 0;
    homing->seen_at = now;
}

void wb_homing_wait(struct wb_homing *homing, uint16_t now)
{
    homing->seen_at = now;
}

bool wb_homing_timed_out(struct wb_homing *homing, const struct wb_settings *settings, uint16_t now)
{
    homing->elapsed += (uint16_t)(now - homing->seen_at);
    homing->seen_at = now;
    /* A tick is 1.024 ms: the time is exceeded by a fortieth at most. */
    return homing->elapsed > (uint32_t)wb_setting(settings, WB_SETTING_HOME_TIME_MS);
}

bool wb_homing_is_phase(uint8_t phase)
{
    return phase == WB_PHASE_CLEAR_WIRE || (phase >= WB_PHASE_HOME_RELEASE && phase <= WB_PHASE_HOME_LOCATE);
}

bool wb_homing_move(const struct wb_settings *settings, bool switch_pressed, uint8_t phase, struct wb_move *move)
{
    int32_t towards = side(settings);
    int32_t travel = wb_setting(settings, WB_SETTING_HOME_TRAVEL);
    int32_t pull_off = wb_setting(settings, WB_SETTING_HOME_BACK_OFF);
    move->rate = (uint16_t)wb_setting(settings, WB_SETTING_HOME_FAST_RATE);
    move->readings = WB_SWITCH_READINGS;
    switch (phase) {
    case WB_PHASE_HOME_RELEASE:
        if (travel > MAX_PULL_OFFS * pull_off) {
            travel = MAX_PULL_OFFS * pull_off;
        }
        move->steps = -towards * travel;
        move->until = WB_UNTIL_RELEASED;
        return switch_pressed;
    case WB_PHASE_HOME_SEEK:
        move->steps = towards * travel;
        move->until = WB_UNTIL_PRESSED;
        return true;
    case WB_PHASE_HOME_PULL_OFF:
        move->steps = -towards * pull_off;
        move->until = WB_UNTIL_COUNT;
        return true;
    case WB_PHASE_HOME_LOCATE:
        move->rate = (uint16_t)wb_setting(settings, WB_SETTING_HOME_SLOW_RATE);
        /* Twice the way back: the switch has some play. */
        move->steps = 2 * towards * pull_off;
        move->until = WB_UNTIL_PRESSED;
        return true;
    default:
        return false;
    }
}

bool wb_homing_ended(const struct wb_settings *settings, struct wb_stepper *stepper, uint8_t phase)
{
    if (phase == WB_PHASE_HOME_PULL_OFF || phase == WB_PHASE_CLEAR_WIRE) {
        return stepper->end == WB_END_REACHED;
    }
    if (stepper->end != WB_END_SWITCH) {
        return false;
    }
    if (phase == WB_PHASE_HOME_LOCATE) {
        int32_t steps = 2 * wb_setting(settings, WB_SETTING_HOME_BACK_OFF);
        if (steps - (int32_t)stepper->remaining <= WB_SWITCH_READINGS) {
            return false; /* pressed from the first step on: it sticks */
        }
        stepper->position[WB_BEND] = wb_setting(settings, WB_SETTING_HOME_POSITION);
    }
    return true;
}
