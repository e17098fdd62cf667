//! What can go wrong between a document and what is computed from it.

mod driver;
mod kind;
mod remedies;
mod stencil;

use std::path::PathBuf;

use wirebend_accuracy::ClosingError;
use wirebend_core::calibrate::CalibrationError;
use wirebend_core::compensate::{PegGeometryError, SpringbackError};
use wirebend_core::simulate::BadErrorTerm;
use wirebend_driver_host::HostError;
use wirebend_error::{ErrorRemedy, InputName};
use wirebend_files::document::DocumentError;
use wirebend_files::read::frame::StrutMatchError;
use wirebend_files::read::{Format, ReadError};
use wirebend_profile::{Kind, ProfileError};

pub use driver::DriverProblem;
pub use kind::ErrorKind;
pub(crate) use remedies::edges_of_faces;
pub use stencil::StencilFileError;

use crate::report::PlanReport;
use crate::stage::StageName;
use crate::text;

/// Which command of a step.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ToldCommand {
    Feed,
    Bend,
}

/// Why a command came to nothing.
#[derive(Debug, thiserror::Error)]
pub enum PlanningError {
    /// An input cannot be read.
    #[error(transparent)]
    Read(#[from] ReadError),
    /// A document or a job is not one, or cannot be written.
    #[error(transparent)]
    Document(#[from] DocumentError),
    /// A profile is unknown or wrong.
    #[error(transparent)]
    Profile(#[from] ProfileError),
    /// The figures of a machine profile contradict each other.
    #[error("machine '{machine}': {}", text::error::peg_geometry(error))]
    Geometry { machine: String, error: PegGeometryError },
    /// No wire was named, neither by the command nor by the design, nor a machine that has one.
    #[error("no material is named")]
    NoMaterial {
        /// The materials that there are.
        known: Vec<String>,
    },
    /// Torsion of a wire cannot be computed.
    #[error(
        "material '{material}' has neither a shear modulus nor Poisson's ratio: no frame of it can be computed"
    )]
    NoShearModulus { material: String },
    /// A strut has no direction.
    #[error("{name}: edge {edge} has no length: vertices {} and {} are at the same place", ends[0], ends[1])]
    StrutWithoutLength {
        /// The design.
        name: String,
        edge: u32,
        ends: [u32; 2],
    },
    /// A design is no frame that can be computed.
    #[error("{name} cannot be computed as a frame: {reason}")]
    NoFrame {
        /// The design.
        name: String,
        reason: String,
    },
    /// A design has chosen no walks, by which its edges would belong to wires.
    #[error("{name} has no walks of wires: which edges are one wire is not known")]
    NoWalks { name: String },
    /// A sequence cannot be read.
    #[error("{name}, line {line}: {reason}")]
    SequenceFile { name: String, line: usize, reason: String },
    /// A sequence is of another design.
    #[error("{name}: {error}")]
    OtherDesign { name: String, error: StrutMatchError },
    /// The figures of a strut builder make no machine.
    #[error("machine '{machine}': {reason}")]
    StrutBuilder { machine: String, reason: String },
    /// A file has several load cases, or not the one that is wanted.
    #[error("{name} has {}", case_words(wanted.as_deref(), known))]
    LoadCase {
        /// The file.
        name: String,
        wanted: Option<String>,
        /// Those that it has.
        known: Vec<String>,
    },
    /// The search for modes came to nothing.
    #[error("the modes of the frame were not found: {reason}")]
    NoModes { reason: String },
    /// The joints of a frame cannot be closed.
    #[error("{name}: {}", text::error::closing(error))]
    Closing {
        /// The design.
        name: String,
        error: ClosingError,
    },
    /// A file of faces is none.
    #[error("{name} is no list of faces: {reason}")]
    Faces { name: String, reason: String },
    /// Nothing that is required depends on what varies.
    #[error("nothing that is required depends on the motions that vary")]
    NoLimit,
    /// Closed formulas say nothing of what was asked.
    #[error("the closed formulas know feeds alone, and neither angles nor stresses")]
    OnlyLengths,
    /// A person has stopped it.
    #[error("stopped before it was done")]
    Stopped,
    /// A springback table is not one.
    #[error("material '{material}': {}", text::error::springback(error))]
    Springback { material: String, error: SpringbackError },
    /// An error model is not one.
    #[error("noise '{noise}': {}", text::error::noise(error))]
    Noise {
        /// The noise profile.
        noise: String,
        error: BadErrorTerm,
    },
    /// A file without a surface is to be traced on.
    #[error("{name} holds no surface to trace on")]
    NoSurface { name: String },
    /// The surface of a design is in a file that cannot be had.
    #[error(transparent)]
    Stencil(#[from] StencilFileError),
    /// Measurements that no machine can be fitted to.
    #[error("{}", text::calibration::refusal(.0))]
    Calibration(#[from] CalibrationError),
    /// What readings tell is nothing that a profile holds.
    #[error("{sheet}: {reason}")]
    Beyond { sheet: String, reason: String },
    /// A profile that comes with the program is to be changed.
    #[error("'{id}' comes with the program and stays as it is")]
    ShippedProfile { id: String },
    /// There is no last change of a profile.
    #[error("{}", text::profile::nothing_to_revert(.id, *.changed_elsewhere))]
    NothingToRevert {
        id: String,
        /// There was one, and the file has been changed by something else since.
        changed_elsewhere: bool,
    },
    /// A number is outside what makes sense.
    #[error("{name} is {value}, expected {expected}")]
    Value {
        /// What is to be corrected; `None` where that is not what was given.
        input: Option<InputName>,
        name: &'static str,
        /// What was given.
        value: String,
        expected: &'static str,
    },
    /// A new profile was to have an id that another file has.
    #[error("the id '{id}' is taken by the {kind} in {file}")]
    IdTaken { kind: Kind, id: String, file: String },
    /// An id could mean profiles of several kinds.
    #[error("'{id}' is {}", kind_words(kinds))]
    SeveralKinds { id: String, kinds: Vec<Kind> },
    /// An id is known, but not in the kind that was named.
    #[error("no {wanted} has the id '{id}', which is {}", kind_words(kinds))]
    OtherKind {
        id: String,
        /// The kind that was named.
        wanted: Kind,
        kinds: Vec<Kind>,
    },
    /// A new profile would leave open what its abstract parent leaves open.
    #[error(
        "the {kind} '{parent}' is abstract: a profile that inherits from it alone could not be used without {}",
        missing.join(", ")
    )]
    OpenParent {
        kind: Kind,
        parent: String,
        /// What is missing, as it would be written.
        missing: Vec<String>,
        /// The complete profiles that inherit from it.
        complete: Vec<String>,
    },
    /// No machine was named, neither by the command nor by the document.
    #[error("no machine is named")]
    NoMachine {
        /// The machines that there are.
        known: Vec<String>,
    },
    /// The input has a surface but no wireframe.
    #[error("{name} holds a surface and no lines")]
    OnlyStencil { name: String, format: Format },
    /// The wireframe has no vertex of this id.
    #[error("there is no vertex {vertex} in {name}: its {count} vertices are numbered {range}")]
    NoVertex {
        /// The wanted one.
        vertex: u32,
        name: String,
        /// How many there are.
        count: usize,
        /// First and last.
        range: String,
        /// What names it.
        input: InputName,
    },
    /// A format that cannot be written.
    #[error("'{name}' is not a format that can be written{}", missing.as_ref().map(|error| format!(": {error}")).unwrap_or_default())]
    UnknownFormat {
        /// The wanted one.
        name: String,
        known: Vec<String>,
        /// Why the machine's own driver could not be asked.
        missing: Option<Box<DriverProblem>>,
    },
    /// Settings were given for a format that has none.
    #[error("{format} has no settings")]
    NoSettings { format: &'static str },
    /// A driver is not there, is not trusted, failed, or refused.
    #[error(transparent)]
    Driver(#[from] DriverProblem),
    /// A machine's program was asked for in the format of another machine.
    #[error("{format} is no format of '{machine}', whose programs are compensated for that machine alone")]
    FormatOfAnother {
        /// The wanted format.
        format: String,
        machine: String,
        /// What can be written for it; empty where a program was read.
        known: Vec<String>,
    },
    /// Something else was given where a job is needed.
    #[error("{name} is not a job")]
    NotAJob { name: String },
    /// G-code was to be run: what it bends is not read back, so that nothing could be checked.
    #[error("{name} is G-code, which can be written but not read back: run the job that it was written from")]
    GCodeToRun { name: String },
    /// A job was given where a design is needed.
    #[error("{name} is a job, which is planned already")]
    IsAJob { name: String },
    /// A program that is what a machine was told, and no machine is named.
    #[error(
        "{name} is what a machine was told; how that differs from the design, only the machine's profile says"
    )]
    Compensated {
        /// The program.
        name: String,
    },
    /// A program that was not compensated for this machine and this wire.
    #[error("{name}, step {step}: no design leads to this {} on {machine} with {material}", match command { ToldCommand::Feed => "feed", ToldCommand::Bend => "bend" })]
    OtherCompensation {
        /// The program.
        name: String,
        /// The step, from 1.
        step: usize,
        command: ToldCommand,
        machine: String,
        material: String,
    },
    /// An order is to be kept that there is not.
    #[error("{name} has no order to keep: only a program has one")]
    NoOrder {
        /// The design.
        name: String,
    },
    /// Options were given that have no effect on what is settled already.
    #[error("{name} is taken as it is: {} would have no effect", input_words(inputs))]
    Settled {
        name: String,
        /// What was given besides.
        inputs: Vec<InputName>,
        /// What to do to have an effect.
        instead: Box<ErrorRemedy>,
    },
    /// Options were given for files of another kind.
    #[error("{name}: {} would have no effect on a file of format {format}", input_words(inputs))]
    WithoutEffect { name: String, format: Format, inputs: Vec<InputName> },
    /// One wire that ends where it starts, and several wires.
    #[error("a closed route is for one wire, and the number of wires is {wires}")]
    ClosedWires { wires: u32 },
    /// The wanted start has no edge.
    #[error("the wire cannot start at vertex {vertex} of {name}: no edge ends there")]
    StartWithoutEdge { vertex: u32, name: String },
    /// A job whose hash fits but that cannot be followed.
    #[error("{name}: the job cannot be followed: {reason}")]
    DamagedJob {
        /// The job.
        name: String,
        reason: String,
    },
    /// A job was planned for another machine.
    #[error("{name} was planned for machine '{planned}', not '{wanted}'")]
    OtherMachine {
        /// The job.
        name: String,
        /// Its machine.
        planned: String,
        wanted: String,
    },
    /// No machine can be simulated as this one.
    #[error("machine '{machine}' has no pin and peg: no machine can be simulated as it")]
    NoBender { machine: String },
    /// A format cannot hold this wire.
    #[error("wire {} cannot be written as {format}: {reason}", .wire + 1)]
    Unwritable {
        /// Index of the wire, from 0.
        wire: usize,
        format: &'static str,
        reason: String,
    },
    /// A stage was asked for that the design does not reach.
    #[error("there is no {} of this design", stage.in_words())]
    StageNotReached {
        stage: StageName,
        /// What the checks say.
        report: Box<PlanReport>,
    },
    /// The machine cannot make it, and it was to be written for the machine.
    #[error("this cannot be bent on '{machine}'")]
    NotFeasible {
        machine: String,
        /// What the checks say.
        report: Box<PlanReport>,
    },
    /// A file would be replaced.
    #[error("{} exists already", .0.display())]
    Exists(PathBuf),
    /// A picture cannot be drawn.
    #[error("the picture cannot be drawn: {0}")]
    Picture(String),
    /// A value cannot be turned into JSON.
    #[error("the result cannot be written as JSON: {0}")]
    Json(#[from] serde_json::Error),
}

/// "no load case 'wind'", "several load cases".
fn case_words(wanted: Option<&str>, known: &[String]) -> String {
    match wanted {
        Some(wanted) => format!("no load case '{wanted}'"),
        None => format!("{} load cases", known.len()),
    }
}

/// "a machine profile and a noise profile".
fn kind_words(kinds: &[Kind]) -> String {
    let words: Vec<String> = kinds.iter().map(|kind| format!("a {kind} profile")).collect();
    words.join(" and ")
}

/// "scale and tolerance".
pub(crate) fn input_words(inputs: &[InputName]) -> String {
    let words: Vec<&str> = inputs.iter().map(|input| input.words()).collect();
    match words.split_last() {
        Some((last, before)) if !before.is_empty() => format!("{} and {last}", before.join(", ")),
        _ => words.concat(),
    }
}

impl From<HostError> for PlanningError {
    fn from(error: HostError) -> Self {
        Self::Driver(error.into())
    }
}
