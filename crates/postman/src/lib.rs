//! Route inspection, the Chinese postman's problem: which edges of a graph to travel twice so that one walk goes along all of
//! them, at the least cost, with a proof.
//!
//! A graph has a closed walk through all its edges when every vertex has an even number of edge ends. The cheapest set of edges
//! that makes it so is a minimum-weight join of the odd vertices ([`cheapest_join`]; "T-join" in the literature). It comes
//! with a [`Certificate`], which [`verify`] checks without the solver.
//!
//! The same method pairs up things of which each may have any other for its partner ([`cheapest_pairs`]).
//!
//! Sources: J. Edmonds, E. L. Johnson, "Matching, Euler tours and the Chinese postman", Mathematical Programming 5 (1973); V.
//! Kolmogorov, "Blossom V", Mathematical Programming Computation 1 (2009).

mod certificate;
mod graph;
mod join;
mod matching;
mod near;
mod nested;
mod order;
mod pairs;
mod search;

pub use certificate::{Broken, Certificate, Join, NO_SET, verify};
pub use graph::{Graph, GraphError};
pub use join::{NoJoin, cheapest_join, cheapest_joins};
pub use pairs::cheapest_pairs;
