//! The machine without port and clock: bytes and times in, bytes and events out.

use std::collections::{BTreeMap, VecDeque};
use std::hash::{BuildHasher, Hasher, RandomState};
use std::rc::Rc;
use std::time::Duration;

use wirebend_driver_api::Event;

use super::console::Console;
use super::head_target::HeadTarget;
use super::wire_progress::{Token, WireProgress};
use crate::link::Link;
use crate::protocol::{Alarm, Refusal, SETTINGS, Status, Versions};
use crate::settings::Settings;

/// It goes no faster than its settings say, percent.
pub(super) const FASTEST: u8 = 100;

/// 0 and 65535 are not sessions.
const LAST_SESSION: u16 = 0xFFFE;

/// What the machine is doing.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Activity {
    /// Until the controller's settings are known.
    Connecting,
    Idle,
    Homing(Homing),
    /// Armed for a wire, to whose place the head is turned once a step is sent; `at`: where it stands, steps, as the next status
    /// reports it.
    ToTurn {
        session: u16,
        at: Option<i32>,
    },
    /// Until this line has turned it; then the session of the wire is opened.
    Turning {
        line: u32,
        session: u16,
    },
    /// Until the session of a wire is open and the controller has the position of the head.
    Arming,
    /// A wire is being bent.
    Running,
    /// Until this line is done.
    Jogging(u32),
    StoringSettings,
    /// Until the line that a person has typed is answered.
    Typing(Typed),
    /// The connection is over.
    Closed,
}

/// What becomes of a line that a person has typed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Typed {
    Question,
    /// Settings are stored by it, and read again.
    Stores,
    /// The motors are off: axes can be turned by hand.
    Releases,
}

/// The parts of homing.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Homing {
    /// Stopping what the controller was doing.
    Stopping,
    /// Opening a new session.
    Opening,
    /// Sending the controller the position of the head.
    SettingHead,
    /// Homing to the switch.
    Searching { line: u32, accepted: bool },
    /// Waiting for a status with the position of the head.
    ReadingHead,
    /// Turning the head back to zero.
    Returning { line: u32 },
}

/// Whether a stop or an alarm holds until the machine is homed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Halt {
    No,
    /// The program has asked for a stop.
    Requested,
    /// An alarm was reported to the program.
    Reported(Alarm),
}

/// Whether the controller's count of the head is still that of the wire.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum HeadReference {
    /// The controller may have been reset since the wire before.
    Unknown,
    /// It was not reset since the wire of the token began.
    Kept,
    /// It was reset since it was given the position of the head.
    Lost,
}

impl HeadReference {
    /// `same`: whether the controller is known not to have been reset since the wire of a token began.
    pub const fn since(self, same: Option<bool>) -> Self {
        match (self, same) {
            (Self::Lost, _) | (_, Some(false)) => Self::Lost,
            (_, Some(true)) => Self::Kept,
            _ => self,
        }
    }
}

/// The end of a wire or an alarm, reported as soon as the controller sends its position, or after a timeout without it.
#[derive(Debug)]
pub(super) struct Ending {
    pub events: Vec<Event>,
    /// The wire that was running.
    pub wire: Option<WireProgress>,
    /// The axes were at rest before, so the reported position is exact.
    pub exact: bool,
    /// The controller's count is right: no switch was hit and no power was lost.
    pub counted: bool,
    pub until: Duration,
}

/// The state of the connection.
pub(super) struct Machine {
    pub(super) settings: Rc<Settings>,
    pub(super) link: Link,
    pub(super) console: Console,
    pub(super) events: VecDeque<Event>,
    pub(super) activity: Activity,
    pub(super) token: Option<Token>,
    pub(super) versions: Option<Versions>,
    /// The machine that the firmware must be built for.
    pub(super) built_for: u32,
    /// How often the controller has started.
    pub(super) boots: u32,
    /// The controller's settings as far as they were read; nothing where it says that they are damaged.
    pub(super) read: [Option<i32>; SETTINGS.len()],
    /// The speed override, percent: as it is, and as it was asked for.
    pub(super) speed: u8,
    pub(super) wanted_speed: u8,
    /// Values that the controller has refused.
    pub(super) unwritten: BTreeMap<u8, (i32, Refusal)>,
    pub(super) status: Option<Status>,
    pub(super) told: Option<[i32; 3]>,
    pub(super) head: HeadReference,
    /// Position of the head that the program gave for homing, steps.
    pub(super) head_at: Option<i32>,
    pub(super) homed: bool,
    pub(super) held: bool,
    pub(super) halt: Halt,
    pub(super) ending: Option<Ending>,
    pub(super) wire: Option<WireProgress>,
    pub(super) head_target: HeadTarget,
}

impl Machine {
    pub fn new(settings: Rc<Settings>, resume: Option<&str>, now: Duration) -> Self {
        let token = resume.and_then(Token::parse);
        let boot = Duration::try_from_secs_f64(settings.boot_s).unwrap_or_default();
        let link = Link::new(
            session_id(token.map(|token| token.session)),
            token.map(|token| token.session),
            boot,
            now,
        );
        Self {
            built_for: settings.firmware_machine,
            settings,
            link,
            console: Console::default(),
            events: VecDeque::new(),
            activity: Activity::Connecting,
            token,
            versions: None,
            boots: 0,
            read: [None; SETTINGS.len()],
            speed: FASTEST,
            wanted_speed: FASTEST,
            unwritten: BTreeMap::new(),
            status: None,
            told: None,
            head: HeadReference::Unknown,
            head_at: None,
            homed: false,
            held: false,
            halt: Halt::No,
            ending: None,
            wire: None,
            head_target: HeadTarget::default(),
        }
    }

    pub fn take_bytes(&mut self) -> Vec<u8> {
        let bytes = self.link.take_bytes();
        self.console.say(&bytes, &mut self.events);
        bytes
    }

    pub fn take_event(&mut self) -> Option<Event> {
        self.events.pop_front()
    }

    pub fn report(&mut self, event: Event) {
        self.events.push_back(event);
    }

    /// The frame to send before the port is closed: a feed hold.
    pub fn last_hold(&self) -> Vec<u8> {
        self.link.hold()
    }

    /// Whether the controller has lines that are not done.
    pub fn is_moving(&self) -> bool {
        self.link.is_outstanding()
    }

    /// Whether a STOP was not answered yet.
    pub fn is_stopping(&self) -> bool {
        self.link.is_stopping()
    }
}

/// A random id that no other program is likely to have used; never the one before.
pub(super) fn session_id(before: Option<u16>) -> u16 {
    let random = RandomState::new().build_hasher().finish();
    let id = u16::try_from(1 + random % u64::from(LAST_SESSION)).unwrap_or(1);
    if Some(id) == before { id % LAST_SESSION + 1 } else { id }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_session_is_never_that_of_before_nor_nobodys() {
        for before in [1, 2, LAST_SESSION] {
            for _ in 0..200_000 {
                let id = session_id(Some(before));
                assert!(id != before && (1..=LAST_SESSION).contains(&id), "{id}");
            }
        }
    }
}
