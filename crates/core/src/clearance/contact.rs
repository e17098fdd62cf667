//! Contacts of a program.

use nalgebra::{Isometry3, Translation3, UnitQuaternion, Vector3};
use wirebend_collide::{Interval, Meeting, Solid, Task, closest, first_contact};

use super::body::{Bodies, Body, MovesWith};
use super::centreline::{Centreline, Lie};
use super::stroke::{Moves, Phase, Seen, Stroke, strokes};
use super::zone::{Passage, Passed, Touch};
use crate::bend::{Frame, Step};
use crate::compensate::BendModel;
use crate::motion::poses;
use crate::units::{Angle, Length};

/// How far a chord may be from the arc that it stands for, mm.
const CHORD: f64 = 0.005;
/// How exact distances are, mm.
const EXACT: f64 = 0.005;

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
}

/// What the wire meets.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Obstacle {
    /// A body of the machine, by its index.
    Body(usize),
    /// The wire that is still to be bent.
    Stock,
}

/// Where the wire already bent meets something.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contact {
    /// Index of the step, from 0.
    pub step: usize,
    /// What moves.
    pub phase: Phase,
    /// The part of the phase that has passed, from 0 to 1.
    pub passed: f64,
    /// How much of the step is fed by then.
    pub fed: Length,
    /// Where the head is, right-handed about +x of the machine.
    pub head: Angle,
    /// How far the wire is bent, signed as the step's bend.
    pub bent: Angle,
    /// What it meets.
    pub obstacle: Obstacle,
    /// Index of the step that has made the part of the wire that meets it.
    pub leg: usize,
    /// Where on the wire it is, as the length from its start.
    pub along: Length,
    /// How far they are into each other at the worst of the step, the margin included.
    pub depth: Length,
}

/// A wire in a machine, whose steps are asked about one by one.
#[derive(Debug, Clone)]
pub struct Clearance<'a> {
    bodies: &'a Bodies,
    bend: &'a BendModel,
    wire: StockWire,
    centreline: Centreline,
    passed: Passed,
    steps: Vec<Step>,
    told: Vec<Angle>,
    lies: Vec<(Lie, nalgebra::UnitVector3<f64>)>,
    /// Before each step, and after the last.
    heads: Vec<Angle>,
    stock: Vec<Body>,
    /// What the wire has met in the last step that was asked about.
    met: Vec<Obstacle>,
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
        let centreline = Centreline::new(start, steps, wire.bend_radius, CHORD);
        let lies = poses(start, steps)
            .iter()
            .zip(&centreline.legs)
            .map(|(pose, leg)| (Lie { turn: pose.turn, begin: leg.begin }, pose.bend_axis))
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
        let passed = Passed::new(passages.into_iter().zip(corners(&centreline)));
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
        Self { bodies, bend, wire, centreline, passed, steps, told, lies, heads, stock, met: Vec::new() }
    }

    /// How many steps there are.
    #[must_use]
    pub fn steps(&self) -> usize {
        self.steps.len()
    }

    /// What the wire begins to meet in a step; the steps are asked for in order. One contact for each thing that it meets.
    pub fn contacts_of(&mut self, step: usize) -> Vec<Contact> {
        let Some(strokes) = self.strokes(step) else { return Vec::new() };
        let stock = &self.stock[step];
        let all = self.bodies.all.iter().enumerate().map(|(index, body)| (Obstacle::Body(index), body));
        let mut found = Vec::new();
        let mut met = Vec::new();
        for (obstacle, body) in all.chain([(Obstacle::Stock, stock)]) {
            let mut moving = strokes.iter().filter(|stroke| stroke.moves(body.moves_with));
            let first = moving
                .find_map(|stroke| Some((stroke, self.meet(step, stroke, obstacle, body, first_contact)?)));
            let Some((stroke, meeting)) = first else { continue };
            met.push(obstacle);
            let goes_on = stroke.phase == Phase::Feed && meeting.time <= 0.0;
            if !(goes_on && self.met.contains(&obstacle)) {
                found.push(self.contact(step, (stroke, meeting), obstacle, body, &strokes));
            }
        }
        self.met = met;
        found.sort_by(|one, other| one.phase.cmp(&other.phase).then(one.passed.total_cmp(&other.passed)));
        found
    }

    fn strokes(&self, step: usize) -> Option<Vec<Stroke>> {
        let (leg, bend) = (self.centreline.legs.get(step)?, self.steps[step].bend);
        let (lie, bend_axis) = self.lies[step];
        let springback = self.bend.springback.as_ref();
        let pressed = springback.map_or(bend, |springback| springback.bend_to(bend)).abs();
        let moves = Moves {
            lie,
            bend_axis,
            radius: leg.radius,
            fed: leg.fed(),
            head: [self.heads[step], self.heads[step + 1]],
            bend,
            pressed: if bend == Angle::ZERO { bend } else { pressed },
            told: self.told.get(step).copied().unwrap_or(bend),
        };
        Some(strokes(&moves, self.bodies, self.bend.setback.as_ref()))
    }

    /// Asks about one body in one stroke.
    fn meet(
        &self,
        step: usize,
        stroke: &Stroke,
        obstacle: Obstacle,
        body: &Body,
        ask: fn(&Task) -> Option<Meeting>,
    ) -> Option<Meeting> {
        let leg = &self.centreline.legs[step];
        let out = if stroke.phase == Phase::Feed { leg.straight.from } else { leg.straight.to };
        let touch = match obstacle {
            Obstacle::Stock => Touch::Stock,
            Obstacle::Body(_) => Touch::Body(body.contact_zone.mm()),
        };
        let parts = self.passed.counting(step, stroke.phase, touch, out);
        let motion = Seen::new(stroke, body, self.bodies.pivot);
        let reach = self.wire.diameter.mm() / 2.0 + self.wire.margin.mm();
        let chain = &self.centreline.chain;
        ask(&Task { chain, parts: &parts, solid: &body.solid, motion: &motion, reach, tolerance: EXACT })
    }

    fn contact(
        &self,
        step: usize,
        (stroke, meeting): (&Stroke, Meeting),
        obstacle: Obstacle,
        body: &Body,
        strokes: &[Stroke],
    ) -> Contact {
        let state = stroke.at(meeting.time);
        let moving = strokes.iter().filter(|stroke| stroke.moves(body.moves_with));
        let nearest = moving.filter_map(|stroke| self.meet(step, stroke, obstacle, body, closest));
        let least = nearest.map(|meeting| meeting.distance).fold(meeting.distance, f64::min);
        let reach = self.wire.diameter.mm() / 2.0 + self.wire.margin.mm();
        let legs = &self.centreline.legs;
        let leg = legs.partition_point(|leg| leg.straight.to + leg.arc / 2.0 < meeting.along).min(step);
        Contact {
            step,
            phase: stroke.phase,
            passed: passed_of(stroke, strokes, meeting.time),
            fed: Length::computed(state.fed),
            head: Angle::computed(state.head),
            bent: Angle::computed(stroke.side * state.bent),
            obstacle,
            leg,
            along: Length::computed(meeting.along),
            depth: Length::computed((reach - least).max(0.0)),
        }
    }
}

/// The part of a phase that has passed at a time of one of its strokes.
fn passed_of(stroke: &Stroke, strokes: &[Stroke], time: f64) -> f64 {
    let same = || strokes.iter().filter(|other| other.phase == stroke.phase);
    let before: f64 = same().take_while(|other| !std::ptr::eq(*other, stroke)).map(Stroke::size).sum();
    let whole: f64 = same().map(Stroke::size).sum();
    if whole > 0.0 { (before + stroke.size() * time) / whole } else { time }
}

/// For each leg the wire from the middle of the arc before it to the middle of the arc after it.
fn corners(centreline: &Centreline) -> impl Iterator<Item = Interval> {
    let mut before = 0.0;
    centreline.legs.iter().map(move |leg| {
        let part = Interval { from: before, to: leg.straight.to + leg.arc / 2.0 };
        before = part.to;
        part
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
        source: String::new(),
        measured: true,
    }
}
