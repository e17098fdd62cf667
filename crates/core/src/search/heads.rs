//! Which of the equal ways each bend is made, so that nothing is met: a dynamic program over the bends of a wire, a layer each.

use std::collections::BTreeMap;

use crate::bend::{NominalProgram, Step};
use crate::clearance::{Clearance, Obstacle, StepPart, StepRun};
use crate::schedule::{BendCost, HeadLimits, ScheduledProgram, build, head_angles, nanoseconds};
use crate::units::Angle;

use super::Bender;

/// What a contact counts: one that is sure more than any number of those with bodies that are only estimated.
const SURE: u64 = 1 << 32;
const ESTIMATED: u64 = 1;

/// How the part stands about the axis of the wire.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Orientation {
    /// The head's angle for a first bend that is not flipped, as the schedule counts it, up to whole turns.
    pub unflipped: Angle,
}

impl Orientation {
    /// As far as this about the wire from where the first bend is made at the reference.
    pub fn of_degrees(degrees: f64) -> Self {
        Self { unflipped: Angle::computed(degrees.to_radians()) }
    }

    /// On the other side of the wire.
    pub fn opposite(self) -> Self {
        Self { unflipped: (self.unflipped + Angle::HALF_TURN).wrapped() }
    }

    /// How far the part is turned about +x of the machine, beside one whose first bend is made at the reference.
    pub fn turn(self) -> Angle {
        -self.unflipped
    }

    /// Whether the head comes to where the first bend can be made.
    pub fn is_reached(self, limits: &HeadLimits) -> bool {
        !head_angles(self.unflipped, limits).is_empty()
    }
}

/// One way to make a bend, with the best ways to make those before it.
#[derive(Debug, Clone, Copy)]
pub(super) struct HeadState {
    head: Angle,
    flipped: bool,
    /// What is met up to here.
    pub met: u64,
    /// ns up to here.
    pub spent: i64,
    /// Index of the state before.
    from: usize,
}

/// The ways to make a bend.
#[derive(Debug, Clone)]
pub(super) struct Layer {
    /// The head's angle for a bend that is not flipped, up to whole turns.
    unflipped: Angle,
    pub states: Vec<HeadState>,
    /// What was in the way of the states that are left out.
    pub obstacle: Option<Obstacle>,
}

impl Layer {
    /// Before the first bend.
    pub fn first() -> Self {
        let at_reference = HeadState { head: Angle::ZERO, flipped: false, met: 0, spent: 0, from: 0 };
        Self { unflipped: Angle::ZERO, states: vec![at_reference], obstacle: None }
    }

    /// The best state: what meets least, then what takes least.
    pub fn best(&self) -> Option<usize> {
        (0..self.states.len()).min_by_key(|&k| (self.states[k].met, self.states[k].spent, k))
    }
}

/// A question that a layer asks about one step.
pub(super) struct StepQuestion<'a> {
    pub bender: &'a Bender<'a>,
    pub clearance: &'a Clearance<'a>,
    /// Index of the step.
    pub index: usize,
    pub step: Step,
    /// How the part stands, where this is the first bend.
    pub orientation: Option<Orientation>,
    /// Whether ways that meet something are kept, too.
    pub despite_contacts: bool,
}

impl StepQuestion<'_> {
    /// The ways to make the step after those of the step before. Without any, no way is within the head's limits, or all of them
    /// meet something.
    pub fn after(&self, before: &Layer) -> Layer {
        let feeds = self.feeds(before);
        if self.step.bend == Angle::ZERO {
            return self.fed(before, &feeds);
        }
        let follows = || (before.unflipped + self.step.rotate).wrapped();
        let unflipped = self.orientation.map_or_else(follows, |orientation| orientation.unflipped);
        let ways = head_angles(unflipped, self.bender.head);
        let cost = BendCost::new(self.step.bend, self.bender.seconds);
        let mut layer = Layer { unflipped, states: Vec::new(), obstacle: feeds.obstacle };
        let mut bends: [Option<Met>; 2] = [None, None];
        let mut turns = BTreeMap::new();
        // A side that the machine cannot bend to is left out, where it can bend to the other.
        let makes = [false, true]
            .map(|flipped| self.signed(flipped))
            .map(|bend| (self.bender.seconds)(bend).is_some());
        for (head, flipped) in ways {
            if !makes[usize::from(flipped)] && makes[usize::from(!flipped)] {
                continue;
            }
            let bend = bends[usize::from(flipped)]
                .get_or_insert_with(|| self.met(StepPart::Bend, [head, head], flipped));
            let bend = *bend;
            let best = self.reached(before, &feeds, (head, flipped), bend, cost, &mut turns);
            match best {
                Ok(state) => layer.states.push(state),
                Err(obstacle) => layer.obstacle = layer.obstacle.max(obstacle),
            }
        }
        layer
    }

    /// After a step that only feeds.
    fn fed(&self, before: &Layer, feeds: &Feeds) -> Layer {
        let state = |(from, state): (usize, &HeadState)| HeadState {
            met: state.met + feeds.of(state.flipped).weight,
            from,
            ..*state
        };
        let kept = |state: &HeadState| self.despite_contacts || state.met == 0;
        let states = before.states.iter().enumerate().map(state).filter(kept).collect();
        Layer { unflipped: before.unflipped, states, obstacle: feeds.obstacle }
    }

    /// The best way to come to a state; else what is in the way.
    fn reached(
        &self,
        before: &Layer,
        feeds: &Feeds,
        (head, flipped): (Angle, bool),
        bend: Met,
        cost: BendCost,
        turns: &mut BTreeMap<(bool, i64), Met>,
    ) -> Result<HeadState, Option<Obstacle>> {
        if bend.weight > 0 && !self.despite_contacts {
            return Err(bend.obstacle);
        }
        let turn = |from: &HeadState| self.bender.head.turning(head - from.head);
        let least = |(k, from): (usize, &HeadState)| {
            let met = from.met + feeds.of(from.flipped).weight + bend.weight;
            (met, from.spent.saturating_add(turn(from)).saturating_add(cost.of(flipped)), k)
        };
        let mut ways: Vec<(u64, i64, usize)> = before.states.iter().enumerate().map(least).collect();
        ways.sort_unstable();
        let mut best: Option<(u64, i64, usize)> = None;
        let mut obstacle = feeds.obstacle;
        for (met, spent, k) in ways {
            let cannot_improve = |found: (u64, i64, usize)| found <= (met, spent, k);
            if best.is_some_and(cannot_improve) || (met > 0 && !self.despite_contacts) {
                break;
            }
            let from = &before.states[k];
            let key = (from.flipped, nanoseconds((head - from.head).deg() + 1e6));
            let turned =
                *turns.entry(key).or_insert_with(|| self.met(StepPart::Rotate, [from.head, head], flipped));
            obstacle = obstacle.max(turned.obstacle);
            let reached = (met + turned.weight, spent, k);
            if (turned.weight == 0 || self.despite_contacts) && best.is_none_or(|best| reached < best) {
                best = Some(reached);
            }
        }
        let (met, spent, from) = best.ok_or(obstacle)?;
        Ok(HeadState { head, flipped, met, spent, from })
    }

    /// What is met while the step is fed, by how the bend before was made.
    fn feeds(&self, before: &Layer) -> Feeds {
        let Some(any) = before.states.first() else { return Feeds::default() };
        let frame = self.met(StepPart::FeedPastFrame, [any.head; 2], false);
        let mut feeds = Feeds { met: [frame; 2], obstacle: frame.obstacle };
        for flipped in [false, true] {
            if let Some(state) = before.states.iter().find(|state| state.flipped == flipped) {
                let past_head = self.met(StepPart::FeedPastHead, [state.head; 2], false);
                feeds.met[usize::from(flipped)].weight += past_head.weight;
                feeds.obstacle = feeds.obstacle.max(past_head.obstacle);
            }
        }
        feeds
    }

    fn signed(&self, flipped: bool) -> Angle {
        if flipped { -self.step.bend } else { self.step.bend }
    }

    fn met(&self, part: StepPart, head: [Angle; 2], flipped: bool) -> Met {
        let bend = self.signed(flipped);
        let run = StepRun { head: head.map(|head| -head), bend };
        let obstacle = self.clearance.obstacle(self.index, part, &run);
        let weight = match obstacle {
            None => 0,
            Some(Obstacle::Body(index)) if !self.bender.bodies.all[index].measured => ESTIMATED,
            Some(_) => SURE,
        };
        Met { weight, obstacle }
    }
}

/// What a part of a step meets.
#[derive(Debug, Clone, Copy, Default)]
struct Met {
    weight: u64,
    obstacle: Option<Obstacle>,
}

/// What is met while a step is fed after a bend that was not flipped, and after one that was.
#[derive(Default)]
struct Feeds {
    met: [Met; 2],
    obstacle: Option<Obstacle>,
}

impl Feeds {
    fn of(&self, flipped: bool) -> Met {
        self.met[usize::from(flipped)]
    }
}

/// The program that a state of the last layer stands for; the layers are those of each step.
pub(super) fn scheduled(program: &NominalProgram, layers: &[Layer], mut at: usize) -> ScheduledProgram {
    let mut bends = Vec::new();
    let mut chosen = Vec::new();
    for (k, layer) in layers.iter().enumerate().rev() {
        let state = layer.states[at];
        if program.steps[k].bend != Angle::ZERO {
            bends.push(k);
            chosen.push((state.head, state.flipped));
        }
        at = state.from;
    }
    bends.reverse();
    chosen.reverse();
    build(program, &bends, &chosen)
}

#[cfg(test)]
mod tests;
