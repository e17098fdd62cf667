#include "storage/wire_side.h"

#include <stdbool.h>

#include "common/compiler.h"
#include "hal.h"

/* A ring of bytes; each change writes the next one. A cell of the EEPROM lasts for 100 000 writes and a bend makes two,
 * so the ring lasts for three million bends. The highest bit changes from round to round; the newest byte is the last
 * one of its round. A byte whose write was interrupted is not valid, and the one before it counts: it is written before
 * the peg goes out and after it is in. */
#define FIRST 192
#define COUNT 64
#define ROUND 0x80

/* At least four bits apart from each other and from a byte that was never written. */
static const WB_FLASH uint8_t CODE[] = {0x65, 0x16, 0x59}; /* negative, none, positive */

static bool decode(uint8_t byte, int8_t *side)
{
    for (uint8_t i = 0; i < sizeof CODE; i++) {
        if ((uint8_t)(byte & ~ROUND) == CODE[i]) {
            *side = (int8_t)(i - 1);
            return true;
        }
    }
    return false;
}

/* Index of the newest byte; COUNT when there is none. */
static uint8_t newest(void *board, int8_t *side, uint8_t *round)
{
    uint8_t index = COUNT;
    *side = 0;
    *round = ROUND;
    for (uint8_t i = 0; i < COUNT; i++) {
        uint8_t byte = hal_stored(board, (uint16_t)(FIRST + i));
        int8_t one;
        if (!decode(byte, &one)) {
            continue;
        }
        if (index != COUNT && (byte & ROUND) != *round) {
            break;
        }
        index = i;
        *side = one;
        *round = (uint8_t)(byte & ROUND);
    }
    return index;
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
    uint8_t index = newest(board, &before, &round);
    index++;
    if (index >= COUNT) {
        index = 0;
        round ^= ROUND;
    }
    hal_store(board, (uint16_t)(FIRST + index), (uint8_t)(CODE[side + 1] | round));
}
