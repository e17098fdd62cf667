/* What the core asks of a board. `board` is what the controller was started with.
 *
 * Times of the step timer are in ticks of half a microsecond. Everything may be called from the main loop;
 * what interrupts call too is marked. */
#ifndef WB_HAL_H
#define WB_HAL_H

#include <stdbool.h>
#include <stdint.h>

#define WB_TIMER_HZ 2000000uL   /* ticks of the step timer, 1/s */
#define WB_TICK_US 1024u        /* period of the system tick, us */

/* Bits of the setting `inputs`. */
#define WB_INPUT_HOLD 1u
#define WB_INPUT_EMERGENCY 2u

enum wb_axis { WB_FEED, WB_ROTATE, WB_BEND, WB_AXES };

/* Nothing of the board's interrupts comes between these two. Not nested. */
void hal_lock(void *board);
void hal_unlock(void *board);

/* Which way the next pulses of an axis go, as the motor sees it. */
void hal_direction(void *board, uint8_t axis, bool forward);
/* One step pulse, high for 1.9 us or more. From the step interrupt. */
void hal_pulse(void *board, uint8_t axis);
/* Whether the switch reads high: pressed, or its wire broken. From the step interrupt too. */
bool hal_switch_high(void *board);
/* Motor drivers on: they hold. */
void hal_motors_on(void *board);
/* Motor drivers off: whoever turns an axis turns it, and nobody counts. */
void hal_motors_off(void *board);
/* Whether the contact of an input is open, or its wire broken. From interrupts too. */
bool hal_input_open(void *board, uint8_t input);

/* The first step interrupt comes after so many ticks. */
void hal_timer_start(void *board, uint16_t ticks);
/* The next one so many ticks after this one. From the step interrupt, first thing; false when it is too late. */
bool hal_timer_next(void *board, uint16_t ticks);
/* No more of them. From interrupts too. */
void hal_timer_stop(void *board);

/* Servo pulse width. */
void hal_peg(void *board, uint16_t width /* us */);

/* Room for bytes to the host, and one byte; only when there is room. */
uint8_t hal_send_room(void *board);
void hal_send(void *board, uint8_t byte);

/* A byte of the memory that outlives power. */
uint8_t hal_stored(void *board, uint16_t address);
void hal_store(void *board, uint16_t address, uint8_t byte);

#endif
