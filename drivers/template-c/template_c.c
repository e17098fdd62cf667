/*
 * The driver to copy, in C: a table of the machine's steps as text. It says, takes and writes what
 * drivers/template does in Rust. README.md says how to make another driver of it.
 */

#include <wirebend_driver.h>

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "json.h"
#include "text.h"

#define FORMAT "template-c-text"
#define MAX_DECIMALS 6
/* The largest length or angle of a column, mm or degrees. With six decimals it still is a whole number of
   units below 2^53, which a double counts exactly. */
#define MAX_VALUE 100000.0

/* What crates/driver-api/schema/description.schema.json asks for. */
static char description[] =
    "{\"id\": \"template-c\", \"name\": \"Template in C\", \"version\": \"0.1.0\","
    " \"description\": \"The driver to copy, in C: it writes the machine's steps as a table, for no machine in"
    " particular. No machine has been run from its files.\","
    " \"capabilities\": [\"export\"],"
    " \"formats\": [{\"id\": \"" FORMAT "\", \"name\": \"Table of steps\", \"extensions\": [\"txt\"],"
    "  \"content\": \"machine\", \"files\": \"each-wire\", \"program\": true}],"
    " \"settings_schema\": {\"type\": \"object\", \"additionalProperties\": false, \"properties\": {"
    "  \"decimals\": {\"type\": \"integer\", \"minimum\": 0, \"maximum\": 6, \"default\": 3, \"description\":"
    "   \"Digits behind the decimal point of lengths (mm) and angles (degrees), 0 to 6.\"},"
    "  \"header\": {\"type\": \"boolean\", \"default\": true, \"description\":"
    "   \"Whether a line with the names and units of the columns stands above the steps.\"},"
    "  \"comment\": {\"type\": \"string\", \"default\": \"#\", \"description\":"
    "   \"What a comment line starts with. The first line is a comment with the names of design and machine and"
    " the hash of the design; empty: it is left out.\"}}}}";

/* Handed out when there is no memory to say so. */
static char no_memory[] =
    "{\"code\": \"out-of-memory\", \"message\": \"memory ran out\", \"help\": \"close other programs\"}";

static int32_t refuse_for_memory(wirebend_buffer *out) {
    *out = (wirebend_buffer){.data = (uint8_t *)no_memory, .len = strlen(no_memory)};
    return WIREBEND_REFUSED;
}

/* Hands a text over to the program, or says that memory ran out. */
static int32_t give(wirebend_buffer *out, struct text *text, int32_t status) {
    if (text->failed) {
        free(text->bytes);
        return refuse_for_memory(out);
    }
    *out = (wirebend_buffer){.data = (uint8_t *)text->bytes, .len = text->len};
    return status;
}

static int32_t refuse(wirebend_buffer *out, const char *code, const char *help, const char *format, ...) {
    struct text text = {0};
    va_list values, again;
    va_start(values, format);
    va_copy(again, values);
    int len = vsnprintf(NULL, 0, format, values);
    char *message = len < 0 ? NULL : malloc((size_t)len + 1);
    if (message == NULL) {
        text.failed = true;
    } else {
        (void)vsnprintf(message, (size_t)len + 1, format, again);
        add_text(&text, "{\"code\": ");
        add_quoted(&text, code, strlen(code));
        add_text(&text, ", \"message\": ");
        add_quoted(&text, message, strlen(message));
        add_text(&text, ", \"help\": ");
        add_quoted(&text, help, strlen(help));
        add_text(&text, "}");
    }
    va_end(again);
    va_end(values);
    free(message);
    return give(out, &text, WIREBEND_REFUSED);
}

/* Reads what the program hands in; null after a refusal. */
static struct json_value *read_or_refuse(wirebend_bytes bytes, wirebend_buffer *out, const char *code) {
    struct json_problem problem;
    struct json_value *value = json_read(bytes.data, bytes.len, &problem);
    if (value == NULL && problem.no_memory) {
        (void)refuse_for_memory(out);
    } else if (value == NULL) {
        (void)refuse(out, code, "see the schema of messages", "byte %zu: %s", problem.at, problem.what);
    }
    return value;
}

/* --- settings */

struct instance {
    int decimals;
    bool header;
    struct text comment;
};

/* Takes one setting; WIREBEND_REFUSED names its key. */
static int32_t set(struct instance *instance, const struct json_value *value, wirebend_buffer *out) {
    const struct json_text *text = json_as_text(value);
    if (json_text_is(&value->key, "decimals")) {
        double number = value->number;
        if (value->kind != JSON_NUMBER || number < 0 || number > MAX_DECIMALS || floor(number) != number) {
            return refuse(out, "settings", "set it to 3 for thousandths",
                          "'decimals' can be a whole number from 0 to %d", MAX_DECIMALS);
        }
        instance->decimals = (int)number;
    } else if (json_text_is(&value->key, "header")) {
        if (value->kind != JSON_TRUE && value->kind != JSON_FALSE) {
            return refuse(out, "settings", "write one of the two", "'header' can be true or false");
        }
        instance->header = value->kind == JSON_TRUE;
    } else if (json_text_is(&value->key, "comment")) {
        if (text == NULL || !is_one_line(text->bytes, text->len)) {
            return refuse(out, "settings", "use the mark that starts a comment, such as #",
                          "'comment' is a text without control characters, such as the end of a line");
        }
        instance->comment.len = 0;
        add(&instance->comment, text->bytes, text->len);
        return instance->comment.failed ? refuse_for_memory(out) : WIREBEND_OK;
    } else {
        return refuse(out, "settings", "known: decimals, header, comment", "'%s' is not a setting of this driver",
                      value->key.bytes);
    }
    return WIREBEND_OK;
}

/* --- the format */

/* A column of rounded numbers. What rounding takes from one step is given to the next, so that the sum
   down the column is never off by more than half of the last digit. */
struct column {
    const char *name, *key;
    double carry; /* what is left over, in units of the last digit */
};

/* Writes whole units of the last digit with a point between: no locale, no "-0". */
static void add_number(struct text *text, struct column *column, double value, int decimals) {
    long long scale = 1;
    for (int k = 0; k < decimals; k++) {
        scale *= 10;
    }
    /* A product and a sum, not one operation with a rounding of its own, which some compilers make of them. */
    double exact = value * (double)scale;
    exact += column->carry;
    /* Halves go to the even side: what is left over is a half at most, and so a zero stays zero. */
    double rounded = rint(exact);
    column->carry = exact - rounded;
    long long units = (long long)rounded;
    add_text(text, units < 0 ? "-" : "");
    add_count(text, (size_t)(llabs(units) / scale));
    add_text(text, decimals > 0 ? "." : "");
    for (long long place = scale / 10; place > 0; place /= 10) {
        char digit = (char)('0' + llabs(units) / place % 10);
        add(text, &digit, 1);
    }
}

static int32_t add_steps(struct text *text, const struct json_value *steps, size_t wire, int decimals,
                         wirebend_buffer *out) {
    struct column columns[] = {{"feed", "feed_mm", 0}, {"rotate", "rotate_deg", 0}, {"bend", "bend_deg", 0}};
    size_t n = 1; /* wires and steps count from 1 for people */
    /* The machine's own signs are in the steps already: nothing here turns a sign round. */
    for (const struct json_value *step = steps->first; step != NULL; step = step->next, n++) {
        add_count(text, n);
        for (size_t k = 0; k < 3; k++) {
            const struct json_value *value = json_member(step, columns[k].key);
            if (value == NULL || value->kind != JSON_NUMBER) {
                return refuse(out, "request", "see the schema of calls", "wire %zu, step %zu: '%s' is no number",
                              wire + 1, n, columns[k].key);
            }
            if (fabs(value->number) > MAX_VALUE) {
                return refuse(out, "too-large", "divide the design, or look at its scale",
                              "wire %zu, step %zu: %s is %.0f; a column holds up to %.0f", wire + 1, n,
                              columns[k].name, value->number, MAX_VALUE);
            }
            add_text(text, ", ");
            add_number(text, &columns[k], value->number, decimals);
        }
        add_text(text, "\n");
    }
    return WIREBEND_OK;
}

/* One wire as the text of a file; WIREBEND_REFUSED names wire and step. */
static int32_t add_table(struct text *text, const struct instance *with, const struct json_value *job,
                         const struct json_value *wire, size_t index, wirebend_buffer *out) {
    const struct json_text *name = json_as_text(json_member(job, "name"));
    const struct json_text *machine = json_as_text(json_member(json_member(job, "machine"), "name"));
    const struct json_text *hash = json_as_text(json_member(job, "design_hash"));
    const struct json_value *steps = json_member(wire, "machine");
    if (name == NULL || machine == NULL || hash == NULL) {
        return refuse(out, "request", "see the schema of calls", "the job has no name, machine or design_hash");
    }
    if (steps == NULL || steps->kind == JSON_NULL) {
        return refuse(out, "no-machine-steps", "see what the checks say",
                      "wire %zu has no steps for a machine: it could not be compensated", index + 1);
    }
    if (steps->kind != JSON_ARRAY) {
        return refuse(out, "request", "see the schema of calls", "wire %zu: 'machine' is no list", index + 1);
    }
    if (with->comment.len > 0) {
        add(text, with->comment.bytes, with->comment.len);
        add_text(text, " ");
        add_one_line(text, name->bytes, name->len);
        add_text(text, " for ");
        add_one_line(text, machine->bytes, machine->len);
        add_text(text, ", design ");
        add_one_line(text, hash->bytes, hash->len);
        add_text(text, "\n");
    }
    if (with->header) {
        add_text(text, "n, feed_mm, rotate_deg, bend_deg\n");
    }
    return add_steps(text, steps, index, with->decimals, out);
}

static int32_t encode(const struct instance *with, const struct json_value *call, wirebend_buffer *out) {
    const struct json_value *job = json_member(call, "job");
    const struct json_value *wires = json_member(job, "wires");
    if (!json_text_is(json_as_text(json_member(call, "format")), FORMAT)) {
        return refuse(out, "unknown-format", "known: " FORMAT, "that is not a format of this driver");
    }
    if (wires == NULL || wires->kind != JSON_ARRAY) {
        return refuse(out, "request", "see the schema of calls", "the job has no list 'wires'");
    }
    struct text reply = {0};
    size_t index = 0;
    add_text(&reply, "{\"files\": [");
    for (const struct json_value *wire = wires->first; wire != NULL; wire = wire->next, index++) {
        struct text table = {0};
        int32_t status = add_table(&table, with, job, wire, index, out);
        if (status == WIREBEND_OK) {
            add_text(&reply, index == 0 ? "{\"text\": " : ", {\"text\": ");
            add_quoted(&reply, table.bytes, table.len);
            add_text(&reply, "}");
            reply.failed = reply.failed || table.failed;
        }
        free(table.bytes);
        if (status != WIREBEND_OK) {
            free(reply.bytes);
            return status;
        }
    }
    add_text(&reply, "], \"notes\": []}");
    return give(out, &reply, WIREBEND_OK);
}

/* --- the table of functions */

static int32_t describe_c(wirebend_buffer *out) {
    *out = (wirebend_buffer){.data = (uint8_t *)description, .len = strlen(description)};
    return WIREBEND_OK;
}

static void close_c(void *opened) {
    struct instance *instance = opened;
    if (instance != NULL) {
        free(instance->comment.bytes);
        free(instance);
    }
}

static int32_t open_c(wirebend_bytes settings, void **opened, wirebend_buffer *out) {
    *out = (wirebend_buffer){0};
    struct instance *instance = calloc(1, sizeof *instance);
    if (instance == NULL) {
        return refuse_for_memory(out);
    }
    instance->decimals = 3;
    instance->header = true;
    add_text(&instance->comment, "#");
    int32_t status = instance->comment.failed ? refuse_for_memory(out) : WIREBEND_OK;
    struct json_value *keys = status == WIREBEND_OK ? read_or_refuse(settings, out, "settings") : NULL;
    if (keys == NULL) {
        status = WIREBEND_REFUSED;
    } else if (keys->kind != JSON_OBJECT) {
        status = refuse(out, "settings", "write {} for the defaults", "the settings are no object");
    } else {
        for (struct json_value *key = keys->first; key != NULL && status == WIREBEND_OK; key = key->next) {
            status = set(instance, key, out);
        }
    }
    json_free(keys);
    if (status == WIREBEND_OK) {
        *opened = instance;
    } else {
        close_c(instance);
    }
    return status;
}

static int32_t call_c(void *opened, wirebend_bytes request, wirebend_buffer *out) {
    static const char *const moving[] = {"home", "arm", "send", "jog", "pause", "resume", "stop",
                                         "write-settings"};
    struct json_value *call = read_or_refuse(request, out, "request");
    if (call == NULL) {
        return WIREBEND_REFUSED;
    }
    const struct json_text *name = json_as_text(json_member(call, "call"));
    int32_t status = WIREBEND_REFUSED;
    if (name == NULL) {
        status = refuse(out, "request", "see the schema of calls", "the request has no text 'call'");
    } else if (json_text_is(name, "encode")) {
        status = encode(opened, call, out);
    } else if (json_text_is(name, "disconnect")) {
        struct text done = {0};
        add_text(&done, "{}");
        status = give(out, &done, WIREBEND_OK);
    } else if (json_text_is(name, "connect")) {
        status = refuse(out, "unsupported", "see the capabilities that it describes",
                        "this driver cannot move a machine: it writes files");
    } else if (json_text_is(name, "ports")) {
        status = refuse(out, "unsupported", "see the capabilities that it describes",
                        "this driver cannot list ports: it writes files");
    } else {
        bool known = false;
        for (size_t k = 0; k < sizeof moving / sizeof *moving; k++) {
            known = known || json_text_is(name, moving[k]);
        }
        status = known ? refuse(out, "not-connected", "connect first", "the driver has no connection")
                       : refuse(out, "unknown-call", "it may be older than the program: look for a newer one",
                                "'%s' is not a call that this driver knows", name->bytes);
    }
    json_free(call);
    return status;
}

static int32_t poll_c(void *opened, wirebend_buffer *out) {
    (void)opened; /* nothing happens by itself: there is no machine */
    *out = (wirebend_buffer){0};
    return WIREBEND_OK;
}

static void free_c(wirebend_buffer buffer) {
    if (buffer.data != (uint8_t *)description && buffer.data != (uint8_t *)no_memory) {
        free(buffer.data);
    }
}

static const void *extension_c(const char *name) {
    (void)name;
    return NULL;
}

const wirebend_driver *wirebend_driver_entry(void) {
    static const wirebend_driver table = {WIREBEND_ABI_MAJOR, WIREBEND_ABI_MINOR, describe_c, open_c, call_c,
                                          poll_c, close_c, free_c, extension_c};
    return &table;
}
