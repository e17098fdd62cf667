/*
 * Reads JSON (RFC 8259) into a tree. Strict: nothing is guessed, repaired or left over.
 *
 * Refused besides what is no JSON: bytes that are no UTF-8, a key that is twice in its object, a number
 * beyond the range of a double or of more than JSON_MOST_DIGITS characters, nesting beyond JSON_MOST_DEPTH,
 * and objects of more than JSON_MOST_KEYS keys. No message of the boundary comes near these limits.
 */
#ifndef TEMPLATE_C_JSON_H
#define TEMPLATE_C_JSON_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define JSON_MOST_DEPTH 64   /* values inside each other */
#define JSON_MOST_KEYS 256   /* in one object */
#define JSON_MOST_DIGITS 400 /* characters of a number */

enum json_kind { JSON_NULL, JSON_FALSE, JSON_TRUE, JSON_NUMBER, JSON_TEXT, JSON_ARRAY, JSON_OBJECT };

/* UTF-8. A zero byte ends it, and may be inside as well. */
struct json_text {
    char *bytes;
    size_t len; /* bytes, without the zero at the end */
};

struct json_value {
    enum json_kind kind;
    double number;            /* JSON_NUMBER: finite */
    struct json_text text;    /* JSON_TEXT */
    struct json_value *first; /* JSON_ARRAY, JSON_OBJECT: null when empty */
    struct json_value *next;  /* the next element or member of what it is in */
    struct json_text key;     /* of a member; else null */
};

/* Why there is no value. */
struct json_problem {
    const char *what; /* what was expected; static */
    size_t at;        /* offset of the byte, from 0 */
    bool no_memory;   /* the text may be good: memory ran out */
};

/* Gives the value, which the caller hands to json_free; or null, and then `problem` says why. */
struct json_value *json_read(const uint8_t *bytes, size_t len, struct json_problem *problem);

/* Gives back a value and all that is in it. Null is allowed. */
void json_free(struct json_value *value);

/* The member of an object; null when it is not there, or when `value` is null or no object. */
const struct json_value *json_member(const struct json_value *value, const char *key);

/* The text of a value; null when `value` is null or no text. */
const struct json_text *json_as_text(const struct json_value *value);

/* Whether a text is this one, which ends with a zero byte. Null is no text. */
bool json_text_is(const struct json_text *text, const char *other);

#endif
