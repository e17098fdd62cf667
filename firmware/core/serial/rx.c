#include "serial/rx.h"

/* Stands for a damaged byte. No printable byte is 0, so it makes its line invalid. */
#define DAMAGED 0

void wb_rx_put(struct wb_rx *rx, uint8_t byte, bool damaged)
{
    uint8_t next = (uint8_t)((rx->in + 1) % WB_RX_BYTES);
    if (next == rx->out) {
        /* The ring is full and this byte is lost: spoil the line that it would have been part of. */
        rx->byte[(rx->in + WB_RX_BYTES - 1) % WB_RX_BYTES] = DAMAGED;
    } else {
        rx->byte[rx->in] = damaged ? DAMAGED : byte;
        rx->in = next;
    }
    if (byte == WB_STOP_BYTE) {
        rx->stop_end = rx->in;
    }
}

void wb_rx_drop_before_stop(struct wb_rx *rx)
{
    rx->out = rx->stop_end;
    rx->frame.invalid = true; /* the line that the STOP has cut in two */
}

bool wb_rx_waiting(const struct wb_rx *rx)
{
    return rx->out != rx->in;
}

enum wb_rx_result wb_rx_next(struct wb_rx *rx, uint16_t session)
{
    while (wb_rx_waiting(rx)) {
        uint8_t byte = rx->byte[rx->out];
        rx->out = (uint8_t)((rx->out + 1) % WB_RX_BYTES);
        switch (wb_frame_add(&rx->frame, byte, session)) {
        case WB_FRAME_VALID:
            return WB_RX_FRAME;
        case WB_FRAME_INVALID:
            return WB_RX_INVALID;
        default:
            break;
        }
    }
    return WB_RX_NOTHING;
}
