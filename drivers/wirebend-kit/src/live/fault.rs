//! What a person reads when something is not as it should be.

use wirebend_driver_api::{Capability, DriverError, Lack, SettingCheck};

use crate::protocol::{Alarm, Machine, Refusal, SETTINGS, VERSION, Versions};

pub(super) fn identity(versions: Option<Versions>) -> String {
    match versions {
        Some(Versions { firmware, machine, .. }) => {
            format!("{}, firmware {}.{:02}", built_for(machine), firmware / 100, firmware % 100)
        }
        None => "WireBend-kit, in the session of before".to_owned(),
    }
}

fn machine(code: u32) -> Option<Machine> {
    u8::try_from(code).ok().and_then(Machine::of)
}

fn built_for(code: u32) -> String {
    match machine(code) {
        Some(Machine::WirebendKit) => "WireBend-kit".to_owned(),
        Some(Machine::Howtomechatronics) => "HowToMechatronics".to_owned(),
        None => format!("machine {code}"),
    }
}

pub(super) fn busy(what: &str, why: &str) -> DriverError {
    DriverError::new(
        "busy",
        format!("the machine cannot {what} now: {why}"),
        "wait until it is idle, or stop it",
    )
}

pub(super) fn gap(given: u32, n: u32) -> DriverError {
    DriverError::new("gap", format!("step {n} does not follow step {given}"), "send the steps in order")
}

pub(super) fn beyond(n: u32, what: &str, value: f64, max: f64, unit: &str) -> DriverError {
    let step = if n == 0 { String::new() } else { format!(" of step {n}") };
    DriverError::new(
        "beyond",
        format!("the {what}{step} of {value:.3}{unit} is beyond the machine's {max:.3}{unit}"),
        "plan the design for this machine, or correct the limits in its profile",
    )
}

pub(super) fn bends_nothing(n: u32, approach: f64, bend: f64) -> DriverError {
    DriverError::new(
        "other-side",
        format!(
            "in step {n} the peg would come out at {approach:.1}° for a bend to {bend:.1}°: it has to come out on the other side of \
             zero, or farther from it"
        ),
        "plan the design again",
    )
}

pub(super) fn cannot_approach(n: u32, deg: f64, versions: Versions) -> DriverError {
    DriverError::new(
        "older-firmware",
        format!(
            "in step {n} the peg has to come out at {deg:.1}°, beside wire that is bent already, and firmware {}.{:02} cannot be told so",
            versions.firmware / 100,
            versions.firmware % 100
        ),
        "flash the firmware of this program: firmware/README.md says how; or lengthen the edge before the bend",
    )
}

pub(super) fn cannot_end_before_zero(n: u32, deg: f64, versions: Versions) -> DriverError {
    DriverError::new(
        "older-firmware",
        format!(
            "in step {n} the bend axis stops before zero, at {deg:.1}°, and firmware {}.{:02} cannot be told to which side that is",
            versions.firmware / 100,
            versions.firmware % 100
        ),
        "flash the firmware of this program: firmware/README.md says how; or enlarge the bend",
    )
}

/// What a board with that firmware cannot.
pub(super) fn lacks_before_zero(versions: Versions) -> Lack {
    let (major, minor) = (versions.firmware / 100, versions.firmware % 100);
    Lack {
        capability: Capability::BeforeZero,
        reason: format!(
            "its firmware is {major}.{minor:02}, and 1.13 is the first that is told to which side it bends"
        ),
        help: "flash the firmware of this program: firmware/README.md says how; or enlarge the bend"
            .to_owned(),
    }
}

pub(super) fn no_faster() -> DriverError {
    DriverError::new(
        "no-faster",
        "the machine goes no faster than its settings say",
        "raise the speeds in the profile, and write its settings to the machine",
    )
}

pub(super) fn firmware_lacks(what: &str, versions: Versions) -> DriverError {
    DriverError::new(
        "older-firmware",
        format!("firmware {}.{:02} has no {what}", versions.firmware / 100, versions.firmware % 100),
        "flash the firmware of this program: firmware/README.md says how",
    )
}

pub(super) fn silent(connecting: bool) -> DriverError {
    if connecting {
        return DriverError::new(
            "no-answer",
            "nothing that speaks the WireBend-kit protocol answers at this port",
            "see whether it is the right port, whether the board has power, and whether it has this program's firmware: firmware/README.md says how to flash it",
        );
    }
    DriverError::new(
        "silent",
        "the machine has not answered for more than a second; if it hears nothing either, it finishes its step and holds",
        "look at the cable and at the board, then connect again",
    )
}

pub(super) fn unplugged() -> DriverError {
    DriverError::new(
        "unplugged",
        "the port is gone: the machine finishes its step and holds if it has power",
        "plug the cable in, then connect again",
    )
}

pub(super) fn other_version(versions: Versions) -> DriverError {
    DriverError::new(
        "other-version",
        format!(
            "the firmware speaks version {} of the protocol, this driver version {VERSION}",
            versions.protocol
        ),
        "flash the firmware that came with this program: firmware/README.md says how",
    )
}

pub(super) fn other_machine(found: u32, expected: u32) -> DriverError {
    let flash = match machine(expected) {
        Some(expected) => format!("make -C firmware flash MACHINE={} PORT=…", expected.name()),
        None => "make -C firmware flash MACHINE=… PORT=…, with the name of its file in firmware/machines"
            .to_owned(),
    };
    DriverError::new(
        "other-machine",
        format!(
            "the board has the firmware for {}, this profile wants that for {}: its motors and its servo are on other \
             pins, so nothing was moved or stored",
            built_for(found),
            built_for(expected)
        ),
        format!(
            "flash the firmware for the machine that is there ({flash}), or choose the profile of the machine that the \
             firmware was built for; 'firmware_machine' of the driver's settings says which one a profile wants"
        ),
    )
}

pub(super) fn other_host() -> DriverError {
    DriverError::new(
        "other-session",
        "the machine has lines of another session that it has not run",
        "resume the job that they belong to, or press the reset button of the board, and connect again",
    )
}

pub(super) fn head_beyond(deg: f64, max: f64) -> DriverError {
    DriverError::new(
        "head-beyond",
        format!("the head stands {deg}° from its zero, and its cable allows {max}° either way"),
        "switch the motors off and turn it back by hand",
    )
}

pub(super) fn restarted() -> DriverError {
    DriverError::new(
        "restarted",
        "the controller has started anew and does not know where its axes are",
        "look at its power and its cable, home the machine, and say whether the step in doubt was done",
    )
}

pub(super) fn refused(command: u8, error: Refusal, homing: bool) -> DriverError {
    let what = match command {
        b'H' => "to home",
        b'M' if homing => "to turn the head back",
        b'M' => "a step",
        b'Y' => "a dry-run move",
        b'U' => "the speed override",
        b'S' => "a new session",
        b'Z' => "the position of the head",
        _ => "a request",
    };
    let help = match error {
        Refusal::Settings => "write the settings of the profile to the machine",
        Refusal::NotHomed | Refusal::InAlarm => "home the machine",
        Refusal::Emergency => "release the emergency stop, then home the machine",
        Refusal::HoldInput => "close the door or release the feed hold, then try again",
        Refusal::SoftLimit => "turn the head back, or correct the limits of the axes",
        _ => "home the machine and try again",
    };
    DriverError::new("refused", format!("the machine refuses {what}: {}", error.meaning()), help)
}

pub(super) fn alarm(alarm: Alarm) -> DriverError {
    let help = match alarm {
        Alarm::Limit => "see what turned the bend axis to its switch, then home the machine",
        Alarm::Homing => "look at the switch and its wires, and at the direction of the bend axis",
        Alarm::Emergency => {
            "find out why it was pressed, release it, home the machine, and say whether the step in doubt was done"
        }
        Alarm::LatePulse => "lower the speeds in the profile, then home the machine",
        _ => "home the machine",
    };
    DriverError::new("alarm", format!("the machine has stopped: {}", alarm.meaning()), help)
}

pub(super) fn stopped_unasked() -> DriverError {
    DriverError::new(
        "stopped",
        "a STOP has reached the machine that this program did not send",
        "if no other program did, the line is disturbed: use a shorter, shielded cable away from the motors' wires",
    )
}

pub(super) fn host_lost() -> DriverError {
    DriverError::new(
        "host-lost",
        "the machine has heard nothing for a second and holds after its step",
        "look at the cable, then resume",
    )
}

pub(super) fn hold_input() -> DriverError {
    DriverError::new(
        "hold-input",
        "the hold input of the machine is open: it slows down and holds",
        "close the door or release the feed hold, check that no one is at the machine, then resume",
    )
}

pub(super) fn released() -> DriverError {
    DriverError::new(
        "released",
        "the machine has released its motors at rest, and does not know any more where its axes are",
        "home it before the next wire; 'release_after_s' of the driver's settings says after how long",
    )
}

pub(super) fn older_firmware(versions: Option<Versions>) -> DriverError {
    DriverError::new(
        "older-firmware",
        format!(
            "the board has an older firmware ({}): it lacks settings that this driver needs",
            identity(versions)
        ),
        "flash the firmware that came with this program: firmware/README.md says how; its settings are taken over",
    )
}

pub(super) fn not_stored(id: u8, value: i32, error: Refusal) -> DriverError {
    let name = SETTINGS.iter().find(|setting| setting.id == id).map_or("a setting", |setting| setting.name);
    DriverError::new(
        "not-stored",
        format!("the machine does not take {value} for '{name}': {}", error.meaning()),
        "correct the driver's settings in the machine's profile, and write them again",
    )
}

pub(super) fn settings_damaged() -> SettingCheck {
    SettingCheck {
        name: "stored settings".to_owned(),
        machine: "none, damaged, or of another version".to_owned(),
        expected: "those of the profile".to_owned(),
        matters: true,
    }
}
