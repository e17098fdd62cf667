//! For straight parts that are too short: one end farther out, the other, or both by half.

use nalgebra::{Point3, Unit, Vector3};
use wirebend_core::checks::{Code, Diagnostic, Quantity};
use wirebend_core::wireframe::{EdgeId, VertexId, Wireframe};

use super::super::{EditRequest, Placed};
use super::trials::Trials;
use super::verdict::share_edge;
use super::{Candidate, Finding, shown_mm};

/// How much longer than needed, so that rounding does not make it too short again; mm.
const MARGIN_MM: f64 = 0.05;
/// How often it is made longer still where the feed depends on the bends, which change with it.
const MAX_ATTEMPTS: usize = 4;
/// What a check calls near: within a twentieth of the limit.
const NEAR: f64 = 1.05;

/// The straight part made long enough.
pub(super) fn candidates(finding: Finding, trials: &mut Trials) -> Vec<Candidate> {
    let straight = ends(&trials.document().wireframe, finding.diagnostic);
    let needed = missing(finding.diagnostic, finding.wire.iter().flat_map(|wire| &wire.diagnostics));
    let (Some(straight), Some(needed)) = (straight, needed) else { return Vec::new() };
    let mut found = Vec::new();
    for (first, last) in [(0.0, 1.0), (1.0, 0.0), (0.5, 0.5)] {
        let mut more = needed;
        for _ in 0..MAX_ATTEMPTS {
            let Some(candidate) = straight.longer(&trials.document().wireframe, more * first, more * last)
            else {
                break;
            };
            let Some(trial) = trials.of(&candidate.edit) else { break };
            found.push(candidate);
            match missing(finding.diagnostic, trial.diagnostics()) {
                Some(still) => {
                    found.pop();
                    more += still;
                }
                None => break,
            }
        }
    }
    found
}

/// What a straight part lacks, the margin included; none where nothing is missing. Whatever else is too short about it
/// is made up for at once.
fn missing<'a>(of: &Diagnostic, said: impl Iterator<Item = &'a Diagnostic>) -> Option<f64> {
    let too_short = |code| {
        matches!(code, Code::EdgeTooShort | Code::FeedTooShort | Code::ArcsOverlap | Code::LeadTooShort)
    };
    let near = |code| matches!(code, Code::EdgeNearLimit | Code::FeedNearLimit) && !of.is_error();
    let here = said.filter(|d| share_edge(d, of) && (too_short(d.code()) || near(d.code())));
    let lacks = here.filter_map(|d| {
        let (Some(Quantity::Length(measured)), Some(limit)) = (d.measured(), d.limit()) else { return None };
        let Quantity::Length(limit) = limit.value else { return None };
        let wanted = if of.is_error() { limit.mm() } else { limit.mm() * NEAR };
        Some(wanted - measured.mm() + MARGIN_MM)
    });
    lacks.max_by(f64::total_cmp)
}

/// A straight part of the wire: one edge, or several in line.
struct Straight {
    first: VertexId,
    last: VertexId,
    along: Unit<Vector3<f64>>,
}

/// Where the edges of a diagnostic begin and end.
fn ends(wireframe: &Wireframe, diagnostic: &Diagnostic) -> Option<Straight> {
    let edges: &[EdgeId] = &diagnostic.location.edges;
    let edge = wireframe.edge(*edges.first()?)?;
    let (first, last) = match edges.get(1).and_then(|&next| wireframe.edge(next)) {
        None => (edge.a, edge.b),
        Some(next) => {
            let joint = if [next.a, next.b].contains(&edge.b) { edge.b } else { edge.a };
            let mut last = joint;
            for &id in edges.get(1..)? {
                last = wireframe.edge(id)?.other(last);
            }
            (edge.other(joint), last)
        }
    };
    // An edge without length has no direction.
    let along = Unit::try_new(wireframe.vertex(last)?.position - wireframe.vertex(first)?.position, 1e-9)?;
    Some(Straight { first, last, along })
}

impl Straight {
    /// Its ends moved out by so much, mm. What the design holds fixed is not moved.
    fn longer(&self, wireframe: &Wireframe, first: f64, last: f64) -> Option<Candidate> {
        let mut moved: Vec<(VertexId, Vector3<f64>)> = Vec::new();
        if first > 0.0 {
            moved.push((self.first, -self.along.into_inner() * first));
        }
        if last > 0.0 {
            moved.push((self.last, self.along.into_inner() * last));
        }
        if moved.iter().any(|&(id, _)| wireframe.vertex(id).is_none_or(|vertex| vertex.support)) {
            return None;
        }
        Some(match moved.as_slice() {
            &[(id, by)] => move_vertex(id, by),
            _ => Candidate {
                title: format!(
                    "Move vertices {} and {} apart by {}",
                    self.first,
                    self.last,
                    shown_mm(first + last)
                ),
                edit: EditRequest::Place {
                    positions: moved
                        .into_iter()
                        .filter_map(|(id, by)| Some((id, wireframe.vertex(id)?.position + by)))
                        .map(|(id, to): (VertexId, Point3<f64>)| Placed {
                            vertex: id.0,
                            at_mm: to.coords.into(),
                        })
                        .collect(),
                },
            },
        })
    }
}

/// A vertex moved, mm.
pub(super) fn move_vertex(id: VertexId, by: Vector3<f64>) -> Candidate {
    Candidate {
        title: format!("Move vertex {id} by {}", shown_mm(by.norm())),
        edit: EditRequest::Move { vertices: vec![id.0], lines: Vec::new(), by_mm: by.into() },
    }
}
