#include "motion/limits.h"

static bool within(int32_t value, int32_t limit)
{
    return value >= -limit && value <= limit;
}

bool wb_limits_allow_head(const struct wb_settings *settings, int32_t position)
{
    return within(position, wb_setting(settings, WB_SETTING_ROTATE_LIMIT));
}

bool wb_limits_allow_bend_axis(const struct wb_settings *settings, int32_t position)
{
    return within(position, wb_setting(settings, WB_SETTING_BEND_LIMIT));
}

bool wb_limits_allow_move(const struct wb_settings *settings, const struct wb_queue *queue, int32_t feed,
                          int32_t rotate, int32_t bend)
{
    int32_t turn = wb_setting(settings, WB_SETTING_ROTATE_LIMIT);
    /* Positions are counted in 32 bits: 30 of them are forty kilometres of wire. */
    return within(feed, wb_setting(settings, WB_SETTING_FEED_MOST)) && within(queue->planned_feed, INT32_MAX / 2) &&
           within(rotate, 2 * turn) && within(queue->planned_rotate + rotate, turn) &&
           wb_limits_allow_bend_axis(settings, bend);
}
