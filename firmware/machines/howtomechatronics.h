/* The 3D wire bender of howtomechatronics.com and its clones: Arduino Uno, three drivers, a servo. Pins are port
 * letter and bit. Pins and steps are those of the sketch, on which several public copies of it agree; nothing of this
 * has been tried on a machine. */
#ifndef WB_MACHINE_H
#define WB_MACHINE_H

#include "common/codes.h"

#define WB_MACHINE_ID WB_MACHINE_HOWTOMECHATRONICS

/*                     port bit   Uno  in the sketch */
#define WB_PIN_FEED_STEP   D, 5 /* D5   feederStepper(1, 5, 6) */
#define WB_PIN_FEED_DIR    D, 6 /* D6 */
#define WB_PIN_ROTATE_STEP D, 7 /* D7   zAxisStepper(1, 7, 8) */
#define WB_PIN_ROTATE_DIR  B, 0 /* D8 */
#define WB_PIN_BEND_STEP   B, 1 /* D9   benderStepper(1, 9, 10) */
#define WB_PIN_BEND_DIR    B, 2 /* D10 */
#define WB_PIN_SWITCH      B, 3 /* D11  limitSwitch, input with pull-up: low when pressed */
#define WB_PIN_PEG         D, 2 /* D2   servo01; the program makes its edges, to about 10 us */
#define WB_PIN_MOTORS_OFF  B, 4 /* D12  EN of the three drivers, with a pull-up; not in the sketch, where they are always on */
#define WB_PIN_EMERGENCY   C, 0 /* A0   sense of the emergency stop: a contact to ground that opens; not in the sketch */
#define WB_PIN_HOLD        C, 1 /* A1   door or feed hold: a contact to ground that opens; not in the sketch */

/* In the order of firmware/protocol/settings.csv. HTM: from the sketch; the others are estimates.
 * The sketch counts from where a positive bend begins; a negative one begins 43 degrees further. Zero here is in the
 * middle, with the peg on the wire's axis. The switch is on the side from which a positive bend begins. */
#define WB_MACHINE_DEFAULTS                                                                                  \
    48000,  /* feed, steps/m. HTM: 48 a mm */                                                                \
    5760,   /* rotate, steps/rev. HTM: 16 a degree */                                                        \
    5760,   /* bend, steps/rev. HTM: 16 a degree */                                                          \
    1200,   /* feed, steps/s. HTM */                                                                         \
    500,    /* rotate, steps/s. HTM */                                                                       \
    700,    /* bend, steps/s. HTM */                                                                         \
    4000,   /* feed, steps/s^2 */                                                                            \
    2000,   /* rotate, steps/s^2 */                                                                          \
    2000,   /* bend, steps/s^2 */                                                                            \
    100000, /* longest feed of a line, steps: 2 m */                                                         \
    2880,   /* soft limit of the head, steps: 180 degrees */                                                 \
    1700,   /* soft limit of the bend axis, steps: 106 degrees, short of the switch */                       \
    344,    /* near side, steps. HTM: half of 43 degrees */                                                  \
    320,    /* back off, steps: 20 degrees */                                                                \
    1884,   /* peg in, us. HTM: servo at 130 degrees, of a library that has 544 to 2400 us */                \
    956,    /* peg out, us. HTM: servo at 40 degrees */                                                      \
    500,    /* time that the peg needs, ms */                                                                \
    -1744,  /* position of the switch, steps. HTM: 1400 from the beginning of a positive bend, and 344 */    \
    700,    /* homing, fast approach, steps/s */                                                             \
    100,    /* homing, slow approach, steps/s */                                                             \
    48,     /* homing, pull-off, steps: 3 degrees */                                                         \
    3700,   /* homing, longest travel, steps: from one end to the other and more */                          \
    60000,  /* homing, longest time, ms */                                                                   \
    12,     /* inverted: 4 bend, whose switch lies where the sketch counts up; 8 switch, low when pressed */ \
    0,      /* motors stay on when idle */                                                                   \
    0       /* no inputs wired */

#endif
