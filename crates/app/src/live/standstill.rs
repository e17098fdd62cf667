//! Waiting until a machine that was stopped, or whose driver was lost, stands.

use std::time::{Duration, Instant};

use wirebend_driver_host::{Session, Standstill};

use super::connect::{Connection, PAUSE};
use super::hearing::Hearing;

/// A machine that stands has said so by then; after that a person is told.
const TELL_AFTER: Duration = Duration::from_secs(1);

/// What is told while a stop is not confirmed.
pub(crate) const NOT_YET: &str = "the machine has not confirmed the stop yet, and it is repeated: if something still moves, cut the power of the machine";

/// Tells a person once that a stop is not confirmed yet.
#[derive(Default)]
pub(crate) struct StopWatch {
    since: Option<Instant>,
    told: bool,
}

impl StopWatch {
    /// To be called again and again while a machine is watched.
    pub fn look(&mut self, session: &Session, hearing: &mut Hearing) {
        if session.standstill() != Some(Standstill::Awaited) {
            *self = Self::default();
            return;
        }
        let since = *self.since.get_or_insert_with(Instant::now);
        if !self.told && since.elapsed() > TELL_AFTER {
            self.told = true;
            hearing.warn("stop-not-confirmed-yet", NOT_YET);
        }
    }
}

/// Waits until the machine has confirmed that it stands, or it is known that nobody will know. `unwanted`: nothing is wanted
/// of it any more.
pub(crate) fn await_standstill(
    session: &mut Session,
    hearing: &mut Hearing,
    unwanted: impl Fn() -> bool,
) -> Option<Standstill> {
    let mut watch = StopWatch::default();
    while session.standstill() == Some(Standstill::Awaited) && !unwanted() {
        // A driver that fails meanwhile is not waited for any more: the session asks the machine itself.
        let events = session.poll().unwrap_or_default();
        for event in &events {
            hearing.hear(event);
        }
        if events.is_empty() {
            std::thread::sleep(PAUSE);
        }
        watch.look(session, hearing);
    }
    session.standstill()
}

impl Connection<'_> {
    /// Waits until the machine stands, where it was stopped or its driver was lost.
    pub fn await_standstill(&mut self) -> Option<Standstill> {
        await_standstill(&mut self.session, &mut self.hearing, || false)
    }
}
