//! Why a session does not do what it was asked.

use wirebend_driver_api::{Capability, SettingCheck};
use wirebend_error::{ErrorCode, ErrorRemedy};

use super::permit_kind::PermitKind;
use super::phase::{Act, Phase};
use crate::error::HostError;

/// Why a session does not do what it was asked. The machine does not move for it.
#[derive(Debug, thiserror::Error)]
pub enum SessionError {
    /// It is not the time for it.
    #[error("{act} is not possible while the machine is {state}; it has to be {expected}")]
    State {
        /// What was asked.
        act: Act,
        /// What the machine is in.
        state: Phase,
        /// When it is possible.
        expected: &'static str,
    },
    /// The machine was armed again, or stopped, since.
    #[error("the machine was stopped or armed anew since this was confirmed")]
    Stale,
    /// The yes is to a question of another session, or the permit is another session's.
    #[error("this was confirmed for another connection")]
    OtherSession,
    /// The question was answered before, or another one was asked since.
    #[error("this confirmation was used before, or another question was asked since")]
    ConfirmationUsed,
    /// A stop ends what was confirmed before it.
    #[error("the machine was stopped since this was confirmed")]
    StoppedSince,
    /// The person was asked for something else.
    #[error("{act} was not confirmed, only {permitted}")]
    NotPermitted {
        /// What was to be done.
        act: &'static str,
        /// What was confirmed.
        permitted: PermitKind,
    },
    /// The session is armed for moves by hand.
    #[error("the machine is armed for moves by hand, not for a wire")]
    NotForAWire,
    /// The session is armed for a wire.
    #[error("the machine is armed for a wire, not for moves by hand")]
    ForAWire,
    /// The axes are not where a wire has to start.
    #[error("the head stands {rotate_deg:.3}° and the bend axis {bend_deg:.3}° from where a wire starts")]
    OffZero {
        /// The head.
        rotate_deg: f64,
        /// The bend axis.
        bend_deg: f64,
    },
    /// It is not known where the head stands, and the machine has no switch to find it.
    #[error(
        "it is not known where the head stands, between {least:.1}° and {most:.1}° from its zero as the machine counts"
    )]
    HeadUnknown { least: f64, most: f64 },
    /// Where the head will stand cannot be written down, and so it was not turned.
    #[error("where the head stands cannot be kept: {cause}; nothing was moved")]
    HeadNotKept { cause: String },
    /// The machine is set otherwise than its profile says.
    #[error(
        "the machine is not set as its profile says, and wires would come out wrong: {}",
        listed(settings)
    )]
    SettingsDiffer { settings: Vec<SettingCheck> },
    /// Steps with a gap, out of order, or too many.
    #[error("the steps have to follow number {sent} without a gap, and end with {total} at most")]
    Steps {
        /// The last that was sent.
        sent: u32,
        /// How many the wire has.
        total: u32,
    },
    /// The driver reports steps that cannot be.
    #[error("the driver reports step {n}, after {done} and with {sent} sent: its reports are inconsistent")]
    OutOfOrder {
        /// What it reports.
        n: u32,
        /// The last before.
        done: u32,
        /// The last that was sent.
        sent: u32,
    },
    /// The driver or its machine cannot do this at all.
    #[error("the driver '{driver}' cannot do this: it lacks '{}'", word(*capability))]
    Unsupported {
        driver: String,
        /// What it lacks.
        capability: Capability,
    },
    /// The driver was built before wires could be resumed.
    #[error("the driver '{driver}' is too old to begin a wire after step {after}: it would pass over that")]
    TooOld {
        driver: String,
        /// How many steps are done.
        after: u32,
    },
    /// The driver failed or refused.
    #[error(transparent)]
    Host(#[from] HostError),
}

impl SessionError {
    /// A name that stays the same while the wording may change.
    #[must_use]
    pub fn code(&self) -> ErrorCode {
        match self {
            Self::State { .. } => ErrorCode::SessionState,
            Self::Stale => ErrorCode::SessionStale,
            Self::OtherSession => ErrorCode::ConfirmationOfAnother,
            Self::ConfirmationUsed => ErrorCode::ConfirmationUsed,
            Self::StoppedSince => ErrorCode::StoppedSince,
            Self::NotPermitted { .. } => ErrorCode::NotPermitted,
            Self::NotForAWire | Self::ForAWire => ErrorCode::SessionPurpose,
            Self::OffZero { .. } => ErrorCode::OffZero,
            Self::HeadUnknown { .. } => ErrorCode::HeadUnknown,
            Self::HeadNotKept { .. } => ErrorCode::HeadNotKept,
            Self::SettingsDiffer { .. } => ErrorCode::SettingsDiffer,
            Self::Steps { .. } => ErrorCode::Steps,
            Self::OutOfOrder { .. } => ErrorCode::OutOfOrder,
            Self::Unsupported { .. } => ErrorCode::Unsupported,
            Self::TooOld { .. } => ErrorCode::DriverTooOld,
            Self::Host(error) => error.code(),
        }
    }

    /// What can be done about it.
    #[must_use]
    pub fn remedies(&self) -> Vec<ErrorRemedy> {
        match self {
            Self::Stale | Self::NotForAWire | Self::ForAWire => vec![ErrorRemedy::ArmAgain],
            Self::OtherSession | Self::ConfirmationUsed | Self::StoppedSince | Self::NotPermitted { .. } => {
                vec![ErrorRemedy::AskAgain]
            }
            Self::OffZero { .. } => vec![ErrorRemedy::TurnAxesBack, ErrorRemedy::Home],
            Self::HeadUnknown { .. } => vec![ErrorRemedy::StateHead],
            Self::HeadNotKept { .. } => vec![ErrorRemedy::CheckDisk],
            Self::SettingsDiffer { .. } => vec![ErrorRemedy::SetMachine, ErrorRemedy::AcceptSettings],
            Self::State { .. } | Self::Steps { .. } => Vec::new(),
            Self::OutOfOrder { .. } => vec![ErrorRemedy::Stop, ErrorRemedy::LookAtWire],
            Self::Unsupported { .. } => vec![ErrorRemedy::UseOtherMachine],
            Self::TooOld { .. } => vec![ErrorRemedy::UpdateDriver, ErrorRemedy::BeginAnew],
            Self::Host(error) => error.remedies(),
        }
    }
}

fn listed(settings: &[SettingCheck]) -> String {
    let one = |s: &SettingCheck| format!("{} is {}, not {}", s.name, s.machine, s.expected);
    settings.iter().map(one).collect::<Vec<_>>().join(", ")
}

const fn word(capability: Capability) -> &'static str {
    match capability {
        Capability::Export => "export",
        Capability::Live => "live",
        Capability::Jog => "jog",
        Capability::DryRun => "dry-run",
        Capability::BeforeZero => "before-zero",
        Capability::Console => "console",
        Capability::Cut => "cut",
        Capability::Speed => "speed",
        Capability::Home => "home",
        Capability::Pause => "pause",
        Capability::Resume => "resume",
        Capability::Stop => "stop",
        Capability::Ports => "ports",
        Capability::Settings => "settings",
        Capability::Unknown => "something newer",
    }
}

wirebend_error::reported!(SessionError);
