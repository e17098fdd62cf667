//! Whether the wire fits the machine at all.

use super::{Code, Diagnostic, Limit, Place, Quantity, Severity, Wire};

pub(super) fn check(wire: &Wire, found: &mut Vec<Diagnostic>) {
    let (least, most) = (&wire.limits.least_diameter, &wire.limits.most_diameter);
    let (limit, verdict) = if wire.diameter < least.value {
        (least, "thinner")
    } else if wire.diameter > most.value {
        (most, "thicker")
    } else {
        return;
    };
    found.push(Diagnostic {
        code: Code::WireDoesNotFit,
        severity: Severity::Error,
        place: Place::default(),
        measured: Some(Quantity::Length(wire.diameter)),
        limit: Some(Limit { value: Quantity::Length(limit.value), source: limit.source.clone() }),
        message: format!(
            "a wire of {:.2} is {verdict} than the machine takes ({:.2} to {:.2})",
            wire.diameter, least.value, most.value
        ),
        help: "choose another material, or another machine".to_owned(),
    });
}
