//! The cubic spline through points: with the same direction and the same curvature on both sides of each.
//!
//! The parameter grows by the distance between points, as CAD programs choose it. Ends without a direction of their own
//! have no curvature ("natural"); a closed spline has none. Source: de Boor, A Practical Guide to Splines, chapter IV.

use nalgebra::{Point3, Vector3};
use wirebend_core::curve::Spline;

/// How the spline begins and ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Ends {
    /// The directions at the start and at the end, as far as they are known.
    Open([Option<Vector3<f64>>; 2]),
    /// The last point continues to the first.
    Closed,
}

/// The spline; none of fewer than two points that are apart. Points on the one before are left out.
pub(super) fn through(points: &[Point3<f64>], ends: Ends) -> Option<Spline> {
    let mut points = points.to_vec();
    points.dedup();
    if ends == Ends::Closed {
        // It may say itself that it comes back.
        while points.len() > 1 && points.first() == points.last() {
            points.pop();
        }
        points.push(*points.first()?);
    }
    let steps: Vec<f64> = points.windows(2).map(|pair| (pair[1] - pair[0]).norm()).collect();
    if steps.is_empty() || !steps.iter().all(|step| step.is_normal()) {
        return None;
    }
    let slopes = match ends {
        Ends::Closed if steps.len() > 2 => closed(&points, &steps),
        Ends::Closed => open(&points, &steps, [None, None]),
        Ends::Open(ends) => open(&points, &steps, ends),
    };
    // Each piece as a Bézier curve; together a spline with each knot three times.
    let (mut control, mut knots, mut at) = (vec![points[0]], vec![0.0; 4], 0.0);
    for (k, step) in steps.iter().enumerate() {
        let third = step / 3.0;
        control.extend([points[k] + slopes[k] * third, points[k + 1] - slopes[k + 1] * third, points[k + 1]]);
        at += step;
        knots.extend([at; 3]);
    }
    knots.push(at);
    Spline::new(3, knots, control, Vec::new()).ok()
}

/// A row of the equations: what the slopes before, at and behind a point are multiplied by, and the sum.
struct Row {
    before: f64,
    at: f64,
    behind: f64,
    sum: Vector3<f64>,
}

/// The same curvature on both sides of a point, with the chords and their lengths.
fn inner(chords: [Vector3<f64>; 2], lengths: [f64; 2]) -> Row {
    let [before, behind] = lengths;
    let sum = (chords[0] / before * behind + chords[1] / behind * before) * 3.0;
    Row { before: behind, at: 2.0 * (before + behind), behind: before, sum }
}

fn open(points: &[Point3<f64>], steps: &[f64], ends: [Option<Vector3<f64>>; 2]) -> Vec<Vector3<f64>> {
    let chord = |k: usize| points[k + 1] - points[k];
    // Directions may have any length; a speed of 1 fits the parameter.
    let ends = ends.map(|end| end.and_then(|direction| direction.try_normalize(1e-12)));
    let last = steps.len();
    let end = |direction: Option<Vector3<f64>>, k: usize, is_first: bool| {
        if let Some(direction) = direction {
            return Row { before: 0.0, at: 1.0, behind: 0.0, sum: direction };
        }
        let (before, behind) = if is_first { (0.0, 1.0) } else { (1.0, 0.0) };
        Row { before, at: 2.0, behind, sum: chord(k) / steps[k] * 3.0 }
    };
    let mut rows = vec![end(ends[0], 0, true)];
    rows.extend((1..last).map(|k| inner([chord(k - 1), chord(k)], [steps[k - 1], steps[k]])));
    rows.push(end(ends[1], last - 1, false));
    let right: Vec<Vector3<f64>> = rows.iter().map(|row| row.sum).collect();
    solve(&rows, right)
}

/// With the corners of the matrix by the formula of Sherman and Morrison. The first slope is the last one, too.
fn closed(points: &[Point3<f64>], steps: &[f64]) -> Vec<Vector3<f64>> {
    let count = steps.len();
    let chord = |k: usize| points[k + 1] - points[k];
    let row = |k: usize| {
        let before = (k + count - 1) % count;
        inner([chord(before), chord(k)], [steps[before], steps[k]])
    };
    let mut rows: Vec<Row> = (0..count).map(row).collect();
    let (top, bottom) = (rows[0].before, rows[count - 1].behind);
    let shift = -rows[0].at;
    rows[0].at -= shift;
    rows[count - 1].at -= top * bottom / shift;
    let right: Vec<Vector3<f64>> = rows.iter().map(|row| row.sum).collect();
    let found = solve(&rows, right);
    let mut unit = vec![0.0; count];
    unit[0] = shift;
    unit[count - 1] = bottom;
    let bent = solve(&rows, unit);
    let share = top / shift;
    let by = (found[0] + found[count - 1] * share) / (1.0 + bent[0] + bent[count - 1] * share);
    let mut slopes: Vec<Vector3<f64>> =
        found.iter().zip(&bent).map(|(slope, bent)| slope - by * *bent).collect();
    slopes.push(slopes[0]);
    slopes
}

/// The equations without corners, by elimination: what is at each point outweighs what is beside it.
fn solve<T>(rows: &[Row], mut right: Vec<T>) -> Vec<T>
where
    T: Copy + std::ops::Sub<Output = T> + std::ops::Mul<f64, Output = T> + std::ops::Div<f64, Output = T>,
{
    let mut at: Vec<f64> = rows.iter().map(|row| row.at).collect();
    for k in 1..rows.len() {
        let share = rows[k].before / at[k - 1];
        at[k] -= share * rows[k - 1].behind;
        right[k] = right[k] - right[k - 1] * share;
    }
    for k in (0..rows.len()).rev() {
        if k + 1 < rows.len() {
            right[k] = right[k] - right[k + 1] * rows[k].behind;
        }
        right[k] = right[k] / at[k];
    }
    right
}
