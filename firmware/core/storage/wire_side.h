/* On which side of the wire the peg is out for a bend. It is stored, because after a reset too the peg must not go in
 * while it presses on the wire. */
#ifndef WB_WIRE_SIDE_H
#define WB_WIRE_SIDE_H

#include <stdint.h>

/* 1 or -1, the sign of the bend; 0 when the peg is clear of the wire. */
int8_t wb_wire_side_load(void *board);
void wb_wire_side_store(void *board, int8_t side);

#endif
