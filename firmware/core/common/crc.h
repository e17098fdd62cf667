/* The checksum of frames and of stored settings: CRC-16, polynomial 0x8408, least significant bit first. */
#ifndef WB_CRC_H
#define WB_CRC_H

#include <stdint.h>

/* Adds a byte. The first `crc` is the seed: the id of the session for a frame. */
uint16_t wb_crc16(uint16_t crc, uint8_t byte);

#endif
