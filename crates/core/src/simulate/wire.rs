//! One wire, as a program whose motions are off bends it.

use nalgebra::{Point3, Vector3};
use rand::{RngExt as _, SeedableRng as _};
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution as _, StandardNormal};

use super::{ErrorModel, ErrorSource, SimulationInput};
use crate::bend::{Frame, Step};
use crate::compensate::{Compensation, ToldStep, is_turn, with_bend_before};
use crate::units::{Angle, Length};

/// A wire as a program makes it when its motions are off.
#[derive(Debug, Clone, PartialEq)]
pub struct ImperfectWire {
    /// Its vertices in mm, in the order of the route; the first is where it starts.
    pub points: Vec<Point3<f64>>,
    /// The steps that it is made of, from corner to corner: a bowed strut counts with the distance of its ends.
    pub steps: Vec<Step>,
    /// The commands, each bend as far off as the bend that it leaves: where the bend axis goes.
    pub told: Vec<ToldStep>,
}

/// The errors of one wire.
pub(super) struct Draw<'a> {
    errors: &'a ErrorModel,
    random: ChaCha8Rng,
}

impl<'a> Draw<'a> {
    /// Those of the wire with this number: the same whatever other wires are drawn, and in which order.
    pub fn new(errors: &'a ErrorModel, seed: u64, wire: u32) -> Self {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        random.set_stream(u64::from(wire));
        Self { errors, random }
    }

    fn error(&mut self, of: ErrorSource) -> f64 {
        self.error_with(of, 1.0)
    }

    /// The same with its constant part to a side: 1 or -1.
    fn error_with(&mut self, of: ErrorSource, side: f64) -> f64 {
        let normal: f64 = StandardNormal.sample(&mut self.random);
        let term = self.errors.term(of);
        term.sigma.mul_add(normal, term.bias * side)
    }

    /// To which side a bow goes, as an angle about the strut.
    fn side(&mut self) -> f64 {
        self.random.random_range(0.0..std::f64::consts::TAU)
    }
}

/// Turns fed lengths between formed bends into lengths from corner to corner.
pub(super) fn corner_to_corner(steps: &[Step], compensation: &Compensation) -> Vec<Step> {
    let Some(model) = &compensation.feed else {
        return steps.to_vec();
    };
    let with_before = with_bend_before(steps);
    with_before
        .map(|(before, step)| Step { feed: model.segment_of(step.feed, before, step.bend), ..*step })
        .collect()
}

/// Of each step whether a rotation before its bend is part of the shape, and so can be off: what the head has turned since the bend
/// before. Before the first bend it turns the wire as a whole.
pub(super) fn rotations_made(formed: &[Step]) -> Vec<bool> {
    let mut since: Option<Angle> = None;
    let made = formed.iter().map(|step| {
        since = since.map(|since| since + step.rotate);
        if step.bend == Angle::ZERO {
            return false;
        }
        since.replace(Angle::ZERO).is_some_and(is_turn)
    });
    made.collect()
}

/// One wire. `formed`: what its commands leave where nothing is off.
///
/// Vertices on a straight feed divide it as `fractions` says: for each step the parts of its feed at
/// which a vertex of the route lies, ending with 1. The first vertex is that of `start`.
pub(super) fn imperfect(input: &SimulationInput, formed: &[Step], draw: &mut Draw) -> ImperfectWire {
    let mut told: Vec<ToldStep> = input.program.told().collect();
    let rotations_made = rotations_made(formed);
    let disturbed: Vec<Step> = told
        .iter_mut()
        .zip(formed)
        .enumerate()
        .map(|(index, (told, formed))| {
            let is_bend = formed.bend != Angle::ZERO;
            let feed = formed.feed + Length::computed(draw.error(ErrorSource::Feed));
            let mut off = |of, side: f64| {
                if is_bend { Angle::computed(draw.error_with(of, side).to_radians()) } else { Angle::ZERO }
            };
            // Drawn for every bend, so that what is drawn after it does not depend on it.
            let turned = off(ErrorSource::Rotation, 1.0);
            let rotate = if rotations_made[index] { formed.rotate + turned } else { formed.rotate };
            // What is constant bends farther, to whichever side.
            let wrong = off(ErrorSource::Bend, formed.bend.signum());
            let side = told.side();
            told.step.bend += wrong;
            // An error does not make it a bend to the other side.
            if told.side() * side < 0.0 {
                told.approach = input.program.peg_comes_out(index);
            }
            Step { feed, rotate, bend: formed.bend + wrong }
        })
        .collect();
    let mut frame = input.start;
    let mut points = Vec::with_capacity(input.design.len());
    points.push(frame.position);
    let mut steps = corner_to_corner(&disturbed, input.compensation);
    for (step, fractions) in steps.iter_mut().zip(input.fractions) {
        let bow = Bow(draw.error(ErrorSource::Curvature));
        step.feed = Length::computed(step.feed.mm() * bow.chord_over_arc());
        let from = frame.position;
        if let [inner @ .., _] = fractions.as_slice()
            && !inner.is_empty()
        {
            let side = across(&frame, draw.side());
            points.extend(inner.iter().map(|&fraction| {
                let [along, aside] = bow.place(fraction);
                from + (frame.t() * along + side * aside) * step.feed.mm()
            }));
        }
        frame.position = from + frame.t() * step.feed.mm();
        points.push(frame.position);
        frame.rotate(step.rotate);
        frame.bend(step.bend);
    }
    ImperfectWire { points, steps, told }
}

/// A direction across the wire.
fn across(frame: &Frame, angle: f64) -> Vector3<f64> {
    let (sin, cos) = angle.sin_cos();
    frame.n() * cos + frame.b() * sin
}

/// The bow of a strut: the rise of its arc over the distance of its ends.
#[derive(Debug, Clone, Copy)]
pub(super) struct Bow(pub f64);

/// An arc of fewer radians is straight.
const STRAIGHT: f64 = 4e-6;

impl Bow {
    /// What the arc turns by from end to end.
    fn angle(self) -> f64 {
        4.0 * (2.0 * self.0).atan()
    }

    /// The distance of the ends over the length.
    pub fn chord_over_arc(self) -> f64 {
        let half = self.angle() / 2.0;
        if half.abs() < STRAIGHT / 2.0 { 1.0 } else { half.sin() / half }
    }

    /// Where a part of the length ends: along the line between the ends and aside from it, as parts of their distance.
    pub fn place(self, fraction: f64) -> [f64; 2] {
        let angle = self.angle();
        if angle.abs() < STRAIGHT {
            return [fraction, 4.0 * self.0 * fraction * (1.0 - fraction)];
        }
        let (half, here) = (angle / 2.0, angle * (fraction - 0.5));
        [f64::midpoint(here.sin() / half.sin(), 1.0), (here.cos() - half.cos()) / (2.0 * half.sin())]
    }
}
