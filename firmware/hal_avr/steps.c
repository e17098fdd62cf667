/* Timer 1 makes the step interrupt. It counts 0.5 us and clears on a match with OCR1A. */
#include <avr/interrupt.h>

#include "board.h"

/* Counts of 0.5 us: margin for the timer, which must not have passed the end of an interval that is only just set. */
#define LATE_COUNTS 4

void wb_steps_begin(void)
{
    TCCR1A = 0;
    TCCR1B = (uint8_t)(1u << WGM12); /* clear on match; no clock yet */
}

void hal_timer_start(void *board, uint16_t interval)
{
    (void)board;
    TCNT1 = 0;
    OCR1A = (uint16_t)(interval - 1);
    TIFR1 = (uint8_t)(1u << OCF1A);
    TIMSK1 = (uint8_t)(1u << OCIE1A);
    TCCR1B = (uint8_t)(1u << WGM12 | 1u << CS11); /* 16 MHz / 8 */
}

bool hal_timer_next(void *board, uint16_t interval)
{
    (void)board;
    OCR1A = (uint16_t)(interval - 1);
    return TCNT1 + LATE_COUNTS < interval;
}

void hal_timer_stop(void *board)
{
    (void)board;
    TIMSK1 = 0;
    TCCR1B = (uint8_t)(1u << WGM12);
    TIFR1 = (uint8_t)(1u << OCF1A);
}

/* The pulse comes first. The division that finds the interval after the next one is long: the next step waits for it,
 * but bytes from the host and the servo do not. */
ISR(TIMER1_COMPA_vect)
{
    if (wb_on_step(&wb_controller)) {
        TIMSK1 = 0;
        sei();
        wb_on_step_rest(&wb_controller);
        cli();
        /* Not after a STOP, nor when a hold has ended the move. */
        if (wb_stepping(&wb_controller)) {
            TIMSK1 = (uint8_t)(1u << OCIE1A);
        }
    }
}
