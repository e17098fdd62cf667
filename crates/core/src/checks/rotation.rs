//! Whether the head can turn to where every bend needs it.

use super::{Diagnostic, Fact, Remedy, Severity, WireStages};
use crate::units::Angle;

pub(super) fn check(wire: &WireStages, found: &mut Vec<Diagnostic>) {
    let Some(refused) = wire.rotation else { return };
    let limits = wire.limits;
    let negative = refused.wanted < Angle::ZERO;
    let source = if negative { &limits.min_rotation_source } else { &limits.max_rotation_source };
    found.push(Diagnostic {
        severity: Severity::Error,
        location: wire.location_of_step(refused.step),
        fact: Fact::RotationOutOfRange {
            wanted: refused.wanted,
            commanded: refused.commanded,
            range: [refused.min, refused.max],
            source: source.clone(),
        },
        remedies: vec![Remedy::TurnBendPlane, Remedy::ChooseStart, Remedy::ChooseMachineWithRotation],
    });
}
