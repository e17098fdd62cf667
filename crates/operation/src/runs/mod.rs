//! `runs`: what was bent, wire by wire.

mod folder;

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
pub use wirebend_driver_host::jobs::{Outcome, PartInWire, Record, ToldBy};

use crate::FrontEnd;
use crate::OperationError;
pub use folder::{RunsFolder, StoredRun, record_bytes};
use wirebend_driver_host::jobs::Piece;
use wirebend_planning::Installation;
use wirebend_planning::misnamed::RECORD;
use wirebend_planning::output::Output;
use wirebend_planning::report::NoteReport;

/// Asks for the records of what was bent.
#[derive(Debug, Clone, Default, Deserialize, JsonSchema)]
pub struct RunsRequest {}

/// A wire that was begun.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct RunEntry {
    pub id: String,
    /// Why nothing is known of it, where its journal cannot be read; then the rest is absent.
    pub problem: Option<String>,
    /// Name of the design.
    pub name: Option<String>,
    pub job_hash: Option<String>,
    /// Index of the wire in the job, from 0.
    pub wire: Option<usize>,
    /// Which piece it is, where several were to be bent in a row.
    pub piece: Option<Piece>,
    pub machine: Option<String>,
    pub material: Option<String>,
    /// When it was begun.
    pub started: Option<String>,
    /// When it was over.
    pub ended: Option<String>,
    /// What became of it.
    pub outcome: Option<Outcome>,
    /// The last step that is done.
    pub made: Option<u32>,
    /// How many steps it has.
    pub steps: Option<u32>,
    /// How often it was stopped or failed.
    pub interruptions: Option<usize>,
    /// At how many pause points a person has let it go on.
    pub pauses: Option<usize>,
    /// How far the worst corner is from the design, in mm, where that was measured.
    pub worst_deviation_mm: Option<f64>,
}

/// The records.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct RunsResponse {
    /// Where they are; null where there is no such place.
    pub folder: Option<PathBuf>,
    /// In the order in which they were begun.
    pub runs: Vec<RunEntry>,
}

/// Asks for one record.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct RunsShowRequest {
    /// Its id, or enough of its beginning.
    pub id: String,
}

/// One record.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct RunsShowResponse {
    pub id: String,
    pub journal: PathBuf,
    pub record: Record,
}

/// Asks for one record as a file.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct RunsExportRequest {
    /// Its id, or enough of its beginning.
    pub id: String,
    /// Where it goes; absent, it is returned.
    pub output: Option<Output>,
}

/// A record as a file.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct RunsExportResponse {
    pub id: String,
    pub output: Option<PathBuf>,
    /// What a person should know.
    pub notes: Vec<NoteReport>,
    /// The contents, where they were not written.
    #[serde(skip)]
    pub contents: Vec<u8>,
}

pub fn list(
    app: &Installation,
    _request: &RunsRequest,
    _progress: &dyn FrontEnd,
) -> Result<RunsResponse, OperationError> {
    let Ok(folder) = RunsFolder::of(app) else {
        return Ok(RunsResponse { folder: None, runs: Vec::new() });
    };
    let mut runs: Vec<_> = folder.all()?.iter().map(|run| (run.last_written(), RunEntry::of(run))).collect();
    // Their stamps are such that their order is that of time. They count whole seconds: of wires that were begun in the same one,
    // the first to be over was begun first, as a machine bends one at a time.
    runs.sort_by(|(a_written, a), (b_written, b)| {
        (&a.started, a_written, &a.id).cmp(&(&b.started, b_written, &b.id))
    });
    let runs = runs.into_iter().map(|(_, run)| run).collect();
    Ok(RunsResponse { folder: Some(folder.path().to_owned()), runs })
}

pub fn show(
    app: &Installation,
    request: &RunsShowRequest,
    _progress: &dyn FrontEnd,
) -> Result<RunsShowResponse, OperationError> {
    let (id, journal, record) = found(app, &request.id)?;
    Ok(RunsShowResponse { id, journal, record })
}

pub fn export(
    app: &Installation,
    request: &RunsExportRequest,
    _progress: &dyn FrontEnd,
) -> Result<RunsExportResponse, OperationError> {
    request.output.as_ref().map_or(Ok(()), Output::check)?;
    let (id, _, record) = found(app, &request.id)?;
    let contents = record_bytes(&record)?;
    let notes = RECORD.misnamed(request.output.as_ref()).into_iter().collect();
    Ok(match &request.output {
        Some(output) => {
            RunsExportResponse { id, output: Some(output.save(&contents)?), notes, contents: Vec::new() }
        }
        None => RunsExportResponse { id, output: None, notes, contents },
    })
}

fn found(app: &Installation, id: &str) -> Result<(String, PathBuf, Record), OperationError> {
    let kept = RunsFolder::of(app)?.find(id)?;
    let record = kept.record();
    let StoredRun { id, path, read } = kept;
    read.map_err(crate::LiveProblem::from)?;
    // What can be read begins with a job.
    let record = record.ok_or(crate::LiveProblem::NoRun { id: id.clone() })?;
    Ok((id, path, record))
}

impl RunEntry {
    fn of(kept: &StoredRun) -> Self {
        let record = kept.record();
        let record = record.as_ref();
        let job = record.map(|record| &record.job);
        let deviations = record.and_then(|record| record.deviations_mm.as_ref());
        Self {
            id: kept.id.clone(),
            problem: kept.read.as_ref().err().map(ToString::to_string),
            name: job.map(|job| job.name.clone()),
            job_hash: job.map(|job| job.job_hash.clone()),
            wire: job.map(|job| job.wire),
            piece: job.and_then(|job| job.piece),
            machine: job.map(|job| job.machine.clone()),
            material: job.map(|job| job.material.clone()),
            started: record.map(|record| record.started.clone()),
            ended: record.and_then(|record| record.ended.clone()),
            outcome: record.map(|record| record.outcome),
            made: record.map(|record| record.made),
            steps: job.map(|job| job.steps),
            interruptions: record.map(|record| record.interruptions.len()),
            pauses: record.map(|record| record.pauses.len()),
            worst_deviation_mm: deviations.map(|all| all.iter().copied().fold(0.0, f64::max)),
        }
    }
}
