//! What a connected driver reports without being asked.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::{DriverError, Limits, Step};

/// Something that happened on the machine or on the line to it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "event", rename_all = "kebab-case")]
pub enum Event {
    /// The machine has answered.
    Connected {
        /// What it says that it is.
        identity: String,
        /// Its settings against those of the driver.
        #[serde(default)]
        settings: Vec<SettingCheck>,
        /// Whether it knows where its axes are.
        #[serde(default)]
        homed: bool,
        /// The machine still is in the session of the token that `connect` was given; absent when it is not, as
        /// after a reset, or cannot report that. Since 1.1.
        #[serde(default, rename = "going_on")]
        resume: Option<ResumeState>,
        /// Whether the machine or a person brings the axes to their reference. Since 1.2.
        #[serde(default)]
        reference: ReferenceBy,
        /// What reports that a step is done. Since 1.2.
        #[serde(default)]
        done_by: DoneBy,
        /// What knows where the head stands. Since 1.3.
        #[serde(default)]
        head: HeadBy,
        /// What the machine itself says of how far its axes go and how fast at most, in the units of its driver's
        /// settings; of these and of [`Call::Limits`](crate::Call::Limits) all hold. Since 1.3.
        #[serde(default)]
        limits: Limits,
    },
    /// The machine has found its reference, or has taken the place where it stands as that.
    Homed,
    /// A step is done: the machine reports it, or its time is over where no machine reports anything.
    Done {
        /// The step.
        n: u32,
    },
    /// The last step is done and the machine is at rest.
    Finished,
    /// A jog is over.
    Jogged,
    /// The machine holds.
    Paused {
        /// Why. Since 1.1.
        #[serde(default)]
        by: PausedBy,
    },
    /// The machine resumes.
    Resumed,
    /// The speed override has changed, by request or at the machine. Since 1.5.
    Speed {
        /// The override, percent.
        percent: u8,
    },
    /// The machine has stopped.
    Stopped {
        /// Whether it still knows where its axes are.
        homed: bool,
    },
    /// The machine stands in the middle of a step, and has not begun those after it; every step before was reported.
    /// Reported before `stopped` or `fault`, or after a `fault` as soon as the machine stands. Since 1.2.
    PartMade {
        /// The step.
        step: u32,
        /// How much of its feed and its rotation was done, and where the bend axis stands, in the machine's signs; absent
        /// when the machine does not count that.
        #[serde(default)]
        made: Option<Step>,
        /// The axis that was on its way stands exactly there. False where it may have lost steps as it stopped.
        #[serde(default)]
        exact: bool,
    },
    /// Where the axes are, in the machine's signs.
    Position(Step),
    /// Settings were stored in the machine, by `write-settings`, or perhaps by a line of the console, and the machine has been asked
    /// for them afterwards. Since 1.1.
    SettingsWritten {
        /// The machine's settings against those of the driver, as in `connected`.
        #[serde(default)]
        settings: Vec<SettingCheck>,
        /// What the machine says of its axes by now, as in `connected`. Since 1.3.
        #[serde(default)]
        limits: Limits,
    },
    /// The wire as a simulated machine bent it; sent before `finished`. In the frame of the turtle at the start
    /// of the wire: it is at the origin and looks along +x, +z is the axis of the bend. Since 1.1.
    Made {
        /// Points along its middle, mm.
        wire_mm: Vec<[f64; 3]>,
        /// Both ends, and between them where its straight parts meet when they are prolonged, mm.
        corners_mm: Vec<[f64; 3]>,
    },
    /// The line of [`Call::Console`](crate::Call::Console) was answered, and the machine stands. Where it may have changed what the
    /// machine has stored, `settings-written` comes before. Since 1.7.
    ConsoleDone {
        /// Whether the machine still knows where its axes are. After anything but a question it does not.
        #[serde(default)]
        homed: bool,
        /// Whether an axis may have moved: not for a question, nor where only something was stored.
        #[serde(default = "yes")]
        moved: bool,
    },
    /// The wire is cut, its new tip is where a wire begins, and the machine is at rest. Since 1.7.
    Cut,
    /// A line to or from the machine.
    Console {
        /// Which way it went.
        direction: Direction,
        /// The line, without its end.
        text: String,
    },
    /// Something that a person should know and that ends nothing.
    Warning(DriverError),
    /// The run is over, or the connection is.
    Fault {
        /// What happened and what to do.
        #[serde(flatten)]
        error: DriverError,
        /// The step in doubt, of which it is not known whether it was done: the machine has not begun those after it,
        /// and will not. Absent where there is none, and where a machine that still has steps may resume by itself.
        #[serde(default)]
        in_doubt: Option<u32>,
        /// Whether the port is closed.
        #[serde(default)]
        disconnected: bool,
    },
    /// One of a later minor version, which this one does not know. It changes nothing.
    #[serde(other)]
    #[schemars(skip)]
    Unknown,
}

const fn yes() -> bool {
    true
}

/// Whether the machine or a person brings the axes to their reference.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum ReferenceBy {
    /// The machine: on `home` its axes move to their switches.
    #[default]
    Machine,
    /// A person. On `home` nothing moves: the place where the axes stand then is taken as zero, so that the program
    /// has to ask first whether they stand there.
    Person,
}

/// What reports that a step is done.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum DoneBy {
    /// The machine.
    #[default]
    Machine,
    /// The clock: the machine acknowledges nothing, and a step counts as done when its time is over. What was sent is not
    /// known to be done, not even that there is a machine.
    Clock,
}

/// What knows where the head stands, of which a cable allows a turn or less either way.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum HeadBy {
    /// The reference: after `home` the head stands at zero, by a switch of its own or because a person has brought it
    /// there.
    #[default]
    Reference,
    /// The program. No switch finds the head, and a machine that was switched on or reset counts from wherever it stands:
    /// with `home` the program says where that is, and `home` turns it back to zero. A `position` right before a `fault`
    /// is where the machine stands then, as before `stopped`.
    Program,
    /// The same, but the machine has not forgotten it since the wire of `resume` began, and need not be set.
    Kept,
}

/// Why a machine holds.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum PausedBy {
    /// The program has asked for it.
    Program,
    /// The machine has not heard of the program for too long.
    Silence,
    /// Something at the machine, such as a button or a door; or it cannot be known. A person has to confirm that it
    /// may resume.
    #[default]
    Machine,
}

/// Where a machine is in a session that was begun before, in the numbers of the wire's steps.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[schemars(rename = "GoingOn")] // as schemas have named it from the first
pub struct ResumeState {
    /// The last step that it has taken. It runs it without being sent it again.
    pub accepted: u32,
    /// The last that it has done.
    pub done: u32,
}

/// Which way a line went.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub enum Direction {
    /// To the machine.
    #[serde(rename = "->")]
    ToMachine,
    /// From the machine.
    #[serde(rename = "<-")]
    FromMachine,
}

/// A setting of the machine against what the driver's settings say.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct SettingCheck {
    /// What it is called, on the machine and for people.
    pub name: String,
    /// What the machine says.
    pub machine: String,
    /// What was expected.
    pub expected: String,
    /// Whether a program would come out wrong.
    pub matters: bool,
}
