//! Which points are one: a point that lies on an earlier one is that one.

use std::collections::HashMap;

use crate::units::Length;
use nalgebra::{Point3, Vector3};

/// Edge of a cell of the grid, in tolerances: a point reaches into few cells, and however dense points are, fewer than 200 that are
/// farther than the tolerance from each other fit into one.
const CELL: f64 = 4.0;

/// Points that are farther from each other than a tolerance, in a grid of cells.
///
/// However many points are put in, a cell holds fewer than 200, so the time is linear even where a
/// whole model is smaller than the tolerance.
#[derive(Debug)]
pub struct Welder {
    tolerance: f64,
    cells: HashMap<[i64; 3], Vec<(u32, Point3<f64>)>>,
}

impl Welder {
    /// A grid without points.
    #[must_use]
    pub fn new(tolerance: Length) -> Self {
        Self { tolerance: tolerance.mm(), cells: HashMap::new() }
    }

    /// The first point within the tolerance (mm), or `index` itself, which is then remembered.
    ///
    /// A point that is moved is moved by no more than the tolerance. Points that are not finite are
    /// never within it.
    pub fn put(&mut self, index: u32, point: Point3<f64>) -> u32 {
        self.near(point).unwrap_or_else(|| {
            self.cells.entry(self.cell(point)).or_default().push((index, point));
            index
        })
    }

    /// The first remembered point within the tolerance (mm).
    #[must_use]
    pub fn near(&self, point: Point3<f64>) -> Option<u32> {
        // What is rounded must not hide a point at the very end of the tolerance.
        let reach = Vector3::repeat(self.tolerance * (1.0 + 1e-9));
        let (low, high) = (self.cell(point - reach), self.cell(point + reach));
        let cells = (low[0]..=high[0])
            .flat_map(|x| (low[1]..=high[1]).flat_map(move |y| (low[2]..=high[2]).map(move |z| [x, y, z])));
        let near = cells.filter_map(|cell| self.cells.get(&cell)).flatten();
        let close = near.filter(|(_, other)| (other - point).norm() <= self.tolerance);
        close.map(|&(index, _)| index).min()
    }

    fn cell(&self, point: Point3<f64>) -> [i64; 3] {
        // A cell is never smaller than what a coordinate of a kilometre can resolve.
        let size = (CELL * self.tolerance).max(1e-9);
        #[allow(clippy::cast_possible_truncation)] // saturates, which keeps neighbours together
        [point.x, point.y, point.z].map(|c| (c / size).floor() as i64)
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn put_all(points: impl IntoIterator<Item = f64>) -> Vec<u32> {
        let mut welder = Welder::new(Length::from_mm(1.0).unwrap());
        points.into_iter().zip(0..).map(|(x, k)| welder.put(k, Point3::new(x, 0.0, 0.0))).collect()
    }

    #[test]
    fn a_chain_is_not_drawn_together() {
        assert_eq!(put_all([0.0, 0.9, 1.8, -0.9, 1.0, f64::NAN]), [0, 0, 2, 0, 0, 5]);
    }

    #[test]
    fn points_across_the_edge_of_a_cell_are_near_each_other() {
        // The cells of a tolerance of 1 mm end at multiples of 4 mm.
        assert_eq!(put_all([3.5, 4.5, 8.0, 7.0, 9.0]), [0, 0, 2, 2, 2]);
        assert_eq!(put_all([3.5, 4.6, -4.0, -5.0, -5.1]), [0, 1, 2, 2, 4]);
    }

    proptest! {
        /// Whatever the grid leaves out is farther than the tolerance.
        #[test]
        fn it_finds_what_a_look_at_every_point_finds(
            points in prop::collection::vec(prop::array::uniform3(-24_i32..24), 0..60),
            at in -1e5..1e5_f64,
        ) {
            // In halves of the tolerance: many are just so far from each other, at the edges of cells, too.
            let points: Vec<Point3<f64>> = points.iter().map(|half| {
                Point3::from(half.map(|c| f64::from(c) * 0.5 + at.round()))
            }).collect();
            let mut welder = Welder::new(Length::from_mm(1.0).unwrap());
            let mut kept: Vec<(u32, Point3<f64>)> = Vec::new();
            for (index, &point) in (0..).zip(&points) {
                let near = kept.iter().find(|(_, other)| (other - point).norm() <= 1.0);
                let wanted = near.map_or(index, |&(first, _)| first);
                if wanted == index {
                    kept.push((index, point));
                }
                prop_assert_eq!(welder.put(index, point), wanted);
            }
        }
    }

    #[test]
    fn a_model_smaller_than_the_tolerance_takes_no_longer() {
        // With a comparison of all pairs this would take a minute.
        let indices = put_all((0..50_000).map(|k| f64::from(k) * 1e-9));
        assert!(indices.iter().all(|&index| index == 0));
    }
}
