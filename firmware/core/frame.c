#include "frame.h"

#include "codes.h"
#include "crc.h"
#include "flash.h"
#include "hal.h"

/* `*HHHH` */
#define SEAL 5

static bool hex(char digit, uint8_t *value)
{
    if (digit >= '0' && digit <= '9') {
        *value = (uint8_t)(digit - '0');
        return true;
    }
    if (digit >= 'A' && digit <= 'F') {
        *value = (uint8_t)(digit - 'A' + 10);
        return true;
    }
    return false;
}

static bool sealed(struct wb_frame *frame, uint16_t session)
{
    if (frame->poisoned || frame->length <= SEAL) {
        return false;
    }
    uint8_t payload = (uint8_t)(frame->length - SEAL);
    if (frame->text[payload] != '*') {
        return false;
    }
    uint16_t told = 0;
    for (uint8_t i = 1; i < SEAL; i++) {
        uint8_t digit;
        if (!hex(frame->text[payload + i], &digit)) {
            return false;
        }
        told = (uint16_t)((told << 4) | digit);
    }
    uint16_t crc = frame->text[0] == WB_COMMAND_SESSION ? WB_NO_SESSION : session;
    for (uint8_t i = 0; i < payload; i++) {
        crc = wb_crc16(crc, (uint8_t)frame->text[i]);
    }
    frame->text[payload] = 0;
    return crc == told;
}

enum wb_fed wb_frame_feed(struct wb_frame *frame, uint8_t byte, uint16_t session)
{
    if (byte != '\n') {
        if (byte < '!' || byte > '~' || frame->length == WB_LINE_MOST) {
            frame->poisoned = true;
        } else {
            frame->text[frame->length++] = (char)byte;
        }
        return WB_FED_MORE;
    }
    enum wb_fed fed = WB_FED_MORE;
    if (frame->length > 0 || frame->poisoned) {
        fed = sealed(frame, session) ? WB_FED_FRAME : WB_FED_DAMAGED;
    }
    frame->length = 0;
    frame->poisoned = false;
    return fed;
}

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
