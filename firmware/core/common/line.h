/* A numbered line from the host: a move, a dry-run move, homing, or the peg by hand. */
#ifndef WB_LINE_H
#define WB_LINE_H

#include <stdint.h>

struct wb_line {
    uint32_t n;       /* number: counts from 1 in a session */
    char letter;      /* letter: WB_COMMAND_MOVE, _DRY, _HOME or _PEG */
    int32_t feed;     /* steps; of a peg line 1 for out, 0 for in */
    int32_t rotate;   /* steps */
    int32_t bend;     /* steps from zero; the axis returns to zero after it */
    int32_t approach; /* steps from zero: where the peg comes out, at least; 0: at the near side, and the bend's sign is its side */
};

#endif
