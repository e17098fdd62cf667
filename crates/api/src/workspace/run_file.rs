//! A job, a program or a recording that is open to be shown and run. The design stays as it is behind it.

use std::path::PathBuf;
use std::sync::{Arc, PoisonError};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_files::document::Job;
use wirebend_files::read::Format;
use wirebend_planning::as_given::{GivenWires, ProgramMachine, job_of_file, job_of_moves};
use wirebend_planning::job::is_job;
use wirebend_planning::machine::{Setup, accepted_errors, restored};
use wirebend_planning::report::{DiagnosticReport, NoteReport};
use wirebend_planning::{Installation, PlanningError};

use super::{MadeResponse, ProgramResponse, Workspace};
use crate::{ApiError, Input, MovesFile, Progress};

/// Opens a job, a program in the format of the design's machine, or a recording, to be shown and run.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct OpenRunFile {
    pub file: Input,
}

/// Checks what is open with the profiles as they are now, as it was read: another file in its place is not looked at.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct CheckRunFile {}

/// Closes it: the design is shown and run again.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct CloseRunFile {}

/// Asks which is open.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct RunFileRequest {}

#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct RunFileNow {
    /// Null where none is open: the design is run.
    pub file: Option<RunFileReport>,
}

/// What is open to be run.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct RunFileReport {
    /// Name of the file, without its folder.
    pub name: String,
    /// Where it is; null for bytes.
    pub path: Option<PathBuf>,
    pub kind: RunFileKind,
    /// Machine and wire that it is for.
    pub machine: String,
    pub material: String,
    /// Hash of the job that it is run as; another one where the same name holds other contents.
    pub job_hash: String,
    pub wires: Vec<RunFileWire>,
    /// How many moves a recording has.
    pub moves: usize,
    /// Whether the machine can make it, as its profile was when a job was planned; a program that collides cannot be made.
    pub feasible: bool,
    /// What the checks say of its wires, errors first.
    pub findings: Vec<DiagnosticReport>,
    /// Errors despite which a job was planned; of a program, that the search for collisions did not end.
    pub notes: Vec<NoteReport>,
}

/// What a file to be run is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum RunFileKind {
    /// A sealed job, run as it was planned.
    Job,
    /// A program in the machine's own format, run as it stands: nothing of it is compensated.
    Program,
    /// Recorded moves, which are replayed.
    Moves,
}

/// A wire of it.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct RunFileWire {
    pub steps: usize,
    /// Wire that is fed, mm.
    pub length_mm: f64,
    /// Stock to load, mm.
    pub stock_mm: f64,
    pub time_s: f64,
}

/// What is open to be run, with all that is shown of it.
pub(super) struct RunFile {
    pub report: RunFileReport,
    /// As it was read.
    bytes: Arc<[u8]>,
    job: Job,
    setup: Setup,
    wires: GivenWires,
}

impl RunFile {
    /// Its job, as an order takes it; a program that the machine cannot make only where a person wants it.
    pub fn job(&self, despite_errors: bool) -> Result<Input, ApiError> {
        let RunFileReport { name, kind, feasible, .. } = &self.report;
        if *kind == RunFileKind::Moves {
            return Err(PlanningError::NotAJob { name: name.clone() }.into());
        }
        // Who planned a job despite an error knew it.
        if *kind == RunFileKind::Program && !feasible && !despite_errors {
            let (machine, report) = (self.setup.machine_id().to_owned(), self.wires.report(&self.setup));
            return Err(PlanningError::NotFeasible { machine, report: Box::new(report) }.into());
        }
        let stem = name.rsplit_once('.').map_or(name.as_str(), |(stem, _)| stem);
        Ok(Input::Bytes {
            name: format!("{stem}.wbjob"),
            bytes: self.job.to_bytes().map_err(PlanningError::from)?,
        })
    }

    /// Refuses to move anything for a file that is another one by now: a person has looked at what was read before. One that is gone
    /// is still what was looked at.
    pub fn require_unchanged(&self) -> Result<(), ApiError> {
        let now = self.report.path.as_ref().and_then(|path| std::fs::read(path).ok());
        match now {
            Some(bytes) if *bytes != *self.bytes => {
                Err(ApiError::FileChanged { name: self.report.name.clone() })
            }
            _ => Ok(()),
        }
    }

    pub fn program(&self) -> ProgramResponse {
        let RunFileReport { machine, material, kind, feasible, job_hash, .. } = self.report.clone();
        ProgramResponse {
            machine,
            material,
            diameter_mm: self.setup.model.wire.diameter.mm(),
            feasible,
            // What is replayed is no wire of a job.
            job_hash: (kind != RunFileKind::Moves).then_some(job_hash),
            wires: self.wires.played(&self.setup),
            without: 0,
            left_out: Vec::new(),
        }
    }
}

impl Workspace {
    pub(crate) fn open_run_file(
        &self,
        asked: &OpenRunFile,
        progress: &dyn Progress,
    ) -> Result<RunFileNow, ApiError> {
        progress.stage("reading");
        let (name, bytes) = asked.file.load()?;
        let (path, own) = match &asked.file {
            Input::File(path) => (Some(path.clone()), crate::workspace::name_of(path)),
            Input::Bytes { name, .. } => (None, name.clone()),
        };
        let design = self.open().state();
        let of = ProgramMachine { machine: design.machine.as_deref(), material: design.material.as_deref() };
        let file =
            read_run_file(&self.installation(), &name, (path.clone(), own), bytes.into(), of, progress)?;
        if let Some(path) = path {
            self.remember(&path);
        }
        self.put_run_file(Some(file));
        Ok(self.run_file_now())
    }

    pub(crate) fn check_run_file(
        &self,
        _: &CheckRunFile,
        progress: &dyn Progress,
    ) -> Result<RunFileNow, ApiError> {
        while let Some(open) = self.run_file() {
            let app = self.installation();
            let RunFileReport { name, path, machine, material, .. } = &open.report;
            let full = path.as_ref().map_or_else(|| name.clone(), |path| path.display().to_string());
            let of = ProgramMachine { machine: Some(machine), material: Some(material) };
            let bytes = Arc::clone(&open.bytes);
            let file = read_run_file(&app, &full, (path.clone(), name.clone()), bytes, of, progress);
            let mut now = self.run_file.lock().unwrap_or_else(PoisonError::into_inner);
            // Closed meanwhile, or another one opened.
            if !now.as_ref().is_some_and(|now| Arc::ptr_eq(&now.bytes, &open.bytes)) {
                break;
            }
            // Profiles that were changed meanwhile count.
            if !Arc::ptr_eq(&app, &self.installation()) {
                continue;
            }
            // What cannot be checked any more is not armed with what was found before.
            *now = None;
            *now = Some(Arc::new(file?));
            break;
        }
        Ok(self.run_file_now())
    }
    pub(crate) fn close_run_file(&self, _: &CloseRunFile, _: &dyn Progress) -> Result<RunFileNow, ApiError> {
        self.put_run_file(None);
        Ok(self.run_file_now())
    }

    pub(crate) fn ask_run_file(&self, _: &RunFileRequest, _: &dyn Progress) -> Result<RunFileNow, ApiError> {
        Ok(self.run_file_now())
    }

    fn run_file_now(&self) -> RunFileNow {
        RunFileNow { file: self.run_file().map(|file| file.report.clone()) }
    }

    /// What is open to be run instead of the design.
    pub(super) fn run_file(&self) -> Option<Arc<RunFile>> {
        self.run_file.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    pub(super) fn put_run_file(&self, file: Option<RunFile>) {
        *self.run_file.lock().unwrap_or_else(PoisonError::into_inner) = file.map(Arc::new);
    }

    /// How the machine bends what is open to be run.
    pub(super) fn made_of_file(
        &self,
        file: &RunFile,
        progress: &dyn Progress,
    ) -> Result<MadeResponse, ApiError> {
        super::program::made_of(&self.installation(), &file.report.name, &file.setup, &file.job, progress)
    }
}

/// What a file holds that is to be run; `of` is the machine that a program is for, which has no other.
fn read_run_file(
    app: &Installation,
    name: &str,
    (path, own): (Option<PathBuf>, String),
    bytes: Arc<[u8]>,
    of: ProgramMachine,
    progress: &dyn Progress,
) -> Result<RunFile, ApiError> {
    let moves = is_recording(name, &bytes);
    let (kind, job, moves) = if moves {
        let count = MovesFile::open(name, &bytes)?.moves.len();
        (RunFileKind::Moves, job_of_moves(app, name, &bytes, of)?, count)
    } else {
        let kind = if is_job(name, &bytes) { RunFileKind::Job } else { RunFileKind::Program };
        (kind, job_of_file(app, name, &bytes, of)?, 0)
    };
    let setup = restored(name, job.contents())?;
    let mut wires = GivenWires::of(name, &job, &setup)?;
    let mut notes = if kind == RunFileKind::Job { accepted_errors(job.contents()) } else { Vec::new() };
    // Nobody has looked at a program before: one that collides is refused like a design that does.
    if kind == RunFileKind::Program {
        progress.stage("checking for collisions");
        notes.extend(wires.find_collisions(&setup));
    }
    let report = RunFileReport {
        name: own,
        path,
        kind,
        machine: setup.machine_id().to_owned(),
        material: setup.material_id().to_owned(),
        job_hash: job.hash().to_owned(),
        wires: job.contents().wires.iter().map(|wire| RunFileWire::of(wire, &setup)).collect(),
        moves,
        feasible: wires.feasible(),
        findings: wires.findings().map(DiagnosticReport::from).collect(),
        notes,
    };
    Ok(RunFile { report, bytes, job, setup, wires })
}

impl RunFileWire {
    fn of(wire: &wirebend_files::document::JobWire, setup: &Setup) -> Self {
        Self {
            steps: wire.compensated.len(),
            length_mm: setup.fed_mm(wire),
            stock_mm: wire.stock_mm,
            time_s: wire.time_s,
        }
    }
}

/// Whether a file is a recording of moves.
pub(super) fn is_recording(name: &str, bytes: &[u8]) -> bool {
    matches!(wirebend_files::read::detect(name, bytes), Ok(Format::Moves))
}
