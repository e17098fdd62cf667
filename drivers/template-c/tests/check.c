/*
 * Talks to the driver through its table, and to its JSON reader, under sanitizers. The test in
 * drivers/template/tests/c_twin.rs asks; this program answers each line with one line.
 *
 *     describe | poll | close | open HEX | call HEX     what the table answers
 *     json HEX                                          reads, and writes again what was read
 *     fail N                                            the N-th allocation from here on fails; 0: none does.
 *                                                       Answers how many there have been since the last `fail`
 *     point C                                           C is the decimal point of the locale from here on
 *
 * An answer is a status, 0 or 1, a blank, and bytes in hexadecimal digits.
 */

#include <wirebend_driver.h>

#include <locale.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "json.h"
#include "text.h"

/* --- what the driver calls instead of the standard library */

static size_t allocations, failing;
static char point[] = ".";

static bool fails(void) { return ++allocations == failing; }

void *checked_malloc(size_t len);
void *checked_calloc(size_t count, size_t len);
void *checked_realloc(void *old, size_t len);
struct lconv *checked_localeconv(void);
double checked_strtod(const char *text, char **end);

void *checked_malloc(size_t len) { return fails() ? NULL : malloc(len); }

void *checked_calloc(size_t count, size_t len) { return fails() ? NULL : calloc(count, len); }

void *checked_realloc(void *old, size_t len) { return fails() ? NULL : realloc(old, len); }

struct lconv *checked_localeconv(void) {
    static struct lconv other;
    other.decimal_point = point;
    return &other;
}

/* As in a locale with this decimal point: another one ends the number. */
double checked_strtod(const char *text, char **end) {
    char copy[512];
    size_t k = 0;
    for (; text[k] != '\0' && k + 1 < sizeof copy; k++) {
        if (text[k] == '.' && point[0] != '.') {
            break;
        }
        copy[k] = text[k] == point[0] ? '.' : text[k];
    }
    copy[k] = '\0';
    return strtod(copy, end);
}

/* --- answers */

static void answer(int status, const void *bytes, size_t len) {
    const uint8_t *at = bytes;
    printf("%d ", status);
    for (size_t k = 0; k < len; k++) {
        printf("%02x", at[k]);
    }
    printf("\n");
    fflush(stdout);
}

static void dump(struct text *text, const struct json_value *value) {
    char number[40];
    const char *between = "";
    switch (value->kind) {
    case JSON_NULL: add_text(text, "null"); break;
    case JSON_FALSE: add_text(text, "false"); break;
    case JSON_TRUE: add_text(text, "true"); break;
    case JSON_NUMBER:
        (void)snprintf(number, sizeof number, "%.17g", value->number);
        add_text(text, number);
        break;
    case JSON_TEXT: add_quoted(text, value->text.bytes, value->text.len); break;
    case JSON_ARRAY:
    case JSON_OBJECT:
        add_text(text, value->kind == JSON_ARRAY ? "[" : "{");
        for (const struct json_value *inside = value->first; inside != NULL; inside = inside->next) {
            add_text(text, between);
            if (value->kind == JSON_OBJECT) {
                add_quoted(text, inside->key.bytes, inside->key.len);
                add_text(text, ":");
            }
            dump(text, inside);
            between = ",";
        }
        add_text(text, value->kind == JSON_ARRAY ? "]" : "}");
        break;
    }
}

static void read_json(const uint8_t *bytes, size_t len) {
    struct json_problem problem = {0};
    struct json_value *value = json_read(bytes, len, &problem);
    struct text text = {0};
    if (value != NULL) {
        dump(&text, value);
    } else {
        add_count(&text, problem.at);
        add_text(&text, ": ");
        add_text(&text, problem.what);
    }
    answer(value == NULL, text.bytes, text.len);
    json_free(value);
    free(text.bytes);
}

/* --- the table */

static void *instance;

static void close_instance(const wirebend_driver *driver) {
    if (instance != NULL) {
        driver->close(instance);
    }
    instance = NULL;
}

static void ask_table(const wirebend_driver *driver, const char *what, wirebend_bytes asked) {
    wirebend_buffer out = {0};
    int32_t status = WIREBEND_OK;
    if (strcmp(what, "describe") == 0) {
        status = driver->describe(&out);
    } else if (strcmp(what, "open") == 0) {
        close_instance(driver);
        status = driver->open(asked, &instance, &out);
    } else if (strcmp(what, "close") == 0) {
        close_instance(driver);
    } else if (instance == NULL) {
        fprintf(stderr, "'%s' needs an open instance\n", what);
        exit(2);
    } else if (strcmp(what, "call") == 0) {
        status = driver->call(instance, asked, &out);
    } else if (strcmp(what, "poll") == 0) {
        status = driver->poll(instance, &out);
    } else {
        fprintf(stderr, "'%s' cannot be asked\n", what);
        exit(2);
    }
    answer(status, out.data, out.len);
    driver->free(out);
}

/* Bytes of exactly their length, so that reading past their end is found. */
static uint8_t *from_hex(const char *hex, size_t *len) {
    *len = strlen(hex) / 2;
    uint8_t *bytes = *len == 0 ? NULL : malloc(*len);
    for (size_t k = 0; bytes != NULL && k < *len; k++) {
        char pair[] = {hex[2 * k], hex[2 * k + 1], '\0'};
        bytes[k] = (uint8_t)strtoul(pair, NULL, 16);
    }
    return bytes;
}

int main(void) {
    static char line[1 << 22];
    const wirebend_driver *driver = wirebend_driver_entry();
    if (driver->abi_major != WIREBEND_ABI_MAJOR || driver->extension("none/1") != NULL) {
        return 2;
    }
    while (fgets(line, sizeof line, stdin) != NULL) {
        line[strcspn(line, "\n")] = '\0';
        char *rest = strchr(line, ' ');
        if (rest != NULL) {
            *rest++ = '\0';
        } else {
            rest = line + strlen(line);
        }
        if (strcmp(line, "fail") == 0) {
            char count[24];
            (void)snprintf(count, sizeof count, "%zu", allocations);
            allocations = 0;
            failing = (size_t)strtoul(rest, NULL, 10);
            answer(0, count, strlen(count));
        } else if (strcmp(line, "point") == 0) {
            point[0] = rest[0];
            answer(0, NULL, 0);
        } else {
            size_t len = 0;
            uint8_t *bytes = from_hex(rest, &len);
            if (strcmp(line, "json") == 0) {
                read_json(bytes, len);
            } else {
                ask_table(driver, line, (wirebend_bytes){.data = bytes, .len = len});
            }
            free(bytes);
        }
    }
    close_instance(driver);
    return 0;
}
