#include "replies.h"

#include "hal.h"
#include "serial/reply.h"

void wb_send_number(void *board, const struct wb_session *session, char letter, uint32_t number)
{
    struct wb_reply reply = wb_reply_begin(board, letter, session->id);
    wb_reply_unsigned(&reply, number);
    wb_reply_end(&reply);
}

void wb_send_accepted(void *board, const struct wb_session *session, char letter, uint8_t free_lines)
{
    struct wb_reply reply = wb_reply_begin(board, letter, session->id);
    wb_reply_unsigned(&reply, session->accepted);
    wb_reply_unsigned(&reply, free_lines);
    wb_reply_end(&reply);
}

static void add_versions(struct wb_reply *reply)
{
    wb_reply_unsigned(reply, WB_PROTOCOL);
    wb_reply_unsigned(reply, WB_FIRMWARE);
    wb_reply_unsigned(reply, WB_MACHINE_ID);
}

void wb_send_boot(void *board, const struct wb_boot *boot)
{
    struct wb_reply reply = wb_reply_begin(board, WB_REPLY_BOOT, WB_NO_SESSION);
    add_versions(&reply);
    wb_reply_unsigned(&reply, boot->cause);
    wb_reply_unsigned(&reply, boot->count);
    wb_reply_end(&reply);
}

void wb_send_open(void *board, const struct wb_session *session, const struct wb_boot *boot)
{
    struct wb_reply reply = wb_reply_begin(board, WB_REPLY_OPEN, WB_NO_SESSION);
    wb_reply_unsigned(&reply, session->id);
    wb_reply_unsigned(&reply, session->accepted);
    wb_reply_unsigned(&reply, session->done);
    add_versions(&reply);
    wb_reply_unsigned(&reply, boot->count);
    wb_reply_end(&reply);
}

void wb_send_setting(void *board, const struct wb_session *session, const struct wb_settings *settings, uint8_t id)
{
    struct wb_reply reply = wb_reply_begin(board, WB_REPLY_VALUE, session->id);
    wb_reply_unsigned(&reply, id);
    wb_reply_signed(&reply, wb_setting(settings, id));
    wb_reply_end(&reply);
}

void wb_send_error(void *board, const struct wb_session *session, uint8_t error, char command)
{
    /* A host that asks for a session is in none, and could not read what is sealed with that of another host. */
    uint16_t seal = command == WB_COMMAND_SESSION ? WB_NO_SESSION : session->id;
    struct wb_reply reply = wb_reply_begin(board, WB_REPLY_REFUSED, seal);
    wb_reply_unsigned(&reply, error);
    wb_reply_unsigned(&reply, session->accepted + 1);
    wb_reply_unsigned(&reply, (uint8_t)command);
    wb_reply_end(&reply);
}

void wb_send_status(const struct wb_controller *c)
{
    int32_t position[WB_AXES];
    hal_lock(c->board);
    for (uint8_t axis = 0; axis < WB_AXES; axis++) {
        position[axis] = c->motion.stepper.position[axis];
    }
    hal_unlock(c->board);
    struct wb_reply reply = wb_reply_begin(c->board, WB_REPLY_STATUS, c->session.id);
    wb_reply_unsigned(&reply, wb_state(&c->safety, &c->motion, &c->queue));
    wb_reply_unsigned(&reply, c->safety.alarm);
    for (uint8_t axis = 0; axis < WB_AXES; axis++) {
        wb_reply_signed(&reply, position[axis]);
    }
    wb_reply_unsigned(&reply, c->session.accepted);
    wb_reply_unsigned(&reply, c->session.done);
    wb_reply_unsigned(&reply, c->motion.peg.position);
    wb_reply_unsigned(&reply, wb_switch_pressed(&c->settings, c->board));
    wb_reply_unsigned(&reply, c->motion.homed);
    wb_reply_end(&reply);
}
