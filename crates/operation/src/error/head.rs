//! Why a machine does not move because of where its head stands.

use wirebend_error::ErrorCode;

/// Why a machine does not move because of where its head stands.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum HeadProblem {
    /// There is no user to ask.
    #[error("{what}")]
    Unknown {
        /// What is known of it.
        what: String,
    },
    /// It has to be turned back by a person.
    #[error("the head has to stand at zero, with its cable unwound, and {what}")]
    Turned {
        /// What is known of it.
        what: String,
    },
    /// It cannot be where a person says, or is where it must not be.
    #[error("the head cannot stand at {deg}°: its cable allows {least}° to {most}°")]
    Beyond {
        /// Where they say.
        deg: f64,
        least: f64,
        most: f64,
    },
    /// A turn by hand is too far.
    #[error(
        "the head stands at {from:.1}° and would be turned to {to:.1}°, and its cable allows {least}° to {most}°"
    )]
    TooFar {
        from: f64,
        /// Where it would stand.
        to: f64,
        least: f64,
        most: f64,
    },
}

impl HeadProblem {
    /// A name that stays the same while the wording may change.
    #[must_use]
    pub const fn code(&self) -> ErrorCode {
        match self {
            Self::Unknown { .. } => ErrorCode::HeadUnknown,
            Self::Turned { .. } => ErrorCode::HeadTurned,
            Self::Beyond { .. } => ErrorCode::HeadBeyond,
            Self::TooFar { .. } => ErrorCode::HeadTooFar,
        }
    }
}
