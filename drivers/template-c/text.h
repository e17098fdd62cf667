/*
 * Text that grows. When memory runs out `failed` is set and nothing more is added, so that a writer looks
 * once, at the end.
 */
#ifndef TEMPLATE_C_TEXT_H
#define TEMPLATE_C_TEXT_H

#include <stdbool.h>
#include <stddef.h>

/* Starts as {0}. The owner gives `bytes` to free(). */
struct text {
    char *bytes; /* null while empty; no zero byte at the end */
    size_t len;  /* bytes */
    size_t room; /* bytes */
    bool failed;
};

void add(struct text *text, const char *bytes, size_t len);

/* Up to the zero byte. */
void add_text(struct text *text, const char *zero_ended);

void add_count(struct text *text, size_t count);

/* As a text of JSON, in quotation marks. The bytes are UTF-8. */
void add_quoted(struct text *text, const char *bytes, size_t len);

/* Without control characters (below U+0020, U+007F to U+009F), so that it cannot end a line. The bytes are
   UTF-8. */
void add_one_line(struct text *text, const char *bytes, size_t len);

/* Whether add_one_line would add all of it. */
bool is_one_line(const char *bytes, size_t len);

#endif
