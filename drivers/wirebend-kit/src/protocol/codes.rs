//! Codes of the wire protocol.
//!
//! Made by `cargo xtask generate` from firmware/protocol/codes.csv and settings.csv: change those.

/// A request of the host.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(u8)]
pub enum Command {
    /// Opens the session with this id of 1 to 65534; the same id again changes nothing. Sealed with 65535.
    Session = b'S',
    /// Asks for the status.
    Query = b'Q',
    /// Line n: feeds, rotates, then bends. All in steps: feed and rotation are relative, the bend goes from zero to its angle and back. The peg comes out at `approach`, or at the near side of the same sign where that is farther, and bends to the other side; since firmware 1.13 the bend may so end at zero or before it, short of where the peg came out. `approach` may be left out or 0, and is since firmware 1.11: the bend is then to the side of its sign.
    Move = b'M',
    /// Line n: a dry-run move. As a move, but the peg stays in, the bend axis goes to its angle and back, and each axis moves at a quarter of its speed, not below 31 steps/s. Since firmware 1.12.
    Dry = b'Y',
    /// Line n: homes the bend axis, then moves it to zero.
    Home = b'H',
    /// Line n: the peg in (0) or out (1).
    Peg = b'K',
    /// Sets the speed override: moves that begin from now on have so many percent of their speed, 10 to 100. Without a number, or with 0, it is asked for. Homing has speeds of its own. A new session begins with 100. Since firmware 1.12.
    Speed = b'U',
    /// Feed hold: slows down and holds.
    Pause = b'P',
    /// Leaves the hold.
    Resume = b'G',
    /// Sets the position of the head; only when idle.
    Head = b'Z',
    /// Reads a setting.
    ReadSetting = b'C',
    /// Writes a setting and stores it; only when idle.
    WriteSetting = b'W',
    /// Stores the compiled-in settings, and answers with the first; only when idle.
    LoadDefaults = b'L',
    /// Turns the motor drivers off; only when idle. Home the machine afterwards.
    Release = b'R',
}

impl Command {
    /// The variant with this code.
    #[must_use]
    pub const fn of(code: u8) -> Option<Self> {
        Some(match code {
            b'S' => Self::Session,
            b'Q' => Self::Query,
            b'M' => Self::Move,
            b'Y' => Self::Dry,
            b'H' => Self::Home,
            b'K' => Self::Peg,
            b'U' => Self::Speed,
            b'P' => Self::Pause,
            b'G' => Self::Resume,
            b'Z' => Self::Head,
            b'C' => Self::ReadSetting,
            b'W' => Self::WriteSetting,
            b'L' => Self::LoadDefaults,
            b'R' => Self::Release,
            _ => return None,
        })
    }
}

/// A frame of the controller: an answer, or a report.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(u8)]
pub enum Reply {
    /// The controller has started. Sealed with 65535.
    Boot = b'b',
    /// The session with this id is open. Sealed with 65535.
    Open = b'o',
    /// Every line up to this number is accepted; so many more fit.
    Accepted = b'a',
    /// Every line up to this number is done, or was dropped by an alarm.
    Done = b'd',
    /// No room for the line: send it again.
    Full = b'f',
    /// Refused, with an error; the number that is expected next; the code of the letter that was refused, or 0 for a line that cannot be read. Sealed with 65535 when it answers a session command.
    Refused = b'e',
    /// The status: positions in steps; peg 0 in, 1 out, 2 unknown.
    Status = b't',
    /// A setting.
    Value = b'v',
    /// The speed override, percent.
    Speed = b'i',
    /// Stopped with this alarm; also the answer to STOP.
    Alarm = b'x',
}

impl Reply {
    /// The variant with this code.
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
            b'i' => Self::Speed,
            b'x' => Self::Alarm,
            _ => return None,
        })
    }
}

/// Why a command is refused.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(u8)]
pub enum Refusal {
    /// Possible only when idle.
    NotIdle = 1,
    /// Wrong format or out of range.
    Range = 2,
    /// An alarm is latched: home the machine.
    InAlarm = 3,
    /// No such command or setting.
    Unknown = 4,
    /// The machine is not homed.
    NotHomed = 5,
    /// Beyond the soft limit of the axis.
    SoftLimit = 6,
    /// The stored settings are damaged or of another version: nothing moves.
    Settings = 7,
    /// The line came damaged: send it again from the next number.
    Damaged = 8,
    /// The number is not the next one.
    Gap = 9,
    /// No session is open.
    NoSession = 10,
    /// The hold input is open: close it, then resume.
    HoldInput = 11,
    /// The emergency stop is pressed: release it first.
    Emergency = 12,
}

impl Refusal {
    /// The variant with this code.
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

    /// The text for a user.
    #[must_use]
    pub const fn meaning(self) -> &'static str {
        match self {
            Self::NotIdle => "possible only when idle",
            Self::Range => "wrong format or out of range",
            Self::InAlarm => "an alarm is latched: home the machine",
            Self::Unknown => "no such command or setting",
            Self::NotHomed => "the machine is not homed",
            Self::SoftLimit => "beyond the soft limit of the axis",
            Self::Settings => "the stored settings are damaged or of another version: nothing moves",
            Self::Damaged => "the line came damaged: send it again from the next number",
            Self::Gap => "the number is not the next one",
            Self::NoSession => "no session is open",
            Self::HoldInput => "the hold input is open: close it, then resume",
            Self::Emergency => "the emergency stop is pressed: release it first",
        }
    }
}

/// Why the controller has stopped or holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(u8)]
pub enum Alarm {
    /// None.
    None = 0,
    /// Stopped by the STOP byte.
    Stop = 1,
    /// The switch of the bend axis was pressed, or its wire is broken.
    Limit = 2,
    /// Homing failed: the switch was not found within its travel and time, or sticks.
    Homing = 3,
    /// The controller hung and its watchdog restarted it.
    Watchdog = 4,
    /// No valid frame for a second: holds after the running line; left by resume.
    HostLost = 5,
    /// A step pulse came too late.
    LatePulse = 6,
    /// The emergency stop is pressed, or its sense wire is broken.
    Emergency = 7,
    /// The hold input is open: holds; close it, then resume.
    HoldInput = 8,
}

impl Alarm {
    /// The variant with this code.
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

    /// The text for a user.
    #[must_use]
    pub const fn meaning(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Stop => "stopped by the STOP byte",
            Self::Limit => "the switch of the bend axis was pressed, or its wire is broken",
            Self::Homing => "homing failed: the switch was not found within its travel and time, or sticks",
            Self::Watchdog => "the controller hung and its watchdog restarted it",
            Self::HostLost => "no valid frame for a second: holds after the running line; left by resume",
            Self::LatePulse => "a step pulse came too late",
            Self::Emergency => "the emergency stop is pressed, or its sense wire is broken",
            Self::HoldInput => "the hold input is open: holds; close it, then resume",
        }
    }
}

/// What the controller is doing.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(u8)]
pub enum State {
    /// No line runs or waits.
    Idle = 0,
    /// Runs a line.
    Run = 1,
    /// Holds.
    Hold = 2,
    /// An alarm is latched.
    Alarm = 3,
}

impl State {
    /// The variant with this code.
    #[must_use]
    pub const fn of(code: u8) -> Option<Self> {
        Some(match code {
            0 => Self::Idle,
            1 => Self::Run,
            2 => Self::Hold,
            3 => Self::Alarm,
            _ => return None,
        })
    }

    /// The text for a user.
    #[must_use]
    pub const fn meaning(self) -> &'static str {
        match self {
            Self::Idle => "no line runs or waits",
            Self::Run => "runs a line",
            Self::Hold => "holds",
            Self::Alarm => "an alarm is latched",
        }
    }
}

/// Why the controller has started.
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
    /// The variant with this code.
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

    /// The text for a user.
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

/// The machine that a firmware was built for: its pins and its default settings.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(u8)]
pub enum Machine {
    /// The WireBend-kit bender: Arduino Uno with a CNC Shield V3.
    WirebendKit = 1,
    /// The bender of howtomechatronics.com: Arduino Uno and three drivers.
    Howtomechatronics = 2,
}

impl Machine {
    /// The variant with this code.
    #[must_use]
    pub const fn of(code: u8) -> Option<Self> {
        Some(match code {
            1 => Self::WirebendKit,
            2 => Self::Howtomechatronics,
            _ => return None,
        })
    }

    /// The text for a user.
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
    /// Its id in frames.
    pub id: u8,
    /// As in profiles and messages.
    pub name: &'static str,
    /// Unit of its value.
    pub unit: &'static str,
    /// Smallest allowed value.
    pub min: i32,
    /// Largest allowed value.
    pub max: i32,
}

/// Every setting, in order of their numbers, which count from 1.
pub const SETTINGS: [Setting; 26] = [
    Setting { id: 1, name: "feed_steps_per_m", unit: "steps/m", min: 1000, max: 1_000_000 },
    Setting { id: 2, name: "rotate_steps_per_rev", unit: "steps/rev", min: 200, max: 1_000_000 },
    Setting { id: 3, name: "bend_steps_per_rev", unit: "steps/rev", min: 200, max: 1_000_000 },
    Setting { id: 4, name: "feed_rate", unit: "steps/s", min: 31, max: 8000 },
    Setting { id: 5, name: "rotate_rate", unit: "steps/s", min: 31, max: 8000 },
    Setting { id: 6, name: "bend_rate", unit: "steps/s", min: 31, max: 8000 },
    Setting { id: 7, name: "feed_acceleration", unit: "steps/s²", min: 1000, max: 400_000 },
    Setting { id: 8, name: "rotate_acceleration", unit: "steps/s²", min: 1000, max: 400_000 },
    Setting { id: 9, name: "bend_acceleration", unit: "steps/s²", min: 1000, max: 400_000 },
    Setting { id: 10, name: "feed_most", unit: "steps", min: 1000, max: 10_000_000 },
    Setting { id: 11, name: "rotate_limit", unit: "steps", min: 100, max: 10_000_000 },
    Setting { id: 12, name: "bend_limit", unit: "steps", min: 100, max: 1_000_000 },
    Setting { id: 13, name: "near_side", unit: "steps", min: 1, max: 100_000 },
    Setting { id: 14, name: "back_off", unit: "steps", min: 0, max: 100_000 },
    Setting { id: 15, name: "peg_in_us", unit: "µs", min: 512, max: 2500 },
    Setting { id: 16, name: "peg_out_us", unit: "µs", min: 512, max: 2500 },
    Setting { id: 17, name: "peg_time_ms", unit: "ms", min: 20, max: 5000 },
    Setting { id: 18, name: "home_position", unit: "steps", min: -1_000_000, max: 1_000_000 },
    Setting { id: 19, name: "home_fast_rate", unit: "steps/s", min: 31, max: 8000 },
    Setting { id: 20, name: "home_slow_rate", unit: "steps/s", min: 31, max: 8000 },
    Setting { id: 21, name: "home_back_off", unit: "steps", min: 1, max: 100_000 },
    Setting { id: 22, name: "home_travel", unit: "steps", min: 100, max: 1_000_000 },
    Setting { id: 23, name: "home_time_ms", unit: "ms", min: 1000, max: 600_000 },
    Setting { id: 24, name: "inverted", unit: "bits", min: 0, max: 15 },
    Setting { id: 25, name: "release_s", unit: "s", min: 0, max: 36_000 },
    Setting { id: 26, name: "inputs", unit: "bits", min: 0, max: 3 },
];
