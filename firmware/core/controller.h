/* The controller: the structs of all rooms.
 *
 * Steps are counted in the frame of the program: positive feeds forward, turns the head by the right-hand rule about
 * the direction of the wire, and bends towards the head's normal. */
#ifndef WB_CONTROLLER_H
#define WB_CONTROLLER_H

#include "storage/boot.h"
#include "common/clock.h"
#include "motion/inputs.h"
#include "motion/motion.h"
#include "motion/queue.h"
#include "serial/rx.h"
#include "safety.h"
#include "serial/session.h"
#include "storage/settings.h"

/* Version of the wire protocol; the host refuses another. */
#define WB_PROTOCOL 1
/* Version of this firmware: 100 * major + minor. */
#define WB_FIRMWARE 113

struct wb_controller {
    void *board; /* what the board wants of every hal_ function */
    struct wb_settings settings;
    struct wb_clock clock;
    struct wb_inputs inputs;
    struct wb_rx rx;
    struct wb_session session;
    struct wb_queue queue;
    struct wb_motion motion;
    struct wb_safety safety;
    struct wb_boot boot;
};

#endif
