/* Turns an input into what a host, a person and the world do to the controller.
 *
 * An input is text with one event a line; other lines are ignored:
 *   M 100 -20 30   a command with its numbers, sealed in the session; lines (M, H, K) get the next number
 *   =M7,1,1,1      any payload, sealed
 *   <M1,1,1,1*0000 bytes as they are, and a newline
 *   ?abc           bytes with a framing error each
 *   !              STOP
 *   t 500          time passes, ms
 *   w 1            the switch reads low (0), high (1), or as the bend axis is (2)
 *   r 3            a reset with this cause
 *   i 2            inputs are open: 1 hold, 2 emergency stop, 3 both, 0 none
 *   e 5 255        a byte of the EEPROM changes: address, value
 * Numbers are taken modulo 2^32. */
#include "invariants.h"

#include <stdio.h>
#include <string.h>

#include "../core/common/crc.h"

#define SESSION 7
/* An input ends after this time of the machine, in cycles. */
#define MAX_CYCLES (20ull * WB_HOST_HZ)
#define PAYLOAD_MAX 80

/* What is left of a line. */
struct text {
    const uint8_t *at;
    const uint8_t *end;
};

/* Reads the next number of a line; 0 when there is none. */
static int32_t number(struct text *text)
{
    uint32_t value = 0;
    bool negative = false;
    while (text->at < text->end && *text->at != '-' && (*text->at < '0' || *text->at > '9')) {
        text->at++;
    }
    if (text->at < text->end && *text->at == '-') {
        negative = true;
        text->at++;
    }
    for (; text->at < text->end && *text->at >= '0' && *text->at <= '9'; text->at++) {
        value = value * 10 + (uint32_t)(*text->at - '0');
    }
    return (int32_t)(negative ? 0u - value : value);
}

static void byte(struct world *world, uint8_t value, bool damaged)
{
    world_run(world, world_now(world) + WB_HOST_BYTE_CYCLES);
    world_receive(world, value, damaged);
}

static void say(struct world *world, const char *payload, size_t length)
{
    uint16_t crc = *payload == WB_COMMAND_SESSION ? WB_NO_SESSION : world_session(world);
    char seal[8];
    for (size_t i = 0; i < length; i++) {
        crc = wb_crc16(crc, (uint8_t)payload[i]);
        byte(world, (uint8_t)payload[i], false);
    }
    snprintf(seal, sizeof seal, "*%04X\n", crc);
    for (size_t i = 0; seal[i]; i++) {
        byte(world, (uint8_t)seal[i], false);
    }
}

static void command(struct world *world, char letter, struct text *text)
{
    char payload[PAYLOAD_MAX];
    uint32_t n = world_next(world);
    int32_t a = number(text), b = number(text), c = number(text), d = number(text);
    int length;
    switch (letter) {
    case WB_COMMAND_MOVE:
        length = snprintf(payload, sizeof payload, d ? "M%u,%d,%d,%d,%d" : "M%u,%d,%d,%d", n, a, b, c, d);
        break;
    case WB_COMMAND_DRY:
        length = snprintf(payload, sizeof payload, "Y%u,%d,%d,%d", n, a, b, c);
        break;
    case WB_COMMAND_HOME:
        length = snprintf(payload, sizeof payload, "H%u", n);
        break;
    case WB_COMMAND_PEG:
        length = snprintf(payload, sizeof payload, "K%u,%d", n, a);
        break;
    case WB_COMMAND_WRITE_SETTING:
        length = snprintf(payload, sizeof payload, "W%d,%d", a, b);
        break;
    case WB_COMMAND_SESSION:
    case WB_COMMAND_SPEED:
    case WB_COMMAND_HEAD:
    case WB_COMMAND_READ_SETTING:
        length = snprintf(payload, sizeof payload, "%c%d", letter, a);
        break;
    default:
        length = snprintf(payload, sizeof payload, "%c", letter);
        break;
    }
    say(world, payload, (size_t)length);
}

static void line(struct world *world, struct text text)
{
    if (text.at == text.end) {
        return;
    }
    char letter = (char)*text.at++;
    size_t left = (size_t)(text.end - text.at);
    char payload[PAYLOAD_MAX] = {0};
    switch (letter) {
    case '=':
        memcpy(payload, text.at, left < PAYLOAD_MAX ? left : PAYLOAD_MAX);
        say(world, payload, left < PAYLOAD_MAX ? left : PAYLOAD_MAX);
        break;
    case '<':
    case '?':
        for (; text.at < text.end; text.at++) {
            byte(world, *text.at, letter == '?');
        }
        byte(world, '\n', false);
        break;
    case '!':
        byte(world, WB_STOP_BYTE, false);
        break;
    case 't':
        world_run(world, world_now(world) + (uint64_t)(number(&text) & 0xFFF) * (WB_HOST_HZ / 1000));
        break;
    case 'w':
        world->switch_mode = (uint8_t)(number(&text) & 3);
        world_look_at_switch(world);
        break;
    case 'r':
        world_reset(world, (uint8_t)(number(&text) & 3));
        break;
    case 'i':
        wb_host_inputs(world->host, (uint8_t)(number(&text) & 3));
        break;
    case 'e': {
        size_t count;
        uint8_t *stored = wb_host_stored(world->host, &count);
        int32_t address = number(&text) & 1023;
        stored[address] = (uint8_t)number(&text);
        break;
    }
    default:
        if (letter >= 'A' && letter <= 'Z') {
            command(world, letter, &text);
        }
        break;
    }
    world_check(world);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct world world;
    world_begin(&world, SESSION);
    const uint8_t *end = data + size;
    while (data < end && world_now(&world) < MAX_CYCLES) {
        const uint8_t *newline = memchr(data, '\n', (size_t)(end - data));
        struct text text = {data, newline ? newline : end};
        line(&world, text);
        data = newline ? newline + 1 : end;
    }
    world_end(&world);
    return 0;
}
