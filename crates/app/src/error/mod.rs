//! What can go wrong.

mod kind;

use std::path::PathBuf;

use wirebend_core::compensate::{PegGeometryError, SpringbackError};
use wirebend_core::simulate::BadErrorTerm;
use wirebend_driver_host::HostError;
use wirebend_files::document::DocumentError;
use wirebend_files::read::ReadError;
use wirebend_profile::{Kind, ProfileError};

pub use kind::ErrorKind;

use crate::report::PlanReport;
use crate::stencil::StencilFileError;
use crate::{DriverProblem, EditorError, LiveProblem, OperatorError};

/// Why a command came to nothing. The message says what to do.
#[derive(Debug, thiserror::Error)]
pub enum AppError {
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
    #[error("machine '{machine}': {error}; correct its bend section")]
    Geometry {
        /// The machine.
        machine: String,
        /// What is wrong.
        error: PegGeometryError,
    },
    /// A springback table is not one.
    #[error("material '{material}': {error}; correct its springback table")]
    Springback {
        /// The material.
        material: String,
        /// What is wrong.
        error: SpringbackError,
    },
    /// An error model is not one.
    #[error("noise '{noise}': {error}; correct the profile")]
    Noise {
        /// The noise profile.
        noise: String,
        /// What is wrong.
        error: BadErrorTerm,
    },
    /// The open design cannot be changed like this, or not be kept safe.
    #[error(transparent)]
    Editor(#[from] EditorError),
    /// A design that was never saved is to be saved without a name.
    #[error("the design has no file yet: say where to save it")]
    NoFile,
    /// There is no example of this id.
    #[error("there is no example '{id}'; known: {known}")]
    NoExample {
        /// The wanted one.
        id: String,
        /// All.
        known: String,
    },
    /// A profile that comes with the program is to be changed.
    #[error(
        "'{id}' comes with the program and stays as it is: copy it to a profile of your own, and change that"
    )]
    ShippedProfile {
        /// The profile.
        id: String,
    },
    /// There is no folder for a person's own profiles.
    #[error("there is no home folder for profiles of your own: set HOME, and start again")]
    NoOwnFolder,
    /// A file without a surface is to be traced on.
    #[error("{name} holds no surface to trace on: open it as a wireframe")]
    NoSurface {
        /// The input.
        name: String,
    },
    /// The surface of a design is in a file that cannot be had.
    #[error(transparent)]
    Stencil(#[from] StencilFileError),
    /// A number is outside what makes sense.
    #[error("{name} is {value}: {expected}")]
    Value {
        /// Which option.
        name: &'static str,
        /// What was given.
        value: String,
        /// What was expected.
        expected: &'static str,
    },
    /// A new profile was to have an id that another file has.
    #[error("the id '{id}' is taken by the {kind} in {file}; choose another id")]
    IdTaken {
        /// The kind.
        kind: Kind,
        /// The id.
        id: String,
        /// The file that has it.
        file: String,
    },
    /// An id could mean profiles of several kinds.
    #[error("'{id}' is {}; say which is meant with {}", kind_words(kinds), kind_options(kinds))]
    SeveralKinds {
        /// The id.
        id: String,
        /// The kinds that have it.
        kinds: Vec<Kind>,
    },
    /// An id is known, but not in the kind that was named.
    #[error("no {wanted} has the id '{id}', which is {}; correct the id or --kind", kind_words(kinds))]
    OtherKind {
        /// The id.
        id: String,
        /// The kind that was named.
        wanted: Kind,
        /// The kinds that have it.
        kinds: Vec<Kind>,
    },
    /// A new profile would leave open what its abstract parent leaves open.
    #[error(
        "the {kind} '{parent}' is abstract: a profile that inherits from it alone could not be used without {}; {}",
        missing.join(", "), open_parent_help(complete)
    )]
    OpenParent {
        /// The kind.
        kind: Kind,
        /// The parent.
        parent: String,
        /// What is missing, as it would be written.
        missing: Vec<String>,
        /// The complete profiles that inherit from it.
        complete: Vec<String>,
    },
    /// No machine was named, neither by the command nor by the document.
    #[error("no machine is named; choose one of: {}", known.join(", "))]
    NoMachine {
        /// The machines that there are.
        known: Vec<String>,
    },
    /// The input has a surface but no wireframe.
    #[error(
        "{name} holds a surface and no lines: import it with --face-edges to take the edges of its faces, or trace a wireframe on it"
    )]
    OnlyStencil {
        /// The input.
        name: String,
    },
    /// The wireframe has no vertex of this id.
    #[error("there is no vertex {vertex} in {name}: its {count} vertices are numbered {range}")]
    NoVertex {
        /// The wanted one.
        vertex: u32,
        /// The input.
        name: String,
        /// How many there are.
        count: usize,
        /// First and last.
        range: String,
    },
    /// A format that cannot be written.
    #[error("'{name}' is not a format that can be written; known: {known}{}", missing.as_ref().map(|error| format!("; {error}")).unwrap_or_default())]
    UnknownFormat {
        /// The wanted one.
        name: String,
        /// All.
        known: String,
        /// Why the machine's own driver could not be asked.
        missing: Option<Box<DriverProblem>>,
    },
    /// Settings were given for a format that has none.
    #[error("{format} has no settings: leave them out")]
    NoSettings {
        /// The format.
        format: &'static str,
    },
    /// A driver is not there, is not trusted, failed, or refused.
    #[error(transparent)]
    Driver(#[from] DriverProblem),
    /// A machine does not move, or does not any more.
    #[error(transparent)]
    Live(#[from] LiveProblem),
    /// An operator does not do what it was told.
    #[error(transparent)]
    Operator(#[from] OperatorError),
    /// A machine's program was asked for in the format of another machine.
    #[error(
        "{format} is no format of '{machine}', whose programs are compensated for that machine alone: plan the wireframe for a machine that reads it, or choose one of {known}"
    )]
    FormatOfAnother {
        /// The wanted format.
        format: String,
        /// The machine.
        machine: String,
        /// What can be written for it.
        known: String,
    },
    /// Something else was given where a job is needed.
    #[error(
        "{name} is not a job: make one of a design with `wirebend plan DESIGN --machine ID -o JOB.wbjob`"
    )]
    NotAJob {
        /// The input.
        name: String,
    },
    /// A job was given where a design is needed.
    #[error(
        "{name} is a job, which is planned already: use `export` or `simulate` on it, or this command on its wireframe"
    )]
    IsAJob {
        /// The input.
        name: String,
    },
    /// A program that is what a machine was told, and nobody says which.
    #[error(
        "{name} is a program that was compensated for a machine, and not the design: name that machine with --machine, and its wire with --material, to turn it back, or take it as it stands with --program nominal"
    )]
    Compensated {
        /// The program.
        name: String,
    },
    /// A program that was not compensated for this machine and this wire.
    #[error(
        "{name}, step {step}: no design leads to this feed on {machine} with {material}; name the machine and the material that the program was compensated for, or take it as it stands with --program nominal"
    )]
    OtherCompensation {
        /// The program.
        name: String,
        /// The step, from 1.
        step: usize,
        /// The machine.
        machine: String,
        /// The material.
        material: String,
    },
    /// An order is to be kept that there is not.
    #[error(
        "{name} has no order to keep: --keep-order is for the file of a program, such as WireBend-kit text, a Pensa script or an LRA table; plan that file itself"
    )]
    NoOrder {
        /// The design.
        name: String,
    },
    /// Options were given that have no effect on what is settled already.
    #[error("{name} is taken as it is: {options} would have no effect; leave them out, or {instead}")]
    Settled {
        /// The input.
        name: String,
        /// The options.
        options: &'static str,
        /// What to do to have them.
        instead: &'static str,
    },
    /// The wanted start has no edge.
    #[error("the wire cannot start at vertex {vertex} of {name}: no edge ends there")]
    StartWithoutEdge {
        /// The vertex.
        vertex: u32,
        /// The input.
        name: String,
    },
    /// A job whose hash fits but that cannot be followed.
    #[error("{name}: the job cannot be followed: {reason}; plan the wireframe again")]
    DamagedJob {
        /// The job.
        name: String,
        /// Why.
        reason: String,
    },
    /// A job was made for another machine.
    #[error(
        "{name} was planned for machine '{planned}', not '{wanted}': plan its wireframe again for '{wanted}'"
    )]
    OtherMachine {
        /// The job.
        name: String,
        /// Its machine.
        planned: String,
        /// The wanted one.
        wanted: String,
    },
    /// A format cannot hold this wire.
    #[error("wire {} cannot be written as {format}: {reason}", .wire + 1)]
    Unwritable {
        /// Index of the wire, from 0.
        wire: usize,
        /// The format.
        format: &'static str,
        /// Why.
        reason: String,
    },
    /// A stage was asked for that the design does not reach.
    #[error("there is no {} of this design: `check` names what is in the way", in_words(stage))]
    StageNotReached {
        /// The stage.
        stage: &'static str,
        /// What the checks say.
        report: Box<PlanReport>,
    },
    /// The machine cannot make it, and it was to be written for the machine.
    #[error(
        "this cannot be made on '{machine}': mend what the checks name, or write it all the same with --despite-errors"
    )]
    NotFeasible {
        /// The machine.
        machine: String,
        /// What the checks say.
        report: Box<PlanReport>,
    },
    /// A file would be replaced.
    #[error("{} exists already: name another file, or replace it with --force", .0.display())]
    Exists(PathBuf),
    /// A picture cannot be drawn.
    #[error("the picture cannot be drawn: {0}")]
    Picture(String),
    /// A value cannot be turned into JSON.
    #[error("the result cannot be written as JSON: {0}")]
    Json(#[from] serde_json::Error),
}

/// What a stage leaves, for a person.
fn in_words(stage: &str) -> &str {
    if stage == "compensated" { "compensated program" } else { stage }
}

/// "a machine profile and a noise profile".
fn kind_words(kinds: &[Kind]) -> String {
    let words: Vec<String> = kinds.iter().map(|kind| format!("a {kind} profile")).collect();
    words.join(" and ")
}

/// "--kind machine or --kind noise".
fn kind_options(kinds: &[Kind]) -> String {
    let options: Vec<String> = kinds.iter().map(|kind| format!("--kind {kind}")).collect();
    options.join(" or ")
}

/// What to do where a parent leaves values open.
fn open_parent_help(complete: &[String]) -> String {
    if complete.is_empty() {
        return "inherit from a complete profile, or write the file by hand with these values".to_owned();
    }
    format!("inherit from one that has them: {}", complete.join(", "))
}

impl From<HostError> for AppError {
    fn from(error: HostError) -> Self {
        Self::Driver(error.into())
    }
}
