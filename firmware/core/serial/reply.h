/* Writes one frame to the host: a letter, its numbers, and the seal. */
#ifndef WB_REPLY_H
#define WB_REPLY_H

#include <stdbool.h>
#include <stdint.h>

/* The longest reply: a status with every number at its longest, with its newline. */
#define WB_REPLY_MAX 76

/* A frame that is being sent. */
struct wb_reply {
    void *board;
    uint16_t crc; /* CRC of what was sent so far */
    bool first;   /* flag: no number yet, so no comma */
};

/* There must be room to send WB_REPLY_MAX bytes. `session` is the id that seals the frame. */
struct wb_reply wb_reply_begin(void *board, char letter, uint16_t session);
void wb_reply_unsigned(struct wb_reply *reply, uint32_t value);
void wb_reply_signed(struct wb_reply *reply, int32_t value);
void wb_reply_end(struct wb_reply *reply);

#endif
