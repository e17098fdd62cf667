//! Which edges to travel twice: the exact minimum-weight T-join of the odd vertices.

use std::collections::{BTreeMap, BinaryHeap};

use super::RouteError;
use super::matching::least_cost_pairs;
use crate::units::Length;
use crate::wireframe::{Component, EdgeId, VertexId, Wireframe};

/// Costs of the matching are whole nanometres.
const COST_PER_MM: f64 = 1.0e6;

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
/// the best other. For a closed one none does.
///
/// # Errors
/// [`RouteError::NoEdges`] or [`RouteError::StartElsewhere`].
pub fn doubling(
    wireframe: &Wireframe,
    component: &Component,
    start: Option<VertexId>,
    closed: bool,
) -> Result<Doubling, RouteError> {
    if component.edges.is_empty() {
        return Err(RouteError::NoEdges);
    }
    if let Some(start) = start.filter(|start| component.vertices.binary_search(start).is_err()) {
        return Err(RouteError::StartElsewhere(start));
    }
    let mut terminals = wireframe.odd_vertices(component, &[]);
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
    let trees: Vec<Tree> = terminals.iter().map(|&v| Tree::grow(wireframe, v)).collect();
    let mut pairs = Vec::new();
    for (k, tree) in trees.iter().enumerate() {
        for (j, other) in terminals.iter().enumerate().skip(k + 1) {
            if let Some(&(distance, _)) = tree.reached.get(other) {
                #[allow(clippy::cast_possible_truncation)] // lengths are far below 2^63 nm
                pairs.push((k, j, (distance * COST_PER_MM).round() as i64));
            }
        }
        pairs.extend((0..free).map(|stand_in| (k, terminals.len() + stand_in, 0)));
    }
    // Where two paths of a matching share an edge, the edge is needed neither time.
    let mut edges = std::collections::BTreeSet::new();
    for (k, j) in least_cost_pairs(terminals.len() + free, &pairs) {
        if j < terminals.len() {
            for edge in trees[k].path_to(wireframe, terminals[j]) {
                if !edges.remove(&edge) {
                    edges.insert(edge);
                }
            }
        }
    }
    let added = edges.iter().map(|&edge| wireframe.edge_length(edge)).sum();
    Ok(Doubling {
        edges: edges.into_iter().collect(),
        added,
    })
}

/// Shortest paths from one vertex, by Dijkstra's algorithm; ties go to the lower ids.
struct Tree {
    /// Distance in mm and the edge that leads there; none at the root.
    reached: BTreeMap<VertexId, (f64, Option<EdgeId>)>,
}

impl Tree {
    fn grow(wireframe: &Wireframe, root: VertexId) -> Self {
        let mut reached = BTreeMap::new();
        let mut queue = BinaryHeap::from([(std::cmp::Reverse(Length::ZERO), std::cmp::Reverse(root), None)]);
        while let Some((std::cmp::Reverse(distance), std::cmp::Reverse(vertex), via)) = queue.pop() {
            if reached.contains_key(&vertex) {
                continue;
            }
            reached.insert(vertex, (distance.mm(), via.map(|std::cmp::Reverse(edge)| edge)));
            for edge in wireframe.incident(vertex) {
                let Some(other) = wireframe.edge(edge).map(|e| e.other(vertex)) else {
                    continue;
                };
                if !reached.contains_key(&other) {
                    let further = distance + wireframe.edge_length(edge);
                    let reverse = std::cmp::Reverse(edge);
                    queue.push((
                        std::cmp::Reverse(further),
                        std::cmp::Reverse(other),
                        Some(reverse),
                    ));
                }
            }
        }
        Self { reached }
    }

    fn path_to(&self, wireframe: &Wireframe, target: VertexId) -> Vec<EdgeId> {
        let mut path = Vec::new();
        let mut at = target;
        while let Some(&(_, Some(edge))) = self.reached.get(&at) {
            path.push(edge);
            let Some(from) = wireframe.edge(edge).map(|e| e.other(at)) else {
                break;
            };
            at = from;
        }
        path
    }
}
