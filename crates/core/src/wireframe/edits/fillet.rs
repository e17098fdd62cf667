//! Corners that are rounded by a radius, as chords of the arc that touches both of their edges.

use std::collections::BTreeMap;

use nalgebra::{Point3, Rotation3, Unit, Vector3};

use super::super::Vertex;
use super::super::delta::Draft;
use super::super::graph::{Edge, EdgeId, VertexId, WireframeError};
use super::exact::{angle_between, direction, only_two, other_end};
use super::{EditError, FilletFault, check_listed};
use crate::units::{Angle, Length};

/// What is shorter than a millionth of a millimetre is no edge.
const NOTHING: f64 = 1e-6;
/// Corners that are straighter, or nearer to folded back, have no arc: radians.
const STRAIGHT: f64 = 1e-6;
/// The most chords of a corner.
const MAX_CHORDS: f64 = 100_000.0;

/// What of a fillet a machine can make.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ChordLimits {
    /// The shortest edge as designed.
    pub min_edge: Length,
    /// The shortest feed, which has to be left of an edge once its arcs are taken off.
    pub min_feed: Length,
    /// Centreline radius of a bend; 0 where feeds are as designed.
    pub bend_radius: Length,
    /// Radius of the neutral fibre of a bend; 0 likewise.
    pub neutral_radius: Length,
}

impl ChordLimits {
    /// The shortest chord, mm, where the wire is bent by `bend` between two chords and by half of it at the ends of the arc, in
    /// whichever direction it runs: a feed is shorter than its edge by the tangents at both ends, and longer by the arc of one.
    fn chord(&self, bend: f64) -> f64 {
        let (radius, neutral) = (self.bend_radius.mm(), self.neutral_radius.mm());
        let (inner, end) = ((bend / 2.0).tan(), (bend / 4.0).tan());
        let lost = (2.0 * radius * inner - neutral * bend).max(radius * (inner + end) - neutral * bend / 2.0);
        self.min_edge.mm().max(self.min_feed.mm() + lost.max(0.0))
    }

    /// The shortest that may be left of an edge, mm, beside an arc with such bends.
    fn left(&self, bend: f64) -> f64 {
        self.min_edge.mm().max(self.min_feed.mm() + self.bend_radius.mm() * (bend / 4.0).tan())
    }
}

/// One of the two edges at a corner.
struct Leg {
    id: EdgeId,
    edge: Edge,
    end: VertexId,
    way: Unit<Vector3<f64>>,
    length: f64,
}

/// A corner, and what its fillet has to keep to.
struct Corner {
    vertex: VertexId,
    at: Point3<f64>,
    legs: [Leg; 2],
    /// How far the wire is bent at the corner, and so how far round the arc goes.
    sweep: f64,
}

/// Rounds corners. See `Edit::Fillet`.
pub(super) fn fillet(
    draft: &mut Draft,
    vertices: &[VertexId],
    radius: Length,
    step: Angle,
    limits: &ChordLimits,
) -> Result<(), EditError> {
    check_listed(draft, vertices)?;
    if radius <= Length::ZERO {
        return Err(EditError::FilletRadius(radius.mm()));
    }
    if step <= Angle::ZERO || step > Angle::HALF_TURN {
        return Err(EditError::ArcStep(step));
    }
    let corners = vertices.iter().map(|&vertex| Corner::of(draft, vertex)).collect::<Result<Vec<_>, _>>()?;
    let reaches = corners.iter().map(|corner| (corner.vertex, corner.reach())).collect();
    let chords = corners.iter().map(|corner| corner.chords(radius.mm(), step.rad(), limits, &reaches));
    let chords = chords.collect::<Result<Vec<_>, _>>()?;
    for (&vertex, chords) in vertices.iter().zip(chords) {
        // As those before it have left its edges.
        Corner::of(draft, vertex)?.round(draft, radius.mm(), chords)?;
    }
    Ok(())
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
            Ok::<_, EditError>(Leg { id, edge, end, way: direction(id, at, to)?, length: (to - at).norm() })
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

    /// Into how many chords an arc is divided: at most `step` is bent at each vertex, and none is shorter than the machine can make.
    /// `reaches`: of all corners that are rounded, since an edge between two of them is shortened at both of its ends.
    fn chords(
        &self,
        radius: f64,
        step: f64,
        limits: &ChordLimits,
        reaches: &BTreeMap<VertexId, f64>,
    ) -> Result<u32, EditError> {
        let taken = |leg: &Leg| self.reach() + reaches.get(&leg.end).copied().unwrap_or(0.0);
        let left = |leg: &Leg| leg.length - radius * taken(leg);
        // Of two chords, which have the largest bends.
        let (min_chord, min_left) = (limits.chord(self.sweep / 2.0), limits.left(self.sweep / 2.0));
        // What nothing is left of is no edge that could be too short.
        let room = |leg: &Leg| left(leg).abs() < NOTHING || left(leg) >= min_left - NOTHING;
        let min = min_chord / (2.0 * (self.sweep / 4.0).sin());
        let fits = self.legs.iter().map(|leg| (leg.length - min_left) / taken(leg));
        let max = fits.fold(f64::INFINITY, f64::min);
        let short = radius < min - NOTHING;
        if short || !self.legs.iter().all(room) {
            // A figure that is written with a digit behind the point is one that can be made.
            let (up, down) = ((min * 10.0 - NOTHING).ceil() / 10.0, (max * 10.0 + NOTHING).floor() / 10.0);
            let nearest = (up <= down && down > 0.0).then(|| Length::computed(if short { up } else { down }));
            let (min_edge, fault) =
                if short { (min_chord, FilletFault::Chords) } else { (min_left, FilletFault::Edges) };
            return Err(EditError::Fillet {
                vertex: self.vertex,
                radius: Length::computed(radius),
                min_edge: Length::computed(min_edge),
                fault,
                nearest,
            });
        }
        // A step that divides the arc evenly does so in spite of rounding.
        let wanted = (self.sweep / step - 1e-9).ceil().max(2.0);
        if wanted > MAX_CHORDS {
            return Err(EditError::ArcStep(Angle::computed(step)));
        }
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // from 2 to the most
        let wanted = wanted as u32;
        let fits = |count: u32| {
            let bend = self.sweep / f64::from(count);
            2.0 * radius * (bend / 2.0).sin() >= limits.chord(bend) - NOTHING
        };
        Ok((2..=wanted).rev().find(|&count| fits(count)).unwrap_or(2))
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
