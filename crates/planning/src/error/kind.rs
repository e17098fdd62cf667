//! The kind of an error, which gives the exit status, and the name by which a front end knows it.

use wirebend_error::ErrorCode;
use wirebend_files::document::DocumentError;
use wirebend_profile::ProfileError;

use super::PlanningError;
use crate::report::PlanReport;

/// The kind of an error, which gives the exit status.
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

impl PlanningError {
    /// The kind of error, which gives the exit status.
    #[must_use]
    pub fn kind(&self) -> ErrorKind {
        match self {
            Self::Driver(problem) => problem.kind(),
            Self::Stopped => ErrorKind::Stopped,
            Self::Document(DocumentError::Save { .. } | DocumentError::Write(_))
            | Self::NoModes { .. }
            | Self::Picture(_)
            | Self::Json(_) => ErrorKind::Failure,
            Self::Profile(
                ProfileError::Unknown { .. } | ProfileError::UnknownId { .. } | ProfileError::Abstract { .. },
            )
            | Self::Value { .. }
            | Self::NoMachine { .. }
            | Self::NoMaterial { .. }
            | Self::NoLimit
            | Self::NoWalks { .. }
            | Self::LoadCase { .. }
            | Self::OnlyLengths
            | Self::IdTaken { .. }
            | Self::ShippedProfile { .. }
            | Self::NothingToRevert { .. }
            | Self::SeveralKinds { .. }
            | Self::OtherKind { .. }
            | Self::OpenParent { .. }
            | Self::UnknownFormat { .. }
            | Self::NoSettings { .. }
            | Self::OtherMachine { .. }
            | Self::NoBender { .. }
            | Self::FormatOfAnother { .. }
            | Self::Settled { .. }
            | Self::WithoutEffect { .. }
            | Self::ClosedWires { .. }
            | Self::NotAJob { .. }
            | Self::GCodeToRun { .. }
            | Self::IsAJob { .. }
            | Self::Exists(_) => ErrorKind::Usage,
            Self::Read(_)
            | Self::Document(_)
            | Self::Profile(_)
            | Self::Geometry { .. }
            | Self::NoShearModulus { .. }
            | Self::StrutWithoutLength { .. }
            | Self::NoFrame { .. }
            | Self::SequenceFile { .. }
            | Self::OtherDesign { .. }
            | Self::StrutBuilder { .. }
            | Self::Faces { .. }
            | Self::Closing { .. }
            | Self::Springback { .. }
            | Self::Calibration(_)
            | Self::Beyond { .. }
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
    pub fn code(&self) -> ErrorCode {
        match self {
            Self::Read(error) => error.code(),
            Self::Document(error) => error.code(),
            Self::Profile(error) => error.code(),
            Self::Geometry { .. } | Self::StrutBuilder { .. } => ErrorCode::MachineGeometry,
            Self::NoMaterial { .. } => ErrorCode::NoMaterial,
            Self::NoShearModulus { .. } => ErrorCode::NoShearModulus,
            Self::StrutWithoutLength { .. } => ErrorCode::StrutWithoutLength,
            Self::NoFrame { .. } => ErrorCode::NoFrame,
            Self::NoWalks { .. } => ErrorCode::NoWalks,
            Self::SequenceFile { .. } => ErrorCode::SequenceFile,
            Self::OtherDesign { error, .. } => error.code(),
            Self::NoModes { .. } => ErrorCode::NoModes,
            Self::LoadCase { .. } => ErrorCode::LoadCase,
            Self::Closing { .. } => ErrorCode::ClosingJoints,
            Self::Faces { .. } => ErrorCode::Faces,
            Self::NoLimit => ErrorCode::NoLimit,
            Self::OnlyLengths => ErrorCode::OnlyLengths,
            Self::Stopped => ErrorCode::Stopped,
            Self::Springback { .. } => ErrorCode::SpringbackTable,
            Self::Noise { .. } => ErrorCode::NoiseProfile,
            Self::Calibration(_) | Self::Beyond { .. } => ErrorCode::Calibration,
            Self::ShippedProfile { .. } => ErrorCode::ShippedProfile,
            Self::NothingToRevert { .. } => ErrorCode::NothingToRevert,
            Self::Value { .. } => ErrorCode::Value,
            Self::IdTaken { .. } => ErrorCode::IdTaken,
            Self::SeveralKinds { .. } => ErrorCode::SeveralKinds,
            Self::OtherKind { .. } => ErrorCode::OtherKind,
            Self::OpenParent { .. } => ErrorCode::OpenParent,
            Self::Compensated { .. } => ErrorCode::Compensated,
            Self::OtherCompensation { .. } => ErrorCode::OtherCompensation,
            Self::NoOrder { .. } => ErrorCode::NoOrder,
            Self::NoSurface { .. } => ErrorCode::NoSurface,
            Self::Stencil(_) => ErrorCode::StencilMissing,
            Self::NoMachine { .. } => ErrorCode::NoMachine,
            Self::OnlyStencil { .. } => ErrorCode::OnlyStencil,
            Self::NoVertex { .. } => ErrorCode::NoVertex,
            Self::UnknownFormat { .. } => ErrorCode::UnknownFormat,
            Self::NoSettings { .. } => ErrorCode::NoSettings,
            Self::Driver(problem) => problem.code(),
            Self::OtherMachine { .. } => ErrorCode::OtherMachine,
            Self::NoBender { .. } => ErrorCode::NoBender,
            Self::FormatOfAnother { .. } => ErrorCode::FormatOfAnother,
            Self::Settled { .. } => ErrorCode::Settled,
            Self::WithoutEffect { .. } => ErrorCode::WithoutEffect,
            Self::ClosedWires { .. } => ErrorCode::ClosedWires,
            Self::StartWithoutEdge { .. } => ErrorCode::StartWithoutEdge,
            Self::DamagedJob { .. } => ErrorCode::DamagedJob,
            Self::NotAJob { .. } | Self::GCodeToRun { .. } => ErrorCode::NotAJob,
            Self::IsAJob { .. } => ErrorCode::IsAJob,
            Self::Unwritable { .. } => ErrorCode::Unwritable,
            Self::StageNotReached { .. } => ErrorCode::StageNotReached,
            Self::NotFeasible { .. } => ErrorCode::NotFeasible,
            Self::Exists(_) => ErrorCode::Exists,
            Self::Picture(_) => ErrorCode::Picture,
            Self::Json(_) => ErrorCode::Json,
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
