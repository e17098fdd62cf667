/* Soft limits: how far a line may move each axis. */
#ifndef WB_LIMITS_H
#define WB_LIMITS_H

#include <stdbool.h>
#include <stdint.h>

#include "motion/queue.h"
#include "storage/settings.h"

/* Whether the head may stand at this position, in steps. */
bool wb_limits_allow_head(const struct wb_settings *settings, int32_t position);
/* Whether the bend axis may stand at this position, in steps. */
bool wb_limits_allow_bend_axis(const struct wb_settings *settings, int32_t position);
/* Whether a move may follow the lines that wait. All in steps. */
bool wb_limits_allow_move(const struct wb_settings *settings, const struct wb_queue *queue, int32_t feed,
                          int32_t rotate, int32_t bend);

#endif
