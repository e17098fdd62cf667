//! Which bend brings edges that come too close to where they are, and whether one passes the other on the way.

use std::collections::HashMap;

use nalgebra::{Point3, Rotation3, Unit};
use wirebend_collide::between_pieces;

use super::WirePlan;
use crate::checks::{Brought, Diagnostic, Fact};
use crate::units::Length;
use crate::wireframe::{EdgeId, VertexId};

/// What comes nearer than it is in the finished part, by more than this share of the diameter, passes the other.
const PASSES: f64 = 0.1;
/// So far goes the end of the arm at least from one look to the next, in diameters.
const LOOK: f64 = 0.02;
/// So much of an edge counts on either side of where it comes close to the other, in diameters.
const AROUND: f64 = 10.0;

/// Says of edges that come too close, and that one wire runs along, which bend brings them together.
///
/// Wire that is not bent yet lies straight, and all that is bent turns about the bend together: two edges come to where they are, seen
/// from each other, at the bend with which the later one begins. Corners are taken for as sharp as they are drawn.
pub fn say_what_brings(found: &mut [Diagnostic], wires: &[WirePlan]) {
    if !found.iter().any(|one| matches!(one.fact, Fact::EdgesMeet { .. })) {
        return;
    }
    let passes: Vec<Passes> = wires.iter().map(Passes::of).collect();
    for diagnostic in found {
        if let Fact::EdgesMeet { edges, from, along, diameter, brought, .. } = &mut diagnostic.fact {
            let places = [0, 1].map(|side| Place { edge: edges[side], from: from[side], along: along[side] });
            let all = || passes.iter().flat_map(|wire| wire.brought(places, *diameter));
            // Of an edge that is passed twice one may pass the other only once.
            *brought = all().find(|one| one.passes).or_else(|| all().next());
        }
    }
}

/// A place on an edge, so far from one of its vertices.
#[derive(Clone, Copy)]
struct Place {
    edge: EdgeId,
    from: VertexId,
    along: Length,
}

/// Where a wire passes each edge, by the segments of its path.
struct Passes<'a> {
    wire: &'a WirePlan,
    of: HashMap<EdgeId, Vec<usize>>,
}

impl<'a> Passes<'a> {
    fn of(wire: &'a WirePlan) -> Self {
        let mut of: HashMap<EdgeId, Vec<usize>> = HashMap::new();
        for (segment, traversal) in wire.route.iter().flat_map(|route| &route.traversals).enumerate() {
            of.entry(traversal.edge).or_default().push(segment);
        }
        Self { wire, of }
    }

    /// What brings two places together, for each time that the wire passes both.
    fn brought(&self, places: [Place; 2], diameter: Length) -> impl Iterator<Item = Brought> {
        let segments = |place: Place| self.of.get(&place.edge).map_or(&[][..], Vec::as_slice).iter();
        let pairs =
            segments(places[0]).flat_map(move |&one| segments(places[1]).map(move |&other| [one, other]));
        pairs.filter_map(move |segments| {
            let mut both = [0, 1].map(|side| (segments[side], places[side]));
            both.sort_unstable_by_key(|&(segment, _)| segment);
            self.bend_between(both, diameter.mm())
        })
    }

    /// The bend with which the later of two segments begins; none where both are of one straight.
    fn bend_between(&self, [earlier, later]: [(usize, Place); 2], diameter: f64) -> Option<Brought> {
        let wire = self.wire;
        let spans = &wire.nominal.as_ref()?.spans;
        let span = spans.iter().find(|span| span.contains(&later.0))?;
        if span.contains(&earlier.0) {
            return None;
        }
        let before = span.start.checked_sub(1)?;
        let vertex = wire.route.as_ref()?.traversals.get(before)?.to;
        let point = |index: usize| wire.path.get(index).copied();
        let (corner, next) = (point(span.start)?, point(span.start + 1)?);
        let (arrives, leaves) = (corner - point(before)?, next - corner);
        let turns = Unit::try_new(arrives.cross(&leaves), 0.0)?;
        let angle = arrives.angle(&leaves);
        let around = |(segment, place)| self.around(segment, place, AROUND * diameter);
        let (turning, still) = (around(earlier)?, around(later)?);
        let at = |bent: f64| {
            let turn = Rotation3::from_axis_angle(&turns, angle - bent);
            let turned = turning.map(|end| corner + turn * (end - corner));
            between_pieces(&turned, &still).0
        };
        let arm = turning.iter().map(|end| (end - corner).norm()).fold(0.0, f64::max);
        let passed = at(angle) - PASSES * diameter;
        let mut bent = 0.0;
        while bent < angle {
            let distance = at(bent);
            if distance < passed {
                return Some(Brought { vertex, passes: true });
            }
            bent += (distance - passed).max(LOOK * diameter) / arm;
        }
        Some(Brought { vertex, passes: false })
    }

    /// The part of a segment that is so far from a place at most.
    fn around(&self, segment: usize, place: Place, reach: f64) -> Option<[Point3<f64>; 2]> {
        let traversal = self.wire.route.as_ref()?.traversals.get(segment)?;
        let [from, to] = [segment, segment + 1].map(|index| self.wire.path.get(index).copied());
        let (from, to) = (from?, to?);
        let length = (to - from).norm();
        let along = if traversal.from == place.from { place.along.mm() } else { length - place.along.mm() };
        Some([along - reach, along + reach].map(|at| from + (to - from) * (at / length).clamp(0.0, 1.0)))
    }
}
