/* A recursive reader; its depth is bounded. See json.h for what it refuses. */

#include "json.h"

#include <locale.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

struct reader {
    const uint8_t *bytes;
    size_t len;
    size_t at;
    struct json_problem *problem;
};

static bool fails(struct reader *in, const char *what) {
    *in->problem = (struct json_problem){.what = what, .at = in->at, .no_memory = false};
    return false;
}

static bool out_of_memory(struct reader *in) {
    *in->problem = (struct json_problem){.what = "memory ran out", .at = in->at, .no_memory = true};
    return false;
}

/* The next byte; -1 at the end. */
static int peek(const struct reader *in) { return in->at < in->len ? in->bytes[in->at] : -1; }

static bool takes(struct reader *in, int byte) {
    if (peek(in) != byte) {
        return false;
    }
    in->at++;
    return true;
}

static void skip_blanks(struct reader *in) {
    while (peek(in) == ' ' || peek(in) == '\t' || peek(in) == '\n' || peek(in) == '\r') {
        in->at++;
    }
}

static bool word(struct reader *in, const char *expected) {
    size_t len = strlen(expected);
    if (in->len - in->at < len || memcmp(in->bytes + in->at, expected, len) != 0) {
        return fails(in, "expected a value");
    }
    in->at += len;
    return true;
}

/* --- texts */

static bool four_digits(struct reader *in, uint32_t *code) {
    *code = 0;
    for (int digit = 0; digit < 4; digit++) {
        int byte = peek(in);
        int value = byte >= '0' && byte <= '9'   ? byte - '0'
                    : byte >= 'a' && byte <= 'f' ? byte - 'a' + 10
                    : byte >= 'A' && byte <= 'F' ? byte - 'A' + 10
                                                 : -1;
        if (value < 0) {
            return fails(in, "expected four hexadecimal digits behind \\u");
        }
        *code = *code * 16 + (uint32_t)value;
        in->at++;
    }
    return true;
}

static void add_code(struct json_text *text, uint32_t code) {
    static const uint8_t lead[] = {0x00, 0xC0, 0xE0, 0xF0};
    int more = code < 0x80 ? 0 : code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
    text->bytes[text->len++] = (char)(lead[more] | (code >> (6 * more)));
    while (more-- > 0) {
        text->bytes[text->len++] = (char)(0x80 | ((code >> (6 * more)) & 0x3F));
    }
}

static bool escape(struct reader *in, struct json_text *text) {
    static const char names[] = "\"\\/bfnrt";
    static const char meant[] = "\"\\/\b\f\n\r\t";
    int byte = peek(in);
    const char *name = byte > 0 ? strchr(names, byte) : NULL;
    if (name != NULL) {
        in->at++;
        text->bytes[text->len++] = meant[name - names];
        return true;
    }
    uint32_t code = 0;
    uint32_t low = 0;
    if (!takes(in, 'u')) {
        return fails(in, "expected one of \" \\ / b f n r t u behind the backslash");
    }
    if (!four_digits(in, &code)) {
        return false;
    }
    if (code >= 0xD800 && code < 0xE000) {
        bool pair = code < 0xDC00 && takes(in, '\\') && takes(in, 'u');
        if (pair && !four_digits(in, &low)) {
            return false;
        }
        if (!pair || low < 0xDC00 || low >= 0xE000) {
            return fails(in, "expected a whole surrogate pair, such as \\ud83d\\ude00");
        }
        code = 0x10000 + ((code - 0xD800) << 10) + (low - 0xDC00);
    }
    add_code(text, code);
    return true;
}

/* One character beyond ASCII: neither longer than need be, nor a surrogate, nor beyond U+10FFFF. */
static bool wide(struct reader *in, struct json_text *text) {
    int lead = peek(in);
    int more = lead >= 0xC2 && lead < 0xE0 ? 1 : lead >= 0xE0 && lead < 0xF0 ? 2 : lead >= 0xF0 && lead < 0xF5 ? 3 : 0;
    if (more == 0 || in->len - in->at <= (size_t)more) {
        return fails(in, "expected UTF-8");
    }
    uint32_t code = (uint32_t)lead & (0x3Fu >> more);
    for (int k = 1; k <= more; k++) {
        uint8_t byte = in->bytes[in->at + (size_t)k];
        if ((byte & 0xC0) != 0x80) {
            return fails(in, "expected UTF-8");
        }
        code = (code << 6) | (byte & 0x3Fu);
    }
    static const uint32_t least[] = {0, 0x80, 0x800, 0x10000};
    if (code < least[more] || code > 0x10FFFF || (code >= 0xD800 && code < 0xE000)) {
        return fails(in, "expected UTF-8");
    }
    in->at += (size_t)more + 1;
    add_code(text, code);
    return true;
}

/* The caller owns text->bytes, also after a failure. */
static bool read_text(struct reader *in, struct json_text *text) {
    if (!takes(in, '"')) {
        return fails(in, "expected a text in quotation marks");
    }
    /* What an escape stands for is never longer than the escape: the raw length is enough. */
    size_t end = in->at;
    while (end < in->len && in->bytes[end] != '"') {
        end += in->bytes[end] == '\\' ? 2 : 1;
    }
    if (end >= in->len) {
        in->at = in->len;
        return fails(in, "expected the quotation mark that ends the text");
    }
    text->bytes = malloc(end - in->at + 1);
    if (text->bytes == NULL) {
        return out_of_memory(in);
    }
    while (!takes(in, '"')) {
        int byte = peek(in);
        if (byte < 0x20) {
            return fails(in, "expected no control character inside a text: write it as an escape");
        }
        if (byte >= 0x80) {
            if (!wide(in, text)) {
                return false;
            }
        } else {
            in->at++;
            if (byte != '\\') {
                text->bytes[text->len++] = (char)byte;
            } else if (!escape(in, text)) {
                return false;
            }
        }
    }
    text->bytes[text->len] = '\0';
    return true;
}

/* --- numbers */

static bool digits(struct reader *in) {
    if (peek(in) < '0' || peek(in) > '9') {
        return fails(in, "expected a digit");
    }
    while (peek(in) >= '0' && peek(in) <= '9') {
        in->at++;
    }
    return true;
}

static bool read_number(struct reader *in, double *number) {
    size_t start = in->at;
    (void)takes(in, '-');
    if (!takes(in, '0') && !digits(in)) {
        return false;
    }
    size_t point = in->at;
    bool has_point = takes(in, '.');
    if (has_point && !digits(in)) {
        return false;
    }
    if (takes(in, 'e') || takes(in, 'E')) {
        if (!takes(in, '+')) {
            (void)takes(in, '-');
        }
        if (!digits(in)) {
            return false;
        }
    }
    /* strtod expects the decimal point of the locale, which the program that loaded this library may have set. */
    const char *mark = localeconv()->decimal_point;
    char copy[JSON_MOST_DIGITS + 16];
    size_t len = in->at - start;
    size_t mark_len = strlen(mark);
    if (len > JSON_MOST_DIGITS || mark_len > 8) {
        return fails(in, "expected a shorter number");
    }
    size_t before = has_point ? point - start : len;
    memcpy(copy, in->bytes + start, before);
    size_t used = before;
    if (has_point) {
        memcpy(copy + used, mark, mark_len);
        used += mark_len;
        memcpy(copy + used, in->bytes + point + 1, len - before - 1);
        used += len - before - 1;
    }
    copy[used] = '\0';
    *number = strtod(copy, NULL);
    return isfinite(*number) ? true : fails(in, "expected a number that a double can hold");
}

/* --- values */

static bool read_value(struct reader *in, struct json_value **place, int depth);

static bool read_key(struct reader *in, const struct json_value *object, struct json_text *key, size_t count) {
    if (!read_text(in, key)) {
        return false;
    }
    if (count > JSON_MOST_KEYS) {
        return fails(in, "expected fewer keys in an object");
    }
    for (const struct json_value *other = object->first; other != NULL; other = other->next) {
        if (other->key.len == key->len && memcmp(other->key.bytes, key->bytes, key->len) == 0) {
            return fails(in, "expected every key once in its object");
        }
    }
    skip_blanks(in);
    return takes(in, ':') ? true : fails(in, "expected ':' behind a key");
}

/* What stands between brackets. Everything read hangs on `whole`, which the caller owns. */
static bool read_inside(struct reader *in, struct json_value *whole, int depth) {
    bool object = whole->kind == JSON_OBJECT;
    int end = object ? '}' : ']';
    struct json_value **place = &whole->first;
    skip_blanks(in);
    if (takes(in, end)) {
        return true;
    }
    for (size_t count = 1;; count++) {
        struct json_text key = {0};
        skip_blanks(in);
        if (object && !read_key(in, whole, &key, count)) {
            free(key.bytes);
            return false;
        }
        bool read = read_value(in, place, depth + 1);
        if (*place == NULL) {
            free(key.bytes);
            return false;
        }
        (*place)->key = key;
        if (!read) {
            return false;
        }
        place = &(*place)->next;
        skip_blanks(in);
        if (takes(in, end)) {
            return true;
        }
        if (!takes(in, ',')) {
            return fails(in, object ? "expected ',' or '}'" : "expected ',' or ']'");
        }
    }
}

/* Puts a value in its place before it is complete, so that it is given back with the rest on a failure. */
static bool read_value(struct reader *in, struct json_value **place, int depth) {
    skip_blanks(in);
    if (depth >= JSON_MOST_DEPTH) {
        return fails(in, "expected fewer values inside each other");
    }
    struct json_value *value = calloc(1, sizeof *value);
    if (value == NULL) {
        return out_of_memory(in);
    }
    *place = value;
    switch (peek(in)) {
    case '{':
    case '[':
        value->kind = peek(in) == '{' ? JSON_OBJECT : JSON_ARRAY;
        in->at++;
        return read_inside(in, value, depth);
    case '"':
        value->kind = JSON_TEXT;
        return read_text(in, &value->text);
    case 't':
        value->kind = JSON_TRUE;
        return word(in, "true");
    case 'f':
        value->kind = JSON_FALSE;
        return word(in, "false");
    case 'n':
        return word(in, "null"); /* JSON_NULL is zero, which calloc has written */
    case '-':
    case '0': case '1': case '2': case '3': case '4':
    case '5': case '6': case '7': case '8': case '9':
        value->kind = JSON_NUMBER;
        return read_number(in, &value->number);
    default:
        return fails(in, "expected a value");
    }
}

struct json_value *json_read(const uint8_t *bytes, size_t len, struct json_problem *problem) {
    struct reader in = {.bytes = bytes, .len = len, .at = 0, .problem = problem};
    struct json_value *value = NULL;
    bool read = read_value(&in, &value, 0);
    if (read) {
        skip_blanks(&in);
        read = in.at == len ? true : fails(&in, "expected nothing behind the value");
    }
    if (!read) {
        json_free(value);
        return NULL;
    }
    return value;
}

void json_free(struct json_value *value) {
    while (value != NULL) {
        struct json_value *next = value->next;
        json_free(value->first); /* as deep as the reader went: JSON_MOST_DEPTH */
        free(value->text.bytes);
        free(value->key.bytes);
        free(value);
        value = next;
    }
}

const struct json_value *json_member(const struct json_value *value, const char *key) {
    if (value == NULL || value->kind != JSON_OBJECT) {
        return NULL;
    }
    const struct json_value *member = value->first;
    while (member != NULL && !json_text_is(&member->key, key)) {
        member = member->next;
    }
    return member;
}

const struct json_text *json_as_text(const struct json_value *value) {
    return value != NULL && value->kind == JSON_TEXT ? &value->text : NULL;
}

bool json_text_is(const struct json_text *text, const char *other) {
    return text != NULL && text->len == strlen(other) && memcmp(text->bytes, other, text->len) == 0;
}
