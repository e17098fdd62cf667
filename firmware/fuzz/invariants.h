/* The core on a computer, and a second opinion on everything it does. */
#ifndef WB_INVARIANTS_H
#define WB_INVARIANTS_H

#include "../core/controller.h"
#include "../hal_host/host.h"

struct world {
    struct wb_host *host;
    int64_t pulses[WB_AXES];  /* that the motors have made, in the program's directions, since the reset */
    int64_t offset[WB_AXES];  /* what a position is ahead of the pulses: by homing, or because somebody said so */
    int32_t reach;            /* how far the head may be: where it was when the move began, or its limit */
    int64_t bend;             /* where the bend axis really stands */
    uint8_t switch_mode;      /* 0 low, 1 high, else as the bend axis stands */
    uint16_t peg_us;          /* what the servo was told last */
    bool stopped;             /* by STOP, and not homed since */
    bool told_end;            /* of a reply: it begins anew */
};

/* A machine with small ranges and great speeds, so that much happens in little time. */
void world_begin(struct world *world, uint16_t session);
void world_end(struct world *world);
void world_run(struct world *world, uint64_t until /* cycles */);
void world_receive(struct world *world, uint8_t byte, bool damaged);
void world_look_at_switch(struct world *world);
void world_reset(struct world *world, uint8_t cause);
uint64_t world_now(const struct world *world);
/* What a command is sealed with, and the number of the next line. */
uint16_t world_session(const struct world *world);
uint32_t world_next(const struct world *world);
/* Ends the process when something is as it must not be. */
void world_check(struct world *world);

#endif
