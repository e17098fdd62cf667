//! The schedule: which of the equal ways to make each bend is taken.
//!
//! (φ, θ) and (φ ± 180°, -θ) are the same bend, and the head may stand a whole turn further. Which
//! one is run decides how far the head turns, whether its cable winds up, and to which side the
//! peg pushes.

use crate::bend::{NominalProgram, Step};
use crate::units::Angle;

/// What the head may do.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HeadLimits {
    /// The least absolute angle of the head; zero or less.
    pub least: Angle,
    /// The largest absolute angle of the head; zero or more.
    pub most: Angle,
    /// How long it takes to turn by one degree, in seconds.
    pub seconds_per_degree: f64,
}

/// A program with the way of every bend chosen: bends are signed, rotations are the head's own
/// turns and may exceed 180°.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ScheduledProgram {
    /// The steps. Replay gives the same path as the nominal program, turned by half a turn about the
    /// first feed where the first bend goes to the negative side.
    pub steps: Vec<Step>,
    /// The absolute angle of the head during each step's bend; it starts at zero.
    pub head: Vec<Angle>,
}

/// A bend that no turn of the head within its limits can make.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error(
    "step {}: the head would have to stand at {wanted:.2} (or a multiple of half a turn away), outside {least:.1} to {most:.1}",
    .step + 1
)]
pub struct RotationOutOfRange {
    /// Index of the step, from 0.
    pub step: usize,
    /// The angle nearest to zero at which the bend could be made.
    pub wanted: Angle,
    /// The limit below.
    pub least: Angle,
    /// The limit above.
    pub most: Angle,
}

/// One way to make a bend.
#[derive(Debug, Clone, Copy)]
struct Way {
    head: Angle,
    flipped: bool,
    /// Nanoseconds from the start, and the index of the way before.
    spent: i64,
    from: usize,
}

/// Nanoseconds that a bend takes to its own side and to the other.
#[derive(Debug, Clone, Copy)]
struct BendCost {
    kept: i64,
    flipped: i64,
}

impl BendCost {
    const fn of(self, flipped: bool) -> i64 {
        if flipped { self.flipped } else { self.kept }
    }
}

/// Chooses for every bend its sign and the winding of the head, so that the head stays within its
/// limits and the time is least; no other choice is faster (dynamic programming over all of them).
///
/// `bend_seconds` tells how long a signed bend takes, or `None` where it cannot be made to that
/// side; such a bend is only chosen where the other side cannot make it either, and it is for
/// the checks to say so. Among equally fast ways the one that keeps the head nearer to zero wins.
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
    let costs: Vec<BendCost> = bends
        .iter()
        .map(|&step| {
            let bend = program.steps[step].bend;
            // A bend that cannot be made weighs more than any number of turns.
            let cost = |bend| nanoseconds(bend_seconds(bend).unwrap_or(1.0e6));
            BendCost { kept: cost(bend), flipped: cost(-bend) }
        })
        .collect();
    // The wire is round: before the first bend it has no side, so that bend is made with the head at
    // zero, to either side.
    let mut best: Option<(i64, Vec<Way>)> = None;
    let mut refused = None;
    for flipped in [false, true] {
        match fastest(program, &bends, &costs, limits, flipped) {
            Ok((spent, ways)) if best.as_ref().is_none_or(|(least, _)| spent < *least) => {
                best = Some((spent, ways));
            }
            Ok(_) => {}
            Err(error) => refused = Some(error),
        }
    }
    match (best, refused) {
        (Some((_, ways)), _) => Ok(build(program, &bends, &ways)),
        (None, Some(error)) => Err(error),
        (None, None) => Ok(unturned(program)),
    }
}

fn unturned(program: &NominalProgram) -> ScheduledProgram {
    ScheduledProgram { steps: program.steps.clone(), head: vec![Angle::ZERO; program.steps.len()] }
}

fn fastest(
    program: &NominalProgram,
    bends: &[usize],
    costs: &[BendCost],
    limits: &HeadLimits,
    first_flipped: bool,
) -> Result<(i64, Vec<Way>), RotationOutOfRange> {
    let mut layers: Vec<Vec<Way>> = Vec::with_capacity(bends.len());
    layers.push(vec![Way {
        head: Angle::ZERO,
        flipped: first_flipped,
        spent: costs[0].of(first_flipped),
        from: 0,
    }]);
    // Where the head stands for a bend that is not flipped, up to whole turns. Rotations of steps
    // that bend nothing count towards the next bend.
    let mut stand = if first_flipped { Angle::HALF_TURN } else { Angle::ZERO };
    for (pair, cost) in bends.windows(2).zip(&costs[1..]) {
        let turned: Angle = program.steps[pair[0] + 1..=pair[1]].iter().map(|step| step.rotate).sum();
        stand = (stand + turned).wrapped();
        let mut layer = Vec::new();
        for (head, flipped) in stands(stand, limits) {
            let made = cost.of(flipped);
            let reach = |way: &Way| {
                let turn = nanoseconds((head - way.head).abs().deg() * limits.seconds_per_degree);
                way.spent.saturating_add(turn).saturating_add(made)
            };
            let before = layers[layers.len() - 1].iter().enumerate();
            if let Some((spent, from)) = before.map(|(k, way)| (reach(way), k)).min() {
                layer.push(Way { head, flipped, spent, from });
            }
        }
        if layer.is_empty() {
            let (least, most) = (limits.least, limits.most);
            let other = (stand + Angle::HALF_TURN).wrapped();
            let wanted = if other.abs() < stand.abs() { other } else { stand };
            return Err(RotationOutOfRange { step: pair[1], wanted, least, most });
        }
        layers.push(layer);
    }
    let last = &layers[layers.len() - 1];
    let mut at = (0..last.len()).min_by_key(|&k| (last[k].spent, k)).unwrap_or(0);
    let spent = last[at].spent;
    let mut ways = Vec::with_capacity(layers.len());
    for layer in layers.iter().rev() {
        ways.push(layer[at]);
        at = layer[at].from;
    }
    ways.reverse();
    Ok((spent, ways))
}

/// A head that may turn without end is not wound farther than this from where it starts: more choices
/// would take time to weigh and none of them is nearer.
const MOST_HALF_TURNS: f64 = 40.0;

/// Every angle of the head within its limits, and within twenty turns, at which a bend can be made, nearest to zero first,
/// with whether the bend is then flipped.
fn stands(unflipped: Angle, limits: &HeadLimits) -> Vec<(Angle, bool)> {
    // Rounding of a sum of angles must not push the head over a limit that it just reaches.
    let slack = Angle::computed(1e-9);
    let span = limits.most.deg().max(-limits.least.deg());
    #[allow(clippy::cast_possible_truncation)] // limits are a few turns
    let turns = (span / 180.0).ceil().min(MOST_HALF_TURNS) as i32 + 1;
    let mut stands: Vec<(Angle, bool)> = (-turns..=turns)
        .map(|halves| (unflipped + Angle::HALF_TURN.times(halves), halves % 2 != 0))
        .filter(|&(head, _)| head >= limits.least - slack && head <= limits.most + slack)
        .map(|(head, flipped)| (head.max(limits.least).min(limits.most), flipped))
        .collect();
    stands.sort_by_key(|&(head, flipped)| (head.abs(), flipped, head < Angle::ZERO));
    stands
}

fn build(program: &NominalProgram, bends: &[usize], ways: &[Way]) -> ScheduledProgram {
    let mut scheduled = ScheduledProgram::default();
    let mut head = Angle::ZERO;
    for (k, step) in program.steps.iter().enumerate() {
        let mut made = Step { feed: step.feed, ..Step::default() };
        if let Ok(at) = bends.binary_search(&k) {
            made.rotate = ways[at].head - head;
            made.bend = if ways[at].flipped { -step.bend } else { step.bend };
            head = ways[at].head;
        }
        scheduled.steps.push(made);
        scheduled.head.push(head);
    }
    scheduled
}

#[allow(clippy::cast_possible_truncation)] // a job takes hours, not centuries
fn nanoseconds(seconds: f64) -> i64 {
    // Rounds, since time is not negative; `round` is a call, and this runs once for every pair of ways.
    (seconds * 1.0e9 + 0.5) as i64
}

#[cfg(test)]
mod tests;
