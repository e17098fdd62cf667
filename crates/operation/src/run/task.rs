//! What is to be bent, and where its journals are.

use std::cell::Cell;
use std::path::Path;

use wirebend_driver_host::api::{Bench, DoneBy};
use wirebend_driver_host::jobs::{Part, Record, SystemClock, WireJob};
use wirebend_error::{ErrorRemedy, InputName, RunTarget};
use wirebend_files::document::{Job, JobPause, JobStep, JobWire};

use super::interrupted::Interrupted;
use super::report::{RunOutcome, RunResponse, WireRun};
use super::{RunHow, RunRequest};
use crate::FrontEnd;
use crate::live::Reattached;
use crate::live::{At, Connection, Unnamed};
use crate::pieces::Pieces;
use crate::runs::{RunsFolder, StoredRun, record_bytes};
use crate::{LiveProblem, OperationError};
use wirebend_planning::as_given::{GivenWires, ProgramMachine, job_of_file};
use wirebend_planning::design::Input;
use wirebend_planning::job::{SimulatedAs, work};
use wirebend_planning::machine::{Setup, accepted_errors, restored};
use wirebend_planning::output::Output;
use wirebend_planning::report::NoteReport;
use wirebend_planning::{Installation, PartOfStep, PlanningError};

/// A job, its machine, and the journals of its wires.
pub struct Task<'a> {
    pub app: &'a Installation,
    pub request: RunRequest,
    pub progress: &'a dyn FrontEnd,
    pub file: String,
    pub job: Job,
    pub setup: Setup,
    /// What a simulated machine is told where that is not what the wire was planned for.
    pub bench: Option<Bench>,
    pub folder: RunsFolder,
    pub clock: SystemClock,
    pub pieces: Cell<Pieces>,
}

impl<'a> Task<'a> {
    pub fn open(
        app: &'a Installation,
        request: RunRequest,
        progress: &'a dyn FrontEnd,
    ) -> Result<Self, OperationError> {
        progress.stage("reading");
        let (file, bytes) = request.job.load()?;
        let of =
            ProgramMachine { machine: request.machine.as_deref(), material: request.material.as_deref() };
        let job = job_of_file(app, &file, &bytes, of)?;
        let setup = restored(&file, job.contents())?;
        if let Some(wanted) = request.machine.as_ref().filter(|wanted| *wanted != setup.machine_id()) {
            let (planned, wanted) = (setup.machine_id().to_owned(), wanted.clone());
            return Err(PlanningError::OtherMachine { name: file, planned, wanted }.into());
        }
        if request.material.as_ref().is_some_and(|wanted| wanted != setup.material_id()) {
            let (inputs, instead) = (vec![InputName::Material], Box::new(ErrorRemedy::PlanAgain));
            return Err(PlanningError::Settled { name: file, inputs, instead }.into());
        }
        require_feasible(&file, &job, &setup, &request)?;
        let simulated = &request.simulated_as;
        let bench = if simulated.is_as_planned() { None } else { Some(simulated.bench(app, &setup)?) };
        let count = job.contents().wires.len();
        if let Some(wire) = request.wire.filter(|&wire| wire >= count) {
            return Err(LiveProblem::NoWire { wire, count }.into());
        }
        let folder = RunsFolder::of(app)?;
        let pieces = Cell::new(Pieces::new(request.repeat)?);
        let clock = SystemClock::default();
        let task = Self { app, request, progress, file, job, setup, bench, folder, clock, pieces };
        for wire in task.wanted() {
            task.pieces.get().require_enough(task.wire(wire)?)?;
            for piece in 1..=task.request.repeat.pieces {
                task.record_output(wire, piece).map_or(Ok(()), |output| output.check())?;
            }
        }
        Ok(task)
    }

    /// The wires that were asked for.
    pub fn wanted(&self) -> Vec<usize> {
        self.request.wire.map_or_else(|| (0..self.job.contents().wires.len()).collect(), |wire| vec![wire])
    }

    /// The wires in the order in which they are bent, piece by piece: each with those of its piece that follow it.
    pub fn sequence<'w>(&self, wanted: &'w [usize]) -> impl Iterator<Item = (usize, &'w [usize])> + use<'w> {
        let piece =
            move |_| wanted.iter().enumerate().map(move |(place, &wire)| (wire, &wanted[place + 1..]));
        (0..self.request.repeat.pieces).flat_map(piece)
    }

    pub fn wire(&self, index: usize) -> Result<&JobWire, OperationError> {
        let count = self.job.contents().wires.len();
        let wire = self.job.contents().wires.get(index);
        wire.ok_or_else(|| LiveProblem::NoWire { wire: index, count }.into())
    }

    /// Where the machine waits for a person in a wire.
    pub fn pauses(&self, wire: usize) -> &[JobPause] {
        self.job.contents().wires.get(wire).map(|wire| wire.pauses.as_slice()).unwrap_or_default()
    }

    /// A wire for the machine that is connected: in the time that it takes there.
    pub fn work(&self, wire: usize, connection: &Connection) -> Result<WireJob, OperationError> {
        let setup = self.setup.at(&connection.board())?;
        let mut work = work(&setup, &self.job, &self.request.job.stem(), wire)?;
        if let Some(bench) = &self.bench {
            if connection.session.simulated().is_none() {
                return Err(LiveProblem::NotSimulated { port: connection.port.clone() }.into());
            }
            work.run.bench = Some(Box::new(bench.clone()));
        }
        Ok(work)
    }

    /// Refuses a wire that could not be finished; what is before step `from`, counted from 1, is done.
    pub fn require_within(
        &self,
        connection: &Connection,
        wire: usize,
        from: u32,
    ) -> Result<(), OperationError> {
        Ok(connection.require_within(wire, &self.work(wire, connection)?.steps, from)?)
    }

    /// The machine of the job, for a wire that is begun or resumed.
    pub fn at<'b>(&'b self, of: Option<&'b Interrupted>, unnamed: Unnamed<'b>) -> At<'b> {
        At {
            profile: &self.setup.machine.profile,
            signs: self.setup.signs,
            port: self.request.port.as_deref(),
            unnamed,
            reattached: of.map(|wire| Reattached { token: wire.token(), journal: wire.journal() }),
            axes_at_zero: self.request.answers.axes_at_zero,
        }
    }

    /// The last journal of a wire.
    pub fn last(&self, wire: usize) -> Result<Option<StoredRun>, OperationError> {
        Ok(self.folder.of_wire(self.job.hash(), wire)?.pop())
    }

    /// A wire of this job, so that it can be resumed or given up.
    pub fn target(&self, wire: usize) -> RunTarget {
        let job = match &self.request.job {
            Input::File(path) => Some(path.clone()),
            Input::Bytes { .. } => None,
        };
        let several = self.job.contents().wires.len() > 1;
        let RunRequest { port, machine, material, .. } = self.request.clone();
        RunTarget { job, wire: several.then_some(wire), port, machine, material }
    }

    /// An answer without a wire yet.
    pub fn response(&self) -> RunResponse {
        RunResponse {
            machine: self.setup.machine_id().to_owned(),
            material: self.setup.material_id().to_owned(),
            job_hash: self.job.hash().to_owned(),
            port: None,
            identity: None,
            wires: Vec::new(),
            left: Vec::new(),
            left_because: None,
            pieces: self.pieces.get().report(),
            notes: self.notes(),
            files: Vec::new(),
        }
    }

    /// What a person should know of the job and of what is simulated.
    fn notes(&self) -> Vec<NoteReport> {
        let mut notes = accepted_errors(self.job.contents());
        let SimulatedAs { machine, material } = &self.request.simulated_as;
        let head = machine.as_ref().map(|id| format!("the bend head of '{id}'"));
        let wire = material.as_ref().map(|id| format!("the wire '{id}'"));
        let of = [head, wire].into_iter().flatten().collect::<Vec<_>>();
        // A wire that is resumed is on the machine on which it was begun.
        if !of.is_empty() && self.request.how == RunHow::Begin {
            let (of, planned) = (of.join(" and "), (self.setup.machine_id(), self.setup.material_id()));
            let message = format!(
                "the simulated machine has {of}; the job was planned for '{}' with '{}'",
                planned.0, planned.1
            );
            notes.push(NoteReport { code: "simulated-as".into(), count: 1, message, remedies: Vec::new() });
        }
        notes
    }

    /// A wire that nothing was done to this time.
    pub fn untouched(
        &self,
        wire: usize,
        id: &str,
        outcome: RunOutcome,
        made: u32,
        done_by: DoneBy,
    ) -> Result<WireRun, OperationError> {
        let kept = self.wire(wire)?;
        Ok(WireRun {
            wire,
            piece: self.pieces.get().piece(),
            id: id.to_owned(),
            outcome,
            made,
            done_by,
            steps: u32::try_from(kept.compensated.len()).unwrap_or(u32::MAX),
            in_doubt: None,
            stopped_in: None,
            stock_mm: kept.stock_mm,
            elapsed_s: 0.0,
            stopped_by: None,
            standstill: None,
            problem: None,
            deviations_mm: None,
            resume: None,
            resumable: None,
        })
    }

    /// A step of a wire, from 1: as designed, and as sent to the machine in canonical signs, its feed in mm of wire: a person can
    /// measure nothing else.
    pub fn step(&self, wire: usize, n: u32) -> Result<(JobStep, JobStep), OperationError> {
        let index = usize::try_from(n).unwrap_or(usize::MAX).saturating_sub(1);
        let kept = self.wire(wire)?;
        let at = |steps: &[JobStep]| steps.get(index).copied().unwrap_or_default();
        let commanded = at(&kept.compensated);
        let feed_mm = commanded.feed_mm * self.feed_scale();
        Ok((at(&kept.scheduled), JobStep { feed_mm, ..commanded }))
    }

    /// How much of a step is in the wire, from what the machine counts.
    pub fn part(&self, part: Part) -> PartOfStep {
        let part = self.setup.signs.part(part);
        PartOfStep { feed_mm: part.feed_mm * self.feed_scale(), ..part }
    }

    /// How much of a step is in the wire as a person says it, as the machine counts it.
    pub fn told_part(&self, part: PartOfStep) -> Part {
        self.setup.signs.told_part(PartOfStep { feed_mm: part.feed_mm / self.feed_scale(), ..part })
    }

    /// Wire that is fed for each commanded millimetre.
    fn feed_scale(&self) -> f64 {
        self.setup.model.compensation.motion.feed_scale
    }

    /// `piece`: from 1. Of several wires or pieces each has a file of its own.
    fn record_output(&self, wire: usize, piece: u32) -> Option<Output> {
        let Output { path, force } = self.request.record.clone()?;
        let pieces = (self.request.repeat.pieces > 1).then(|| format!("-{piece}"));
        let wires = (self.wanted().len() > 1).then(|| format!("-{}", wire + 1));
        if pieces.is_none() && wires.is_none() {
            return Some(Output { path, force });
        }
        let which = pieces.unwrap_or_default() + &wires.unwrap_or_default();
        let stem = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let extension = path.extension().map(|e| format!(".{}", e.to_string_lossy())).unwrap_or_default();
        Some(Output { path: path.with_file_name(format!("{stem}{which}{extension}")), force })
    }

    /// Writes a record beside its journal, and to where it was asked for.
    pub fn keep(
        &self,
        record: Option<&Record>,
        journal: &Path,
        wire: usize,
        response: &mut RunResponse,
    ) -> Result<(), OperationError> {
        let Some(record) = record else { return Ok(()) };
        let path = Record::path_beside(journal);
        // The journal says the same: what cannot be written beside it is not lost.
        if let Err(cause) = record.write(&path) {
            let message = format!("the record {} cannot be written: {cause}", path.display());
            response.notes.push(NoteReport {
                code: "no-record".into(),
                count: 1,
                message,
                remedies: Vec::new(),
            });
        }
        let piece = self.pieces.get().piece().map_or(1, |piece| piece.number);
        if let Some(output) = self.record_output(wire, piece) {
            match output.save_or_note(&record_bytes(record)?) {
                Ok(file) => response.files.push(file),
                Err(note) => response.notes.push(note),
            }
        }
        Ok(())
    }
}

/// Refuses what the machine cannot make, and a wire that hits it or itself, unless a person wants it run all the same. Who planned a job
/// despite an error knew it.
fn require_feasible(
    file: &str,
    job: &Job,
    setup: &Setup,
    request: &RunRequest,
) -> Result<(), OperationError> {
    let known = job.contents().program.is_none() && !job.contents().objections.is_empty();
    if known || request.despite_errors || request.how != RunHow::Begin {
        return Ok(());
    }
    let mut given = GivenWires::of(file, job, setup)?;
    // Where the search does not end in time, the user reads that before they say yes.
    given.find_collisions(setup);
    if !given.feasible() {
        let report = Box::new(given.report(setup));
        return Err(PlanningError::NotFeasible { machine: setup.machine_id().to_owned(), report }.into());
    }
    Ok(())
}
