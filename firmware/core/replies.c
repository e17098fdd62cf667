#include "replies.h"

#include "frame.h"
#include "hal.h"
#include "homing.h"

void wb_tell_one(struct wb_controller *c, char letter, uint32_t one)
{
    struct wb_reply reply = wb_reply_begin(c->board, letter, c->session);
    wb_reply_unsigned(&reply, one);
    wb_reply_end(&reply);
}

void wb_tell_taken(struct wb_controller *c, char letter)
{
    struct wb_reply reply = wb_reply_begin(c->board, letter, c->session);
    wb_reply_unsigned(&reply, c->last);
    wb_reply_unsigned(&reply, (uint32_t)(WB_QUEUE - c->queued));
    wb_reply_end(&reply);
}

static void tell_versions(struct wb_reply *reply)
{
    wb_reply_unsigned(reply, WB_PROTOCOL);
    wb_reply_unsigned(reply, WB_FIRMWARE);
    wb_reply_unsigned(reply, WB_MACHINE_ID);
}

void wb_tell_boot(struct wb_controller *c)
{
    struct wb_reply reply = wb_reply_begin(c->board, WB_REPLY_BOOT, WB_NO_SESSION);
    tell_versions(&reply);
    wb_reply_unsigned(&reply, c->reset);
    wb_reply_unsigned(&reply, c->boots);
    wb_reply_end(&reply);
}

void wb_tell_open(struct wb_controller *c)
{
    struct wb_reply reply = wb_reply_begin(c->board, WB_REPLY_OPEN, WB_NO_SESSION);
    wb_reply_unsigned(&reply, c->session);
    wb_reply_unsigned(&reply, c->last);
    wb_reply_unsigned(&reply, c->done);
    tell_versions(&reply);
    wb_reply_unsigned(&reply, c->boots);
    wb_reply_end(&reply);
}

void wb_tell_status(struct wb_controller *c)
{
    int32_t position[WB_AXES];
    hal_lock(c->board);
    for (uint8_t axis = 0; axis < WB_AXES; axis++) {
        position[axis] = c->stepper.position[axis];
    }
    hal_unlock(c->board);
    struct wb_reply reply = wb_reply_begin(c->board, WB_REPLY_STATUS, c->session);
    wb_reply_unsigned(&reply, wb_state(c));
    wb_reply_unsigned(&reply, c->alarm);
    for (uint8_t axis = 0; axis < WB_AXES; axis++) {
        wb_reply_signed(&reply, position[axis]);
    }
    wb_reply_unsigned(&reply, c->last);
    wb_reply_unsigned(&reply, c->done);
    wb_reply_unsigned(&reply, c->peg);
    wb_reply_unsigned(&reply, wb_switch_pressed(c));
    wb_reply_unsigned(&reply, c->homed);
    wb_reply_end(&reply);
}

void wb_tell_setting(struct wb_controller *c, uint8_t id)
{
    struct wb_reply reply = wb_reply_begin(c->board, WB_REPLY_VALUE, c->session);
    wb_reply_unsigned(&reply, id);
    wb_reply_signed(&reply, wb_setting(&c->settings, id));
    wb_reply_end(&reply);
}

void wb_tell_refusal(struct wb_controller *c, uint8_t error, char command)
{
    /* Who asks for a session is in none, and could not read what is sealed with that of another host. */
    uint16_t session = command == WB_COMMAND_SESSION ? WB_NO_SESSION : c->session;
    struct wb_reply reply = wb_reply_begin(c->board, WB_REPLY_REFUSED, session);
    wb_reply_unsigned(&reply, error);
    wb_reply_unsigned(&reply, c->last + 1);
    wb_reply_unsigned(&reply, (uint8_t)command);
    wb_reply_end(&reply);
}
