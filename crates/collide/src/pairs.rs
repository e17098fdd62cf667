//! Pairs of straight pieces that come close to each other.

use std::ops::ControlFlow;

use nalgebra::{Point3, Vector3};

use crate::between_pieces;

/// Two pieces that come closer than asked.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ClosePair {
    /// Their indices, the lower one first.
    pub pieces: [usize; 2],
    /// How far they are apart.
    pub distance: f64,
    /// Where that is on each of them, from 0 at its first end to 1 at its second.
    pub parts: [f64; 2],
}

/// So few pieces are compared one by one.
const FEW: usize = 8;

/// All pairs of pieces that come closer than `reach`, in order of their indices; only those for which `counts` says so.
///
/// No more than `most` pairs with boxes so close are looked at: where everything is within reach of everything, the time
/// would grow with the square of their number. Pairs of the first pieces are found then, and not those of the others.
#[must_use]
pub fn close_pairs(
    pieces: &[[Point3<f64>; 2]],
    reach: f64,
    most: usize,
    counts: impl Fn([usize; 2]) -> bool,
) -> Vec<ClosePair> {
    let corners: Vec<Corners> = pieces.iter().map(Corners::of).collect();
    let mut order: Vec<usize> = (0..pieces.len()).collect();
    let mut tree = Vec::new();
    if !order.is_empty() {
        grow(&mut tree, &mut order, &corners, 0);
    }
    let search = Search { corners: &corners, order: &order, tree: &tree, reach };
    let mut found = Vec::new();
    let mut left = most;
    for index in 0..pieces.len() {
        let stopped = search.look(0, index, &mut |other| {
            // Both pieces of a pair come to it.
            if other <= index {
                return ControlFlow::Continue(());
            }
            let Some(rest) = left.checked_sub(1) else { return ControlFlow::Break(()) };
            left = rest;
            if counts([index, other]) {
                let (distance, parts) = between_pieces(&pieces[index], &pieces[other]);
                if distance < reach {
                    found.push(ClosePair { pieces: [index, other], distance, parts });
                }
            }
            ControlFlow::Continue(())
        });
        if stopped.is_break() {
            break;
        }
    }
    found.sort_by_key(|pair| pair.pieces);
    found
}

/// The corners of a box along the axes.
#[derive(Debug, Clone, Copy)]
struct Corners {
    low: Vector3<f64>,
    high: Vector3<f64>,
}

impl Corners {
    fn of([from, to]: &[Point3<f64>; 2]) -> Self {
        Self { low: from.coords.inf(&to.coords), high: from.coords.sup(&to.coords) }
    }

    fn with(&self, other: &Self) -> Self {
        Self { low: self.low.inf(&other.low), high: self.high.sup(&other.high) }
    }

    fn is_within(&self, reach: f64, other: &Self) -> bool {
        let gap = (self.low - other.high).sup(&(other.low - self.high));
        gap.max() < reach
    }
}

/// A box around a run of the order.
struct Node {
    corners: Corners,
    first: usize,
    end: usize,
    /// The second half; the first one comes right after this one. None: its pieces are compared one by one.
    second: Option<usize>,
}

/// Adds the boxes of a run of the order, and sorts it along the longest edge of its box.
fn grow(tree: &mut Vec<Node>, order: &mut [usize], corners: &[Corners], first: usize) -> usize {
    let boxes = order.iter().map(|&index| corners[index]);
    let Some(around) = boxes.reduce(|one, other| one.with(&other)) else { return tree.len() };
    let at = tree.len();
    tree.push(Node { corners: around, first, end: first + order.len(), second: None });
    if order.len() > FEW {
        let axis = (around.high - around.low).imax();
        let middle = order.len() / 2;
        let place = |index: &usize| corners[*index].low[axis] + corners[*index].high[axis];
        order.select_nth_unstable_by(middle, |one, other| place(one).total_cmp(&place(other)));
        let (one, other) = order.split_at_mut(middle);
        grow(tree, one, corners, first);
        tree[at].second = Some(grow(tree, other, corners, first + middle));
    }
    at
}

struct Search<'a> {
    corners: &'a [Corners],
    order: &'a [usize],
    tree: &'a [Node],
    reach: f64,
}

impl Search<'_> {
    /// Gives each piece in a node whose box is near that of piece `index`, until told to stop.
    fn look(
        &self,
        node: usize,
        index: usize,
        near: &mut impl FnMut(usize) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        let Some(Node { corners, first, end, second }) = self.tree.get(node) else {
            return ControlFlow::Continue(());
        };
        if !corners.is_within(self.reach, &self.corners[index]) {
            return ControlFlow::Continue(());
        }
        if let Some(second) = *second {
            self.look(node + 1, index, near)?;
            return self.look(second, index, near);
        }
        for &other in &self.order[*first..*end] {
            if self.corners[other].is_within(self.reach, &self.corners[index]) {
                near(other)?;
            }
        }
        ControlFlow::Continue(())
    }
}
