#include "bend.h"

#include "motion.h"

int32_t wb_bend_target(const struct wb_settings *settings, uint8_t phase, int32_t bend)
{
    int32_t side = bend < 0 ? -1 : 1;
    int32_t near = -wb_setting(settings, WB_SETTING_NEAR_SIDE);
    int32_t back = side * bend - wb_setting(settings, WB_SETTING_BACK_OFF);
    switch (phase) {
    case WB_GOES_NEAR:
        return side * near;
    case WB_SWINGS:
        return bend;
    case WB_BACKS_OFF:
        /* No further than where it came out, which is clear of the wire and within the range of the axis. */
        return side * (back < near ? near : back);
    default:
        return 0;
    }
}

int32_t wb_bend_clear(const struct wb_settings *settings, int8_t side, int32_t position, bool placed)
{
    int32_t near = -wb_setting(settings, WB_SETTING_NEAR_SIDE);
    int32_t farthest = wb_setting(settings, WB_SETTING_BEND_LIMIT);
    int32_t from = side * position;
    /* Counted from where it was when the controller started: no further than from one end of the bends to the other. */
    int32_t least = placed ? near : near - farthest;
    int32_t back = from - wb_setting(settings, WB_SETTING_BACK_OFF);
    if (back < least) {
        back = least;
    }
    return side * (back < from ? back : from);
}
