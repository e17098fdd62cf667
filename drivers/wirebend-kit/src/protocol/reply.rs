//! What a frame of the controller says.

use super::codes::{Alarm, Refusal, Reply, Reset, State};
use super::frame::{Line, NO_SESSION};

/// How the controller stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Status {
    pub state: State,
    /// Why it has stopped or holds.
    pub alarm: Alarm,
    /// Position of feed, rotate and bend, steps.
    pub position: [i32; 3],
    /// Lines that it has taken.
    pub last: u32,
    /// Lines that it has done.
    pub done: u32,
    /// Whether the peg is out; `None` when it does not know.
    pub peg_out: Option<bool>,
    /// Whether the switch of the bend axis is pressed.
    pub switch: bool,
    /// Whether the bend axis has found its switch.
    pub homed: bool,
}

/// What a controller is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Versions {
    pub protocol: u32,
    /// Version of its firmware, 100 for 1.0.
    pub firmware: u32,
    /// Which machine it was built for.
    pub machine: u32,
}

/// A frame of the controller.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ReplyFrame {
    /// It has started.
    Boot {
        versions: Versions,
        reset: Reset,
        /// How often it has started.
        boots: u32,
    },
    /// A session is open.
    Open {
        id: u16,
        /// Lines that it has taken in it.
        last: u32,
        /// Lines that it has done in it.
        done: u32,
        versions: Versions,
        /// How often it has started.
        boots: u32,
    },
    /// Lines are taken.
    Accepted {
        /// The last of them.
        last: u32,
    },
    /// Lines are done.
    Done {
        /// The last of them.
        n: u32,
    },
    /// There was no room for a line.
    Full {
        /// The last that was taken.
        last: u32,
    },
    Refused {
        error: Refusal,
        /// The number of the line that it expects.
        next: u32,
        /// The letter of the command; `None` for a line that it could not read.
        command: Option<u8>,
    },
    Status(Status),
    /// The speed override.
    Speed {
        percent: u8,
    },
    Value {
        id: u8,
        value: i32,
    },
    /// It has stopped.
    Alarm(Alarm),
}

impl ReplyFrame {
    /// What a line says; `None` when it is not sealed with this session, nor of those that belong to none.
    #[must_use]
    pub fn of(line: &Line, session: u16) -> Option<Self> {
        let heard = Self::parse(&line.payload)?;
        let free = matches!(
            heard,
            Self::Boot { .. }
                | Self::Open { .. }
                | Self::Refused { error: Refusal::NoSession, .. }
                | Self::Refused { command: Some(b'S'), .. }
                | Self::Alarm(_)
        );
        (line.is_sealed_with(session) || free && line.is_sealed_with(NO_SESSION)).then_some(heard)
    }

    fn parse(payload: &str) -> Option<Self> {
        let (&letter, rest) = payload.as_bytes().split_first()?;
        let rest = std::str::from_utf8(rest).ok()?;
        let fields = rest.split(',').map(str::parse).collect::<Result<Vec<i64>, _>>().ok()?;
        let natural = |value: i64| u32::try_from(value).ok();
        let steps = |value: i64| i32::try_from(value).ok();
        let code = |value: i64| u8::try_from(value).ok();
        let flag = |value: i64| matches!(value, 0 | 1).then_some(value == 1);
        let versions = |protocol, firmware, machine| {
            Some(Versions {
                protocol: natural(protocol)?,
                firmware: natural(firmware)?,
                machine: natural(machine)?,
            })
        };
        Some(match (Reply::of(letter)?, fields.as_slice()) {
            (Reply::Boot, &[protocol, firmware, machine, reset, boots]) => Self::Boot {
                versions: versions(protocol, firmware, machine)?,
                reset: Reset::of(code(reset)?)?,
                boots: natural(boots)?,
            },
            (Reply::Open, &[id, last, done, protocol, firmware, machine, boots]) => Self::Open {
                id: u16::try_from(id).ok()?,
                last: natural(last)?,
                done: natural(done)?,
                versions: versions(protocol, firmware, machine)?,
                boots: natural(boots)?,
            },
            (Reply::Accepted, &[last, _free]) => Self::Accepted { last: natural(last)? },
            (Reply::Done, &[n]) => Self::Done { n: natural(n)? },
            (Reply::Full, &[last, _free]) => Self::Full { last: natural(last)? },
            (Reply::Refused, &[error, next, command]) => Self::Refused {
                error: Refusal::of(code(error)?)?,
                next: natural(next)?,
                command: Some(code(command)?).filter(|&letter| letter != 0),
            },
            (Reply::Status, &[state, alarm, feed, rotate, bend, last, done, peg, switch, homed]) => {
                Self::Status(Status {
                    state: State::of(code(state)?)?,
                    alarm: Alarm::of(code(alarm)?)?,
                    position: [steps(feed)?, steps(rotate)?, steps(bend)?],
                    last: natural(last)?,
                    done: natural(done)?,
                    peg_out: match peg {
                        2 => None,
                        known => Some(flag(known)?),
                    },
                    switch: flag(switch)?,
                    homed: flag(homed)?,
                })
            }
            (Reply::Speed, &[percent]) => Self::Speed { percent: code(percent)? },
            (Reply::Value, &[id, value]) => Self::Value { id: code(id)?, value: steps(value)? },
            (Reply::Alarm, &[alarm]) => Self::Alarm(Alarm::of(code(alarm)?)?),
            _ => return None,
        })
    }
}
