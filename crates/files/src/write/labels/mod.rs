//! What stands beside a drawn wire: at each bend the number of its step and its angle, at each edge its length.
//!
//! Labels cover neither the wire nor each other. Where there is no room beside it, a label has a leader; where there is none at all, an
//! angle or a length is left out and counted.

mod board;
mod spots;
#[cfg(test)]
mod tests;

use std::collections::BTreeSet;
use std::f64::consts::TAU;

use wirebend_core::units::DisplayUnit;

use super::drawing::{Bounds, Point, Shape};
use super::pdf::letters::width;
use crate::number::{fixed, length_in};
use board::{Beside, Board, Place};

pub use spots::LabelStep;
pub(super) use spots::{Spots, spots};

/// Capitals and digits are so much of their size high.
const CAPITALS: f64 = 0.72;
/// Between the wire and a label, in mm.
const GAP: f64 = 0.6;
/// How far labels may be from the wire without a leader, and with one, in mm; beyond the gap.
const NEAR: [f64; 3] = [0.4, 1.1, 1.9];
const FAR: [f64; 7] = [3.5, 5.5, 8.0, 11.0, 15.0, 20.0, 26.0];
/// Directions around a corner.
const AROUND: u32 = 16;

/// How labels are written.
#[derive(Debug, Clone, Copy)]
pub(super) struct Style {
    /// The size of letters in mm.
    pub size: f64,
    /// Half the width of the wire as it is drawn.
    pub half: f64,
    /// What they stay within.
    pub room: Option<Bounds>,
    /// What lengths are written in.
    pub unit: DisplayUnit,
}

/// A bend on the page.
#[derive(Debug, Clone, Copy)]
pub(super) struct BendAt {
    /// The number of its step, from 1.
    pub number: usize,
    pub at: Point,
    /// To the corners before and after it.
    pub sides: [Point; 2],
    pub angle_deg: f64,
}

/// An edge on the page.
#[derive(Debug, Clone, Copy)]
pub(super) struct EdgeAt {
    pub ends: [Point; 2],
    pub length_mm: f64,
}

/// A word beside a point, away from the wire there if it can be.
#[derive(Debug, Clone)]
pub(super) struct WordAt {
    pub word: String,
    pub at: Point,
    pub away: Point,
}

/// Labels that have a place.
#[derive(Debug, Default)]
pub(super) struct Labels {
    pub shapes: Vec<Shape>,
    /// What each of them takes.
    #[cfg(test)]
    pub frames: Vec<Bounds>,
    /// The bends that have their number, and those that have their angle too, by their places in the list that was given.
    pub numbered: BTreeSet<usize>,
    pub with_angle: BTreeSet<usize>,
    /// How many edges have no length.
    pub without_length: usize,
}

/// Labels for a wire that is drawn as `lines`. Numbers come before angles, and both before lengths: those are in the table too.
pub(super) fn labels(
    lines: &[[Point; 2]],
    words: &[WordAt],
    bends: &[BendAt],
    edges: &[EdgeAt],
    style: Style,
) -> Labels {
    let finite = |line: &&[[f64; 2]; 2]| line.iter().flatten().all(|c| c.is_finite());
    let lines: Vec<[Point; 2]> = lines.iter().filter(finite).copied().collect();
    let mut board = Board::new(&lines, style.half + GAP, style.room);
    let mut found = Labels::default();
    let both: Vec<f64> = NEAR.into_iter().chain(FAR).map(|reach| style.half + GAP + reach).collect();
    let (near, far) = both.split_at(NEAR.len());
    let beside = |points: Vec<Point>, directions: Vec<Point>| {
        // Letters that are a little off need no leader yet.
        Beside { points, directions, leader_from: far[0], start: style.half + GAP }
    };
    for WordAt { word, at, away } in words {
        let label = Label::text(word.clone());
        if let Some(place) = board.find(&beside(vec![*at], fan(*away)), label.frame(style.size), &both) {
            board.put(place);
            found.add(&label, place, style.size);
        }
    }
    let digits = bends.iter().map(|bend| bend.number).max().map_or(1, |most| most.to_string().len());
    // Every number first, then as many angles as there is room for.
    let mut numbers = Vec::new();
    for (index, bend) in bends.iter().enumerate() {
        let label = Label { number: Some(bend.number), digits, text: String::new() };
        let beside = beside(vec![bend.at], fan(outwards(bend.sides)));
        if let Some(place) = board.find(&beside, label.frame(style.size), &both) {
            numbers.push((index, label, beside, place, board.put(place)));
        }
    }
    for (index, number, beside, place, put) in numbers {
        let bend = &bends[index];
        let text = format!("{}°", fixed(bend.angle_deg, 1));
        let full = Label { number: Some(bend.number), digits, text };
        board.take_away(put);
        let size = full.frame(style.size);
        let larger = board.find(&beside, size, near).or_else(|| board.find(&beside, size, far));
        let (label, place) = match larger {
            Some(larger) => (full, larger),
            None => (number, place),
        };
        board.put(place);
        found.add(&label, place, style.size);
        found.numbered.insert(index);
        if larger.is_some() {
            found.with_angle.insert(index);
        }
    }
    let centre = middle(&lines);
    for edge in edges {
        let label = Label::text(length_in(style.unit, edge.length_mm, [1, 3]));
        let (size, [beside_it, around]) =
            (label.frame(style.size), along(edge, centre).map(|(p, d)| beside(p, d)));
        match board.find(&beside_it, size, near).or_else(|| board.find(&around, size, far)) {
            Some(place) => {
                board.put(place);
                found.add(&label, place, style.size);
            }
            None => found.without_length += 1,
        }
    }
    found
}

/// "2 numbers, 3 angles and 12 lengths": what is not beside the wire, as words; `None` where all is. Without its number a bend has no angle
/// either.
pub(super) fn left_out(numbers: usize, angles: usize, lengths: usize) -> Option<String> {
    let all = [(numbers, "number"), (angles, "angle"), (lengths, "length")];
    let some = all.into_iter().filter(|(count, _)| *count > 0);
    let words: Vec<String> =
        some.map(|(count, what)| format!("{count} {what}{}", if count == 1 { "" } else { "s" })).collect();
    match &words[..] {
        [] => None,
        [only] => Some(only.clone()),
        [first @ .., last] => Some(format!("{} and {last}", first.join(", "))),
    }
}

impl Labels {
    fn add(&mut self, label: &Label, place: Place, size: f64) {
        #[cfg(test)]
        self.frames.push(place.frame);
        self.shapes.extend(label.shapes(place.frame, size));
        self.shapes.extend(place.leader.map(Shape::Line));
    }
}

/// A number in a circle and a text beside it, or one of both.
struct Label {
    number: Option<usize>,
    /// How many digits its circle has room for: all circles of a drawing are as large.
    digits: usize,
    text: String,
}

impl Label {
    fn text(text: String) -> Self {
        Self { number: None, digits: 0, text }
    }

    /// The radius of the circle around its number.
    fn circle(&self, size: f64) -> Option<f64> {
        self.number?;
        Some((width(&"0".repeat(self.digits), size, false) / 2.0).hypot(size * CAPITALS / 2.0) + size * 0.14)
    }

    /// Width and height.
    fn frame(&self, size: f64) -> [f64; 2] {
        let text = width(&self.text, size, false);
        match self.circle(size) {
            Some(radius) if self.text.is_empty() => [2.0 * radius; 2],
            Some(radius) => [2.0 * radius + size * 0.3 + text, 2.0 * radius],
            None => [text, size * CAPITALS],
        }
    }

    fn shapes(&self, [left, bottom, _, top]: Bounds, size: f64) -> Vec<Shape> {
        let y = f64::midpoint(bottom, top);
        let base = y - size * CAPITALS / 2.0;
        let mut shapes = Vec::new();
        let mut x = left;
        if let (Some(number), Some(radius)) = (self.number, self.circle(size)) {
            let text = number.to_string();
            let at = [x + radius - width(&text, size, false) / 2.0, base];
            shapes.push(Shape::Circle { centre: [x + radius, y], radius });
            shapes.push(Shape::Text { at, size, text });
            x += 2.0 * radius + size * 0.3;
        }
        if !self.text.is_empty() {
            shapes.push(Shape::Text { at: [x, base], size, text: self.text.clone() });
        }
        shapes
    }
}

/// Where to stand beside an edge, and in which directions: the middle first, and away from the middle of the drawing; then where a
/// leader may go. An edge that is seen as a point has no sides.
fn along(edge: &EdgeAt, centre: Point) -> [(Vec<Point>, Vec<Point>); 2] {
    let [a, b] = edge.ends;
    let at = |t: f64| [a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t];
    let length = (b[0] - a[0]).hypot(b[1] - a[1]);
    if length < 0.5 {
        let around = || (vec![at(0.5)], fan([0.0, 1.0]));
        return [around(), around()];
    }
    let aside = [-(b[1] - a[1]) / length, (b[0] - a[0]) / length];
    let [x, y] = at(0.5);
    let outwards = aside[0] * (x - centre[0]) + aside[1] * (y - centre[1]) >= 0.0;
    let aside = if outwards { aside } else { aside.map(|c| -c) };
    let points = [0.5, 0.35, 0.65, 0.2, 0.8].map(at).to_vec();
    [(points.clone(), vec![aside, aside.map(|c| -c)]), (points, fan(aside))]
}

/// The side of a corner on which the wire is not.
fn outwards(sides: [Point; 2]) -> Point {
    let [a, b] = sides.map(unit);
    let sum = [a[0] + b[0], a[1] + b[1]];
    // Along a straight line both sides are as good.
    if sum[0].hypot(sum[1]) < 1e-6 { [-a[1], a[0]] } else { sum.map(|c| -c) }
}

/// Directions all around, those that are nearest to one first.
fn fan(first: Point) -> Vec<Point> {
    let [x, y] = unit(first);
    let begin = if x == 0.0 && y == 0.0 { TAU / 4.0 } else { y.atan2(x) };
    let turn = |k: u32| {
        let steps = f64::from(k.div_ceil(2)) * if k.is_multiple_of(2) { 1.0 } else { -1.0 };
        let (sin, cos) = (begin + steps * TAU / f64::from(AROUND)).sin_cos();
        [cos, sin]
    };
    (0..AROUND).map(turn).collect()
}

fn unit([x, y]: Point) -> Point {
    let length = x.hypot(y);
    if length > 1e-9 { [x / length, y / length] } else { [0.0; 2] }
}

fn middle(lines: &[[Point; 2]]) -> Point {
    let points = || lines.iter().flatten();
    let half = |k: usize| {
        let low = points().fold(f64::INFINITY, |low, point| low.min(point[k]));
        let high = points().fold(f64::NEG_INFINITY, |high, point| high.max(point[k]));
        if low <= high { f64::midpoint(low, high) } else { 0.0 }
    };
    [half(0), half(1)]
}
