//! Whether the machine stands: after a stop, after its driver was lost, and after a fault while it might move.

use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::stop_line::StopLine;

/// How long a machine has to confirm a stop before the program stops waiting for it.
pub(super) const GIVE_UP_AFTER: Duration = Duration::from_secs(10);
/// How long the driver has for it before the program takes the port over.
pub(super) const DRIVER_CONFIRMS_WITHIN: Duration = Duration::from_secs(3);
/// Between two writes of the stop bytes by the program itself.
const AGAIN: Duration = Duration::from_millis(100);
/// Between two looks for the reply.
const LOOK: Duration = Duration::from_millis(10);

/// Whether a machine that was stopped, or whose driver was lost or has reported a fault, stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Standstill {
    /// The stop is repeated until the machine confirms it.
    Awaited,
    /// The machine has confirmed that it stands.
    Confirmed,
    /// The machine has not confirmed it: it may still be moving. Cut its power.
    NotConfirmed,
}

/// Stops the machine when its driver is lost, and knows whether it stands. A copy is the same one: the session, its
/// stop handles and the driver's process share it.
#[derive(Debug, Clone, Default)]
pub(super) struct Guard(Arc<Shared>);

#[derive(Debug, Default)]
struct Shared {
    known: Mutex<Known>,
    /// Notified when the machine stands, and when the wait is given up.
    settled: Condvar,
}

/// What stops the machine once its driver is ended.
#[derive(Debug, Default)]
enum WithoutDriver {
    /// Nothing that the program can do.
    #[default]
    Nothing,
    /// The stop bytes, written to the port.
    Line(StopLine),
    /// Its driver simulates it: it has ended with it.
    Simulated,
}

#[derive(Debug, Default)]
struct Known {
    without_driver: WithoutDriver,
    /// The machine may move: something was asked of it that has not ended.
    moves: bool,
    /// The last stop, or the loss of the driver, and what came of it.
    standstill: Option<Standstill>,
    since: Option<Instant>,
    /// A thread writes the stop bytes.
    insists: bool,
    /// The session is over.
    over: bool,
}

impl Known {
    fn line(&self) -> Option<StopLine> {
        match &self.without_driver {
            WithoutDriver::Line(line) => Some(line.clone()),
            WithoutDriver::Nothing | WithoutDriver::Simulated => None,
        }
    }

    const fn is_simulated(&self) -> bool {
        matches!(self.without_driver, WithoutDriver::Simulated)
    }

    /// The machine may move, or a stop is not confirmed yet. What was given up is not begun again by itself.
    fn concerns(&self) -> bool {
        let wanted = match self.standstill {
            Some(standstill) => standstill == Standstill::Awaited,
            None => self.moves,
        };
        wanted && !self.over
    }
}

impl Guard {
    fn lock(&self) -> MutexGuard<'_, Known> {
        self.0.known.lock().unwrap_or_else(PoisonError::into_inner)
    }

    pub fn use_line(&self, line: Option<StopLine>) {
        if let Some(line) = line {
            self.lock().without_driver = WithoutDriver::Line(line);
        }
    }

    pub fn line(&self) -> Option<StopLine> {
        self.lock().line()
    }

    /// The driver simulates the machine. Where there is a port to write to, that is what counts.
    pub fn use_simulated(&self) {
        let mut known = self.lock();
        if matches!(known.without_driver, WithoutDriver::Nothing) {
            known.without_driver = WithoutDriver::Simulated;
        }
    }

    pub fn is_simulated(&self) -> bool {
        self.lock().is_simulated()
    }

    /// Whether ending the driver settles that the machine stands, or lets the program find it out.
    pub fn settles_without_driver(&self) -> bool {
        !matches!(self.lock().without_driver, WithoutDriver::Nothing)
    }

    /// The machine is about to be asked to move. Whether it might move before.
    pub fn may_move(&self) -> bool {
        std::mem::replace(&mut self.lock().moves, true)
    }

    /// What was asked of the machine has ended.
    pub fn rests(&self) {
        self.lock().moves = false;
    }

    /// What came of the last stop; `None` when there was none since the machine was last known to stand.
    pub fn standstill(&self) -> Option<Standstill> {
        self.lock().standstill
    }

    /// How long the confirmation has been awaited.
    pub fn awaited_for(&self) -> Option<Duration> {
        let known = self.lock();
        known.since.filter(|_| known.standstill == Some(Standstill::Awaited)).map(|since| since.elapsed())
    }

    /// A stop is on its way.
    pub fn stop_begins(&self) {
        let mut known = self.lock();
        (known.standstill, known.since) = (Some(Standstill::Awaited), Some(Instant::now()));
    }

    /// The machine has said that it stands.
    pub fn confirm(&self) {
        let mut known = self.lock();
        known.moves = false;
        if known.standstill.is_some() {
            known.standstill = Some(Standstill::Confirmed);
        }
        self.0.settled.notify_all();
    }

    /// It cannot be found out whether the machine stands.
    pub fn give_up(&self) {
        let mut known = self.lock();
        if known.standstill == Some(Standstill::Awaited) {
            known.standstill = Some(Standstill::NotConfirmed);
        }
        self.0.settled.notify_all();
    }

    /// A caller that continues has heard of the last stop.
    pub fn forget(&self) {
        let mut known = self.lock();
        if known.standstill != Some(Standstill::Awaited) {
            known.standstill = None;
        }
    }

    /// The driver's process is gone, or about to be. Where the machine may move, the program stops it. Several threads notice it:
    /// once the machine has confirmed to one of them, none asks again.
    pub fn driver_is_lost(&self) {
        self.take_over_if(Known::concerns);
    }

    /// Whether the machine has to be stopped when its driver is lost.
    pub fn concerns(&self) -> bool {
        self.lock().concerns()
    }

    /// Writes the stop bytes to the port, and again until the machine confirms. Whether the system has taken them. The driver is ended
    /// before.
    pub fn take_over(&self) -> bool {
        self.take_over_if(|_| true)
    }

    fn take_over_if(&self, wanted: impl FnOnce(&Known) -> bool) -> bool {
        let mut known = self.lock();
        if !wanted(&known) {
            return false;
        }
        let Some(line) = known.line() else {
            let ended = known.is_simulated();
            known.moves &= !ended;
            known.standstill = Some(if ended { Standstill::Confirmed } else { Standstill::NotConfirmed });
            self.0.settled.notify_all();
            return false;
        };
        if known.standstill != Some(Standstill::Awaited) {
            (known.standstill, known.since) = (Some(Standstill::Awaited), Some(Instant::now()));
        }
        if std::mem::replace(&mut known.insists, true) {
            return line.write();
        }
        // Before anybody else writes: the reply to that would be thrown away.
        let written = line.write_first();
        let guard = self.clone();
        thread::spawn(move || guard.insist(&line));
        written
    }

    /// Repeats the stop bytes until the machine replies, the port is gone, or it has taken too long.
    fn insist(&self, line: &StopLine) {
        let (mut written, mut heard) = (Instant::now(), Vec::new());
        let mut known = self.lock();
        let ends = loop {
            heard.append(&mut line.read());
            let late = known.since.is_none_or(|since| since.elapsed() > GIVE_UP_AFTER);
            if line.confirms(&heard) {
                break Standstill::Confirmed;
            } else if known.over || late || line.is_gone() {
                break Standstill::NotConfirmed;
            }
            if written.elapsed() >= AGAIN {
                written = Instant::now();
                line.write();
            }
            known = self.0.settled.wait_timeout(known, LOOK).unwrap_or_else(PoisonError::into_inner).0;
        };
        (known.insists, known.standstill) = (false, Some(ends));
        known.moves &= ends != Standstill::Confirmed;
        self.0.settled.notify_all();
    }

    /// The session is over: the port is left alone from now on.
    fn end(&self) {
        self.lock().over = true;
        self.0.settled.notify_all();
    }
}

/// The session's own: the guard's work ends with it. Declared after the driver, so that one that has to be killed at the
/// end of the session leaves no machine moving.
#[derive(Debug, Default)]
pub(super) struct SessionGuard(Guard);

impl SessionGuard {
    pub fn copy(&self) -> Guard {
        self.0.clone()
    }
}

impl std::ops::Deref for SessionGuard {
    type Target = Guard;

    fn deref(&self) -> &Guard {
        &self.0
    }
}

impl Drop for SessionGuard {
    fn drop(&mut self) {
        self.0.end();
    }
}

#[cfg(test)]
mod tests;
