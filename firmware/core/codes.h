/* Made by `cargo xtask generate` from firmware/protocol/codes.csv and settings.csv: change those. */
#ifndef WB_CODES_H
#define WB_CODES_H

#define WB_COMMAND_SESSION 'S' /* Opens the session with this id of 1 to 65534; the same id again changes nothing. Sealed with 65535 */
#define WB_COMMAND_QUERY 'Q' /* Asks for the status */
#define WB_COMMAND_MOVE 'M' /* Line n: feeds, then rotates, then bends; in steps, each from where it stands, the bend from zero and back to it */
#define WB_COMMAND_HOME 'H' /* Line n: lets the bend axis find its switch and go to zero */
#define WB_COMMAND_PEG 'K' /* Line n: the peg in (0) or out (1) */
#define WB_COMMAND_PAUSE 'P' /* Slows down and holds */
#define WB_COMMAND_GO_ON 'G' /* Leaves the hold */
#define WB_COMMAND_HEAD 'Z' /* Says where the head stands; at rest only */
#define WB_COMMAND_READ_SETTING 'C' /* Asks for a setting */
#define WB_COMMAND_WRITE_SETTING 'W' /* Changes a setting and stores it; at rest only */
#define WB_COMMAND_LOAD_DEFAULTS 'L' /* Stores the settings that were compiled in, and answers with the first; at rest only */
#define WB_COMMAND_RELEASE 'R' /* Turns the motor drivers off, at rest only: the machine has to be homed again */

#define WB_REPLY_BOOT 'b' /* Has started; sealed with 65535 */
#define WB_REPLY_OPEN 'o' /* The session with this id is open; sealed with 65535 */
#define WB_REPLY_ACCEPTED 'a' /* Every line up to this number is taken; so many more fit */
#define WB_REPLY_DONE 'd' /* Every line up to this number is made, or was forgotten by an alarm */
#define WB_REPLY_FULL 'f' /* No room for the line: to be sent again */
#define WB_REPLY_REFUSED 'e' /* Not taken; the number that is expected next; the code of the letter that was refused or 0 for a line that cannot be read. Sealed with 65535 when it was a session */
#define WB_REPLY_STATUS 't' /* How it stands; positions in steps; peg 0 in, 1 out, 2 unknown */
#define WB_REPLY_VALUE 'v' /* A setting */
#define WB_REPLY_ALARM 'x' /* Has stopped with this alarm; also the answer to STOP */

#define WB_ERROR_NOT_IDLE 1 /* Possible only at rest */
#define WB_ERROR_RANGE 2 /* Not of the form or out of the range that it must have */
#define WB_ERROR_IN_ALARM 3 /* An alarm is latched: home the machine */
#define WB_ERROR_UNKNOWN 4 /* No such command or setting */
#define WB_ERROR_NOT_HOMED 5 /* The bend axis has not found its switch */
#define WB_ERROR_SOFT_LIMIT 6 /* Beyond the range of the axis */
#define WB_ERROR_SETTINGS 7 /* The stored settings are damaged or of another version: nothing moves */
#define WB_ERROR_DAMAGED 8 /* The line came damaged: to be sent again from the next number */
#define WB_ERROR_GAP 9 /* The number is not the next one */
#define WB_ERROR_NO_SESSION 10 /* No session is open */
#define WB_ERROR_HOLD_INPUT 11 /* The hold input is open: close it and go on */
#define WB_ERROR_EMERGENCY 12 /* The emergency stop is pressed: release it first */

#define WB_ALARM_NONE 0 /* None */
#define WB_ALARM_STOP 1 /* Stopped by the STOP byte */
#define WB_ALARM_LIMIT 2 /* The switch of the bend axis was hit */
#define WB_ALARM_HOMING 3 /* The switch was not found within its travel and time */
#define WB_ALARM_WATCHDOG 4 /* The controller hung and was started again by its watchdog */
#define WB_ALARM_HOST_LOST 5 /* No valid frame for a second: holds after the running line; left by go-on */
#define WB_ALARM_LATE_PULSE 6 /* A step pulse came too late */
#define WB_ALARM_EMERGENCY 7 /* The emergency stop is pressed, or its sense wire is broken */
#define WB_ALARM_HOLD_INPUT 8 /* The hold input is open: holds, and is left by go-on once it is closed */

#define WB_STATE_IDLE 0 /* At rest */
#define WB_STATE_RUNNING 1 /* Makes a line */
#define WB_STATE_HELD 2 /* Holds */
#define WB_STATE_ALARM 3 /* An alarm is latched */

#define WB_RESET_POWER_ON 0 /* Power came on */
#define WB_RESET_EXTERNAL 1 /* The reset pin; also when a port is opened */
#define WB_RESET_BROWN_OUT 2 /* The voltage was too low */
#define WB_RESET_WATCHDOG 3 /* The watchdog */

#define WB_MACHINE_WIREBEND_KIT 1 /* The WireBend-kit bender: Arduino Uno with a CNC Shield V3 */
#define WB_MACHINE_HOWTOMECHATRONICS 2 /* The bender of howtomechatronics.com: Arduino Uno and three drivers */

#define WB_SETTINGS_COUNT 26
#define WB_SETTING_FEED_STEPS_PER_M 1 /* steps/m: Steps of the feed motors for a metre of wire */
#define WB_SETTING_ROTATE_STEPS_PER_REV 2 /* steps/rev: Steps of the head for a full turn */
#define WB_SETTING_BEND_STEPS_PER_REV 3 /* steps/rev: Steps of the bend axis for a full turn */
#define WB_SETTING_FEED_RATE 4 /* steps/s: Speed of the feed */
#define WB_SETTING_ROTATE_RATE 5 /* steps/s: Speed of the head */
#define WB_SETTING_BEND_RATE 6 /* steps/s: Speed of the bend axis */
#define WB_SETTING_FEED_ACCELERATION 7 /* steps/s²: Acceleration of the feed */
#define WB_SETTING_ROTATE_ACCELERATION 8 /* steps/s²: Acceleration of the head */
#define WB_SETTING_BEND_ACCELERATION 9 /* steps/s²: Acceleration of the bend axis */
#define WB_SETTING_FEED_MOST 10 /* steps: Longest feed of one line */
#define WB_SETTING_ROTATE_LIMIT 11 /* steps: How far the head may turn to either side */
#define WB_SETTING_BEND_LIMIT 12 /* steps: How far the bend axis may go to either side */
#define WB_SETTING_NEAR_SIDE 13 /* steps: Where the peg comes out: so far before zero on the side from which it bends */
#define WB_SETTING_BACK_OFF 14 /* steps: How far the peg goes back from the wire before it goes in */
#define WB_SETTING_PEG_IN_US 15 /* µs: Servo pulse with the peg in */
#define WB_SETTING_PEG_OUT_US 16 /* µs: Servo pulse with the peg out */
#define WB_SETTING_PEG_TIME_MS 17 /* ms: Time that the peg takes */
#define WB_SETTING_HOME_POSITION 18 /* steps: Where the bend axis stands at the edge of its switch; the sign says on which side */
#define WB_SETTING_HOME_FAST_RATE 19 /* steps/s: Speed of the first search */
#define WB_SETTING_HOME_SLOW_RATE 20 /* steps/s: Speed of the second search */
#define WB_SETTING_HOME_BACK_OFF 21 /* steps: Way back from the switch between the searches */
#define WB_SETTING_HOME_TRAVEL 22 /* steps: Longest way of a search */
#define WB_SETTING_HOME_TIME_MS 23 /* ms: Longest time of homing */
#define WB_SETTING_INVERTED 24 /* bits: Inverted: 1 feed, 2 rotate, 4 bend, 8 switch that closes when pressed */
#define WB_SETTING_RELEASE_S 25 /* s: Time at rest after which the motor drivers are turned off; 0 never */
#define WB_SETTING_INPUTS 26 /* bits: Inputs that are wired, by contacts that open: 1 hold, 2 emergency stop */

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
