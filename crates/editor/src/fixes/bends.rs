//! For bends that cannot be made: the vertex moved until they can.

use nalgebra::{Point3, Vector3};
use wirebend_core::checks::{Code, Diagnostic, Quantity};
use wirebend_core::compensate::{BendError, BendModel};
use wirebend_core::route::Traversal;
use wirebend_core::units::Angle;
use wirebend_core::wireframe::VertexId;

use super::super::{EditRequest, Placed};
use super::lengths::move_vertex;
use super::trials::Trials;
use super::verdict::same_place;
use super::{Candidate, Finding};

/// How far within the limit, so that rounding does not bring it beyond again.
const MARGIN_DEG: f64 = 0.05;
/// How often more is tried where other bends of the vertex or the side of the bend change with it.
const MAX_ATTEMPTS: usize = 3;
/// What a check calls near: within a twentieth of the limit.
const NEAR: f64 = 0.95;

/// The vertex of a bend with its neighbours along the route, mm.
struct Corner {
    id: VertexId,
    before: Point3<f64>,
    at: Point3<f64>,
    after: Point3<f64>,
}

/// The vertex nearer to the line between its neighbours, or farther from it.
pub(super) fn moves(finding: Finding, trials: &mut Trials) -> Vec<Candidate> {
    let Some(corner) = Corner::of(finding, trials) else { return Vec::new() };
    let diagnostic = finding.diagnostic;
    let mut found = Vec::new();
    match diagnostic.code() {
        Code::CornerNotMade => found.extend(corner.on_line()),
        Code::BendTooSmall => {
            found.extend(corner.on_line());
            let bend = &trials.machine().compensation.bend;
            let least = angle(diagnostic.measured()).and_then(|measured| least_bend(bend, measured));
            found.extend(least.and_then(|least| corner.sharpened(least.abs().deg() + MARGIN_DEG)));
        }
        _ => found.extend(opened(&corner, diagnostic, trials)),
    }
    found
}

/// The bend made as gentle as its limit wants it.
fn opened(corner: &Corner, diagnostic: &Diagnostic, trials: &mut Trials) -> Option<Candidate> {
    let limit = angle(diagnostic.limit().map(|limit| limit.value))?.abs().deg();
    let limit = if diagnostic.is_error() { limit } else { limit * NEAR };
    let mut wanted = limit - MARGIN_DEG;
    for _ in 0..MAX_ATTEMPTS {
        let candidate = corner.eased(wanted)?;
        let trial = trials.of(&candidate.edit)?;
        let still = trial.diagnostics().filter(|other| same_place(other, diagnostic));
        let still = still.filter_map(|other| Some(angle(other.measured())?.abs().deg() - limit));
        match still.max_by(f64::total_cmp) {
            Some(excess) => wanted -= excess.max(0.0) + MARGIN_DEG,
            None => return Some(candidate),
        }
    }
    None
}

impl Corner {
    fn of(finding: Finding, trials: &Trials) -> Option<Self> {
        let wire = finding.wire?;
        let traversals = &wire.route.as_ref()?.traversals;
        let id = *finding.diagnostic.location.vertices.first()?;
        let at = if let Some(step) = finding.diagnostic.location.step {
            wire.nominal.as_ref()?.spans.get(step)?.end
        } else {
            // A corner that is not bent is within a step: its edges follow each other.
            let [first, next] = finding.diagnostic.location.edges.as_slice() else { return None };
            let follow =
                |pair: &[Traversal]| pair[0].edge == *first && pair[1].edge == *next && pair[1].from == id;
            1 + traversals.windows(2).position(follow)?
        };
        let (before, after) = (traversals.get(at.checked_sub(1)?)?.from, traversals.get(at)?.to);
        let vertex = |id: VertexId| trials.document().wireframe.vertex(id);
        // What the design holds fixed is not moved.
        let own = vertex(id).filter(|vertex| !vertex.support)?;
        let (before, after) = (vertex(before)?.position, vertex(after)?.position);
        Some(Self { id, before, at: own.position, after })
    }

    /// The bend when the vertex is at a point, degrees.
    fn bend(&self, at: Point3<f64>) -> f64 {
        (at - self.before).angle(&(self.after - at)).to_degrees()
    }

    /// The point of the line between the neighbours at a part of it, and what leads there from the vertex.
    fn to_line(&self, within: (f64, f64)) -> Option<Vector3<f64>> {
        let along = self.after - self.before;
        let part = (self.at - self.before).dot(&along) / along.norm_squared();
        let part = part.clamp(within.0, within.1);
        let to = self.before + along * part - self.at;
        // In line with its neighbours, the vertex has no side from which to come nearer.
        let off = to - along * (to.dot(&along) / along.norm_squared());
        (along.norm() > 1e-6 && off.norm() > 1e-9).then_some(to)
    }

    fn on_line(&self) -> Option<Candidate> {
        let to = self.at + self.to_line((0.0, 1.0))?;
        Some(Candidate {
            title: format!("Put vertex {} onto the line of its edges", self.id),
            edit: EditRequest::Place {
                positions: vec![Placed { vertex: self.id.0, at_mm: to.coords.into() }],
            },
        })
    }

    /// The vertex moved towards the line just so far that the bend is no larger than wanted, degrees.
    fn eased(&self, wanted: f64) -> Option<Candidate> {
        let to = self.to_line((0.25, 0.75))?;
        if wanted <= 0.0 {
            return None;
        }
        let part = halved(0.0, 1.0, |part| self.bend(self.at + to * part) <= wanted);
        Some(move_vertex(self.id, to * part))
    }

    /// The vertex moved away from the line just so far that the bend is no smaller than wanted, degrees.
    fn sharpened(&self, wanted: f64) -> Option<Candidate> {
        let from = -self.to_line((0.0, 1.0))?.normalize();
        let farthest = (self.after - self.before).norm();
        let enough = |far: f64| self.bend(self.at + from * far) >= wanted;
        let far = enough(farthest).then(|| halved(0.0, farthest, enough))?;
        Some(move_vertex(self.id, from * far))
    }
}

/// The least bend to the same side that the axis can bend.
fn least_bend(model: &BendModel, bend: Angle) -> Option<Angle> {
    let signed = |deg: f64| Angle::from_deg(deg * bend.signum()).ok();
    let made = |deg: f64| {
        signed(deg).is_some_and(|bend| !matches!(model.command(bend), Err(BendError::TooSmall { .. })))
    };
    made(90.0).then(|| signed(halved(bend.abs().deg(), 90.0, made))).flatten()
}

/// Where something begins to hold between two numbers, of which it holds for the second.
fn halved(mut no: f64, mut yes: f64, holds: impl Fn(f64) -> bool) -> f64 {
    for _ in 0..60 {
        let middle = f64::midpoint(no, yes);
        if holds(middle) { yes = middle } else { no = middle }
    }
    yes
}

fn angle(quantity: Option<Quantity>) -> Option<Angle> {
    match quantity? {
        Quantity::Angle(angle) => Some(angle),
        _ => None,
    }
}
