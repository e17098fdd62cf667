#include "motion/queue.h"

uint8_t wb_queue_free(const struct wb_queue *queue)
{
    return (uint8_t)(WB_QUEUE_LINES - queue->count);
}

void wb_queue_push(struct wb_queue *queue, const struct wb_line *line)
{
    queue->line[(queue->first + queue->count) % WB_QUEUE_LINES] = *line;
    queue->count++;
}

const struct wb_line *wb_queue_first(const struct wb_queue *queue)
{
    return &queue->line[queue->first];
}

void wb_queue_remove_first(struct wb_queue *queue)
{
    queue->first = (uint8_t)((queue->first + 1) % WB_QUEUE_LINES);
    queue->count--;
}

void wb_queue_clear(struct wb_queue *queue, int32_t feed, int32_t rotate)
{
    queue->count = 0;
    queue->planned_feed = feed;
    queue->planned_rotate = rotate;
}
