/* How often the controller has started. */
#ifndef WB_BOOTS_H
#define WB_BOOTS_H

#include <stdint.h>

/* Counts this start. */
uint16_t wb_boots_count(void *board);

#endif
