/* See text.h. */

#include "text.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void add(struct text *text, const char *bytes, size_t len) {
    if (text->failed || len == 0) {
        return;
    }
    if (text->room - text->len < len) {
        size_t room = 2 * (text->room + len);
        char *bigger = realloc(text->bytes, room);
        if (bigger == NULL) {
            text->failed = true;
            return;
        }
        text->bytes = bigger;
        text->room = room;
    }
    memcpy(text->bytes + text->len, bytes, len);
    text->len += len;
}

void add_text(struct text *text, const char *zero_ended) { add(text, zero_ended, strlen(zero_ended)); }

void add_count(struct text *text, size_t count) {
    char digits[24];
    (void)snprintf(digits, sizeof digits, "%zu", count);
    add_text(text, digits);
}

void add_quoted(struct text *text, const char *bytes, size_t len) {
    add(text, "\"", 1);
    for (size_t k = 0; k < len; k++) {
        unsigned char byte = (unsigned char)bytes[k];
        if (byte == '"' || byte == '\\') {
            add(text, "\\", 1);
        }
        if (byte < 0x20) {
            char escaped[8];
            (void)snprintf(escaped, sizeof escaped, "\\u%04x", byte);
            add_text(text, escaped);
        } else {
            add(text, &bytes[k], 1);
        }
    }
    add(text, "\"", 1);
}

/* Bytes of the control character at the start; 0 when there is none. */
static size_t control_len(const char *bytes, size_t len) {
    unsigned char first = (unsigned char)bytes[0];
    if (first < 0x20 || first == 0x7F) {
        return 1;
    }
    return first == 0xC2 && len > 1 && (unsigned char)bytes[1] < 0xA0 ? 2 : 0;
}

void add_one_line(struct text *text, const char *bytes, size_t len) {
    size_t k = 0;
    while (k < len) {
        size_t skip = control_len(bytes + k, len - k);
        if (skip == 0) {
            add(text, &bytes[k++], 1);
        }
        k += skip;
    }
}

bool is_one_line(const char *bytes, size_t len) {
    for (size_t k = 0; k < len; k++) {
        if (control_len(bytes + k, len - k) != 0) {
            return false;
        }
    }
    return true;
}
