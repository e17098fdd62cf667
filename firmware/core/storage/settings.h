/* The settings of the machine, stored with a version and a checksum. */
#ifndef WB_SETTINGS_H
#define WB_SETTINGS_H

#include <stdbool.h>
#include <stdint.h>

#include "common/codes.h"

/* Version of the stored layout. Version 1, of firmware 1.00, is converted; any other counts as damaged. */
#define WB_SETTINGS_VERSION 2

struct wb_settings {
    bool good;                        /* flag: they are valid; otherwise nothing may move */
    int32_t value[WB_SETTINGS_COUNT]; /* numbers by id - 1, in the units of codes.h */
};

/* The value of a setting by its id. */
int32_t wb_setting(const struct wb_settings *settings, uint8_t id);

/* Reads the stored settings: `good` when one copy has the right version and checksum and every value is in range. */
void wb_settings_load(struct wb_settings *settings, void *board);
/* Changes one and stores all. false when there is no such id (then `known` is false) or the value is out of range. */
bool wb_settings_change(struct wb_settings *settings, void *board, int32_t id, int32_t value, bool *known);
/* Stores the defaults of the machine's file. */
void wb_settings_defaults(struct wb_settings *settings, void *board);

#endif
