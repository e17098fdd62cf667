/* Lines from the host: bytes in, sealed payloads out; and replies to it. */
#ifndef WB_FRAME_H
#define WB_FRAME_H

#include <stdbool.h>
#include <stdint.h>

/* The longest line is a move with every number at its longest, 53 bytes; nothing longer can be valid. */
#define WB_LINE_MOST 60
/* The longest reply, a status with every number at its longest, with its newline. */
#define WB_REPLY_MOST 76
/* Stop at once: not printable, so never part of a line, and three bits from every byte of one. */
#define WB_STOP_BYTE 0x80
/* Seals what belongs to no session. */
#define WB_NO_SESSION 0xFFFFu

enum wb_fed {
    WB_FED_MORE,    /* the line goes on, or was empty */
    WB_FED_FRAME,   /* a whole frame with a good checksum: `text` holds its payload, ended by 0 */
    WB_FED_DAMAGED  /* a line that is none */
};

struct wb_frame {
    char text[WB_LINE_MOST + 1];
    uint8_t length;
    bool poisoned;
};

/* Takes a byte. A frame's seal starts from `session`, that of a session command from WB_NO_SESSION. */
enum wb_fed wb_frame_feed(struct wb_frame *frame, uint8_t byte, uint16_t session);

/* A reply that is being sent: its checksum so far. */
struct wb_reply {
    void *board;
    uint16_t crc;
    bool first; /* no comma yet */
};

struct wb_reply wb_reply_begin(void *board, char letter, uint16_t session);
void wb_reply_unsigned(struct wb_reply *reply, uint32_t value);
void wb_reply_signed(struct wb_reply *reply, int32_t value);
void wb_reply_end(struct wb_reply *reply);

#endif
