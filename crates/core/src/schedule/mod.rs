//! The schedule: which of the equal choices to make each bend is taken.
//!
//! (φ, θ) and (φ ± 180°, -θ) are the same bend, and the head may stand a whole turn further. Which
//! one is run decides how far the head turns, whether its cable winds up, and to which side the
//! peg pushes.

mod standing;

use self::standing::standing;
use crate::bend::{NominalProgram, Step};
use crate::units::Angle;

/// What the head may do.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HeadLimits {
    /// The least absolute angle of the head; zero or less.
    pub min: Angle,
    /// The largest absolute angle of the head; zero or more.
    pub max: Angle,
    /// How long it takes to turn by one degree, in seconds.
    pub seconds_per_degree: f64,
    /// What every turn takes besides, in seconds.
    pub seconds_per_turn: f64,
}

impl HeadLimits {
    /// Nanoseconds for a turn of the head.
    pub(crate) fn turning(&self, turn: Angle) -> i64 {
        let fixed = if turn == Angle::ZERO { 0.0 } else { self.seconds_per_turn };
        nanoseconds(turn.abs().deg() * self.seconds_per_degree + fixed)
    }
}

/// A program with the way of every bend chosen: bends are signed, rotations are the head's own
/// turns and may exceed 180°.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ScheduledProgram {
    /// The steps. Replay gives the same path as the nominal program, turned about the first feed by what the head turns before the
    /// first bend, and by half a turn where that goes to the negative side.
    pub steps: Vec<Step>,
    /// The absolute angle of the head during each step's bend; it starts at zero.
    pub head: Vec<Angle>,
}

/// A bend that no turn of the head within its limits can make.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error("step {}: the head cannot turn to {wanted:.2} within {min:.1} to {max:.1}", .step + 1)]
pub struct RotationOutOfRange {
    /// Index of the step, from 0.
    pub step: usize,
    /// The angle nearest to zero at which the bend could be made, with the head at zero for the first bend.
    pub wanted: Angle,
    /// Whether that is where the head is sent, with what it is off by.
    pub commanded: bool,
    /// The limit below.
    pub min: Angle,
    /// The limit above.
    pub max: Angle,
}

/// One of the equal ways to make a bend, with the fastest choices before it.
#[derive(Debug, Clone, Copy)]
struct BendChoice {
    /// Angle of the head during the bend.
    head: Angle,
    /// Whether the bend goes to the negative side.
    flipped: bool,
    /// Time from the start to the end of this bend, in ns.
    spent: i64,
    /// Index of the choice for the bend before.
    from: usize,
}

/// Whether a bend can be made to its own side and to the other.
type Sides = [bool; 2];

/// Whether a bend can be made so, or not at all.
fn is_side_made(sides: Sides, flipped: bool) -> bool {
    sides[usize::from(flipped)] || !sides[usize::from(!flipped)]
}

/// Nanoseconds that a bend takes to its own side and to the other.
#[derive(Debug, Clone, Copy)]
pub(crate) struct BendCost {
    kept: i64,
    flipped: i64,
}

impl BendCost {
    /// `bend_seconds`: as [`schedule`] has it. A bend that cannot be made weighs more than any number of turns.
    pub fn new(bend: Angle, bend_seconds: impl Fn(Angle) -> Option<f64>) -> Self {
        let cost = |bend| nanoseconds(bend_seconds(bend).unwrap_or(1.0e6));
        Self { kept: cost(bend), flipped: cost(-bend) }
    }

    pub const fn of(self, flipped: bool) -> i64 {
        if flipped { self.flipped } else { self.kept }
    }
}

/// Chooses for every bend its sign and the winding of the head, so that the head stays within its
/// limits and the time is least; no other choice is faster (dynamic programming over all of them).
/// The first bend is made with the head at zero, unless a later one can be made only where it is not: then with the head turned as little
/// as can be, and no other choice from there is faster.
///
/// `bend_seconds` tells how long a signed bend takes, or `None` where it cannot be made to that
/// side; such a bend is only chosen where the other side cannot make it either, and it is for
/// the checks to say so. Among equally fast choices the one that keeps the head nearer to zero wins.
///
/// # Errors
/// [`RotationOutOfRange`] names the first step that no choice before it makes possible.
pub fn schedule(
    program: &NominalProgram,
    limits: &HeadLimits,
    bend_seconds: impl Fn(Angle) -> Option<f64>,
) -> Result<ScheduledProgram, RotationOutOfRange> {
    let bends: Vec<usize> =
        (0..program.steps.len()).filter(|&k| program.steps[k].bend != Angle::ZERO).collect();
    if bends.is_empty() {
        return Ok(unturned(program));
    }
    let costs: Vec<BendCost> =
        bends.iter().map(|&step| BendCost::new(program.steps[step].bend, &bend_seconds)).collect();
    let sides: Vec<Sides> = bends
        .iter()
        .map(|&step| program.steps[step].bend)
        .map(|bend| [bend, -bend].map(|bend| bend_seconds(bend).is_some()))
        .collect();
    let is_made = |choices: &[BendChoice]| {
        choices.iter().zip(&sides).all(|(choice, sides)| is_side_made(*sides, choice.flipped))
    };
    // The wire is round: before the first bend it has no side, so that bend is made with the head at
    // zero, to either side.
    let mut best: Option<(i64, Vec<BendChoice>)> = None;
    let mut refused = None;
    for flipped in [false, true] {
        let unflipped = if flipped { Angle::HALF_TURN } else { Angle::ZERO };
        match fastest(program, (&bends, &costs, None), limits, (unflipped, vec![(Angle::ZERO, flipped)])) {
            Ok((spent, choices)) if best.as_ref().is_none_or(|(cost, _)| spent < *cost) => {
                best = Some((spent, choices));
            }
            Ok(_) => {}
            Err(error) => refused = Some(error),
        }
    }
    if best.as_ref().is_none_or(|(_, choices)| !is_made(choices))
        && let Some(unflipped) = standing(program, &bends, &sides, limits)
    {
        let mut ways = head_angles(unflipped, limits);
        ways.retain(|&(_, flipped)| is_side_made(sides[0], flipped));
        let elsewhere = || fastest(program, (&bends, &costs, None), limits, (unflipped, ways.clone())).ok();
        let made = (!ways.is_empty()).then(elsewhere).flatten().filter(|(_, choices)| is_made(choices));
        best = made.or(best);
    }
    // That a bend is made to a side to which it cannot is then for want of turns: the step where they end.
    if best.as_ref().is_some_and(|(_, choices)| !is_made(choices)) {
        let made = [false, true].into_iter().filter(|&flipped| is_side_made(sides[0], flipped));
        let ends = made.filter_map(|flipped| {
            let unflipped = if flipped { Angle::HALF_TURN } else { Angle::ZERO };
            let first = (unflipped, vec![(Angle::ZERO, flipped)]);
            fastest(program, (&bends, &costs, Some(&sides)), limits, first).err()
        });
        if let Some(farthest) = ends.max_by_key(|error| error.step) {
            return Err(farthest);
        }
    }
    match (best, refused) {
        (Some((_, choices)), _) => {
            let chosen: Vec<(Angle, bool)> =
                choices.iter().map(|choice| (choice.head, choice.flipped)).collect();
            Ok(build(program, &bends, &chosen))
        }
        (None, Some(error)) => Err(error),
        (None, None) => Ok(unturned(program)),
    }
}

fn unturned(program: &NominalProgram) -> ScheduledProgram {
    ScheduledProgram { steps: program.steps.clone(), head: vec![Angle::ZERO; program.steps.len()] }
}

/// `sides`: no bend is made to a side to which it cannot. `first`: the head's angle for a first bend that is not flipped, up to whole turns, and the ways to make that bend. Afterwards rotations
/// of steps that bend nothing count towards the next bend.
fn fastest(
    program: &NominalProgram,
    (bends, costs, sides): (&[usize], &[BendCost], Option<&[Sides]>),
    limits: &HeadLimits,
    (mut unflipped, first): (Angle, Vec<(Angle, bool)>),
) -> Result<(i64, Vec<BendChoice>), RotationOutOfRange> {
    let mut layers: Vec<Vec<BendChoice>> = Vec::with_capacity(bends.len());
    let turning = |turn: Angle| limits.turning(turn);
    let begin = |(head, flipped): (Angle, bool)| BendChoice {
        head,
        flipped,
        spent: turning(head).saturating_add(costs[0].of(flipped)),
        from: 0,
    };
    layers.push(first.into_iter().map(begin).collect());
    for (k, (pair, cost)) in (1..).zip(bends.windows(2).zip(&costs[1..])) {
        let turned: Angle = program.steps[pair[0] + 1..=pair[1]].iter().map(|step| step.rotate).sum();
        unflipped = (unflipped + turned).wrapped();
        let mut layer = Vec::new();
        for (head, flipped) in head_angles(unflipped, limits) {
            if sides.is_some_and(|sides| !is_side_made(sides[k], flipped)) {
                continue;
            }
            let made = cost.of(flipped);
            let reach = |before: &BendChoice| {
                before.spent.saturating_add(turning(head - before.head)).saturating_add(made)
            };
            let last = layers[layers.len() - 1].iter().enumerate();
            if let Some((spent, from)) = last.map(|(k, choice)| (reach(choice), k)).min() {
                layer.push(BendChoice { head, flipped, spent, from });
            }
        }
        if layer.is_empty() {
            let (min, max) = (limits.min, limits.max);
            let ways = [(unflipped, false), ((unflipped + Angle::HALF_TURN).wrapped(), true)];
            let made = ways.into_iter().filter(|way| sides.is_none_or(|sides| is_side_made(sides[k], way.1)));
            let wanted = made.map(|(head, _)| head).min_by_key(|head| head.abs()).unwrap_or(unflipped);
            return Err(RotationOutOfRange { step: pair[1], wanted, commanded: false, min, max });
        }
        layers.push(layer);
    }
    let last = &layers[layers.len() - 1];
    let mut at = (0..last.len()).min_by_key(|&k| (last[k].spent, k)).unwrap_or(0);
    let spent = last[at].spent;
    let mut choices = Vec::with_capacity(layers.len());
    for layer in layers.iter().rev() {
        choices.push(layer[at]);
        at = layer[at].from;
    }
    choices.reverse();
    Ok((spent, choices))
}

/// A head that may turn without end is not wound farther than this from where it starts: more choices
/// would take time to weigh and none of them is nearer.
const MAX_HALF_TURNS: f64 = 40.0;

/// Every angle of the head within its limits, and within twenty turns, at which a bend can be made, nearest to zero first,
/// with whether the bend is then flipped.
pub(crate) fn head_angles(unflipped: Angle, limits: &HeadLimits) -> Vec<(Angle, bool)> {
    // Rounding of a sum of angles must not push the head over a limit that it just reaches.
    let slack = Angle::computed(1e-9);
    let span = limits.max.deg().max(-limits.min.deg());
    #[allow(clippy::cast_possible_truncation)] // limits are a few turns
    let turns = (span / 180.0).ceil().min(MAX_HALF_TURNS) as i32 + 1;
    let mut head_angles: Vec<(Angle, bool)> = (-turns..=turns)
        .map(|halves| (unflipped + Angle::HALF_TURN.times(halves), halves % 2 != 0))
        .filter(|&(head, _)| head >= limits.min - slack && head <= limits.max + slack)
        .map(|(head, flipped)| (head.max(limits.min).min(limits.max), flipped))
        .collect();
    head_angles.sort_by_key(|&(head, flipped)| (head.abs(), flipped, head < Angle::ZERO));
    head_angles
}

/// The program whose bends, by the indices of their steps, are made with the head at these angles, flipped or not.
pub(crate) fn build(program: &NominalProgram, bends: &[usize], chosen: &[(Angle, bool)]) -> ScheduledProgram {
    let mut scheduled = ScheduledProgram::default();
    let mut head = Angle::ZERO;
    for (k, step) in program.steps.iter().enumerate() {
        let mut made = Step { feed: step.feed, ..Step::default() };
        if let Ok(at) = bends.binary_search(&k) {
            let (angle, flipped) = chosen[at];
            made.rotate = angle - head;
            made.bend = if flipped { -step.bend } else { step.bend };
            head = angle;
        }
        scheduled.steps.push(made);
        scheduled.head.push(head);
    }
    scheduled
}

#[allow(clippy::cast_possible_truncation)] // a job takes hours, not centuries
pub(crate) fn nanoseconds(seconds: f64) -> i64 {
    // Rounds, since time is not negative; `round` is a call, and this runs once for every pair of choices.
    (seconds * 1.0e9 + 0.5) as i64
}

#[cfg(test)]
mod tests;
