//! Perfect matching of least cost, exact, over rustworkx-core's blossom algorithm.

use std::convert::Infallible;

use petgraph::graph::UnGraph;
use rustworkx_core::max_weight_matching::max_weight_matching;

/// Pairs up `count` things so that the sum of the costs is least. `pairs` lists which pairs are
/// allowed at which cost (not negative). Each pair of the result has its lower index first and the
/// pairs are in ascending order; things that cannot be paired are left out.
pub(super) fn least_cost_pairs(count: usize, pairs: &[(usize, usize, i64)]) -> Vec<(usize, usize)> {
    if count == 2 {
        return pairs
            .iter()
            .take(1)
            .map(|&(a, b, _)| (a.min(b), a.max(b)))
            .collect();
    }
    let mut graph = UnGraph::<(), i64>::with_capacity(count, pairs.len());
    let nodes: Vec<_> = (0..count).map(|_| graph.add_node(())).collect();
    let dearest = pairs.iter().map(|pair| pair.2).max().unwrap_or(0);
    for &(a, b, cost) in pairs {
        graph.add_edge(nodes[a], nodes[b], cost);
    }
    // Among matchings of the same size, most of (dearest - cost) is least of cost.
    let gain = |edge: petgraph::graph::EdgeReference<i64>| {
        Ok::<_, Infallible>(i128::from(dearest) - i128::from(*edge.weight()) + 1)
    };
    let Ok(matched) = max_weight_matching(&graph, true, gain, false);
    let mut matched: Vec<_> = matched.into_iter().map(|(a, b)| (a.min(b), a.max(b))).collect();
    matched.sort_unstable();
    matched
}
