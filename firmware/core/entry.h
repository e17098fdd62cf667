/* What a board calls: wb_start once, the wb_on_ functions from its interrupts, and wb_poll from its main loop. */
#ifndef WB_ENTRY_H
#define WB_ENTRY_H

#include <stdbool.h>
#include <stdint.h>

#include "controller.h"

/* `board` is handed to every function of hal.h; `reset` is one of WB_RESET_... */
void wb_start(struct wb_controller *controller, void *board, uint8_t reset);

/* A byte from the host; `damaged` when the receiver saw a framing error or lost bytes. From its interrupt. */
void wb_on_byte(struct wb_controller *controller, uint8_t byte, bool damaged);
/* Every WB_TICK_US. From its interrupt. */
void wb_on_tick(struct wb_controller *controller);
/* The step interrupt, in two parts: see stepper.h. */
bool wb_on_step(struct wb_controller *controller);
void wb_on_step_rest(struct wb_controller *controller);
/* Whether step interrupts are to come: not after a STOP, nor after a move has ended. From its interrupt. */
bool wb_stepping(const struct wb_controller *controller);

/* Everything else. true when there is more to do at once; otherwise nothing is lost by sleeping until an interrupt. */
bool wb_poll(struct wb_controller *controller);

#endif
