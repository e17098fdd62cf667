//! `sequence`: the order in which a machine builds the struts of a design, or whether one that is given can be built.

mod builder;
mod drawn;
mod findings;
mod given;
mod report;
mod write;

use std::ops::ControlFlow;
use std::time::{Duration, Instant};

use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::Deserialize;
use wirebend_core::checks::{Diagnostic, check_crossings};
use wirebend_core::units::Length;
use wirebend_core::wireframe::EdgeId;
use wirebend_error::InputName;
use wirebend_frame::STANDARD_GRAVITY;
use wirebend_sequence::{
    GivenStep, Groups, LayerOptions, Outcome, Progress as SearchProgress, SearchOptions, Structure, Task,
    Weight,
};

use crate::choices::PlanChoices;
use crate::design::{DesignInput, Input, Opened, default_weld};
use crate::frame::{FrameSupports, doubled_struts, unused_supports};
use crate::{Installation, Output, PlanningError, Progress};
use builder::BuilderSetup;
use drawn::Drawing;
pub use drawn::{DrawnSequence, HeadMove, OrderedStep, drawn_sequence};
pub use report::{
    ObstacleReport, ObstacleRuleName, PartialReport, SequenceJoint, SequenceResponse, SequenceStepReport,
    StepTypeName, StrategyName,
};

pub use write::SequenceFormat;

/// So long is searched where nobody says, s.
const LIMIT_S: f64 = 120.0;

#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct SequenceRequest {
    pub design: DesignInput,
    /// The machine that builds the struts: the id of a strut builder.
    pub machine: String,
    /// What the struts are made of; absent, what the design says, else what the machine's profile names.
    pub material: Option<String>,
    /// What stands on the ground.
    #[serde(default)]
    pub supports: FrameSupports,
    /// How far a joint may be from where it is drawn, mm; absent, the radius of a strut less the machine's position tolerance.
    #[schemars(range(min = 0.0))]
    pub epsilon_mm: Option<f64>,
    /// A sequence to check, in place of a search: what this command wrote, or a file of `FrameFab`.
    pub check: Option<Input>,
    /// Whether to cut the frame into layers, too.
    #[serde(default)]
    pub layers: bool,
    /// What is placed at once.
    #[serde(default)]
    pub group_by: GroupBy,
    /// What makes one order better than another.
    #[serde(default)]
    pub cost: CostName,
    /// How long is searched, s; absent, 120.
    #[schemars(range(min = 0.0))]
    pub limit_s: Option<f64>,
    /// Where the chance of the search begins; absent, 1. The same seed finds the same.
    pub seed: Option<u64>,
    /// Where the sequence goes.
    pub output: Option<Output>,
    /// What it is written as.
    #[serde(default)]
    pub format: SequenceFormat,
}

/// What is placed at once.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum GroupBy {
    /// A strut.
    #[default]
    Edge,
    /// All struts of a wire, along the walks that the design has chosen for its wires.
    Wire,
}

/// What makes one order better than another.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum CostName {
    /// The first that is found, with struts that share a vertex after each other.
    #[default]
    Sharing,
    /// That of `FrameFab`, layer by layer.
    Paper,
}

pub fn sequence(
    app: &Installation,
    request: &SequenceRequest,
    progress: &dyn Progress,
) -> Result<SequenceResponse, PlanningError> {
    Ok(run(app, request, None, progress)?.0)
}

/// Finds a sequence, or checks one: that of the request, or an order of a person.
fn run(
    app: &Installation,
    request: &SequenceRequest,
    order: Option<&[OrderedStep]>,
    progress: &dyn Progress,
) -> Result<(SequenceResponse, Drawing), PlanningError> {
    if let Some(output) = &request.output {
        output.check()?;
        write::check(request.format, order.is_some() || request.check.is_some())?;
    }
    let limit = seconds(request.limit_s)?;
    let started = Instant::now();
    let mut opened = request.design.open(progress)?.with_wireframe()?;
    opened.require_designed()?;
    opened.document.wireframe = request.supports.hold(&opened)?;
    let setup = BuilderSetup::new(app, &opened, request)?;
    cost_fits(request.cost, setup.builder.places)?;
    let mut answer = report::Answer::new(&opened, &setup);
    answer.took("read", started);
    let mut drawing = Drawing::new(&setup);
    let wireframe = &opened.document.wireframe;
    answer.notes(unused_supports(wireframe, &FrameSupports::Design.vertices(&opened)?));
    answer.notes(doubled_struts(wireframe));
    let structure = match Structure::new(wireframe) {
        Ok(structure) => structure,
        Err(error) => return Ok((answer.refused(&findings::no_structure(&opened, &error)), drawing)),
    };
    let diameter = Length::from_mm(2.0 * setup.section.radius).unwrap_or_default();
    let crossings = check_crossings(wireframe, diameter, default_weld());
    if !crossings.is_empty() {
        return Ok((answer.refused(&crossings), drawing));
    }
    let groups = groups(&opened, &structure, request.group_by)?;
    let weight = Weight { section: setup.section, gravity: Vector3::new(0.0, 0.0, -STANDARD_GRAVITY) };
    let task = Task { structure: &structure, groups: &groups, builder: &setup.builder, weight: &weight };
    let no_frame = |error: wirebend_frame::ModelError| PlanningError::NoFrame {
        name: opened.name.clone(),
        reason: error.to_string(),
    };
    let searched = order.is_none() && request.check.is_none();
    if searched && let Some(obstacle) = wirebend_sequence::whole_frame(&task).map_err(no_frame)? {
        return Ok((answer.found(&task, &Outcome::impossible(obstacle), Vec::new()), drawing));
    }
    let layers = if request.layers || request.cost == CostName::Paper {
        progress.stage("cutting layers");
        let since = Instant::now();
        let ceilings: Vec<EdgeId> =
            wireframe.edges().filter(|(_, edge)| edge.ceiling).map(|(id, _)| id).collect();
        let layers =
            wirebend_sequence::layers(&task, &ceilings, &LayerOptions::default()).map_err(no_frame)?;
        answer.took("layers", since);
        Some(layers)
    } else {
        None
    };
    if request.layers {
        answer.layers(&structure, layers.as_deref().unwrap_or_default());
    }
    let given = request.check.as_ref().filter(|_| order.is_none());
    let given = given.map(|input| given::read(input, &opened)).transpose()?;
    if order.is_some() || given.is_some() {
        progress.stage("checking the sequence");
        let since = Instant::now();
        let (given, checked) = match (order, given) {
            (Some(order), _) => drawn::check_ordered(order, &task),
            (None, given) => {
                let given = given.unwrap_or_default();
                let checked = wirebend_sequence::check(&task, &given);
                (given, checked)
            }
        };
        answer.took("check", since);
        let given = given::with_free_foremost(given, &checked);
        let mut response = answer.checked(&task, &given, &checked);
        if let Some(output) = request.output.as_ref().filter(|_| response.feasible) {
            let text = write::text(request.format, &response, None, &opened, &setup.material)?;
            response.files.push(output.save(text.as_bytes())?);
            response.notes.extend(request.format.kind().misnamed(Some(output)));
        }
        drawing.moves(&structure, &response, None);
        return Ok((response, drawing));
    }
    let since = Instant::now();
    let until = since.checked_add(limit).ok_or_else(|| no_limit(limit.as_secs_f64()))?;
    let mut watch = Watch { progress, until, named: false };
    let outcome = if let (CostName::Paper, Some(layers)) = (request.cost, layers) {
        let backtracks = SearchOptions::default().backtracks;
        wirebend_sequence::search_by_paper(&task, &layers, backtracks, &mut |told| watch.hear(told))
    } else {
        let options = SearchOptions { seed: request.seed.unwrap_or(1), ..SearchOptions::default() };
        wirebend_sequence::search(&task, &options, &mut |told| watch.hear(told))
    };
    let outcome = outcome.map_err(no_frame)?;
    answer.took("search", since);
    let since = Instant::now();
    let refused = rechecked(&task, &outcome, progress);
    answer.took("check", since);
    let mut response = answer.found(&task, &outcome, refused);
    if let Some(output) = request.output.as_ref().filter(|_| response.feasible) {
        let text = write::text(request.format, &response, Some((&task, &outcome)), &opened, &setup.material)?;
        response.files.push(output.save(text.as_bytes())?);
        response.notes.extend(request.format.kind().misnamed(Some(output)));
    }
    drawing.moves(&structure, &response, Some(&outcome));
    Ok((response, drawing))
}

/// What an independent check says of a sequence that was found.
fn rechecked(task: &Task<'_>, outcome: &Outcome, progress: &dyn Progress) -> Vec<Diagnostic> {
    if !outcome.is_found() {
        return Vec::new();
    }
    progress.stage("checking the sequence");
    let given: Vec<GivenStep> =
        outcome.steps.iter().map(|step| GivenStep::of(step, task.structure, task.builder)).collect();
    wirebend_sequence::check(task, &given).violations.iter().map(findings::violation).collect()
}

/// Whether a cost is one of what is built: that of `FrameFab` is one of struts that are drawn.
fn cost_fits(cost: CostName, places: bool) -> Result<(), PlanningError> {
    if !places || cost != CostName::Paper {
        return Ok(());
    }
    Err(PlanningError::Value {
        input: None,
        name: "cost",
        value: "paper".to_owned(),
        expected: "sharing: the cost of FrameFab is that of single struts that are drawn, and not placed",
    })
}

/// Groups by what the design says of its wires.
fn groups(opened: &Opened, structure: &Structure, by: GroupBy) -> Result<Groups, PlanningError> {
    if by == GroupBy::Edge {
        return Ok(Groups::single(structure));
    }
    let walks = &opened.document.walks;
    if walks.is_empty() {
        return Err(PlanningError::NoWalks { name: opened.name.clone() });
    }
    let wires: Vec<Vec<EdgeId>> = walks.iter().map(|walk| walk.edges.clone()).collect();
    Groups::together(structure, &wires)
        .map_err(|error| PlanningError::NoFrame { name: opened.name.clone(), reason: error.to_string() })
}

fn seconds(limit: Option<f64>) -> Result<Duration, PlanningError> {
    let limit = limit.unwrap_or(LIMIT_S);
    let seconds = Duration::try_from_secs_f64(limit).ok();
    // So far off a clock may not count.
    seconds.filter(|seconds| Instant::now().checked_add(*seconds).is_some()).ok_or_else(|| no_limit(limit))
}

fn no_limit(limit: f64) -> PlanningError {
    PlanningError::Value {
        input: Some(InputName::TimeLimit),
        name: InputName::TimeLimit.words(),
        value: limit.to_string(),
        expected: "seconds, 0 or more, and no more than a clock can count",
    }
}

/// Tells a front end how far a search is, and ends it when time is up or a person has had enough.
struct Watch<'a> {
    progress: &'a dyn Progress,
    until: Instant,
    named: bool,
}

impl Watch<'_> {
    fn hear(&mut self, told: &SearchProgress) -> ControlFlow<()> {
        if !std::mem::replace(&mut self.named, true) {
            self.progress.search("looking for a sequence");
        }
        self.progress.advance(told.taken as u64, told.of as u64);
        if self.progress.goes_on() && Instant::now() < self.until {
            ControlFlow::Continue(())
        } else {
            ControlFlow::Break(())
        }
    }
}

/// The choices by which the material of a frame is found.
fn material_choices(request: &SequenceRequest) -> PlanChoices {
    PlanChoices { material: request.material.clone(), ..PlanChoices::default() }
}
