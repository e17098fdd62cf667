//! `jog`, `replay` and `dry-run`: moves by hand, a recorded row of them, and those of a wire without wire.

mod dry_run;
mod making;
mod moves;
mod wire;

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_driver_host::Standstill;
use wirebend_profile::{MachineProfile, Resolved};

use crate::FrontEnd;
use crate::live::{Answers, Zero};
use crate::order::Move;
use crate::run::{LeftBecause, Task};
use crate::{LiveProblem, OperationError, Repeat, RunHow, RunRequest};
pub use dry_run::DryRun;
use making::make;
pub use making::{MoveProgress, MoveRow, lines, make_all, require};
pub use moves::MovesFile;
pub use moves::{check_moves, profile_hash};
pub use wire::WireByHand;
use wirebend_error::ProblemReport;
use wirebend_planning::Installation;
use wirebend_planning::design::Input;
use wirebend_planning::job::SimulatedAs;
use wirebend_planning::misnamed::MOVES;
use wirebend_planning::output::Output;
use wirebend_planning::report::NoteReport;

/// What to move. Nothing moves unless a person says so: here, or when they are asked.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct JogRequest {
    pub machine: String,
    /// Where it is; absent, the machine that its driver simulates is taken, if it has one.
    pub port: Option<String>,
    /// The moves, in order.
    pub moves: Vec<Move>,
    #[serde(flatten)]
    pub answers: Answers,
    /// A file for the moves that are done, to be replayed.
    pub record: Option<Output>,
}

/// Recorded moves to replay. Nothing moves unless the user confirms it: here, or when they are asked.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct ReplayRequest {
    /// The recording.
    pub file: Input,
    /// The machine; absent, the one of the recording. Named, it may be another one, or one whose profile has
    /// changed since.
    pub machine: Option<String>,
    /// Where it is; absent, the machine that its driver simulates is taken, if it has one.
    pub port: Option<String>,
    #[serde(flatten)]
    pub answers: Answers,
}

/// A wire whose moves are to be made without wire. Nothing moves unless a person confirms it: here, or when they are asked.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct DryRunRequest {
    /// A job, or a program in the format of its machine.
    pub job: Input,
    /// The machine that a program is for; a job says it itself.
    #[serde(default)]
    pub machine: Option<String>,
    /// The wire that a program is for; absent, the one that the machine's profile names.
    #[serde(default)]
    pub material: Option<String>,
    /// Whether to do it although a check says that the machine cannot make the wire.
    #[serde(default)]
    pub despite_errors: bool,
    /// Whether to do it although the machine's settings are not those of its profile.
    #[serde(default)]
    pub accept_settings: bool,
    /// Where the machine is; absent, the machine that its driver simulates is taken, if it has one.
    pub port: Option<String>,
    /// Index of the wire, from 0; it has to be named where there are several.
    pub wire: Option<usize>,
    #[serde(flatten)]
    pub answers: Answers,
}

/// What was moved.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct JogResponse {
    pub machine: String,
    pub port: String,
    /// What it says that it is.
    pub identity: String,
    /// The moves that are done.
    pub made: Vec<Move>,
    /// How many there were to be.
    pub of: usize,
    /// Why the rest was not begun, where the user had to be asked in the middle; null where all are done, or one failed.
    pub left_because: Option<LeftBecause>,
    /// Whether it was stopped.
    pub stopped: bool,
    /// Whether the machine stands after a stop, after its driver was lost, or after a fault while it might move; null
    /// where there was none of them.
    pub standstill: Option<Standstill>,
    /// What failed.
    pub problem: Option<ProblemReport>,
    /// The recording.
    pub output: Option<PathBuf>,
    /// What a person should know.
    pub notes: Vec<NoteReport>,
}

pub fn jog(
    app: &Installation,
    request: &JogRequest,
    progress: &dyn FrontEnd,
) -> Result<JogResponse, OperationError> {
    request.record.as_ref().map_or(Ok(()), Output::check)?;
    check_moves(&request.moves)?;
    let machine = app.library.machine(&request.machine)?;
    let hand = Hand { port: request.port.as_deref(), answers: request.answers, zero: Zero::Moves };
    let mut response = make(
        app,
        &machine,
        &hand,
        &MoveRow { moves: &request.moves, notes: Vec::new(), dry: None },
        progress,
    )?;
    if let Some(output) = &request.record {
        if response.made.is_empty() {
            let message = "nothing was moved, and so nothing was recorded".to_owned();
            response.notes.push(NoteReport {
                code: "nothing-recorded".into(),
                count: 1,
                message,
                remedies: Vec::new(),
            });
        } else {
            let file = MovesFile::new(&machine, response.made.clone())?;
            match output.save_or_note(&file.to_bytes()?) {
                Ok(path) => {
                    response.output = Some(path);
                    response.notes.extend(MOVES.misnamed(Some(output)));
                }
                Err(note) => response.notes.push(note),
            }
        }
    }
    Ok(response)
}

pub fn replay(
    app: &Installation,
    request: &ReplayRequest,
    progress: &dyn FrontEnd,
) -> Result<JogResponse, OperationError> {
    progress.stage("reading");
    let (name, bytes) = request.file.load()?;
    let file = MovesFile::open(&name, &bytes)?;
    let machine = app.library.machine(request.machine.as_ref().unwrap_or(&file.machine))?;
    let lines = other_machine(&name, &file, &machine, request.machine.is_some())?;
    let hand = Hand { port: request.port.as_deref(), answers: request.answers, zero: Zero::Wire };
    make(app, &machine, &hand, &MoveRow { moves: &file.moves, notes: lines, dry: None }, progress)
}

pub fn dry_run(
    app: &Installation,
    request: &DryRunRequest,
    progress: &dyn FrontEnd,
) -> Result<JogResponse, OperationError> {
    let DryRunRequest { job, machine, material, despite_errors, accept_settings, port, wire, answers } =
        request.clone();
    let request = RunRequest {
        job,
        machine,
        material,
        despite_errors,
        port,
        wire,
        repeat: Repeat::default(),
        how: RunHow::Begin,
        simulated_as: SimulatedAs::default(),
        answers,
        accept_settings,
        record: None,
    };
    let task = Task::open(app, request, progress)?;
    let &[wire] = task.wanted().as_slice() else {
        return Err(LiveProblem::WhichWire { count: task.wanted().len() }.into());
    };
    let dry = DryRun::of(&task, wire)?;
    let moves = dry.moves()?;
    let hand = Hand { port: task.request.port.as_deref(), answers, zero: Zero::Wire };
    make(
        app,
        &task.setup.machine,
        &hand,
        &MoveRow { moves: &moves, notes: dry.lines(), dry: Some(dry) },
        progress,
    )
}

/// The moves of a recording for a machine that is connected, and what a person has to know of them. `named`: whether they
/// have said that the recording may be of another machine.
pub fn moves_of(
    file: &Input,
    machine: &Resolved<MachineProfile>,
    named: bool,
) -> Result<(Vec<Move>, Vec<String>), OperationError> {
    let (name, bytes) = file.load()?;
    let file = MovesFile::open(&name, &bytes)?;
    let lines = other_machine(&name, &file, machine, named)?;
    Ok((file.moves, lines))
}

/// What a person has to know of a recording from elsewhere, which they have asked for by name.
fn other_machine(
    name: &str,
    file: &MovesFile,
    machine: &Resolved<MachineProfile>,
    named: bool,
) -> Result<Vec<String>, OperationError> {
    let Some(recorded) = file.differs(machine)? else { return Ok(Vec::new()) };
    if !named {
        let (file, machine) = (name.to_owned(), machine.profile.id.clone());
        return Err(LiveProblem::OtherMachine { file, recorded, machine }.into());
    }
    Ok(vec![format!("these moves were recorded {recorded}")])
}

/// Where the machine is, and what a person has answered.
struct Hand<'a> {
    port: Option<&'a str>,
    answers: Answers,
    /// What the moves count from.
    zero: Zero,
}
