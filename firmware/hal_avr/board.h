/* The ATmega328P at 16 MHz: what the files of this board share. */
#ifndef WB_BOARD_H
#define WB_BOARD_H

#include <stdint.h>

#include "../core/entry.h"

/* The controller of the board. */
extern struct wb_controller wb_controller;

/* Time since the main loop was last reached. */
extern volatile uint16_t wb_stalled_ticks; /* 1.024 ms */

/* Each file sets up its registers. */
void wb_motors_begin(void);
void wb_steps_begin(void);
void wb_clock_begin(void);
void wb_serial_begin(void);

#endif
