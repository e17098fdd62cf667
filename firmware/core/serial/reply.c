#include "serial/reply.h"

#include "common/compiler.h"
#include "common/crc.h"
#include "hal.h"

static void put(struct wb_reply *reply, char letter)
{
    reply->crc = wb_crc16(reply->crc, (uint8_t)letter);
    hal_send(reply->board, (uint8_t)letter);
}

struct wb_reply wb_reply_begin(void *board, char letter, uint16_t session)
{
    struct wb_reply reply = {.board = board, .crc = session, .first = true};
    put(&reply, letter);
    return reply;
}

static void number(struct wb_reply *reply, uint32_t value, bool negative)
{
    char digits[10];
    uint8_t count = 0;
    if (!reply->first) {
        put(reply, ',');
    }
    reply->first = false;
    if (negative) {
        put(reply, '-');
    }
    do {
        digits[count++] = (char)('0' + value % 10);
        value /= 10;
    } while (value > 0);
    while (count > 0) {
        put(reply, digits[--count]);
    }
}

void wb_reply_unsigned(struct wb_reply *reply, uint32_t value)
{
    number(reply, value, false);
}

void wb_reply_signed(struct wb_reply *reply, int32_t value)
{
    number(reply, value < 0 ? 0u - (uint32_t)value : (uint32_t)value, value < 0);
}

void wb_reply_end(struct wb_reply *reply)
{
    static const WB_FLASH char HEX[16] = {'0', '1', '2', '3', '4', '5', '6', '7',
                                          '8', '9', 'A', 'B', 'C', 'D', 'E', 'F'};
    uint16_t crc = reply->crc;
    hal_send(reply->board, '*');
    for (uint8_t i = 0; i < 4; i++) {
        hal_send(reply->board, (uint8_t)HEX[crc >> 12]);
        crc = (uint16_t)(crc << 4);
    }
    hal_send(reply->board, '\n');
}
