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
///
/// To find the fewest bends beyond the limit of all walks is NP-hard (S. W. Bent, U. Manber, "On non-intersecting Eulerian
/// circuits", Discrete Applied Mathematics 18, 1987: only neighbours around a vertex may follow each other), so none of this
/// kind is sure to. The tests compare it with every way to pair the ends of small graphs: it never leaves more than needed
/// there. On meshes, spheres and random graphs of up to 100 000 edges it leaves as many as the pairing has, the least.
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

#[cfg(test)]
mod tests {
    use nalgebra::Point3;
    use std::collections::BTreeMap;

    use proptest::prelude::*;
    use proptest::strategy::ValueTree;
    use proptest::test_runner::TestRunner;

    use super::*;
    use crate::route::network::Network;
    use crate::route::pairing::BEYOND_LIMIT;
    use crate::route::{Layout, RouteOptions, doubling, layout};
    use crate::units::Angle;
    use crate::wireframe::{Vertex, Wireframe};

    /// So many graphs are tried.
    const GRAPHS: usize = 500;
    /// So many ways to pair the ends of all vertices are tried.
    const MAX_WAYS: usize = 20_000;

    /// Connected graphs with a few vertices of a few edges.
    fn any_wireframe() -> impl Strategy<Value = Wireframe> {
        let points = prop::collection::vec(prop::array::uniform3(-100.0..100.0_f64), 3..8);
        (
            points,
            prop::collection::vec(0..100_usize, 8),
            prop::collection::vec((0..8_usize, 0..8_usize), 3..10),
        )
            .prop_map(|(points, tree, extra)| {
                let mut w = Wireframe::new();
                let ids: Vec<_> =
                    points.iter().map(|&p| w.add_vertex(Vertex::at(Point3::from(p))).unwrap()).collect();
                let tree = (1..ids.len()).map(|k| (tree[k] % k, k));
                for (a, b) in tree.chain(extra.into_iter().map(|(a, b)| (a % ids.len(), b % ids.len()))) {
                    if a != b {
                        w.add_edge(ids[a], ids[b]).unwrap();
                    }
                }
                w
            })
    }

    /// Fold backs and bends beyond the limit, as the pairing weighs them.
    fn beyond(pairing: &Pairing) -> i64 {
        let pairs = (0..pairing.vertex_count()).flat_map(|vertex| pairing.pairs(vertex));
        pairs.map(|(p, q)| pairing.cost(p, q) / BEYOND_LIMIT).sum()
    }

    /// All perfect matchings of ends, but for two ends of wires.
    fn matchings(pairing: &Pairing, ends: &[End]) -> Vec<Vec<(End, End)>> {
        let Some((&p, others)) = ends.split_first() else { return vec![Vec::new()] };
        let mut found = Vec::new();
        for &q in others {
            if pairing.is_wire_end(p) && pairing.is_wire_end(q) {
                continue;
            }
            let rest: Vec<End> = others.iter().copied().filter(|&end| end != q).collect();
            for mut matching in matchings(pairing, &rest) {
                matching.push((p, q));
                found.push(matching);
            }
        }
        found
    }

    /// The fewest bends beyond the limit of all pairings that are one trail; none where there are too many.
    fn fewest(pairing: &mut Pairing) -> Option<i64> {
        let at: Vec<Vec<Vec<(End, End)>>> =
            (0..pairing.vertex_count()).map(|vertex| matchings(pairing, pairing.ends(vertex))).collect();
        let ways = at.iter().try_fold(1_usize, |ways, at| ways.checked_mul(at.len()))?;
        if ways > MAX_WAYS {
            return None;
        }
        let mut fewest = i64::MAX;
        for way in 0..ways {
            let mut way = way;
            for at in &at {
                for &(p, q) in &at[way % at.len()] {
                    pairing.set(p, q);
                }
                way /= at.len();
            }
            if Trails::of(pairing).count == 1 {
                fewest = fewest.min(beyond(pairing));
            }
        }
        Some(fewest)
    }

    /// Counts graphs, half of them closed, by the bends beyond the limit that one trail needs and the pairing does not, and by
    /// those that joining leaves and no trail needs.
    fn counted(limit_deg: f64, graphs: usize) -> BTreeMap<(i64, i64), usize> {
        let mut runner = TestRunner::deterministic();
        let mut counts = BTreeMap::new();
        for k in 0..graphs {
            let w = any_wireframe().new_tree(&mut runner).unwrap().current();
            let component = w.components().remove(0);
            let closed = k % 2 == 0;
            let doubled = doubling(&w, &component, None, closed).unwrap().edges;
            let options = RouteOptions { doubled, closed, ..RouteOptions::default() };
            let network = Network::new(&w, &component);
            let Layout { copies, wire_ends } = layout(&network, &component, &options).unwrap();
            let limit = Some(Angle::from_deg(limit_deg).unwrap());
            let mut pairing = Pairing::new(&network, &copies, &wire_ends, limit);
            let least = beyond(&pairing);
            join(&mut pairing);
            let found = beyond(&pairing);
            if let Some(best) = fewest(&mut pairing) {
                *counts.entry((best - least, found - best)).or_default() += 1;
            }
        }
        counts
    }

    /// Else a wire is called one that the machine cannot bend although it could, walked otherwise.
    #[test]
    fn joining_trails_leaves_no_bend_beyond_the_limit_that_is_not_needed() {
        for limit_deg in [80.0, 110.0, 155.0] {
            let counts = counted(limit_deg, GRAPHS);
            assert!(
                counts.keys().all(|&(needed, missed)| needed >= 0 && missed == 0),
                "{limit_deg}: {counts:?}"
            );
            assert!(2 * counts.values().sum::<usize>() > GRAPHS, "{limit_deg}: {counts:?}");
            // Some need more than the pairing at each vertex: it is no matter of course.
            assert!(counts.contains_key(&(1, 0)), "{limit_deg}: {counts:?}");
        }
    }
}
