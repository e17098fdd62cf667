/* What the host asks for: each command, its checks and its answer. */
#ifndef WB_COMMANDS_H
#define WB_COMMANDS_H

#include <stdint.h>

#include "controller.h"
#include "serial/parse.h"

/* Carries out a command and answers it. Gives the error with which it is refused, or 0 when it was answered. */
uint8_t wb_dispatch(struct wb_controller *controller, const struct wb_command *command);

#endif
