#include "motion/peg.h"

#include "storage/wire_side.h"

bool wb_peg_move(struct wb_peg *peg, const struct wb_stepper *stepper, const struct wb_settings *settings,
                 const struct wb_clock *clock, uint8_t target)
{
    if (peg->position == target) {
        return false;
    }
    uint8_t id = target == WB_PEG_OUT ? WB_SETTING_PEG_OUT_US : WB_SETTING_PEG_IN_US;
    uint16_t width = (uint16_t)wb_setting(settings, id);
    hal_lock(stepper->board);
    if (!stepper->latched) {
        hal_peg(stepper->board, width);
        peg->position = target;
    }
    hal_unlock(stepper->board);
    peg->moved_at = wb_clock_now(clock, stepper->board);
    return true;
}

bool wb_peg_arrived(const struct wb_peg *peg, const struct wb_settings *settings, uint16_t now)
{
    /* A tick is a little more than a millisecond, and the first one has begun already. */
    return (uint16_t)(now - peg->moved_at) > wb_setting(settings, WB_SETTING_PEG_TIME_MS);
}

void wb_peg_set_wire_side(struct wb_peg *peg, void *board, int8_t side)
{
    if (peg->wire_side != side) {
        peg->wire_side = side;
        wb_wire_side_store(board, side);
    }
}
