/* Output pins as a scope sees them, and inputs as a switch drives them. */
#include <avr_timer.h>

#include "uno.h"

enum { OC2A_BIT = 3 /* of port B */ };

static void show(struct uno *uno, int port)
{
	avr_t *avr = uno->avr;
	uint8_t level = avr->data[uno->port[port]->r_port];
	if (port == 0 && avr->data[REG_TCCR2A] >> 6)
		level = (level & ~(1 << OC2A_BIT)) | uno->oc2a << OC2A_BIT;
	level &= avr->data[uno->port[port]->r_ddr];
	for (uint8_t bit = 0; bit < 8; bit++) {
		if (!((level ^ uno->shown[port]) >> bit & 1))
			continue;
		struct pin_change *change = append(&uno->pins);
		*change = (struct pin_change){ avr->cycle, port, bit, level >> bit & 1 };
	}
	uno->shown[port] = level;
}

static int port_of(struct uno *uno, struct avr_irq_t *irq, int which)
{
	int port = 0;
	while (port < PORTS - 1 && irq != &uno->port[port]->io.irq[which])
		port++;
	return port;
}

static void on_port(struct avr_irq_t *irq, uint32_t value, void *param)
{
	(void)value; /* is stored already */
	show(param, port_of(param, irq, IOPORT_IRQ_REG_PORT));
}

/* simavr reports a direction before it stores it. */
static void on_direction(struct avr_irq_t *irq, uint32_t value, void *param)
{
	struct uno *uno = param;
	int port = port_of(uno, irq, IOPORT_IRQ_DIRECTION_ALL);
	uno->avr->data[uno->port[port]->r_ddr] = value;
	show(uno, port);
}

/* Where the timer does not make PWM, simavr moves the pin at each overflow and at each write of OCR2A as well,
   always against the sense of COM2A. On the chip a match alone moves it. */
static void on_oc2a(struct avr_irq_t *irq, uint32_t value, void *param)
{
	struct uno *uno = param;
	uint8_t *data = uno->avr->data;
	unsigned com = data[REG_TCCR2A] >> 6, pwm = data[REG_TCCR2A] & 1;
	(void)irq;
	if (com == 1)
		uno->oc2a ^= 1;
	else if (com && (pwm || (value & 1) == (com == 3)))
		uno->oc2a = value & 1;
	show(uno, 0);
}

static void on_tccr2a(struct avr_irq_t *irq, uint32_t value, void *param)
{
	(void)irq;
	(void)value;
	show(param, 0);
}

void pins_attach(struct uno *uno)
{
	avr_t *avr = uno->avr;
	for (int port = 0; port < PORTS; port++) {
		avr_irq_t *irq = uno->port[port]->io.irq;
		/* Filtered, the first write after a reset would be hidden when it is what was there before. */
		irq[IOPORT_IRQ_REG_PORT].flags &= ~IRQ_FLAG_FILTERED;
		irq[IOPORT_IRQ_DIRECTION_ALL].flags &= ~IRQ_FLAG_FILTERED;
		avr_irq_register_notify(&irq[IOPORT_IRQ_REG_PORT], on_port, uno);
		avr_irq_register_notify(&irq[IOPORT_IRQ_DIRECTION_ALL], on_direction, uno);
	}
	avr_irq_register_notify(avr_io_getirq(avr, AVR_IOCTL_TIMER_GETIRQ('2'), TIMER_IRQ_OUT_COMP), on_oc2a, uno);
	avr_irq_register_notify(avr_iomem_getirq(avr, REG_TCCR2A, "tccr2a", AVR_IOMEM_IRQ_ALL), on_tccr2a, uno);
}

/* A reset makes every pin an input, which lets go of what was high; what drives the inputs stays as it was. */
void pins_after_reset(struct uno *uno)
{
	uno->oc2a = 0;
	avr_unconnect_irq(avr_io_getirq(uno->avr, AVR_IOCTL_TIMER_GETIRQ('2'), TIMER_IRQ_OUT_COMP),
			  &uno->port[0]->io.irq[OC2A_BIT]);
	for (int port = 0; port < PORTS; port++) {
		avr_ioport_t *io = uno->port[port];
		uint8_t level = uno->input_level[port] & uno->input_mask[port];
		for (int bit = 0; bit < 8; bit++)
			io->io.irq[bit].value = level >> bit & 1;
		uno->avr->data[io->r_pin] = level;
		show(uno, port);
	}
}

/* Both the pin and simavr's external level: the pin alone is pulled back up at the next write of the port. */
void uno_set_input(struct uno *uno, uint8_t port, uint8_t bit, uint8_t level)
{
	avr_ioport_t *io = uno->port[port];
	uno->input_mask[port] |= 1 << bit;
	uno->input_level[port] = (uno->input_level[port] & ~(1 << bit)) | (level & 1) << bit;
	avr_ioport_external_t external = { io->name, uno->input_mask[port], uno->input_level[port] };
	avr_ioctl(uno->avr, AVR_IOCTL_IOPORT_SET_EXTERNAL(io->name), &external);
	avr_raise_irq(&io->io.irq[bit], level & 1);
}
