#include "wire_side.h"

#include <stdbool.h>

#include "flash.h"
#include "hal.h"

/* A ring of bytes, of which each change writes the next one: a cell of the EEPROM bears 100 000 writes, a bend makes
 * two, so the ring bears three million bends. Each round has the other value of the highest bit; the newest byte is
 * the last of a round. A byte of which the write was cut is none of these, and the one before it counts: the write
 * comes before the peg goes out and after it is in. */
#define FIRST 192
#define COUNT 64
#define ROUND 0x80

/* Four bits or more from each other and from a byte that was never written. */
static const WB_FLASH uint8_t CODE[] = {0x65, 0x16, 0x59}; /* negative, none, positive */

static bool known(uint8_t byte, int8_t *side)
{
    for (uint8_t i = 0; i < sizeof CODE; i++) {
        if ((uint8_t)(byte & ~ROUND) == CODE[i]) {
            *side = (int8_t)(i - 1);
            return true;
        }
    }
    return false;
}

/* The place of the newest byte, from 0; COUNT when there is none. */
static uint8_t newest(void *board, int8_t *side, uint8_t *round)
{
    uint8_t place = COUNT;
    *side = 0;
    *round = ROUND;
    for (uint8_t i = 0; i < COUNT; i++) {
        uint8_t byte = hal_stored(board, (uint16_t)(FIRST + i));
        int8_t one;
        if (!known(byte, &one)) {
            continue;
        }
        if (place != COUNT && (byte & ROUND) != *round) {
            break;
        }
        place = i;
        *side = one;
        *round = (uint8_t)(byte & ROUND);
    }
    return place;
}

int8_t wb_wire_side_load(void *board)
{
    int8_t side;
    uint8_t round;
    newest(board, &side, &round);
    return side;
}

void wb_wire_side_store(void *board, int8_t side)
{
    int8_t before;
    uint8_t round;
    uint8_t place = newest(board, &before, &round);
    place++;
    if (place >= COUNT) {
        place = 0;
        round ^= ROUND;
    }
    hal_store(board, (uint16_t)(FIRST + place), (uint8_t)(CODE[side + 1] | round));
}
