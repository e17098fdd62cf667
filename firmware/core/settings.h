/* What a person can set on the machine: kept with a version and a checksum, and never guessed. */
#ifndef WB_SETTINGS_H
#define WB_SETTINGS_H

#include <stdbool.h>
#include <stdint.h>

#include "codes.h"

/* Layout of what is stored. That of firmware 1.00, version 1, is taken over; another one is refused like damage. */
#define WB_SETTINGS_VERSION 2

struct wb_settings {
    bool good;                        /* false: nothing may move */
    int32_t value[WB_SETTINGS_COUNT]; /* by id, from 1 */
};

/* The value of a setting by its id. */
int32_t wb_setting(const struct wb_settings *settings, uint8_t id);

/* Reads what is stored; not `good` when the version or checksum of both copies is wrong or a value is out of range. */
void wb_settings_load(struct wb_settings *settings, void *board);
/* Changes one and stores all. false when there is no such id (`known` says so) or the value is out of range. */
bool wb_settings_change(struct wb_settings *settings, void *board, int32_t id, int32_t value, bool *known);
/* Takes and stores what the machine's file says. */
void wb_settings_defaults(struct wb_settings *settings, void *board);

#endif
