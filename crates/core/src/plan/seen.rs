//! What the checks see of a wire.

use super::head::sent_beyond;
use super::{Machine, WirePlan};
use crate::checks::{Diagnostic, WireStages, check_wire};
use crate::compensate::{BendError, CompensatedProgram, StepError};
use crate::units::Angle;
use crate::wireframe::Wireframe;

/// What checks see of a plan, which does not say why a stage was left out.
pub(super) fn stages_of<'a>(
    wireframe: &'a Wireframe,
    machine: &'a Machine,
    plan: &'a WirePlan,
) -> WireStages<'a> {
    WireStages {
        wireframe,
        component: &plan.component,
        doubled: &plan.doubled,
        odd_allowed: 0,
        proposal: None,
        forced: &[],
        passed_again: &[],
        route: plan.route.as_ref(),
        nominal: plan.nominal.as_ref(),
        scheduled: plan.scheduled.as_ref(),
        rotation: None,
        compensated: plan.compensated.as_ref(),
        unbendable: &[],
        searched: plan.searched.is_some(),
        sag: plan.sag.map(|sag| sag.largest),
        contacts: plan.contacts.as_deref().unwrap_or_default(),
        bodies: &machine.bodies.all,
        compensation: &machine.compensation,
        diameter: machine.wire.diameter,
        bend_radius: machine.bend_radius,
        straight: machine.straight,
        scatter: machine.scatter.as_ref(),
        limits: &machine.limits,
    }
}

/// Everything worth saying about a wire whose stages are given: its walk stays as it is, and no other one is proposed. Most severe
/// first.
#[must_use]
pub fn check_given(wireframe: &Wireframe, machine: &Machine, plan: &WirePlan) -> Vec<Diagnostic> {
    // A program of another, as a text or a table has it, is held against what the axes can do as it stands.
    let rounding = Angle::computed(WRITTEN_DEG.to_radians());
    let told = plan.compensated.as_ref();
    let rotation = told.and_then(|program| sent_beyond(program, machine, rounding));
    let unbendable: Vec<StepError> =
        told.map_or_else(Vec::new, |program| beyond_the_axis(program, machine, plan, rounding));
    let mut found = check_wire(&WireStages {
        odd_allowed: usize::MAX,
        rotation: rotation.as_ref(),
        unbendable: &unbendable,
        ..stages_of(wireframe, machine, plan)
    });
    found.sort_by_key(|diagnostic| diagnostic.severity);
    found
}

/// What figures of programs are rounded by, degrees, many of them together.
const WRITTEN_DEG: f64 = 0.01;

/// The bends that are sent farther than the bend axis goes.
fn beyond_the_axis(
    program: &CompensatedProgram,
    machine: &Machine,
    plan: &WirePlan,
    rounding: Angle,
) -> Vec<StepError> {
    let model = &machine.compensation.bend;
    let (Some(limit), Some(made)) = (model.axis_limit, &plan.scheduled) else { return Vec::new() };
    let steps = program.steps().iter().zip(&made.steps).enumerate();
    let beyond = steps.filter(|(_, (told, _))| told.bend.abs() > limit + rounding);
    let error = |bend| BendError::OutOfReach { bend, max: model.max_bend(bend) };
    beyond.map(|(step, (_, made))| StepError { step, error: error(made.bend) }).collect()
}
