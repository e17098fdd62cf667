/* The moves of a bend: the peg comes out on the near side of the wire, swings, backs off and goes in. */
#ifndef WB_BEND_H
#define WB_BEND_H

#include "controller.h"

/* Where the bend axis goes for a phase of a bend to `bend` steps; for phases that move it. */
int32_t wb_bend_target(const struct wb_settings *settings, uint8_t phase, int32_t bend);
/* Where it goes to take the peg off a wire that it was bending from this side, from where it stands. `placed`: its
 * position means something; else it goes a whole way back from where it is. */
int32_t wb_bend_clear(const struct wb_settings *settings, int8_t side, int32_t position, bool placed);

#endif
