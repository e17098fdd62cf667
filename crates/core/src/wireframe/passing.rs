//! What straight pieces pass.

use nalgebra::{Point3, center};
use wirebend_collide::close_pairs;

use crate::units::Length;

/// No more pairs for each piece are looked at: more are near each other only where the whole is no larger than the distance.
const MOST_FOR_ONE: usize = 128;

/// For each piece the points that it passes between its ends within a distance, in their order along it.
#[must_use]
pub fn points_passed(pieces: &[[Point3<f64>; 2]], points: &[Point3<f64>], within: Length) -> Vec<Vec<usize>> {
    let all: Vec<[Point3<f64>; 2]> =
        pieces.iter().copied().chain(points.iter().map(|point| [*point; 2])).collect();
    let counts = |[piece, point]: [usize; 2]| piece < pieces.len() && point >= pieces.len();
    let mut passed = vec![Vec::new(); pieces.len()];
    for pair in close_pairs(&all, reach(within), MOST_FOR_ONE * all.len(), counts) {
        let ([piece, point], [along, _]) = (pair.pieces, pair.parts);
        if is_between_ends(along) {
            passed[piece].push((along, point - pieces.len()));
        }
    }
    passed
        .into_iter()
        .map(|mut of_piece| {
            of_piece.sort_by(|one, other| one.0.total_cmp(&other.0));
            of_piece.into_iter().map(|(_, point)| point).collect()
        })
        .collect()
}

/// Where two pieces cross between their ends, as near to each other as a distance.
#[must_use]
pub fn crossings(pieces: &[[Point3<f64>; 2]], within: Length) -> Vec<Point3<f64>> {
    let pairs = close_pairs(pieces, reach(within), MOST_FOR_ONE * pieces.len(), |_| true);
    let crosses = pairs.into_iter().filter(|pair| pair.parts.into_iter().all(is_between_ends));
    let at = |piece: usize, part: f64| {
        let [from, to] = pieces[piece];
        from + (to - from) * part
    };
    crosses
        .map(|pair| center(&at(pair.pieces[0], pair.parts[0]), &at(pair.pieces[1], pair.parts[1])))
        .collect()
}

fn is_between_ends(part: f64) -> bool {
    part > 0.0 && part < 1.0
}

/// What is as far as the distance counts, whatever arithmetic makes of it.
fn reach(within: Length) -> f64 {
    within.mm() * (1.0 + 1e-9) + 1e-9
}
