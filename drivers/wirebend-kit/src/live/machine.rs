//! The machine as the program sees it: what it is asked, and what it reports. Knows no port and no clock.

use std::collections::{BTreeMap, VecDeque};
use std::hash::{BuildHasher, Hasher, RandomState};
use std::rc::Rc;
use std::time::Duration;

use wirebend_driver_api::Event;

use super::console::Console;
use super::wire::{Token, Wire};
use crate::link::Link;
use crate::protocol::{Alarm, Refusal, SETTINGS, Status, Versions};
use crate::settings::Settings;

/// 0 and 65535 are nobody's.
const LAST_SESSION: u16 = 0xFFFE;

/// What it is busy with.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Doing {
    /// Until the controller's settings are known.
    Connecting,
    Nothing,
    Homing(Homing),
    /// Until the session of a wire is open, and the controller knows where the head stands.
    Arming,
    Making,
    /// Until this line is made.
    Jogging(u32),
    Writing,
    /// The port is of no use any more.
    Over,
}

/// From a request to a machine that knows where its axes are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Homing {
    /// What the controller was busy with is stopped.
    Stopping,
    Opening,
    /// Until the controller counts the head from where it stands.
    Placing,
    Searching {
        line: u32,
        accepted: bool,
    },
    /// Until a status tells where the head stands.
    Asking,
    /// The head goes back to zero.
    Returning {
        line: u32,
    },
}

/// What has ended everything, until the machine is homed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Halt {
    No,
    /// A person has asked for a stop.
    Asked,
    /// It was told.
    Told(Alarm),
}

/// From where the controller counts the head.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Counts {
    /// As it does: nobody knows whether it has started since the wire before.
    Itself,
    /// It has not started since the wire of the program's token began.
    Kept,
    /// It has started since it was told where the head stands.
    Lost,
}

impl Counts {
    /// Once it is known whether it has started since the wire of a token began.
    pub const fn since(self, same: Option<bool>) -> Self {
        match (self, same) {
            (Self::Lost, _) | (_, Some(false)) => Self::Lost,
            (_, Some(true)) => Self::Kept,
            _ => self,
        }
    }
}

/// An end that is told as soon as the controller says where its axes stand, or when it does not say so in time.
#[derive(Debug)]
pub(super) struct Ending {
    pub events: Vec<Event>,
    /// The wire that it has ended.
    pub wire: Option<Wire>,
    /// Whether its axes were at rest before, and stand exactly where they are said to.
    pub exact: bool,
    /// Whether its axes stand where the controller counts.
    pub counted: bool,
    pub until: Duration,
}

/// A controller, and what was made of it.
pub(super) struct Machine {
    pub(super) settings: Rc<Settings>,
    pub(super) link: Link,
    pub(super) console: Console,
    pub(super) events: VecDeque<Event>,
    pub(super) doing: Doing,
    pub(super) token: Option<Token>,
    pub(super) versions: Option<Versions>,
    /// The machine that its firmware must be built for.
    pub(super) built_for: u32,
    /// How often the controller has started.
    pub(super) boots: u32,
    /// The controller's settings as far as they were read; nothing where it says that they are damaged.
    pub(super) read: [Option<i32>; SETTINGS.len()],
    /// Values that it would not take.
    pub(super) unwritten: BTreeMap<u8, (i32, Refusal)>,
    pub(super) status: Option<Status>,
    pub(super) told: Option<[i32; 3]>,
    pub(super) head: Counts,
    /// Where it stands, as the program has said with the search for the reference that begins, steps.
    pub(super) head_at: Option<i32>,
    pub(super) homed: bool,
    pub(super) held: bool,
    pub(super) halt: Halt,
    /// What has ended everything, and is told with where the axes stand.
    pub(super) ending: Option<Ending>,
    pub(super) wire: Option<Wire>,
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
            doing: Doing::Connecting,
            token,
            versions: None,
            boots: 0,
            read: [None; SETTINGS.len()],
            unwritten: BTreeMap::new(),
            status: None,
            told: None,
            head: Counts::Itself,
            head_at: None,
            homed: false,
            held: false,
            halt: Halt::No,
            ending: None,
            wire: None,
        }
    }

    pub fn take_bytes(&mut self) -> Vec<u8> {
        let bytes = self.link.take_bytes();
        Console::say(&bytes, &mut self.events);
        bytes
    }

    pub fn take_event(&mut self) -> Option<Event> {
        self.events.pop_front()
    }

    pub fn report(&mut self, event: Event) {
        self.events.push_back(event);
    }

    /// What is sent when nobody will be there any more.
    pub fn farewell(&self) -> Vec<u8> {
        self.link.hold()
    }

    /// Whether the controller has lines that it has not made.
    pub fn is_moving(&self) -> bool {
        self.link.is_outstanding()
    }

    /// Whether a STOP was not answered yet.
    pub fn is_stopping(&self) -> bool {
        self.link.is_stopping()
    }
}

/// One that neither this program nor another is likely to have taken before, and never that of before.
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
