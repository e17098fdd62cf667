/* Where the bend axis goes: the peg comes out on the near side of the wire, bends it, backs off and goes in. */
#ifndef WB_BEND_H
#define WB_BEND_H

#include <stdbool.h>
#include <stdint.h>

#include "common/line.h"
#include "storage/settings.h"

/* How far before zero the peg comes out for an approach of a line, in steps: at the near side at least. */
int32_t wb_bend_near(const struct wb_settings *settings, int32_t approach);
/* To which side of the wire a line bends: 1 or -1; 0 where it does not. It is that opposite to its approach, so that the axis may
 * stop at zero or before it; without an approach it is that of the bend. */
int8_t wb_bend_side(const struct wb_line *line);
/* Whether a line with an approach bends at all: the axis has to stop beyond where the peg comes out. */
bool wb_bend_possible(const struct wb_settings *settings, int32_t bend, int32_t approach);
/* Target of a phase that moves the bend axis, in a bend to `bend` on a `side`, whose peg comes out `near` before zero. All in
 * steps from zero. */
int32_t wb_bend_target(const struct wb_settings *settings, uint8_t phase, int8_t side, int32_t bend, int32_t near);
/* Target that takes the peg off a wire that it was bending, in steps. `side` is that of the wire, `position` that of
 * the axis, `near` how far before zero the peg came out; unless the axis is located its position means nothing, and it
 * goes the whole way back. */
int32_t wb_bend_clear(const struct wb_settings *settings, int8_t side, int32_t position, int32_t near, bool located);

#endif
