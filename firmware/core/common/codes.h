/* Made by `cargo xtask generate` from firmware/protocol/codes.csv and settings.csv: change those. */
#ifndef WB_CODES_H
#define WB_CODES_H

#define WB_COMMAND_SESSION 'S' /* Opens the session with this id of 1 to 65534; the same id again changes nothing. Sealed with 65535 */
#define WB_COMMAND_QUERY 'Q' /* Asks for the status */
#define WB_COMMAND_MOVE 'M' /* Line n: feeds, rotates, then bends. All in steps: feed and rotation are relative, the bend goes from zero to its angle and back. The peg comes out at `approach`, or at the near side of the same sign where that is farther, and bends to the other side; since firmware 1.13 the bend may so end at zero or before it, short of where the peg came out. `approach` may be left out or 0, and is since firmware 1.11: the bend is then to the side of its sign */
#define WB_COMMAND_DRY 'Y' /* Line n: a dry-run move. As a move, but the peg stays in, the bend axis goes to its angle and back, and each axis moves at a quarter of its speed, not below 31 steps/s. Since firmware 1.12 */
#define WB_COMMAND_HOME 'H' /* Line n: homes the bend axis, then moves it to zero */
#define WB_COMMAND_PEG 'K' /* Line n: the peg in (0) or out (1) */
#define WB_COMMAND_SPEED 'U' /* Sets the speed override: moves that begin from now on have so many percent of their speed, 10 to 100. Without a number, or with 0, it is asked for. Homing has speeds of its own. A new session begins with 100. Since firmware 1.12 */
#define WB_COMMAND_PAUSE 'P' /* Feed hold: slows down and holds */
#define WB_COMMAND_RESUME 'G' /* Leaves the hold */
#define WB_COMMAND_HEAD 'Z' /* Sets the position of the head; only when idle */
#define WB_COMMAND_READ_SETTING 'C' /* Reads a setting */
#define WB_COMMAND_WRITE_SETTING 'W' /* Writes a setting and stores it; only when idle */
#define WB_COMMAND_LOAD_DEFAULTS 'L' /* Stores the compiled-in settings, and answers with the first; only when idle */
#define WB_COMMAND_RELEASE 'R' /* Turns the motor drivers off; only when idle. Home the machine afterwards */

#define WB_REPLY_BOOT 'b' /* The controller has started. Sealed with 65535 */
#define WB_REPLY_OPEN 'o' /* The session with this id is open. Sealed with 65535 */
#define WB_REPLY_ACCEPTED 'a' /* Every line up to this number is accepted; so many more fit */
#define WB_REPLY_DONE 'd' /* Every line up to this number is done, or was dropped by an alarm */
#define WB_REPLY_FULL 'f' /* No room for the line: send it again */
#define WB_REPLY_REFUSED 'e' /* Refused, with an error; the number that is expected next; the code of the letter that was refused, or 0 for a line that cannot be read. Sealed with 65535 when it answers a session command */
#define WB_REPLY_STATUS 't' /* The status: positions in steps; peg 0 in, 1 out, 2 unknown */
#define WB_REPLY_VALUE 'v' /* A setting */
#define WB_REPLY_SPEED 'i' /* The speed override, percent */
#define WB_REPLY_ALARM 'x' /* Stopped with this alarm; also the answer to STOP */

#define WB_ERROR_NOT_IDLE 1 /* Possible only when idle */
#define WB_ERROR_RANGE 2 /* Wrong format or out of range */
#define WB_ERROR_IN_ALARM 3 /* An alarm is latched: home the machine */
#define WB_ERROR_UNKNOWN 4 /* No such command or setting */
#define WB_ERROR_NOT_HOMED 5 /* The machine is not homed */
#define WB_ERROR_SOFT_LIMIT 6 /* Beyond the soft limit of the axis */
#define WB_ERROR_SETTINGS 7 /* The stored settings are damaged or of another version: nothing moves */
#define WB_ERROR_DAMAGED 8 /* The line came damaged: send it again from the next number */
#define WB_ERROR_GAP 9 /* The number is not the next one */
#define WB_ERROR_NO_SESSION 10 /* No session is open */
#define WB_ERROR_HOLD_INPUT 11 /* The hold input is open: close it, then resume */
#define WB_ERROR_EMERGENCY 12 /* The emergency stop is pressed: release it first */

#define WB_ALARM_NONE 0 /* None */
#define WB_ALARM_STOP 1 /* Stopped by the STOP byte */
#define WB_ALARM_LIMIT 2 /* The switch of the bend axis was pressed, or its wire is broken */
#define WB_ALARM_HOMING 3 /* Homing failed: the switch was not found within its travel and time, or sticks */
#define WB_ALARM_WATCHDOG 4 /* The controller hung and its watchdog restarted it */
#define WB_ALARM_HOST_LOST 5 /* No valid frame for a second: holds after the running line; left by resume */
#define WB_ALARM_LATE_PULSE 6 /* A step pulse came too late */
#define WB_ALARM_EMERGENCY 7 /* The emergency stop is pressed, or its sense wire is broken */
#define WB_ALARM_HOLD_INPUT 8 /* The hold input is open: holds; close it, then resume */

#define WB_STATE_IDLE 0 /* No line runs or waits */
#define WB_STATE_RUN 1 /* Runs a line */
#define WB_STATE_HOLD 2 /* Holds */
#define WB_STATE_ALARM 3 /* An alarm is latched */

#define WB_RESET_POWER_ON 0 /* Power came on */
#define WB_RESET_EXTERNAL 1 /* The reset pin; also when a port is opened */
#define WB_RESET_BROWN_OUT 2 /* The voltage was too low */
#define WB_RESET_WATCHDOG 3 /* The watchdog */

#define WB_MACHINE_WIREBEND_KIT 1 /* The WireBend-kit bender: Arduino Uno with a CNC Shield V3 */
#define WB_MACHINE_HOWTOMECHATRONICS 2 /* The bender of howtomechatronics.com: Arduino Uno and three drivers */

#define WB_SETTINGS_COUNT 26
#define WB_SETTING_FEED_STEPS_PER_M 1 /* steps/m: Steps of the feed motors per metre of wire */
#define WB_SETTING_ROTATE_STEPS_PER_REV 2 /* steps/rev: Steps of the head per turn */
#define WB_SETTING_BEND_STEPS_PER_REV 3 /* steps/rev: Steps of the bend axis per turn */
#define WB_SETTING_FEED_RATE 4 /* steps/s: Speed of the feed */
#define WB_SETTING_ROTATE_RATE 5 /* steps/s: Speed of the head */
#define WB_SETTING_BEND_RATE 6 /* steps/s: Speed of the bend axis */
#define WB_SETTING_FEED_ACCELERATION 7 /* steps/s²: Acceleration of the feed */
#define WB_SETTING_ROTATE_ACCELERATION 8 /* steps/s²: Acceleration of the head */
#define WB_SETTING_BEND_ACCELERATION 9 /* steps/s²: Acceleration of the bend axis */
#define WB_SETTING_FEED_MOST 10 /* steps: Longest feed of one line */
#define WB_SETTING_ROTATE_LIMIT 11 /* steps: Soft limit of the head to either side */
#define WB_SETTING_BEND_LIMIT 12 /* steps: Soft limit of the bend axis to either side */
#define WB_SETTING_NEAR_SIDE 13 /* steps: How far before zero the peg comes out, on the side from which it bends */
#define WB_SETTING_BACK_OFF 14 /* steps: How far the peg moves back from the wire before it goes in */
#define WB_SETTING_PEG_IN_US 15 /* µs: Servo pulse width with the peg in */
#define WB_SETTING_PEG_OUT_US 16 /* µs: Servo pulse width with the peg out */
#define WB_SETTING_PEG_TIME_MS 17 /* ms: Time that the peg needs to move */
#define WB_SETTING_HOME_POSITION 18 /* steps: Position of the bend axis at the edge of its switch; the sign says on which side it is */
#define WB_SETTING_HOME_FAST_RATE 19 /* steps/s: Homing: speed of the first, fast approach */
#define WB_SETTING_HOME_SLOW_RATE 20 /* steps/s: Homing: speed of the second, slow approach */
#define WB_SETTING_HOME_BACK_OFF 21 /* steps: Homing: pull-off from the switch between the two approaches */
#define WB_SETTING_HOME_TRAVEL 22 /* steps: Homing: longest travel of an approach */
#define WB_SETTING_HOME_TIME_MS 23 /* ms: Homing: longest time */
#define WB_SETTING_INVERTED 24 /* bits: Inverted: 1 feed, 2 rotate, 4 bend, 8 switch (normally open) */
#define WB_SETTING_RELEASE_S 25 /* s: Idle time after which the motor drivers are turned off; 0 never */
#define WB_SETTING_INPUTS 26 /* bits: Inputs that are wired, with normally closed contacts: 1 hold, 2 emergency stop */

#define WB_SETTINGS_RANGES \
    {1000, 1000000}, \
    {200, 1000000}, \
    {200, 1000000}, \
    {31, 8000}, \
    {31, 8000}, \
    {31, 8000}, \
    {1000, 400000}, \
    {1000, 400000}, \
    {1000, 400000}, \
    {1000, 10000000}, \
    {100, 10000000}, \
    {100, 1000000}, \
    {1, 100000}, \
    {0, 100000}, \
    {512, 2500}, \
    {512, 2500}, \
    {20, 5000}, \
    {-1000000, 1000000}, \
    {31, 8000}, \
    {31, 8000}, \
    {1, 100000}, \
    {100, 1000000}, \
    {1000, 600000}, \
    {0, 15}, \
    {0, 36000}, \
    {0, 3}

#define WB_INVERTED_FEED 1
#define WB_INVERTED_ROTATE 2
#define WB_INVERTED_BEND 4
#define WB_INVERTED_SWITCH 8

#endif
