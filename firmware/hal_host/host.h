/* A controller on a computer: the same core with a virtual clock.
 *
 * Time is counted in cycles of 16 MHz since power-on, as on the board. */
#ifndef WB_HOST_H
#define WB_HOST_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define WB_HOST_HZ 16000000u
/* Cycles of a byte: ten bits at 117647 baud, which the board makes of 115200. */
#define WB_HOST_BYTE_CYCLES 1360u

enum wb_host_kind {
    WB_HOST_PULSE, /* `value`: axis, `on`: direction as the motor sees it */
    WB_HOST_PEG,   /* `value`: pulse width of the servo, us */
    WB_HOST_SENT,  /* `value`: a byte to the host */
    WB_HOST_MOTORS /* the drivers were turned on or off */
};

struct wb_host_event {
    uint64_t at; /* cycles */
    uint16_t value; /* number: see enum wb_host_kind */
    uint8_t kind;   /* enum wb_host_kind */
    uint8_t on;     /* flag: see enum wb_host_kind */
};

struct wb_host;

/* A controller without power, with an empty EEPROM. Null when memory has run out. */
struct wb_host *wb_host_new(void);
void wb_host_free(struct wb_host *host);

/* Power-on or a reset: all but the EEPROM is lost. `cause` is one of WB_RESET_... */
void wb_host_reset(struct wb_host *host, uint8_t cause);
/* Time starts at zero again, without power until the next reset. The EEPROM stays. */
void wb_host_restart_clock(struct wb_host *host);
/* A byte from the serial line, now. */
void wb_host_receive(struct wb_host *host, uint8_t byte, bool damaged);
/* Several bytes at once, as if the main loop had been busy. */
void wb_host_receive_all(struct wb_host *host, const uint8_t *bytes, size_t count);
/* The main loop is busy until then, as with a write of the EEPROM: interrupts alone run. */
void wb_host_busy(struct wb_host *host, uint64_t until /* cycles */);
/* Level of the switch's pin from now on. */
void wb_host_switch(struct wb_host *host, bool high);
/* These inputs are open from now on, the others closed. */
void wb_host_inputs(struct wb_host *host, uint8_t open);
/* Runs until `until`, or until events wait. Gives the time, in cycles. */
uint64_t wb_host_run(struct wb_host *host, uint64_t until /* cycles */);
/* Takes the next event; false when none waits. */
bool wb_host_next(struct wb_host *host, struct wb_host_event *event);
/* Power fails after so many more stored bytes: later ones are lost, until the next reset. */
void wb_host_fail_after(struct wb_host *host, uint32_t bytes);
/* The EEPROM, and its size in bytes. */
uint8_t *wb_host_stored(struct wb_host *host, size_t *count);

#endif
