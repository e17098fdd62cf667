/* The system clock: ticks since the start, modulo 2^16, which is 67 s. */
#ifndef WB_CLOCK_H
#define WB_CLOCK_H

#include <stdint.h>

#include "hal.h"

struct wb_clock {
    volatile uint16_t ticks; /* 1.024 ms */
};

/* The time now, in ticks of 1.024 ms. Not from interrupts. */
static inline uint16_t wb_clock_now(const struct wb_clock *clock, void *board)
{
    hal_lock(board);
    uint16_t ticks = clock->ticks;
    hal_unlock(board);
    return ticks;
}

#endif
