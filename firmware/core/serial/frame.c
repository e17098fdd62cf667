#include "serial/frame.h"

#include "common/codes.h"
#include "common/crc.h"

/* `*HHHH` */
#define SEAL_BYTES 5

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

/* Checks the seal and terminates the payload. */
static bool sealed(struct wb_frame *frame, uint16_t session)
{
    if (frame->invalid || frame->length <= SEAL_BYTES) {
        return false;
    }
    uint8_t payload = (uint8_t)(frame->length - SEAL_BYTES);
    if (frame->text[payload] != '*') {
        return false;
    }
    uint16_t expected = 0;
    for (uint8_t i = 1; i < SEAL_BYTES; i++) {
        uint8_t digit;
        if (!hex(frame->text[payload + i], &digit)) {
            return false;
        }
        expected = (uint16_t)((expected << 4) | digit);
    }
    uint16_t crc = frame->text[0] == WB_COMMAND_SESSION ? WB_NO_SESSION : session;
    for (uint8_t i = 0; i < payload; i++) {
        crc = wb_crc16(crc, (uint8_t)frame->text[i]);
    }
    frame->text[payload] = 0;
    return crc == expected;
}

enum wb_frame_result wb_frame_add(struct wb_frame *frame, uint8_t byte, uint16_t session)
{
    if (byte != '\n') {
        if (byte < '!' || byte > '~' || frame->length == WB_LINE_MAX) {
            frame->invalid = true;
        } else {
            frame->text[frame->length++] = (char)byte;
        }
        return WB_FRAME_PARTIAL;
    }
    enum wb_frame_result result = WB_FRAME_PARTIAL;
    if (frame->length > 0 || frame->invalid) {
        result = sealed(frame, session) ? WB_FRAME_VALID : WB_FRAME_INVALID;
    }
    frame->length = 0;
    frame->invalid = false;
    return result;
}
