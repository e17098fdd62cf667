/* Homing of the bend axis: off the switch, to it fast, back, to it slowly. Bounded in travel and in time. */
#ifndef WB_HOMING_H
#define WB_HOMING_H

#include <stdbool.h>
#include <stdint.h>

#include "storage/settings.h"
#include "motion/stepper.h"

struct wb_homing {
    uint32_t elapsed; /* 1.024 ms, without holds */
    uint16_t seen_at; /* 1.024 ms: time up to which `elapsed` counts */
};

/* `now` in ticks of 1.024 ms. */
void wb_homing_start(struct wb_homing *homing, uint16_t now);
/* During a hold: it is no time of homing. */
void wb_homing_wait(struct wb_homing *homing, uint16_t now);
bool wb_homing_timed_out(struct wb_homing *homing, const struct wb_settings *settings, uint16_t now);

/* Whether a phase belongs to homing, up to where the switch is located. */
bool wb_homing_is_phase(uint8_t phase);
/* Fills in the move of a phase. false when the phase has none. */
bool wb_homing_move(const struct wb_settings *settings, bool switch_pressed, uint8_t phase, struct wb_move *move);
/* The move of a phase has ended: false when homing has failed. The last one sets the position of the axis. */
bool wb_homing_ended(const struct wb_settings *settings, struct wb_stepper *stepper, uint8_t phase);

#endif
