#include "homing.h"

#include "motion.h"

/* How far the axis may stand beyond the edge of its switch, in ways back from it. A switch that is still pressed
 * after that is stuck, or its wire is broken: the axis must not run around to its other end. */
#define PRESSED_BACK_OFFS 10

/* The side on which the switch is. */
static int32_t side(const struct wb_settings *settings)
{
    return wb_setting(settings, WB_SETTING_HOME_POSITION) < 0 ? -1 : 1;
}

bool wb_switch_pressed(const struct wb_controller *c)
{
    bool inverted = (wb_setting(&c->settings, WB_SETTING_INVERTED) & WB_INVERTED_SWITCH) != 0;
    return hal_switch_high(c->board) != inverted;
}

bool wb_homing_move(const struct wb_controller *c, uint8_t phase, struct wb_move *move)
{
    const struct wb_settings *settings = &c->settings;
    int32_t towards = side(settings);
    int32_t travel = wb_setting(settings, WB_SETTING_HOME_TRAVEL);
    int32_t back_off = wb_setting(settings, WB_SETTING_HOME_BACK_OFF);
    move->rate = (uint16_t)wb_setting(settings, WB_SETTING_HOME_FAST_RATE);
    move->readings = WB_SWITCH_SAMPLES;
    switch (phase) {
    case WB_LEAVES_SWITCH:
        if (travel > PRESSED_BACK_OFFS * back_off) {
            travel = PRESSED_BACK_OFFS * back_off;
        }
        move->steps = -towards * travel;
        move->until = WB_UNTIL_RELEASED;
        return wb_switch_pressed(c);
    case WB_SEEKS_FAST:
        move->steps = towards * travel;
        move->until = WB_UNTIL_PRESSED;
        return true;
    case WB_LEAVES_AGAIN:
        move->steps = -towards * back_off;
        move->until = WB_UNTIL_COUNT;
        return true;
    case WB_SEEKS_SLOW:
        move->rate = (uint16_t)wb_setting(settings, WB_SETTING_HOME_SLOW_RATE);
        /* Twice the way back: the switch has some play. */
        move->steps = 2 * towards * back_off;
        move->until = WB_UNTIL_PRESSED;
        return true;
    default:
        return false;
    }
}

bool wb_homing_ended(struct wb_controller *c, uint8_t phase, uint8_t end)
{
    if (phase == WB_LEAVES_AGAIN || phase == WB_LEAVES_WIRE) {
        return end == WB_END_REACHED;
    }
    if (end != WB_END_SWITCH) {
        return false;
    }
    if (phase == WB_SEEKS_SLOW) {
        int32_t way = 2 * wb_setting(&c->settings, WB_SETTING_HOME_BACK_OFF);
        if (way - (int32_t)c->stepper.remaining <= WB_SWITCH_SAMPLES) {
            return false; /* pressed from the first step on: it sticks */
        }
        c->stepper.position[WB_BEND] = wb_setting(&c->settings, WB_SETTING_HOME_POSITION);
        c->placed = true;
    }
    return true;
}

bool wb_homing_late(struct wb_controller *c)
{
    uint16_t passed = (uint16_t)(wb_ticks(c) - c->homing_tick);
    c->homing_tick = (uint16_t)(c->homing_tick + passed);
    c->homing_ticks += passed;
    /* A tick is 1.024 ms: the time is exceeded by a fortieth at most. */
    return c->homing_ticks > (uint32_t)wb_setting(&c->settings, WB_SETTING_HOME_TIME_MS);
}
