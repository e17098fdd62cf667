//! What an instance can be asked, and what it answers.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::{Bench, Job};

/// A request to an instance. Those from `home` on need a connection.
///
/// A driver refuses what it does not know as `unknown-call`, and so an older one does those of a later minor.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "call", rename_all = "kebab-case")]
pub enum Call {
    /// Writes a job in a format. Reply: [`Encoded`].
    Encode(Box<Encode>),
    /// Lists the ports of this computer. Needs no connection. Reply: [`Ports`](crate::Ports). Since 1.1.
    Ports,
    /// Reports how far the axes go and how fast, with the settings of this instance. Needs no connection. Reply:
    /// [`Limits`](crate::Limits). Since 1.2.
    Limits,
    /// Opens a port and greets the machine. Reply: `{}`; then the event `connected` or `fault`.
    Connect {
        /// Name of the port, such as `/dev/ttyUSB0` or `COM3`.
        port: String,
        /// Token of an earlier arming: the driver tries to resume the machine's own session, and says in
        /// `connected` whether the machine still is in it. Nothing moves for it. Since 1.1.
        #[serde(default)]
        resume: Option<String>,
    },
    /// Closes the port. Reply: `{}`. Nothing moves afterwards that the machine can be kept from.
    Disconnect,
    /// Finds the machine's reference. Reply: `{}`; then `homed` or `fault`.
    Home {
        /// Where the head stands now, degrees from its zero in the machine's signs, where the program knows it and the
        /// machine may not ([`HeadBy::Program`](crate::HeadBy::Program)). It is turned back to zero. Since 1.3.
        #[serde(default)]
        head_at_deg: Option<f64>,
    },
    /// Makes ready for one wire. Reply: [`ArmedReply`]. Nothing moves yet.
    Arm(Run),
    /// Hands over steps. Reply: [`Sent`]; then `done` for each, and `finished` after the last.
    Send(Batch),
    /// Moves one axis. Reply: `{}`; then `jogged` or `fault`. On a machine that bends with a peg, a jog of the
    /// bend axis is a whole bend: the peg comes out, the axis goes there and back, the peg goes in. Of a dry run
    /// it is that with the peg in.
    Jog(Motion),
    /// Holds. Reply: `{}`; then `paused`.
    Pause,
    /// Resumes. Reply: `{}`; then `resumed`.
    Resume,
    /// Sets the speed override, percent of the programmed speeds: [`SPEEDS`]. It takes effect as soon as the machine can, at the
    /// latest with its next moves. Refused where the machine goes no faster. Reply: `{}`; then `speed` where it changes.
    /// A wire begins and ends with 100: the driver sees to that. Since 1.5.
    Speed {
        /// The override, percent.
        percent: u8,
    },
    /// Passes on a line that a person has typed, if it is one that the driver lets pass. Only while the machine stands and no wire is
    /// armed. Reply: `{}`; then `console` for the line and each line of the answer, and `console-done` or `fault`. Since 1.7.
    Console {
        /// The line, without its end: see [`ConsoleLine`](crate::ConsoleLine).
        #[schemars(length(min = 1, max = 256), pattern(r"^[^\p{Cc}]+$"))]
        line: String,
        /// A person has confirmed that the machine may move or be changed by it. Without it the driver takes questions alone, which
        /// change nothing, and refuses everything else as [`DriverError::NOT_A_QUESTION`](crate::DriverError::NOT_A_QUESTION).
        #[serde(default)]
        may_change: bool,
    },
    /// Cuts off what was bent: the wire is fed to the cutter ([`Limits::cutter_mm`](crate::Limits::cutter_mm)), cut, and brought back, so
    /// that its new tip is where a wire begins. Only while the machine stands, homed, and no wire is armed. Reply: `{}`; then `cut` or
    /// `fault`. Since 1.7.
    Cut,
    /// Stops at once. Reply: `{}`; then `stopped`. Always allowed once connected.
    Stop,
    /// Writes the driver's settings to the machine, for good. Reply: `{}`; then `settings-written` or `fault`.
    /// Nothing moves. Since 1.1.
    WriteSettings,
}

/// The name of a request: it is read first, so that what a driver does not know is told apart from what is damaged.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum CallName {
    Encode,
    Ports,
    Limits,
    Connect,
    Disconnect,
    Home,
    Arm,
    Send,
    Jog,
    Pause,
    Resume,
    Speed,
    Console,
    Cut,
    Stop,
    WriteSettings,
}

/// What to write.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Encode {
    /// Id of one of the driver's formats.
    pub format: String,
    /// The job.
    pub job: Job,
}

/// The wire that is about to be bent.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Run {
    /// Hash of the job.
    pub job_hash: String,
    /// Hash of the design that it was planned from.
    #[serde(default)]
    pub design_hash: String,
    /// Name of the design.
    pub name: String,
    /// Id of the machine's profile.
    #[serde(default)]
    pub machine: String,
    /// Wire that has to be put in, with what cannot be fed, mm.
    #[serde(default)]
    pub stock_mm: Option<f64>,
    /// Index of the wire, from 0.
    pub wire: usize,
    /// How many steps it has.
    pub steps: u32,
    /// How many of them are done already: numbers continue at the one after. Since 1.1.
    #[serde(default)]
    pub after: u32,
    /// Where the head stands, degrees from its reference, in the machine's signs: the sum of what the steps that
    /// are done have turned it, and of what is turned of the next. A machine that has lost its head takes it to
    /// stand there. One that was homed again, so that the head stands at zero, turns it there before the next step.
    /// Since 1.1. Of a new wire, since 1.7: so far before zero that the first step takes up the play of the head; the machine
    /// was homed, and turns it there.
    #[serde(default)]
    pub rotate_at_deg: f64,
    /// Where the head stands once all steps are done that the machine has taken, degrees likewise, where it still is in the wire: the next
    /// step turns it from there. Since 1.7.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rotate_taken_deg: Option<f64>,
    /// How much of the step after `after` is fed already, mm: a step that was interrupted, of which the rest is sent under
    /// its number. Since 1.2.
    #[serde(default)]
    pub fed_mm: f64,
    /// What a simulated machine has to know of the bender and of the wire. Others pass over it. Since 1.1.
    #[serde(default)]
    pub bench: Option<Box<Bench>>,
}

/// What became of arming.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct ArmedReply {
    /// Names the session that the machine is in now, for `resume` of a later `connect`: what a journal keeps.
    /// Absent where a machine has none. Since 1.1.
    #[serde(default)]
    pub token: Option<String>,
}

/// Steps to be run one after the other.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Batch {
    /// In order, without gaps.
    pub steps: Vec<NumberedStep>,
    /// Whether the wire ends with them.
    pub last: bool,
}

/// A step of the machine with its place in the wire.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct NumberedStep {
    /// From 1. A driver takes a number once; what it has taken already it acknowledges and does not run again.
    pub n: u32,
    /// Feed, rotate and bend in the machine's signs.
    #[serde(flatten)]
    pub step: crate::Step,
}

/// What became of a batch.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct Sent {
    /// The last step that was taken; later ones of the batch have to be sent again.
    pub accepted: u32,
    /// How many more would be taken now.
    pub free: u32,
}

/// The speeds that a driver can be asked for, percent.
pub const SPEEDS: std::ops::RangeInclusive<u8> = 10..=200;

/// A move of one axis by an amount, in the machine's signs. What a jog of the bend axis means on a machine with
/// a peg: see [`Call::Jog`].
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Motion {
    /// Which axis.
    pub axis: Axis,
    /// How far: mm for feed, degrees for the others.
    pub by: f64,
    /// Whether it belongs to a dry run: without wire, at a quarter of the speed, the peg in; the bend axis goes there and back.
    /// Only for drivers with [`Capability::DryRun`](crate::Capability::DryRun). Since 1.5.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub dry: bool,
}

impl Motion {
    /// A jog.
    #[must_use]
    pub const fn new(axis: Axis, by: f64) -> Self {
        Self { axis, by, dry: false }
    }
}

/// An axis of a bender.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Axis {
    /// Along the wire.
    Feed,
    /// About the wire.
    Rotate,
    /// Of the bend head.
    Bend,
}

/// Files with what had to be said about them.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct Encoded {
    /// One for each wire in order, or one for all, as the format says.
    pub files: Vec<EncodedFile>,
    /// What was rounded, left out or assumed.
    #[serde(default)]
    pub notes: Vec<Note>,
}

/// A file.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct EncodedFile {
    /// What is in it.
    pub text: String,
}

/// Something that a person should know of what was written.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct Note {
    /// A name of lower-case letters, digits and hyphens.
    pub code: String,
    /// How many things it is about.
    pub count: usize,
    /// For a person.
    pub message: String,
}
