//! Why a machine does not move, or does not any more.

mod code;

use std::path::PathBuf;

use wirebend_driver_host::api::{DriverError, PausedBy, SettingCheck};
use wirebend_driver_host::jobs::{JobError, JournalError};
use wirebend_driver_host::{SessionError, StoppedBy};

use super::HeadProblem;
use crate::Doubt;

/// Why a machine does not move, or does not any more. The message says what to do.
#[derive(Debug, thiserror::Error)]
pub enum LiveProblem {
    /// No port was named.
    #[error("say with --port where the machine is; {}", there_are(known))]
    NoPort {
        /// What the driver lists.
        known: Vec<String>,
    },
    /// The machine's driver does not move it.
    #[error(
        "the driver '{driver}' of '{machine}' writes files and moves nothing: use `wirebend export`, and the machine's own program"
    )]
    FilesOnly {
        /// The machine.
        machine: String,
        /// Its driver.
        driver: String,
    },
    /// Nobody is there to be asked.
    #[error("nobody is here to say whether the machine may move: look that it may, and say --yes")]
    NotConfirmed,
    /// Nobody is there to be asked where the axes stand.
    #[error(
        "nobody is here to say whether every axis stands at zero, which --yes alone does not say: this machine has no switches; bring the axes there, and say --axes-at-zero"
    )]
    ZeroNotConfirmed,
    /// Where its head stands is against it.
    #[error(transparent)]
    Head(#[from] HeadProblem),
    /// A person has said no.
    #[error("nothing was moved")]
    Declined,
    /// A person has stopped it before a wire was begun.
    #[error("the machine was stopped while {during}: it has to be homed before it moves again")]
    Stopped {
        /// What it did.
        during: &'static str,
    },
    /// It holds in a move by hand, and was stopped for it.
    #[error(
        "the machine held while {during}{}, and what was left of that is given up: home it before it moves again",
        held_by(*by)
    )]
    Held {
        /// What it did.
        during: &'static str,
        /// Why.
        by: PausedBy,
    },
    /// It holds in a move by hand, and its driver did not stop it.
    #[error(
        "the machine held while {during}, and the driver did not pass the stop on and was ended: {}",
        hard_stop(*by)
    )]
    Unstopped {
        /// What it did.
        during: &'static str,
        /// Who has stopped the machine.
        by: StoppedBy,
    },
    /// It was stopped, or its driver was lost, and it has not confirmed that it stands.
    #[error(
        "the machine was stopped while {during}, and has not confirmed that it stands: it may still be moving. Cut its power, and look at it before you connect it again"
    )]
    MayMove {
        /// What it did.
        during: &'static str,
    },
    /// Nothing can be written down any more, and so the machine was stopped.
    #[error("{error}; {}; then go on with `{resume}`", stopped_for_it(*.stands))]
    Unrecorded {
        /// Why not.
        error: Box<JobError>,
        /// Whether the machine has confirmed that it stands.
        stands: bool,
        /// How to go on.
        resume: String,
    },
    /// The machine does not answer.
    #[error(
        "the machine at {port} has not answered for {seconds} s: see whether it has power and whether the port is the right one"
    )]
    NoAnswer {
        /// The port.
        port: String,
        /// For how long.
        seconds: u64,
    },
    /// A program makes a wire on it.
    #[error(
        "another program, or another window of this one, makes the wire '{name}' on the machine at {port}: wait until it is made, or stop it there"
    )]
    AtWork {
        /// The port.
        port: String,
        /// The wire.
        name: String,
    },
    /// The machine or its line failed.
    #[error("{0}")]
    Fault(DriverError),
    /// The session refuses.
    #[error(transparent)]
    Session(#[from] SessionError),
    /// The loop that makes a wire refuses, or its journal cannot be used.
    #[error(transparent)]
    Job(#[from] JobError),
    /// The machine is set otherwise than its profile says.
    #[error(
        "the machine is not set as the profile of '{machine}' says, and wires would come out wrong: {}; {}, or make wires all the same with --accept-settings",
        listed(settings),
        how_to_set(machine, port, *.writable)
    )]
    SettingsDiffer {
        /// The machine.
        machine: String,
        /// Where it is.
        port: String,
        /// Which.
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
    /// The wire was begun before, and is not over.
    #[error(
        "wire {} of this job was begun on {started} and is not over: {made} of {of} steps are made; go on with `{resume}`, or give it up with `{abandon}`",
        .wire + 1
    )]
    Unfinished {
        /// Index of the wire, from 0.
        wire: usize,
        /// When.
        started: String,
        /// The last step that was made.
        made: u32,
        /// How many there are.
        of: u32,
        /// How to go on.
        resume: String,
        /// How to give it up.
        abandon: String,
    },
    /// The journal of an interrupted wire cannot be read.
    #[error("{error}; `{abandon}` sets the journal aside")]
    DamagedJournal {
        /// What is wrong.
        error: JournalError,
        /// How to give it up.
        abandon: String,
    },
    /// Several wires of a job were interrupted.
    #[error("several wires of this job are not over ({}): say with --wire which is meant", numbers(wires))]
    SeveralUnfinished {
        /// Their indices, from 0.
        wires: Vec<usize>,
    },
    /// Nothing of the job was begun.
    #[error("no wire of this job was begun: leave out {option}")]
    NothingBegun {
        /// What was asked for.
        option: &'static str,
    },
    /// A person has to look at the wire.
    #[error(
        "{doubt}; look at the wire, and say `{command}=made:{n}` when it was made to its end, `{command}=not-made:{n}` when nothing of it was,{counted} or `{command}=part:{n}:MM:DEGREES` with how much was fed and turned: the rest is made then, and its bend from the beginning",
        n = doubt.step,
        counted = counted(doubt, command)
    )]
    InDoubt {
        /// The step.
        doubt: Box<Doubt>,
        /// The command without the answer.
        command: String,
    },
    /// A person has said something of a step that is in no doubt.
    #[error(
        "nobody has to know what became of step {step}: {made} {} made, and {}; say `{command}` without that answer",
        if *made == 1 { "step is" } else { "steps are" },
        in_doubt.map_or_else(|| "no step is in doubt".to_owned(), |n| format!("step {n} is the one in doubt"))
    )]
    OtherStep {
        /// The step that was named.
        step: u32,
        /// The first that is in doubt.
        in_doubt: Option<u32>,
        /// The last that is made.
        made: u32,
        /// The command without the answer.
        command: String,
    },
    /// The machine has not counted how much of a step it has made.
    #[error("nobody has counted how much of step {step} is made: measure it")]
    NotCounted {
        /// The step.
        step: u32,
    },
    /// The machine and the journal cannot both be right, and nobody has said that it may be stopped.
    #[error(
        "{reason}. With `{command}=made:N`, `{command}=not-made:N` or `{command}=part:N:MM:DEGREES` of the first step N that it is unknown of, the machine is stopped, and the answer is taken"
    )]
    Contradiction {
        /// What contradicts what.
        reason: String,
        /// The command without the answer.
        command: String,
    },
    /// There is no place for journals and records.
    #[error(
        "there is no folder of yours to keep journals of wires in: set HOME, or name one with --runs-folder"
    )]
    NowhereToRecord,
    /// The folder of journals and records cannot be used.
    #[error("{} cannot be used for journals and records: {cause}", folder.display())]
    RunsFolder {
        /// The folder.
        folder: PathBuf,
        /// Why.
        cause: std::io::Error,
    },
    /// There is no such record.
    #[error("there is no record '{id}'; see `wirebend runs`")]
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
    #[error("{file}: {reason}; record the moves again with `wirebend jog … --record FILE`")]
    Moves {
        /// The file.
        file: String,
        /// What is wrong.
        reason: String,
    },
    /// Moves were recorded on another machine, or the machine's profile has changed since.
    #[error("{file} was recorded {recorded}; to replay it all the same, say --machine {machine}")]
    OtherMachine {
        /// The file.
        file: String,
        /// On which, as opposed to what there is now.
        recorded: String,
        /// The machine.
        machine: String,
    },
}

fn there_are(known: &[String]) -> String {
    if known.is_empty() {
        "the driver lists no port".to_owned()
    } else {
        format!("there are: {}", known.join(", "))
    }
}

const fn stopped_for_it(stands: bool) -> &'static str {
    if stands {
        "the machine was stopped for it and stands: make room on the disk, or see that it can be written to"
    } else {
        "the machine was stopped for it and has not confirmed that it stands: cut its power; make room on the disk, or see that it can be written to"
    }
}

const fn held_by(by: PausedBy) -> &'static str {
    match by {
        PausedBy::Program => "",
        PausedBy::Silence => ", since it had heard nothing for too long",
        PausedBy::Machine => ", of which somebody at it may know",
    }
}

/// What a person does when a driver had to be ended.
pub(crate) const fn hard_stop(by: StoppedBy) -> &'static str {
    match by {
        StoppedBy::Host => "the stop was written to the port itself; connect the machine again",
        _ => "cut the power of the machine if it still moves, then connect it again",
    }
}

fn how_to_set(machine: &str, port: &str, writable: bool) -> String {
    if writable {
        format!("write them with `wirebend machine-settings --machine {machine} --port {port} --write`")
    } else {
        "its driver cannot write them: set them at the machine with its own program, or correct the profile and plan the job again"
            .to_owned()
    }
}

/// The answer that takes what the machine has counted, where it has.
fn counted(doubt: &Doubt, command: &str) -> String {
    let step = doubt.step;
    doubt
        .counted
        .map(|_| format!(" `{command}=as-counted:{step}` when what the machine counts is right,"))
        .unwrap_or_default()
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

#[cfg(test)]
mod tests {
    use super::*;

    /// A command that the driver refuses leads a person in a circle.
    #[test]
    fn settings_are_written_by_a_command_only_where_the_driver_can() {
        let told = |writable| {
            let setting = SettingCheck {
                name: "$100".to_owned(),
                machine: "80".to_owned(),
                expected: "40".to_owned(),
                matters: true,
            };
            let (machine, port) = ("bender".to_owned(), "/dev/ttyUSB0".to_owned());
            LiveProblem::SettingsDiffer { machine, port, settings: vec![setting], writable }.to_string()
        };
        assert!(told(true).contains("$100 is 80, not 40; write them with `wirebend machine-settings"));
        assert!(told(false).contains("$100 is 80, not 40; its driver cannot write them"));
        assert!(!told(false).contains("--write"), "{}", told(false));
        assert!([true, false].into_iter().all(|writable| told(writable).contains("--accept-settings")));
    }
}
