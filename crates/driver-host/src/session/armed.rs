//! What every motion needs.

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
