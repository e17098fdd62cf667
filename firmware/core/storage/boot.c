#include "storage/boot.h"

#include <stdbool.h>

#include "common/crc.h"
#include "hal.h"

/* A ring of numbers, each with a checksum; every start writes the next one. A cell of the EEPROM lasts for 100 000
 * writes, the ring for 1.6 million starts. A number whose write was interrupted is ignored; the others remain. */
#define FIRST 128
#define COUNT 16
#define SIZE 4
#define SEED 0xB007

/* Address of the number in firmware 1.00. */
#define OLD 0

static uint16_t word(void *board, uint16_t at)
{
    return (uint16_t)(hal_stored(board, at) | hal_stored(board, (uint16_t)(at + 1)) << 8);
}

static uint16_t sum(uint16_t boots)
{
    return wb_crc16(wb_crc16(SEED, (uint8_t)boots), (uint8_t)(boots >> 8));
}

uint16_t wb_boot_count(void *board)
{
    uint16_t boots = word(board, OLD); /* 65535 in an empty memory, so that the first start is 0 */
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
