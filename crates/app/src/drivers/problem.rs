//! What can go wrong with drivers.

use std::path::PathBuf;

use wirebend_driver_host::HostError;
use wirebend_driver_host::api::{Axis, AxisLimit, Beyond, DriverError, Extent, Limits, Step};

use crate::ErrorKind;

/// Why there is no driver, or why it did not do what it was asked. The message says what to do.
#[derive(Debug, thiserror::Error)]
pub enum DriverProblem {
    /// There is no driver with this id.
    #[error(
        "there is no driver '{id}'; see `wirebend drivers`, and --driver-path for one in another folder{}",
        waiting_for(waiting)
    )]
    NoDriver {
        /// The wanted one.
        id: String,
        /// Libraries that nobody has accepted.
        waiting: Vec<PathBuf>,
    },
    /// A machine's own format cannot be written without its driver.
    #[error("'{format}' is written by the driver of the machine: {cause}")]
    OwnFormat {
        /// The format.
        format: String,
        /// Why there is no such driver.
        cause: Box<DriverProblem>,
    },
    /// A driver failed, is not trusted, or refused.
    #[error(transparent)]
    Host(#[from] HostError),
    /// A driver does not write this wire.
    #[error("'{driver}' does not write this as {format}: {error}")]
    Unwritten {
        /// The driver.
        driver: String,
        /// The format.
        format: String,
        /// Why.
        error: DriverError,
    },
    /// A driver does not take its settings.
    #[error("the settings of the driver '{driver}' cannot be used: {error}")]
    Settings {
        /// The driver.
        driver: String,
        /// Which of them, and what was expected.
        error: DriverError,
    },
    /// A step of the wire would be refused in the middle of it.
    #[error(
        "wire {}: with step {step} {goes} {value:.3}{unit}, and {by} takes no more than {most:.3}{unit} ({because}); plan the design anew for a machine profile with that limit, or change the setting",
        .wire.saturating_add(1)
    )]
    BeyondLimit {
        /// Index of the wire, from 0.
        wire: usize,
        /// The step, from 1.
        step: u32,
        /// What goes beyond, in words.
        goes: &'static str,
        /// How far.
        value: f64,
        /// Who refuses it.
        by: &'static str,
        /// What is taken.
        most: f64,
        /// Of both.
        unit: &'static str,
        /// Where the limit comes from.
        because: String,
    },
    /// A library cannot be read.
    #[error("{}: the library cannot be read: {cause}", file.display())]
    Library {
        /// The library.
        file: PathBuf,
        /// Why.
        cause: std::io::Error,
    },
    /// Another library was accepted than the one that is there.
    #[error("{} is not the library that was meant: its SHA-256 is {found}", file.display())]
    OtherLibrary {
        /// The library.
        file: PathBuf,
        /// What it is.
        found: String,
    },
    /// There is no place for the list of accepted libraries.
    #[error("there is no folder of yours to keep the list of accepted drivers in: set HOME")]
    NowhereToTrust,
    /// The running program's file is not known, and so no driver can be started.
    #[error("the system does not tell which file this program is, so that no driver can be started: {0}")]
    OwnProgram(std::io::Error),
}

/// Advice about libraries that wait to be accepted.
fn waiting_for(waiting: &[PathBuf]) -> String {
    let names: Vec<String> = waiting.iter().map(|file| file.display().to_string()).collect();
    if names.is_empty() { String::new() } else { format!("; not accepted yet: {}", names.join(", ")) }
}

impl DriverProblem {
    /// Whose turn it is.
    pub(crate) fn kind(&self) -> ErrorKind {
        match self {
            Self::OwnFormat { cause, .. } => cause.kind(),
            Self::NoDriver { .. } | Self::Host(_) | Self::OwnProgram(_) | Self::NowhereToTrust => {
                ErrorKind::Failure
            }
            Self::Settings { .. } | Self::Library { .. } => ErrorKind::BadInput,
            Self::OtherLibrary { .. } => ErrorKind::Usage,
            Self::Unwritten { .. } | Self::BeyondLimit { .. } => ErrorKind::NotFeasible,
        }
    }

    /// A name that stays the same while the wording may change.
    pub(crate) fn code(&self) -> &'static str {
        match self {
            Self::OwnFormat { cause, .. } => cause.code(),
            Self::NoDriver { .. } => "no-driver",
            Self::Host(error) => error.code(),
            Self::Unwritten { .. } => "unwritten",
            Self::BeyondLimit { .. } => "beyond-limit",
            Self::Settings { .. } => "driver-settings",
            Self::Library { .. } => "driver-library",
            Self::OtherLibrary { .. } => "other-library",
            Self::NowhereToTrust => "nowhere-to-trust",
            Self::OwnProgram(_) => "own-program",
        }
    }
}

impl DriverProblem {
    /// Refuses a wire, by its index from 0, with a step that would be refused in its middle; those before `from`, counted
    /// from 1, are made.
    pub(crate) fn require_within(
        limits: &Limits,
        by: &'static str,
        wire: usize,
        steps: &[Step],
        from: u32,
    ) -> Result<(), Self> {
        limits.beyond(steps, from).map_or(Ok(()), |beyond| Err(Self::beyond(wire, by, beyond)))
    }

    fn beyond(wire: usize, by: &'static str, beyond: Beyond) -> Self {
        let Beyond { step, value, limit: AxisLimit { axis, of, most, setting, reason } } = beyond;
        let (goes, unit) = match (axis, of) {
            (Axis::Feed, Extent::Step) => ("the wire is fed", " mm"),
            (Axis::Feed, Extent::Position) => ("the wire is fed in all", " mm"),
            (Axis::Rotate, Extent::Step) => ("the head turns", "\u{b0}"),
            (Axis::Rotate, Extent::Position) => ("the head comes to", "\u{b0}"),
            (Axis::Bend, Extent::Step) => ("the bend axis goes to", "\u{b0}"),
            (Axis::Bend, Extent::Position) => ("the bend axis comes to", "\u{b0}"),
        };
        let because = setting.as_ref().map_or_else(|| reason.clone(), |key| format!("driver setting {key}"));
        Self::BeyondLimit { wire, step, goes, value, by, most: *most, unit, because }
    }
}
