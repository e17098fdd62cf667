//! Whether a wire, or as many as there may be, can run through every edge once.

use super::{Diagnostic, Fact, Location, Remedy, Severity, WireStages};
use crate::route::Doubling;
use crate::wireframe::{Component, EdgeId, VertexId, Wireframe};

pub(super) fn check(wire: &WireStages, found: &mut Vec<Diagnostic>) {
    let WireStages { wireframe, component, doubled, odd_allowed, proposal, .. } = *wire;
    found.extend(check_odd(wireframe, component, doubled, odd_allowed, proposal));
}

/// More odd vertices than there may be in a component of which some edges are travelled twice, and how to do without them:
/// `proposal`, or there is none.
pub(crate) fn check_odd(
    wireframe: &Wireframe,
    component: &Component,
    doubled: &[EdgeId],
    allowed: usize,
    proposal: Option<&Doubling>,
) -> Option<Diagnostic> {
    let odd = wireframe.odd_vertices(component, doubled);
    // Wire that comes back from a dead end is folded there, which few machines can.
    let is_dead_end = |vertex: VertexId| wireframe.incident(vertex).len() == 1;
    let folds = |doubling: &Doubling| {
        let ends = doubling.edges.iter().filter_map(|&edge| wireframe.edge(edge));
        ends.flat_map(|edge| [edge.a, edge.b]).any(is_dead_end)
    };
    let wires = proposal.filter(|doubling| allowed > 0 && folds(doubling)).map(|_| Remedy::AllowWires);
    (odd.len() > allowed).then(|| Diagnostic {
        severity: Severity::Error,
        location: Location::at_vertices(odd.iter().copied()),
        fact: Fact::NoEulerPath { odd: odd.len(), allowed },
        remedies: match proposal {
            Some(doubling) => wires.into_iter().chain([Remedy::double(doubling, wireframe)]).collect(),
            None => vec![Remedy::FindDoubling, Remedy::ReduceOddVertices],
        },
    })
}
