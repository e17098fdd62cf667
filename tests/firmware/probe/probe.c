/*
 * A small program that uses what the firmware uses, one command a letter, so that the bench can be tested alone:
 * serial line with interrupts, step pulses by timer 1, a servo by timer 2, sleep, watchdog, EEPROM, MCUSR.
 */
#include <avr/eeprom.h>
#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/sleep.h>
#include <avr/wdt.h>
#include <util/crc16.h>
#include <util/delay.h>

enum { RING = 64, STEPS = 100, STEP_PINS = 1 << PD2 | 1 << PD3 | 1 << PD4, PULSE_START = 64 /* ticks of 4 us */ };

static uint8_t reset_cause __attribute__((section(".noinit")));
static uint8_t boots __attribute__((section(".noinit")));
static uint8_t keep_flags __attribute__((section(".noinit"))); /* 0x5A: leave MCUSR as it is, WDRF apart */

static volatile uint8_t in[RING], in_head, in_tail, out[RING], out_head, out_tail, line_errors;
static volatile uint8_t steps_left, overflows;
static volatile uint16_t pulse_ticks = 375; /* of 4 us */

void first(void) __attribute__((naked, used, section(".init3")));
void first(void)
{
	reset_cause = MCUSR;
	MCUSR = keep_flags == 0x5A ? MCUSR & ~(1 << WDRF) : 0;
	wdt_disable();
}

ISR(USART_RX_vect)
{
	line_errors |= UCSR0A & (1 << FE0 | 1 << DOR0);
	in[in_head] = UDR0;
	in_head = (in_head + 1) % RING;
}

ISR(USART_UDRE_vect)
{
	UDR0 = out[out_tail];
	out_tail = (out_tail + 1) % RING;
	if (out_tail == out_head)
		UCSR0B &= ~(1 << UDRIE0);
}

ISR(TIMER1_COMPA_vect)
{
	PORTD |= STEP_PINS;
	_delay_us(2);
	PORTD &= ~STEP_PINS;
	if (!--steps_left)
		TCCR1B = 0;
}

/* A pulse of `pulse_ticks` every 20 overflows: one match sets the pin, a later one clears it. */
ISR(TIMER2_OVF_vect)
{
	uint16_t end = PULSE_START + pulse_ticks;
	if (++overflows == 20)
		overflows = 0;
	if (overflows == 0) {
		OCR2A = PULSE_START;
		TCCR2A = 1 << COM2A1 | 1 << COM2A0;
	} else if (overflows == end >> 8) {
		OCR2A = end;
		TCCR2A = 1 << COM2A1;
	}
}

static void put(uint8_t byte)
{
	uint8_t next = (out_head + 1) % RING;
	while (next == out_tail)
		;
	out[out_head] = byte;
	out_head = next;
	UCSR0B |= 1 << UDRIE0;
}

static void put_hex(uint8_t byte)
{
	static const char digits[] = "0123456789ABCDEF";
	put(digits[byte >> 4]);
	put(digits[byte & 15]);
}

static uint8_t get(void)
{
	cli();
	while (in_tail == in_head) {
		sleep_enable();
		sei();
		sleep_cpu();
		sleep_disable();
		wdt_reset();
		cli();
	}
	uint8_t byte = in[in_tail];
	in_tail = (in_tail + 1) % RING;
	sei();
	return byte;
}

static void start_steps(uint8_t forward)
{
	PORTD = forward ? 1 << PD5 : 0;
	steps_left = STEPS;
	TCNT1 = 0;
	OCR1A = 999; /* every 8000 cycles */
	TIMSK1 = 1 << OCIE1A;
	TCCR1B = 1 << WGM12 | 1 << CS11;
}

static uint16_t crc_of_eeprom(void)
{
	uint16_t crc = 0xFFFF;
	for (uint16_t at = 0; at < 64; at++)
		crc = _crc_ccitt_update(crc, eeprom_read_byte((uint8_t *)at));
	return crc;
}

/* The compare output turns over at each match, or is let go of. */
static void toggle(void)
{
	TIMSK2 = 0;
	OCR2A = 100;
	TCCR2A ^= TCCR2A & 1 << COM2A1 ? 1 << COM2A1 | 1 << COM2A0 : 1 << COM2A0;
}

static void send_blindly(void)
{
	for (uint8_t i = 0; i < 5; i++)
		UDR0 = '0' + i;
}

static void obey(uint8_t letter)
{
	uint16_t value;
	switch (letter) {
	case 'a': start_steps(1); break;
	case 'b': start_steps(0); break;
	case 'c': value = crc_of_eeprom(); put_hex(value >> 8); put_hex(value); break;
	case 'e': put_hex(line_errors); break;
	case 'h': cli(); for (;;) ;
	case 'i': put_hex(PINB); break;
	case 'j': ((void (*)(void))0x3000)(); break; /* erased flash */
	case 'k': cli(); _delay_us(10 * 85); sei(); break; /* ten bytes pass */
	case 'o': PORTB ^= 1 << PB0; break;
	case 'p': put('p'); break;
	case 'r': value = get(); put_hex(eeprom_read_byte((uint8_t *)value)); break;
	case 't': toggle(); break;
	case 'u': pulse_ticks = 250; break;
	case 'v': pulse_ticks = 500; break;
	case 'w': value = get(); eeprom_write_byte((uint8_t *)value, get()); break;
	case 'y': send_blindly(); break;
	case 'z': cli(); sleep_enable(); sleep_cpu(); break;
	default: put(letter);
	}
}

int main(void)
{
	DDRD = STEP_PINS | 1 << PD5 | 1 << PD6 | 1 << PD7;
	DDRB = 1 << PB0 | 1 << PB3;
	PORTB = 1 << PB1; /* pull-up of a switch */
	PORTC = 1 << PC0;
	DDRC = 1 << PC0;
	UCSR0A = 1 << U2X0;
	UBRR0 = 16;
	UCSR0B = 1 << RXEN0 | 1 << TXEN0 | 1 << RXCIE0;
	TCCR2A = 1 << COM2A1;
	TIMSK2 = 1 << TOIE2;
	TCCR2B = 1 << CS22;
	set_sleep_mode(SLEEP_MODE_IDLE);
	wdt_enable(WDTO_1S);
	sei();
	boots++;
	put('B');
	put_hex(reset_cause);
	put_hex(boots);
	for (;;)
		obey(get());
}
