/* The core on a computer, and rules that must hold whatever happens. */
#ifndef WB_INVARIANTS_H
#define WB_INVARIANTS_H

#include "../core/entry.h"
#include "../hal_host/host.h"

struct world {
    struct wb_host *host;
    int64_t pulses[WB_AXES]; /* pulses since the reset, in the program's directions */
    int64_t offset[WB_AXES]; /* steps that a position is ahead of the pulses, by homing or by the command Z */
    int32_t reach;           /* steps from zero that the head may be: its limit, or where it was when the move began */
    int64_t bend;            /* steps: where the bend axis really is */
    uint8_t switch_mode;     /* code: 0 low, 1 high, else as the bend axis is */
    uint16_t peg_us;         /* us: the last pulse width of the servo */
    bool stopped;            /* flag: by STOP, and not homed since */
    bool reply_ended;        /* flag: the next byte begins a reply */
};

/* A machine with small ranges and high speeds, so that much happens in little time. */
void world_begin(struct world *world, uint16_t session);
void world_end(struct world *world);
void world_run(struct world *world, uint64_t until /* cycles */);
void world_receive(struct world *world, uint8_t byte, bool damaged);
void world_look_at_switch(struct world *world);
void world_reset(struct world *world, uint8_t cause);
uint64_t world_now(const struct world *world);
/* The id that seals a command, and the number of the next line. */
uint16_t world_session(const struct world *world);
uint32_t world_next(const struct world *world);
/* Aborts when a rule is broken. */
void world_check(struct world *world);

#endif
