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
/// No more than `most` pairs with boxes so close are judged, and as many looked at before that is known: where everything is within
/// reach of everything, the time would grow with the square of their number. Pairs of the first pieces are found then, and not those
/// of the others.
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
    let judge = |pair: [usize; 2]| {
        if counts(pair) {
            let (distance, parts) = between_pieces(&pieces[pair[0]], &pieces[pair[1]]);
            if distance < reach {
                found.push(ClosePair { pieces: pair, distance, parts });
            }
        }
    };
    match search.near(most) {
        Some(near) => near.into_iter().for_each(judge),
        None => search.near_in_order(most, judge),
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
        (0..3).all(|axis| {
            self.low[axis] - other.high[axis] < reach && other.low[axis] - self.high[axis] < reach
        })
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
    /// The pairs with boxes within reach; `None` where there are more than `most`.
    fn near(&self, most: usize) -> Option<Vec<[usize; 2]>> {
        let mut found = Vec::new();
        let complete = self.near_between([0, 0], &mut |pair| {
            if found.len() == most {
                return ControlFlow::Break(());
            }
            found.push(pair);
            ControlFlow::Continue(())
        });
        complete.is_continue().then_some(found)
    }

    /// Gives each pair of a piece in one node and one in the other with boxes within reach, until told to stop. Of a node with itself
    /// each pair comes once.
    fn near_between(
        &self,
        [one, other]: [usize; 2],
        near: &mut impl FnMut([usize; 2]) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        let (Some(ours), Some(theirs)) = (self.tree.get(one), self.tree.get(other)) else {
            return ControlFlow::Continue(());
        };
        if !ours.corners.is_within(self.reach, &theirs.corners) {
            return ControlFlow::Continue(());
        }
        let size = |node: &Node| node.end - node.first;
        match (ours.second, theirs.second) {
            (Some(second), _) if one == other => {
                self.near_between([one + 1; 2], near)?;
                self.near_between([one + 1, second], near)?;
                self.near_between([second; 2], near)
            }
            (Some(second), theirs_second) if theirs_second.is_none() || size(ours) >= size(theirs) => {
                self.near_between([one + 1, other], near)?;
                self.near_between([second, other], near)
            }
            (_, Some(second)) => {
                self.near_between([one, other + 1], near)?;
                self.near_between([one, second], near)
            }
            (_, None) => {
                for at in ours.first..ours.end {
                    let from = if one == other { at + 1 } else { theirs.first };
                    let index = self.order[at];
                    for &opposite in &self.order[from..theirs.end] {
                        if self.corners[index].is_within(self.reach, &self.corners[opposite]) {
                            near([index.min(opposite), index.max(opposite)])?;
                        }
                    }
                }
                ControlFlow::Continue(())
            }
        }
    }

    /// Judges the first `most` pairs with boxes within reach, in the order of their lower pieces.
    fn near_in_order(&self, most: usize, mut judge: impl FnMut([usize; 2])) {
        let mut left = most;
        for index in 0..self.order.len() {
            let stopped = self.look(0, index, &mut |other| {
                // Both pieces of a pair come to it.
                if other <= index {
                    return ControlFlow::Continue(());
                }
                let Some(rest) = left.checked_sub(1) else { return ControlFlow::Break(()) };
                left = rest;
                judge([index, other]);
                ControlFlow::Continue(())
            });
            if stopped.is_break() {
                break;
            }
        }
    }

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
