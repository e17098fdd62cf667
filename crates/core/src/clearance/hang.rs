//! The shapes that the wire takes under its own weight while a step runs.

use nalgebra::{UnitQuaternion, Vector3};
use wirebend_collide::Chain;

use super::centreline::{Centreline, Leg};
use super::stroke::{Phase, State, Stroke};
use crate::estimate::WireModel;
use crate::motion::bend_axis;
use crate::sag::{HangingWire, down};
use crate::units::Angle;

/// A shape is so near to what the wire is like at any moment for which it stands, mm, or by this share of what it sags.
const EXACT: f64 = 0.1;
const SHARE: f64 = 0.02;
/// A motion is halved so many times at most: what sags by so much that it does not help is only indicated.
const HALVINGS: u32 = 7;

/// How far each point of the part already bent is moved, mm.
type Moved = Vec<Vector3<f64>>;

/// The wire of a program as its weight makes it hang.
#[derive(Debug, Clone)]
pub(super) struct Hanging(HangingWire);

/// A part of a stroke, and what the wire is like meanwhile.
#[derive(Debug, Clone)]
pub(super) struct Slice {
    /// From when to when, of the stroke's time from 0 to 1.
    pub times: [f64; 2],
    pub chain: Chain,
    /// How far the wire may be from there, mm.
    pub spread: f64,
}

impl Slice {
    /// The part of the stroke.
    pub fn of(&self, stroke: &Stroke) -> Stroke {
        let [from, to] = self.times.map(|time| stroke.at(time));
        Stroke { from, to, ..*stroke }
    }

    /// A time of that part as one of the whole stroke.
    pub fn time(&self, time: f64) -> f64 {
        self.times[0] + (self.times[1] - self.times[0]) * time
    }
}

impl Hanging {
    /// None where the wire has no stiffness.
    pub fn new(centreline: &Centreline, wire: &WireModel) -> Option<Self> {
        HangingWire::new(centreline.chain.points().to_vec(), wire).map(Self)
    }

    /// The shapes of a stroke, in order.
    pub fn slices(&self, chain: &Chain, leg: &Leg, stroke: &Stroke) -> Vec<Slice> {
        let ends = [0.0, 1.0].map(|time| (time, self.moved(chain, leg, stroke, time)));
        let mut slices = Vec::new();
        self.slice((chain, leg, stroke), [&ends[0], &ends[1]], HALVINGS, &mut slices);
        slices
    }

    /// Adds the shapes from one time to another, at which the wire is moved so. It is halved so many times at most.
    fn slice(
        &self,
        (chain, leg, stroke): (&Chain, &Leg, &Stroke),
        [from, to]: [&(f64, Moved); 2],
        halvings: u32,
        slices: &mut Vec<Slice>,
    ) {
        let time = f64::midpoint(from.0, to.0);
        let middle = (time, self.moved(chain, leg, stroke, time));
        let apart = |other: &Moved| {
            middle.1.iter().zip(other).map(|(one, other)| (one - other).norm()).fold(0.0, f64::max)
        };
        let spread = apart(&from.1).max(apart(&to.1));
        let most = middle.1.iter().map(Vector3::norm).fold(0.0, f64::max);
        if let Some(halvings) = halvings.checked_sub(1).filter(|_| spread > EXACT.max(SHARE * most)) {
            for ends in [[from, &middle], [&middle, to]] {
                self.slice((chain, leg, stroke), ends, halvings, slices);
            }
            return;
        }
        let points = chain.points().iter().zip(&middle.1).map(|(point, moved)| point + moved).collect();
        slices.push(Slice { times: [from.0, to.0], chain: chain.moved(points), spread });
    }

    /// How far each point of the part already bent is moved at a time of a stroke, in the frame of the design.
    fn moved(&self, chain: &Chain, leg: &Leg, stroke: &Stroke, time: f64) -> Moved {
        let state = stroke.at(time);
        let feeds = stroke.phase == Phase::Feed;
        let along = if feeds { leg.straight.from } else { leg.straight.to };
        let last = chain.along().partition_point(|&at| at <= along).saturating_sub(1);
        // The machine holds it at the bend point: beyond, where the wire that is being fed goes on, or its arc begins.
        let beyond = if feeds { state.fed } else { leg.arc };
        let held = self.0.held_beyond(last, stroke.lie.turn.inverse() * -Vector3::x() * beyond);
        let down = down(&turn(stroke, &state));
        (0..=last).map(|point| self.0.displacement(point, &held, &down)).collect()
    }
}

/// From the frame of the design to that of the machine.
fn turn(stroke: &Stroke, state: &State) -> UnitQuaternion<f64> {
    let axis = bend_axis(Angle::computed(state.head));
    UnitQuaternion::from_axis_angle(&axis, stroke.side * state.bent) * stroke.lie.turn
}
