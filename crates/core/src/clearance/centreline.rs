//! The centreline of a bent wire: straight parts, and arcs around the pin.

use nalgebra::{Point3, UnitQuaternion};
use wirebend_collide::{Chain, Interval};

use crate::bend::{Frame, Step};
use crate::units::{Angle, Length};

/// A bend beyond this has no corner that could be rounded.
const FOLDED: f64 = 3.12;

/// A bent wire as a chain in the frame of the design.
#[derive(Debug, Clone)]
pub(super) struct Centreline {
    pub chain: Chain,
    /// For each step.
    pub legs: Vec<Leg>,
}

/// What a step adds to the wire.
#[derive(Debug, Clone, Copy)]
pub(super) struct Leg {
    /// The straight part, as lengths along the chain.
    pub straight: Interval,
    /// Where the straight part begins, in the frame of the design.
    pub begin: Point3<f64>,
    /// Centreline radius of the bend at its end, mm: less where arcs would overlap.
    pub radius: f64,
    /// The length of its arc, mm.
    pub arc: f64,
}

impl Leg {
    /// How far it is fed, mm.
    pub fn fed(&self) -> f64 {
        self.straight.to - self.straight.from + self.arc
    }
}

impl Centreline {
    /// The wire of steps from corner to corner. `radius`: of the bends; `tolerance`: how far a chord may be from its arc, mm; `longest`:
    /// how long a piece of a straight part may be, mm.
    pub fn new(start: Frame, steps: &[Step], radius: Length, tolerance: f64, longest: f64) -> Self {
        let tangents = tangents(steps, radius.mm());
        let mut frame = start;
        let mut points = vec![start.position];
        let mut marks = Vec::with_capacity(steps.len());
        let mut before = 0.0;
        for (step, &tangent) in steps.iter().zip(&tangents) {
            let (t, corner) = (frame.t(), frame.position + frame.t() * step.feed.mm());
            let begin = points.len() - 1;
            if step.feed.mm() > before + tangent {
                add_straight(&mut points, corner - t * tangent, longest);
            }
            let straight_end = points.len() - 1;
            frame.position = corner;
            frame.rotate(step.rotate);
            let (size, bent) = (step.bend.abs().rad(), tangent > 0.0);
            let radius = if bent { tangent / (size / 2.0).tan() } else { 0.0 };
            if bent {
                add_arc(&mut points, &frame, step.bend, radius, tolerance);
            }
            frame.bend(step.bend);
            marks.push((begin, straight_end, radius, radius * size));
            before = tangent;
        }
        let chain = Chain::new(points);
        let leg = |(begin, end, radius, arc): (usize, usize, f64, f64)| Leg {
            straight: Interval { from: chain.along()[begin], to: chain.along()[end] },
            begin: chain.points()[begin],
            radius,
            arc,
        };
        let legs = marks.into_iter().map(leg).collect();
        Self { chain, legs }
    }
}

/// For each step how far its arc begins before its corner, mm: as the radius wants, or as much as there is room for.
fn tangents(steps: &[Step], radius: f64) -> Vec<f64> {
    let wanted: Vec<f64> = steps
        .iter()
        .map(|step| {
            let size = step.bend.abs().rad();
            if size < FOLDED { radius * (size / 2.0).tan() } else { 0.0 }
        })
        .collect();
    // Two arcs that share a straight part which is too short get parts of it as they want them.
    let room = |k: usize| {
        let before = k.checked_sub(1).map_or(0.0, |before| wanted[before]);
        let both = before + wanted[k];
        if both > 0.0 { (steps[k].feed.mm().max(0.0) / both).min(1.0) } else { 1.0 }
    };
    let share: Vec<f64> = (0..steps.len()).map(room).collect();
    let least = |k: usize| share[k].min(share.get(k + 1).copied().unwrap_or(1.0));
    wanted.iter().enumerate().map(|(k, tangent)| tangent * least(k)).collect()
}

/// Adds the points of a straight part.
fn add_straight(points: &mut Vec<Point3<f64>>, to: Point3<f64>, longest: f64) {
    let from = points.last().copied().unwrap_or(to);
    let pieces = ((to - from).norm() / longest).ceil().max(1.0);
    points.extend((1..=whole(pieces)).map(|k| from + (to - from) * (f64::from(k) / pieces)));
}

/// Adds the points of the arc at the corner where `frame` is, turned for the bend.
fn add_arc(points: &mut Vec<Point3<f64>>, frame: &Frame, bend: Angle, radius: f64, tolerance: f64) {
    let (size, side) = (bend.abs().rad(), bend.signum());
    let tangent = radius * (size / 2.0).tan();
    let (t, n) = (frame.t(), frame.n() * side);
    let begin = frame.position - t * tangent;
    // The rise of a chord: r (1 - cos(half its angle)).
    let widest = 2.0 * (1.0 - (tolerance / radius).min(1.0)).acos();
    let chords = (size / widest).ceil().max(1.0);
    for k in 1..=whole(chords) {
        let turned = size * f64::from(k) / chords;
        points.push(begin + t * (radius * turned.sin()) + n * (radius * (1.0 - turned.cos())));
    }
}

#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // it is whole, positive and small
fn whole(count: f64) -> u32 {
    count as u32
}

/// How the wire lies in the machine while a step feeds: what turns the frame of the design, and the point of the wire that is
/// at the bend point when the step begins.
#[derive(Debug, Clone, Copy)]
pub(super) struct Lie {
    pub turn: UnitQuaternion<f64>,
    pub begin: Point3<f64>,
}
