//! Hierholzer's algorithm on a given pairing: follow it into trails, then join closed ones to others
//! where they meet, each time at the vertex where that costs least.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use petgraph::unionfind::UnionFind;

use super::pairing::{End, Pairing};

/// What it adds to the cost, and two ends of different pairs of a vertex that are to follow each other, as then do their partners.
type Swap = (i64, End, End);

/// Joins the trails of a pairing until there is one for each wire. Each step takes the cheapest change of two pairs that
/// belong to different trails, one of them closed; a change that folds the wire back is never the cheaper of the two that
/// are possible.
pub(super) fn join(pairing: &mut Pairing) {
    let mut trails = Trails::of(pairing);
    let mut swaps = Vec::new();
    for vertex in 0..pairing.vertex_count() {
        let pairs = pairing.pairs(vertex);
        for (k, one) in pairs.clone().enumerate() {
            swaps.extend(pairs.clone().skip(k + 1).filter_map(|other| trails.swap(pairing, one, other)));
        }
    }
    let mut swaps: BinaryHeap<_> = swaps.into_iter().map(Reverse).collect();
    while trails.count > 1
        && let Some(Reverse((added, p, r))) = swaps.pop()
    {
        let (q, s) = (pairing.mate(p), pairing.mate(r));
        if trails.swap(pairing, (p, q), (r, s)) != Some((added, p, r)) {
            continue;
        }
        trails.join(p, r);
        pairing.set(p, r);
        pairing.set(q, s);
        let vertex = pairing.vertex(p);
        for new in [(p, r), (q, s)] {
            let others = pairing.pairs(vertex);
            swaps.extend(others.filter_map(|other| trails.swap(pairing, new, other)).map(Reverse));
        }
    }
}

/// Which trail each copy of an edge is part of. Open ones count as one: two of them have nothing to join for.
struct Trails {
    of: UnionFind<usize>,
    copies: usize,
    count: usize,
}

impl Trails {
    fn of(pairing: &Pairing) -> Self {
        // All ends of wires are those of one more copy.
        let copies = pairing.copy_count();
        let count = copies + usize::from(!pairing.wire_ends().is_empty());
        let mut trails = Self { of: UnionFind::new(count), copies, count };
        for end in 0..pairing.end_count() {
            trails.join(end, pairing.mate(end));
        }
        trails
    }

    fn copy(&self, end: End) -> usize {
        (end / 2).min(self.copies)
    }

    fn join(&mut self, p: End, q: End) {
        let [a, b] = [p, q].map(|end| self.copy(end));
        if self.of.union(a, b) {
            self.count -= 1;
        }
    }

    /// The cheaper of both ways to join the trails of two pairs of a vertex; none where they are of the same.
    fn swap(&mut self, pairing: &Pairing, (a, b): (End, End), (c, d): (End, End)) -> Option<Swap> {
        let [one, other] = [a, c].map(|end| self.copy(end));
        if self.of.find_mut(one) == self.of.find_mut(other) {
            return None;
        }
        let now = pairing.cost(a, b) + pairing.cost(c, d);
        let both_end = |p, q| pairing.is_wire_end(p) && pairing.is_wire_end(q);
        let added = |[p, q, r, s]: [End; 4]| {
            let is_possible = !both_end(p, q) && !both_end(r, s);
            is_possible.then(|| (pairing.cost(p, q) + pairing.cost(r, s) - now, p, q))
        };
        [[a, c, b, d], [a, d, b, c]].into_iter().filter_map(added).min()
    }
}

/// Follows a pairing whose trails are joined, one walk for each wire: each copy with whether it is travelled from its first
/// vertex to its second. Without wire ends the loop is cut at its dearest transition.
pub(super) fn walks(pairing: &Pairing) -> Vec<Vec<(usize, bool)>> {
    if pairing.wire_ends().is_empty() {
        let transitions = (0..pairing.vertex_count()).flat_map(|vertex| pairing.pairs(vertex));
        // The first of the dearest ones, so that the choice does not depend on the run.
        let dearest = transitions.max_by_key(|&(p, q)| (pairing.cost(p, q), Reverse((p, q))));
        return vec![walk(pairing, dearest.map_or(0, |(p, q)| p.min(q))).0];
    }
    let mut walks = Vec::with_capacity(pairing.wire_ends().len() / 2);
    let mut finished = Vec::new();
    for end in pairing.wire_ends() {
        if !finished.contains(&end) {
            let (found, last) = walk(pairing, pairing.mate(end));
            walks.push(found);
            finished.push(last);
        }
    }
    walks
}

/// Follows a trail from an end on, to where it ends or has come round; and the end after its last copy.
fn walk(pairing: &Pairing, from: End) -> (Vec<(usize, bool)>, End) {
    let mut leaving = from;
    let mut walk = Vec::new();
    while walk.len() < pairing.copy_count() && !pairing.is_wire_end(leaving) {
        walk.push((leaving / 2, leaving.is_multiple_of(2)));
        leaving = pairing.mate(leaving ^ 1);
    }
    (walk, leaving)
}
