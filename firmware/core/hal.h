/* What the core needs of a board. `board` is what the controller was started with.
 *
 * The main loop may call everything. What interrupts call too is marked. */
#ifndef WB_HAL_H
#define WB_HAL_H

#include <stdbool.h>
#include <stdint.h>

#define WB_TIMER_HZ 2000000uL /* 1/s: the step timer counts 0.5 us */
#define WB_TICK_US 1024u      /* us: period of the system tick */

/* Bits of the setting `inputs`. */
#define WB_INPUT_HOLD 1u
#define WB_INPUT_EMERGENCY 2u

enum wb_axis { WB_FEED, WB_ROTATE, WB_BEND, WB_AXES };

/* No interrupt of the board comes between these two. Not nested. */
void hal_lock(void *board);
void hal_unlock(void *board);

/* Direction of the next pulses of an axis, as the motor sees it. */
void hal_direction(void *board, uint8_t axis, bool forward);
/* One step pulse, high for at least 1.9 us. From the step interrupt. */
void hal_pulse(void *board, uint8_t axis);
/* Level of the switch's pin. With a normally closed switch it is high when pressed, or when the wire is broken.
 * From the step interrupt too. */
bool hal_switch_high(void *board);
/* Motor drivers on: they hold their positions. */
void hal_motors_on(void *board);
/* Motor drivers off: the axes can be turned by hand, and this is not counted. */
void hal_motors_off(void *board);
/* Whether the contact of an input is open, or its wire broken. From interrupts too. */
bool hal_input_open(void *board, uint8_t input);

/* Starts the step timer: the first interrupt comes after this time. */
void hal_timer_start(void *board, uint16_t interval /* 0.5 us */);
/* Sets the time from this step interrupt to the next, first thing in it. false when that time is already over. */
bool hal_timer_next(void *board, uint16_t interval /* 0.5 us */);
/* No more step interrupts. From interrupts too. */
void hal_timer_stop(void *board);

/* Pulse width of the servo. Locked. */
void hal_peg(void *board, uint16_t width /* us */);

/* Free bytes of the send buffer, and one byte into it; only when there is room. */
uint8_t hal_send_room(void *board);
void hal_send(void *board, uint8_t byte);

/* Bytes of the EEPROM. */
uint8_t hal_stored(void *board, uint16_t address);
void hal_store(void *board, uint16_t address, uint8_t byte);

#endif
