/* Steps of one axis at a time, with a trapezoid of speed.
 *
 * The interval between two pulses follows David Austin's recurrence of a constant acceleration (Generate
 * stepper-motor speed profiles in real time, 2004): c(n) = c(n-1) - 2 c(n-1) / (4 n + 1), in integers with the
 * remainder carried, and back the same way. */
#ifndef WB_STEPPER_H
#define WB_STEPPER_H

#include <stdbool.h>
#include <stdint.h>

#include "hal.h"

/* How often in a row the switch has to read the same, once a step: motors make noise on its wire. */
#define WB_SWITCH_SAMPLES 4
/* The same while an axis moves that does not turn towards it: more, for they are fast. */
#define WB_GUARD_SAMPLES 16

/* What ends a move before its last step. */
enum wb_until {
    WB_UNTIL_COUNT,   /* nothing */
    WB_UNTIL_PRESSED, /* the switch is pressed */
    WB_UNTIL_RELEASED /* the switch is released */
};

enum wb_end {
    WB_END_REACHED, /* every step is made */
    WB_END_HELD,    /* it holds with steps left */
    WB_END_SWITCH,  /* the switch has ended it */
    WB_END_CUT,     /* it was stopped at once */
    WB_END_LATE     /* a pulse came too late */
};

struct wb_move {
    uint8_t axis;
    uint8_t until;
    uint8_t readings;      /* of the switch in a row that end it */
    bool inverted;         /* the motor turns the other way */
    bool switch_inverted;  /* the switch reads low when pressed */
    int32_t steps;
    uint16_t rate;         /* steps/s */
    uint32_t acceleration; /* steps/s^2 */
};

struct wb_stepper {
    void *board;
    volatile int32_t position[WB_AXES]; /* steps */
    volatile bool moving;
    volatile bool hold;
    volatile bool latched; /* no move begins */
    volatile uint8_t end;
    struct wb_move move;
    volatile uint32_t remaining; /* steps */
    uint32_t ramp;         /* steps that it takes to stand */
    uint32_t rest;         /* what the last division left */
    uint16_t interval;     /* to the pulse after the next, ticks */
    uint16_t least;        /* at full speed, ticks */
    bool slowing;
    uint8_t samples;       /* how often the switch has read so in a row */
};

/* Begins a move of at least one step; not while one goes on. When latched it ends at once as cut. */
void wb_stepper_begin(struct wb_stepper *stepper, const struct wb_move *move);
/* Goes on with what is left after a hold. */
void wb_stepper_go_on(struct wb_stepper *stepper);
/* No pulse comes after this, and no move begins until it is unlatched. From interrupts too. */
void wb_stepper_cut(struct wb_stepper *stepper);
void wb_stepper_unlatch(struct wb_stepper *stepper);

/* The step interrupt, in two parts: the pulse, which must not wait; true when the second part is wanted. */
bool wb_stepper_pulse(struct wb_stepper *stepper);
/* The division that finds the interval after the next. Other interrupts may come in between. */
void wb_stepper_plan(struct wb_stepper *stepper);

#endif
