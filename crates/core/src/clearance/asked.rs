//! Questions about a step, body by body.

use std::ops::ControlFlow;

use wirebend_collide::{Parts, Proximity, Task, first_contact};

use super::body::{Body, MovesWith};
use super::centreline::Centreline;
use super::contact::{Contact, Obstacle};
use super::hang::{Hanging, Slice};
use super::rooms::Rooms;
use super::seen::Seen;
use super::stroke::{Moves, Phase, State, Stroke, strokes};
use super::wire::Clearance;
use super::zone::Touch;
use crate::units::{Angle, Length};

/// How exact distances are, mm.
pub(super) const EXACT: f64 = 0.003;

/// The strokes of a step.
pub(super) struct Strokes {
    /// For bodies of the peg.
    in_parts: Vec<Stroke>,
    /// For all others.
    whole: Vec<Stroke>,
    /// For the stock: a bend up to what is left in the wire, and from there on.
    split: Vec<Stroke>,
}

impl Strokes {
    pub fn new(clearance: &Clearance, moves: &Moves) -> Self {
        let peg = clearance.bend.setback.as_ref();
        let [in_parts, whole] = [true, false].map(|parts| strokes(moves, clearance.bodies, peg, parts));
        let split = whole.iter().copied().flat_map(Stroke::split).collect();
        Self { in_parts, whole, split }
    }

    /// Those in which an obstacle moves past the wire, those of a phase together.
    pub fn past(&self, (obstacle, body): (Obstacle, &Body)) -> impl Iterator<Item = &[Stroke]> {
        let moves_with = body.moves_with;
        let all = match (obstacle, moves_with) {
            (Obstacle::Stock, _) => &self.split,
            (_, MovesWith::Peg) => &self.in_parts,
            _ => &self.whole,
        };
        let parted = move |one: &Stroke, other: &Stroke| {
            obstacle == Obstacle::Stock && one.overbends() != other.overbends()
        };
        let same = move |one: &Stroke, other: &Stroke| {
            one.phase == other.phase
                && one.moves(moves_with) == other.moves(moves_with)
                && !parted(one, other)
        };
        all.chunk_by(same).filter(move |phase| phase[0].moves(moves_with))
    }
}

/// A step that is asked about.
pub(super) struct Asked<'a> {
    clearance: &'a Clearance<'a>,
    step: usize,
    strokes: &'a Strokes,
    /// How far things have to stay from each other.
    margin: Length,
    /// What counts of the wire, for each question that has come up: the first phase in which it counts.
    counting: Vec<(Phase, Touch, Parts<'a>)>,
    /// The shapes of a wire that hangs, by what it depends on how it does.
    shapes: Vec<([f64; 5], Vec<Slice>)>,
}

impl<'a> Asked<'a> {
    pub const fn new(clearance: &'a Clearance<'a>, step: usize, strokes: &'a Strokes) -> Self {
        let margin = clearance.wire.margin;
        Self { clearance, step, strokes, margin, counting: Vec::new(), shapes: Vec::new() }
    }

    /// The same of what touches, without a margin.
    pub fn touching(self) -> Self {
        Self { margin: Length::ZERO, ..self }
    }

    /// Things meet where the centreline is so near, mm.
    pub fn reach(&self) -> f64 {
        self.clearance.wire.diameter.mm() / 2.0 + self.margin.mm()
    }

    /// The strokes of the step.
    pub const fn strokes(&self) -> &'a Strokes {
        self.strokes
    }

    /// The first contact with a body.
    pub fn first(&mut self, one: (Obstacle, &Body)) -> Option<(Stroke, Proximity)> {
        let strokes = self.strokes;
        strokes.past(one).find_map(|strokes| self.ask(one, strokes, EXACT, first_contact))
    }

    /// What comes first of a question about a body and strokes of one phase: in which of them, and when.
    pub fn ask(
        &mut self,
        one: (Obstacle, &Body),
        strokes: &[Stroke],
        tolerance: f64,
        ask: impl Fn(&Task) -> Option<Proximity>,
    ) -> Option<(Stroke, Proximity)> {
        let mut first = None;
        self.answers(one, strokes, tolerance, ask, &mut |answer| {
            first = Some(answer);
            ControlFlow::Break(())
        });
        first
    }

    /// All that comes of it, until `take` has enough: one answer at most where the wire keeps its shape, one of each of its shapes where
    /// it hangs.
    pub fn answers(
        &mut self,
        (obstacle, body): (Obstacle, &Body),
        strokes: &[Stroke],
        tolerance: f64,
        ask: impl Fn(&Task) -> Option<Proximity>,
        take: &mut dyn FnMut((Stroke, Proximity)) -> ControlFlow<()>,
    ) {
        let clearance = self.clearance;
        let Some(first) = strokes.first() else { return };
        let parts = self.counting(first, obstacle, body);
        let rooms = match obstacle {
            Obstacle::Body(index) => clearance.rooms[index],
            Obstacle::Stock => Rooms::new(body, clearance.bodies),
        };
        let asks = |this: &Self, strokes: &[Stroke], parts: &Parts, spread: f64| {
            let seen = Seen::new(strokes, body, &rooms, clearance.bodies)?;
            let near = ask(&Task {
                parts,
                solid: &body.solid,
                motion: &seen,
                reach: this.reach() + spread,
                tolerance,
            })?;
            let (stroke, time) = seen.stroke_at(near.time);
            Some((*stroke, Proximity { time, ..near }))
        };
        let Some(hanging) = &clearance.hanging else {
            if let Some(answer) = asks(self, strokes, &self.counting[parts].2, 0.0) {
                let _ = take(answer);
            }
            return;
        };
        for stroke in strokes {
            let shapes = self.shapes(hanging, stroke);
            for slice in &self.shapes[shapes].1 {
                let parts = Parts::of(&slice.chain, self.counting[parts].2.intervals().to_vec());
                let Some((_, near)) = asks(self, &[slice.of(stroke)], &parts, slice.spread) else {
                    continue;
                };
                if take((*stroke, Proximity { time: slice.time(near.time), ..near })).is_break() {
                    return;
                }
            }
        }
    }

    /// The place of what counts of the wire in a stroke.
    fn counting(&mut self, stroke: &Stroke, obstacle: Obstacle, body: &Body) -> usize {
        let Self { clearance, step, .. } = *self;
        // Once the head has turned nothing is fed or turned any more, and the same counts until the step is over.
        let phase = stroke.phase.min(Phase::Approach);
        let leg = &clearance.centreline.legs[step];
        let out = if phase == Phase::Feed { leg.straight.from } else { leg.straight.to };
        let touch = match obstacle {
            // A wire that is overbent presses on the vertices that it closes: by that the struts of these may be gone past.
            Obstacle::Stock if stroke.phase == Phase::Bend && !stroke.overbends() => {
                Touch::StockPassing { near: clearance.wire.diameter.mm() + self.margin.mm().max(0.0) }
            }
            Obstacle::Stock => Touch::Stock,
            Obstacle::Body(_) => Touch::Body { wire: body.contact_zone.mm(), vertex: body.vertex_zone.mm() },
        };
        let known = self.counting.iter().position(|(of, how, _)| (*of, *how) == (phase, touch));
        known.unwrap_or_else(|| {
            let parts = clearance.passed.counting(step, phase, touch, out);
            let parts = Parts::of(&clearance.centreline.chain, parts);
            self.counting.push((phase, touch, parts));
            self.counting.len() - 1
        })
    }

    /// The place of the shapes of a stroke.
    fn shapes(&mut self, hanging: &Hanging, stroke: &Stroke) -> usize {
        let Stroke { phase, from, to, .. } = stroke;
        let of = [from.fed, from.bent, to.fed, to.bent, if *phase == Phase::Feed { 0.0 } else { 1.0 }];
        let known = self
            .shapes
            .iter()
            .position(|(known, _)| known.iter().zip(&of).all(|(one, other)| one.total_cmp(other).is_eq()));
        known.unwrap_or_else(|| {
            let Centreline { chain, legs } = &self.clearance.centreline;
            self.shapes.push((of, hanging.slices(chain, &legs[self.step], stroke)));
            self.shapes.len() - 1
        })
    }

    /// A contact as a whole, from where it was found.
    pub fn contact(&self, obstacle: Obstacle, (stroke, near): (Stroke, Proximity)) -> Contact {
        let legs = &self.clearance.centreline.legs;
        let leg = legs.partition_point(|leg| leg.straight.to + leg.arc / 2.0 < near.along);
        let state = stroke.at(near.time);
        Contact {
            step: self.step,
            phase: stroke.phase,
            passed: self.passed(&stroke, &state, near.time),
            fed: Length::computed(state.fed),
            head: Angle::computed(state.head),
            bent: Angle::computed(stroke.side * state.bent),
            obstacle,
            leg: leg.min(self.step),
            along: Length::computed(near.along),
        }
    }

    /// The part of a phase that has passed at a time of one of its strokes.
    fn passed(&self, stroke: &Stroke, state: &State, time: f64) -> f64 {
        let same = || self.strokes.in_parts.iter().filter(|other| other.phase == stroke.phase);
        let whole: f64 = same().map(Stroke::size).sum();
        let mut before = 0.0;
        for part in same() {
            let bending = part.to.bent > part.from.bent;
            let time =
                if bending { (state.bent - part.from.bent) / (part.to.bent - part.from.bent) } else { time };
            let is_it = if bending { (0.0..=1.0).contains(&time) } else { part.from == stroke.from };
            if is_it {
                before += part.size() * time;
                break;
            }
            before += part.size();
        }
        if whole > 0.0 { (before / whole).min(1.0) } else { time }
    }
}
