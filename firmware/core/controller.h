/* The machine: what the host asks for, and what the motors, the peg and the switch do about it.
 *
 * A board calls wb_start once, the wb_on_ functions from its interrupts, and wb_poll from its main loop.
 * Steps are counted in the frame of the program: positive feeds forward, turns the head by the right-hand
 * rule about the wire's way, bends towards the head's normal. */
#ifndef WB_CONTROLLER_H
#define WB_CONTROLLER_H

#include <stdbool.h>
#include <stdint.h>

#include "codes.h"
#include "frame.h"
#include "parse.h"
#include "settings.h"
#include "stepper.h"

/* Version of the wire protocol; the host refuses another. */
#define WB_PROTOCOL 1
/* Version of this firmware, as 100 * major + minor. */
#define WB_FIRMWARE 110

/* Lines that wait; a host sends at most four ahead. */
#define WB_QUEUE 8
/* Bytes that wait to be looked at: four of the longest lines would be more, and they are looked at as they come. */
#define WB_RECEIVED 128

enum wb_peg { WB_PEG_IN, WB_PEG_OUT, WB_PEG_UNKNOWN };

struct wb_line {
    uint32_t n;
    char letter;
    int32_t feed, rotate, bend; /* steps; of a peg line `feed` is 1 for out */
};

struct wb_controller {
    void *board;
    struct wb_settings settings;
    struct wb_stepper stepper;

    /* From the serial interrupt to the main loop. */
    volatile uint8_t received[WB_RECEIVED];
    volatile uint8_t received_in, received_out;
    volatile bool stop_asked;
    volatile uint8_t stop_mark; /* what came before this place is not looked at any more */
    volatile uint16_t ticks;
    volatile uint8_t inputs; /* those that are wired */
    volatile uint8_t hold_open, emergency_open; /* for how many ticks they have been, up to enough */
    struct wb_frame frame;

    /* The session. */
    uint16_t session;
    uint32_t last, done;
    bool done_told;
    bool alarm_told;
    uint16_t heard; /* tick of the last valid frame */
    uint8_t reset;
    uint16_t boots;
    bool boot_told;

    /* The lines that wait, and the one that is made. */
    struct wb_line queue[WB_QUEUE];
    uint8_t queued, first;
    struct wb_line line;
    uint8_t phase;      /* of the line; 0 when none is made */
    uint8_t doing;      /* what it waits for */
    uint16_t since;     /* tick at which the peg was told */
    int32_t head;       /* where the head will stand after every line that waits, steps */
    int32_t fed;        /* the same of the feed */
    uint32_t homing_ticks; /* since homing began */
    uint16_t homing_tick;
    uint32_t rest_ticks; /* at rest with the drivers on */
    uint16_t rest_tick;

    uint8_t alarm;
    uint8_t peg;
    int8_t wire_side; /* the side from which the peg may press on the wire; 0 when it does not */
    bool placed;      /* the bend axis was homed since the start: its position means something */
    bool homed;
    bool motors;      /* the drivers are on */
    bool input_holds; /* what holds is the hold input */
    bool held;      /* by pause: no phase begins */
    bool hold_next; /* the host is gone: no line begins */
};

void wb_start(struct wb_controller *controller, void *board, uint8_t reset);

/* A byte from the host; `damaged` when the receiver saw a framing error or lost bytes. From its interrupt. */
void wb_on_byte(struct wb_controller *controller, uint8_t byte, bool damaged);
/* Every WB_TICK_US. From its interrupt. */
void wb_on_tick(struct wb_controller *controller);
/* The step interrupt, in two parts: see stepper.h. */
bool wb_on_step(struct wb_controller *controller);
void wb_on_step_rest(struct wb_controller *controller);

/* What it does: one of the states in codes.h. */
uint8_t wb_state(const struct wb_controller *controller);
/* Whether an input that is wired is open now. */
bool wb_input_open(const struct wb_controller *controller, uint8_t input);
/* Ticks since the start, over and over. */
uint16_t wb_ticks(struct wb_controller *controller);

/* Everything else. true when there is more to do at once; else nothing is lost by sleeping until an interrupt. */
bool wb_poll(struct wb_controller *controller);

#endif
