/* What a frame asks for. */
#ifndef WB_PARSE_H
#define WB_PARSE_H

#include <stdbool.h>
#include <stdint.h>

/* The most numbers of a command. */
#define WB_FIELDS_MOST 4

struct wb_command {
    char letter;
    /* The line's number where the command is a line; else 0. */
    uint32_t n;
    /* The numbers after it, in their order. */
    int32_t field[WB_FIELDS_MOST];
};

enum wb_parsed { WB_PARSED, WB_PARSE_UNKNOWN, WB_PARSE_RANGE };

/* Reads a payload that ends with 0: decimal numbers without leading zeros or spaces, as many as the command
 * has. WB_PARSE_UNKNOWN for another letter, WB_PARSE_RANGE for other numbers. */
enum wb_parsed wb_parse(const char *payload, struct wb_command *command);

#endif
