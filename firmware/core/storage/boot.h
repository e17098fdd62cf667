/* This start of the controller: its cause, and how many there were. */
#ifndef WB_BOOT_H
#define WB_BOOT_H

#include <stdbool.h>
#include <stdint.h>

struct wb_boot {
    uint16_t count; /* starts, this one included, modulo 2^16 */
    uint8_t cause;  /* code: WB_RESET_... */
    bool sent;      /* flag: the boot frame was sent */
};

/* Counts this start, in the EEPROM; its number. */
uint16_t wb_boot_count(void *board);

#endif
