/* The contacts of the machine: the switch of the bend axis, the hold input and the sense of the emergency stop. */
#ifndef WB_INPUTS_H
#define WB_INPUTS_H

#include <stdbool.h>
#include <stdint.h>

#include "storage/settings.h"

struct wb_inputs {
    void *board;
    volatile uint8_t wired;          /* bits: WB_INPUT_HOLD, WB_INPUT_EMERGENCY; the others are ignored */
    volatile uint8_t hold_open;      /* 1.024 ms that it has been open, up to the time that counts */
    volatile uint8_t emergency_open; /* 1.024 ms that it has been open, up to the time that counts */
};

/* Takes over the settings. */
void wb_inputs_configure(struct wb_inputs *inputs, const struct wb_settings *settings);
/* Every tick, from its interrupt. true when the emergency stop has just been pressed. */
bool wb_inputs_tick(struct wb_inputs *inputs);
/* Whether an input is wired and its contact open now. */
bool wb_input_open(const struct wb_inputs *inputs, uint8_t input);
/* Whether they have been open for longer than a disturbance of their wires. */
bool wb_hold_is_open(const struct wb_inputs *inputs);
bool wb_emergency_is_open(const struct wb_inputs *inputs);
/* Whether the hold input is closed; neither while it has only just opened. */
bool wb_hold_is_closed(const struct wb_inputs *inputs);
/* Whether the switch of the bend axis is pressed, or its wire broken. */
bool wb_switch_pressed(const struct wb_settings *settings, void *board);

#endif
