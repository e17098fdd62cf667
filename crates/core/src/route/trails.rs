//! Hierholzer's algorithm on a given pairing: follow it into trails, then join closed ones to others
//! where they meet, each time at the vertex where that costs least.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use petgraph::unionfind::UnionFind;

use super::pairing::{End, Pairing};

/// Two pairs of one vertex and what they would become, with what that adds to the cost.
type PairChange = (i64, usize, [(End, End); 2], [(End, End); 2]);

/// Joins the trails of a pairing until there is one for each wire. Each step takes the cheapest change of two pairs that
/// belong to different trails, one of them closed; a change that folds the wire back is never the cheaper of the two that
/// are possible.
pub(super) fn join(pairing: &mut Pairing) {
    let mut trails = UnionFind::<usize>::new(pairing.end_count());
    for copy in 0..pairing.copy_count() {
        trails.union(2 * copy, 2 * copy + 1);
    }
    // Open trails count as one: two of them have nothing to join for.
    for end in pairing.wire_ends().skip(1) {
        trails.union(pairing.wire_ends().start, end);
    }
    for end in 0..pairing.end_count() {
        trails.union(end, pairing.mate(end));
    }
    let mut changes = Vec::new();
    for (vertex, pairs) in pairing.vertices().iter().enumerate() {
        offer(pairing, vertex, pairs, &mut trails, &mut changes);
    }
    let mut changes = BinaryHeap::from(changes);
    let mut further = Vec::new();
    while let Some(Reverse((_, vertex, old, new))) = changes.pop() {
        let current = old.iter().all(|pair| pairing.vertices()[vertex].contains(pair));
        if current && trails.union(old[0].0, old[1].0) {
            pairing.replace(vertex, old, new);
            offer(pairing, vertex, &new, &mut trails, &mut further);
            changes.extend(further.drain(..));
        }
    }
}

/// Lists every change of some pairs of a vertex that would join two trails.
fn offer(
    pairing: &Pairing,
    vertex: usize,
    of: &[(End, End)],
    trails: &mut UnionFind<usize>,
    changes: &mut Vec<Reverse<PairChange>>,
) {
    let pairs = &pairing.vertices()[vertex];
    for &(a, b) in of {
        for &(c, d) in pairs {
            // Two pairs that are both offered meet twice.
            if (c, d) <= (a, b) && of.contains(&(c, d)) {
                continue;
            }
            if trails.find_mut(a) == trails.find_mut(c) {
                continue;
            }
            let now = pairing.cost(a, b) + pairing.cost(c, d);
            for new in [[(a, c), (b, d)], [(a, d), (b, c)]] {
                let [(p, q), (r, s)] = new;
                let both_wire_ends = |x, y| pairing.is_wire_end(x) && pairing.is_wire_end(y);
                if !both_wire_ends(p, q) && !both_wire_ends(r, s) {
                    let added = pairing.cost(p, q) + pairing.cost(r, s) - now;
                    changes.push(Reverse((added, vertex, [(a, b), (c, d)], new)));
                }
            }
        }
    }
}

/// Follows a pairing whose trails are joined, one walk for each wire: each copy with whether it is travelled from its first
/// vertex to its second. Without wire ends the loop is cut at its dearest transition.
pub(super) fn walks(pairing: &Pairing) -> Vec<Vec<(usize, bool)>> {
    if pairing.wire_ends().is_empty() {
        let transitions = pairing.vertices().iter().flatten();
        // The first of the dearest ones, so that the choice does not depend on the run.
        let dearest = transitions.max_by_key(|&&(p, q)| (pairing.cost(p, q), Reverse((p, q))));
        return vec![walk(pairing, dearest.map_or(0, |&(p, q)| p.min(q))).0];
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
