//! A drawing that is larger than the paper, divided among pages that overlap.

use std::collections::BTreeSet;

use crate::write::drawing::{Bounds, Drawing, Point, crosses};

/// How far a page continues beyond the one before it, in mm.
pub(super) const OVERLAP: f64 = 10.0;

/// A page by its row from the top and its column from the left, both from 0.
pub(super) type Tile = (u32, u32);

/// How a drawing is divided.
pub(super) struct Tiling {
    /// The upper left corner of the first page, in the drawing.
    corner: Point,
    /// Width and height of what a page shows, in mm.
    pub window: [f64; 2],
    pub columns: u32,
    pub rows: u32,
    /// The pages on which something is.
    pub used: BTreeSet<Tile>,
}

impl Tiling {
    /// Divides a drawing for windows of a size, larger than the overlap. `None` when more pages than `max_pages` have
    /// something on them.
    pub fn new(drawing: &Drawing, window: [f64; 2], chord: f64, max_pages: usize) -> Option<Self> {
        let [left, bottom, right, top] = drawing.bounds();
        let columns = count(right - left, window[0])?;
        let rows = count(top - bottom, window[1])?;
        let mut tiling = Self { corner: [left, top], window, columns, rows, used: BTreeSet::new() };
        for (_, shape) in &drawing.shapes {
            for pair in shape.points(chord).windows(2) {
                tiling.mark(pair[0], pair[1], chord);
                if tiling.used.len() > max_pages {
                    return None;
                }
            }
        }
        Some(tiling)
    }

    /// What a page shows of the drawing.
    pub fn shown(&self, (row, column): Tile) -> Bounds {
        let left = self.corner[0] + f64::from(column) * (self.window[0] - OVERLAP);
        let top = self.corner[1] - f64::from(row) * (self.window[1] - OVERLAP);
        [left, top - self.window[1], left + self.window[0], top]
    }

    /// Pages by column and row: A1 is the first, B1 is to its right.
    pub fn name((row, column): Tile) -> String {
        let (mut letters, mut rest) = (String::new(), column + 1);
        while rest > 0 {
            let digit = u8::try_from((rest - 1) % 26).unwrap_or_default();
            letters.insert(0, char::from(b'A' + digit));
            rest = (rest - 1) / 26;
        }
        format!("{letters}{}", row + 1)
    }

    /// Marks the pages that a line passes, with the ink of its width.
    fn mark(&mut self, from: Point, to: Point, ink: f64) {
        let length = (to[0] - from[0]).hypot(to[1] - from[1]);
        let min_side = (self.window[0].min(self.window[1]) - OVERLAP).max(1.0);
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        // from 1, and a drawing has few pages
        let parts = (length / min_side).ceil().clamp(1.0, 1e6) as u32;
        let at = |k: u32| {
            let along = f64::from(k) / f64::from(parts);
            [from[0] + (to[0] - from[0]) * along, from[1] + (to[1] - from[1]) * along]
        };
        // Parts no longer than a page touch few of them, each of which is asked.
        for k in 0..parts {
            let (a, b) = (at(k), at(k + 1));
            let columns = self.range(0, a[0].min(b[0]) - self.corner[0], a[0].max(b[0]) - self.corner[0]);
            let rows = self.range(1, self.corner[1] - a[1].max(b[1]), self.corner[1] - a[1].min(b[1]));
            for row in rows {
                for column in columns.clone() {
                    let [left, bottom, right, top] = self.shown((row, column));
                    if crosses(a, b, [left - ink, bottom - ink, right + ink, top + ink]) {
                        self.used.insert((row, column));
                    }
                }
            }
        }
    }

    /// The columns (axis 0) or rows (1) that may show what is so far from the corner; one more to both sides.
    fn range(&self, axis: usize, min: f64, max: f64) -> std::ops::RangeInclusive<u32> {
        let (step, count) = (self.window[axis] - OVERLAP, [self.columns, self.rows][axis]);
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // within the count
        let at = |value: f64| (value / step).floor().clamp(0.0, f64::from(count - 1)) as u32;
        at(min - self.window[axis])..=at(max + step)
    }
}

/// How many windows of a size, overlapping, cover a length.
fn count(length: f64, window: f64) -> Option<u32> {
    let count = ((length - OVERLAP) / (window - OVERLAP)).ceil().max(1.0);
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // asked before
    (count < 1e6).then_some(count as u32)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::write::drawing::{Layer, Shape};

    fn drawing(points: Vec<Point>) -> Drawing {
        Drawing { shapes: vec![(Layer::Wire, Shape::Chain(points))], ..Drawing::default() }
    }

    fn is_on(tiling: &Tiling, [x, y]: Point) -> bool {
        tiling.used.iter().any(|&tile| {
            let [left, bottom, right, top] = tiling.shown(tile);
            (left - 1e-9..=right + 1e-9).contains(&x) && (bottom - 1e-9..=top + 1e-9).contains(&y)
        })
    }

    #[test]
    fn pages_are_counted_with_their_overlap() {
        // 190 mm wide windows: 190, 370, 550 mm.
        for (width, columns) in [(0.0, 1), (189.0, 1), (190.0, 1), (190.1, 2), (370.0, 2), (370.1, 3)] {
            assert_eq!(count(width, 190.0), Some(columns), "{width}");
        }
        assert_eq!(count(1e12, 190.0), None);
        assert_eq!(count(f64::NAN, 190.0), Some(1));
        let names = [(0, 0), (2, 1), (0, 25), (0, 26), (9, 701), (0, 702)].map(Tiling::name);
        assert_eq!(names, ["A1", "B3", "Z1", "AA1", "ZZ10", "AAA1"]);
    }

    #[test]
    fn a_diagonal_leaves_the_other_corners_out() {
        let tiling = Tiling::new(&drawing(vec![[0.0, 0.0], [910.0, -910.0]]), [190.0; 2], 0.1, 100).unwrap();
        assert_eq!((tiling.columns, tiling.rows), (5, 5));
        assert!(
            tiling.used.contains(&(4, 4)) && !tiling.used.contains(&(0, 4)) && !tiling.used.contains(&(4, 0))
        );
        assert!(Tiling::new(&drawing(vec![[0.0, 0.0], [910.0, -910.0]]), [190.0; 2], 0.1, 4).is_none());
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]

        #[test]
        fn every_point_is_on_a_page_and_no_page_is_empty(
            points in prop::collection::vec(prop::array::uniform2(-900.0..900.0_f64), 2..9),
            window in prop::array::uniform2(50.0..300.0_f64),
        ) {
            let tiling = Tiling::new(&drawing(points.clone()), window, 0.05, 100_000).unwrap();
            let mut seen = BTreeSet::new();
            for pair in points.windows(2) {
                for k in 0..=500 {
                    let along = f64::from(k) / 500.0;
                    let at = [0, 1].map(|c| pair[0][c] + (pair[1][c] - pair[0][c]) * along);
                    prop_assert!(is_on(&tiling, at), "{at:?}");
                    seen.extend(tiling.used.iter().copied().filter(|&tile| {
                        // A line that is walked in steps of 5.1 mm at most comes as near to each page that it passes.
                        let [left, bottom, right, top] = tiling.shown(tile);
                        let near = 5.2;
                        at[0] > left - near && at[0] < right + near && at[1] > bottom - near && at[1] < top + near
                    }));
                }
            }
            prop_assert_eq!(&seen, &tiling.used);
            // All pages together cover what encloses the drawing.
            let (last, [left, bottom, right, top]) = ((tiling.rows - 1, tiling.columns - 1), drawing(points).bounds());
            let (first, last) = (tiling.shown((0, 0)), tiling.shown(last));
            prop_assert!(first[0] <= left && first[3] >= top && last[2] >= right - 1e-9 && last[1] <= bottom + 1e-9);
        }
    }
}
