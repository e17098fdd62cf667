/* The lines that wait for their turn. */
#ifndef WB_QUEUE_H
#define WB_QUEUE_H

#include <stdint.h>

#include "common/line.h"

/* Lines that can wait; a host sends at most four ahead. */
#define WB_QUEUE_LINES 8

struct wb_queue {
    struct wb_line line[WB_QUEUE_LINES];
    uint8_t count;          /* lines */
    uint8_t first;          /* index */
    int32_t planned_feed;   /* steps: position of the feed after every line that waits */
    int32_t planned_rotate; /* steps: position of the head after every line that waits */
};

/* Room for more lines. */
uint8_t wb_queue_free(const struct wb_queue *queue);
/* Adds a line at the end; there must be room. */
void wb_queue_push(struct wb_queue *queue, const struct wb_line *line);
/* The line that is next; there must be one. */
const struct wb_line *wb_queue_first(const struct wb_queue *queue);
/* Drops the line that is next. */
void wb_queue_remove_first(struct wb_queue *queue);
/* Drops every line; feed and head stand at these positions, in steps. */
void wb_queue_clear(struct wb_queue *queue, int32_t feed, int32_t rotate);

#endif
