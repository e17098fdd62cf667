//! A bender for the tests of this module.

use nalgebra::{Point3, Rotation3, Unit, Vector3};

use super::Phase;
use crate::bend::Step;

/// Centreline radius of its bends, mm.
pub(super) const RADIUS: f64 = 3.0;

/// A bender that knows only pushing, turning and winding around a pin, and the wire as points 1 mm apart.
pub(super) struct Bender {
    /// Where each point is, the last one at the bend point.
    pub points: Vec<Point3<f64>>,
    pub head: f64,
    pub bends_before: f64,
}

/// How far a bend winds at a time, radians: 0.2°.
const WIND: f64 = 0.000_872_664_6 * 4.0;

impl Bender {
    /// Runs a step; `see` is told of every state: the phase, how far it has come, the points of the rigid part, the head.
    pub fn run(&mut self, step: &Step, pressed: f64, see: &mut impl FnMut(Phase, f64, &[Point3<f64>], f64)) {
        let size = step.bend.abs().rad();
        let corner = |bend: f64| RADIUS * (bend / 2.0).tan();
        let fed = step.feed.mm() - corner(self.bends_before) - corner(size) + RADIUS * size;
        let old = self.points.len();
        let begin = self.points.clone();
        let slices = (fed / 0.1).ceil();
        let mut slice = 0.0;
        while slice <= slices {
            let by = fed * slice / slices;
            self.points = begin.iter().map(|at| at + Vector3::x() * by).collect();
            see(Phase::Feed, slice / slices, &self.points, self.head);
            slice += 1.0;
        }
        let mut along = fed.floor();
        while along >= 0.0 {
            self.points.push(Point3::new(along, 0.0, 0.0));
            along -= 1.0;
        }
        debug_assert!(self.points.len() > old);
        let from = self.head;
        let turns = (step.rotate.rad().abs() / WIND).ceil();
        let mut turn = 1.0;
        while turn <= turns {
            self.head = from - step.rotate.rad() * turn / turns;
            let rigid = self.points.len();
            see(Phase::Rotate, turn / turns, &self.points[..rigid], self.head);
            turn += 1.0;
        }
        if size > 0.0 {
            self.wind(step.bend.signum(), pressed, Phase::Bend, see);
            self.unwind(step.bend.signum(), pressed, size);
            self.wound(step.bend.signum(), size);
        }
        self.bends_before = size;
    }

    fn wind(
        &mut self,
        side: f64,
        to: f64,
        phase: Phase,
        see: &mut impl FnMut(Phase, f64, &[Point3<f64>], f64),
    ) {
        let parts = (to / WIND).ceil();
        let before: Vec<f64> = self.points.iter().map(|at| at.x).collect();
        let was = self.points.clone();
        let mut part = 0.0;
        while part < parts {
            let (bent, by) = (to * (part + 0.5) / parts, to / parts);
            self.turn(side, bent, by);
            part += 1.0;
            see(phase, part / parts, &self.points, self.head);
        }
        // What was on the x axis within the arc is wound around the pin: it is not rigid, and nothing is asked about it.
        for ((at, &x), was) in self.points.iter_mut().zip(&before).zip(&was) {
            if was.y.abs() < 1e-9 && was.z.abs() < 1e-9 && x < RADIUS * to {
                *at = Point3::new(f64::NAN, 0.0, 0.0);
            }
        }
        self.points.retain(|at| !at.x.is_nan());
    }

    fn unwind(&mut self, side: f64, from: f64, to: f64) {
        let parts = ((from - to) / WIND).ceil();
        let mut part = 0.0;
        while part < parts {
            let bent = from - (from - to) * (part + 0.5) / parts;
            self.turn(side, bent, -(from - to) / parts);
            part += 1.0;
        }
    }

    /// What was wound around the pin is rigid from now on.
    fn wound(&mut self, side: f64, bent: f64) {
        let parts = (bent * RADIUS).ceil();
        let mut part = parts;
        while part >= 0.0 {
            self.points.push(self.on_pin(side, bent * part / parts));
            part -= 1.0;
        }
    }

    /// Where the wire leaves the pin when it is bent so far.
    fn on_pin(&self, side: f64, bent: f64) -> Point3<f64> {
        let across = Rotation3::from_axis_angle(&Vector3::x_axis(), self.head) * Vector3::y() * side;
        Point3::from(Vector3::x() * (RADIUS * bent.sin()) + across * (RADIUS * (1.0 - bent.cos())))
    }

    fn turn(&mut self, side: f64, bent: f64, by: f64) {
        let axis = Rotation3::from_axis_angle(&Vector3::x_axis(), self.head) * Vector3::z();
        let axis = Unit::new_normalize(axis);
        let about = self.on_pin(side, bent);
        let turn = Rotation3::from_axis_angle(&axis, side * by);
        for at in &mut self.points {
            *at = about + turn * (*at - about);
        }
    }
}
