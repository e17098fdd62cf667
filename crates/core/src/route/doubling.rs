//! Which edges to travel twice: the exact minimum-weight T-join of the odd vertices.

use wirebend_postman::{Graph, cheapest_join};

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
    if component.edges.is_empty() {
        return Err(RouteError::NoEdges);
    }
    let network = Network::new(wireframe, component);
    let start = match start {
        Some(start) => Some(network.index(start).ok_or(RouteError::StartElsewhere(start))?),
        None => None,
    };
    let mut odd = network.odd(&[]);
    if odd.is_empty() {
        return Ok(Doubling::default());
    }
    // An open route leaves two vertices odd. A wanted start is one of them without a choice: in the set it leaves it, not in it
    // it joins it.
    let mut left = if closed { 0 } else { 2 };
    if let Some(start) = start.filter(|_| !closed) {
        match odd.binary_search(&start) {
            Ok(at) => drop(odd.remove(at)),
            Err(at) => odd.insert(at, start),
        }
        left = 1;
    }
    let number = |vertex: usize| u32::try_from(vertex).map_err(|_| RouteError::TooLong);
    let edge = |link: &Link| Ok((number(link.a)?, number(link.b)?, link.length_nm.cast_unsigned()));
    let edges: Vec<_> = network.links.iter().map(edge).collect::<Result<_, _>>()?;
    let odd: Vec<u32> = odd.into_iter().map(number).collect::<Result<_, _>>()?;
    let graph = Graph::new(network.vertices.len(), &edges).map_err(|_| RouteError::TooLong)?;
    // The odd vertices of each piece of a graph are even in number, so that there always is a join.
    let join = cheapest_join(&graph, &odd, left).map_err(|_| {
        let odd = network.odd(&[]).into_iter().map(|vertex| network.vertices[vertex]).collect();
        RouteError::Odd { odd, closed }
    })?;
    let edges: Vec<EdgeId> = join.edges.iter().map(|&edge| network.links[edge as usize].id).collect();
    let added = edges.iter().map(|&edge| wireframe.edge_length(edge)).sum();
    Ok(Doubling { edges, added })
}
