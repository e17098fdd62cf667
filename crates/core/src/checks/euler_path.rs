//! Whether one wire can run through every edge once.

use super::{Code, Diagnostic, Limit, Place, Quantity, Severity, Wire};

pub(super) fn check(wire: &Wire, found: &mut Vec<Diagnostic>) {
    let odd = wire.wireframe.odd_vertices(wire.component, wire.doubled);
    let allowed = if wire.closed { 0 } else { 2 };
    if odd.len() <= allowed {
        return;
    }
    let help = match wire.proposal {
        Some(doubling) => format!(
            "travel {} twice: that adds {:.1} ({:.1} % of the design), and no other choice adds less",
            match doubling.edges.len() {
                1 => "1 edge".to_owned(),
                count => format!("{count} edges"),
            },
            doubling.added,
            100.0 * doubling.added.mm() / length(wire).max(f64::MIN_POSITIVE),
        ),
        None => "have the cheapest edges travelled twice, or add and delete edges until at most two vertices are odd".to_owned(),
    };
    found.push(Diagnostic {
        code: Code::NoEulerPath,
        severity: Severity::Error,
        place: Place::at_vertices(odd.iter().copied()),
        measured: Some(Quantity::Count(odd.len())),
        limit: Some(Limit {
            value: Quantity::Count(allowed),
            source: "Euler: only the two ends of a wire may be odd".to_owned(),
        }),
        message: format!(
            "{} vertices are odd: no {} runs through every edge once",
            odd.len(),
            if wire.closed { "closed wire" } else { "single wire" }
        ),
        help,
    });
}

fn length(wire: &Wire) -> f64 {
    wire.component.edges.iter().map(|&edge| wire.wireframe.edge_length(edge).mm()).sum()
}
