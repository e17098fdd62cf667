/* The serial line, byte by byte in time, and how long interrupts wait and run. */
#include "uno.h"

enum { DOR = 1 << 3, FIFO_MASK = 63, UART_HOLDS = 3 /* two characters and the shift register */ };

/* simavr's own input would show a byte before it is here, take 64 of them, and never report an overrun. */
static avr_cycle_count_t on_wire(struct avr_t *avr, avr_cycle_count_t when, void *param)
{
	struct uno *uno = param;
	avr_uart_t *uart = uno->uart;
	struct wire_byte *byte = (struct wire_byte *)uno->wire.items + uno->wire_next++;
	(void)when;
	if (((uart->input.write - uart->input.read) & FIFO_MASK) >= UART_HOLDS) {
		avr->data[REG_UCSR0A] |= DOR;
		uno->overruns++;
	} else {
		avr_raise_irq(&uart->io.irq[UART_IRQ_INPUT], byte->value);
		if (uart->input.write != uart->input.read) /* nothing comes in while the receiver is off */
			avr_raise_interrupt(avr, &uart->rxc);
	}
	if (uno->wire_next < uno->wire.count)
		return byte[1].cycle > avr->cycle ? byte[1].cycle : avr->cycle + 1;
	uno->wire.count = uno->wire_next = 0;
	return 0;
}

static void await_wire(struct uno *uno)
{
	if (uno->wire_next == uno->wire.count)
		return;
	uint64_t at = ((struct wire_byte *)uno->wire.items)[uno->wire_next].cycle, now = uno->avr->cycle;
	avr_cycle_timer_register(uno->avr, at > now ? at - now : 1, on_wire, uno);
}

/* `cycle` is the end of its stop bit; calls come in the order of time. */
void uno_receive(struct uno *uno, uint64_t cycle, uint16_t value)
{
	struct wire_byte *byte = append(&uno->wire);
	*byte = (struct wire_byte){ cycle, value };
	if (uno->wire.count - uno->wire_next == 1)
		await_wire(uno);
}

static void on_sent(struct avr_irq_t *irq, uint32_t value, void *param)
{
	struct uno *uno = param;
	avr_uart_t *uart = uno->uart;
	uint8_t *data = uno->avr->data;
	uint64_t now = uno->avr->cycle, from = uno->sending_until > now ? uno->sending_until : now;
	uint64_t ubrr = data[REG_UBRR0] | (data[REG_UBRR0 + 1] & 0x0F) << 8;
	(void)irq;
	/* Start, eight bits, stop. simavr counts a parity bit that is not there; it reads this after this call. */
	uart->cycles_per_byte = (ubrr + 1) * (avr_regbit_get(uno->avr, uart->u2x) ? 8 : 16) * 10;
	if (from - now > uart->cycles_per_byte) { /* one on the wire and one waiting: a third has no place */
		uno->lost_sending++;
		return;
	}
	uno->sending_until = from + uart->cycles_per_byte;
	struct wire_byte *byte = append(&uno->sent);
	*byte = (struct wire_byte){ uno->sending_until, value };
}

void wire_attach(struct uno *uno)
{
	uint32_t flags = 0; /* neither sleep when it is polled nor print */
	avr_ioctl(uno->avr, AVR_IOCTL_UART_SET_FLAGS('0'), &flags);
	avr_irq_register_notify(&uno->uart->io.irq[UART_IRQ_OUTPUT], on_sent, uno);
}

/* What was being sent is cut off; what is on the way in still arrives. avr_reset has wiped the timer. */
void wire_after_reset(struct uno *uno)
{
	struct wire_byte *sent = uno->sent.items;
	while (uno->sent.count && sent[uno->sent.count - 1].cycle > uno->avr->cycle)
		uno->sent.count--;
	uno->sending_until = 0;
	await_wire(uno);
}

static void on_pending(struct avr_irq_t *irq, uint32_t value, void *param)
{
	struct vector *vector = param;
	(void)irq;
	if (value && !vector->waiting)
		vector->wait_from = vector->avr->cycle;
	vector->waiting = value != 0;
}

static void on_running(struct avr_irq_t *irq, uint32_t value, void *param)
{
	struct vector *vector = param;
	struct vector_time *time = &vector->time;
	uint64_t now = vector->avr->cycle, run = now - vector->run_from, wait = now - vector->wait_from;
	(void)irq;
	if (value) {
		time->count++;
		vector->run_from = now;
		if (wait > time->worst_wait)
			time->worst_wait = wait;
	} else if (vector->running && run > time->worst_run) {
		time->worst_run = run;
	}
	vector->running = value != 0;
}

void vectors_attach(struct uno *uno)
{
	for (int v = 1; v < VECTORS; v++) {
		avr_irq_t *irq = avr_get_interrupt_irq(uno->avr, v);
		uno->vector[v].avr = uno->avr;
		if (!irq)
			continue;
		avr_irq_register_notify(irq + AVR_INT_IRQ_PENDING, on_pending, &uno->vector[v]);
		avr_irq_register_notify(irq + AVR_INT_IRQ_RUNNING, on_running, &uno->vector[v]);
	}
}

void vectors_after_reset(struct uno *uno)
{
	for (int v = 1; v < VECTORS; v++)
		uno->vector[v].running = uno->vector[v].waiting = 0;
}
