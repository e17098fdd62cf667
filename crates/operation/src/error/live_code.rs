//! The kind of a problem, which gives the exit status, and its name for programs.

use wirebend_driver_host::SessionError;
use wirebend_driver_host::jobs::{JobError, JournalError};

use wirebend_error::ErrorCode;

use super::LiveProblem;
use wirebend_planning::ErrorKind;

impl LiveProblem {
    /// The kind of error, which gives the exit status.
    pub fn kind(&self) -> ErrorKind {
        match self {
            Self::NoPort { .. }
            | Self::FilesOnly { .. }
            | Self::NotConfirmed
            | Self::YesForPieces { .. }
            | Self::ZeroNotConfirmed
            | Self::Head(_)
            | Self::NoWire { .. }
            | Self::WhichWire { .. }
            | Self::BendTooFar { .. }
            | Self::NoCutter { .. }
            | Self::EndTooShort { .. }
            | Self::Unfinished { .. }
            | Self::SeveralUnfinished { .. }
            | Self::WireInMachine { .. }
            | Self::NothingBegun { .. }
            | Self::NothingUnfinished
            | Self::NotSimulated { .. }
            | Self::InDoubt { .. }
            | Self::OtherStep { .. }
            | Self::NotCounted { .. }
            | Self::Contradiction { .. }
            | Self::NoRun { .. }
            | Self::SeveralRuns { .. }
            | Self::OtherMachine { .. }
            | Self::Job(JobError::NotOfStep { .. } | JobError::NotInDoubt { .. })
            | Self::Session(SessionError::Unsupported { .. }) => ErrorKind::Usage,
            Self::Moves { .. }
            | Self::DamagedJournal { .. }
            | Self::Job(
                JobError::Steps { .. }
                | JobError::OtherWire { .. }
                | JobError::Journal(JournalError::Damaged { .. } | JournalError::Empty { .. }),
            ) => ErrorKind::BadInput,
            Self::Declined | Self::Stopped { .. } | Self::Held { .. } | Self::Unstopped { .. } => {
                ErrorKind::Stopped
            }
            Self::MayMove { .. } | Self::Unrecorded { stands: false, .. } => ErrorKind::MayMove,
            Self::NoAnswer { .. }
            | Self::Unrecorded { .. }
            | Self::AtWork { .. }
            | Self::Fault(_)
            | Self::Session(_)
            | Self::Job(_)
            | Self::SettingsDiffer { .. }
            | Self::NowhereToRecord
            | Self::RunsFolder { .. } => ErrorKind::Failure,
        }
    }

    /// A name that stays the same while the wording may change.
    pub fn code(&self) -> ErrorCode {
        match self {
            Self::NoPort { .. } => ErrorCode::NoPort,
            Self::FilesOnly { .. } => ErrorCode::FilesOnly,
            Self::NotConfirmed | Self::YesForPieces { .. } => ErrorCode::NotConfirmed,
            Self::ZeroNotConfirmed => ErrorCode::ZeroNotConfirmed,
            Self::Head(problem) => problem.code(),
            Self::Declined => ErrorCode::Declined,
            Self::Stopped { .. } => ErrorCode::Stopped,
            Self::Held { .. } => ErrorCode::Held,
            Self::Unstopped { .. } => ErrorCode::DriverEnded,
            Self::MayMove { .. } => ErrorCode::StopNotConfirmed,
            Self::Unrecorded { error, .. } => error.code(),
            Self::NoAnswer { .. } => ErrorCode::NoAnswer,
            Self::AtWork { .. } => ErrorCode::MachineAtWork,
            Self::Fault(_) => ErrorCode::MachineFault,
            Self::Session(error) => error.code(),
            Self::Job(error) => error.code(),
            Self::SettingsDiffer { .. } => ErrorCode::SettingsDiffer,
            Self::NoWire { .. } => ErrorCode::NoWire,
            Self::WhichWire { .. } => ErrorCode::WhichWire,
            Self::BendTooFar { .. } => ErrorCode::BendTooFar,
            Self::NoCutter { .. } => ErrorCode::NoCutter,
            Self::EndTooShort { .. } => ErrorCode::EndTooShort,
            Self::Unfinished { .. } | Self::WireInMachine { .. } => ErrorCode::Unfinished,
            Self::DamagedJournal { .. } => ErrorCode::JournalDamaged,
            Self::SeveralUnfinished { .. } => ErrorCode::SeveralUnfinished,
            Self::NotSimulated { .. } => ErrorCode::NotSimulated,
            Self::NothingBegun { .. } => ErrorCode::NothingBegun,
            Self::NothingUnfinished => ErrorCode::NothingUnfinished,
            Self::InDoubt { .. } => ErrorCode::InDoubt,
            Self::OtherStep { .. } => ErrorCode::OtherStep,
            Self::NotCounted { .. } => ErrorCode::NotCounted,
            Self::Contradiction { .. } => ErrorCode::Contradiction,
            Self::NowhereToRecord => ErrorCode::NowhereToRecord,
            Self::RunsFolder { .. } => ErrorCode::RunsFolder,
            Self::NoRun { .. } => ErrorCode::NoRun,
            Self::SeveralRuns { .. } => ErrorCode::SeveralRuns,
            Self::Moves { .. } => ErrorCode::Moves,
            Self::OtherMachine { .. } => ErrorCode::MovesOfAnother,
        }
    }
}
