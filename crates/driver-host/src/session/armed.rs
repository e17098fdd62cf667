//! What a person has to say before anything moves.

use wirebend_driver_api::Run;

/// A person's yes. It can only be had by asking.
#[derive(Debug)]
pub struct Confirmed(());

/// What a person is asked.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Asked {
    /// What will move, and how.
    pub question: String,
}

impl Confirmed {
    /// Asks a person; `None` when they say no.
    pub fn by(asked: &Asked, person: impl FnOnce(&Asked) -> bool) -> Option<Self> {
        person(asked).then_some(Self(()))
    }
}

/// What the machine is armed for.
#[derive(Debug, Clone, PartialEq)]
pub enum Purpose {
    /// One wire of a job, or the rest of one: from the step after [`Run::after`] on.
    Wire(Run),
    /// Moves at a person's word.
    ByHand,
}

/// The session is armed. Every motion needs this; it cannot be made or copied outside the session.
#[derive(Debug, PartialEq, Eq)]
pub struct Armed {
    pub(super) arming: u64,
    pub(super) token: Option<String>,
}

impl Armed {
    /// What the driver calls the session that the machine is in: kept in a journal, it is what
    /// [`Session::connect_resuming`](super::Session::connect_resuming) takes. `None` where there are no such
    /// sessions.
    #[must_use]
    pub fn token(&self) -> Option<&str> {
        self.token.as_deref()
    }
}
