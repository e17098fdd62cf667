//! What is exported, from a design that is planned now or from a job that was planned before.

use std::collections::BTreeMap;

use nalgebra::Point3;
use wirebend_core::bend::Step;
use wirebend_core::compensate::ToldStep;
use wirebend_core::units::{Angle, DisplayUnit, Length};
use wirebend_core::wireframe::{Joint, VertexId};
use wirebend_error::{ErrorRemedy, InputName};
use wirebend_files::document::JobWire;
use wirebend_files::write::{LabelStep, Mark, PictureWire};

use super::ExportRequest;
use super::format::Chosen;
use super::print;
use crate::choices::PlanChoices;
use crate::job::Stages;
use crate::job::{is_job, open_job};
use crate::machine::{Setup, accepted_errors, kept_steps, restored, told_steps};
use crate::picture;
use crate::plan::{Planned, job_wire};
use crate::report::{NoteReport, PlanReport};
use crate::text;
use crate::{Installation, PlanningError, Progress};

pub(super) struct Wire {
    pub path: Vec<Point3<f64>>,
    pub nominal: Vec<Step>,
    pub compensated: Option<Vec<ToldStep>>,
    pub stock_mm: Option<f64>,
    pub time_s: Option<f64>,
    /// Segments of the path along edges that are travelled more than once.
    pub doubled: Vec<usize>,
    /// As a job has it; none where it is not compensated.
    pub kept: Option<JobWire>,
}

impl Wire {
    pub fn stages(&self) -> Stages<'_> {
        Stages {
            path: &self.path,
            nominal: &self.nominal,
            compensated: self.compensated.as_deref(),
            stock_mm: self.stock_mm,
            time_s: self.time_s,
        }
    }

    pub fn picture(&self) -> PictureWire {
        PictureWire { points: self.path.clone(), doubled: self.doubled.clone() }
    }

    /// What is written beside it.
    pub fn labels(&self) -> Vec<LabelStep> {
        let label = |step: &Step| LabelStep { feed_mm: step.feed.mm(), bend_deg: step.bend.deg() };
        self.nominal.iter().map(label).collect()
    }

    pub fn bend_count(&self) -> usize {
        self.nominal.iter().filter(|step| step.bend != Angle::ZERO).count()
    }
}

/// Everything that a format may hold.
pub(super) struct Content {
    pub title: String,
    pub setup: Setup,
    pub design_hash: String,
    /// Of a job that was planned before.
    pub job_hash: Option<String>,
    pub wires: Vec<Wire>,
    pub marks: Vec<Mark>,
    /// The joints of the design; none of a job, which is wire alone.
    pub joints: Vec<(VertexId, Joint)>,
    pub notes: Vec<NoteReport>,
    pub feasible: bool,
    /// What the checks say; a job was feasible, or its maker knew.
    pub report: Option<Box<PlanReport>>,
}

impl Content {
    pub fn open(
        app: &Installation,
        request: &ExportRequest,
        progress: &dyn Progress,
    ) -> Result<Self, PlanningError> {
        progress.stage("reading");
        let (name, bytes) = request.design.input.load()?;
        let title = request.design.input.stem();
        if is_job(&name, &bytes) {
            return Self::of_job(&name, &bytes, title, request);
        }
        let opened = request.design.open_bytes_with(app, &request.choices, name, &bytes)?;
        let opened = app.designed(opened, &request.choices)?.with_wireframe()?;
        let setup = app.setup_of(&opened, &request.choices)?;
        let setup = Self::as_set(app, setup, request)?;
        let planned = Installation::plan_with(opened, setup, &request.choices, progress)?;
        Self::of_plan(planned, title, print::unit(request)?)
    }

    /// What is set for the machine's driver changes what the machine can make.
    fn as_set(app: &Installation, setup: Setup, request: &ExportRequest) -> Result<Setup, PlanningError> {
        if request.settings.is_empty() {
            return Ok(setup);
        }
        let chosen = Chosen::new(app, request.format.as_deref(), &setup)?;
        let own = setup.machine.profile.driver.id.as_deref();
        let of_machine = chosen.driver_id().is_some() && chosen.driver_id() == own;
        if of_machine { app.setup_with(setup, &request.settings) } else { Ok(setup) }
    }

    fn of_plan(planned: Planned, title: String, unit: DisplayUnit) -> Result<Self, PlanningError> {
        let report = text::kept_in(unit, || planned.report());
        let wireframe = &planned.opened.document.wireframe;
        let wires = planned
            .wires
            .iter()
            .zip(&planned.pauses.wires)
            .map(|(plan, pauses)| Wire {
                // Without a route the edges themselves can be drawn, but nothing can be followed.
                path: plan.path.clone(),
                nominal: plan.nominal.as_ref().map(|program| program.steps.clone()).unwrap_or_default(),
                compensated: plan.compensated.as_ref().map(|program| program.told().collect()),
                stock_mm: plan.stock.map(Length::mm),
                time_s: plan.seconds,
                kept: job_wire(plan, pauses),
                doubled: plan.route.as_ref().map_or_else(Vec::new, |route| {
                    passed_twice(&route.traversals.iter().map(|t| t.edge).collect::<Vec<_>>())
                }),
            })
            .collect();
        let unrouted = planned.wires.iter().any(|plan| plan.route.is_none()) || planned.wires.is_empty();
        if unrouted || wireframe.edge_count() == 0 {
            return Err(PlanningError::StageNotReached {
                stage: crate::StageName::Route,
                report: Box::new(report),
            });
        }
        Ok(Self {
            title,
            job_hash: None,
            design_hash: planned.opened.document.design_hash()?,
            marks: picture::marks(&planned),
            joints: wireframe.vertices().filter_map(|(id, vertex)| Some((id, vertex.joint?))).collect(),
            notes: planned.opened.notes.clone(),
            feasible: planned.feasible(),
            report: Some(Box::new(report)),
            wires,
            setup: planned.setup,
        })
    }

    fn of_job(
        name: &str,
        bytes: &[u8],
        title: String,
        request: &ExportRequest,
    ) -> Result<Self, PlanningError> {
        let job = open_job(name, bytes)?;
        let contents = job.contents();
        if let Some(wanted) = request.choices.machine.as_ref().filter(|id| **id != contents.machine.id) {
            let planned = contents.machine.id.clone();
            return Err(PlanningError::OtherMachine {
                name: name.to_owned(),
                planned,
                wanted: wanted.clone(),
            });
        }
        let PlanChoices {
            machine: _,
            material,
            double,
            detours,
            wires,
            closed,
            start,
            reverse,
            keep_order,
            collisions,
            avoid_collisions,
            search_effort,
            search_seed,
            search_weights,
            sag,
            collision_margin_mm,
        } = &request.choices;
        let other_material = material.as_ref().is_some_and(|id| *id != contents.material.id);
        let searches =
            *avoid_collisions || search_effort.is_some() || search_seed.is_some() || search_weights.is_some();
        let given = [
            (InputName::Format, request.design.format.is_some()),
            (InputName::Material, other_material),
            (InputName::Double, *double),
            (InputName::Detours, *detours),
            (InputName::Wires, wires.is_some()),
            (InputName::Closed, *closed),
            (InputName::Start, start.is_some()),
            (InputName::Reverse, *reverse),
            (InputName::KeepOrder, *keep_order),
            (InputName::Collisions, *collisions),
            (InputName::AvoidCollisions, searches),
            (InputName::Clearance, collision_margin_mm.is_some()),
            (InputName::Sag, *sag),
        ];
        let given = given.into_iter().filter_map(|(input, given)| given.then_some(input));
        let inputs: Vec<InputName> = given.chain(request.design.read_otherwise()).collect();
        if !inputs.is_empty() || !request.design.reads_plainly() {
            let instead = Box::new(ErrorRemedy::PlanAgain);
            return Err(PlanningError::Settled { name: name.to_owned(), inputs, instead });
        }
        let wires = contents.wires.iter().map(|wire| {
            let ends = wire.vertices.windows(2).map(|pair| (pair[0].min(pair[1]), pair[0].max(pair[1])));
            Ok(Wire {
                path: wire.path_mm.iter().copied().map(Point3::from).collect(),
                nominal: kept_steps(&wire.nominal)?,
                compensated: Some(told_steps(&wire.compensated)?),
                stock_mm: Some(wire.stock_mm),
                time_s: Some(wire.time_s),
                kept: Some(wire.clone()),
                doubled: passed_twice(&ends.collect::<Vec<_>>()),
            })
        });
        Ok(Self {
            title,
            job_hash: Some(job.hash().to_owned()),
            setup: restored(name, contents)?,
            design_hash: contents.design_hash.clone(),
            wires: wires.collect::<Result<_, PlanningError>>()?,
            marks: Vec::new(),
            joints: Vec::new(),
            notes: accepted_errors(contents),
            feasible: contents.objections.is_empty(),
            report: None,
        })
    }

    /// Refuses what cannot be made, unless a person has said that they want it. A program of the machine's
    /// own has to be compensated whatever a person says.
    pub fn require_feasible(&self, despite_errors: bool, own: bool) -> Result<(), PlanningError> {
        match &self.report {
            Some(report) if own && self.wires.iter().any(|wire| wire.compensated.is_none()) => {
                Err(PlanningError::StageNotReached {
                    stage: crate::StageName::Compensated,
                    report: report.clone(),
                })
            }
            Some(report) if !self.feasible && !despite_errors => {
                let machine = self.setup.machine_id().to_owned();
                Err(PlanningError::NotFeasible { machine, report: report.clone() })
            }
            _ => Ok(()),
        }
    }
}

/// The places in a walk that are along something that it passes more than once.
fn passed_twice<T: Ord>(walk: &[T]) -> Vec<usize> {
    let mut times: BTreeMap<&T, usize> = BTreeMap::new();
    for passed in walk {
        *times.entry(passed).or_default() += 1;
    }
    walk.iter().enumerate().filter(|(_, passed)| times[passed] > 1).map(|(k, _)| k).collect()
}
