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

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use wirebend_collide::between_pieces;

    use super::*;

    /// Of a coarse grid, so that points lie on pieces, pieces cross, and some share an end.
    fn any_points(count: usize) -> impl Strategy<Value = Vec<Point3<f64>>> {
        let at = prop::array::uniform3(0..5_i8).prop_map(|at| Point3::from(at.map(f64::from)));
        prop::collection::vec(at, count)
    }

    proptest! {
        /// One by one, by the point of each piece that is nearest.
        #[test]
        fn what_is_passed_is_what_lies_on_a_piece(ends in any_points(12), points in any_points(6)) {
            let pieces: Vec<[Point3<f64>; 2]> = ends.chunks(2).map(|pair| [pair[0], pair[1]]).collect();
            let passed = points_passed(&pieces, &points, Length::from_mm(1e-3).unwrap());
            for (piece, passed) in pieces.iter().zip(passed) {
                let along = |point: &Point3<f64>| {
                    let way = piece[1] - piece[0];
                    let part = (point - piece[0]).dot(&way) / way.norm_squared();
                    let off = (point - (piece[0] + way * part)).norm();
                    (off < 1e-6 && part > 0.0 && part < 1.0).then_some(part)
                };
                let parts: Vec<f64> = passed.iter().map(|&point| along(&points[point]).unwrap()).collect();
                prop_assert!(parts.is_sorted(), "{parts:?}");
                prop_assert_eq!(parts.len(), points.iter().filter_map(along).count());
            }
        }

        #[test]
        fn pieces_cross_where_both_are_near(ends in any_points(8)) {
            let pieces: Vec<[Point3<f64>; 2]> = ends.chunks(2).map(|pair| [pair[0], pair[1]]).collect();
            for crossing in crossings(&pieces, Length::from_mm(1e-3).unwrap()) {
                let near = pieces.iter().filter(|piece| between_pieces(&[crossing; 2], piece).0 < 1e-3);
                prop_assert!(near.count() >= 2, "{crossing}");
            }
        }
    }
}
