//! The cheapest join: candidates for pairs, their matching, and pairs that were missed, until there are none.

use crate::certificate::{Certificate, Join};
use crate::graph::{Graph, NONE, id};
use crate::matching::Matching;
use crate::price::Pricer;
use crate::search::Search;

/// To each odd vertex so many of the nearest others are candidates from the beginning.
const NEAREST: usize = 14;

/// Why there is no join.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum NoJoin {
    /// An odd vertex is listed twice or is none of the graph.
    #[error("vertex {0} is listed twice, or is not in the graph")]
    NoSet(u32),
    /// So many cannot be left that the others form pairs.
    #[error("{left} of {odd} odd vertices cannot be left so that the others form pairs")]
    Parity {
        /// How many are to be left.
        left: usize,
        /// How many there are.
        odd: usize,
    },
    /// A part of the graph has a vertex that no path leads from to a partner.
    #[error("no path leads from vertex {0} to another odd vertex that is not paired")]
    Apart(u32),
}

/// The cheapest join of vertices, of which `left` are left as they are: whichever makes it cheapest.
///
/// With the vertices of odd degree and none left its edges, taken once more, make a closed walk through all edges possible;
/// with two left an open one, with 2q left q walks.
///
/// # Errors
/// [`NoJoin`] where there is none.
pub fn cheapest_join(graph: &Graph, odd: &[u32], left: usize) -> Result<Join, NoJoin> {
    join_from(graph, odd, left, NEAREST)
}

/// The cheapest joins that leave none, two, four vertices and so on, up to `left` of them: each from the one before.
///
/// # Errors
/// [`NoJoin`] where there is none that leaves so many.
pub fn cheapest_joins(graph: &Graph, odd: &[u32], left: usize) -> Result<Vec<Join>, NoJoin> {
    let mut solver = Solver::new(graph, odd, left, NEAREST)?;
    let counts = (odd.len() % 2..=left).step_by(2);
    counts.map(|count| solver.leave(count)).collect()
}

/// The first of these, with so many candidates for each vertex: fewer make more pairs that are missed at first.
fn join_from(graph: &Graph, odd: &[u32], left: usize, nearest: usize) -> Result<Join, NoJoin> {
    let mut solver = Solver::new(graph, odd, left, nearest)?;
    // Closed first: stand-ins for ends then have little to change.
    if left > 0 && left.is_multiple_of(2) && solver.pricer.is_even_everywhere() {
        solver.solve()?;
    }
    solver.leave(left)
}

/// A matching of odd vertices, and what it is judged by.
struct Solver<'a> {
    graph: &'a Graph,
    odd: &'a [u32],
    search: Search,
    pricer: Pricer<'a>,
    matching: Matching,
    /// Stand-ins that take part.
    left: usize,
}

impl<'a> Solver<'a> {
    /// With room for so many stand-ins.
    fn new(graph: &'a Graph, odd: &'a [u32], left: usize, nearest: usize) -> Result<Self, NoJoin> {
        let mut number = vec![NONE; graph.vertices()];
        for (k, &vertex) in odd.iter().enumerate() {
            match number.get_mut(vertex as usize) {
                Some(number) if *number == NONE => *number = id(k),
                _ => return Err(NoJoin::NoSet(vertex)),
            }
        }
        if left > odd.len() || (odd.len() - left) % 2 == 1 {
            return Err(NoJoin::Parity { left, odd: odd.len() });
        }
        let mut search = Search::new(graph);
        let (edges, reach) = candidates(graph, odd, &number, nearest, &mut search);
        let matching = Matching::new(odd.len() + left, odd.len(), edges);
        Ok(Self { graph, odd, search, pricer: Pricer::new(graph, odd, number, reach), matching, left: 0 })
    }

    /// The cheapest join that leaves so many, no fewer than before.
    fn leave(&mut self, left: usize) -> Result<Join, NoJoin> {
        if left > self.left {
            self.matching.bring_in(left - self.left, self.left);
            self.left = left;
        }
        self.solve()?;
        Ok(self.join())
    }

    /// Matches all that take part, with all pairs that there are.
    fn solve(&mut self) -> Result<(), NoJoin> {
        let Self { matching, pricer, .. } = self;
        let vertices = self.odd.len() + self.left;
        loop {
            matching.plant(vertices);
            let missed = if matching.run().is_ok() {
                let missed = pricer.missed(matching, vertices);
                if missed.is_empty() {
                    return Ok(());
                }
                missed
            } else {
                let further = pricer.between_trees(matching);
                if further.is_empty() {
                    return Err(NoJoin::Apart(pricer.unmatched(matching)));
                }
                matching.abandon();
                further
            };
            for (a, b, weight) in missed {
                matching.take_in(a, b, weight);
            }
        }
    }

    /// The edges on the paths between partners; what two paths share is needed neither time.
    fn join(&mut self) -> Join {
        let (graph, odd) = (self.graph, self.odd);
        let partners = self.matching.partners(odd.len() + self.left);
        let mut needed = vec![false; graph.edges()];
        let mut left = Vec::new();
        // Stand-ins that are each other's: all that is paired costs nothing then, and may as well be left.
        let mut spare =
            partners[odd.len()..].iter().filter(|&&partner| partner as usize >= odd.len()).count();
        for (k, &root) in odd.iter().enumerate() {
            let partner = partners[k] as usize;
            if partner >= odd.len() {
                left.push(root);
            } else if k < partner && spare > 0 {
                left.extend([root, odd[partner]]);
                spare -= 2;
            } else if k < partner {
                let goal = odd[partner];
                self.search.run(graph, root, |vertex, _| vertex == goal);
                for edge in self.search.path(graph, goal) {
                    needed[edge as usize] ^= true;
                }
            }
        }
        left.sort_unstable();
        let edges: Vec<u32> = (0..id(needed.len())).filter(|&edge| needed[edge as usize]).collect();
        let weight = edges.iter().map(|&edge| graph.weight(edge)).sum::<i64>().cast_unsigned();
        let certificate = Certificate::new(graph, odd, self.left, &self.matching);
        Join { edges, weight, left, certificate }
    }
}

/// Pairs of near vertices, with four times their distance; and how far each vertex has been looked around.
fn candidates(
    graph: &Graph,
    odd: &[u32],
    number: &[u32],
    nearest: usize,
    search: &mut Search,
) -> (Vec<([u32; 2], i64)>, Vec<i64>) {
    let mut found: Vec<(u32, u32, i64)> = Vec::with_capacity(odd.len() * nearest);
    let mut reach = vec![i64::MAX; odd.len()];
    for (k, &root) in odd.iter().enumerate() {
        let mut wanted = nearest;
        search.run(graph, root, |vertex, distance| {
            let other = number[vertex as usize];
            if other == NONE || vertex == root {
                return false;
            }
            let own = id(k);
            found.push((own.min(other), own.max(other), 4 * distance));
            wanted -= 1;
            if wanted == 0 {
                reach[k] = 4 * distance;
            }
            wanted == 0
        });
    }
    found.sort_unstable();
    found.dedup();
    (found.into_iter().map(|(a, b, weight)| ([a, b], weight)).collect(), reach)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::certificate::verify;

    proptest! {
        /// However few pairs it begins with, it ends with the cheapest.
        #[test]
        fn pairs_that_were_missed_are_found(
            ends in prop::collection::vec((0..60_u32, 0..60_u32, prop_oneof![Just(10_u64), 0..1000_u64]), 20..200),
            nearest in 1_usize..4,
            left in 0_usize..7,
        ) {
            let graph = Graph::new(60, &ends).unwrap();
            let odd = graph.odd();
            let left = (left & !1).min(odd.len());
            let join = join_from(&graph, &odd, left, nearest).unwrap();
            prop_assert_eq!(verify(&graph, &odd, &join), Ok(()));
            prop_assert_eq!(join.weight, cheapest_join(&graph, &odd, left).unwrap().weight);
        }
    }

    /// The cheapest of a graph of 60 vertices, each edge as `from-to:weight`, from so many candidates on and from all.
    fn is_found(edges: &str, nearest: usize) {
        let edge = |edge: &str| {
            let parts: Vec<u32> = edge.split(['-', ':']).map(|part| part.parse().unwrap()).collect();
            (parts[0], parts[1], u64::from(parts[2]))
        };
        let edges: Vec<_> = edges.split_whitespace().map(edge).collect();
        let graph = Graph::new(60, &edges).unwrap();
        let odd = graph.odd();
        for join in [join_from(&graph, &odd, 0, nearest), cheapest_join(&graph, &odd, 0)] {
            assert_eq!(verify(&graph, &odd, &join.unwrap()), Ok(()));
        }
    }

    /// A vertex comes into a blossom, and its tree dissolves before it has looked at its edges.
    #[test]
    fn who_was_even_for_no_time_is_met() {
        is_found(
            "43-11:10 11-42:10 12-10:10 40-4:10 42-14:10 9-11:10 41-4:10 55-3:10 41-10:1 44-41:10 5-0:10 \
             10-3:10 47-10:10 40-13:10 11-13:20 2-40:10 2-47:10 9-3:10 55-42:10 15-15:10",
            1,
        );
    }

    /// A free vertex becomes even, grows, and is free again before an even one beside it has looked a second time.
    #[test]
    fn who_grew_and_is_free_again_is_met() {
        is_found(
            "23-13:119 22-6:10 36-51:10 33-59:10 2-29:10 24-11:10 22-39:10 8-54:10 18-41:20 18-15:10 \
             55-39:10 34-19:10 56-12:10 14-6:10 2-12:50 18-27:10 10-12:10 43-12:10 18-6:10 29-34:10 \
             41-13:10 0-36:10 8-51:10 37-36:10 1-18:11 7-47:10 10-39:10 43-13:10 18-21:10 10-31:10 \
             44-6:55 50-4:10 6-55:10 21-26:22 23-39:10 1-22:10 22-9:12 55-2:40 17-10:10 51-57:10 \
             30-46:10 48-42:10 20-55:10 20-26:10 9-10:20 15-48:10 50-0:10 23-55:10 38-3:55 24-55:18 \
             1-52:10 17-44:75 4-37:10 23-44:55 46-12:418 35-23:10 57-2:11 34-17:21 29-52:30 14-13:10 \
             20-45:76 50-10:10 2-2:10 2-5:10 52-39:10 37-24:12 35-29:10 23-29:20 46-7:10 58-13:10 \
             13-8:10 40-11:10 54-9:11 41-12:10 45-23:10 4-42:10 8-12:10 32-51:20 18-13:11 5-33:10 \
             23-22:10 9-41:31 36-34:10 9-32:10 11-15:10 15-43:20 20-22:10 9-29:10 39-27:10 8-8:10 \
             32-26:10 11-33:16 39-23:10 13-16:48 34-58:10 36-3:10 2-10:36 14-2:45 1-17:10 6-23:10",
            3,
        );
    }
}
