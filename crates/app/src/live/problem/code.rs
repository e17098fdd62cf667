//! Whose turn it is after a problem, and its name for programs.

use wirebend_driver_host::SessionError;
use wirebend_driver_host::jobs::{JobError, JournalError};

use super::LiveProblem;
use crate::ErrorKind;

impl LiveProblem {
    /// Whose turn it is.
    pub(crate) fn kind(&self) -> ErrorKind {
        match self {
            Self::NoPort { .. }
            | Self::FilesOnly { .. }
            | Self::NotConfirmed
            | Self::ZeroNotConfirmed
            | Self::Head(_)
            | Self::NoWire { .. }
            | Self::Unfinished { .. }
            | Self::SeveralUnfinished { .. }
            | Self::NothingBegun { .. }
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
    pub(crate) fn code(&self) -> &'static str {
        match self {
            Self::NoPort { .. } => "no-port",
            Self::FilesOnly { .. } => "files-only",
            Self::NotConfirmed => "not-confirmed",
            Self::ZeroNotConfirmed => "zero-not-confirmed",
            Self::Head(problem) => problem.code(),
            Self::Declined => "declined",
            Self::Stopped { .. } => "stopped",
            Self::Held { .. } => "held",
            Self::Unstopped { .. } => "driver-ended",
            Self::MayMove { .. } => "stop-not-confirmed",
            Self::Unrecorded { error, .. } => job_code(error),
            Self::NoAnswer { .. } => "no-answer",
            Self::AtWork { .. } => "machine-at-work",
            Self::Fault(_) => "machine-fault",
            Self::Session(error) => error.code(),
            Self::Job(error) => job_code(error),
            Self::SettingsDiffer { .. } => "settings-differ",
            Self::NoWire { .. } => "no-wire",
            Self::Unfinished { .. } => "unfinished",
            Self::DamagedJournal { .. } => "journal-damaged",
            Self::SeveralUnfinished { .. } => "several-unfinished",
            Self::NothingBegun { .. } => "nothing-begun",
            Self::InDoubt { .. } => "in-doubt",
            Self::OtherStep { .. } => "other-step",
            Self::NotCounted { .. } => "not-counted",
            Self::Contradiction { .. } => "contradiction",
            Self::NowhereToRecord => "nowhere-to-record",
            Self::RunsFolder { .. } => "runs-folder",
            Self::NoRun { .. } => "no-run",
            Self::SeveralRuns { .. } => "several-runs",
            Self::Moves { .. } => "moves",
            Self::OtherMachine { .. } => "moves-of-another",
        }
    }
}

const fn job_code(error: &JobError) -> &'static str {
    match error {
        JobError::Journal(error) => match error {
            JournalError::Exists { .. } => "journal-exists",
            JournalError::InUse { .. } => "journal-in-use",
            JournalError::Empty { .. } => "journal-empty",
            JournalError::Damaged { .. } => "journal-damaged",
            JournalError::Impossible { .. } => "journal-impossible",
            JournalError::Broken { .. } | JournalError::Io { .. } => "journal-io",
        },
        JobError::Session(_) => "session",
        JobError::OtherWire { .. } => "other-wire",
        JobError::Steps { .. } => "steps",
        JobError::InDoubt { .. } | JobError::NotInDoubt { .. } => "in-doubt",
        JobError::NotOfStep { .. } => "not-of-step",
        JobError::AtWork => "at-work",
        JobError::Contradiction(_) => "contradiction",
        JobError::Nothing(_) => "nothing",
        JobError::NotBegun => "not-begun",
    }
}
