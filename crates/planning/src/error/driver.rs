//! What can go wrong with drivers.

use std::path::PathBuf;

use wirebend_core::units::Mm;
use wirebend_driver_host::HostError;
use wirebend_driver_host::api::{Axis, AxisLimit, Beyond, DriverError, Extent, Limits, Step};
use wirebend_error::ErrorCode;

use super::ErrorKind;

/// How far an axis goes: beside a limit that it may be close to.
fn amount(axis: Axis, value: f64) -> String {
    if axis == Axis::Feed { format!("{:.3}", Mm(value)) } else { format!("{value:.3}\u{b0}") }
}

/// Why there is no driver, or why it did not do what it was asked.
#[derive(Debug, thiserror::Error)]
pub enum DriverProblem {
    /// There is no driver with this id.
    #[error("there is no driver '{id}'")]
    NoDriver {
        /// The wanted one.
        id: String,
        /// Libraries that were not accepted.
        waiting: Vec<PathBuf>,
    },
    /// A machine's own format cannot be written without its driver.
    #[error("'{format}' is written by the driver of the machine: {cause}")]
    OwnFormat {
        format: String,
        /// Why there is no such driver.
        cause: Box<DriverProblem>,
    },
    /// A driver failed, is not trusted, or refused.
    #[error(transparent)]
    Host(#[from] HostError),
    /// A driver does not write this wire.
    #[error("'{driver}' does not write this as {format}: {error}")]
    Unwritten { driver: String, format: String, error: DriverError },
    /// A driver does not take its settings.
    #[error("the settings of the driver '{driver}' cannot be used: {error}")]
    Settings {
        driver: String,
        /// Which of them, and what was expected.
        error: DriverError,
    },
    /// A step of the wire would be refused in the middle of it.
    #[error(
        "wire {}: with step {step} {goes} {}, and {by} takes no more than {} ({because})",
        .wire.saturating_add(1), amount(*.axis, *.value), amount(*.axis, *.most)
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
        /// Whether the driver or the machine refuses it.
        by: &'static str,
        /// What is taken.
        most: f64,
        /// What both are of.
        axis: Axis,
        /// Where the limit comes from.
        because: String,
    },
    /// A library cannot be read.
    #[error("{}: the library cannot be read: {cause}", file.display())]
    Library { file: PathBuf, cause: std::io::Error },
    /// Another library was accepted than the one that is there.
    #[error("{} is not the library that was meant: its SHA-256 is {found}", file.display())]
    OtherLibrary { file: PathBuf, found: String },
    /// There is no place for the list of accepted libraries.
    #[error("there is no folder of yours to keep the list of accepted drivers in")]
    NowhereToTrust,
    /// The running program's file is not known, and so no driver can be started.
    #[error("the system does not report which file this program is, so that no driver can be started: {0}")]
    OwnProgram(std::io::Error),
}

impl DriverProblem {
    /// The kind of error, which gives the exit status.
    pub fn kind(&self) -> ErrorKind {
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
    pub fn code(&self) -> ErrorCode {
        match self {
            Self::OwnFormat { cause, .. } => cause.code(),
            Self::NoDriver { .. } => ErrorCode::NoDriver,
            Self::Host(error) => error.code(),
            Self::Unwritten { .. } => ErrorCode::Unwritten,
            Self::BeyondLimit { .. } => ErrorCode::BeyondLimit,
            Self::Settings { .. } => ErrorCode::DriverSettings,
            Self::Library { .. } => ErrorCode::DriverLibrary,
            Self::OtherLibrary { .. } => ErrorCode::OtherLibrary,
            Self::NowhereToTrust => ErrorCode::NowhereToTrust,
            Self::OwnProgram(_) => ErrorCode::OwnProgram,
        }
    }
}

impl DriverProblem {
    /// Refuses a wire, by its index from 0, with a step that would be refused in its middle; those before `from`, counted
    /// from 1, are done.
    pub fn require_within(
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
        let goes = match (axis, of) {
            (Axis::Feed, Extent::Step) => "the wire is fed",
            (Axis::Feed, Extent::Position) => "the wire is fed in all",
            (Axis::Rotate, Extent::Step) => "the head turns",
            (Axis::Rotate, Extent::Position) => "the head comes to",
            (Axis::Bend, Extent::Step) => "the bend axis goes to",
            (Axis::Bend, Extent::Position) => "the bend axis comes to",
        };
        let because = setting.as_ref().map_or_else(|| reason.clone(), |key| format!("driver setting {key}"));
        Self::BeyondLimit { wire, step, goes, value, by, most: *most, axis: *axis, because }
    }
}
