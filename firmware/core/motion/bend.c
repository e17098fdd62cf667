#include "motion/bend.h"

#include "common/phase.h"

int32_t wb_bend_near(const struct wb_settings *settings, int32_t approach)
{
    int32_t near = wb_setting(settings, WB_SETTING_NEAR_SIDE);
    int32_t asked = approach < 0 ? -approach : approach;
    return asked > near ? asked : near;
}

int8_t wb_bend_side(const struct wb_line *line)
{
    int32_t towards = line->approach != 0 ? -line->approach : line->bend;
    return (int8_t)((towards > 0) - (towards < 0));
}

bool wb_bend_possible(const struct wb_settings *settings, int32_t bend, int32_t approach)
{
    return approach == 0 || (approach < 0 ? bend : -bend) > -wb_bend_near(settings, approach);
}

int32_t wb_bend_target(const struct wb_settings *settings, uint8_t phase, int8_t side, int32_t bend, int32_t near)
{
    int32_t back = side * bend - wb_setting(settings, WB_SETTING_BACK_OFF);
    switch (phase) {
    case WB_PHASE_APPROACH:
        return -side * near;
    case WB_PHASE_BEND:
        return bend;
    case WB_PHASE_BACK_OFF:
        /* No further than where the peg came out, which is clear of the wire and within the range of the axis. */
        return side * (back < -near ? -near : back);
    default:
        return 0;
    }
}

int32_t wb_bend_clear(const struct wb_settings *settings, int8_t side, int32_t position, int32_t near, bool located)
{
    int32_t limit = wb_setting(settings, WB_SETTING_BEND_LIMIT);
    int32_t from = side * position;
    /* Counted from where it was when the controller started: no further than from one end of the bends to the other. */
    int32_t min = located ? -near : -near - limit;
    int32_t back = from - wb_setting(settings, WB_SETTING_BACK_OFF);
    if (back < min) {
        back = min;
    }
    return side * (back < from ? back : from);
}
