/* The controller's life: made from an ELF file, run, reset, looked into, and given back. */
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <avr_eeprom.h>
#include <avr_extint.h>

#include "uno.h"

enum { WDRF = 1 << 3, FREQUENCY = 16000000 /* Hz */ };

/* What simavr complained of last in this thread. Everything else that it says is left out. */
static _Thread_local char last_words[200];

static void listen(struct avr_t *avr, const int level, const char *format, va_list values)
{
	(void)avr;
	if (level == LOG_ERROR)
		vsnprintf(last_words, sizeof last_words, format, values);
}

const char *uno_last_words(void) { return last_words; }

/* A core that sleeps jumps to its next event by itself; waiting as long for real is what this leaves out. */
static void no_sleep(avr_t *avr, avr_cycle_count_t how_long)
{
	(void)avr;
	(void)how_long;
}

avr_io_t *find_io(avr_t *avr, const char *kind, int nth)
{
	avr_io_t *io = avr->io_port;
	while (io && (strcmp(io->kind, kind) || nth--))
		io = io->next;
	return io;
}

void *append(struct list *list)
{
	if (list->count == list->room) {
		size_t room = list->room ? list->room * 2 : 1024;
		void *items = realloc(list->items, room * list->size);
		if (!items)
			abort(); /* as Rust does without memory */
		list->items = items;
		list->room = room;
	}
	return (char *)list->items + list->size * list->count++;
}

void uno_free(struct uno *uno)
{
	if (uno->avr) {
		avr_terminate(uno->avr);
		free(uno->avr);
	}
	for (uint32_t i = 0; i < uno->elf.symbolcount; i++)
		free(uno->elf.symbol[i]);
	free(uno->elf.symbol);
	free(uno->elf.flash);
	free(uno->elf.eeprom);
	free(uno->pins.items);
	free(uno->sent.items);
	free(uno->wire.items);
	free(uno);
}

static int attach(struct uno *uno)
{
	avr_t *avr = uno->avr;
	uno->uart = (avr_uart_t *)find_io(avr, "uart", 0);
	for (int nth = 0; nth < PORTS; nth++) {
		avr_ioport_t *port = (avr_ioport_t *)find_io(avr, "port", nth);
		if (!port || port->name < 'B' || port->name > 'D')
			return 0;
		uno->port[port->name - 'B'] = port;
	}
	if (!uno->uart)
		return 0;
	pins_attach(uno);
	wire_attach(uno);
	vectors_attach(uno);
	return 1;
}

/* None when the file cannot be read or simavr lacks the part. It still has to be reset. */
struct uno *uno_new(const char *elf)
{
	struct uno *uno = calloc(1, sizeof *uno);
	if (!uno)
		abort();
	last_words[0] = 0;
	avr_global_logger_set(listen);
	uno->pins.size = sizeof(struct pin_change);
	uno->sent.size = uno->wire.size = sizeof(struct wire_byte);
	if (elf_read_firmware(elf, &uno->elf) || !uno->elf.flashsize || !(uno->avr = avr_make_mcu_by_name("atmega328p"))) {
		uno_free(uno);
		return NULL;
	}
	avr_init(uno->avr);
	uno->avr->log = LOG_ERROR;
	uno->elf.frequency = FREQUENCY;
	avr_load_firmware(uno->avr, &uno->elf);
	uno->avr->frequency = FREQUENCY;
	uno->avr->sleep = no_sleep;
	uno->run = uno->avr->run;
	if (!attach(uno)) {
		uno_free(uno);
		return NULL;
	}
	return uno;
}

#define SLEEP 0x9588 /* the instruction */

static void after_reset(struct uno *uno, uint8_t mcusr)
{
	/* Step pins are INT0 and INT1: while one is low, simavr would look at it every cycle. */
	avr_extint_set_strict_lvl_trig(uno->avr, 0, 0);
	avr_extint_set_strict_lvl_trig(uno->avr, 1, 0);
	uno->avr->data[REG_MCUSR] = mcusr;
	pins_after_reset(uno);
	wire_after_reset(uno);
	vectors_after_reset(uno);
}

/* `flag` of MCUSR is added to those that were not cleared, unless `alone`. */
void uno_reset(struct uno *uno, uint8_t flag, uint8_t alone)
{
	if (uno->avr->run != uno->run)
		avr_run(uno->avr); /* a watchdog reset that was under way comes first */
	uint8_t mcusr = alone ? flag : uno->avr->data[REG_MCUSR] | flag;
	uno->crashed_at = 0;
	avr_reset(uno->avr);
	after_reset(uno, mcusr);
}

static avr_cycle_count_t stop(struct avr_t *avr, avr_cycle_count_t when, void *param)
{
	(void)avr;
	(void)when;
	(void)param;
	return 0;
}

/* Ends at the first instruction at or after `cycle`; an event there keeps a sleeping core from jumping further. */
int uno_run_until(struct uno *uno, uint64_t cycle)
{
	avr_t *avr = uno->avr;
	if (avr->state == cpu_Crashed)
		return CRASHED;
	last_words[0] = 0;
	if (avr->cycle < cycle)
		avr_cycle_timer_register(avr, cycle - avr->cycle, stop, uno);
	while (avr->cycle < cycle) {
		int watchdog = avr->run != uno->run;
		uint8_t mcusr = avr->data[REG_MCUSR];
		uint32_t pc = avr->pc;
		uint64_t before = avr->cycle;
		/* The run that falls asleep jumps as far as it sleeps, and may wake up in it. */
		int slept = avr->state == cpu_Sleeping || (avr->flash[pc] | avr->flash[pc + 1] << 8) == SLEEP;
		int state = avr_run(avr);
		if (slept)
			uno->asleep += avr->cycle - before;
		if (watchdog) {
			uno->watchdog_resets++;
			after_reset(uno, mcusr | WDRF);
			if (avr->cycle < cycle)
				avr_cycle_timer_register(avr, cycle - avr->cycle, stop, uno);
		} else if (avr->pc >= uno->elf.flashbase + uno->elf.flashsize) {
			/* The chip would run on through erased flash, and simavr does until the flash ends. */
			snprintf(last_words, sizeof last_words, "it left the program at %#06x", (unsigned)pc);
			uno->crashed_at = avr->pc;
			avr->state = cpu_Crashed;
			return CRASHED;
		} else if (state == cpu_Crashed) {
			if (!uno->crashed_at)
				uno->crashed_at = pc;
			return CRASHED;
		} else if (state == cpu_Done) {
			return ASLEEP_FOR_EVER;
		}
	}
	return REACHED;
}

uint64_t uno_cycle(const struct uno *uno) { return uno->avr->cycle; }
uint32_t uno_crashed_at(const struct uno *uno) { return uno->crashed_at; }
uint64_t uno_overruns(const struct uno *uno) { return uno->overruns; }
uint64_t uno_lost_sending(const struct uno *uno) { return uno->lost_sending; }
uint64_t uno_asleep(const struct uno *uno) { return uno->asleep; }
uint64_t uno_watchdog_resets(const struct uno *uno) { return uno->watchdog_resets; }
uint8_t *uno_data(struct uno *uno) { return uno->avr->data; }
struct vector_time uno_vector_time(const struct uno *uno, uint8_t v) { return uno->vector[v].time; }

/* What came since the last call; valid until the core runs again. */
const struct pin_change *uno_take_pins(struct uno *uno, size_t *count)
{
	*count = uno->pins.count;
	uno->pins.count = 0;
	return uno->pins.items;
}

/* Bytes whose stop bit is over; those still on the wire stay for a later call. */
const struct wire_byte *uno_sent(struct uno *uno, size_t *count)
{
	const struct wire_byte *sent = uno->sent.items;
	*count = uno->sent.count;
	while (*count && sent[*count - 1].cycle > uno->avr->cycle)
		--*count;
	return sent;
}

void uno_drop_sent(struct uno *uno, size_t count)
{
	struct wire_byte *sent = uno->sent.items;
	uno->sent.count -= count;
	if (uno->sent.count)
		memmove(sent, sent + count, uno->sent.count * sizeof *sent);
}

/* Returns 0 when simavr refuses. */
int uno_eeprom(struct uno *uno, uint8_t *bytes, uint16_t offset, uint16_t size, uint8_t write)
{
	avr_eeprom_desc_t what = { bytes, offset, size };
	return avr_ioctl(uno->avr, write ? AVR_IOCTL_EEPROM_SET : AVR_IOCTL_EEPROM_GET, &what) >= 0;
}

/* Address of a linker symbol in data memory; -1 when it is not there. */
int32_t uno_symbol(const struct uno *uno, const char *name)
{
	for (uint32_t i = 0; i < uno->elf.symbolcount; i++)
		if (!strcmp(uno->elf.symbol[i]->symbol, name))
			return (int32_t)(uno->elf.symbol[i]->addr & 0xFFFF);
	return -1;
}
