//! Which edges to travel twice: the exact minimum-weight T-join of the odd vertices.

use wirebend_postman::{Graph, Join, cheapest_join, cheapest_joins, verify};

use super::RouteError;
use super::network::{Link, Network};
use crate::units::Length;
use crate::wireframe::{Component, EdgeId, VertexId, Wireframe};

/// The cheapest set of edges to travel twice.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Doubling {
    /// The edges, in order of id; empty when a route exists already.
    pub edges: Vec<EdgeId>,
    /// How much wire they add.
    pub added: Length,
}

/// Sums of the same lengths in another order differ by less, mm.
const ROUNDING_MM: f64 = 1e-6;

impl Doubling {
    /// Whether another doubling, which adds so much, is as good as this one.
    #[must_use]
    pub fn is_matched_by(&self, added: Length) -> bool {
        added.mm() <= self.added.mm() + ROUNDING_MM
    }
}

/// The edges whose doubling makes a route possible and adds the least length; no set is shorter.
///
/// For an open route two odd vertices stay odd, the best two, and with a wanted `start` that one and
/// the best other. For a closed one none does.
///
/// # Errors
/// [`RouteError::NoEdges`], [`RouteError::StartElsewhere`] or [`RouteError::TooLong`].
pub fn doubling(
    wireframe: &Wireframe,
    component: &Component,
    start: Option<VertexId>,
    closed: bool,
) -> Result<Doubling, RouteError> {
    let network = Network::new(wireframe, component);
    let start = known(&network, start)?;
    let odd = ends(&network, start.filter(|_| !closed));
    let left = match (closed, start) {
        (true, _) => 0,
        (false, None) => odd.len().min(2),
        (false, Some(_)) => odd.len().min(1),
    };
    let graph = graph(&network, |length| length)?;
    let join = cheapest_join(&graph, &odd, left).map_err(|_| no_join(&network, left))?;
    debug_assert_eq!(verify(&graph, &odd, &join), Ok(()));
    Ok(in_wireframe(wireframe, &network, &join))
}

/// The cheapest doublings for one open wire, for two, and so on up to so many: each further one leaves two more vertices odd.
/// As many as there are, the last of them the first that needs no edge twice.
///
/// # Errors
/// As [`doubling`].
pub fn doublings(
    wireframe: &Wireframe,
    component: &Component,
    start: Option<VertexId>,
    wires: usize,
) -> Result<Vec<Doubling>, RouteError> {
    let network = Network::new(wireframe, component);
    let odd = ends(&network, known(&network, start)?);
    // What is wanted as a start is an end already.
    let open = odd.len() % 2;
    let left = odd.len().min(2 * wires.max(1) - open);
    let graph = graph(&network, |length| length)?;
    let joins = cheapest_joins(&graph, &odd, left).map_err(|_| no_join(&network, left))?;
    debug_assert!(joins.iter().all(|join| verify(&graph, &odd, join).is_ok()));
    // Without a wanted start the first is closed; it is the answer where nothing is odd.
    let closed = usize::from(open == 0 && joins.len() > 1);
    let mut found: Vec<Doubling> =
        joins[closed..].iter().map(|join| in_wireframe(wireframe, &network, join)).collect();
    let enough = found.iter().position(|doubling| doubling.edges.is_empty());
    found.truncate(enough.map_or(found.len(), |last| last + 1));
    Ok(found)
}

/// A doubling for so many open wires, or for a closed one, that is the cheapest for other weights of the edges than their lengths:
/// `weigh` gives them, whole nm for nm, for one edge after the other. With weights that are nearly the lengths it is another
/// of those that are equally short.
///
/// # Errors
/// As [`doubling`].
pub(crate) fn doubling_weighed(
    wireframe: &Wireframe,
    component: &Component,
    (start, closed): (Option<VertexId>, bool),
    wires: usize,
    weigh: impl FnMut(u64) -> u64,
) -> Result<Doubling, RouteError> {
    let network = Network::new(wireframe, component);
    let start = known(&network, start)?;
    let odd = ends(&network, start.filter(|_| !closed));
    let left = if closed { 0 } else { odd.len().min(2 * wires.max(1) - odd.len() % 2) };
    let join = cheapest_join(&graph(&network, weigh)?, &odd, left).map_err(|_| no_join(&network, left))?;
    Ok(in_wireframe(wireframe, &network, &join))
}

/// What one part of a design gets of its wires.
#[derive(Debug, Clone, PartialEq)]
pub struct Share {
    /// How many wires, at least one.
    pub wires: usize,
    /// The cheapest doubling with so many, where it is known.
    pub doubling: Option<Doubling>,
}

impl Default for Share {
    /// One wire.
    fn default() -> Self {
        Self { wires: 1, doubling: None }
    }
}

/// Shares out further wires, beyond one for each part, so that together the parts double the least length. Of each part the
/// [`doublings`] are known; a further wire saves less than the one before it, so that each goes where it saves most.
#[must_use]
pub fn share_out(parts: Vec<Vec<Doubling>>, further: usize) -> Vec<Share> {
    let mut wires = vec![1; parts.len()];
    for _ in 0..further {
        let saved = |part: usize| {
            let next = parts[part].get(wires[part])?;
            Some(parts[part][wires[part] - 1].added.mm() - next.added.mm())
        };
        let able = (0..parts.len()).filter_map(|part| Some((part, saved(part)?)));
        // The first of those that save as much.
        let Some((part, _)) = able.reduce(|best, next| if next.1 > best.1 { next } else { best }) else {
            break;
        };
        wires[part] += 1;
    }
    let shares = wires.into_iter().zip(parts);
    shares
        .map(|(wires, mut part)| {
            let doubling = (wires <= part.len()).then(|| part.swap_remove(wires - 1));
            Share { wires, doubling }
        })
        .collect()
}

fn known(network: &Network, start: Option<VertexId>) -> Result<Option<usize>, RouteError> {
    if network.links.is_empty() {
        return Err(RouteError::NoEdges);
    }
    start.map(|start| network.index(start).ok_or(RouteError::StartElsewhere(start))).transpose()
}

/// The odd vertices, of which those that stay so are left. A wanted start is one of them without a choice: in the set it
/// leaves it, not in it it joins it.
fn ends(network: &Network, start: Option<usize>) -> Vec<u32> {
    let mut odd = network.odd(&[]);
    if let Some(start) = start.filter(|_| !odd.is_empty()) {
        match odd.binary_search(&start) {
            Ok(at) => drop(odd.remove(at)),
            Err(at) => odd.insert(at, start),
        }
    }
    // `graph` refuses what has more vertices than these numbers.
    odd.into_iter().filter_map(|vertex| u32::try_from(vertex).ok()).collect()
}

fn graph(network: &Network, mut weigh: impl FnMut(u64) -> u64) -> Result<Graph, RouteError> {
    let number = |vertex: usize| u32::try_from(vertex).map_err(|_| RouteError::TooLong);
    let mut edge =
        |link: &Link| Ok((number(link.a)?, number(link.b)?, weigh(link.length_nm.cast_unsigned())));
    let edges: Vec<_> = network.links.iter().map(&mut edge).collect::<Result<_, _>>()?;
    Graph::new(network.vertices.len(), &edges).map_err(|_| RouteError::TooLong)
}

/// The odd vertices of each piece of a graph are even in number, so that there always is a join.
fn no_join(network: &Network, allowed: usize) -> RouteError {
    let odd = network.odd(&[]).into_iter().map(|vertex| network.vertices[vertex]).collect();
    RouteError::Odd { odd, allowed }
}

fn in_wireframe(wireframe: &Wireframe, network: &Network, join: &Join) -> Doubling {
    let edges: Vec<EdgeId> = join.edges.iter().map(|&edge| network.links[edge as usize].id).collect();
    let added = edges.iter().map(|&edge| wireframe.edge_length(edge)).sum();
    Doubling { edges, added }
}
