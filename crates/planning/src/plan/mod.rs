//! `check` and `plan`: a design through the whole pipeline, or as far as it goes without a machine.

mod check;
mod choice;
mod head;
mod observed;
mod parts;
mod searched;
mod springback;
mod wire;

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::time::Instant;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_core::checks::{Design, Diagnostic, Remedy, check_design};
use wirebend_core::plan::{WirePlan, name_closing_bends};
use wirebend_core::units::Length;
use wirebend_core::wireframe::Component;
use wirebend_files::document::{Job, JobContents, JobPause, JobStep, JobWire, ProfileSnapshot};

use crate::choices::PlanChoices;
use crate::design::{DesignInput, Opened};
use crate::machine::Setup;
use crate::misnamed;
use crate::output::Output;
use crate::pauses::{PlannedPauses, StepPause};
use crate::report::{DiagnosticReport, NoteReport, PlanReport, WireReport};
use crate::stage::StageName;
use crate::{Installation, PlanningError, Progress, text};
pub use check::{CheckRequest, CheckResponse, check};
pub use choice::wires_of_parts;
use parts::{Parts, PlannedParts};

#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct PlanRequest {
    pub design: DesignInput,
    /// On which machine, and how.
    pub choices: PlanChoices,
    /// Where the job goes.
    pub output: Option<Output>,
    /// Whether to return the job, where it does not go to a file.
    #[serde(default)]
    pub make_job: bool,
    /// Steps after which the machine waits for a person, besides the pause points of the design.
    #[serde(default)]
    pub pauses: Vec<StepPause>,
    /// Whether to write a job although a check says that it cannot be made.
    #[serde(default)]
    pub despite_errors: bool,
}

/// A planned design.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct PlanResponse {
    #[serde(flatten)]
    pub report: PlanReport,
    pub machine: String,
    pub material: String,
    /// What was merged, ignored or assumed while reading.
    pub notes: Vec<NoteReport>,
    /// The job's file.
    pub output: Option<PathBuf>,
    /// The job's hash.
    pub job_hash: Option<String>,
    /// Whether a job was asked for and not written, because the machine cannot make it.
    pub withheld: bool,
    /// The job, where it was asked for and not written to a file.
    #[serde(skip)]
    pub contents: Vec<u8>,
}

/// A planned design with everything that was found on the way.
pub struct Planned {
    pub opened: Opened,
    pub setup: Setup,
    pub components: usize,
    pub wires: Vec<WirePlan>,
    pub timings: Vec<BTreeMap<&'static str, f64>>,
    /// What the checks say of the design as a whole.
    pub design: Vec<Diagnostic>,
    /// Where the machine waits for a person.
    pub pauses: PlannedPauses,
}

impl Installation {
    /// Plans every wire of a design.
    pub fn plan_design(
        &self,
        opened: Opened,
        choices: &PlanChoices,
        progress: &dyn Progress,
    ) -> Result<Planned, PlanningError> {
        let setup = self.setup_of(&opened, choices)?;
        Self::plan_with(opened, setup, choices, progress)
    }

    /// The machine of a design with its wire, unless another one is chosen.
    pub fn setup_of(&self, opened: &Opened, choices: &PlanChoices) -> Result<Setup, PlanningError> {
        let document = &opened.document;
        let named =
            |snapshot: &Option<ProfileSnapshot>| snapshot.as_ref().map(|snapshot| snapshot.id.clone());
        let machine = choices.machine.clone().or_else(|| named(&document.machine));
        let machine = machine.ok_or_else(|| PlanningError::NoMachine { known: self.machine_ids() })?;
        let material = choices.material.clone().or_else(|| named(&document.material));
        self.setup(&machine, material.as_deref())
    }

    /// Plans every wire of a design on a machine with a wire in it.
    pub fn plan_with(
        opened: Opened,
        setup: Setup,
        choices: &PlanChoices,
        progress: &dyn Progress,
    ) -> Result<Planned, PlanningError> {
        let mut opened = opened;
        let components = opened.document.wireframe.components();
        setup.driver.require_settings()?;
        let parts = Parts::of(&opened, &components, choices)?;
        let (mut design, planned) = std::thread::scope(|scope| {
            // Neither reads what the other finds.
            let design = scope.spawn(|| checked_design(&opened, &components, setup.model.wire.diameter));
            let planned = parts.plan(&setup, progress);
            if !design.is_finished() {
                progress.stage("checking the design");
            }
            (design.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)), planned)
        });
        opened.notes.extend(setup.driver.note.clone());
        opened.notes.extend(springback::estimated(&setup));
        let PlannedParts { mut wires, timings, replaced } = planned;
        opened.notes.extend(springback::held(&setup, &wires));
        opened.notes.extend(replaced.notes());
        let pauses = PlannedPauses::of(&opened.document.pauses, &wires);
        opened.notes.extend(pauses.notes());
        name_closing_bends(&mut design, &wires, &setup.model);
        // Of a single wire, everything is said with it.
        if let [wire] = wires.as_mut_slice() {
            wire.diagnostics.append(&mut design);
            wire.diagnostics.sort_by_key(|diagnostic| diagnostic.severity);
        } else {
            design.extend(head::of_all(&mut wires));
        }
        Ok(Planned { opened, setup, components: components.len(), wires, timings, design, pauses })
    }
}

/// What is said of a design before any machine is asked, for a wire so thick.
fn checked_design(opened: &Opened, components: &[Component], diameter: Length) -> Vec<Diagnostic> {
    let mut found = check_design(&Design {
        wireframe: &opened.document.wireframe,
        components,
        weld_tolerance: crate::design::default_weld(),
        diameter,
    });
    if opened.document.stencils.is_empty() {
        // There is no face whose edges could be taken.
        for finding in &mut found {
            finding.remedies.retain(|remedy| *remedy != Remedy::TakeFaceEdges);
        }
    }
    found
}

impl Planned {
    /// Whether it was looked at where each wire meets the machine or itself.
    pub fn collisions_checked(&self) -> bool {
        !self.wires.is_empty() && self.wires.iter().all(|wire| wire.contacts.is_some())
    }

    /// Whether the machine can make all of it.
    pub fn feasible(&self) -> bool {
        !self.wires.is_empty()
            && self.wires.iter().all(WirePlan::is_feasible)
            && !self.design.iter().any(Diagnostic::is_error)
    }

    /// The errors that the checks found.
    fn accepted_errors(&self) -> impl Iterator<Item = &Diagnostic> {
        let of_wires = self.wires.iter().flat_map(|wire| &wire.diagnostics);
        self.design.iter().chain(of_wires).filter(|diagnostic| diagnostic.is_error())
    }

    pub fn report(&self) -> PlanReport {
        let wireframe = &self.opened.document.wireframe;
        let mut wires: Vec<WireReport> = self
            .wires
            .iter()
            .zip(&self.timings)
            .zip(&self.pauses.wires)
            .map(|((plan, took), pauses)| {
                WireReport::new(wireframe, self.components, plan, pauses, &self.setup, took.clone())
            })
            .collect();
        if wires.len() == 1 && self.design.is_empty() {
            return PlanReport::One(Box::new(wires.remove(0)));
        }
        PlanReport::Several {
            wires,
            diagnostics: self.design.iter().map(DiagnosticReport::from).collect(),
            feasible: self.feasible(),
        }
    }

    /// The job, or `None` where some wire was not compensated.
    pub fn job(&self) -> Result<Option<Job>, PlanningError> {
        let wires = self.wires.iter().zip(&self.pauses.wires).map(|(plan, pauses)| job_wire(plan, pauses));
        let Some(wires) = wires.collect::<Option<Vec<_>>>() else {
            return Ok(None);
        };
        if wires.is_empty() {
            return Ok(None);
        }
        let snapshot = |id: &str, value| ProfileSnapshot { id: id.to_owned(), snapshot: value };
        Ok(Some(Job::seal(JobContents {
            design_hash: self.opened.document.design_hash()?,
            machine: snapshot(self.setup.machine_id(), serde_json::to_value(&self.setup.machine)?),
            material: snapshot(self.setup.material_id(), serde_json::to_value(&self.setup.material)?),
            wires,
            objections: self.accepted_errors().map(text::message).collect(),
            program: None,
        })?))
    }
}

pub(crate) fn job_wire(plan: &WirePlan, pauses: &[JobPause]) -> Option<JobWire> {
    let (route, nominal) = (plan.route.as_ref()?, plan.nominal.as_ref()?);
    let (scheduled, compensated) = (plan.scheduled.as_ref()?, plan.compensated.as_ref()?);
    let steps = |steps: &[wirebend_core::bend::Step]| steps.iter().copied().map(JobStep::from).collect();
    Some(JobWire {
        vertices: route.vertices().iter().map(|id| id.0).collect(),
        path_mm: plan.path.iter().map(|point| [point.x, point.y, point.z]).collect(),
        nominal: steps(&nominal.steps),
        spans: nominal.spans.iter().map(|span| [span.start, span.end]).collect(),
        scheduled: steps(&scheduled.steps),
        compensated: compensated.told().map(JobStep::from).collect(),
        stock_mm: plan.stock?.mm(),
        time_s: plan.seconds?,
        avoids_collisions: plan.searched.is_some_and(|searched| searched.found),
        clearance_mm: Some(plan.contact_options.margin.mm()).filter(|&mm| mm > 0.0),
        sag: plan.contact_options.sag,
        pauses: pauses.to_vec(),
    })
}

pub fn plan(
    app: &Installation,
    request: &PlanRequest,
    progress: &dyn Progress,
) -> Result<PlanResponse, PlanningError> {
    request.output.as_ref().map_or(Ok(()), Output::check)?;
    let started = Instant::now();
    let opened = app
        .designed(request.design.open_with(app, &request.choices, progress)?, &request.choices)?
        .with_wireframe()?;
    let read_ms = started.elapsed().as_secs_f64() * 1000.0;
    let mut planned = app.plan_design(opened, &request.choices, progress)?;
    planned.pauses = planned.pauses.and(&request.pauses, &planned.wires)?;
    if let Some(first) = planned.timings.first_mut() {
        first.insert("read", read_ms);
    }
    let report = planned.report();
    let mut made = (None, None, Vec::new());
    let wanted = request.output.is_some() || request.make_job;
    let withheld = wanted && !planned.feasible() && !request.despite_errors;
    if wanted && !withheld {
        progress.stage("writing");
        let stage = StageName::Compensated;
        let unreached = || PlanningError::StageNotReached { stage, report: Box::new(report.clone()) };
        let job = planned.job()?.ok_or_else(unreached)?;
        let hash = Some(job.hash().to_owned());
        made = match &request.output {
            Some(output) => {
                planned.opened.notes.extend(misnamed::JOB.misnamed(Some(output)));
                (Some(output.save(&job.to_bytes()?)?), hash, Vec::new())
            }
            None => (None, hash, job.to_bytes()?),
        };
    }
    Ok(PlanResponse {
        report,
        machine: planned.setup.machine_id().to_owned(),
        material: planned.setup.material_id().to_owned(),
        notes: planned.opened.notes,
        output: made.0,
        job_hash: made.1,
        withheld,
        contents: made.2,
    })
}
