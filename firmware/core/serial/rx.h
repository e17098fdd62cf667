/* From received bytes to frames. The serial interrupt fills a ring, the main loop empties it. */
#ifndef WB_RX_H
#define WB_RX_H

#include <stdbool.h>
#include <stdint.h>

#include "serial/frame.h"

/* Size of the ring. The host sends at most four lines ahead, and the main loop reads bytes as they come. */
#define WB_RX_BYTES 128

enum wb_rx_result {
    WB_RX_NOTHING, /* no more bytes wait */
    WB_RX_FRAME,   /* a valid frame: its payload is in `frame.text` */
    WB_RX_INVALID  /* a damaged line */
};

struct wb_rx {
    volatile uint8_t byte[WB_RX_BYTES]; /* bytes */
    volatile uint8_t in;                /* index: the interrupt writes here */
    volatile uint8_t out;               /* index: the main loop reads here */
    volatile uint8_t stop_end;          /* index: what came before it came before the last STOP */
    struct wb_frame frame;
};

/* A byte from the line; `damaged` when the receiver saw a framing error or lost bytes. From the serial interrupt. */
void wb_rx_put(struct wb_rx *rx, uint8_t byte, bool damaged);
/* Drops what came before the last STOP. Locked: the serial interrupt must not come in between. */
void wb_rx_drop_before_stop(struct wb_rx *rx);
/* Whether bytes wait. */
bool wb_rx_waiting(const struct wb_rx *rx);
/* Reads bytes up to the end of the next line. `session` is the id that seals its frame. */
enum wb_rx_result wb_rx_next(struct wb_rx *rx, uint16_t session);

#endif
