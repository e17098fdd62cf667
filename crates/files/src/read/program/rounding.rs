//! How far off the corners of a program are because its figures have few digits.

use nalgebra::Point3;

/// What the last digits of a program's figures stand for; 0 where they are exact.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(crate) struct Rounding {
    pub(crate) length_mm: f64,
    pub(crate) angle_deg: f64,
}

/// No corners are taken for one that are farther apart, mm: no wire is that thin.
const MOST_MM: f64 = 0.2;
/// So many standard deviations a path may be off.
const DEVIATIONS: f64 = 4.0;
/// Variance of what is rounded, as a share of the square of its last digit.
const VARIANCE: f64 = 1.0 / 12.0;

impl Rounding {
    /// How far a path (mm) may miss a corner to which it comes back, mm: each feed is off by up to half of its last digit, and each turn
    /// and bend moves what is farthest from it as far as its angle is off.
    pub(super) fn misses(self, path: &[Point3<f64>]) -> f64 {
        // Corners that follow one another are two.
        let lengths = path.windows(2).map(|pair| (pair[1] - pair[0]).norm());
        let shortest = lengths.filter(|length| *length > 0.0).fold(f64::INFINITY, f64::min);
        let steps = u32::try_from(path.len()).map_or(f64::INFINITY, f64::from);
        let [low, high] = [Point3::inf, Point3::sup].map(|of| path.iter().copied().reduce(|a, b| of(&a, &b)));
        let across = low.zip(high).map_or(0.0, |(low, high)| (high - low).norm());
        let turned = self.angle_deg.to_radians() * across;
        let variance = VARIANCE * steps * (self.length_mm.powi(2) + 2.0 * turned.powi(2));
        (DEVIATIONS * variance.sqrt()).min(MOST_MM).min(shortest / 2.0)
    }
}

#[cfg(test)]
mod tests {
    use super::super::super::{Format, ReadOptions, read};

    /// Vertices and edges of a program.
    fn counts(program: &str) -> [usize; 2] {
        let read = read(program.as_bytes(), "a.txt", Some(Format::Kit), &ReadOptions::default()).unwrap();
        [read.wireframe.vertex_count(), read.wireframe.edge_count()]
    }

    /// A curve in pieces as short as its last digit would be one point, and one in tenths lose every second corner.
    #[test]
    fn corners_that_follow_one_another_are_two() {
        assert_eq!(counts("F 0.1\nF 0.1\nF 0.1\n"), [4, 3]);
        assert_eq!(counts(&"F 0.15\nB 5\n".repeat(20)), [21, 20]);
        assert_eq!(counts(&"F 1\nB 9\n".repeat(20)), [21, 20]);
    }

    /// Three decimals of a square of a metre: its end is as far from its begin as its last digits let it be.
    #[test]
    fn what_comes_back_is_one_corner_where_rounding_explains_it() {
        let square = |last: &str| {
            format!("F 1000.000\nB 90.000\nF 1000.000\nB 90.000\nF 1000.000\nB 90.000\nF {last}\n")
        };
        assert_eq!(counts(&square("1000.000")), [4, 4]);
        assert_eq!(counts(&square("1000.020")), [4, 4]);
        // Through the first corner, to an end beyond it.
        assert_eq!(counts(&square("1000.500")), [5, 5]);
        // Whole angles are no rounder than the feeds.
        assert_eq!(counts("F 60.000\nB 90\nF 60.000\nB 90\nF 60.000\nB 90\nF 60.100\n"), [5, 5]);
    }
}
