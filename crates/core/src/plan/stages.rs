//! The stages after the route.

use super::contacts::{self, ContactOptions};
use super::head::commanded_beyond;
use super::seen::stages_of;
use super::{Machine, Stage, WirePlan};
use crate::bend::{NominalProgram, PathError, program_of_path};
use crate::checks::{Diagnostic, Fact, Location, Remedy, Severity, WireStages, check_wire};
use crate::compensate::{StepError, compensate};
use crate::estimate::stock;
use crate::route::ForcedBend;
use crate::schedule::{HeadLimits, RotationOutOfRange, ScheduledProgram, schedule};
use crate::units::Angle;
use crate::wireframe::{EdgeId, Wireframe};

/// What the stages of all wires of a component have in common.
pub(super) struct Stages<'a> {
    pub wireframe: &'a Wireframe,
    pub machine: &'a Machine,
    /// Whether to look for contacts.
    pub contacts: bool,
    pub contact_options: ContactOptions,
    /// Whether wires that meet nothing were searched for.
    pub searched: bool,
    pub odd_allowed: usize,
    pub forced: &'a [ForcedBend],
    /// For each wire the edges of [`WireStages::passed_again`].
    pub passed_again: Vec<Vec<(EdgeId, usize)>>,
}

impl Stages<'_> {
    /// Takes a wire, by its index, from its route, if it has one, through all other stages.
    pub fn run(
        &self,
        index: usize,
        plan: &mut WirePlan,
        already: Vec<Diagnostic>,
        done: &mut dyn FnMut(Stage),
    ) {
        let Self { wireframe, machine, .. } = *self;
        let mut failures = Failures::default();
        run_stages(wireframe, machine, plan, &mut failures, done);
        plan.contact_options = self.contact_options;
        if self.contact_options.sag {
            plan.sag = contacts::sag(wireframe, machine, plan);
        }
        if self.contacts {
            plan.contacts = contacts::find(wireframe, machine, plan);
            done(Stage::Contacts);
        }
        plan.diagnostics = check_wire(&WireStages {
            odd_allowed: self.odd_allowed,
            proposal: Some(&plan.proposal).filter(|proposal| !proposal.edges.is_empty()),
            forced: self.forced,
            passed_again: self.passed_again.get(index).map_or(&[], Vec::as_slice),
            rotation: failures.rotation.as_ref(),
            unbendable: &failures.unbendable,
            searched: self.searched,
            ..stages_of(wireframe, machine, plan)
        });
        plan.diagnostics.extend(already);
        plan.diagnostics.extend(failures.path.map(|error| path_failure(plan, error)));
        plan.diagnostics.sort_by_key(|diagnostic| diagnostic.severity);
        done(Stage::Check);
    }
}

/// The fastest way to run a program on a machine: what is planned where nobody chooses sides and windings.
///
/// # Errors
/// [`RotationOutOfRange`] where the head cannot turn far enough.
pub fn fastest_schedule(
    machine: &Machine,
    nominal: &NominalProgram,
) -> Result<ScheduledProgram, RotationOutOfRange> {
    let within = |limits: HeadLimits| schedule(nominal, &limits, |bend| bend_seconds(machine, bend));
    let first = within(machine.head)?;
    if machine.compensation.motion.is_exact() {
        return Ok(first);
    }
    let (mut limits, mut found) = (machine.head, first.clone());
    // A head that is off is sent farther than it is to come: where that is too far it is to come less far.
    for _ in 0..MAX_NARROWED {
        let sent = compensate(&found, &machine.compensation).ok();
        let Some(beyond) = sent.and_then(|program| commanded_beyond(&program, machine)) else {
            return Ok(found);
        };
        if beyond.wanted > machine.head.max {
            limits.max = (limits.max - (beyond.wanted - machine.head.max)).max(Angle::ZERO);
        } else {
            limits.min = (limits.min + (machine.head.min - beyond.wanted)).min(Angle::ZERO);
        }
        let Ok(narrower) = within(limits) else { break };
        found = narrower;
    }
    Ok(first)
}

/// So often a schedule is looked for that keeps what the head is sent to within its limits.
const MAX_NARROWED: usize = 6;

/// How long a bend takes, s; none where it cannot be made.
pub(super) fn bend_seconds(machine: &Machine, bend: Angle) -> Option<f64> {
    let limits = &machine.limits;
    let within = bend >= limits.min_bend.value && bend <= limits.max_bend.value;
    let command = machine.compensation.bend.command(bend).ok().filter(|_| within)?;
    let before_zero = command.signum() * bend.signum() < 0.0;
    Some(machine.time.bend_seconds(if before_zero { Angle::ZERO } else { command }))
}

#[derive(Default)]
struct Failures {
    path: Option<PathError>,
    rotation: Option<RotationOutOfRange>,
    unbendable: Vec<StepError>,
}

/// From the route to the compensated program, as far as it goes.
fn run_stages(
    wireframe: &Wireframe,
    machine: &Machine,
    plan: &mut WirePlan,
    failures: &mut Failures,
    done: &mut dyn FnMut(Stage),
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
    let scheduled = match plan.scheduled.take() {
        Some(searched) => Ok(searched),
        None => fastest_schedule(machine, &nominal),
    };
    plan.nominal = Some(nominal);
    done(Stage::Schedule);
    match scheduled {
        Err(error) => failures.rotation = Some(error),
        Ok(scheduled) => {
            match compensate(&scheduled, &machine.compensation) {
                Ok(program) => {
                    failures.unbendable = program.unpressed().to_vec();
                    failures.rotation = commanded_beyond(&program, machine);
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
