//! Bends whose peg meets wire that was bent before.

use super::{Diagnostic, Fact, Location, Remedy, Severity, WireStages};

/// Less than this lies within what bends scatter by on any machine, degrees.
const FURTHER: f64 = 0.1;

pub(super) fn check(wire: &WireStages, found: &mut Vec<Diagnostic>) {
    let mut bends = 0;
    for near in wire.compensated.iter().flat_map(|program| program.near_corners()) {
        if !near.past_other && near.further.is_some_and(|further| further.deg().abs() < FURTHER) {
            continue;
        }
        let (severity, remedies) = if near.past_other {
            (Severity::Warning, vec![Remedy::LengthenEdge { by: None }])
        } else {
            (Severity::Info, vec![Remedy::Leave])
        };
        let location = wire.location_of_step(near.step);
        found.push(Diagnostic { severity, location, fact: Fact::CornerWithinReach(*near), remedies });
        bends += 1;
    }
    // How much further the axis goes there depends on where the peg really is.
    if bends > 0 && wire.limits.head_not_measured {
        found.push(Diagnostic {
            severity: Severity::Info,
            location: Location::default(),
            fact: Fact::HeadNotMeasured(bends),
            remedies: vec![Remedy::Calibrate],
        });
    }
}
