//! Whether the head can turn to where every bend needs it.

use super::{Code, Diagnostic, Limit, Quantity, Severity, Wire};
use crate::units::Angle;

pub(super) fn check(wire: &Wire, found: &mut Vec<Diagnostic>) {
    let Some(refused) = wire.rotation else { return };
    let [least, most] = &wire.limits.head_sources;
    let (limit, source) =
        if refused.wanted < Angle::ZERO { (refused.least, least) } else { (refused.most, most) };
    found.push(Diagnostic {
        code: Code::RotationOutOfRange,
        severity: Severity::Error,
        place: wire.place_of_step(refused.step),
        measured: Some(Quantity::Angle(refused.wanted)),
        limit: Some(Limit { value: Quantity::Angle(limit), source: source.clone() }),
        message: refused.to_string(),
        help: "turn the plane of the bend, choose another start, or a machine whose head turns farther"
            .to_owned(),
    });
}
