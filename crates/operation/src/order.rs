//! The orders of a machine, and what a person can answer.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_core::units::Mm;
use wirebend_driver_host::OrderName;
use wirebend_error::InputName;

use wirebend_planning::{PartOfStep, PlanningError};

use crate::event::Decided;
use crate::pieces::Repeat;

/// One axis by an amount, in canonical signs, or homing.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "move", rename_all = "kebab-case", deny_unknown_fields)]
pub enum Move {
    /// The machine finds its reference.
    Home,
    Feed {
        /// By so much; below 0 back into the machine.
        mm: f64,
    },
    /// Turns the head about the wire.
    Rotate {
        /// By so much, right-handed about the direction of travel.
        deg: f64,
    },
    /// Moves the bend axis. On a machine with a peg that is a whole bend: out with the peg, there and back, in.
    Bend {
        /// By so much.
        deg: f64,
    },
}

/// An order for a connected machine. STOP is none of these: it is always possible.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(tag = "order", rename_all = "kebab-case", deny_unknown_fields)]
pub enum Order {
    /// The machine homes.
    Home,
    /// Moves by hand.
    Jog {
        moves: Vec<Move>,
        /// Whether those that are done are kept for a recording.
        #[serde(default)]
        record: bool,
    },
    /// Plans the open design, checks its wires and asks a person; after a yes the first one can be started.
    Arm {
        /// Index of the one wire to bend, from 0; absent, all of them, one after the other: before each a person is asked.
        #[serde(default)]
        wire: Option<usize>,
        /// How many pieces are bent in a row; before each a person is asked.
        #[serde(default)]
        repeat: Repeat,
        /// Whether to bend it although the machine's settings are not those of its profile.
        #[serde(default)]
        accept_settings: bool,
        /// Whether to bend it although a check says that the machine cannot make it.
        #[serde(default)]
        despite_errors: bool,
    },
    /// What was armed is not started.
    Disarm,
    /// Bends what is armed.
    Start,
    /// The machine holds in the middle of a wire.
    Pause,
    /// It resumes after a pause.
    Resume,
    /// The wire is bent slower or faster than it is programmed, from the next move on at the latest. Every wire begins with 100.
    Speed {
        /// Percent of the programmed speed.
        #[schemars(range(min = 10, max = 200))]
        percent: u8,
    },
    /// Resumes the wire that was interrupted.
    ResumeRun {
        job_hash: String,
        /// Index of the wire, from 0.
        wire: usize,
        /// What became of the first step in doubt; absent, the user is asked.
        #[serde(default)]
        decided: Option<Decided>,
        /// Whether to bend it although the machine's settings are not those of its profile.
        #[serde(default)]
        accept_settings: bool,
    },
    /// Gives up the wire that was interrupted. Nothing moves for it.
    Abandon {
        job_hash: String,
        /// Index of the wire, from 0.
        wire: usize,
    },
    /// Replays recorded moves. A person is asked each time.
    Replay {
        /// The recording; absent, the moves that are recorded now.
        #[serde(default)]
        file: Option<PathBuf>,
        /// Whether to replay those of a file although they were recorded on another machine, or before its profile was changed.
        #[serde(default)]
        other_machine: bool,
    },
    /// Makes the moves of a wire of the open design or file with no wire loaded, slowly, the peg in. A person is asked first.
    DryRun {
        /// Index of the wire, from 0.
        wire: usize,
        /// Whether to do it although the machine's settings are not those of its profile.
        #[serde(default)]
        accept_settings: bool,
        /// Whether to do it although a check says that the machine cannot make the wire.
        #[serde(default)]
        despite_errors: bool,
    },
    /// Sets the machine as its profile says, for good. Nothing moves for it, and it has to be homed afterwards.
    WriteSettings,
    /// Passes on a line that was typed. A question changes nothing; for anything else the user is asked, and the machine has to be
    /// homed afterwards.
    Console {
        #[schemars(length(min = 1, max = 256))]
        line: String,
    },
    /// Closes the port.
    Disconnect,
}

impl Move {
    /// Refuses a number that cannot be sent to a machine.
    pub fn check(self) -> Result<(), PlanningError> {
        let (name, value) = match self {
            Self::Home => return Ok(()),
            Self::Feed { mm } => ("a feed", mm),
            Self::Rotate { deg } => ("a rotation", deg),
            Self::Bend { deg } => ("a bend", deg),
        };
        if value.is_finite() {
            return Ok(());
        }
        let expected = "a finite number of mm or degrees";
        Err(PlanningError::Value { input: Some(InputName::Moves), name, value: value.to_string(), expected })
    }
}

impl std::fmt::Display for Move {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        // To what a machine does of it.
        let shown = |by: f64| (by * 1000.0).round() / 1000.0 + 0.0;
        match self {
            Self::Home => f.write_str("home"),
            Self::Feed { mm } => write!(f, "feed {}", Mm(shown(*mm))),
            Self::Rotate { deg } => write!(f, "rotate {}°", shown(*deg)),
            Self::Bend { deg } => write!(f, "bend {}°", shown(*deg)),
        }
    }
}

impl Order {
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
            Self::Speed { .. } => OrderName::Speed,
            Self::ResumeRun { .. } => OrderName::ResumeRun,
            Self::Abandon { .. } => OrderName::Abandon,
            Self::Replay { .. } => OrderName::Replay,
            Self::DryRun { .. } => OrderName::DryRun,
            Self::WriteSettings => OrderName::WriteSettings,
            Self::Console { .. } => OrderName::Console,
            Self::Disconnect => OrderName::Disconnect,
        }
    }

    /// Whether it is about a wire of a job, which is given with it.
    #[must_use]
    pub const fn is_of_job(&self) -> bool {
        matches!(self, Self::Arm { .. } | Self::DryRun { .. } | Self::ResumeRun { .. } | Self::Abandon { .. })
    }

    /// Whether something moves or is set by it, or is to be.
    #[must_use]
    pub const fn moves(&self) -> bool {
        match self {
            Self::Home
            | Self::Jog { .. }
            | Self::Arm { .. }
            | Self::Start
            | Self::ResumeRun { .. }
            | Self::Replay { .. }
            | Self::DryRun { .. }
            | Self::WriteSettings
            | Self::Console { .. } => true,
            // A wire that was begun continues as it was begun.
            Self::Disarm
            | Self::Pause
            | Self::Resume
            | Self::Speed { .. }
            | Self::Abandon { .. }
            | Self::Disconnect => false,
        }
    }
}

/// What a person says to a question.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Answer {
    Yes,
    /// No; of a step in doubt: the user does not know.
    No,
    /// A step in doubt is done.
    Made,
    /// Nothing was done of what was sent of a step in doubt.
    NotMade,
    /// As much of it is in the wire as the machine has counted: the rest is bent.
    AsCounted,
    /// So much of it is in the wire: the rest is bent.
    Part(PartOfStep),
    /// The head stands here, degrees from where its cable is unwound.
    Head(f64),
}
