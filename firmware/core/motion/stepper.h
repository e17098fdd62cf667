/* Steps of one axis at a time, at a constant acceleration up to a constant speed and back.
 *
 * The interval between two pulses follows David Austin's recurrence (Generate stepper-motor speed profiles in real
 * time, 2004): c(n) = c(n-1) - 2 c(n-1) / (4 n + 1), in integers with the remainder carried, and back the same way. */
#ifndef WB_STEPPER_H
#define WB_STEPPER_H

#include <stdbool.h>
#include <stdint.h>

#include "hal.h"

/* Readings in a row, one a step, until the switch counts as pressed or released: motors disturb its wire. */
#define WB_SWITCH_READINGS 4
/* The same while an axis moves that does not turn towards it: more, for they are fast. */
#define WB_GUARD_READINGS 16

/* What ends a move before its last step. */
enum wb_until {
    WB_UNTIL_COUNT,   /* nothing */
    WB_UNTIL_PRESSED, /* the switch is pressed */
    WB_UNTIL_RELEASED /* the switch is released */
};

/* How a move has ended. */
enum wb_end {
    WB_END_REACHED, /* every step is done */
    WB_END_HELD,    /* it holds with steps left */
    WB_END_SWITCH,  /* by the switch */
    WB_END_STOPPED, /* at once, by wb_stepper_stop */
    WB_END_LATE     /* a pulse came too late */
};

struct wb_move {
    uint8_t axis;          /* enum wb_axis */
    uint8_t until;         /* enum wb_until */
    uint8_t readings;      /* readings of the switch in a row that end it */
    bool inverted;         /* flag: the motor turns the other way */
    bool switch_inverted;  /* flag: the switch reads low when pressed */
    int32_t steps;         /* steps */
    uint16_t rate;         /* steps/s */
    uint32_t acceleration; /* steps/s^2 */
};

struct wb_stepper {
    void *board;
    volatile int32_t position[WB_AXES]; /* steps */
    volatile bool moving;               /* flag: pulses come */
    volatile bool hold;                 /* flag: slow down and hold */
    volatile bool latched;              /* flag: stopped; no move begins */
    volatile uint8_t end;               /* enum wb_end */
    struct wb_move move;
    volatile uint32_t remaining; /* steps */
    uint32_t ramp;               /* steps that it takes to stand */
    uint32_t remainder;          /* 0.5 us times the last divisor: what the last division left */
    uint16_t interval;           /* 0.5 us: to the pulse after the next */
    uint16_t min_interval;       /* 0.5 us: at full speed */
    bool slowing;                /* flag: `remainder` is of slowing down */
    uint8_t readings;            /* readings in a row in which the switch has ended the move */
};

/* Begins a move of at least one step, while none is under way. When latched it ends at once as stopped. */
void wb_stepper_begin(struct wb_stepper *stepper, const struct wb_move *move);
/* Runs the steps that a hold has left. */
void wb_stepper_resume(struct wb_stepper *stepper);
/* No pulse comes after this, and no move begins until it is unlatched. From interrupts too. */
void wb_stepper_stop(struct wb_stepper *stepper);
void wb_stepper_unlatch(struct wb_stepper *stepper);

/* The step interrupt, in two parts: the pulse, which must not wait; true when the second part is wanted. */
bool wb_stepper_pulse(struct wb_stepper *stepper);
/* The division that finds the interval after the next. Other interrupts may come in between. */
void wb_stepper_plan(struct wb_stepper *stepper);

#endif
