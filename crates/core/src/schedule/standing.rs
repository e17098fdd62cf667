//! How the part has to stand about the wire so that a head with little room can make every bend.

use super::{HeadLimits, Sides, is_side_made};
use crate::bend::NominalProgram;
use crate::units::Angle;

/// What angles are rounded by, degrees.
const SLACK: f64 = 1e-8;
const TURN: f64 = 360.0;

/// Where the head stands for a first bend that is not flipped, up to whole turns, so that it comes to every bend within its limits: where it
/// turns least before that bend. None where no angle does.
pub(super) fn standing(
    program: &NominalProgram,
    bends: &[usize],
    sides: &[Sides],
    limits: &HeadLimits,
) -> Option<Angle> {
    let (min, max) = (limits.min.deg() - SLACK, limits.max.deg() + SLACK);
    // Each bend leaves arcs of the circle; where as many lie over each other as there are bends, all can be made.
    let mut ends: Vec<(f64, i32)> = Vec::new();
    // Angles are counted from zero of the head for the first bend, to the side to which it is made.
    let aside = if sides.first().is_some_and(|sides| is_side_made(*sides, false)) {
        Angle::ZERO
    } else {
        Angle::HALF_TURN
    };
    let mut turned = -aside;
    let mut last = bends.first().copied().unwrap_or_default();
    for (&bend, &sides) in bends.iter().zip(sides) {
        let rotated: Angle = program.steps[last + 1..=bend.max(last)].iter().map(|step| step.rotate).sum();
        turned = (turned + rotated).wrapped();
        last = bend;
        let flips = [false, true].into_iter().filter(|&flipped| is_side_made(sides, flipped));
        let arcs = flips.flat_map(|flipped| {
            let at = turned.deg() + if flipped { TURN / 2.0 } else { 0.0 };
            arc(min - at, max - at)
        });
        for [from, to] in joined(arcs.collect()) {
            ends.extend([(from, -1), (to, 1)]);
        }
    }
    // Of ends at one place those where arcs begin come first.
    ends.sort_by(|one, other| one.0.total_cmp(&other.0).then(one.1.cmp(&other.1)));
    let wanted = i32::try_from(bends.len()).ok()?;
    // Where it does not turn at all. Half a turn is as good where the first bend can be made to both sides.
    let both = sides.first().is_some_and(|sides| sides[0] == sides[1]);
    let unturned = [0.0, TURN].into_iter().chain(both.then_some(TURN / 2.0));
    let mut over = 0;
    let mut nearest: Option<(f64, f64)> = None;
    for (k, &(at, end)) in ends.iter().enumerate() {
        over -= end;
        if over < wanted {
            continue;
        }
        // From here to the next end every angle does.
        let to = ends.get(k + 1).map_or(at, |next| next.0);
        for target in unturned.clone() {
            let angle = target.clamp(at, to);
            let turns = (angle - target).abs();
            if nearest.is_none_or(|(least, _)| turns < least) {
                nearest = Some((turns, angle));
            }
        }
    }
    nearest.map(|(_, degrees)| (Angle::computed(degrees.to_radians()) - aside).wrapped())
}

/// The angles from one to another as parts of the circle from 0 to 360.
fn arc(from: f64, to: f64) -> Vec<[f64; 2]> {
    if to - from >= TURN {
        return vec![[0.0, TURN]];
    }
    let begin = from.rem_euclid(TURN);
    let end = begin + to - from;
    if end <= TURN { vec![[begin, end]] } else { vec![[begin, TURN], [0.0, end - TURN]] }
}

/// The same angles as arcs that are apart from each other.
fn joined(mut arcs: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    arcs.sort_by(|one, other| one[0].total_cmp(&other[0]));
    let mut apart: Vec<[f64; 2]> = Vec::new();
    for arc in arcs {
        match apart.last_mut() {
            Some(last) if arc[0] <= last[1] => last[1] = last[1].max(arc[1]),
            _ => apart.push(arc),
        }
    }
    apart
}
