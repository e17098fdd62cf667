//! A wire in a machine.

use nalgebra::{Isometry3, Translation3, UnitQuaternion, Vector3};
use wirebend_collide::{Interval, Solid};

use super::body::{Bodies, Body, MovesWith};
use super::centreline::{Centreline, Lie};
use super::contact::Obstacle;
use super::hang::Hanging;
use super::rooms::Rooms;
use super::stroke::{Moves, StepRun};
use super::zone::{Laid, Passage, Passed};
use crate::bend::{Frame, Step};
use crate::compensate::BendModel;
use crate::estimate::WireModel;
use crate::motion::poses;
use crate::units::{Angle, Length};

/// How far a chord may be from the arc that it stands for, mm.
const CHORD: f64 = 0.0025;
/// What hangs is straight for so long at most, mm.
const HANGING_PIECE: f64 = 25.0;

/// The wire that runs through the machine.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StockWire {
    /// Its diameter.
    pub diameter: Length,
    /// Centreline radius of its bends.
    pub bend_radius: Length,
    /// What is not fed.
    pub tail: Length,
    /// How far from each other things have to stay besides.
    pub margin: Length,
    /// What it is, where it hangs as its own weight makes it; none where it keeps the shape to which it is bent.
    pub hangs: Option<WireModel>,
}

/// A wire in a machine, whose steps are asked about one by one.
#[derive(Debug, Clone)]
pub struct Clearance<'a> {
    pub(super) bodies: &'a Bodies,
    pub(super) bend: &'a BendModel,
    pub(super) wire: StockWire,
    pub(super) centreline: Centreline,
    pub(super) hanging: Option<Hanging>,
    pub(super) passed: Passed,
    steps: Vec<Step>,
    told: Vec<Angle>,
    approaches: Vec<Option<Angle>>,
    pub(super) lies: Vec<Lie>,
    /// Of each body.
    pub(super) rooms: Vec<Rooms>,
    /// Before each step, and after the last.
    heads: Vec<Angle>,
    pub(super) stock: Vec<Body>,
    /// What the wire has met in the last step that was asked about.
    pub(super) met: Vec<Obstacle>,
}

impl<'a> Clearance<'a> {
    /// The wire of `steps`, which begin at `start`: as scheduled, from corner to corner. `told`: where the bend axis goes in
    /// each; without it where it would go. `passages`: the edges of each step, with their lengths; none where nobody knows.
    #[must_use]
    pub fn new(
        (start, steps): (Frame, &[Step]),
        told: Option<&[Step]>,
        passages: Vec<Vec<(Passage, Length)>>,
        wire: StockWire,
        bodies: &'a Bodies,
        bend: &'a BendModel,
    ) -> Self {
        let longest = if wire.hangs.is_some() { HANGING_PIECE } else { f64::INFINITY };
        let centreline = Centreline::new(start, steps, wire.bend_radius, CHORD, longest);
        let lies = poses(start, steps)
            .iter()
            .zip(&centreline.legs)
            .map(|(pose, leg)| Lie { turn: pose.turn, begin: leg.begin })
            .collect();
        let mut heads = vec![Angle::ZERO];
        let mut head = Angle::ZERO;
        for step in steps {
            head -= step.rotate;
            heads.push(head);
        }
        let axis = |step: &Step| bend.command(step.bend).unwrap_or(step.bend);
        let told = told.map_or_else(
            || steps.iter().map(axis).collect(),
            |told| told.iter().map(|step| step.bend).collect(),
        );
        let passed = Passed::new(passages.into_iter().zip(laid(&centreline, (start, steps))));
        let whole: f64 = centreline.legs.iter().map(super::centreline::Leg::fed).sum();
        let mut fed = 0.0;
        let stock = centreline
            .legs
            .iter()
            .map(|leg| {
                fed += leg.fed();
                stock_after(whole - fed + wire.tail.mm(), wire.diameter.mm() / 2.0)
            })
            .collect();
        let steps = steps.to_vec();
        let rooms = bodies.all.iter().map(|body| Rooms::new(body, bodies)).collect();
        Self {
            rooms,
            bodies,
            bend,
            wire,
            hanging: wire.hangs.and_then(|wire| Hanging::new(&centreline, &wire)),
            centreline,
            passed,
            approaches: vec![None; steps.len()],
            steps,
            told,
            lies,
            heads,
            stock,
            met: Vec::new(),
        }
    }

    /// The same with where the peg comes out in each step, where that is beyond its place for straight wire.
    #[must_use]
    pub fn with_approaches(mut self, approaches: Vec<Option<Angle>>) -> Self {
        self.approaches = approaches;
        self
    }

    /// How many steps there are.
    #[must_use]
    pub fn steps(&self) -> usize {
        self.steps.len()
    }

    pub(super) fn moves(&self, step: usize) -> Option<Moves> {
        let run =
            StepRun { head: [self.heads[step], self.heads[step + 1]], bend: self.steps.get(step)?.bend };
        let told = self.told.get(step).copied().unwrap_or(run.bend);
        let moves = self.moves_of(step, &run, told)?;
        Some(Moves { approach: self.approaches.get(step).copied().flatten(), ..moves })
    }

    /// `told`: where the bend axis goes.
    pub(super) fn moves_of(&self, step: usize, run: &StepRun, told: Angle) -> Option<Moves> {
        let StepRun { head, bend } = *run;
        let leg = self.centreline.legs.get(step)?;
        let springback = self.bend.springback.as_ref();
        let pressed = springback.map_or(bend, |springback| springback.bend_to(bend)).abs();
        Some(Moves {
            lie: self.lies[step],
            radius: leg.radius,
            fed: leg.fed(),
            head,
            bend,
            pressed: if bend == Angle::ZERO { bend } else { pressed },
            told,
            approach: None,
        })
    }
}

/// Where the straight part of each leg lies, up to the middle of the arcs on both sides.
fn laid<'c>(
    centreline: &'c Centreline,
    (mut frame, steps): (Frame, &'c [Step]),
) -> impl Iterator<Item = Laid> + 'c {
    let (mut from, mut arc_before) = (0.0, 0.0);
    centreline.legs.iter().zip(steps).map(move |(leg, step)| {
        let (begin, arc) = (frame.position, leg.arc / 2.0);
        frame.feed(step.feed);
        let part = Interval { from, to: leg.straight.to + arc };
        let laid = Laid { part, arcs: [arc_before, arc], corners: [begin, frame.position] };
        frame.rotate(step.rotate);
        frame.bend(step.bend);
        (from, arc_before) = (part.to, arc);
        laid
    })
}

/// The wire that is still to come: a rod along -x, with its end at the bend point.
fn stock_after(length: f64, radius: f64) -> Body {
    let half_length = (length / 2.0).max(0.0);
    let lie = UnitQuaternion::from_axis_angle(&Vector3::y_axis(), std::f64::consts::FRAC_PI_2);
    Body {
        name: String::new(),
        moves_with: MovesWith::Frame,
        solid: Solid::Capsule { radius, half_length },
        at: Isometry3::from_parts(Translation3::new(-half_length, 0.0, 0.0), lie),
        contact_zone: Length::ZERO,
        vertex_zone: Length::ZERO,
        entry: String::new(),
        source: String::new(),
        measured: true,
    }
}
