/* Pins of the motors, the switch and the inputs. */
#include <util/delay_basic.h>

#include "board.h"
#include "pin.h"

void wb_motors_begin(void)
{
#ifdef WB_PIN_MOTORS_OFF
    /* Off until a line moves something. Before this the pins float, and the shield's pull-up keeps the drivers off. */
    wb_pin_high(WB_PIN_MOTORS_OFF);
    wb_pin_output(WB_PIN_MOTORS_OFF);
#endif
    wb_pin_output(WB_PIN_FEED_STEP);
    wb_pin_output(WB_PIN_FEED_DIR);
    wb_pin_output(WB_PIN_ROTATE_STEP);
    wb_pin_output(WB_PIN_ROTATE_DIR);
    wb_pin_output(WB_PIN_BEND_STEP);
    wb_pin_output(WB_PIN_BEND_DIR);
    /* Pull-up of the switch: a broken wire reads high. */
    wb_pin_high(WB_PIN_SWITCH);
    /* Pull-ups of the inputs: a broken wire reads as open. */
    wb_pin_high(WB_PIN_HOLD);
    wb_pin_high(WB_PIN_EMERGENCY);
}

void hal_direction(void *board, uint8_t axis, bool forward)
{
    (void)board;
    if (axis == WB_FEED) {
        forward ? wb_pin_high(WB_PIN_FEED_DIR) : wb_pin_low(WB_PIN_FEED_DIR);
    } else if (axis == WB_ROTATE) {
        forward ? wb_pin_high(WB_PIN_ROTATE_DIR) : wb_pin_low(WB_PIN_ROTATE_DIR);
    } else {
        forward ? wb_pin_high(WB_PIN_BEND_DIR) : wb_pin_low(WB_PIN_BEND_DIR);
    }
}

/* 32 cycles of 62.5 ns from edge to edge: the DRV8825 needs 1.9 us. */
static inline void hold_high(void)
{
    _delay_loop_1(10);
}

void hal_pulse(void *board, uint8_t axis)
{
    (void)board;
    if (axis == WB_FEED) {
        wb_pin_high(WB_PIN_FEED_STEP);
        hold_high();
        wb_pin_low(WB_PIN_FEED_STEP);
    } else if (axis == WB_ROTATE) {
        wb_pin_high(WB_PIN_ROTATE_STEP);
        hold_high();
        wb_pin_low(WB_PIN_ROTATE_STEP);
    } else {
        wb_pin_high(WB_PIN_BEND_STEP);
        hold_high();
        wb_pin_low(WB_PIN_BEND_STEP);
    }
}

bool hal_switch_high(void *board)
{
    (void)board;
    return wb_pin_is_high(WB_PIN_SWITCH);
}

void hal_motors_on(void *board)
{
    (void)board;
#ifdef WB_PIN_MOTORS_OFF
    wb_pin_low(WB_PIN_MOTORS_OFF);
#endif
}

void hal_motors_off(void *board)
{
    (void)board;
#ifdef WB_PIN_MOTORS_OFF
    wb_pin_high(WB_PIN_MOTORS_OFF);
#endif
}

bool hal_input_open(void *board, uint8_t input)
{
    (void)board;
    return input == WB_INPUT_HOLD ? wb_pin_is_high(WB_PIN_HOLD) : wb_pin_is_high(WB_PIN_EMERGENCY);
}
