#include "boots.h"

#include <stdbool.h>

#include "crc.h"
#include "hal.h"

/* A ring of numbers with a checksum each, of which every start writes the next one: a cell of the EEPROM bears 100 000
 * writes, the ring 1.6 million starts. A number whose write was cut is not counted; those before it are still there. */
#define FIRST 128
#define COUNT 16
#define SIZE 4
#define SEED 0xB007

/* Where firmware 1.00 kept it. */
#define OLD 0

static uint16_t word(void *board, uint16_t at)
{
    return (uint16_t)(hal_stored(board, at) | hal_stored(board, (uint16_t)(at + 1)) << 8);
}

static uint16_t sum(uint16_t boots)
{
    return wb_crc16(wb_crc16(SEED, (uint8_t)boots), (uint8_t)(boots >> 8));
}

uint16_t wb_boots_count(void *board)
{
    uint16_t boots = word(board, OLD); /* in an empty memory 65535, to which the first start adds one */
    uint8_t newest = COUNT - 1;
    bool found = false;
    for (uint8_t i = 0; i < COUNT; i++) {
        uint16_t at = (uint16_t)(FIRST + i * SIZE);
        uint16_t one = word(board, at);
        if (word(board, (uint16_t)(at + 2)) == sum(one) && (!found || (int16_t)(one - boots) > 0)) {
            boots = one;
            newest = i;
            found = true;
        }
    }
    boots = (uint16_t)(boots + 1);
    uint16_t at = (uint16_t)(FIRST + (uint8_t)((newest + 1) % COUNT) * SIZE);
    uint16_t crc = sum(boots);
    hal_store(board, at, (uint8_t)boots);
    hal_store(board, (uint16_t)(at + 1), (uint8_t)(boots >> 8));
    hal_store(board, (uint16_t)(at + 2), (uint8_t)crc);
    hal_store(board, (uint16_t)(at + 3), (uint8_t)(crc >> 8));
    return boots;
}
