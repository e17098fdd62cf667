//! Which edges to travel twice: the exact minimum-weight T-join of the odd vertices.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use super::RouteError;
use super::matching::min_cost_pairs;
use super::network::Network;
use crate::units::Length;
use crate::wireframe::{Component, EdgeId, VertexId, Wireframe};

/// The most entries of search trees that are kept, 64 MiB of them.
const MAX_KEPT: usize = 1 << 24;

/// No link leads to the root of a search.
const NOWHERE: u32 = u32::MAX;

/// The cheapest set of edges to travel twice.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Doubling {
    /// The edges, in order of id; empty when a route exists already.
    pub edges: Vec<EdgeId>,
    /// How much wire they add.
    pub added: Length,
}

/// The edges whose doubling makes a route possible and adds the least length; no set is shorter.
///
/// For an open route two odd vertices stay odd, the best two, and with a wanted `start` that one and
/// the best other. For a closed one none does. More than `max_odd` odd vertices are refused: memory
/// grows with their square and time with their cube (400 take a third of a second, 1500 a quarter of
/// a minute).
///
/// # Errors
/// [`RouteError::NoEdges`], [`RouteError::StartElsewhere`] or [`RouteError::TooManyOdd`].
pub fn doubling(
    wireframe: &Wireframe,
    component: &Component,
    start: Option<VertexId>,
    closed: bool,
    max_odd: usize,
) -> Result<Doubling, RouteError> {
    if component.edges.is_empty() {
        return Err(RouteError::NoEdges);
    }
    let network = Network::new(wireframe, component);
    let start = match start {
        Some(start) => Some(network.index(start).ok_or(RouteError::StartElsewhere(start))?),
        None => None,
    };
    let mut terminals = network.odd(&[]);
    if terminals.is_empty() {
        return Ok(Doubling::default());
    }
    // An open route leaves two vertices odd: as many stand-ins take part in the matching for free.
    // A wanted start is odd without one: in the set it leaves it, not in it it joins it.
    let mut free = if closed { 0 } else { 2 };
    if let Some(start) = start.filter(|_| !closed) {
        match terminals.binary_search(&start) {
            Ok(at) => drop(terminals.remove(at)),
            Err(at) => terminals.insert(at, start),
        }
        free = 1;
    }
    if terminals.len() > max_odd {
        return Err(RouteError::TooManyOdd { odd: terminals.len(), max: max_odd });
    }
    let count = terminals.len();
    let mut search = Search::new(&network);
    let mut distances = vec![0; count * count];
    // Where they fit, the searches are kept for the paths; else those of the pairs are run again.
    let keep = count * network.vertices.len() <= MAX_KEPT;
    let mut kept: Vec<Vec<u32>> = Vec::new();
    for (k, &root) in terminals.iter().enumerate() {
        search.run(&network, root, &terminals[k + 1..]);
        if keep {
            kept.push(search.via.clone());
        }
        for (j, &other) in terminals.iter().enumerate().skip(k + 1) {
            distances[k * count + j] = search.distance[other];
        }
    }
    let pairs = min_cost_pairs(count + free, |k, j| match (k < count, j < count) {
        (true, true) => Some(distances[k * count + j]),
        (true, false) => Some(0),
        _ => None,
    });
    // Where two paths of the matching share an edge, the edge is needed neither time.
    let mut needed = vec![false; network.links.len()];
    for (k, j) in pairs.into_iter().filter(|&(_, j)| j < count) {
        if !keep {
            search.run(&network, terminals[k], &[terminals[j]]);
        }
        let via = kept.get(k).unwrap_or(&search.via);
        let mut at = terminals[j];
        while via[at] != NOWHERE {
            let link = via[at] as usize;
            needed[link] ^= true;
            at = network.links[link].other(at);
        }
    }
    let edges: Vec<EdgeId> = (0..needed.len()).filter(|&k| needed[k]).map(|k| network.links[k].id).collect();
    let added = edges.iter().map(|&edge| wireframe.edge_length(edge)).sum();
    Ok(Doubling { edges, added })
}

/// Shortest paths from one vertex, by Dijkstra's algorithm; ties go to the lower index.
struct Search {
    /// In nm, of the vertices that were reached.
    distance: Vec<i64>,
    /// The link that leads to a vertex; [`NOWHERE`] at the root.
    via: Vec<u32>,
    settled: Vec<bool>,
    wanted: Vec<bool>,
    queue: BinaryHeap<Reverse<(i64, usize)>>,
}

impl Search {
    fn new(network: &Network) -> Self {
        let count = network.vertices.len();
        Self {
            distance: vec![i64::MAX; count],
            via: vec![NOWHERE; count],
            settled: vec![false; count],
            wanted: vec![false; count],
            queue: BinaryHeap::with_capacity(count),
        }
    }

    /// Searches until all of `targets` are settled.
    fn run(&mut self, network: &Network, root: usize, targets: &[usize]) {
        self.distance.fill(i64::MAX);
        self.via.fill(NOWHERE);
        self.settled.fill(false);
        self.queue.clear();
        self.distance[root] = 0;
        self.queue.push(Reverse((0, root)));
        self.wanted.fill(false);
        for &target in targets {
            self.wanted[target] = true;
        }
        let mut left = targets.len();
        while let Some(Reverse((distance, vertex))) = self.queue.pop() {
            if std::mem::replace(&mut self.settled[vertex], true) {
                continue;
            }
            left -= usize::from(self.wanted[vertex]);
            if left == 0 {
                return;
            }
            for &link in network.at(vertex) {
                let other = network.links[link].other(vertex);
                let further = distance + network.links[link].length_nm;
                if further < self.distance[other] {
                    self.distance[other] = further;
                    // Edges are numbered with 32 bits, so a list of them is no longer.
                    self.via[other] = u32::try_from(link).unwrap_or(NOWHERE);
                    self.queue.push(Reverse((further, other)));
                }
            }
        }
    }
}
