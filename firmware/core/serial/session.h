/* The session with a host: its id, the numbers of its lines, and whether the host is still there.
 *
 * A line runs at most once: a new line has the number after the last accepted one. An earlier number is acknowledged
 * again, a later one is refused. */
#ifndef WB_SESSION_H
#define WB_SESSION_H

#include <stdbool.h>
#include <stdint.h>

enum wb_order {
    WB_ORDER_REPEATED, /* accepted before: acknowledged again, never run again */
    WB_ORDER_NEXT,
    WB_ORDER_GAP /* a line before it is missing */
};

struct wb_session {
    uint16_t id;       /* id: seals every frame; WB_NO_SESSION while none is open */
    uint32_t accepted; /* number of the last line that was accepted; 0 for none */
    uint32_t done;     /* number of the last line that is done; 0 for none */
    bool done_pending; /* flag: `done` was not reported to the host */
    uint16_t heard_at; /* 1.024 ms: time of the last valid frame */
};

/* Opens the session with this id. The id that is open changes nothing. Gives an error, or 0. */
uint8_t wb_session_open(struct wb_session *session, int32_t id, bool busy);
/* Where a line with this number belongs. */
enum wb_order wb_session_order(const struct wb_session *session, uint32_t n);
/* The running line is done. */
void wb_session_done(struct wb_session *session, uint32_t n);
/* Whether the host has been silent for a second while it is needed. `now` in ticks of 1.024 ms. */
bool wb_session_host_lost(struct wb_session *session, uint16_t now, bool busy);

#endif
