//! Waiting until a machine that was stopped, or whose driver was lost, stands.

use std::time::{Duration, Instant};

use wirebend_driver_host::{Session, Standstill};
use wirebend_error::{ErrorCode, ErrorRemedy, ProblemReport};

use super::connection::Connection;
use super::observer::MachineObserver;
use super::refused::PAUSE;

/// A machine that stands has said so by then; after that the user is warned.
const TELL_AFTER: Duration = Duration::from_secs(1);

/// What is shown while a stop is not confirmed.
pub const NOT_YET: &str = "the machine has not confirmed the stop yet, and it is repeated";

/// Warns the user once that a stop is not confirmed yet.
#[derive(Default)]
pub struct StopWatch {
    since: Option<Instant>,
    told: bool,
}

impl StopWatch {
    /// To be called again and again while a machine is watched.
    pub fn look(&mut self, session: &Session, observer: &mut MachineObserver) {
        if session.standstill() != Some(Standstill::Awaited) {
            *self = Self::default();
            return;
        }
        let since = *self.since.get_or_insert_with(Instant::now);
        if !self.told && since.elapsed() > TELL_AFTER {
            self.told = true;
            let power = vec![ErrorRemedy::CutPower];
            observer.warn(ProblemReport::new(ErrorCode::StopNotConfirmedYet, NOT_YET.to_owned(), power));
        }
    }
}

/// Waits until the machine has confirmed that it stands, or it is certain that this will not be known. `unwanted`: nothing is wanted
/// of it any more.
pub fn await_standstill(
    session: &mut Session,
    observer: &mut MachineObserver,
    unwanted: impl Fn() -> bool,
) -> Option<Standstill> {
    let mut watch = StopWatch::default();
    while session.standstill() == Some(Standstill::Awaited) && !unwanted() {
        // A driver that fails meanwhile is not waited for any more: the session asks the machine itself.
        let events = session.poll().unwrap_or_default();
        observer.publish(session);
        for event in &events {
            observer.hear(event);
        }
        if events.is_empty() {
            std::thread::sleep(PAUSE);
        }
        watch.look(session, observer);
    }
    session.standstill()
}

impl Connection<'_> {
    /// Waits until the machine stands, where it was stopped or its driver was lost.
    pub fn await_standstill(&mut self) -> Option<Standstill> {
        await_standstill(&mut self.session, &mut self.observer, || false)
    }
}
