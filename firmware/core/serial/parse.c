#include "serial/parse.h"

#include "common/codes.h"
#include "common/compiler.h"

/* Reads a number from 0 to 4294967295. Gives its end, or null when there is none. */
static const char *natural(const char *text, uint32_t *value)
{
    const char *start = text;
    uint32_t sum = 0;
    for (; *text >= '0' && *text <= '9'; text++) {
        uint8_t digit = (uint8_t)(*text - '0');
        if (sum > (UINT32_MAX - digit) / 10) {
            return 0;
        }
        sum = sum * 10 + digit;
    }
    if (text == start || (*start == '0' && text - start > 1)) {
        return 0;
    }
    *value = sum;
    return text;
}

/* Reads a number from -2147483647 to 2147483647: the smallest number of 32 bits has no opposite. */
static const char *integer(const char *text, int32_t *value)
{
    bool negative = *text == '-';
    uint32_t size;
    text = natural(text + negative, &size);
    if (!text || size > INT32_MAX || (negative && size == 0)) {
        return 0;
    }
    *value = negative ? -(int32_t)size : (int32_t)size;
    return text;
}

enum wb_parsed wb_parse(const char *payload, struct wb_command *command)
{
    struct form {
        char letter;    /* letter of the command */
        bool numbered;  /* flag: it is a line, and begins with its number */
        uint8_t fields; /* numbers after that */
        uint8_t more;   /* numbers after those that may be left out: then they are 0 */
    };
    static const WB_FLASH struct form FORMS[] = {
        {WB_COMMAND_MOVE, true, 3, 1},           {WB_COMMAND_DRY, true, 3, 0},
        {WB_COMMAND_HOME, true, 0, 0},           {WB_COMMAND_PEG, true, 1, 0},
        {WB_COMMAND_PAUSE, false, 0, 0},         {WB_COMMAND_RESUME, false, 0, 0},
        {WB_COMMAND_HEAD, false, 1, 0},          {WB_COMMAND_READ_SETTING, false, 1, 0},
        {WB_COMMAND_WRITE_SETTING, false, 2, 0}, {WB_COMMAND_LOAD_DEFAULTS, false, 0, 0},
        {WB_COMMAND_QUERY, false, 0, 0},         {WB_COMMAND_SESSION, false, 1, 0},
        {WB_COMMAND_RELEASE, false, 0, 0},       {WB_COMMAND_SPEED, false, 0, 1},
    };
    uint8_t form = 0;
    while (FORMS[form].letter != *payload) {
        if (++form == sizeof FORMS / sizeof FORMS[0]) {
            return WB_PARSE_UNKNOWN;
        }
    }
    command->letter = *payload++;
    command->n = 0;
    bool first = true;
    if (FORMS[form].numbered) {
        payload = natural(payload, &command->n);
        if (!payload || command->n == 0) {
            return WB_PARSE_RANGE;
        }
        first = false;
    }
    for (uint8_t i = 0; i < FORMS[form].fields + FORMS[form].more; i++) {
        if (i >= FORMS[form].fields && !*payload) {
            command->field[i] = 0;
            continue;
        }
        if (!first && *payload++ != ',') {
            return WB_PARSE_RANGE;
        }
        first = false;
        payload = integer(payload, &command->field[i]);
        if (!payload) {
            return WB_PARSE_RANGE;
        }
    }
    return *payload ? WB_PARSE_RANGE : WB_PARSED;
}
