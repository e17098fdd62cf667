/* The serial line: 115200 baud, eight bits, no parity, one stop bit. */
#include <avr/interrupt.h>

#include "board.h"

/* With U2X: 16 MHz / 8 / (16 + 1) = 117647 baud, 2.1 % fast, as on every Uno. */
#define DIVIDER 16
#define SEND_BYTES 128

static volatile uint8_t bytes[SEND_BYTES]; /* bytes to the host */
static volatile uint8_t in;                /* index */
static volatile uint8_t out;               /* index */

void wb_serial_begin(void)
{
    UBRR0 = DIVIDER;
    UCSR0A = (uint8_t)(1u << U2X0);
    UCSR0C = (uint8_t)(1u << UCSZ01 | 1u << UCSZ00);
    UCSR0B = (uint8_t)(1u << RXCIE0 | 1u << RXEN0 | 1u << TXEN0);
}

uint8_t hal_send_room(void *board)
{
    (void)board;
    return (uint8_t)(SEND_BYTES - 1 - (uint8_t)(in - out) % SEND_BYTES);
}

void hal_send(void *board, uint8_t byte)
{
    (void)board;
    bytes[in] = byte;
    in = (uint8_t)((in + 1) % SEND_BYTES);
    /* The interrupt changes UDRIE0 too. */
    cli();
    UCSR0B |= (uint8_t)(1u << UDRIE0);
    sei();
}

ISR(USART_RX_vect)
{
    /* The flags are of the byte that is read next, so they are read first. */
    bool damaged = (UCSR0A & (1u << FE0 | 1u << DOR0)) != 0;
    wb_on_byte(&wb_controller, UDR0, damaged);
}

ISR(USART_UDRE_vect)
{
    UDR0 = bytes[out];
    out = (uint8_t)((out + 1) % SEND_BYTES);
    if (in == out) {
        UCSR0B &= (uint8_t)~(1u << UDRIE0);
    }
}
