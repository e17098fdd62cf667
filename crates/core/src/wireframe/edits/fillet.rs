//! Corners that are rounded by a radius, as chords of the arc that touches both of their edges.

use std::collections::BTreeMap;

use nalgebra::{Point3, Rotation3, Unit, Vector3};

use super::super::Vertex;
use super::super::delta::Draft;
use super::super::graph::{Edge, EdgeId, VertexId, WireframeError};
use super::chord_limits::{ChordLimits, NOTHING};
use super::exact::{angle_between, direction, only_two, other_end};
use super::{EditError, FilletFault, check_listed};
use crate::units::{Angle, Length};

/// Corners that are straighter, or nearer to folded back, have no arc: radians.
const STRAIGHT: f64 = 1e-6;
/// The most chords of a corner.
const MAX_CHORDS: f64 = 100_000.0;

/// Which chords a fillet would make. One that cannot be made is an [`EditError::Fillet`].
#[derive(Debug, Clone, PartialEq)]
pub struct FilletOutcome {
    /// How many, of each corner in the order in which they are listed.
    pub chords: Vec<u32>,
    /// The shortest of all.
    pub shortest: Length,
    /// What can be made there at least; 0 where everything can be made.
    pub needed: Length,
    /// The nearest radius at which nothing comes near the machine's limits, so that no check warns of it: the radius itself where that is
    /// so. None where no radius is like that.
    pub clear: Option<Length>,
}

/// One of the two edges at a corner.
struct Leg {
    id: EdgeId,
    edge: Edge,
    end: VertexId,
    way: Unit<Vector3<f64>>,
    length: f64,
    /// How far the wire is bent where the leg ends; 0 at its end, and where it meets others.
    bend: f64,
}

/// A corner, and what its fillet has to keep to.
struct Corner {
    vertex: VertexId,
    at: Point3<f64>,
    legs: [Leg; 2],
    /// How far the wire is bent at the corner, and so how far round the arc goes.
    sweep: f64,
}

/// What bounds the radius of a corner.
struct Bounds {
    /// The shortest of two chords, which have the largest bends, and the shortest that may be left of an edge, mm.
    chord: f64,
    left: f64,
    /// The least and the largest radius, mm.
    min: f64,
    max: f64,
    /// What the radius that is asked for leaves of the shorter edge, mm, unless that is nothing: of it there is no edge that could
    /// be too short. Less than 0 where an edge is not long enough.
    rest: f64,
}

/// Rounds corners. See `Edit::Fillet`.
pub(super) fn fillet(
    draft: &mut Draft,
    vertices: &[VertexId],
    radius: Length,
    step: Angle,
    limits: &ChordLimits,
) -> Result<(), EditError> {
    let planned = plan(draft, vertices, radius, step, limits)?;
    for (&vertex, (_, chords)) in vertices.iter().zip(planned.corners) {
        // As those before it have left its edges.
        Corner::of(draft, vertex)?.round(draft, radius.mm(), chords)?;
    }
    Ok(())
}

/// What a fillet would make; none without corners.
pub(super) fn outcome(
    draft: &Draft,
    vertices: &[VertexId],
    radius: Length,
    step: Angle,
    limits: &ChordLimits,
) -> Result<Option<FilletOutcome>, EditError> {
    let Plan { corners: planned, clear } = plan(draft, vertices, radius, step, limits)?;
    let told = |(corner, count): &(Corner, u32)| {
        let bend = corner.sweep / f64::from(*count);
        (corner.chord(radius.mm(), *count), limits.chord(bend))
    };
    let shortest = planned.iter().map(told).min_by(|(one, _), (other, _)| one.total_cmp(other));
    Ok(shortest.map(|(shortest, needed)| FilletOutcome {
        chords: planned.iter().map(|(_, count)| *count).collect(),
        shortest: Length::computed(shortest),
        needed: Length::computed(needed),
        clear,
    }))
}

/// What becomes of the corners of a fillet.
struct Plan {
    /// Each with the number of chords that its arc is divided into.
    corners: Vec<(Corner, u32)>,
    /// See [`FilletOutcome::clear`].
    clear: Option<Length>,
}

fn plan(
    draft: &Draft,
    vertices: &[VertexId],
    radius: Length,
    step: Angle,
    limits: &ChordLimits,
) -> Result<Plan, EditError> {
    check_listed(draft, vertices)?;
    if radius <= Length::ZERO {
        return Err(EditError::FilletRadius(radius.mm()));
    }
    if step <= Angle::ZERO || step > Angle::HALF_TURN {
        return Err(EditError::ArcStep(step));
    }
    let corners = vertices.iter().map(|&vertex| Corner::of(draft, vertex)).collect::<Result<Vec<_>, _>>()?;
    let reaches = corners.iter().map(|corner| (corner.vertex, corner.reach())).collect();
    let bounds = |limits: &ChordLimits| -> Vec<Bounds> {
        corners.iter().map(|corner| corner.bounds(radius.mm(), limits, &reaches)).collect()
    };
    let (bounds, wide) = (bounds(limits), bounds(&limits.with_margin()));
    // Who is offered a radius is not to be warned of it.
    let clear = nearest(radius, &wide);
    for (corner, own) in corners.iter().zip(&bounds) {
        let (fault, length, min_edge) = if own.is_too_small(radius) {
            (FilletFault::Chords, corner.chord(radius.mm(), 2), own.chord)
        } else if own.leaves_too_little() {
            (FilletFault::Edges, own.rest.max(0.0), own.left)
        } else {
            continue;
        };
        return Err(EditError::Fillet {
            vertex: corner.vertex,
            radius,
            length: Length::computed(length),
            min_edge: Length::computed(min_edge),
            fault,
            nearest: clear.or_else(|| nearest(radius, &bounds)),
        });
    }
    let chords = corners.iter().map(|corner| corner.chords(radius.mm(), step.rad(), limits));
    let chords = chords.collect::<Result<Vec<_>, _>>()?;
    Ok(Plan { corners: corners.into_iter().zip(chords).collect(), clear })
}

/// The nearest radius that can be made at all corners: the radius itself, or one with one digit behind the point, as it is written.
fn nearest(radius: Length, bounds: &[Bounds]) -> Option<Length> {
    if !bounds.iter().any(|own| own.is_too_small(radius) || own.leaves_too_little()) {
        return Some(radius);
    }
    let min = bounds.iter().map(|bounds| bounds.min).fold(0.0, f64::max);
    let max = bounds.iter().map(|bounds| bounds.max).fold(f64::INFINITY, f64::min);
    let (up, down) = ((min * 10.0 - NOTHING).ceil() / 10.0, (max * 10.0 + NOTHING).floor() / 10.0);
    (up <= down && down > 0.0).then(|| Length::computed(radius.mm().clamp(up, down)))
}

impl Bounds {
    fn is_too_small(&self, radius: Length) -> bool {
        radius.mm() < self.min - NOTHING
    }

    fn leaves_too_little(&self) -> bool {
        self.rest < self.left - NOTHING
    }
}

impl Corner {
    fn of(draft: &Draft, vertex: VertexId) -> Result<Self, EditError> {
        let (one, other) = only_two(draft, vertex)?;
        let marked = draft.vertex(vertex).ok_or(WireframeError::NoVertex(vertex))?;
        if marked.support || marked.joint.is_some() {
            return Err(EditError::HeldCorner(vertex));
        }
        let at = marked.position;
        let leg = |id: EdgeId| {
            let edge = draft.edge(id).ok_or(EditError::NoEdge(id))?;
            let end = other_end(id, edge, vertex)?;
            let to = draft.position(end)?;
            let (way, length, bend) = (direction(id, at, to)?, (to - at).norm(), bend_at(draft, end));
            Ok::<_, EditError>(Leg { id, edge, end, way, length, bend })
        };
        let legs = [leg(one)?, leg(other)?];
        let sweep = std::f64::consts::PI - angle_between(&legs[0].way, &legs[1].way);
        if !(STRAIGHT..=std::f64::consts::PI - STRAIGHT).contains(&sweep) {
            return Err(EditError::StraightCorner(vertex));
        }
        Ok(Self { vertex, at, legs, sweep })
    }

    /// How far from the corner an arc of radius 1 touches its edges.
    fn reach(&self) -> f64 {
        (self.sweep / 2.0).tan()
    }

    /// How long a chord of its arc is, mm, of which there are so many.
    fn chord(&self, radius: f64, count: u32) -> f64 {
        2.0 * radius * (self.sweep / f64::from(count) / 2.0).sin()
    }

    /// `reaches`: of all corners that are rounded, since an edge between two of them is shortened at both of its ends.
    fn bounds(&self, radius: f64, limits: &ChordLimits, reaches: &BTreeMap<VertexId, f64>) -> Bounds {
        let chord = limits.chord(self.sweep / 2.0);
        // At its ends the arc bends by half of what it bends between two chords.
        let far = |leg: &Leg| if reaches.contains_key(&leg.end) { leg.bend / 4.0 } else { leg.bend };
        let left = self.legs.iter().map(|leg| limits.left(self.sweep / 4.0, far(leg)));
        let left = left.fold(0.0, f64::max);
        let taken = |leg: &Leg| self.reach() + reaches.get(&leg.end).copied().unwrap_or(0.0);
        let rests = self.legs.iter().map(|leg| leg.length - radius * taken(leg));
        let largest = self.legs.iter().map(|leg| (leg.length - left) / taken(leg));
        Bounds {
            chord,
            left,
            min: chord / self.chord(1.0, 2),
            max: largest.fold(f64::INFINITY, f64::min),
            rest: rests.filter(|rest| rest.abs() >= NOTHING).fold(f64::INFINITY, f64::min),
        }
    }

    /// Into how many chords an arc is divided: at most `step` is bent at each vertex, and none is shorter than the machine can make.
    fn chords(&self, radius: f64, step: f64, limits: &ChordLimits) -> Result<u32, EditError> {
        // A step that divides the arc evenly does so in spite of rounding.
        let wanted = (self.sweep / step - 1e-9).ceil().max(2.0);
        if wanted > MAX_CHORDS {
            return Err(EditError::ArcStep(Angle::computed(step)));
        }
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // from 2 to the most
        let wanted = wanted as u32;
        let fits = |count: u32, limits: &ChordLimits| {
            self.chord(radius, count) >= limits.chord(self.sweep / f64::from(count)) - NOTHING
        };
        // Fewer chords rather than some that a check warns of.
        let clear = (2..=wanted).rev().find(|&count| fits(count, &limits.with_margin()));
        Ok(clear.or_else(|| (2..=wanted).rev().find(|&count| fits(count, limits))).unwrap_or(2))
    }

    fn round(&self, draft: &mut Draft, radius: f64, chords: u32) -> Result<(), EditError> {
        let [first, last] = &self.legs;
        let touch = radius * self.reach();
        let (begin, end) =
            (self.at + first.way.into_inner() * touch, self.at + last.way.into_inner() * touch);
        let half = first.way.into_inner() + last.way.into_inner();
        let centre = self.at + half.normalize() * (radius / (self.sweep / 2.0).cos());
        let axis = Unit::new_normalize((begin - centre).cross(&(end - centre)));
        let turned = |k: u32| {
            let turn = Rotation3::from_axis_angle(&axis, self.sweep * f64::from(k) / f64::from(chords));
            centre + turn * (begin - centre)
        };
        let ceiling = first.edge.ceiling && last.edge.ceiling;
        let mut inner = 1..chords;
        // The corner's vertex goes to the beginning of the arc, or where an end of an edge is there already, to its next vertex.
        let mut before = if first.length - touch < NOTHING {
            draft.remove_edge(first.id);
            let chord = inner.next().unwrap_or(1);
            draft.move_vertex(self.vertex, turned(chord))?;
            draft.add_edge(Edge { a: first.end, b: self.vertex, ceiling })?;
            self.vertex
        } else {
            draft.move_vertex(self.vertex, begin)?;
            self.vertex
        };
        for k in inner {
            let next = draft.add_vertex(Vertex::at(turned(k)))?;
            draft.add_edge(Edge { a: before, b: next, ceiling })?;
            before = next;
        }
        let to = if last.length - touch < NOTHING {
            draft.remove_edge(last.id);
            last.end
        } else {
            let to = draft.add_vertex(Vertex::at(end))?;
            let onto = |vertex: VertexId| if vertex == self.vertex { to } else { vertex };
            draft.set_edge(last.id, Edge { a: onto(last.edge.a), b: onto(last.edge.b), ..last.edge });
            to
        };
        draft.add_edge(Edge { a: before, b: to, ceiling })?;
        Ok(())
    }
}

/// How far the wire is bent at a vertex of two edges; 0 at any other, and where it is folded back, which has no corner.
fn bend_at(draft: &Draft, vertex: VertexId) -> f64 {
    let bend = || -> Result<f64, EditError> {
        let (one, other) = only_two(draft, vertex)?;
        let at = draft.position(vertex)?;
        let way = |id: EdgeId| {
            let edge = draft.edge(id).ok_or(EditError::NoEdge(id))?;
            direction(id, at, draft.position(other_end(id, edge, vertex)?)?)
        };
        Ok(std::f64::consts::PI - angle_between(&*way(one)?, &*way(other)?))
    };
    bend().ok().filter(|bend| *bend < std::f64::consts::PI - STRAIGHT).unwrap_or(0.0)
}
