/* The search of the bend axis for its switch: fast, back, slow; bounded in way and time. */
#ifndef WB_HOMING_H
#define WB_HOMING_H

#include "controller.h"

/* Whether the switch of the bend axis is pressed, or its wire broken. */
bool wb_switch_pressed(const struct wb_controller *c);
/* The move of a phase of homing. false when the phase has none. */
bool wb_homing_move(const struct wb_controller *c, uint8_t phase, struct wb_move *move);
/* What a move that has ended means: false when homing has failed. */
bool wb_homing_ended(struct wb_controller *c, uint8_t phase, uint8_t end);
/* Whether it has taken too long. */
bool wb_homing_late(struct wb_controller *c);

#endif
