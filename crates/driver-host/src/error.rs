//! What can go wrong with a driver, as the program sees it.

use std::path::PathBuf;
use std::time::Duration;

use wirebend_driver_api::DriverError;

use crate::trust::{Fingerprint, TrustError};

/// Why a driver could not be had or did not do what it was asked. The message says what to do.
#[derive(Debug, thiserror::Error)]
pub enum HostError {
    /// Nobody has accepted the library.
    #[error(
        "{} is a driver that did not come with this program (SHA-256 {hash}); if you trust its author, accept it with `wirebend driver trust {}`",
        file.display(), file.display()
    )]
    NotTrusted {
        /// The library.
        file: PathBuf,
        /// What it is now.
        hash: Fingerprint,
    },
    /// The library was accepted and has been changed.
    #[error(
        "{} was changed since it was accepted (SHA-256 {hash}); if that was an update of yours, accept it again with `wirebend driver trust {}`",
        file.display(), file.display()
    )]
    Changed {
        /// The library.
        file: PathBuf,
        /// What it is now.
        hash: Fingerprint,
    },
    /// Others could change the library, or it cannot be read.
    #[error("{} is not loaded: {reason}", file.display())]
    Unsafe {
        /// The library.
        file: PathBuf,
        /// Why.
        reason: String,
    },
    /// The process of a driver could not be started.
    #[error("the process of the driver {driver} cannot be started: {cause}")]
    Start {
        /// The library.
        driver: String,
        /// Why.
        cause: std::io::Error,
    },
    /// The library is no driver that this program can use.
    #[error("{driver} cannot be used: {reason}")]
    Load {
        /// The library.
        driver: String,
        /// A word that stays: `library`, `symbol`, `version`, `table`, `changed`, `limit`.
        code: String,
        /// Why.
        reason: String,
    },
    /// The driver broke a rule of the boundary.
    #[error("the driver {driver} broke a rule during {during}: {reason}; report this to its author")]
    Broken {
        /// The driver.
        driver: String,
        /// What it was asked.
        during: &'static str,
        /// Which rule.
        reason: String,
    },
    /// The process of the driver ended.
    #[error("the driver {driver} {how} during {during}{said}")]
    Died {
        /// The driver.
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
        /// The driver.
        driver: String,
        /// What it was asked.
        during: &'static str,
        /// How long it had.
        deadline: Duration,
        /// The last that it printed.
        said: String,
    },
    /// The driver wrote to the pipe itself, and was ended.
    #[error(
        "the driver {driver} wrote something during {during} that is no answer, and was ended; report this to its author"
    )]
    Garbage {
        /// The driver.
        driver: String,
        /// What it was asked.
        during: &'static str,
    },
    /// The driver answered more than there is room for, and was ended.
    #[error(
        "the driver {driver} answered {bytes} bytes to {during}, which is more than anything needs, and was ended"
    )]
    TooLarge {
        /// The driver.
        driver: String,
        /// What it was asked.
        during: &'static str,
        /// How many.
        bytes: usize,
    },
    /// The process was ended before, by a stop or after a failure.
    #[error("the driver {driver} was ended before: start it again")]
    Ended {
        /// The driver.
        driver: String,
    },
    /// A stop came before the driver was asked.
    #[error("{during} was given up: the machine was stopped before")]
    StoppedBefore {
        /// What was to be asked.
        during: &'static str,
    },
    /// The driver said no.
    #[error("the driver {driver} refuses: {error}")]
    Refused {
        /// The driver.
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
    pub fn code(&self) -> &'static str {
        match self {
            Self::NotTrusted { .. } => "driver-not-trusted",
            Self::Changed { .. } => "driver-changed",
            Self::Unsafe { .. } => "driver-unsafe",
            Self::Start { .. } => "driver-start",
            Self::Load { .. } => "driver-load",
            Self::Broken { .. } => "driver-broken",
            Self::Died { .. } => "driver-died",
            Self::Hung { .. } => "driver-hung",
            Self::Garbage { .. } => "driver-garbage",
            Self::TooLarge { .. } => "driver-too-large",
            Self::Ended { .. } => "driver-ended",
            Self::StoppedBefore { .. } => "stopped-before",
            Self::Refused { .. } => "driver-refused",
            Self::Trust(_) => "driver-trust",
        }
    }
}
