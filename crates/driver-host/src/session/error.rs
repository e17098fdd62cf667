//! Why a session does not do what it was asked.

use wirebend_driver_api::{Capability, SettingCheck};

use super::state::{Act, State};
use crate::error::HostError;

/// Why a session does not do what it was asked. The machine does not move for it.
#[derive(Debug, thiserror::Error)]
pub enum SessionError {
    /// It is not the time for it.
    #[error("{act} is not possible while the machine is {state}; it has to be {expected}")]
    State {
        /// What was asked.
        act: Act,
        /// The state.
        state: State,
        /// In which states it is possible.
        expected: &'static str,
    },
    /// The machine was armed again, or stopped, since.
    #[error("the machine was stopped or armed anew since this was confirmed: arm it again")]
    Stale,
    /// The session is armed for moves by hand.
    #[error("the machine is armed for moves by hand: arm it for the wire")]
    NotForAWire,
    /// The session is armed for a wire.
    #[error("the machine is armed for a wire: arm it for moves by hand")]
    ForAWire,
    /// The axes are not where a wire has to start.
    #[error(
        "the head stands {rotate_deg:.3}° and the bend axis {bend_deg:.3}° from where a wire starts: turn them back by hand, or home the machine"
    )]
    OffZero {
        /// The head.
        rotate_deg: f64,
        /// The bend axis.
        bend_deg: f64,
    },
    /// Nobody knows where the head stands, and the machine has no switch to find it.
    #[error(
        "nobody knows where the head stands, between {least:.1}° and {most:.1}° from its zero as the machine counts: look at it, and say where it stands"
    )]
    HeadUnknown {
        /// At least here.
        least: f64,
        /// At most here.
        most: f64,
    },
    /// Where the head will stand cannot be written down, and so it was not turned.
    #[error("where the head stands cannot be kept: {cause}; nothing was moved")]
    HeadNotKept {
        /// Why not.
        cause: String,
    },
    /// The machine is set otherwise than its profile says.
    #[error(
        "the machine is not set as its profile says, and wires would come out wrong: {}; set it, or accept the differences",
        listed(settings)
    )]
    SettingsDiffer {
        /// The settings.
        settings: Vec<SettingCheck>,
    },
    /// Steps with a gap, out of order, or too many.
    #[error("the steps have to follow number {sent} without a gap, and end with {total} at most")]
    Steps {
        /// The last that was sent.
        sent: u32,
        /// How many the wire has.
        total: u32,
    },
    /// The driver reports steps that cannot be.
    #[error(
        "the driver reports step {n}, after {done} and with {sent} sent: its account cannot be trusted; stop the machine and look"
    )]
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
        /// The driver.
        driver: String,
        /// What it lacks.
        capability: Capability,
    },
    /// The driver was built before wires could be taken up again.
    #[error(
        "the driver '{driver}' is too old to begin a wire after step {after}: it would pass over that; use a newer one, or make the wire anew"
    )]
    TooOld {
        /// The driver.
        driver: String,
        /// How many steps are made.
        after: u32,
    },
    /// The driver failed or refused.
    #[error(transparent)]
    Host(#[from] HostError),
}

impl SessionError {
    /// A name that stays the same while the wording may change.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::State { .. } => "session-state",
            Self::Stale => "session-stale",
            Self::NotForAWire | Self::ForAWire => "session-purpose",
            Self::OffZero { .. } => "off-zero",
            Self::HeadUnknown { .. } => "head-unknown",
            Self::HeadNotKept { .. } => "head-not-kept",
            Self::SettingsDiffer { .. } => "settings-differ",
            Self::Steps { .. } => "steps",
            Self::OutOfOrder { .. } => "out-of-order",
            Self::Unsupported { .. } => "unsupported",
            Self::TooOld { .. } => "driver-too-old",
            Self::Host(error) => error.code(),
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
        Capability::Home => "home",
        Capability::Pause => "pause",
        Capability::Resume => "resume",
        Capability::Stop => "stop",
        Capability::Ports => "ports",
        Capability::Settings => "settings",
        Capability::Unknown => "something newer",
    }
}
