//! How near the wire in the bender comes to things.

use nalgebra::{Isometry3, Point3, Translation3, UnitQuaternion, Vector3, center};
use wirebend_collide::{Solid, to_solid};
use wirebend_core::bend::Step;
use wirebend_core::clearance::{Body, MovesWith, Obstacle, Passage, Phase};
use wirebend_core::plan::Machine;
use wirebend_core::units::Length;
use wirebend_core::wireframe::VertexId;

use super::{Bender, Ran};

/// How exact distances are, mm.
const EXACT: f64 = 1e-4;

impl Bender<'_> {
    /// The least distance of the centreline from a body, of what may not touch it.
    fn distance(&self, body: &Body, phase: Phase) -> f64 {
        let zone = body.vertex_zone.mm();
        let mut may_touch = Vec::new();
        if body.contact_zone.mm() > 0.0 {
            may_touch = self.may_touch(phase, |_, _| zone);
            may_touch.push([self.out - body.contact_zone.mm(), f64::INFINITY]);
        }
        self.nearest(&body.solid, &self.placed(body), &may_touch)
    }

    /// The same from the stock.
    fn distance_of_stock(&self, phase: Phase) -> f64 {
        let radius = self.machine.wire.diameter.mm() / 2.0;
        let half_length = (self.stock / 2.0).max(0.0);
        let lie = UnitQuaternion::from_axis_angle(&Vector3::y_axis(), std::f64::consts::FRAC_PI_2);
        let at = Isometry3::from_parts(Translation3::new(-half_length, 0.0, 0.0), lie);
        let may_touch = self.may_touch(phase, |ran, end| {
            if phase == Phase::Bend && !self.overbent { self.beside_stock(ran, end) } else { f64::INFINITY }
        });
        self.nearest(&Solid::Capsule { radius, half_length }, &at, &may_touch)
    }

    /// How much of a strut lies so near to where the stock is before or after the bend that they touch there. `end`: at which of its ends.
    fn beside_stock(&self, ran: &Ran, end: usize) -> f64 {
        let begin = self.corners[ran.step];
        let way = (self.corners[ran.step + 1] - begin).normalize();
        let (strut, vertex) = if end == 0 { (way, ran.passage.from) } else { (-way, ran.passage.to) };
        let bends_at = self.passages.get(self.step + 1).and_then(|next| next.first());
        let [before, after] = self.stock_goes.map(|goes| strut.angle(&goes));
        let right = std::f64::consts::FRAC_PI_2;
        // It goes out from where it bends, and on beyond where it comes to.
        let angle = if bends_at.is_some_and(|(passage, _)| passage.from == vertex) {
            before.min(after).min(right)
        } else {
            after.min(2.0 * right - after)
        };
        let touch = self.machine.wire.diameter.mm() + self.margin;
        let at = begin + way * ran.from_corner[end];
        let missed = (at - self.stock_at(vertex)).norm();
        ran.arcs[end].max((touch + missed) / angle.sin() + touch)
    }

    /// Where the stock has a vertex of the edges that come next, once it is bent.
    fn stock_at(&self, vertex: VertexId) -> Point3<f64> {
        let mut at = self.corners[self.step + 1];
        for (passage, length) in &self.passages[self.step + 1] {
            if passage.from == vertex {
                break;
            }
            at += self.stock_goes[1] * length.mm();
        }
        at
    }

    /// Struts may touch within a zone of the vertices of the edges that are fed, or of those that come next once it bends; those
    /// that run along the same edges lie beside them.
    fn may_touch(&self, phase: Phase, zone: impl Fn(&Ran, usize) -> f64) -> Vec<[f64; 2]> {
        let edges = |step: usize| self.passages.get(step).map_or(&[][..], Vec::as_slice);
        let (own, next) = (edges(self.step), edges(self.step + 1));
        let coming = if matches!(phase, Phase::Feed | Phase::Rotate) { own } else { next };
        let is_end = |vertex: VertexId| coming.iter().any(|(one, _)| one.from == vertex || one.to == vertex);
        let mut may = Vec::new();
        for ran in &self.passed {
            let Ran { passage, along: [from, to], .. } = *ran;
            if own.iter().chain(next).any(|(one, _)| one.edge == passage.edge) {
                may.push([from, to]);
            }
            if is_end(passage.from) {
                may.push([from, to.min(from + zone(ran, 0))]);
            }
            if is_end(passage.to) {
                may.push([from.max(to - zone(ran, 1)), to]);
            }
        }
        if phase == Phase::Feed {
            // Half of the arc before belongs to the edge that is fed.
            may.push([self.corner, f64::INFINITY]);
        }
        may
    }

    /// The same from whatever the wire may meet; none where that does not move past it now, or goes the way that it came.
    #[must_use]
    pub fn distance_of(&self, obstacle: Obstacle, phase: Phase) -> Option<f64> {
        let bends = matches!(phase, Phase::Feed | Phase::Bend);
        match obstacle {
            Obstacle::Body(index) => {
                let body = &self.machine.bodies.all[index];
                let moves = bends
                    || body.moves_with == MovesWith::Peg
                    || (phase == Phase::Rotate && body.moves_with == MovesWith::Head);
                moves.then(|| self.distance(body, phase))
            }
            Obstacle::Stock => bends.then(|| self.distance_of_stock(phase)),
        }
    }

    fn nearest(&self, solid: &Solid, at: &Isometry3<f64>, may_touch: &[[f64; 2]]) -> f64 {
        let into = at.inverse();
        let mut least = f64::INFINITY;
        for piece in &self.pieces {
            let middle = into * center(&piece.ends[0], &piece.ends[1]);
            let half = (piece.ends[1] - piece.ends[0]).norm() / 2.0;
            if solid.distance(&middle) - half < least.min(10.0) {
                let mut parts = vec![piece.along];
                for [low, high] in may_touch {
                    let outside = |[from, to]: [f64; 2]| [[from, to.min(*low)], [from.max(*high), to]];
                    parts =
                        parts.into_iter().flat_map(outside).filter(|[from, to]| to - from > 1e-6).collect();
                }
                for part in parts {
                    let [from, to] = part.map(|along| {
                        let share = (along - piece.along[0]) / (piece.along[1] - piece.along[0]);
                        into * (piece.ends[0] + (piece.ends[1] - piece.ends[0]) * share)
                    });
                    least = least.min(to_solid([&from, &to], solid, EXACT).distance);
                }
            }
        }
        least
    }
}

/// What comes nearest to the wire while a program runs, and how far its centreline is from it, mm.
#[must_use]
pub fn nearest(
    machine: &Machine,
    steps: &[Step],
    passages: Vec<Vec<(Passage, Length)>>,
    stride: f64,
) -> Option<(Obstacle, f64)> {
    let obstacles = (0..machine.bodies.all.len()).map(Obstacle::Body).chain([Obstacle::Stock]);
    let mut seen: Vec<(Obstacle, f64)> = obstacles.map(|obstacle| (obstacle, f64::INFINITY)).collect();
    let mut bender = Bender::new(machine, steps, passages, stride);
    for step in steps {
        bender.run(step, &[], &mut |(phase, _), bender| {
            for (obstacle, least) in &mut seen {
                *least = bender.distance_of(*obstacle, phase).map_or(*least, |distance| least.min(distance));
            }
        });
    }
    seen.into_iter().min_by(|one, other| one.1.total_cmp(&other.1))
}
