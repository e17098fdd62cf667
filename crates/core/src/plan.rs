//! The whole pipeline for one wire: every stage in order, as far as it gets, and what the checks say.

use nalgebra::Point3;

use crate::bend::{Frame, NominalProgram, PathError, program_of_path};
use crate::checks::{
    Diagnostic, Fact, Location, MachineLimits, Remedy, Severity, Sourced, WireStages, check_wire,
};
use crate::compensate::{CompensatedProgram, Compensation, StepError, compensate};
use crate::estimate::{TimeModel, WireModel, stock};
use crate::route::{Doubling, Route, RouteError, RouteOptions, doubling, route};
use crate::schedule::{HeadLimits, RotationOutOfRange, ScheduledProgram, schedule};
use crate::units::{Angle, Length};
use crate::wireframe::{Component, EdgeId, VertexId, Wireframe};

/// A machine with a wire in it: everything that the stages ask about.
#[derive(Debug, Clone, PartialEq)]
pub struct Machine {
    /// What it can do.
    pub limits: MachineLimits,
    /// What its head can do.
    pub head: HeadLimits,
    /// How its feeds and bends are compensated for.
    pub compensation: Compensation,
    /// How fast it is.
    pub time: TimeModel,
    /// The wire.
    pub wire: WireModel,
    /// Centreline radius of its bends.
    pub bend_radius: Length,
    /// A change of direction up to this is not bent: half of what the bend axis resolves.
    pub straight: Angle,
    /// How far its bends scatter (one standard deviation), where that is known.
    pub scatter: Option<Sourced<Angle>>,
}

/// Which edges are travelled twice.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum DoublingChoice {
    /// Those that a person has accepted.
    Accepted(Vec<EdgeId>),
    /// The cheapest that make a route possible.
    Cheapest,
}

impl Default for DoublingChoice {
    /// Every edge once.
    fn default() -> Self {
        Self::Accepted(Vec::new())
    }
}

/// What a person may choose of a plan.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct PlanOptions {
    /// Which edges are travelled twice.
    pub doubling: DoublingChoice,
    /// Whether the wire must end where it starts.
    pub closed: bool,
    /// Where the wire starts.
    pub start: Option<VertexId>,
    /// Whether the wire runs the other way: it ends where it would have started.
    pub reversed: bool,
    /// The walk, where it is settled: no other is looked for, and no edge is doubled but those that it passes again.
    pub settled: Option<Route>,
}

/// A stage of the pipeline that has been done.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stage {
    /// Which edges to travel twice.
    Doubling,
    /// The walk along every edge.
    Route,
    /// The nominal program.
    Program,
    /// Signs and windings.
    Schedule,
    /// What the machine is told.
    Compensate,
    /// What cannot be made.
    Check,
}

/// One wire through all stages, as far as it got.
#[derive(Debug, Clone, PartialEq)]
pub struct WirePlan {
    /// The component that it covers.
    pub component: Component,
    /// Edges that are travelled twice.
    pub doubled: Vec<EdgeId>,
    /// The cheapest doubling for these options, whether or not it was applied.
    pub proposal: Doubling,
    /// The route.
    pub route: Option<Route>,
    /// The positions of the route's vertices, in mm.
    pub path: Vec<Point3<f64>>,
    /// The frame in which the nominal program starts.
    pub start: Frame,
    /// The nominal program.
    pub nominal: Option<NominalProgram>,
    /// The schedule.
    pub scheduled: Option<ScheduledProgram>,
    /// The compensated program.
    pub compensated: Option<CompensatedProgram>,
    /// What the checks say, doublings and refusals included.
    pub diagnostics: Vec<Diagnostic>,
    /// Seconds on the machine.
    pub seconds: Option<f64>,
    /// Stock to load.
    pub stock: Option<Length>,
}

impl WirePlan {
    /// What the doubled edges add to the wire.
    #[must_use]
    pub fn doubled_length(&self, wireframe: &Wireframe) -> Length {
        self.doubled.iter().map(|&edge| wireframe.edge_length(edge)).sum()
    }

    /// Whether the machine can make it: it has been compensated and no check objects.
    #[must_use]
    pub fn is_feasible(&self) -> bool {
        self.compensated.is_some() && !self.diagnostics.iter().any(Diagnostic::is_error)
    }
}

/// Plans the wire of one component. Whatever stands in the way of a stage becomes a diagnostic, and
/// the stages after it are left out. `done` is told of each stage that has been done.
pub fn plan_wire(
    wireframe: &Wireframe,
    component: &Component,
    machine: &Machine,
    options: &PlanOptions,
    mut done: impl FnMut(Stage),
) -> WirePlan {
    let mut refusals = Vec::new();
    let proposal = match &options.settled {
        Some(_) => Ok(Doubling::default()),
        None => doubling(wireframe, component, options.start, options.closed),
    };
    let proposal = match proposal {
        Ok(proposal) => proposal,
        Err(error) => {
            refusals.push(refusal(error, None));
            Doubling::default()
        }
    };
    let doubled = match &options.doubling {
        _ if options.settled.is_some() => again(options.settled.as_ref()),
        DoublingChoice::Accepted(edges) => edges.clone(),
        DoublingChoice::Cheapest => proposal.edges.clone(),
    };
    done(Stage::Doubling);
    let mut plan = WirePlan {
        component: component.clone(),
        doubled,
        proposal,
        route: None,
        path: Vec::new(),
        start: Frame::default(),
        nominal: None,
        scheduled: None,
        compensated: None,
        diagnostics: Vec::new(),
        seconds: None,
        stock: None,
    };
    let mut failures = Failures::default();
    if refusals.is_empty() {
        match find_route(wireframe, &plan, machine, options) {
            Ok(found) => plan.route = Some(found),
            // The check of odd vertices says it with the cheapest way out.
            Err(RouteError::Odd { .. }) => {}
            Err(error) => {
                let proposal = Some(&plan.proposal).filter(|proposal| !proposal.edges.is_empty());
                let doubling = proposal.map(|proposal| Remedy::double(proposal, wireframe, component));
                refusals.push(refusal(error, doubling));
            }
        }
    }
    done(Stage::Route);
    run_stages(wireframe, machine, &mut plan, &mut failures, &mut done);
    plan.diagnostics = check_wire(&WireStages {
        wireframe,
        component,
        doubled: &plan.doubled,
        closed: options.closed,
        proposal: Some(&plan.proposal).filter(|proposal| !proposal.edges.is_empty()),
        route: plan.route.as_ref(),
        nominal: plan.nominal.as_ref(),
        scheduled: plan.scheduled.as_ref(),
        rotation: failures.rotation.as_ref(),
        compensated: plan.compensated.as_ref(),
        unbendable: &failures.unbendable,
        compensation: &machine.compensation,
        diameter: machine.wire.diameter,
        bend_radius: machine.bend_radius,
        straight: machine.straight,
        scatter: machine.scatter.as_ref(),
        limits: &machine.limits,
    });
    plan.diagnostics.extend(refusals);
    plan.diagnostics.extend(failures.path.map(|error| path_failure(&plan, error)));
    plan.diagnostics.sort_by_key(|diagnostic| diagnostic.severity);
    done(Stage::Check);
    plan
}

/// The edges that a walk passes once more.
fn again(walk: Option<&Route>) -> Vec<EdgeId> {
    let traversals = walk.into_iter().flat_map(|walk| &walk.traversals);
    traversals.filter(|traversal| traversal.again).map(|traversal| traversal.edge).collect()
}

#[derive(Default)]
struct Failures {
    path: Option<PathError>,
    rotation: Option<RotationOutOfRange>,
    unbendable: Vec<StepError>,
}

fn find_route(
    wireframe: &Wireframe,
    plan: &WirePlan,
    machine: &Machine,
    options: &PlanOptions,
) -> Result<Route, RouteError> {
    let limits = &machine.limits;
    let found = match &options.settled {
        Some(settled) => settled.clone(),
        None => route(
            wireframe,
            &plan.component,
            &RouteOptions {
                doubled: plan.doubled.clone(),
                start: options.start,
                closed: options.closed,
                max_bend: Some(limits.max_bend.value.max(-limits.min_bend.value)),
            },
        )?,
    };
    Ok(if options.reversed { found.reversed() } else { found })
}

/// From the route to the compensated program, as far as it goes.
fn run_stages(
    wireframe: &Wireframe,
    machine: &Machine,
    plan: &mut WirePlan,
    failures: &mut Failures,
    done: &mut impl FnMut(Stage),
) {
    let Some(route) = &plan.route else { return };
    let position = |vertex| wireframe.vertex(vertex).map(|vertex| vertex.position);
    plan.path = route.vertices().into_iter().filter_map(position).collect();
    let (start, nominal) = match program_of_path(&plan.path, machine.straight) {
        Ok(made) => made,
        Err(error) => {
            failures.path = Some(error);
            return;
        }
    };
    plan.start = start;
    done(Stage::Program);
    let limits = &machine.limits;
    let bend_seconds = |bend: Angle| {
        let within = bend >= limits.min_bend.value && bend <= limits.max_bend.value;
        let command = machine.compensation.bend.command(bend).ok().filter(|_| within)?;
        Some(machine.time.bend_seconds(command))
    };
    let scheduled = schedule(&nominal, &machine.head, bend_seconds);
    plan.nominal = Some(nominal);
    done(Stage::Schedule);
    match scheduled {
        Err(error) => failures.rotation = Some(error),
        Ok(scheduled) => {
            match compensate(&scheduled, &machine.compensation) {
                Ok(program) => {
                    plan.seconds = Some(machine.time.seconds(&program));
                    plan.stock = Some(stock(&program, limits.tail.value));
                    plan.compensated = Some(program);
                }
                Err(errors) => failures.unbendable = errors,
            }
            plan.scheduled = Some(scheduled);
        }
    }
    done(Stage::Compensate);
}

/// The finding of a route that cannot be had.
fn refusal(error: RouteError, doubling: Option<Remedy>) -> Diagnostic {
    let location = match &error {
        RouteError::Start { start, .. } | RouteError::StartElsewhere(start) => {
            Location::at_vertices([*start])
        }
        RouteError::DoubledElsewhere(edge) => Location::at_edges([*edge]),
        RouteError::Odd { odd, .. } => Location::at_vertices(odd.iter().copied()),
        RouteError::NoEdges | RouteError::TooLong => Location::default(),
        RouteError::TooManyEnds { vertex, .. } => Location::at_vertices([*vertex]),
    };
    let mut remedies = match error {
        RouteError::TooLong | RouteError::TooManyEnds { .. } => vec![Remedy::SplitDesign],
        RouteError::NoEdges => vec![Remedy::DrawEdges],
        RouteError::Start { .. }
        | RouteError::StartElsewhere(_)
        | RouteError::DoubledElsewhere(_)
        | RouteError::Odd { .. } => vec![Remedy::ChooseStart, Remedy::LeaveStartOpen],
    };
    // A start that no walk has is possible once the proposed edges are doubled.
    remedies.extend(doubling.filter(|_| matches!(error, RouteError::Start { .. })));
    Diagnostic { severity: Severity::Error, location, fact: Fact::RouteRefused(error), remedies }
}

/// The finding of a route with a segment without length. The check of the design names the edge by its vertices too.
fn path_failure(plan: &WirePlan, error: PathError) -> Diagnostic {
    let traversal = match error {
        PathError::NoDirection(k) => plan.route.as_ref().and_then(|route| route.traversals.get(k)),
        PathError::TooShort(_) => None,
    };
    Diagnostic {
        severity: Severity::Error,
        location: Location::at_edges(traversal.map(|t| t.edge)),
        fact: Fact::NoPath(error),
        remedies: vec![Remedy::DeleteEdge, Remedy::MergeVertices],
    }
}
