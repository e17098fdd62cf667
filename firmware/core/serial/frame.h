/* Lines from the host, byte by byte: `PAYLOAD*HHHH` and a newline. */
#ifndef WB_FRAME_H
#define WB_FRAME_H

#include <stdbool.h>
#include <stdint.h>

/* The longest line, without its newline. A move with every number at its longest has 53 bytes. */
#define WB_LINE_MAX 60
/* STOP at once. Not printable, so never part of a line, and three bits from every byte of one. */
#define WB_STOP_BYTE 0x80
/* Seals the frames that belong to no session. */
#define WB_NO_SESSION 0xFFFFu

enum wb_frame_result {
    WB_FRAME_PARTIAL, /* the line continues, or was empty */
    WB_FRAME_VALID,   /* a whole frame with a valid checksum */
    WB_FRAME_INVALID  /* a whole line that is no valid frame */
};

struct wb_frame {
    char text[WB_LINE_MAX + 1]; /* bytes; of a valid frame the payload, terminated by 0 */
    uint8_t length;             /* bytes */
    bool invalid;               /* flag: the line has a byte that no frame has, or is too long */
};

/* Adds a byte to the line. The checksum of a frame starts from `session`, that of a session command from
 * WB_NO_SESSION. */
enum wb_frame_result wb_frame_add(struct wb_frame *frame, uint8_t byte, uint16_t session);

#endif
