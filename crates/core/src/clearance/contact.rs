//! Contacts of a program.

use std::ops::Range;

use nalgebra::{Isometry3, Translation3, UnitQuaternion, Vector3};
use wirebend_collide::{Interval, Meeting, Solid, Task, closest, first_contact};

use super::body::{Bodies, Body, MovesWith};
use super::centreline::{Centreline, Lie};
use super::stroke::{Moves, Phase, Seen, State, StepRun, Stroke, strokes};
use super::zone::{Passage, Passed, Touch};
use crate::bend::{Frame, Step};
use crate::compensate::BendModel;
use crate::motion::{bend_axis, poses};
use crate::units::{Angle, Length};

/// How far a chord may be from the arc that it stands for, mm.
const CHORD: f64 = 0.005;
/// How exact distances are, mm.
pub(super) const EXACT: f64 = 0.005;
/// How exact depths are, mm, and as a share of them.
const DEPTH_EXACT: f64 = 0.02;
const DEPTH_SHARE: f64 = 0.05;

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

impl StockWire {
    /// Things meet where the centreline is so near, mm.
    fn reach(&self) -> f64 {
        self.diameter.mm() / 2.0 + self.margin.mm()
    }
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
}

/// Where a wire first meets one thing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FirstContact {
    /// The first contact with it.
    pub contact: Contact,
    /// How deep it is at the worst of that step.
    pub depth: Length,
    /// In how many later steps they meet again.
    pub later: usize,
}

/// A wire in a machine, whose steps are asked about one by one.
#[derive(Debug, Clone)]
pub struct Clearance<'a> {
    pub(super) bodies: &'a Bodies,
    pub(super) bend: &'a BendModel,
    wire: StockWire,
    centreline: Centreline,
    passed: Passed,
    steps: Vec<Step>,
    told: Vec<Angle>,
    pub(super) lies: Vec<Lie>,
    /// Before each step, and after the last.
    heads: Vec<Angle>,
    pub(super) stock: Vec<Body>,
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

    /// The first contact with each thing that the wire meets, in the order of its steps.
    #[must_use]
    pub fn first_contacts(self) -> Vec<FirstContact> {
        self.first_contacts_while(|_| true).unwrap_or_default()
    }

    /// The same for whoever may be stopped: `goes_on` is asked before each step, with its index. `None` where it does not.
    #[must_use]
    pub fn first_contacts_while(mut self, goes_on: impl FnMut(usize) -> bool) -> Option<Vec<FirstContact>> {
        let all = self.first_contacts_in(0..self.steps(), goes_on)?;
        Some(self.merged([all]))
    }

    /// The same of some steps, so that several threads can share a long wire. How deep they are is not measured yet: what is found of
    /// steps that follow one another gives the whole by [`Clearance::merged`].
    pub fn first_contacts_in(
        &mut self,
        steps: Range<usize>,
        mut goes_on: impl FnMut(usize) -> bool,
    ) -> Option<Vec<FirstContact>> {
        self.met.clear();
        if let Some(before) = steps.start.checked_sub(1) {
            // What it meets already is no new contact.
            self.contacts_of(before);
        }
        let mut found: Vec<FirstContact> = Vec::new();
        for step in steps {
            if !goes_on(step) {
                return None;
            }
            for contact in self.contacts_of(step) {
                let known = found.iter_mut().find(|first| first.contact.obstacle == contact.obstacle);
                if let Some(first) = known {
                    first.later += 1;
                } else {
                    found.push(FirstContact { contact, depth: Length::ZERO, later: 0 });
                }
            }
        }
        Some(found)
    }

    /// The first contacts of the whole wire, from those of its parts in the order of their steps.
    #[must_use]
    pub fn merged(&self, parts: impl IntoIterator<Item = Vec<FirstContact>>) -> Vec<FirstContact> {
        let mut found: Vec<FirstContact> = Vec::new();
        for first in parts.into_iter().flatten() {
            let known = found.iter_mut().find(|known| known.contact.obstacle == first.contact.obstacle);
            if let Some(known) = known {
                known.later += 1 + first.later;
            } else {
                found.push(FirstContact { depth: self.depth(&first.contact), ..first });
            }
        }
        found
    }

    /// What the wire begins to meet in a step; the steps are asked for in order. One contact for each thing that it meets.
    pub fn contacts_of(&mut self, step: usize) -> Vec<Contact> {
        let Some(moves) = self.moves(step) else { return Vec::new() };
        let mut asked = Asked::new(self, step, &moves);
        let all = self.bodies.all.iter().enumerate().map(|(index, body)| (Obstacle::Body(index), body));
        let all: Vec<(Obstacle, &Body)> = all.chain([(Obstacle::Stock, &self.stock[step])]).collect();
        let mut met = Vec::new();
        let mut found = Vec::new();
        for one in all {
            let Some((stroke, meeting)) = asked.first(one) else { continue };
            met.push(one.0);
            let goes_on = stroke.phase == Phase::Feed && meeting.time <= 0.0;
            if !(goes_on && self.met.contains(&one.0)) {
                found.push(asked.contact(one.0, (stroke, meeting)));
            }
        }
        self.met = met;
        found.sort_by(|one, other| one.phase.cmp(&other.phase).then(one.passed.total_cmp(&other.passed)));
        found
    }

    /// How far the wire and what it meets are into each other at the worst of the step, the margin included; to a twentieth.
    #[must_use]
    pub fn depth(&self, contact: &Contact) -> Length {
        let body = match contact.obstacle {
            Obstacle::Body(index) => self.bodies.all.get(index),
            Obstacle::Stock => self.stock.get(contact.step),
        };
        let Some((body, moves)) = body.zip(self.moves(contact.step)) else { return Length::ZERO };
        let mut asked = Asked::new(self, contact.step, &moves);
        let deepest = |task: &Task| closest(task, DEPTH_SHARE);
        let mut least = self.wire.reach();
        for stroke in asked.strokes(body) {
            let near = asked.ask((contact.obstacle, body), &stroke, DEPTH_EXACT, deepest);
            least = near.map_or(least, |near| least.min(near.distance));
        }
        Length::computed(self.wire.reach() - least)
    }

    fn moves(&self, step: usize) -> Option<Moves> {
        let run =
            StepRun { head: [self.heads[step], self.heads[step + 1]], bend: self.steps.get(step)?.bend };
        let told = self.told.get(step).copied().unwrap_or(run.bend);
        self.moves_of(step, &run, told)
    }

    /// `told`: where the bend axis goes.
    pub(super) fn moves_of(&self, step: usize, run: &StepRun, told: Angle) -> Option<Moves> {
        let StepRun { head, bend } = *run;
        let leg = self.centreline.legs.get(step)?;
        let springback = self.bend.springback.as_ref();
        let pressed = springback.map_or(bend, |springback| springback.bend_to(bend)).abs();
        Some(Moves {
            lie: self.lies[step],
            bend_axis: bend_axis(head[1]),
            radius: leg.radius,
            fed: leg.fed(),
            head,
            bend,
            pressed: if bend == Angle::ZERO { bend } else { pressed },
            told,
        })
    }
}

/// A step that is asked about.
pub(super) struct Asked<'a> {
    clearance: &'a Clearance<'a>,
    step: usize,
    /// For bodies of the peg.
    in_parts: Vec<Stroke>,
    /// For all others.
    whole: Vec<Stroke>,
    /// What counts of the wire, for each question that has come up.
    counting: Vec<(Phase, Touch, Vec<Interval>)>,
}

impl<'a> Asked<'a> {
    pub fn new(clearance: &'a Clearance<'a>, step: usize, moves: &Moves) -> Self {
        let peg = clearance.bend.setback.as_ref();
        let [in_parts, whole] = [true, false].map(|parts| strokes(moves, clearance.bodies, peg, parts));
        Self { clearance, step, in_parts, whole, counting: Vec::new() }
    }

    /// The strokes in which a body moves past the wire.
    pub fn strokes(&self, body: &Body) -> Vec<Stroke> {
        let all = if body.moves_with == MovesWith::Peg { &self.in_parts } else { &self.whole };
        all.iter().filter(|stroke| stroke.moves(body.moves_with)).copied().collect()
    }

    fn first(&mut self, one: (Obstacle, &Body)) -> Option<(Stroke, Meeting)> {
        let mut strokes = self.strokes(one.1).into_iter();
        strokes.find_map(|stroke| Some((stroke, self.ask(one, &stroke, EXACT, first_contact)?)))
    }

    pub fn ask(
        &mut self,
        (obstacle, body): (Obstacle, &Body),
        stroke: &Stroke,
        tolerance: f64,
        ask: impl Fn(&Task) -> Option<Meeting>,
    ) -> Option<Meeting> {
        let clearance = self.clearance;
        let leg = &clearance.centreline.legs[self.step];
        let out = if stroke.phase == Phase::Feed { leg.straight.from } else { leg.straight.to };
        let touch = match obstacle {
            Obstacle::Stock => Touch::Stock,
            Obstacle::Body(_) => Touch::Body { wire: body.contact_zone.mm(), vertex: body.vertex_zone.mm() },
        };
        let known = self.counting.iter().position(|(phase, of, _)| (*phase, *of) == (stroke.phase, touch));
        let known = known.unwrap_or_else(|| {
            let parts = clearance.passed.counting(self.step, stroke.phase, touch, out);
            self.counting.push((stroke.phase, touch, parts));
            self.counting.len() - 1
        });
        ask(&Task {
            chain: &clearance.centreline.chain,
            parts: &self.counting[known].2,
            solid: &body.solid,
            motion: &Seen::new(stroke, body, clearance.bodies.pivot),
            reach: clearance.wire.reach(),
            tolerance,
        })
    }

    fn contact(&self, obstacle: Obstacle, (stroke, meeting): (Stroke, Meeting)) -> Contact {
        let legs = &self.clearance.centreline.legs;
        let leg = legs.partition_point(|leg| leg.straight.to + leg.arc / 2.0 < meeting.along);
        let state = stroke.at(meeting.time);
        Contact {
            step: self.step,
            phase: stroke.phase,
            passed: self.passed(&stroke, &state, meeting.time),
            fed: Length::computed(state.fed),
            head: Angle::computed(state.head),
            bent: Angle::computed(stroke.side * state.bent),
            obstacle,
            leg: leg.min(self.step),
            along: Length::computed(meeting.along),
        }
    }

    /// The part of a phase that has passed at a time of one of its strokes.
    fn passed(&self, stroke: &Stroke, state: &State, time: f64) -> f64 {
        let same = || self.in_parts.iter().filter(|other| other.phase == stroke.phase);
        let whole: f64 = same().map(Stroke::size).sum();
        let mut before = 0.0;
        for part in same() {
            let bending = part.to.bent > part.from.bent;
            let time =
                if bending { (state.bent - part.from.bent) / (part.to.bent - part.from.bent) } else { time };
            let is_it = if bending { time <= 1.0 && state.bent > 0.0 } else { part.from == stroke.from };
            if is_it {
                before += part.size() * time;
                break;
            }
            before += part.size();
        }
        if whole > 0.0 { (before / whole).min(1.0) } else { time }
    }
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
        vertex_zone: Length::ZERO,
        entry: String::new(),
        source: String::new(),
        measured: true,
    }
}
