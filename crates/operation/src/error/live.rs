//! Why a machine does not move, or does not any more.

use std::path::PathBuf;

use wirebend_driver_host::api::{PausedBy, SettingCheck};
use wirebend_driver_host::jobs::{JobError, JournalError};
use wirebend_driver_host::{SessionError, StoppedBy};
use wirebend_error::{ErrorRemedy, InputName, ProblemReport, RunTarget};

use super::HeadProblem;
use crate::event::Doubt;

/// Why a machine does not move, or does not any more.
#[derive(Debug, thiserror::Error)]
pub enum LiveProblem {
    /// No port was named.
    #[error("no port is named")]
    NoPort {
        /// What the driver lists.
        known: Vec<String>,
    },
    /// The machine's driver does not move it.
    #[error("the driver '{driver}' of '{machine}' writes files and moves nothing")]
    FilesOnly { machine: String, driver: String },
    /// There is no user to ask.
    #[error("nobody has confirmed that the machine may move")]
    NotConfirmed,
    /// One yes was given for several pieces of a real machine.
    #[error(
        "a yes given beforehand is not enough for {pieces} pieces: between two of them a person has to cut off the one before and take it out, since this machine does not cut, and the next one would be bent into it"
    )]
    YesForPieces { pieces: u32 },
    /// There is no user to ask where the axes stand.
    #[error("nobody has confirmed that every axis stands at zero: this machine has no switches to find it")]
    ZeroNotConfirmed,
    /// Where its head stands is against it.
    #[error(transparent)]
    Head(#[from] HeadProblem),
    /// A person has said no.
    #[error("nothing was moved")]
    Declined,
    /// A person has stopped it before a wire was begun.
    #[error("the machine was stopped while {during}")]
    Stopped { during: &'static str },
    /// It holds in a move by hand, and was stopped for it.
    #[error(
        "the machine held while {during}{}, and the rest of that was cancelled",
        held_by(*by)
    )]
    Held { during: &'static str, by: PausedBy },
    /// It holds in a move by hand, and its driver did not stop it.
    #[error(
        "the machine held while {during}, and the driver did not pass the stop on and was ended{}",
        hard_stop(*by)
    )]
    Unstopped {
        during: &'static str,
        /// Who has stopped the machine.
        by: StoppedBy,
    },
    /// It was stopped, or its driver was lost, and it has not confirmed that it stands.
    #[error(
        "the machine was stopped while {during}, and has not confirmed that it stands: it may still be moving"
    )]
    MayMove { during: &'static str },
    /// Nothing can be written down any more, and so the machine was stopped.
    #[error("{error}; {}", stopped_for_it(*.stands))]
    Unrecorded {
        error: Box<JobError>,
        /// Whether the machine has confirmed that it stands.
        stands: bool,
        /// The wire.
        run: RunTarget,
    },
    /// The machine does not answer.
    #[error("the machine at {port} has not answered for {seconds} s")]
    NoAnswer {
        port: String,
        /// For how long.
        seconds: u64,
    },
    /// A program bends a wire on it.
    #[error(
        "another program, or another window of this one, bends the wire '{name}' on the machine at {port}"
    )]
    AtWork {
        port: String,
        /// The wire.
        name: String,
    },
    /// The machine or its line failed.
    #[error("{}", .0.message)]
    Fault(ProblemReport),
    /// The session refuses.
    #[error(transparent)]
    Session(#[from] SessionError),
    /// The loop that runs a wire refuses, or its journal cannot be used.
    #[error(transparent)]
    Job(#[from] JobError),
    /// The machine is set otherwise than its profile says.
    #[error(
        "the machine is not set as the profile of '{machine}' says, and wires would come out wrong: {}",
        listed(settings)
    )]
    SettingsDiffer {
        machine: String,
        port: String,
        settings: Vec<SettingCheck>,
        /// Whether its driver can write them.
        writable: bool,
    },
    /// A job has fewer wires.
    #[error("there is no wire {}: the job has {count}, counted from 1", .wire.saturating_add(1))]
    NoWire {
        /// Index of the wanted one, from 0.
        wire: usize,
        /// How many there are.
        count: usize,
    },
    /// Pieces were to be cut off, and nothing cuts.
    #[error("'{machine}' has no cutter{}", if *able { "" } else { " that its driver knows to use" })]
    NoCutter {
        machine: String,
        driver: String,
        /// Whether the driver could use one.
        able: bool,
    },
    /// A bend would be pulled into the machine.
    #[error(
        "wire {} ends {straight_mm:.1} mm after its last bend, and the cutter is {back_mm:.1} mm inside the machine: the bend would be pulled into it",
        .wire + 1
    )]
    EndTooShort { wire: usize, straight_mm: f64, back_mm: f64 },
    /// A bend by hand goes farther than the profile lets the bend axis.
    #[error(
        "the bend axis would go to {deg:.1}°, and the machine's profile allows {reach:.1}° to either side"
    )]
    BendTooFar { deg: f64, reach: f64 },
    /// One wire is wanted, and the job has several.
    #[error("the job has {count} wires, and a dry run is of one")]
    WhichWire {
        /// How many there are.
        count: usize,
    },
    /// The wire was begun before, and is not over.
    #[error(
        "wire {} of this job was begun on {started} and is not over: {made} of {of} steps are done",
        .wire + 1
    )]
    Unfinished {
        /// Index of the wire, from 0.
        wire: usize,
        started: String,
        /// The last step that is done.
        made: u32,
        /// How many there are.
        of: u32,
        /// The wire, so that it can be resumed or given up.
        run: RunTarget,
    },
    /// The journal of an interrupted wire cannot be read.
    #[error("{error}")]
    DamagedJournal {
        error: JournalError,
        /// The wire.
        run: RunTarget,
    },
    /// A wire that was interrupted may still be in the machine.
    #[error("wire {} of '{name}' was begun on {started} and is not over: it may still be in the machine", .wire + 1)]
    WireInMachine {
        /// Name of its design.
        name: String,
        /// Index of the wire, from 0.
        wire: usize,
        started: String,
        /// The wire, so that it can be resumed or given up.
        run: RunTarget,
    },
    /// Several wires of a job were interrupted.
    #[error("several wires of this job are not over: {}", numbers(wires))]
    SeveralUnfinished {
        /// Their indices, from 0.
        wires: Vec<usize>,
    },
    /// Nothing is left to be given up.
    #[error("no wire of this job is unfinished")]
    NothingUnfinished,
    /// Nothing of the job was begun.
    #[error("no wire of this job was begun")]
    NothingBegun {
        /// What was asked for.
        input: InputName,
    },
    /// A real machine was to be simulated.
    #[error("the machine at {port} is a real one: its bender and its wire are what they are")]
    NotSimulated { port: String },
    /// A person has to look at the wire.
    #[error("{doubt}")]
    InDoubt {
        /// The step.
        doubt: Box<Doubt>,
        /// The wire.
        run: RunTarget,
    },
    /// A person has said something of a step that is in no doubt.
    #[error(
        "step {step} is not in doubt: {made} {} done, and {}",
        if *made == 1 { "step is" } else { "steps are" },
        in_doubt.map_or_else(|| "no step is in doubt".to_owned(), |n| format!("step {n} is the one in doubt"))
    )]
    OtherStep {
        /// The step that was named.
        step: u32,
        /// The first that is in doubt.
        in_doubt: Option<u32>,
        /// The last that is done.
        made: u32,
        /// The wire.
        run: RunTarget,
    },
    /// The machine has not counted how much of a step it has done.
    #[error("the machine has not counted how much of step {step} is done")]
    NotCounted { step: u32 },
    /// The machine and the journal cannot both be right, and the user has not said that it may be stopped.
    #[error("{reason}")]
    Contradiction {
        /// What contradicts what.
        reason: String,
        /// The wire.
        run: RunTarget,
    },
    /// There is no place for journals and records.
    #[error("there is no folder for journals of wires: the home folder is not known")]
    NowhereToRecord,
    /// The folder of journals and records cannot be used.
    #[error("{} cannot be used for journals and records: {cause}", folder.display())]
    RunsFolder { folder: PathBuf, cause: std::io::Error },
    /// There is no such record.
    #[error("there is no record '{id}'")]
    NoRun {
        /// The wanted one.
        id: String,
    },
    /// The beginning of an id fits several records.
    #[error("'{id}' fits several records: {}", known.join(", "))]
    SeveralRuns {
        /// The wanted one.
        id: String,
        /// Those.
        known: Vec<String>,
    },
    /// A file with moves is not one.
    #[error("{file}: {reason}")]
    Moves { file: String, reason: String },
    /// Moves were recorded on another machine, or the machine's profile has changed since.
    #[error("{file} was recorded {recorded}")]
    OtherMachine {
        file: String,
        /// On which, as opposed to what there is now.
        recorded: String,
        machine: String,
    },
}

const fn stopped_for_it(stands: bool) -> &'static str {
    if stands {
        "the machine was stopped for it and stands"
    } else {
        "the machine was stopped for it and has not confirmed that it stands"
    }
}

const fn held_by(by: PausedBy) -> &'static str {
    match by {
        PausedBy::Program => "",
        PausedBy::Silence => ", since it had heard nothing for too long",
        PausedBy::Machine => ", for a cause at the machine itself",
    }
}

/// Whether the program has stopped the machine itself when a driver had to be ended.
pub const fn hard_stop(by: StoppedBy) -> &'static str {
    match by {
        StoppedBy::Host => ": the stop was written to the port itself",
        StoppedBy::EndOfSimulation => ", and the machine that it simulated with it",
        _ => "",
    }
}

/// What a person does then.
pub fn after_hard_stop(by: StoppedBy) -> Vec<ErrorRemedy> {
    match by {
        StoppedBy::Host | StoppedBy::EndOfSimulation => vec![ErrorRemedy::ConnectAgain],
        _ => vec![ErrorRemedy::CutPower, ErrorRemedy::ConnectAgain],
    }
}

fn listed(settings: &[SettingCheck]) -> String {
    let one = |s: &SettingCheck| format!("{} is {}, not {}", s.name, s.machine, s.expected);
    settings.iter().map(one).collect::<Vec<_>>().join(", ")
}

fn numbers(wires: &[usize]) -> String {
    wires.iter().map(|wire| (wire + 1).to_string()).collect::<Vec<_>>().join(", ")
}

impl From<JournalError> for LiveProblem {
    fn from(error: JournalError) -> Self {
        Self::Job(error.into())
    }
}
