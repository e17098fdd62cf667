//! Bends that the machine cannot make, for every pair of edges that the route makes neighbours.

use super::{BendOf, Diagnostic, Fact, ROUNDING, ReachLimit, Remedy, Severity, Sourced, WireStages, is_near};
use crate::compensate::{BendError, BendModel, with_bend_before};
use crate::units::Angle;
use crate::wireframe::VertexId;

pub(super) fn check(wire: &WireStages, found: &mut Vec<Diagnostic>) {
    // The schedule knows to which side each bend goes; before it, the wider side counts.
    let nominal = wire.nominal.into_iter().flat_map(|program| &program.steps);
    let bends: Vec<Angle> = match wire.scheduled {
        Some(scheduled) => scheduled.steps.iter().map(|step| step.bend).collect(),
        None => nominal.map(|step| step.bend).collect(),
    };
    for (step, &bend) in bends.iter().enumerate().filter(|(_, bend)| **bend != Angle::ZERO) {
        let (min, max) = (&wire.limits.min_bend, &wire.limits.max_bend);
        let negative = match wire.scheduled {
            Some(_) => bend < Angle::ZERO,
            None => min.value.abs() > max.value,
        };
        let limit = if negative { min } else { max };
        // A fold back has a check of its own.
        if bend.abs() == Angle::HALF_TURN {
            continue;
        }
        let room = (limit.value.abs() - bend.abs()).deg();
        let location = wire.location_of_step(step);
        let (severity, fact) = if room < -ROUNDING {
            let of = of_step(wire, location.vertices.first().copied());
            (Severity::Error, Fact::BendTooSharp { bend, of, limit: limit.clone() })
        } else if is_near(room.max(0.0), limit.value.deg()) {
            (Severity::Warning, Fact::BendNearLimit { bend, limit: limit.clone() })
        } else {
            continue;
        };
        let around = match (severity, location.vertices.first()) {
            (Severity::Error, Some(&vertex)) => Remedy::around(wire, vertex),
            _ => Remedy::start_of_closed(wire).into_iter().collect(),
        };
        let remedies = [Remedy::OpenAngle].into_iter().chain(around).collect();
        found.push(Diagnostic { severity, location, fact, remedies });
    }
    unreachable(wire, found);
}

/// Bends within the machine's limits that its axis still cannot reach with this wire.
fn unreachable(wire: &WireStages, found: &mut Vec<Diagnostic>) {
    for failed in wire.unbendable {
        let (bend, fact, remedies) = match failed.error {
            BendError::OutOfReach { bend, max } => {
                let reach = reach_limit(wire, bend);
                let vertex = wire.vertex_of_step(failed.step);
                let fact = Fact::BendOutOfReach { bend, of: of_step(wire, vertex), max, reach };
                let forced =
                    vertex.filter(|_| matches!(fact, Fact::BendOutOfReach { of: BendOf::Forced, .. }));
                let around = forced.map_or_else(Vec::new, |vertex| Remedy::around(wire, vertex));
                (bend, fact, [Remedy::KeepBendBelow { max }].into_iter().chain(around).collect())
            }
            BendError::TooSmall { bend } => {
                (bend, Fact::BendTooSmall { bend }, vec![Remedy::EnlargeBend, Remedy::Straighten])
            }
            // What is too short is told more clearly by the check of feeds.
            BendError::CornerTooNear { .. } | BendError::LeadTooShort { .. }
                if feeds_too_little(wire, failed.step) =>
            {
                continue;
            }
            BendError::CornerTooNear { bend } => {
                (bend, Fact::CornerTooNear { bend }, or_start(wire, Remedy::LengthenEdge { by: None }))
            }
            BendError::LeadTooShort { bend, lead, needed } => {
                let by = (needed > lead).then(|| needed - lead);
                let fact = Fact::LeadTooShort { bend, lead, needed };
                (bend, fact, or_start(wire, Remedy::LengthenEdge { by }))
            }
            BendError::FoldBack { bend } => {
                (bend, Fact::FoldBackNotCompensated { bend }, vec![Remedy::OpenAngle])
            }
        };
        // Already reported with a clearer reason: by the check of fold backs, or as beyond the limit.
        let (min, max) = (wire.limits.min_bend.value.deg(), wire.limits.max_bend.value.deg());
        let beyond = bend.deg() < min - ROUNDING || bend.deg() > max + ROUNDING;
        if bend.abs() == Angle::HALF_TURN || beyond {
            continue;
        }
        let location = wire.location_of_step(failed.step);
        found.push(Diagnostic { severity: Severity::Error, location, fact, remedies });
    }
}

fn or_start(wire: &WireStages, remedy: Remedy) -> Vec<Remedy> {
    [remedy].into_iter().chain(Remedy::start_of_closed(wire)).collect()
}

/// Whether the feed before a bend is shorter than the machine's shortest.
fn feeds_too_little(wire: &WireStages, step: usize) -> bool {
    let Some(scheduled) = wire.scheduled else { return false };
    let told = with_bend_before(&scheduled.steps).nth(step).map(|(before, step)| {
        let feed = wire.compensation.feed.as_ref();
        feed.map_or(step.feed, |model| model.feed_for(step.feed, before, step.bend))
    });
    told.is_some_and(|feed| (feed - wire.limits.min_feed.value).mm() < -ROUNDING)
}

/// Whether another route could avoid a bend at the vertex of a step.
fn of_step(wire: &WireStages, vertex: Option<VertexId>) -> BendOf {
    let is_forced = wire.forced.iter().any(|forced| Some(forced.vertex) == vertex);
    if is_forced { BendOf::Forced } else { BendOf::Step }
}

/// What keeps the machine from a bend: the end of the axis, or the peg that slips off the wire before it.
pub(super) fn reach_limit(wire: &WireStages, bend: Angle) -> ReachLimit {
    let model = &wire.compensation.bend;
    let unlimited = BendModel { axis_limit: None, ..model.clone() };
    match (model.axis_limit, unlimited.command(bend)) {
        (Some(travel), Ok(needed)) => ReachLimit::Axis {
            needed,
            travel: Sourced { value: travel, source: wire.limits.axis_source.clone() },
        },
        _ => ReachLimit::Peg,
    }
}
