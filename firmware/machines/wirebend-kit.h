/* The WireBend-kit bender: Arduino Uno, CNC Shield V3, DRV8825. Pins are port letter and bit. */
#ifndef WB_MACHINE_H
#define WB_MACHINE_H

#include "common/codes.h"

#define WB_MACHINE_ID WB_MACHINE_WIREBEND_KIT

/*                     port bit   Uno  CNC Shield V3 */
#define WB_PIN_FEED_STEP   D, 2 /* D2   X.STEP, and A.STEP by the jumpers that make A a copy of X */
#define WB_PIN_FEED_DIR    D, 5 /* D5   X.DIR, and A.DIR */
#define WB_PIN_ROTATE_STEP D, 4 /* D4   Z.STEP */
#define WB_PIN_ROTATE_DIR  D, 7 /* D7   Z.DIR */
#define WB_PIN_BEND_STEP   D, 3 /* D3   Y.STEP */
#define WB_PIN_BEND_DIR    D, 6 /* D6   Y.DIR */
#define WB_PIN_MOTORS_OFF  B, 0 /* D8   EN, low turns the drivers on */
#define WB_PIN_SWITCH      B, 2 /* D10  Y limit, normally closed to ground: open or broken reads high */
#define WB_PIN_EMERGENCY   C, 0 /* A0   Abort, sense of the emergency stop: a contact to ground that opens */
#define WB_PIN_HOLD        C, 1 /* A1   Hold, door or feed hold: a contact to ground that opens */
#define WB_PIN_PEG         B, 3 /* D11  Z limit, signal of the servo */
#define WB_PEG_AT_OC2A          /* which is the pin that timer 2 can drive */

/* In the order of firmware/protocol/settings.csv. Figures are those of the paper where it has them, otherwise estimates. */
#define WB_MACHINE_DEFAULTS                                                                     \
    54440,  /* feed, steps/m: 6400 a turn, wheel of 37.42 mm */                                 \
    16457,  /* rotate, steps/rev: 6400 a turn, belt 18/7 */                                     \
    21480,  /* bend, steps/rev: 800 a turn, gearbox 26.85 */                                    \
    6000,   /* feed, steps/s: 110.2 mm/s */                                                     \
    6000,   /* rotate, steps/s: 131.3 degrees/s */                                              \
    900,    /* bend, steps/s: 15.1 degrees/s */                                                 \
    30000,  /* feed, steps/s^2 */                                                               \
    20000,  /* rotate, steps/s^2 */                                                             \
    4000,   /* bend, steps/s^2 */                                                               \
    400000, /* longest feed of a line, steps: 7.3 m */                                          \
    16457,  /* soft limit of the head, steps: 360 degrees */                                    \
    9248,   /* soft limit of the bend axis, steps: 155 degrees */                               \
    1089,   /* near side, steps: 13.25 degrees at which the peg touches straight wire, and 5 */ \
    1193,   /* back off, steps: 20 degrees, more than the wire springs after the peg */         \
    1000,   /* servo with the peg in, us */                                                     \
    2000,   /* servo with the peg out, us */                                                    \
    500,    /* time that the peg needs, ms */                                                   \
    -9547,  /* position of the switch, steps: -160 degrees */                                   \
    600,    /* homing, fast approach, steps/s */                                                \
    100,    /* homing, slow approach, steps/s */                                                \
    120,    /* homing, pull-off, steps: 2 degrees */                                            \
    20000,  /* homing, longest travel, steps: from one end to the other and more */             \
    90000,  /* homing, longest time, ms */                                                      \
    0,      /* nothing inverted */                                                              \
    0,      /* motors stay on when idle */                                                      \
    0       /* no inputs wired */

#endif
