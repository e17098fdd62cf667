#include "host.h"

#include <stdlib.h>
#include <string.h>

#include "../core/entry.h"
#include "../core/hal.h"

#define NEVER UINT64_MAX
#define CYCLES_PER_COUNT (WB_HOST_HZ / WB_TIMER_HZ)
#define TICK_CYCLES ((uint64_t)WB_TICK_US * (WB_HOST_HZ / 1000000u))
/* Bytes of the board's EEPROM. */
#define STORED 1024
#define SEND_ROOM 128
/* Events: more than one interrupt makes. */
#define EVENTS 64

struct wb_host {
    struct wb_controller controller;
    uint64_t now;            /* cycles */
    uint64_t step_at;        /* cycles: the next step interrupt, or NEVER */
    uint64_t tick_at;        /* cycles: the next tick */
    uint64_t sent_at;        /* cycles: the end of the byte that is being sent, or NEVER */
    uint64_t busy_until;     /* cycles: the main loop does nothing before */
    bool switch_high;        /* flag: level of the switch's pin */
    bool motors;             /* flag: the drivers are on */
    uint8_t inputs_open;     /* bits: WB_INPUT_HOLD, WB_INPUT_EMERGENCY */
    bool forward[WB_AXES];   /* flag: level of the direction pin */
    uint8_t send[SEND_ROOM]; /* bytes */
    uint8_t send_in;         /* index, counted on beyond the end */
    uint8_t send_out;        /* index, counted on beyond the end */
    struct wb_host_event event[EVENTS];
    uint8_t event_in;       /* index */
    uint8_t event_out;      /* index */
    bool powered;           /* flag: reset since the clock was restarted */
    uint8_t stored[STORED]; /* bytes of the EEPROM */
    uint32_t stores_left;   /* bytes until the power fails */
};

static void note(struct wb_host *host, enum wb_host_kind kind, uint16_t value, bool on)
{
    host->event[host->event_in] =
        (struct wb_host_event){.at = host->now, .value = value, .kind = (uint8_t)kind, .on = on};
    host->event_in = (uint8_t)((host->event_in + 1) % EVENTS);
}

/* --- the board, as the core sees it */

void hal_lock(void *board)
{
    (void)board; /* interrupts come only between calls of the core */
}

void hal_unlock(void *board)
{
    (void)board;
}

void hal_direction(void *board, uint8_t axis, bool forward)
{
    ((struct wb_host *)board)->forward[axis] = forward;
}

void hal_pulse(void *board, uint8_t axis)
{
    struct wb_host *host = board;
    note(host, WB_HOST_PULSE, axis, host->forward[axis]);
}

bool hal_switch_high(void *board)
{
    return ((struct wb_host *)board)->switch_high;
}

void hal_motors_on(void *board)
{
    struct wb_host *host = board;
    if (!host->motors) {
        host->motors = true;
        note(host, WB_HOST_MOTORS, 1, true);
    }
}

void hal_motors_off(void *board)
{
    struct wb_host *host = board;
    if (host->motors) {
        host->motors = false;
        note(host, WB_HOST_MOTORS, 0, false);
    }
}

bool hal_input_open(void *board, uint8_t input)
{
    return (((struct wb_host *)board)->inputs_open & input) != 0;
}

void hal_timer_start(void *board, uint16_t interval)
{
    struct wb_host *host = board;
    host->step_at = host->now + (uint64_t)interval * CYCLES_PER_COUNT;
}

bool hal_timer_next(void *board, uint16_t interval)
{
    hal_timer_start(board, interval);
    return true;
}

void hal_timer_stop(void *board)
{
    ((struct wb_host *)board)->step_at = NEVER;
}

void hal_peg(void *board, uint16_t width)
{
    note(board, WB_HOST_PEG, width, true);
}

uint8_t hal_send_room(void *board)
{
    const struct wb_host *host = board;
    return (uint8_t)(SEND_ROOM - 1 - (uint8_t)(host->send_in - host->send_out) % SEND_ROOM);
}

void hal_send(void *board, uint8_t byte)
{
    struct wb_host *host = board;
    if (host->send_in == host->send_out && host->sent_at == NEVER) {
        host->sent_at = host->now + WB_HOST_BYTE_CYCLES;
    }
    host->send[host->send_in % SEND_ROOM] = byte;
    host->send_in++;
}

uint8_t hal_stored(void *board, uint16_t address)
{
    return ((struct wb_host *)board)->stored[address];
}

void hal_store(void *board, uint16_t address, uint8_t byte)
{
    struct wb_host *host = board;
    if (host->stored[address] != byte && host->stores_left > 0) {
        host->stores_left--;
        host->stored[address] = byte;
    }
}

/* --- the outside */

struct wb_host *wb_host_new(void)
{
    struct wb_host *host = calloc(1, sizeof *host);
    if (host) {
        memset(host->stored, 0xFF, sizeof host->stored);
        host->stores_left = UINT32_MAX;
    }
    return host;
}

void wb_host_free(struct wb_host *host)
{
    free(host);
}

static void poll(struct wb_host *host)
{
    while (host->now >= host->busy_until && wb_poll(&host->controller)) {
        /* as long as there is more to do at once */
    }
}

void wb_host_reset(struct wb_host *host, uint8_t cause)
{
    host->step_at = NEVER;
    host->sent_at = NEVER;
    host->tick_at = host->now + TICK_CYCLES;
    host->send_in = host->send_out = 0;
    host->motors = false;
    host->powered = true;
    host->stores_left = UINT32_MAX;
    host->busy_until = 0;
    wb_start(&host->controller, host, cause);
    poll(host);
}

void wb_host_restart_clock(struct wb_host *host)
{
    host->now = 0;
    host->powered = false;
    host->event_in = host->event_out = 0;
}

void wb_host_receive(struct wb_host *host, uint8_t byte, bool damaged)
{
    if (host->powered) {
        wb_on_byte(&host->controller, byte, damaged);
        poll(host);
    }
}

void wb_host_receive_all(struct wb_host *host, const uint8_t *bytes, size_t count)
{
    if (host->powered) {
        for (size_t i = 0; i < count; i++) {
            wb_on_byte(&host->controller, bytes[i], false);
        }
        poll(host);
    }
}

void wb_host_busy(struct wb_host *host, uint64_t until)
{
    host->busy_until = until;
}

void wb_host_switch(struct wb_host *host, bool high)
{
    host->switch_high = high;
}

void wb_host_inputs(struct wb_host *host, uint8_t open)
{
    host->inputs_open = open;
}

/* Runs the next interrupt; false when it comes after `until`. */
static bool interrupt(struct wb_host *host, uint64_t until)
{
    uint64_t at = host->tick_at;
    at = host->step_at < at ? host->step_at : at;
    at = host->sent_at < at ? host->sent_at : at;
    if (at > until) {
        return false;
    }
    host->now = at;
    if (at == host->step_at) {
        /* The core sets the timer again when there is a next pulse. */
        host->step_at = NEVER;
        if (wb_on_step(&host->controller)) {
            wb_on_step_rest(&host->controller);
        }
    } else if (at == host->sent_at) {
        note(host, WB_HOST_SENT, host->send[host->send_out % SEND_ROOM], true);
        host->send_out++;
        host->sent_at = host->send_in == host->send_out ? NEVER : at + WB_HOST_BYTE_CYCLES;
    } else {
        host->tick_at = at + TICK_CYCLES;
        wb_on_tick(&host->controller);
    }
    poll(host);
    return true;
}

uint64_t wb_host_run(struct wb_host *host, uint64_t until)
{
    while (host->powered && host->event_in == host->event_out && interrupt(host, until)) {
        /* until there is an event */
    }
    if (host->event_in == host->event_out && host->now < until) {
        host->now = until;
    }
    return host->now;
}

bool wb_host_next(struct wb_host *host, struct wb_host_event *event)
{
    if (host->event_in == host->event_out) {
        return false;
    }
    *event = host->event[host->event_out];
    host->event_out = (uint8_t)((host->event_out + 1) % EVENTS);
    return true;
}

void wb_host_fail_after(struct wb_host *host, uint32_t bytes)
{
    host->stores_left = bytes;
}

uint8_t *wb_host_stored(struct wb_host *host, size_t *count)
{
    *count = STORED;
    return host->stored;
}
