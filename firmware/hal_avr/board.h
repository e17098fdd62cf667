/* The ATmega328P at 16 MHz: what its interrupts and its main loop share. */
#ifndef WB_BOARD_H
#define WB_BOARD_H

#include <stdint.h>

#include "../core/controller.h"

/* The one controller of the board. */
extern struct wb_controller wb_controller;

/* Ticks since the main loop came round. */
extern volatile uint16_t wb_silent_ticks;

/* Each part of the board makes its registers ready. */
void wb_motors_begin(void);
void wb_steps_begin(void);
void wb_clock_begin(void);
void wb_serial_begin(void);

#endif
