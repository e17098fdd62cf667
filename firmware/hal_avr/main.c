/* Start, main loop, sleep, watchdog and stored bytes. */
#include <avr/eeprom.h>
#include <avr/interrupt.h>
#include <avr/sleep.h>
#include <avr/wdt.h>

#include "board.h"

struct wb_controller wb_controller;

/* What reset the controller, as it stood before anything else ran. */
static uint8_t cause __attribute__((section(".noinit")));

/* The Uno's boot loader clears the cause before this program sees it. What the last run has left in the RAM tells
 * a hang then: RUNS, and about as many ticks as the watchdog waits. A hang with interrupts off, in which no tick
 * comes, looks like the reset pin. */
#define RUNS 0x5AC3961Eu /* long enough not to be what a RAM without power comes up with */
#define HUNG_TICKS_LEAST 700u
#define HUNG_TICKS_MOST 1400u
static uint32_t runs __attribute__((section(".noinit")));
volatile uint16_t wb_silent_ticks __attribute__((section(".noinit")));

/* What the status register was before the lock. */
static uint8_t unlocked;

/* First thing: after a reset by the watchdog it goes on with its shortest time. */
void wb_before_all(void) __attribute__((naked, used, section(".init3")));
void wb_before_all(void)
{
    cause = MCUSR;
    MCUSR = 0;
    wdt_disable();
}

static uint8_t reset_code(void)
{
    bool hung = runs == RUNS && wb_silent_ticks >= HUNG_TICKS_LEAST && wb_silent_ticks <= HUNG_TICKS_MOST;
    if ((cause & 1u << WDRF) || (cause == 0 && hung)) {
        return WB_RESET_WATCHDOG;
    }
    /* A supply that rises slowly sets both. */
    if (cause & 1u << PORF) {
        return WB_RESET_POWER_ON;
    }
    return cause & 1u << BORF ? WB_RESET_BROWN_OUT : WB_RESET_EXTERNAL;
}

void hal_lock(void *board)
{
    (void)board;
    unlocked = SREG;
    cli();
}

/* Before they are let in for the first time, interrupts stay out. */
void hal_unlock(void *board)
{
    (void)board;
    SREG = unlocked;
}

uint8_t hal_stored(void *board, uint16_t address)
{
    (void)board;
    return eeprom_read_byte((const uint8_t *)address);
}

void hal_store(void *board, uint16_t address, uint8_t byte)
{
    (void)board;
    /* 3.4 ms a byte that changes: all settings, stored twice, take three quarters of a second. */
    wdt_reset();
    wb_silent_ticks = 0;
    eeprom_update_byte((uint8_t *)address, byte);
}

int main(void)
{
    wdt_enable(WDTO_1S);
    wb_motors_begin();
    wb_steps_begin();
    wb_clock_begin();
    wb_serial_begin();
    SMCR = 1u << SE; /* idle: timers and the serial line go on */
    wb_start(&wb_controller, 0, reset_code());
    runs = RUNS;
    sei();
    for (;;) {
        wdt_reset();
        wb_silent_ticks = 0;
        if (!wb_poll(&wb_controller)) {
            /* An interrupt that comes in between is looked at after the next tick, a millisecond later. */
            sleep_cpu();
        }
    }
}
