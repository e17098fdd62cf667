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
    /// One wire of a job.
    Wire(Run),
    /// Moves at a person's word.
    ByHand,
}

/// The session is armed. Every motion needs this; it cannot be made or copied outside the session.
#[derive(Debug, PartialEq, Eq)]
pub struct Armed {
    pub(super) arming: u64,
}
