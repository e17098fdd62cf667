#include "common/crc.h"

uint16_t wb_crc16(uint16_t crc, uint8_t byte)
{
    crc = (uint16_t)(crc ^ byte);
    for (uint8_t bit = 0; bit < 8; bit++) {
        uint16_t carry = (uint16_t)-(crc & 1u);
        crc = (uint16_t)((crc >> 1) ^ (0x8408u & carry));
    }
    return crc;
}
