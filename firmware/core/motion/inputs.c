#include "motion/inputs.h"

#include "common/compiler.h"
#include "hal.h"

/* An input counts as open after so many ticks in a row: 4 ms are longer than a disturbance of its wire. */
#define OPEN_TICKS 4

void wb_inputs_configure(struct wb_inputs *inputs, const struct wb_settings *settings)
{
    inputs->wired = settings->good ? (uint8_t)wb_setting(settings, WB_SETTING_INPUTS) : 0;
    if (!inputs->wired) {
        inputs->hold_open = 0;
        inputs->emergency_open = 0;
    }
}

static WB_INLINE bool is_open(const struct wb_inputs *inputs, uint8_t input)
{
    return (inputs->wired & input) && hal_input_open(inputs->board, input);
}

bool wb_input_open(const struct wb_inputs *inputs, uint8_t input)
{
    return is_open(inputs, input);
}

bool wb_inputs_tick(struct wb_inputs *inputs)
{
    if (!inputs->wired) {
        return false; /* a step may wait for this interrupt */
    }
    if (!is_open(inputs, WB_INPUT_HOLD)) {
        inputs->hold_open = 0;
    } else if (inputs->hold_open < OPEN_TICKS) {
        inputs->hold_open++;
    }
    if (!is_open(inputs, WB_INPUT_EMERGENCY)) {
        inputs->emergency_open = 0;
    } else if (inputs->emergency_open < OPEN_TICKS) {
        return ++inputs->emergency_open == OPEN_TICKS;
    }
    return false;
}

bool wb_hold_is_open(const struct wb_inputs *inputs)
{
    return inputs->hold_open == OPEN_TICKS;
}

bool wb_hold_is_closed(const struct wb_inputs *inputs)
{
    return inputs->hold_open == 0;
}

bool wb_emergency_is_open(const struct wb_inputs *inputs)
{
    return inputs->emergency_open == OPEN_TICKS;
}

bool wb_switch_pressed(const struct wb_settings *settings, void *board)
{
    bool inverted = (wb_setting(settings, WB_SETTING_INVERTED) & WB_INVERTED_SWITCH) != 0;
    return hal_switch_high(board) != inverted;
}
