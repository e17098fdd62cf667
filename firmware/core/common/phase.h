/* The phases of a line, in their order. A line skips those in which it has nothing to do. */
#ifndef WB_PHASE_H
#define WB_PHASE_H

enum wb_phase {
    WB_PHASE_NONE,       /* no line runs */
    WB_PHASE_CLEAR_WIRE, /* homing after a bend that was cut short: the peg leaves the wire the way it came */
    WB_PHASE_RETRACT,    /* the peg goes in before anything else moves */
    /* a move */
    WB_PHASE_FEED,
    WB_PHASE_ROTATE,
    WB_PHASE_APPROACH, /* the bend axis goes to the side of the wire from which the peg bends */
    WB_PHASE_PEG_OUT,
    WB_PHASE_BEND,
    WB_PHASE_BACK_OFF, /* away from the bent wire */
    WB_PHASE_PEG_IN,
    WB_PHASE_RETURN, /* the bend axis goes to zero */
    /* homing */
    WB_PHASE_HOME_RELEASE,  /* off the switch, if it is pressed */
    WB_PHASE_HOME_SEEK,     /* to the switch, fast */
    WB_PHASE_HOME_PULL_OFF, /* back from it */
    WB_PHASE_HOME_LOCATE,   /* to the switch, slowly */
    WB_PHASE_HOME_ZERO,     /* the bend axis goes to zero */
    /* the peg by hand */
    WB_PHASE_PEG_MANUAL
};

#endif
