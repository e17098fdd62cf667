//! What grbl's numbers mean: errors and alarms of version 1.1, after `doc/csv` of github.com/gnea/grbl.

/// What an `error:N` says and what to do.
pub(crate) const fn error(code: u32) -> (&'static str, &'static str) {
    const PROGRAM: &str = "look at the line, and at the blocks and pin commands in the driver's settings";
    const SETTINGS: &str = "change the machine's setting, or the driver's";
    match code {
        1 => ("a word has no letter", PROGRAM),
        2 => ("a number is missing or has the wrong form", PROGRAM),
        3 => ("a '$' command is not known to this controller", "see which version it runs"),
        4 => ("a value is below zero and may not be", PROGRAM),
        5 => ("homing is switched off", "set $22=1, or \"homing\": \"none\" for a machine without switches"),
        6 => ("the step pulse is too short", SETTINGS),
        7 => ("the controller could not read its settings and has taken defaults", "set all of $$ again"),
        8 => ("the command is possible at rest only", "stop, then try again"),
        9 => ("G-code is locked by an alarm or a jog", "home the machine"),
        10 => ("soft limits need homing", "set $22=1 or $20=0"),
        11 => ("the line is too long", "shorten the lines of the blocks"),
        12 => ("the setting asks for more steps a second than possible", SETTINGS),
        13 => ("the safety door is open", "close it"),
        14 => ("the line is too long to be stored", SETTINGS),
        15 => ("the jog goes beyond the machine's travel", "jog less far, or home the machine"),
        16 => ("the jog command is not understood", "see whether the axis letters are the machine's"),
        17 => ("laser mode needs a PWM output", "set $32=0"),
        20 => ("a command or an axis letter is not supported", "stock grbl has the axes X, Y and Z"),
        21 => ("two commands of one group are in the line", PROGRAM),
        22 => ("no feed rate has been set", PROGRAM),
        23 => ("a command needs a whole number", PROGRAM),
        24 => ("two commands of the line need axis words", PROGRAM),
        25 => ("a word is in the line twice", PROGRAM),
        26 => ("axis words are missing", PROGRAM),
        27 => ("the line number is out of range", "switch 'line_numbers' off"),
        28 => ("a command lacks one of its values", PROGRAM),
        29 => ("the coordinate system does not exist", PROGRAM),
        30 => ("G53 needs G0 or G1", PROGRAM),
        31 => ("axis words are there that no command uses", PROGRAM),
        32 | 35 => ("an arc lacks words of its plane", PROGRAM),
        33 => ("the target of the motion is not possible", PROGRAM),
        34 => ("the radius of an arc is not possible", PROGRAM),
        36 => ("words are there that no command uses", PROGRAM),
        37 => ("the tool length offset is of another axis", PROGRAM),
        38 => ("the tool number is too large", PROGRAM),
        _ => ("this number is not grbl's", "look it up in the manual of the controller's firmware"),
    }
}

/// What an `ALARM:N` says and what to do.
pub(crate) const fn alarm(code: u32) -> (&'static str, &'static str) {
    match code {
        1 => ("a limit switch was hit", "see what it ran into, clear it, then home"),
        2 => ("the target is beyond the machine's travel", "see $130 to $132 and the limits of the profile"),
        3 => ("it was reset while it moved", "steps may be lost: home the machine"),
        4 => ("the probe is not in the state that it should start from", "take probing out of the blocks"),
        5 => ("the probe touched nothing", "take probing out of the blocks"),
        6 => ("it was reset while it homed", "home again"),
        7 => ("the safety door was opened while it homed", "close it, then home again"),
        8 => ("the switch was still pressed after pulling off", "raise $27, or check the switch's wiring"),
        9 => ("no switch was found within the travel", "raise $130 to $132, or check the switches' wiring"),
        _ => ("this number is not grbl's", "look it up in the manual of the controller's firmware"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_number_of_version_1_1_has_a_meaning_of_its_own() {
        let unknown = error(0).0;
        // 18 and 19 were never given out.
        let errors = (1..=17).chain(20..=38);
        assert!(errors.clone().all(|code| error(code).0 != unknown));
        assert!((1..=9).all(|code| alarm(code).0 != unknown));
        assert_eq!((error(18).0, error(39).0, alarm(10).0), (unknown, unknown, unknown));
    }
}
