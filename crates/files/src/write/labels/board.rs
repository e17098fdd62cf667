//! Where there is room on a drawing.

use std::collections::HashMap;

use crate::write::drawing::{Bounds, Point, crosses};

/// Between two labels, in mm.
const APART: f64 = 0.5;
/// A leader stays so far away from lines that it does not belong to, in mm.
const LEADER: f64 = 0.3;
/// The least size of a cell in mm, and the most cells along one side of a drawing.
const CELL: f64 = 8.0;
const MAX_CELLS: f64 = 256.0;

/// What takes room.
#[derive(Debug, Clone, Copy)]
enum Taken {
    /// A line with how far labels stay away from it.
    Line([Point; 2], f64),
    Label(Bounds),
}

/// What is on a drawing, to be asked whether something else fits.
pub(super) struct Board {
    /// Labels stay within.
    room: Option<Bounds>,
    cell: f64,
    cells: HashMap<[i64; 2], Vec<usize>>,
    taken: Vec<Option<Taken>>,
}

/// A place that was found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Place {
    pub frame: Bounds,
    /// From beside the place that it is of to the frame.
    pub leader: Option<[Point; 2]>,
}

impl Board {
    /// A drawing of lines that labels stay `clear` mm away from.
    pub fn new(lines: &[[Point; 2]], clear: f64, room: Option<Bounds>) -> Self {
        let longest = lines.iter().map(|[a, b]| (a[0] - b[0]).abs().max((a[1] - b[1]).abs()));
        let cell = longest.fold(CELL, |cell, length| cell.max(length / MAX_CELLS));
        let mut board = Self { room, cell, cells: HashMap::new(), taken: Vec::new() };
        for line in lines {
            board.take(Taken::Line(*line, clear));
        }
        board
    }

    /// Puts a label where it was found; what is returned takes it away again.
    pub fn put(&mut self, place: Place) -> [Option<usize>; 2] {
        let leader = place.leader.map(|line| self.take(Taken::Line(line, APART)));
        [Some(self.take(Taken::Label(place.frame))), leader]
    }

    pub fn take_away(&mut self, put: [Option<usize>; 2]) {
        for index in put.into_iter().flatten() {
            self.taken[index] = None;
        }
    }

    /// A place for a label of a size beside one of several points: in one of the directions, which are unit vectors, as near as
    /// `reaches` says, in this order. From `leader_from` mm on it has a leader, which begins `start` mm from the point.
    pub fn find(&self, beside: &Beside, [width, height]: [f64; 2], reaches: &[f64]) -> Option<Place> {
        for &reach in reaches {
            for at in &beside.points {
                for [x, y] in &beside.directions {
                    let out = reach + x.abs() * width / 2.0 + y.abs() * height / 2.0;
                    let centre = [at[0] + x * out, at[1] + y * out];
                    let frame = [
                        centre[0] - width / 2.0,
                        centre[1] - height / 2.0,
                        centre[0] + width / 2.0,
                        centre[1] + height / 2.0,
                    ];
                    if !self.is_free(frame) {
                        continue;
                    }
                    if reach < beside.leader_from {
                        return Some(Place { frame, leader: None });
                    }
                    // From the middle to where the direction leaves the frame.
                    let inside = (width / 2.0 / x.abs()).min(height / 2.0 / y.abs());
                    let on = |distance: f64| [at[0] + x * distance, at[1] + y * distance];
                    let leader = [on(beside.start), on(out - inside - LEADER)];
                    if self.is_free_of_lines(leader) {
                        return Some(Place { frame, leader: Some(leader) });
                    }
                }
            }
        }
        None
    }

    fn is_free(&self, frame: Bounds) -> bool {
        let inside = self.room.is_none_or(|room| {
            frame[0] >= room[0] && frame[1] >= room[1] && frame[2] <= room[2] && frame[3] <= room[3]
        });
        inside
            && self.near(grown(frame, APART)).all(|taken| match taken {
                Taken::Line([a, b], clear) => !crosses(a, b, grown(frame, clear)),
                Taken::Label(other) => !overlap(other, grown(frame, APART)),
            })
    }

    fn is_free_of_lines(&self, leader: [Point; 2]) -> bool {
        let [a, b] = leader;
        let around = [a[0].min(b[0]), a[1].min(b[1]), a[0].max(b[0]), a[1].max(b[1])];
        self.near(grown(around, LEADER)).all(|taken| match taken {
            Taken::Line(line, clear) => distance(leader, line) > LEADER.max(clear - APART),
            Taken::Label(other) => !crosses(a, b, grown(other, LEADER)),
        })
    }

    fn take(&mut self, taken: Taken) -> usize {
        let index = self.taken.len();
        match taken {
            Taken::Label(frame) => self.enter(frame, index),
            Taken::Line([a, b], clear) => {
                #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // MAX_CELLS at most
                let parts = ((a[0] - b[0]).hypot(a[1] - b[1]) / self.cell).ceil().clamp(1.0, 1e4) as u32;
                let at = |k: u32| {
                    let along = f64::from(k) / f64::from(parts);
                    [a[0] + (b[0] - a[0]) * along, a[1] + (b[1] - a[1]) * along]
                };
                for k in 0..parts {
                    let (a, b) = (at(k), at(k + 1));
                    let around = [a[0].min(b[0]), a[1].min(b[1]), a[0].max(b[0]), a[1].max(b[1])];
                    self.enter(grown(around, clear), index);
                }
            }
        }
        self.taken.push(Some(taken));
        index
    }

    fn enter(&mut self, bounds: Bounds, index: usize) {
        for cell in self.cells_of(bounds) {
            let all = self.cells.entry(cell).or_default();
            if all.last() != Some(&index) {
                all.push(index);
            }
        }
    }

    fn near(&self, bounds: Bounds) -> impl Iterator<Item = Taken> {
        let cells = self.cells_of(bounds).filter_map(|cell| self.cells.get(&cell));
        cells.flatten().filter_map(|&index| self.taken[index])
    }

    fn cells_of(&self, bounds: Bounds) -> impl Iterator<Item = [i64; 2]> + use<> {
        #[allow(clippy::cast_possible_truncation)] // a drawing is no larger than 1e9 mm
        let [left, bottom, right, top] = bounds.map(|c| (c / self.cell).floor() as i64);
        (left..=right).flat_map(move |x| (bottom..=top).map(move |y| [x, y]))
    }
}

/// What a label is looked for beside.
pub(super) struct Beside {
    /// The best first.
    pub points: Vec<Point>,
    /// The best first.
    pub directions: Vec<Point>,
    pub leader_from: f64,
    pub start: f64,
}

pub(super) fn grown([left, bottom, right, top]: Bounds, by: f64) -> Bounds {
    [left - by, bottom - by, right + by, top + by]
}

pub(super) fn overlap(a: Bounds, b: Bounds) -> bool {
    a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3]
}

/// Between two lines: zero where they cross.
fn distance(one: [Point; 2], other: [Point; 2]) -> f64 {
    let side = |[a, b]: [Point; 2], p: Point| (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
    let parts = |line: [Point; 2], [p, q]: [Point; 2]| side(line, p) * side(line, q) < 0.0;
    let ends = |line: [Point; 2], [p, q]: [Point; 2]| to_point(line, p).min(to_point(line, q));
    if parts(one, other) && parts(other, one) { 0.0 } else { ends(one, other).min(ends(other, one)) }
}

fn to_point([a, b]: [Point; 2], p: Point) -> f64 {
    let (along, from) = ([b[0] - a[0], b[1] - a[1]], [p[0] - a[0], p[1] - a[1]]);
    let square = along[0] * along[0] + along[1] * along[1];
    let at =
        if square > 0.0 { ((from[0] * along[0] + from[1] * along[1]) / square).clamp(0.0, 1.0) } else { 0.0 };
    (from[0] - along[0] * at).hypot(from[1] - along[1] * at)
}
