//! Fewer points for the same line (Ramer, Douglas and Peucker).

use nalgebra::Point3;

use super::distance_to_segment;
use crate::units::Length;

/// The indices of the points that are kept so that no point of the polyline is farther than
/// `tolerance` from the simplified one. The first and the last point are always kept; fewer than
/// three points are kept as they are.
///
/// ```
/// use nalgebra::Point3;
/// use wirebend_core::{curve::simplify, units::Length};
/// let bow = [(0., 0.), (10., 0.1), (20., 0.), (20., 9.)].map(|(x, y)| Point3::new(x, y, 0.));
/// assert_eq!(simplify(&bow, Length::from_mm(0.2)?), [0, 2, 3]);
/// # Ok::<(), wirebend_core::units::NotFinite>(())
/// ```
#[must_use]
pub fn simplify(points: &[Point3<f64>], tolerance: Length) -> Vec<usize> {
    let mut kept = vec![false; points.len()];
    if let (Some(first), true) = (kept.first_mut(), points.len() > 1) {
        *first = true;
    }
    if let Some(last) = kept.last_mut() {
        *last = true;
    }
    let mut spans = vec![(0, points.len().saturating_sub(1))];
    while let Some((from, to)) = spans.pop() {
        let distance = |k: usize| distance_to_segment(&points[k], &points[from], &points[to]);
        let farthest = (from + 1..to).max_by(|&a, &b| distance(a).total_cmp(&distance(b)));
        if let Some(k) = farthest.filter(|&k| distance(k) > tolerance.mm()) {
            kept[k] = true;
            spans.push((from, k));
            spans.push((k, to));
        }
    }
    (0..points.len()).filter(|&k| kept[k]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn short_lines_are_kept() {
        let tolerance = Length::from_mm(1.0).unwrap();
        assert_eq!(simplify(&[], tolerance), [0; 0]);
        assert_eq!(simplify(&[Point3::origin()], tolerance), [0]);
        assert_eq!(simplify(&[Point3::origin(); 2], tolerance), [0, 1]);
    }

    proptest! {
        #[test]
        fn no_point_is_farther_away_than_asked(
            points in prop::collection::vec(prop::array::uniform3(-50.0..50.0_f64).prop_map(Point3::from), 2..80),
            tolerance in 0.0..40.0_f64,
        ) {
            let kept = simplify(&points, Length::from_mm(tolerance).unwrap());
            prop_assert_eq!((kept[0], kept[kept.len() - 1]), (0, points.len() - 1));
            for pair in kept.windows(2) {
                for point in &points[pair[0]..=pair[1]] {
                    prop_assert!(distance_to_segment(point, &points[pair[0]], &points[pair[1]]) <= tolerance + 1e-12);
                }
            }
        }
    }
}
