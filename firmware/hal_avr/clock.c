/* Timer 2 makes the system tick and the pulse of the servo. It counts 4 us and overflows every 256 counts.
 *
 * A servo frame is 20 ticks, 20.48 ms. The pulse begins in the first tick and ends in a later one, each time by a match
 * with OCR2A, which the overflow before has set. Its begin is chosen so that its end is not close to an overflow. */
#include <avr/interrupt.h>

#include "board.h"
#include "pin.h"

#define FRAME_TICKS 20
#define COUNT_US 4
/* Counts in which a match may lie: after an overflow its interrupt may be late, whatever else runs. */
#define MIN_COUNT 32
#define MAX_COUNT 250
#define BEGIN 128
#define BEGIN_LATER 192

/* The edges of a pulse. It begins in tick 0 and ends in a later one; there is none while end_tick is 0. */
struct pulse {
    uint8_t begin;    /* 4 us from the start of its tick */
    uint8_t end;      /* 4 us from the start of its tick */
    uint8_t end_tick; /* 1.024 ms: tick of the frame */
};

/* The pulse of the next frame. Copied when the frame begins, so that no pulse is made of two widths. */
static struct pulse wanted;

void wb_clock_begin(void)
{
    wb_pin_output(WB_PIN_PEG);
    TCCR2A = 0;
    TCCR2B = (uint8_t)(1u << CS22); /* 16 MHz / 64 */
    TIMSK2 = (uint8_t)(1u << TOIE2);
}

/* Locked by the core: the overflow reads what this writes. */
void hal_peg(void *board, uint16_t width)
{
    (void)board;
    uint16_t counts = (uint16_t)(width / COUNT_US);
    uint8_t begin = BEGIN;
    uint8_t last = (uint8_t)(BEGIN + counts);
    if (last < MIN_COUNT || last > MAX_COUNT) {
        begin = BEGIN_LATER;
    }
    uint16_t end = (uint16_t)(begin + counts);
    wanted = (struct pulse){.begin = begin, .end = (uint8_t)end, .end_tick = (uint8_t)(end >> 8)};
}

#ifdef WB_PEG_AT_OC2A

/* The timer drives the pin itself, exact to the cycle. */
static void match(uint8_t count, bool high)
{
    OCR2A = count;
    TCCR2A = (uint8_t)(high ? 1u << COM2A1 | 1u << COM2A0 : 1u << COM2A1);
}

#else

static bool rises;

/* An interrupt drives the pin: it may wait for others. */
static void match(uint8_t count, bool high)
{
    OCR2A = count;
    rises = high;
    TIFR2 = (uint8_t)(1u << OCF2A);
    TIMSK2 = (uint8_t)(1u << TOIE2 | 1u << OCIE2A);
}

ISR(TIMER2_COMPA_vect)
{
    TIMSK2 = (uint8_t)(1u << TOIE2);
    if (rises) {
        wb_pin_high(WB_PIN_PEG);
    } else {
        wb_pin_low(WB_PIN_PEG);
    }
}

#endif

ISR(TIMER2_OVF_vect)
{
    static uint8_t tick;
    static struct pulse pulse;
    wb_on_tick(&wb_controller);
    wb_stalled_ticks++;
    if (++tick == FRAME_TICKS) {
        tick = 0;
        pulse = wanted;
        if (pulse.end_tick) {
            match(pulse.begin, true);
        }
    } else if (tick == pulse.end_tick) {
        match(pulse.end, false);
    }
}
