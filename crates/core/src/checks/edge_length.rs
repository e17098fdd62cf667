//! Designed edges that are too short for the machine's head to fit between two bends.

use super::{Code, Diagnostic, Limit, Place, Quantity, ROUNDING, Severity, Wire, is_near};
use crate::units::{Length, digits_apart};

pub(super) fn check(wire: &Wire, found: &mut Vec<Diagnostic>) {
    // With a program the straight parts are known, of which an edge may be a piece; until then each
    // edge is judged on its own.
    if let Some(nominal) = wire.nominal {
        for (index, step) in nominal.steps.iter().enumerate() {
            judge(wire, wire.place_of_step(index), step.feed, found);
        }
    } else {
        for &edge in &wire.component.edges {
            judge(wire, Place::at_edges([edge]), wire.wireframe.edge_length(edge), found);
        }
    }
}

fn judge(wire: &Wire, place: Place, length: Length, found: &mut Vec<Diagnostic>) {
    let limit = &wire.limits.least_edge;
    let room = (length - limit.value).mm();
    let too_short = room < -ROUNDING;
    let (code, severity) = if too_short {
        (Code::EdgeTooShort, Severity::Error)
    } else if is_near(room.max(0.0), limit.value.mm()) {
        (Code::EdgeNearLimit, Severity::Warning)
    } else {
        return;
    };
    let edges: Vec<String> = place.edges.iter().map(ToString::to_string).collect();
    let digits = if room.abs() <= ROUNDING { 1 } else { digits_apart(length.mm(), limit.value.mm(), 1) };
    let name = if edges.len() > 1 { "edges" } else { "edge" };
    found.push(Diagnostic {
        code,
        severity,
        measured: Some(Quantity::Length(length)),
        limit: Some(Limit { value: Quantity::Length(limit.value), source: limit.source.clone() }),
        message: format!(
            "{name} {} {} {length:.digits$} long; the shortest that the machine makes is {:.digits$}",
            edges.join(", "),
            if edges.len() > 1 { "are" } else { "is" },
            limit.value
        ),
        help: if too_short {
            format!("make it at least {:.digits$} longer, or scale the design up", Length::computed(-room))
        } else {
            "leave it, or make it a little longer".to_owned()
        },
        place,
    });
}
