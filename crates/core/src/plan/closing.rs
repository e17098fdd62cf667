//! Which bend closes the gap between edges that come too close, and whether one snaps past the other in it.

use std::collections::HashMap;

use nalgebra::{Point3, Rotation3, Unit};
use wirebend_collide::between_pieces;

use super::{Machine, WirePlan};
use crate::checks::{ClosingBend, Diagnostic, Fact};
use crate::units::{Angle, Length};
use crate::wireframe::{EdgeId, VertexId};

/// One edge snaps past the other where they part again by more than this, in diameters, before the bend is pressed to its end.
const PARTS_BY: f64 = 0.1;
/// The smallest step of the turn, as travel of the longer arm's end, in diameters.
const MIN_STEP: f64 = 0.05;
/// So much of an edge counts on either side of where it comes close to the other, in diameters.
const WINDOW: f64 = 10.0;

/// Names, for edges that come too close and that one wire runs along, the bend that closes the gap between them.
///
/// Wire that is not bent yet lies straight, and all that is bent turns about the bend together: what two places are to each other is
/// settled by the last bend before the later one. Corners are taken to be as sharp as drawn; a bend is pressed beyond its angle by what it
/// springs back.
pub fn name_closing_bends(found: &mut [Diagnostic], wires: &[WirePlan], machine: &Machine) {
    if !found.iter().any(|one| matches!(one.fact, Fact::EdgesMeet { .. })) {
        return;
    }
    let wires: Vec<Traversals> = wires.iter().map(|wire| Traversals::of(wire, machine)).collect();
    let step_is_clear = wires.len() == 1;
    for diagnostic in found {
        if let Fact::EdgesMeet { edges, from, along, diameter, closing, .. } = &mut diagnostic.fact {
            let places = [0, 1].map(|side| Place { edge: edges[side], from: from[side], along: along[side] });
            let mut first = None;
            // Of doubled edges one may snap past where the other does not.
            for bend in wires.iter().flat_map(|wire| wire.closing(places, *diameter)) {
                first = first.or(Some(bend));
                if bend.snaps_past {
                    first = Some(bend);
                    break;
                }
            }
            *closing = first.map(|bend| ClosingBend { step: bend.step.filter(|_| step_is_clear), ..bend });
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

/// A place on the wire: a segment of its path, and mm from the begin of that.
#[derive(Clone, Copy)]
struct OnWire {
    segment: usize,
    along: f64,
}

/// Along which segments of its path a wire passes each edge.
struct Traversals<'a> {
    wire: &'a WirePlan,
    machine: &'a Machine,
    of_edge: HashMap<EdgeId, Vec<usize>>,
}

impl<'a> Traversals<'a> {
    fn of(wire: &'a WirePlan, machine: &'a Machine) -> Self {
        let mut of_edge: HashMap<EdgeId, Vec<usize>> = HashMap::new();
        for (segment, traversal) in wire.route.iter().flat_map(|route| &route.traversals).enumerate() {
            of_edge.entry(traversal.edge).or_default().push(segment);
        }
        Self { wire, machine, of_edge }
    }

    /// The bend for each time that the wire runs through both places.
    fn closing(&self, places: [Place; 2], diameter: Length) -> impl Iterator<Item = ClosingBend> {
        let [one, other] = places.map(|place| self.on_wire(place));
        let pairs =
            one.into_iter().flat_map(move |one| other.clone().into_iter().map(move |other| [one, other]));
        pairs.filter_map(move |mut both| {
            both.sort_unstable_by_key(|place| place.segment);
            self.bend_between(both, diameter.mm())
        })
    }

    fn on_wire(&self, place: Place) -> Vec<OnWire> {
        let segments = self.of_edge.get(&place.edge).into_iter().flatten();
        let at = |&segment: &usize| {
            let from = self.wire.route.as_ref()?.traversals.get(segment)?.from;
            let along =
                if from == place.from { place.along.mm() } else { self.length(segment)? - place.along.mm() };
            Some(OnWire { segment, along })
        };
        segments.filter_map(at).collect()
    }

    fn point(&self, index: usize) -> Option<Point3<f64>> {
        self.wire.path.get(index).copied()
    }

    fn length(&self, segment: usize) -> Option<f64> {
        Some((self.point(segment + 1)? - self.point(segment)?).norm())
    }

    /// The last bend before the later of two places; none where both are on one straight.
    fn bend_between(&self, [earlier, mut later]: [OnWire; 2], diameter: f64) -> Option<ClosingBend> {
        let spans = &self.wire.nominal.as_ref()?.spans;
        let mut index = spans.partition_point(|span| span.end <= later.segment);
        // A place at the begin of a straight is where the one before it ends: it is there before the bend between them.
        loop {
            let span = spans.get(index)?;
            if span.contains(&earlier.segment) {
                return None;
            }
            if later.segment > span.start || later.along > diameter {
                break;
            }
            index = index.checked_sub(1)?;
            let segment = span.start.checked_sub(1)?;
            later = OnWire { segment, along: self.length(segment)? };
        }
        let corner = spans.get(index)?.start;
        let before = corner.checked_sub(1)?;
        let at = self.point(corner)?;
        let (arrives, leaves) = (at - self.point(before)?, self.point(corner + 1)? - at);
        let turns = Unit::try_new(arrives.cross(&leaves), 0.0)?;
        let bend = arrives.angle(&leaves);
        let window = self.window([earlier, later], diameter)?;
        let [turning, still] = [self.around(earlier, window)?, self.around(later, window)?];
        let arm = turning.iter().map(|end| (end - at).norm()).fold(0.0, f64::max);
        let distance = |bent: f64| {
            let turn = Rotation3::from_axis_angle(&turns, bend - bent);
            between_pieces(&turning.map(|end| at + turn * (end - at)), &still).0
        };
        let springback = self.machine.compensation.bend.springback.as_ref();
        let pressed = springback.map_or(bend, |model| model.bend_to(Angle::computed(bend)).rad());
        let vertex = self.wire.route.as_ref()?.traversals.get(before)?.to;
        let snaps_past = parts_again(distance, pressed.max(bend), arm, diameter);
        Some(ClosingBend { vertex, step: index.checked_sub(1), snaps_past })
    }

    /// How much counts around two places: not as far as a vertex at which they are joined, mm.
    fn window(&self, places: [OnWire; 2], diameter: f64) -> Option<f64> {
        let traversals = &self.wire.route.as_ref()?.traversals;
        let [one, other] = places.map(|place| traversals.get(place.segment));
        let (one, other) = (one?, other?);
        let mut window = WINDOW * diameter;
        for (vertex, index) in [(one.from, places[0].segment), (one.to, places[0].segment + 1)] {
            if [other.from, other.to].contains(&vertex) {
                let joint = self.point(index)?;
                for place in places {
                    window = window.min((self.at(place)? - joint).norm() / 2.0);
                }
            }
        }
        Some(window)
    }

    fn at(&self, place: OnWire) -> Option<Point3<f64>> {
        let (from, to) = (self.point(place.segment)?, self.point(place.segment + 1)?);
        Some(from + (to - from) * (place.along / (to - from).norm()).clamp(0.0, 1.0))
    }

    /// The part of a segment that is so far from a place at most.
    fn around(&self, place: OnWire, reach: f64) -> Option<[Point3<f64>; 2]> {
        let [from, to] = [-reach, reach].map(|by| self.at(OnWire { along: place.along + by, ..place }));
        Some([from?, to?])
    }
}

/// Whether two edges that touch in a turn part again before it is pressed to its end.
fn parts_again(distance: impl Fn(f64) -> f64, pressed: f64, arm: f64, diameter: f64) -> bool {
    let (mut bent, mut least) = (0.0, diameter);
    while bent < pressed {
        let apart = distance(bent);
        least = least.min(apart);
        if apart > least + PARTS_BY * diameter && least < diameter {
            return true;
        }
        bent += (apart - diameter).max(MIN_STEP * diameter) / arm;
    }
    distance(pressed) > least + PARTS_BY * diameter && least < diameter
}

#[cfg(test)]
mod tests;
