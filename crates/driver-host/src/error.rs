//! What can go wrong with a driver, as the program sees it.

use std::path::PathBuf;
use std::time::Duration;

use wirebend_driver_api::DriverError;
use wirebend_error::{ErrorCode, ErrorRemedy, ProblemReport};

use crate::registry::LibraryRefusal;
use crate::trust::{Fingerprint, TrustError};

/// Why a driver could not be had or did not do what it was asked.
#[derive(Debug, thiserror::Error)]
pub enum HostError {
    /// The library was not accepted.
    #[error("{} is a driver that did not come with this program, and is not accepted (SHA-256 {hash})", file.display())]
    NotTrusted {
        file: PathBuf,
        /// What it is now.
        hash: Fingerprint,
    },
    /// The library was accepted and has been changed.
    #[error("{} was changed since it was accepted (SHA-256 {hash})", file.display())]
    Changed {
        file: PathBuf,
        /// What it is now.
        hash: Fingerprint,
    },
    /// Others could change the library, or it cannot be read.
    #[error("{} is not loaded: {reason}", file.display())]
    Unsafe { file: PathBuf, reason: LibraryRefusal },
    /// The process of a driver could not be started.
    #[error("the process of the driver {driver} cannot be started: {cause}")]
    Start { driver: String, cause: std::io::Error },
    /// The library is no driver that this program can use.
    #[error("{driver} cannot be used: {reason}")]
    Load {
        driver: String,
        /// A word that stays: `library`, `symbol`, `newer-version`, `older-version`, `table`, `changed`, `limit`.
        code: String,
        reason: String,
    },
    /// The driver broke a rule of the boundary.
    #[error("the driver {driver} broke a rule during {during}: {reason}")]
    Broken {
        driver: String,
        /// What it was asked.
        during: &'static str,
        /// Which rule.
        reason: String,
    },
    /// The process of the driver ended.
    #[error("the driver {driver} {how} during {during}{said}")]
    Died {
        driver: String,
        /// What it was asked.
        during: &'static str,
        /// How it ended.
        how: String,
        /// The last that it printed.
        said: String,
    },
    /// The driver did not answer in time, and was ended.
    #[error("the driver {driver} did not answer {during} within {deadline:?} and was ended{said}")]
    Hung {
        driver: String,
        /// What it was asked.
        during: &'static str,
        /// How long it had.
        deadline: Duration,
        /// The last that it printed.
        said: String,
    },
    /// The driver wrote to the pipe itself, and was ended.
    #[error("the driver {driver} wrote something during {during} that is no answer, and was ended")]
    Garbage {
        driver: String,
        /// What it was asked.
        during: &'static str,
    },
    /// The driver answered more than there is room for, and was ended.
    #[error(
        "the driver {driver} answered {bytes} bytes to {during}, which is more than anything needs, and was ended"
    )]
    TooLarge {
        driver: String,
        /// What it was asked.
        during: &'static str,
        /// How many.
        bytes: usize,
    },
    /// The process was ended before, by a stop or after a failure.
    #[error("the driver {driver} was ended before")]
    Ended { driver: String },
    /// A stop came before the driver was asked.
    #[error("{during} was given up: the machine was stopped before")]
    StoppedBefore {
        /// What was to be asked.
        during: &'static str,
    },
    /// The driver said no.
    #[error("the driver {driver} refuses: {error}")]
    Refused {
        driver: String,
        /// What it said.
        error: DriverError,
    },
    /// The list of accepted drivers cannot be used.
    #[error(transparent)]
    Trust(#[from] TrustError),
}

impl HostError {
    /// A name that stays the same while the wording may change.
    #[must_use]
    pub fn code(&self) -> ErrorCode {
        match self {
            Self::NotTrusted { .. } => ErrorCode::DriverNotTrusted,
            Self::Changed { .. } => ErrorCode::DriverChanged,
            Self::Unsafe { .. } => ErrorCode::DriverUnsafe,
            Self::Start { .. } => ErrorCode::DriverStart,
            Self::Load { .. } => ErrorCode::DriverLoad,
            Self::Broken { .. } => ErrorCode::DriverBroken,
            Self::Died { .. } => ErrorCode::DriverDied,
            Self::Hung { .. } => ErrorCode::DriverHung,
            Self::Garbage { .. } => ErrorCode::DriverGarbage,
            Self::TooLarge { .. } => ErrorCode::DriverTooLarge,
            Self::Ended { .. } => ErrorCode::DriverEnded,
            Self::StoppedBefore { .. } => ErrorCode::StoppedBefore,
            Self::Refused { .. } => ErrorCode::DriverRefused,
            Self::Trust(_) => ErrorCode::DriverTrust,
        }
    }

    /// What can be done about it.
    #[must_use]
    pub fn remedies(&self) -> Vec<ErrorRemedy> {
        vec![match self {
            Self::Unsafe { reason: LibraryRefusal::WritableByAll(path), .. } => {
                ErrorRemedy::RestrictAccess { path: path.clone() }
            }
            Self::NotTrusted { file, .. } => ErrorRemedy::TrustDriver { file: file.clone(), again: false },
            Self::Changed { file, .. } => ErrorRemedy::TrustDriver { file: file.clone(), again: true },
            Self::Broken { .. } | Self::Garbage { .. } => ErrorRemedy::ReportToAuthor,
            Self::Ended { .. } => ErrorRemedy::ConnectAgain,
            Self::Load { code, .. } if code == "newer-version" => ErrorRemedy::UpdateProgram,
            Self::Load { code, .. } if code == "older-version" => ErrorRemedy::UpdateDriver,
            Self::Refused { error, .. } => return advice_of(error),
            Self::Trust(error) => return error.remedies(),
            Self::Load { .. }
            | Self::Unsafe { .. }
            | Self::Start { .. }
            | Self::Died { .. }
            | Self::Hung { .. }
            | Self::TooLarge { .. }
            | Self::StoppedBefore { .. } => return Vec::new(),
        }]
    }
}

/// What a driver reports, under the code that it has given.
#[must_use]
pub fn report_of(error: &DriverError) -> ProblemReport {
    let DriverError { code, message, .. } = error;
    ProblemReport { code: code.clone(), message: message.clone(), remedies: advice_of(error) }
}

/// What a driver advises, in its own words: they are the author's, and pass through as they are.
#[must_use]
pub fn advice_of(error: &DriverError) -> Vec<ErrorRemedy> {
    let advice = error.help.clone();
    if advice.is_empty() { Vec::new() } else { vec![ErrorRemedy::FollowDriver { advice }] }
}

wirebend_error::reported!(HostError);
