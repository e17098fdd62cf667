/* Timer 1 gives the step interrupt: it clears on a match with OCR1A and counts half microseconds. */
#include <avr/interrupt.h>

#include "board.h"

/* From the match until the new period is written, the timer must not have passed its end. */
#define LATE_TICKS 4

void wb_steps_begin(void)
{
    TCCR1A = 0;
    TCCR1B = (uint8_t)(1u << WGM12); /* clear on match; no clock yet */
}

void hal_timer_start(void *board, uint16_t ticks)
{
    (void)board;
    TCNT1 = 0;
    OCR1A = (uint16_t)(ticks - 1);
    TIFR1 = (uint8_t)(1u << OCF1A);
    TIMSK1 = (uint8_t)(1u << OCIE1A);
    TCCR1B = (uint8_t)(1u << WGM12 | 1u << CS11); /* 16 MHz / 8 */
}

bool hal_timer_next(void *board, uint16_t ticks)
{
    (void)board;
    OCR1A = (uint16_t)(ticks - 1);
    return TCNT1 + LATE_TICKS < ticks;
}

void hal_timer_stop(void *board)
{
    (void)board;
    TIMSK1 = 0;
    TCCR1B = (uint8_t)(1u << WGM12);
    TIFR1 = (uint8_t)(1u << OCF1A);
}

/* The pulse comes at once. The division that finds the interval after the next is long: bytes from the host
 * and the servo's pulse do not wait for it, the next step does. */
ISR(TIMER1_COMPA_vect)
{
    if (wb_on_step(&wb_controller)) {
        TIMSK1 = 0;
        sei();
        wb_on_step_rest(&wb_controller);
        cli();
        /* Unless a STOP came, or a hold has ended the move. */
        if (wb_controller.stepper.moving) {
            TIMSK1 = (uint8_t)(1u << OCIE1A);
        }
    }
}
