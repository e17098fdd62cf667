/* An ATmega328P at 16 MHz over libsimavr 1.6. src/ffi.rs declares the same in Rust; README.md says what simavr
   does otherwise than the chip. A cycle is 62.5 ns and counts from power-on, through every reset. */
#ifndef WIREBEND_UNO_H
#define WIREBEND_UNO_H

#include <stddef.h>

#include <avr_ioport.h>
#include <avr_uart.h>
#include <sim_avr.h>
#include <sim_elf.h>

enum { PORTS = 3, VECTORS = 26 };
enum { REG_MCUSR = 0x54, REG_TCCR2A = 0xB0, REG_TCCR2B = 0xB1, REG_UCSR0A = 0xC0, REG_UBRR0 = 0xC4 };
enum { REACHED, CRASHED, ASLEEP_FOR_EVER };

struct pin_change { uint64_t cycle; uint8_t port /* 0 to 2: B to D */, bit, level; };
struct wire_byte { uint64_t cycle /* of the end of its stop bit */; uint16_t value /* 0x8000: no stop bit */; };
struct vector_time { uint64_t count, worst_run /* cycles */, worst_wait /* cycles */; };

struct list { void *items; size_t count, room, size /* bytes an item */; };
struct vector { struct vector_time time; avr_t *avr; uint64_t run_from, wait_from; uint8_t running, waiting; };

struct uno {
	avr_t *avr;
	avr_run_t run; /* simavr's watchdog puts another in its place when it resets */
	avr_uart_t *uart;
	avr_ioport_t *port[PORTS];
	elf_firmware_t elf;
	struct list pins, sent, wire;
	size_t wire_next;
	uint64_t sending_until /* cycle */, overruns, lost_sending, watchdog_resets, asleep /* cycles */;
	uint8_t input_mask[PORTS], input_level[PORTS], shown[PORTS];
	uint32_t crashed_at; /* byte address */
	uint8_t oc2a;
	struct vector vector[VECTORS];
};

avr_io_t *find_io(avr_t *avr, const char *kind, int nth);
/* Room for one more item. */
void *append(struct list *list);

void pins_attach(struct uno *uno);
void pins_after_reset(struct uno *uno);
void wire_attach(struct uno *uno);
void wire_after_reset(struct uno *uno);
void vectors_attach(struct uno *uno);
void vectors_after_reset(struct uno *uno);

#endif
