//! Codes of the wire protocol.
//!
//! Made by `cargo xtask generate` from firmware/protocol/codes.csv and settings.csv: change those.

/// What the controller is asked.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(u8)]
pub enum Command {
    /// Opens the session with this id of 1 to 65534; the same id again changes nothing. Sealed with 65535.
    Session = b'S',
    /// Asks for the status.
    Query = b'Q',
    /// Line n: feeds, then rotates, then bends; in steps, each from where it stands, the bend from zero and back to it.
    Move = b'M',
    /// Line n: lets the bend axis find its switch and go to zero.
    Home = b'H',
    /// Line n: the peg in (0) or out (1).
    Peg = b'K',
    /// Slows down and holds.
    Pause = b'P',
    /// Leaves the hold.
    GoOn = b'G',
    /// Says where the head stands; at rest only.
    Head = b'Z',
    /// Asks for a setting.
    ReadSetting = b'C',
    /// Changes a setting and stores it; at rest only.
    WriteSetting = b'W',
    /// Stores the settings that were compiled in, and answers with the first; at rest only.
    LoadDefaults = b'L',
    /// Turns the motor drivers off, at rest only: the machine has to be homed again.
    Release = b'R',
}

impl Command {
    /// The one with this code.
    #[must_use]
    pub const fn of(code: u8) -> Option<Self> {
        Some(match code {
            b'S' => Self::Session,
            b'Q' => Self::Query,
            b'M' => Self::Move,
            b'H' => Self::Home,
            b'K' => Self::Peg,
            b'P' => Self::Pause,
            b'G' => Self::GoOn,
            b'Z' => Self::Head,
            b'C' => Self::ReadSetting,
            b'W' => Self::WriteSetting,
            b'L' => Self::LoadDefaults,
            b'R' => Self::Release,
            _ => return None,
        })
    }
}

/// What it answers, and what it says unasked.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(u8)]
pub enum Reply {
    /// Has started; sealed with 65535.
    Boot = b'b',
    /// The session with this id is open; sealed with 65535.
    Open = b'o',
    /// Every line up to this number is taken; so many more fit.
    Accepted = b'a',
    /// Every line up to this number is made, or was forgotten by an alarm.
    Done = b'd',
    /// No room for the line: to be sent again.
    Full = b'f',
    /// Not taken; the number that is expected next; the code of the letter that was refused or 0 for a line that cannot be read. Sealed with 65535 when it was a session.
    Refused = b'e',
    /// How it stands; positions in steps; peg 0 in, 1 out, 2 unknown.
    Status = b't',
    /// A setting.
    Value = b'v',
    /// Has stopped with this alarm; also the answer to STOP.
    Alarm = b'x',
}

impl Reply {
    /// The one with this code.
    #[must_use]
    pub const fn of(code: u8) -> Option<Self> {
        Some(match code {
            b'b' => Self::Boot,
            b'o' => Self::Open,
            b'a' => Self::Accepted,
            b'd' => Self::Done,
            b'f' => Self::Full,
            b'e' => Self::Refused,
            b't' => Self::Status,
            b'v' => Self::Value,
            b'x' => Self::Alarm,
            _ => return None,
        })
    }
}

/// Why it does not do what it was asked.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(u8)]
pub enum Refusal {
    /// Possible only at rest.
    NotIdle = 1,
    /// Not of the form or out of the range that it must have.
    Range = 2,
    /// An alarm is latched: home the machine.
    InAlarm = 3,
    /// No such command or setting.
    Unknown = 4,
    /// The bend axis has not found its switch.
    NotHomed = 5,
    /// Beyond the range of the axis.
    SoftLimit = 6,
    /// The stored settings are damaged or of another version: nothing moves.
    Settings = 7,
    /// The line came damaged: to be sent again from the next number.
    Damaged = 8,
    /// The number is not the next one.
    Gap = 9,
    /// No session is open.
    NoSession = 10,
    /// The hold input is open: close it and go on.
    HoldInput = 11,
    /// The emergency stop is pressed: release it first.
    Emergency = 12,
}

impl Refusal {
    /// The one with this code.
    #[must_use]
    pub const fn of(code: u8) -> Option<Self> {
        Some(match code {
            1 => Self::NotIdle,
            2 => Self::Range,
            3 => Self::InAlarm,
            4 => Self::Unknown,
            5 => Self::NotHomed,
            6 => Self::SoftLimit,
            7 => Self::Settings,
            8 => Self::Damaged,
            9 => Self::Gap,
            10 => Self::NoSession,
            11 => Self::HoldInput,
            12 => Self::Emergency,
            _ => return None,
        })
    }

    /// For a person.
    #[must_use]
    pub const fn meaning(self) -> &'static str {
        match self {
            Self::NotIdle => "possible only at rest",
            Self::Range => "not of the form or out of the range that it must have",
            Self::InAlarm => "an alarm is latched: home the machine",
            Self::Unknown => "no such command or setting",
            Self::NotHomed => "the bend axis has not found its switch",
            Self::SoftLimit => "beyond the range of the axis",
            Self::Settings => "the stored settings are damaged or of another version: nothing moves",
            Self::Damaged => "the line came damaged: to be sent again from the next number",
            Self::Gap => "the number is not the next one",
            Self::NoSession => "no session is open",
            Self::HoldInput => "the hold input is open: close it and go on",
            Self::Emergency => "the emergency stop is pressed: release it first",
        }
    }
}

/// Why it has stopped.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(u8)]
pub enum Alarm {
    /// None.
    None = 0,
    /// Stopped by the STOP byte.
    Stop = 1,
    /// The switch of the bend axis was hit.
    Limit = 2,
    /// The switch was not found within its travel and time.
    Homing = 3,
    /// The controller hung and was started again by its watchdog.
    Watchdog = 4,
    /// No valid frame for a second: holds after the running line; left by go-on.
    HostLost = 5,
    /// A step pulse came too late.
    LatePulse = 6,
    /// The emergency stop is pressed, or its sense wire is broken.
    Emergency = 7,
    /// The hold input is open: holds, and is left by go-on once it is closed.
    HoldInput = 8,
}

impl Alarm {
    /// The one with this code.
    #[must_use]
    pub const fn of(code: u8) -> Option<Self> {
        Some(match code {
            0 => Self::None,
            1 => Self::Stop,
            2 => Self::Limit,
            3 => Self::Homing,
            4 => Self::Watchdog,
            5 => Self::HostLost,
            6 => Self::LatePulse,
            7 => Self::Emergency,
            8 => Self::HoldInput,
            _ => return None,
        })
    }

    /// For a person.
    #[must_use]
    pub const fn meaning(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Stop => "stopped by the STOP byte",
            Self::Limit => "the switch of the bend axis was hit",
            Self::Homing => "the switch was not found within its travel and time",
            Self::Watchdog => "the controller hung and was started again by its watchdog",
            Self::HostLost => "no valid frame for a second: holds after the running line; left by go-on",
            Self::LatePulse => "a step pulse came too late",
            Self::Emergency => "the emergency stop is pressed, or its sense wire is broken",
            Self::HoldInput => "the hold input is open: holds, and is left by go-on once it is closed",
        }
    }
}

/// What it does.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(u8)]
pub enum State {
    /// At rest.
    Idle = 0,
    /// Makes a line.
    Running = 1,
    /// Holds.
    Held = 2,
    /// An alarm is latched.
    Alarm = 3,
}

impl State {
    /// The one with this code.
    #[must_use]
    pub const fn of(code: u8) -> Option<Self> {
        Some(match code {
            0 => Self::Idle,
            1 => Self::Running,
            2 => Self::Held,
            3 => Self::Alarm,
            _ => return None,
        })
    }

    /// For a person.
    #[must_use]
    pub const fn meaning(self) -> &'static str {
        match self {
            Self::Idle => "at rest",
            Self::Running => "makes a line",
            Self::Held => "holds",
            Self::Alarm => "an alarm is latched",
        }
    }
}

/// Why it has started.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(u8)]
pub enum Reset {
    /// Power came on.
    PowerOn = 0,
    /// The reset pin; also when a port is opened.
    External = 1,
    /// The voltage was too low.
    BrownOut = 2,
    /// The watchdog.
    Watchdog = 3,
}

impl Reset {
    /// The one with this code.
    #[must_use]
    pub const fn of(code: u8) -> Option<Self> {
        Some(match code {
            0 => Self::PowerOn,
            1 => Self::External,
            2 => Self::BrownOut,
            3 => Self::Watchdog,
            _ => return None,
        })
    }

    /// For a person.
    #[must_use]
    pub const fn meaning(self) -> &'static str {
        match self {
            Self::PowerOn => "power came on",
            Self::External => "the reset pin; also when a port is opened",
            Self::BrownOut => "the voltage was too low",
            Self::Watchdog => "the watchdog",
        }
    }
}

/// The machine that a firmware was built for: its pins, and its first settings.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(u8)]
pub enum Machine {
    /// The WireBend-kit bender: Arduino Uno with a CNC Shield V3.
    WirebendKit = 1,
    /// The bender of howtomechatronics.com: Arduino Uno and three drivers.
    Howtomechatronics = 2,
}

impl Machine {
    /// The one with this code.
    #[must_use]
    pub const fn of(code: u8) -> Option<Self> {
        Some(match code {
            1 => Self::WirebendKit,
            2 => Self::Howtomechatronics,
            _ => return None,
        })
    }

    /// For a person.
    #[must_use]
    pub const fn meaning(self) -> &'static str {
        match self {
            Self::WirebendKit => "The WireBend-kit bender: Arduino Uno with a CNC Shield V3",
            Self::Howtomechatronics => "The bender of howtomechatronics.com: Arduino Uno and three drivers",
        }
    }

    /// Its file in `firmware/machines`, by which its firmware is built.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::WirebendKit => "wirebend-kit",
            Self::Howtomechatronics => "howtomechatronics",
        }
    }
}

/// A setting of the controller.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Setting {
    /// Its number on the line.
    pub id: u8,
    /// Its name.
    pub name: &'static str,
    /// Its unit.
    pub unit: &'static str,
    /// The least that it may be.
    pub least: i32,
    /// The most that it may be.
    pub most: i32,
}

/// Every setting, in order of their numbers, which count from 1.
pub const SETTINGS: [Setting; 26] = [
    Setting { id: 1, name: "feed_steps_per_m", unit: "steps/m", least: 1000, most: 1_000_000 },
    Setting { id: 2, name: "rotate_steps_per_rev", unit: "steps/rev", least: 200, most: 1_000_000 },
    Setting { id: 3, name: "bend_steps_per_rev", unit: "steps/rev", least: 200, most: 1_000_000 },
    Setting { id: 4, name: "feed_rate", unit: "steps/s", least: 31, most: 8000 },
    Setting { id: 5, name: "rotate_rate", unit: "steps/s", least: 31, most: 8000 },
    Setting { id: 6, name: "bend_rate", unit: "steps/s", least: 31, most: 8000 },
    Setting { id: 7, name: "feed_acceleration", unit: "steps/s²", least: 1000, most: 400_000 },
    Setting { id: 8, name: "rotate_acceleration", unit: "steps/s²", least: 1000, most: 400_000 },
    Setting { id: 9, name: "bend_acceleration", unit: "steps/s²", least: 1000, most: 400_000 },
    Setting { id: 10, name: "feed_most", unit: "steps", least: 1000, most: 10_000_000 },
    Setting { id: 11, name: "rotate_limit", unit: "steps", least: 100, most: 10_000_000 },
    Setting { id: 12, name: "bend_limit", unit: "steps", least: 100, most: 1_000_000 },
    Setting { id: 13, name: "near_side", unit: "steps", least: 1, most: 100_000 },
    Setting { id: 14, name: "back_off", unit: "steps", least: 0, most: 100_000 },
    Setting { id: 15, name: "peg_in_us", unit: "µs", least: 512, most: 2500 },
    Setting { id: 16, name: "peg_out_us", unit: "µs", least: 512, most: 2500 },
    Setting { id: 17, name: "peg_time_ms", unit: "ms", least: 20, most: 5000 },
    Setting { id: 18, name: "home_position", unit: "steps", least: -1_000_000, most: 1_000_000 },
    Setting { id: 19, name: "home_fast_rate", unit: "steps/s", least: 31, most: 8000 },
    Setting { id: 20, name: "home_slow_rate", unit: "steps/s", least: 31, most: 8000 },
    Setting { id: 21, name: "home_back_off", unit: "steps", least: 1, most: 100_000 },
    Setting { id: 22, name: "home_travel", unit: "steps", least: 100, most: 1_000_000 },
    Setting { id: 23, name: "home_time_ms", unit: "ms", least: 1000, most: 600_000 },
    Setting { id: 24, name: "inverted", unit: "bits", least: 0, most: 15 },
    Setting { id: 25, name: "release_s", unit: "s", least: 0, most: 36_000 },
    Setting { id: 26, name: "inputs", unit: "bits", least: 0, most: 3 },
];
