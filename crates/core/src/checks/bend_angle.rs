//! Bends that the machine cannot make: every pair of edges that the route makes neighbours.

use super::{Code, Diagnostic, Limit, Quantity, ROUNDING, Severity, Wire, is_near};
use crate::compensate::{BendError, BendModel};
use crate::units::{Angle, digits_apart};

pub(super) fn check(wire: &Wire, found: &mut Vec<Diagnostic>) {
    // The schedule knows to which side; before it, the wider side counts.
    let nominal = wire.nominal.into_iter().flat_map(|program| &program.steps);
    let bends: Vec<Angle> = match wire.scheduled {
        Some(scheduled) => scheduled.steps.iter().map(|step| step.bend).collect(),
        None => nominal.map(|step| step.bend).collect(),
    };
    for (step, &bend) in bends.iter().enumerate().filter(|(_, bend)| **bend != Angle::ZERO) {
        let (least, largest) = (&wire.limits.least_bend, &wire.limits.largest_bend);
        let negative = match wire.scheduled {
            Some(_) => bend < Angle::ZERO,
            None => least.value.abs() > largest.value,
        };
        let limit = if negative { least } else { largest };
        // Straight back is a matter of its own.
        if bend.abs() == Angle::HALF_TURN {
            continue;
        }
        let room = (limit.value.abs() - bend.abs()).deg();
        let (code, severity, verdict) = if room < -ROUNDING {
            (Code::BendTooSharp, Severity::Error, "more than the machine makes")
        } else if is_near(room.max(0.0), limit.value.deg()) {
            (Code::BendNearLimit, Severity::Warning, "close to the most that the machine makes")
        } else {
            continue;
        };
        // At the limit but for rounding the two read alike, as they should.
        let digits = if room.abs() <= ROUNDING {
            1
        } else {
            digits_apart(bend.abs().deg(), limit.value.abs().deg(), 1)
        };
        found.push(Diagnostic {
            code,
            severity,
            place: wire.place_of_step(step),
            measured: Some(Quantity::Angle(bend)),
            limit: Some(Limit { value: Quantity::Angle(limit.value), source: limit.source.clone() }),
            message: format!(
                "the bend{} is {bend:.digits$}, {verdict} ({:.digits$})",
                at(wire, step),
                limit.value
            ),
            help: "open the angle between the two edges, or start the wire at this vertex".to_owned(),
        });
    }
    unreachable(wire, found);
}

/// Bends within the machine's limits that its axis still cannot reach with this wire.
fn unreachable(wire: &Wire, found: &mut Vec<Diagnostic>) {
    for failed in wire.unbendable {
        let (code, bend, limit) = match failed.error {
            BendError::OutOfReach { bend, largest } => (Code::BendOutOfReach, bend, Some(largest)),
            BendError::TooSmall { bend } => (Code::BendTooSmall, bend, None),
            BendError::FoldBack { bend } => (Code::FoldBack, bend, None),
        };
        // Said before, with a clearer reason: by the check of fold backs, or as beyond the limit.
        let (least, largest) = (wire.limits.least_bend.value.deg(), wire.limits.largest_bend.value.deg());
        let beyond = bend.deg() < least - ROUNDING || bend.deg() > largest + ROUNDING;
        if bend.abs() == Angle::HALF_TURN || beyond {
            continue;
        }
        let source = reach_source(wire, bend);
        found.push(Diagnostic {
            code,
            severity: Severity::Error,
            place: wire.place_of_step(failed.step),
            measured: Some(Quantity::Angle(bend)),
            limit: limit.map(|largest| Limit { value: Quantity::Angle(largest), source }),
            message: format!("the bend{}: {}", at(wire, failed.step), failed.error),
            help: match failed.error {
                BendError::OutOfReach { largest, .. } => format!("keep the bend below {largest:.2}"),
                BendError::FoldBack { .. } => "open the angle between the two edges".to_owned(),
                BendError::TooSmall { .. } => "make the bend larger, or the edges straight".to_owned(),
            },
        });
    }
}

/// What keeps a bend from being made: the end of the axis, or the peg that slips off the wire before it.
pub(super) fn reach_source(wire: &Wire, bend: Angle) -> String {
    let model = &wire.compensation.bend;
    let unlimited = BendModel { axis_limit: None, ..model.clone() };
    match (model.axis_limit, unlimited.command(bend)) {
        (Some(limit), Ok(axis)) => {
            let source = &wire.limits.axis_source;
            format!("the bend axis, which would have to go to {axis:.1} and goes to {limit:.1} [{source}]")
        }
        _ => "springback and setback of this wire on this machine".to_owned(),
    }
}

fn at(wire: &Wire, step: usize) -> String {
    wire.vertex_of_step(step).map_or_else(|| format!(" of step {}", step + 1), |v| format!(" at vertex {v}"))
}
