/* Start, main loop, sleep, watchdog and EEPROM. */
#include <avr/eeprom.h>
#include <avr/interrupt.h>
#include <avr/sleep.h>
#include <avr/wdt.h>

#include "board.h"

struct wb_controller wb_controller;

/* MCUSR as it was at the reset: the cause, in bits. */
static uint8_t cause __attribute__((section(".noinit")));

/* The boot loader of the Uno clears the cause before this program sees it. Then a hang shows in what the last run has
 * left in the RAM: RUNNING, and about as many ticks as the watchdog waits. A hang with interrupts off has no ticks and
 * looks like the reset pin. */
#define RUNNING 0x5AC3961Eu /* long enough not to be there by chance after power-on */
#define MIN_HUNG_TICKS 700u
#define MAX_HUNG_TICKS 1400u
static uint32_t running __attribute__((section(".noinit")));
volatile uint16_t wb_stalled_ticks __attribute__((section(".noinit")));

/* SREG before the lock. */
static uint8_t unlocked_sreg;

/* Before anything else: after its reset the watchdog is still on, with its shortest time. */
void wb_before_all(void) __attribute__((naked, used, section(".init3")));
void wb_before_all(void)
{
    cause = MCUSR;
    MCUSR = 0;
    wdt_disable();
}

static uint8_t reset_code(void)
{
    bool hung = running == RUNNING && wb_stalled_ticks >= MIN_HUNG_TICKS && wb_stalled_ticks <= MAX_HUNG_TICKS;
    if ((cause & 1u << WDRF) || (cause == 0 && hung)) {
        return WB_RESET_WATCHDOG;
    }
    /* A supply that rises slowly sets this flag and that of a brown-out. */
    if (cause & 1u << PORF) {
        return WB_RESET_POWER_ON;
    }
    return cause & 1u << BORF ? WB_RESET_BROWN_OUT : WB_RESET_EXTERNAL;
}

void hal_lock(void *board)
{
    (void)board;
    unlocked_sreg = SREG;
    cli();
}

/* Restores the flag: during the start, interrupts stay off. */
void hal_unlock(void *board)
{
    (void)board;
    SREG = unlocked_sreg;
}

uint8_t hal_stored(void *board, uint16_t address)
{
    (void)board;
    return eeprom_read_byte((const uint8_t *)address);
}

void hal_store(void *board, uint16_t address, uint8_t byte)
{
    (void)board;
    /* A byte that changes takes 3.4 ms, all settings, stored twice, three quarters of a second. */
    wdt_reset();
    wb_stalled_ticks = 0;
    eeprom_update_byte((uint8_t *)address, byte);
}

int main(void)
{
    wdt_enable(WDTO_1S);
    wb_motors_begin();
    wb_steps_begin();
    wb_clock_begin();
    wb_serial_begin();
    SMCR = 1u << SE; /* idle mode: timers and the serial line run on */
    wb_start(&wb_controller, 0, reset_code());
    running = RUNNING;
    sei();
    for (;;) {
        wdt_reset();
        wb_stalled_ticks = 0;
        if (!wb_poll(&wb_controller)) {
            /* An interrupt that comes just before this is handled after the next tick, a millisecond later. */
            sleep_cpu();
        }
    }
}
