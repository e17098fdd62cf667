/* The motor drivers: on from the first line, off after a time at rest or when the host says so. */
#ifndef WB_MOTORS_H
#define WB_MOTORS_H

#include <stdbool.h>
#include <stdint.h>

#include "storage/settings.h"

struct wb_motors {
    bool on;          /* flag: the drivers are on, and hold */
    uint32_t idle;    /* 1.024 ms at rest with the drivers on */
    uint16_t seen_at; /* 1.024 ms: time up to which `idle` counts */
};

void wb_motors_on(struct wb_motors *motors, void *board);
void wb_motors_off(struct wb_motors *motors, void *board);
/* Whether they have been at rest for as long as the settings say. `now` in ticks of 1.024 ms. */
bool wb_motors_idle_too_long(struct wb_motors *motors, const struct wb_settings *settings, uint16_t now, bool at_rest);

#endif
