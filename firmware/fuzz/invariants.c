#include "invariants.h"

#include <stdio.h>

/* The rules look into the controller too. */
#include "../hal_host/host.c"

/* Edge of the switch, steps, as in the settings below. */
#define EDGE (-220)

#define MUST(what)                                                                                        \
    do {                                                                                                  \
        if (!(what)) {                                                                                    \
            fprintf(stderr, "%s:%d: rule broken: %s\n", __FILE__, __LINE__, #what);                             \
            abort();                                                                                      \
        }                                                                                                 \
    } while (0)

static bool homing(const struct wb_motion *motion)
{
    return motion->phase == WB_PHASE_CLEAR_WIRE ||
           (motion->phase >= WB_PHASE_HOME_RELEASE && motion->phase <= WB_PHASE_HOME_ZERO);
}

static int32_t size(int32_t value)
{
    return value < 0 ? -value : value;
}

void world_look_at_switch(struct world *world)
{
    bool high = world->switch_mode < 2 ? world->switch_mode == 1 : world->bend <= EDGE;
    wb_host_switch(world->host, high);
}

/* Rules that hold between any two events. */
void world_check(struct world *world)
{
    const struct wb_host *host = world->host;
    const struct wb_controller *c = &host->controller;
    const struct wb_motion *motion = &c->motion;
    MUST(c->queue.count <= WB_QUEUE_LINES && c->queue.first < WB_QUEUE_LINES);
    MUST(c->session.done <= c->session.accepted);
    MUST(c->rx.in < WB_RX_BYTES && c->rx.out < WB_RX_BYTES);
    MUST(c->rx.frame.length <= WB_LINE_MAX);
    MUST((uint8_t)(host->send_in - host->send_out) < SEND_ROOM);
    MUST(motion->slower_by <= 100 - WB_SPEED_MIN);
    MUST(motion->phase <= WB_PHASE_PEG_MANUAL && c->safety.alarm <= WB_ALARM_HOLD_INPUT &&
         motion->peg.position <= WB_PEG_UNKNOWN);
    MUST(!motion->homed || (c->settings.good && motion->motors.on));
    MUST(motion->motors.on == host->motors);
    MUST(!motion->homed || !motion->peg.wire_side || wb_motion_active(motion));
    MUST(!motion->stepper.moving || wb_motion_active(motion));
    MUST(motion->stepper.moving == (host->step_at != NEVER));
    for (uint8_t axis = 0; axis < WB_AXES; axis++) {
        MUST(motion->stepper.position[axis] == world->pulses[axis] + world->offset[axis]);
    }
    if (world->stopped) {
        MUST(motion->homed == false);
    }
    /* Nothing stands still without saying why. */
    MUST(!motion->stepper.latched || wb_state(&c->safety, motion, &c->queue) == WB_STATE_ALARM);
}

/* Rules of a pulse that bends or backs off, after which the axis is at `position`. */
static void bends(const struct wb_controller *before, int32_t position)
{
    const struct wb_line *line = &before->motion.line;
    int32_t near = wb_setting(&before->settings, WB_SETTING_NEAR_SIDE);
    int32_t out = size(line->approach) > near ? size(line->approach) : near;
    int32_t side = before->motion.peg.wire_side;
    /* The peg bends away from where it came out, and no farther than it is told; it goes back no farther than there. */
    MUST(side == 1 || side == -1);
    MUST(line->approach == 0 ? side * line->bend > 0 : side * line->approach < 0);
    MUST(side * position >= -out);
    MUST(before->motion.phase != WB_PHASE_BEND || side * position <= side * line->bend);
}

/* Rules of a pulse; `before` is the controller before it. */
static void pulse(struct world *world, const struct wb_host_event *event, const struct wb_controller *before)
{
    const struct wb_controller *c = &world->host->controller;
    uint8_t axis = (uint8_t)event->value;
    MUST(axis < WB_AXES && axis == before->motion.stepper.move.axis);
    bool inverted = (wb_setting(&c->settings, WB_SETTING_INVERTED) >> axis & 1) != 0;
    world->pulses[axis] += (event->on != 0) != inverted ? 1 : -1;
    int32_t position = (int32_t)(world->pulses[axis] + world->offset[axis]);
    MUST(before->settings.good && world->host->motors);
    MUST(before->safety.alarm == WB_ALARM_NONE || before->safety.alarm == WB_ALARM_HOST_LOST ||
         before->safety.alarm == WB_ALARM_HOLD_INPUT);
    MUST(before->session.id != WB_NO_SESSION);
    MUST(before->motion.homed || homing(&before->motion));
    MUST(!world->stopped || homing(&before->motion));
    /* The peg is in while the wire moves, and while the bend axis is homed. */
    uint8_t phase = before->motion.phase;
    bool dry = before->motion.line.letter == WB_COMMAND_DRY;
    bool peg_out = (phase == WB_PHASE_BEND && !dry) || phase == WB_PHASE_BACK_OFF || phase == WB_PHASE_CLEAR_WIRE;
    MUST(peg_out || world->peg_us == wb_setting(&c->settings, WB_SETTING_PEG_IN_US));
    MUST(!peg_out || axis == WB_BEND);
    if (peg_out && phase != WB_PHASE_CLEAR_WIRE) {
        bends(before, position);
    }
    if (axis == WB_BEND) {
        world->bend += (event->on != 0) != inverted ? 1 : -1;
        world_look_at_switch(world);
        MUST(homing(&before->motion) || size(position) <= wb_setting(&c->settings, WB_SETTING_BEND_LIMIT));
    }
    if (axis == WB_ROTATE) {
        int32_t limit = wb_setting(&c->settings, WB_SETTING_ROTATE_LIMIT);
        MUST(size(position) <= limit || size(position) <= world->reach);
        world->reach = size(position);
    }
}

static void events(struct world *world, const struct wb_controller *before)
{
    static const char REPLIES[] = {WB_REPLY_BOOT, WB_REPLY_OPEN, WB_REPLY_ACCEPTED, WB_REPLY_DONE, WB_REPLY_FULL,
                                   WB_REPLY_REFUSED, WB_REPLY_STATUS, WB_REPLY_VALUE, WB_REPLY_ALARM,
                                   WB_REPLY_SPEED};
    struct wb_host_event event;
    while (wb_host_next(world->host, &event)) {
        switch (event.kind) {
        case WB_HOST_PULSE:
            pulse(world, &event, before);
            break;
        case WB_HOST_PEG:
            MUST(!world->stopped || world->host->controller.motion.phase == WB_PHASE_RETRACT);
            MUST(event.value >= 512 && event.value <= 2500);
            world->peg_us = event.value;
            break;
        case WB_HOST_SENT:
            MUST(event.value == '\n' || (event.value > ' ' && event.value <= '~'));
            MUST(!world->reply_ended || memchr(REPLIES, event.value, sizeof REPLIES));
            world->reply_ended = event.value == '\n';
            break;
        default:
            break;
        }
    }
}

/* A position changes without a pulse by homing and, when idle, by the command Z. */
static void follow(struct world *world, const struct wb_controller *before)
{
    const struct wb_controller *c = &world->host->controller;
    const struct wb_stepper *stepper = &c->motion.stepper;
    int64_t bend = stepper->position[WB_BEND] - world->pulses[WB_BEND];
    if (bend != world->offset[WB_BEND]) {
        MUST(before->motion.phase == WB_PHASE_HOME_LOCATE);
        MUST(stepper->position[WB_BEND] == wb_setting(&c->settings, WB_SETTING_HOME_POSITION));
        world->offset[WB_BEND] = bend;
    }
    int64_t rotate = stepper->position[WB_ROTATE] - world->pulses[WB_ROTATE];
    if (rotate != world->offset[WB_ROTATE]) {
        MUST(!wb_busy(&before->motion, &before->queue));
        world->offset[WB_ROTATE] = rotate;
    }
    if (!stepper->moving) {
        world->reach = size(stepper->position[WB_ROTATE]);
    }
    if (c->motion.homed) {
        MUST(before->motion.homed || wb_motion_active(&before->motion));
        world->stopped = world->stopped && before->motion.homed;
    }
}

void world_run(struct world *world, uint64_t until)
{
    struct wb_controller before = world->host->controller;
    while (interrupt(world->host, until)) {
        events(world, &before);
        follow(world, &before);
        world_check(world);
        before = world->host->controller;
    }
    world->host->now = until;
}

void world_receive(struct world *world, uint8_t byte, bool damaged)
{
    struct wb_controller before = world->host->controller;
    wb_host_receive(world->host, byte, damaged);
    if (byte == WB_STOP_BYTE) {
        world->stopped = true;
        MUST(!world->host->controller.motion.stepper.moving);
        MUST(world->host->controller.safety.alarm == WB_ALARM_STOP);
    }
    events(world, &before);
    follow(world, &before);
    world_check(world);
}

void world_reset(struct world *world, uint8_t cause)
{
    /* What was on its way out of the controller is lost with the reset. */
    world->reply_ended = true;
    world->stopped = false;
    world->peg_us = 0;
    wb_host_reset(world->host, cause);
    for (uint8_t axis = 0; axis < WB_AXES; axis++) {
        world->pulses[axis] = world->offset[axis] = 0;
    }
    world->reach = 0;
    world_check(world);
}

static void settings(struct world *world, uint16_t session)
{
    static const struct {
        uint8_t id;    /* id */
        int32_t value; /* number in the unit of the setting */
    } QUICK[] = {
        {WB_SETTING_NEAR_SIDE, 40},           {WB_SETTING_BEND_LIMIT, 200},
        {WB_SETTING_HOME_POSITION, EDGE},     {WB_SETTING_BACK_OFF, 20},
        {WB_SETTING_HOME_BACK_OFF, 12},       {WB_SETTING_HOME_TRAVEL, 600},
        {WB_SETTING_ROTATE_LIMIT, 300},       {WB_SETTING_PEG_TIME_MS, 20},
        {WB_SETTING_BEND_RATE, 8000},         {WB_SETTING_HOME_FAST_RATE, 4000},
        {WB_SETTING_HOME_SLOW_RATE, 2000},    {WB_SETTING_FEED_ACCELERATION, 400000},
        {WB_SETTING_ROTATE_ACCELERATION, 400000}, {WB_SETTING_BEND_ACCELERATION, 400000},
        {WB_SETTING_INPUTS, 3},               {WB_SETTING_RELEASE_S, 2},
    };
    struct wb_settings *stored = &world->host->controller.settings;
    wb_settings_defaults(stored, world->host);
    for (size_t i = 0; i < sizeof QUICK / sizeof QUICK[0]; i++) {
        bool known;
        MUST(wb_settings_change(stored, world->host, QUICK[i].id, QUICK[i].value, &known));
    }
    world_reset(world, WB_RESET_POWER_ON);
    world->host->controller.session.id = session;
}

void world_begin(struct world *world, uint16_t session)
{
    *world = (struct world){.host = wb_host_new(), .switch_mode = 2, .reply_ended = true};
    MUST(world->host);
    world_reset(world, WB_RESET_POWER_ON);
    world_look_at_switch(world);
    settings(world, session);
}

uint64_t world_now(const struct world *world)
{
    return world->host->now;
}

uint16_t world_session(const struct world *world)
{
    return world->host->controller.session.id;
}

uint32_t world_next(const struct world *world)
{
    return world->host->controller.session.accepted + 1;
}

void world_end(struct world *world)
{
    wb_host_free(world->host);
}
