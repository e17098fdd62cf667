//! Whose turn it is after an error, and the name by which a front end knows it.

use wirebend_files::document::DocumentError;
use wirebend_profile::ProfileError;

use super::AppError;
use crate::report::PlanReport;

/// Whose turn it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum ErrorKind {
    /// The command was given in a way that cannot be followed.
    Usage,
    /// A file, a profile or a value in it is wrong.
    BadInput,
    /// The machine cannot make it.
    NotFeasible,
    /// A machine, a driver or this computer failed.
    Failure,
    /// A person has stopped it.
    Stopped,
    /// A machine was stopped, or its driver was lost, and the machine has not confirmed that it stands.
    MayMove,
}

impl AppError {
    /// Whose turn it is.
    #[must_use]
    pub fn kind(&self) -> ErrorKind {
        match self {
            Self::Driver(problem) => problem.kind(),
            Self::Live(problem) => problem.kind(),
            Self::Operator(problem) => problem.kind(),
            Self::Document(DocumentError::Save { .. } | DocumentError::Write(_))
            | Self::Picture(_)
            | Self::Json(_) => ErrorKind::Failure,
            Self::Profile(
                ProfileError::Unknown { .. } | ProfileError::UnknownId { .. } | ProfileError::Abstract { .. },
            )
            | Self::Value { .. }
            | Self::NoFile
            | Self::NoExample { .. }
            | Self::ShippedProfile { .. }
            | Self::NoOwnFolder
            | Self::Editor(_)
            | Self::NoMachine { .. }
            | Self::IdTaken { .. }
            | Self::SeveralKinds { .. }
            | Self::OtherKind { .. }
            | Self::OpenParent { .. }
            | Self::UnknownFormat { .. }
            | Self::NoSettings { .. }
            | Self::OtherMachine { .. }
            | Self::FormatOfAnother { .. }
            | Self::Settled { .. }
            | Self::NotAJob { .. }
            | Self::IsAJob { .. }
            | Self::Exists(_) => ErrorKind::Usage,
            Self::Read(_)
            | Self::Document(_)
            | Self::Profile(_)
            | Self::Geometry { .. }
            | Self::Springback { .. }
            | Self::Noise { .. }
            | Self::OnlyStencil { .. }
            | Self::NoSurface { .. }
            | Self::Compensated { .. }
            | Self::OtherCompensation { .. }
            | Self::NoOrder { .. }
            | Self::Stencil(_)
            | Self::StartWithoutEdge { .. }
            | Self::DamagedJob { .. }
            | Self::NoVertex { .. } => ErrorKind::BadInput,
            Self::Unwritable { .. } | Self::StageNotReached { .. } | Self::NotFeasible { .. } => {
                ErrorKind::NotFeasible
            }
        }
    }

    /// A name that stays the same while the wording may change.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::Read(error) => error.code(),
            Self::Document(error) => error.code(),
            Self::Profile(error) => error.code(),
            Self::Geometry { .. } => "machine-geometry",
            Self::Springback { .. } => "springback-table",
            Self::Noise { .. } => "noise-profile",
            Self::Value { .. } => "value",
            Self::IdTaken { .. } => "id-taken",
            Self::SeveralKinds { .. } => "several-kinds",
            Self::OtherKind { .. } => "other-kind",
            Self::OpenParent { .. } => "open-parent",
            Self::Compensated { .. } => "compensated",
            Self::OtherCompensation { .. } => "other-compensation",
            Self::NoOrder { .. } => "no-order",
            Self::NoFile => "no-file",
            Self::NoExample { .. } => "no-example",
            Self::ShippedProfile { .. } => "shipped-profile",
            Self::NoOwnFolder => "no-own-folder",
            Self::NoSurface { .. } => "no-surface",
            Self::Stencil(_) => "stencil-missing",
            Self::Editor(error) => error.code(),
            Self::NoMachine { .. } => "no-machine",
            Self::OnlyStencil { .. } => "only-stencil",
            Self::NoVertex { .. } => "no-vertex",
            Self::UnknownFormat { .. } => "unknown-format",
            Self::NoSettings { .. } => "no-settings",
            Self::Driver(problem) => problem.code(),
            Self::Live(problem) => problem.code(),
            Self::Operator(problem) => problem.code(),
            Self::OtherMachine { .. } => "other-machine",
            Self::FormatOfAnother { .. } => "format-of-another",
            Self::Settled { .. } => "settled",
            Self::StartWithoutEdge { .. } => "start-without-edge",
            Self::DamagedJob { .. } => "damaged-job",
            Self::NotAJob { .. } => "not-a-job",
            Self::IsAJob { .. } => "is-a-job",
            Self::Unwritable { .. } => "unwritable",
            Self::StageNotReached { .. } => "stage-not-reached",
            Self::NotFeasible { .. } => "not-feasible",
            Self::Exists(_) => "exists",
            Self::Picture(_) => "picture",
            Self::Json(_) => "json",
        }
    }

    /// What the checks said, where that is the reason.
    #[must_use]
    pub fn report(&self) -> Option<&PlanReport> {
        match self {
            Self::StageNotReached { report, .. } | Self::NotFeasible { report, .. } => Some(report),
            _ => None,
        }
    }
}
