#include "serial/session.h"

#include "common/codes.h"
#include "serial/frame.h"
#include "hal.h"

/* A host asks for the status four times a second. */
#define HOST_LOST_TICKS ((uint16_t)(1000000uL / WB_TICK_US))

uint8_t wb_session_open(struct wb_session *session, int32_t id, bool busy)
{
    if (id < 1 || id >= (int32_t)WB_NO_SESSION) {
        return WB_ERROR_RANGE;
    }
    if (id != session->id) {
        if (busy) {
            return WB_ERROR_NOT_IDLE;
        }
        session->id = (uint16_t)id;
        session->accepted = 0;
        session->done = 0;
        session->done_pending = false;
    }
    return 0;
}

enum wb_order wb_session_order(const struct wb_session *session, uint32_t n)
{
    if (n <= session->accepted) {
        return WB_ORDER_REPEATED;
    }
    return n - session->accepted > 1 ? WB_ORDER_GAP : WB_ORDER_NEXT;
}

void wb_session_done(struct wb_session *session, uint32_t n)
{
    session->done = n;
    session->done_pending = true;
}

bool wb_session_host_lost(struct wb_session *session, uint16_t now, bool busy)
{
    if (!busy) {
        session->heard_at = now;
        return false;
    }
    return (uint16_t)(now - session->heard_at) > HOST_LOST_TICKS;
}
