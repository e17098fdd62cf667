/* On which side of the wire the peg is out for a bend: kept through resets, because it must never be drawn in
 * while it presses on the wire. */
#ifndef WB_WIRE_SIDE_H
#define WB_WIRE_SIDE_H

#include <stdint.h>

/* 1 or -1 as the bend's sign, 0 when the peg was drawn in where it is clear. */
int8_t wb_wire_side_load(void *board);
void wb_wire_side_store(void *board, int8_t side);

#endif
