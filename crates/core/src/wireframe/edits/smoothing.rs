//! Edits that draw a chain of edges anew: straight where it nearly is, or as arcs.

use nalgebra::{Point3, Rotation3};

use super::super::delta::Draft;
use super::super::graph::EdgeId;
use super::EditError;
use super::chain::Chain;
use crate::curve::{Piece, fit_arcs, simplify};
use crate::units::{Angle, Length};

/// The most edges that a chain is drawn anew with.
const MAX_EDGES: u32 = 1_000_000;

/// Takes out the vertices within `tolerance` of a straight line. Those that carry other edges go onto the line.
pub(super) fn straighten(draft: &mut Draft, edges: &[EdgeId], tolerance: Length) -> Result<(), EditError> {
    let chain = Chain::of(draft, edges)?;
    let mut parts: Vec<(usize, usize)> = pairs(&bounds(&chain, |k| chain.is_held(draft, k)));
    while let Some((first, last)) = parts.pop() {
        let kept = simplify(&chain.points[first..=last], tolerance);
        for (from, to) in pairs(&kept).into_iter().map(|(from, to)| (first + from, first + to)) {
            let carrying: Vec<usize> = (from + 1..to).filter(|&k| chain.carries_others(draft, k)).collect();
            let Some(on_line) = put_on_line(&chain, (from, to), &carrying) else {
                // On the line they would change places or lie on each other: one of them stays where it is.
                let stays = carrying.get(carrying.len() / 2).copied().unwrap_or(usize::midpoint(from, to));
                parts.extend([(from, stays), (stays, to)]);
                continue;
            };
            let mut last = from;
            for (place, point) in on_line {
                draft.move_vertex(chain.vertices[place], point)?;
                chain.redraw(draft, (last, place), &[])?;
                last = place;
            }
            chain.redraw(draft, (last, to), &[])?;
        }
    }
    Ok(())
}

/// Where some places of a chain come to lie on the straight line between two others; none where they would not
/// follow each other on it. One edge is a line as it is.
fn put_on_line(
    chain: &Chain,
    (from, to): (usize, usize),
    places: &[usize],
) -> Option<Vec<(usize, Point3<f64>)>> {
    if to == from + 1 {
        return Some(Vec::new());
    }
    let (a, along) = (chain.points[from], chain.points[to] - chain.points[from]);
    let length = along.norm();
    // What lies closer together than a millionth of a millimetre cannot be told apart.
    let mut last = 1e-6;
    let mut found = Vec::with_capacity(places.len());
    for &place in places {
        let at = (chain.points[place] - a).dot(&along) / length;
        if !(at > last && at < length) {
            return None;
        }
        last = at + 1e-6;
        found.push((place, a + along * (at / length)));
    }
    (last < length).then_some(found)
}

/// Draws a chain as the lines and arcs that it is within `tolerance`, with a vertex on an arc at every `step` or
/// less often, so that no edge of an arc is shorter than `min_edge`.
pub(super) fn round(
    draft: &mut Draft,
    edges: &[EdgeId],
    tolerance: Length,
    step: Angle,
    min_edge: Length,
) -> Result<(), EditError> {
    if step <= Angle::ZERO || step > Angle::HALF_TURN {
        return Err(EditError::ArcStep(step));
    }
    let chain = Chain::of(draft, edges)?;
    let parts = bounds(&chain, |k| chain.is_held(draft, k) || chain.carries_others(draft, k));
    let mut drawn = Vec::new();
    for (first, last) in pairs(&parts) {
        for piece in fit_arcs(&chain.points[first..=last], tolerance) {
            drawn.push(match piece {
                Piece::Line { from, to } => ((first + from, first + to), Vec::new()),
                Piece::Arc { from, to, centre, axis, radius, sweep } => {
                    let count = edges_of_arc(radius, sweep, step, min_edge)?;
                    let start = chain.points[first + from] - centre;
                    let turned = |k: u32| {
                        let angle = sweep.rad() * f64::from(k) / f64::from(count);
                        centre + Rotation3::from_axis_angle(&axis, angle) * start
                    };
                    ((first + from, first + to), (1..count).map(turned).collect())
                }
            });
        }
    }
    for (span, through) in drawn {
        chain.redraw(draft, span, &through)?;
    }
    Ok(())
}

/// How many edges an arc is made of: two at least.
fn edges_of_arc(radius: Length, sweep: Angle, step: Angle, min_edge: Length) -> Result<u32, EditError> {
    let edge = |count: f64| 2.0 * radius.mm() * (sweep.rad() / (2.0 * count)).sin();
    // A step that divides the arc evenly does so in spite of rounding.
    let wanted = (sweep.rad() / step.rad() - 1e-9).ceil().max(2.0);
    let half = (min_edge.mm() / (2.0 * radius.mm())).min(1.0);
    let fitting = if half > 0.0 { (sweep.rad() / (2.0 * half.asin()) + 1e-9).floor() } else { wanted };
    let count = wanted.min(fitting);
    if count < 2.0 || edge(count) < min_edge.mm() * (1.0 - 1e-6) {
        return Err(EditError::SmallArc { radius, min_edge });
    }
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // two or more; it saturates
    let count = count as u32;
    if count > MAX_EDGES {
        return Err(EditError::TooMuch { count: count as usize, max: MAX_EDGES as usize });
    }
    Ok(count)
}

/// The places where a chain is divided: its ends, and the inner ones that have to stay.
fn bounds(chain: &Chain, stays: impl Fn(usize) -> bool) -> Vec<usize> {
    let last = chain.vertices.len() - 1;
    (0..=last).filter(|&k| k == 0 || k == last || stays(k)).collect()
}

/// Each with the one after it.
fn pairs(places: &[usize]) -> Vec<(usize, usize)> {
    places.windows(2).map(|pair| (pair[0], pair[1])).collect()
}
