/* A controller on a computer: the same core with a clock that only moves when it is told to.
 *
 * Time is counted in cycles of 16 MHz from the power on, like that of the board. */
#ifndef WB_HOST_H
#define WB_HOST_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define WB_HOST_HZ 16000000u
/* Ten bits at 115200 baud, as the board's divider makes them (U2X, 16: 117647 baud). */
#define WB_HOST_BYTE_CYCLES 1360u

enum wb_host_kind {
    WB_HOST_PULSE, /* `value`: axis, `on`: direction as the motor sees it */
    WB_HOST_PEG,   /* `value`: servo pulse width, us */
    WB_HOST_SENT,  /* `value`: a byte to the host */
    WB_HOST_MOTORS /* the drivers were turned on or off */
};

struct wb_host_event {
    uint64_t at; /* cycles */
    uint16_t value;
    uint8_t kind;
    uint8_t on;
};

struct wb_host;

/* A controller with empty memory, powered off. Null when there is no memory for it. */
struct wb_host *wb_host_new(void);
void wb_host_free(struct wb_host *host);

/* Power comes, or a reset: everything but the stored bytes is forgotten. `cause` as in codes.h. */
void wb_host_reset(struct wb_host *host, uint8_t cause);
/* Time begins at zero again, with the power off until the next reset. What is stored stays. */
void wb_host_restart_clock(struct wb_host *host);
/* A byte from the serial line, now. */
void wb_host_receive(struct wb_host *host, uint8_t byte, bool damaged);
/* Several bytes now, before the main loop looks at any of them: it was busy. */
void wb_host_receive_all(struct wb_host *host, const uint8_t *bytes, size_t count);
/* The level of the switch from now on. */
void wb_host_switch(struct wb_host *host, bool high);
/* The contacts of these inputs are open from now on, those of the others closed. */
void wb_host_inputs(struct wb_host *host, uint8_t open);
/* Lets time pass until `until`, or until events wait; gives the time. */
uint64_t wb_host_run(struct wb_host *host, uint64_t until /* cycles */);
/* The next event, if one waits. */
bool wb_host_next(struct wb_host *host, struct wb_host_event *event);
/* Power fails when so many more bytes are stored: the others are lost, until the next reset. */
void wb_host_fail_after(struct wb_host *host, uint32_t bytes);
/* What is stored: bytes that outlive power, as many as there are. */
uint8_t *wb_host_stored(struct wb_host *host, size_t *count);

#endif
