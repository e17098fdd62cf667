/* Timer 2 gives the system tick, and times the servo's pulse: it overflows every 256 counts of 4 us.
 *
 * A servo frame is 20 ticks, 20.48 ms. The pulse begins at a count of the first tick and ends so many ticks and
 * counts later, both by a match with OCR2A that the overflow before has set. Where it begins is chosen so that it
 * does not end close to an overflow. */
#include <avr/interrupt.h>

#include "board.h"
#include "pin.h"

#define FRAME_TICKS 20
#define COUNT_US 4
/* An overflow is dealt with within so many counts, whatever else goes on. */
#define LEAST_COUNT 32
#define MOST_COUNT 250
#define BEGIN 128
#define BEGIN_LATER 192

/* Counts of the edges; the pulse begins in tick 0 and ends in a later one. No pulse while end_tick is 0. */
struct pulse { uint8_t begin, end, end_tick; };

/* What a frame begins with, so that none is made of two widths. */
static struct pulse wanted;

void wb_clock_begin(void)
{
    wb_pin_output(WB_PIN_PEG);
    TCCR2A = 0;
    TCCR2B = (uint8_t)(1u << CS22); /* 16 MHz / 64 */
    TIMSK2 = (uint8_t)(1u << TOIE2);
}

/* Locked, as the core calls it: the overflow reads what this writes. */
void hal_peg(void *board, uint16_t width)
{
    (void)board;
    uint16_t counts = (uint16_t)(width / COUNT_US);
    uint8_t begin = BEGIN;
    uint8_t last = (uint8_t)(BEGIN + counts);
    if (last < LEAST_COUNT || last > MOST_COUNT) {
        begin = BEGIN_LATER;
    }
    uint16_t end = (uint16_t)(begin + counts);
    wanted = (struct pulse){.begin = begin, .end = (uint8_t)end, .end_tick = (uint8_t)(end >> 8)};
}

#ifdef WB_PEG_AT_OC2A

/* The timer itself drives its pin, to the cycle. */
static void match(uint8_t count, bool high)
{
    OCR2A = count;
    TCCR2A = (uint8_t)(high ? 1u << COM2A1 | 1u << COM2A0 : 1u << COM2A1);
}

#else

static bool rises;

/* The edge waits for other interrupts. */
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
    wb_silent_ticks++;
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
