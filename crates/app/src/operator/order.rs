//! What an operator can be told, and what a person can answer.

use std::fmt;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::design::Input;
use crate::{Decided, Move, PartOfStep};

/// What an operator is told to do. A stop is none of these: it is always possible.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(tag = "order", rename_all = "kebab-case", deny_unknown_fields)]
pub enum Order {
    /// The machine searches its reference.
    Home,
    /// Moves by hand.
    Jog {
        /// The moves, in order.
        moves: Vec<Move>,
        /// Whether those that are made are kept for a recording.
        #[serde(default)]
        record: bool,
    },
    /// Checks a wire of a job and asks a person; after a yes it can be started.
    Arm {
        /// The job.
        job: Input,
        /// Index of the wire, from 0.
        wire: usize,
        /// Whether to make it although the machine's settings are not those of its profile.
        #[serde(default)]
        accept_settings: bool,
    },
    /// What was armed is not started.
    Disarm,
    /// Makes the armed wire.
    Start,
    /// The machine holds in the middle of a wire.
    Pause,
    /// It goes on after a pause.
    Resume,
    /// Goes on with a wire that was interrupted. Steps of which nobody knows are asked about one by one.
    ResumeRun {
        /// The job.
        job: Input,
        /// Index of the wire, from 0.
        wire: usize,
        /// What became of the first step of which nobody knows; absent, a person is asked where the machine cannot tell.
        #[serde(default)]
        decided: Option<Decided>,
        /// Whether to make it although the machine's settings are not those of its profile.
        #[serde(default)]
        accept_settings: bool,
    },
    /// Gives up a wire that was interrupted, so that it can be begun anew. Nothing moves for it.
    Abandon {
        /// The job.
        job: Input,
        /// Index of the wire, from 0.
        wire: usize,
    },
    /// Makes recorded moves again.
    Replay {
        /// The recording.
        file: Input,
        /// Whether to make them although they were recorded on another machine, or before its profile was changed.
        #[serde(default)]
        other_machine: bool,
    },
    /// Sets the machine as its profile says, for good. Nothing moves for it, and it has to be homed afterwards.
    WriteSettings,
    /// Closes the port.
    Disconnect,
}

/// An order without its particulars, such as for a button.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum OrderName {
    /// [`Order::Home`].
    Home,
    /// [`Order::Jog`].
    Jog,
    /// [`Order::Arm`].
    Arm,
    /// [`Order::Disarm`].
    Disarm,
    /// [`Order::Start`].
    Start,
    /// [`Order::Pause`].
    Pause,
    /// [`Order::Resume`].
    Resume,
    /// [`Order::ResumeRun`].
    ResumeRun,
    /// [`Order::Abandon`].
    Abandon,
    /// [`Order::Replay`].
    Replay,
    /// [`Order::WriteSettings`].
    WriteSettings,
    /// [`Order::Disconnect`].
    Disconnect,
}

impl Order {
    /// Its name.
    #[must_use]
    pub const fn name(&self) -> OrderName {
        match self {
            Self::Home => OrderName::Home,
            Self::Jog { .. } => OrderName::Jog,
            Self::Arm { .. } => OrderName::Arm,
            Self::Disarm => OrderName::Disarm,
            Self::Start => OrderName::Start,
            Self::Pause => OrderName::Pause,
            Self::Resume => OrderName::Resume,
            Self::ResumeRun { .. } => OrderName::ResumeRun,
            Self::Abandon { .. } => OrderName::Abandon,
            Self::Replay { .. } => OrderName::Replay,
            Self::WriteSettings => OrderName::WriteSettings,
            Self::Disconnect => OrderName::Disconnect,
        }
    }
}

impl fmt::Display for OrderName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Home => "homing",
            Self::Jog => "moving by hand",
            Self::Arm => "arming",
            Self::Disarm => "disarming",
            Self::Start => "starting a wire",
            Self::Pause => "pausing",
            Self::Resume => "going on after a pause",
            Self::ResumeRun => "going on with an interrupted wire",
            Self::Abandon => "giving up a wire",
            Self::Replay => "replaying moves",
            Self::WriteSettings => "writing settings",
            Self::Disconnect => "disconnecting",
        })
    }
}

/// What a person says to a question.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Answer {
    /// Yes.
    Yes,
    /// No; of a step in doubt: nobody knows.
    No,
    /// A step in doubt was made to its end.
    Made,
    /// Nothing was made of what was sent of a step in doubt.
    NotMade,
    /// As much of it is in the wire as the machine has counted: the rest is made.
    AsCounted,
    /// So much of it is in the wire: the rest is made.
    Part(PartOfStep),
    /// The head stands here, degrees from where its cable is unwound.
    Head(f64),
}
