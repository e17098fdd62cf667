/* The command in a frame. */
#ifndef WB_PARSE_H
#define WB_PARSE_H

#include <stdbool.h>
#include <stdint.h>

/* Most numbers of a command. */
#define WB_FIELDS_MAX 4

struct wb_command {
    char letter;                  /* letter: WB_COMMAND_... */
    uint32_t n;                   /* number of the line; 0 when the command is none */
    int32_t field[WB_FIELDS_MAX]; /* numbers after it, in units of the command */
};

enum wb_parsed { WB_PARSED, WB_PARSE_UNKNOWN, WB_PARSE_RANGE };

/* Reads a payload that is terminated by 0: a letter and as many decimal numbers as the command has, without leading
 * zeros or spaces. WB_PARSE_UNKNOWN for another letter, WB_PARSE_RANGE for other numbers. */
enum wb_parsed wb_parse(const char *payload, struct wb_command *command);

#endif
