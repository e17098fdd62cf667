//! Permission to move a machine or to change its settings: a session asks for it, a person confirms it, and it is used
//! once.
//!
//! [`Session::ask`] opens a question. A person's yes makes a [`Confirmation`] of it, which [`Session::permit`] takes
//! once and turns into a [`Permit`]: the value that everything that moves needs. None of them can be copied, none is of
//! use in another session, and a stop ends them all.

use std::sync::{Arc, Weak};

use super::permit_kind::PermitKind;
use super::stop::Arming;
use super::{Session, SessionError};

/// An open question of one session. To say no is to drop it.
#[derive(Debug)]
pub struct PermitRequest {
    session: u64,
    number: u64,
}

impl PermitRequest {
    /// The person has said yes. The session takes one yes to each question.
    #[must_use]
    pub const fn confirm(&self) -> Confirmation {
        Confirmation { session: self.session, number: self.number }
    }
}

/// A person's yes to one question of one session.
#[derive(Debug)]
pub struct Confirmation {
    session: u64,
    number: u64,
}

/// A person has permitted this session to move the machine or to set it. No person has to permit it on a simulated
/// machine: see [`Simulation`].
#[derive(Debug)]
pub struct Permit {
    kind: PermitKind,
    session: u64,
    /// How many stops there had been when the person was asked.
    stops: u64,
    /// The session sees by it whether the permit is still kept.
    kept: Arc<()>,
}

/// The machine of the session is simulated by its driver: nothing moves, and the user need not be asked.
#[derive(Debug)]
pub struct Simulation(Arming);

impl Simulation {
    /// A permit that no person has to give. A stop ends it like any other.
    #[must_use]
    pub fn permit(&self, kind: PermitKind) -> Permit {
        Permit { kind, session: self.0.session(), stops: self.0.stops(), kept: Arc::default() }
    }
}

/// The question that is open in a session.
#[derive(Debug, Default)]
pub(super) struct Questions {
    /// The number of the last one.
    last: u64,
    open: Option<Open>,
    /// The permit for a wire that was given last, and how many stops there had been.
    wire: (Weak<()>, u64),
}

#[derive(Debug, Clone, Copy)]
struct Open {
    number: u64,
    kind: PermitKind,
    stops: u64,
}

impl Session {
    /// Opens a question to a person. One question is open at a time: an earlier one counts as answered with no.
    pub fn ask(&mut self, kind: PermitKind) -> PermitRequest {
        let number = self.questions.last + 1;
        self.questions.last = number;
        self.questions.open = Some(Open { number, kind, stops: self.arming.stops() });
        PermitRequest { session: self.arming.session(), number }
    }

    /// Takes a person's yes to the open question, once.
    ///
    /// # Errors
    /// [`SessionError::OtherSession`] for the yes to a question of another session, [`SessionError::ConfirmationUsed`]
    /// for one that was taken before or came after the next question, [`SessionError::StoppedSince`] where the machine
    /// was stopped after the question.
    #[allow(clippy::needless_pass_by_value, reason = "it is used up")]
    pub fn permit(&mut self, confirmation: Confirmation) -> Result<Permit, SessionError> {
        let Confirmation { session, number } = confirmation;
        if session != self.arming.session() {
            return Err(SessionError::OtherSession);
        }
        let Open { kind, stops, .. } = self
            .questions
            .open
            .take_if(|open| open.number == number)
            .ok_or(SessionError::ConfirmationUsed)?;
        let permit = Permit { kind, session, stops, kept: Arc::default() };
        self.still_permitted(&permit)?;
        if matches!(kind, PermitKind::Wire | PermitKind::Row) {
            self.questions.wire = (Arc::downgrade(&permit.kept), stops);
            self.times = None;
        }
        Ok(permit)
    }

    /// The permit for one wire of those that were permitted together.
    ///
    /// # Errors
    /// [`SessionError`] where the permit of the row does not hold any more, or is for something else.
    pub fn permit_in_row(&self, row: &Permit) -> Result<Permit, SessionError> {
        self.permits(row, "bending the next wire", &[PermitKind::Row])?;
        Ok(Permit {
            kind: PermitKind::Wire,
            session: row.session,
            stops: row.stops,
            kept: Arc::clone(&row.kept),
        })
    }

    /// Where the driver lists the port of this session as simulated.
    #[must_use]
    pub fn simulated(&self) -> Option<Simulation> {
        let is_simulated = || {
            // A driver that does not report where it simulates is taken to move something.
            let ports = self.driver.ports().unwrap_or_default();
            ports.iter().any(|port| port.simulated && port.name == self.port)
        };
        if *self.is_simulated.get_or_init(is_simulated) {
            self.guard.use_simulated();
            return Some(Simulation(self.arming.clone()));
        }
        None
    }

    /// Uses up a person's yes to what follows a pause point.
    ///
    /// # Errors
    /// [`SessionError`] where it does not hold any more, or is for something else.
    pub(crate) fn goes_on(&self, permit: Permit) -> Result<(), SessionError> {
        self.uses_up(permit, "continuing after a pause point", PermitKind::Continue)
    }

    /// Whether a person has permitted a wire that is not begun.
    pub(super) fn has_permitted_a_wire(&self) -> bool {
        let (kept, stops) = &self.questions.wire;
        kept.strong_count() > 0 && *stops == self.arming.stops()
    }

    /// Refuses a permit that does not hold any more, or is for something else.
    pub(super) fn permits(
        &self,
        permit: &Permit,
        act: &'static str,
        kinds: &[PermitKind],
    ) -> Result<(), SessionError> {
        self.still_permitted(permit)?;
        if kinds.contains(&permit.kind) {
            return Ok(());
        }
        Err(SessionError::NotPermitted { act, permitted: permit.kind })
    }

    /// The same, and the permit is gone whatever comes of it.
    #[allow(clippy::needless_pass_by_value, reason = "it is used up")]
    pub(super) fn uses_up(
        &self,
        permit: Permit,
        act: &'static str,
        kind: PermitKind,
    ) -> Result<(), SessionError> {
        self.permits(&permit, act, &[kind])
    }

    fn still_permitted(&self, permit: &Permit) -> Result<(), SessionError> {
        if permit.session != self.arming.session() {
            return Err(SessionError::OtherSession);
        }
        if permit.stops == self.arming.stops() { Ok(()) } else { Err(SessionError::StoppedSince) }
    }
}
