//! The cheapest join: pairs of near vertices, their matching, with further pairs as it asks for them, and the paths between
//! partners.

use crate::certificate::{Certificate, Join};
use crate::graph::{Graph, id};
use crate::matching::{Matching, Stop};
use crate::near::Near;
use crate::order::Ordered;

/// To each odd vertex so many of the nearest others are candidates from the beginning.
const NEAREST: usize = 10;
/// By which part of it the reach of a vertex is widened.
const WIDER: i64 = 2;

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
    let ordered = Ordered::new(graph, odd).map_err(NoJoin::NoSet)?;
    let mut solver = Solver::new(&ordered, left, NEAREST)?;
    let counts = (odd.len() % 2..=left).step_by(2);
    counts.map(|count| solver.leave(count)).collect()
}

/// The first of these, with so many candidates for each vertex: fewer make more pairs that are missed at first.
fn join_from(graph: &Graph, odd: &[u32], left: usize, nearest: usize) -> Result<Join, NoJoin> {
    let ordered = Ordered::new(graph, odd).map_err(NoJoin::NoSet)?;
    let mut solver = Solver::new(&ordered, left, nearest)?;
    // Closed first: stand-ins for ends then have little to change.
    if left > 0 && left.is_multiple_of(2) && solver.near.is_even_everywhere() {
        solver.solve()?;
    }
    solver.leave(left)
}

/// A matching of odd vertices, and what finds pairs for it.
struct Solver<'a> {
    problem: &'a Ordered,
    near: Near<'a>,
    matching: Matching,
    /// Stand-ins that take part.
    left: usize,
}

impl<'a> Solver<'a> {
    /// With room for so many stand-ins.
    fn new(problem: &'a Ordered, left: usize, nearest: usize) -> Result<Self, NoJoin> {
        let Ordered { graph, odd, .. } = problem;
        if left > odd.len() || (odd.len() - left) % 2 == 1 {
            return Err(NoJoin::Parity { left, odd: odd.len() });
        }
        let mut near = Near::new(graph, odd);
        let (edges, reach) = near.nearest(nearest);
        let matching = Matching::new(odd.len() + left, reach, edges);
        Ok(Self { problem, near, matching, left: 0 })
    }

    /// The cheapest join that leaves so many, no fewer than before.
    fn leave(&mut self, left: usize) -> Result<Join, NoJoin> {
        if left > self.left {
            self.matching.bring_in(left - self.left, self.left);
            self.left = left;
        }
        self.solve()?;
        Ok(self.problem.restore(self.join()))
    }

    /// Matches all that take part, with further pairs of a vertex whenever it grows to where these could get tight.
    fn solve(&mut self) -> Result<(), NoJoin> {
        self.matching.plant(self.problem.odd.len() + self.left);
        loop {
            match self.matching.run() {
                Stop::Matched => return Ok(()),
                Stop::Stuck => return Err(NoJoin::Apart(self.problem.given(self.matching.unmatched()))),
                Stop::AtReach(vertex) => {
                    let known = self.matching.reach();
                    let reach = (2 * self.matching.radius(vertex)).max(known[vertex as usize]);
                    let longest = (reach + reach / WIDER) / 4 + 1;
                    let (found, reach) = self.near.further(vertex, longest, known);
                    self.matching.widen(vertex, reach, &found);
                }
            }
        }
    }

    /// The edges on the paths between partners; what two paths share is needed neither time.
    fn join(&mut self) -> Join {
        let matching = &self.matching;
        let (graph, count) = (&self.problem.graph, self.problem.odd.len());
        let mates = matching.mates(count + self.left);
        let partner = |mate: u32| matching.to(mate) as usize;
        let given = |k: usize| self.problem.given(id(k));
        let mut needed = vec![false; graph.edges()];
        let mut left = Vec::new();
        // Stand-ins that are each other's: all that is paired costs nothing then, and may as well be left.
        let mut spare = mates[count..].iter().filter(|&&mate| partner(mate) >= count).count();
        for (k, &mate) in mates[..count].iter().enumerate() {
            let other = partner(mate);
            if other >= count {
                left.push(given(k));
            } else if k < other && spare > 0 {
                left.extend([given(k), given(other)]);
                spare -= 2;
            } else if k < other {
                for edge in self.near.path(id(k), id(other), matching.weight(mate) / 4) {
                    needed[edge as usize] ^= true;
                }
            }
        }
        left.sort_unstable();
        let edges: Vec<u32> = (0..id(needed.len())).filter(|&edge| needed[edge as usize]).collect();
        let weight = edges.iter().map(|&edge| graph.weight(edge)).sum::<i64>().cast_unsigned();
        let certificate = Certificate::new(graph, &self.problem.odd, self.left, matching);
        Join { edges, weight, left, certificate }
    }
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
