//! Why a machine does not move because of where its head stands.

/// Why a machine does not move because of where its head stands. The message says what to do.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum HeadProblem {
    /// Nobody is there to be asked.
    #[error(
        "{what}; look at it and say --head-at DEGREES, counted from where its cable is unwound, or switch the motors off, turn it back there by hand, and say --head-at=0"
    )]
    Unknown {
        /// What is known of it.
        what: String,
    },
    /// It has to be turned back by a person.
    #[error(
        "the head has to stand at zero, with its cable unwound, and {what}: turn it back, by hand or by `wirebend jog`, and then say --head-at=0"
    )]
    Turned {
        /// What is known of it.
        what: String,
    },
    /// It cannot be where a person says, or is where it must not be.
    #[error(
        "the head cannot be taken to stand at {deg}°, since its cable allows {least}° to {most}°: if it does, switch the motors off, turn it back by hand, and say --head-at=0"
    )]
    Beyond {
        /// Where they say.
        deg: f64,
        /// The least.
        least: f64,
        /// The most.
        most: f64,
    },
    /// A turn by hand is too far.
    #[error(
        "the head stands at {from:.1}° and would be turned to {to:.1}°, and its cable allows {least}° to {most}°: turn it less, or the other way"
    )]
    TooFar {
        /// Where it stands.
        from: f64,
        /// Where it would stand.
        to: f64,
        /// The least.
        least: f64,
        /// The most.
        most: f64,
    },
}

impl HeadProblem {
    /// A name that stays the same while the wording may change.
    #[must_use]
    pub const fn code(&self) -> &'static str {
        match self {
            Self::Unknown { .. } => "head-unknown",
            Self::Turned { .. } => "head-turned",
            Self::Beyond { .. } => "head-beyond",
            Self::TooFar { .. } => "head-too-far",
        }
    }
}
