//! The route: one walk along the wire that uses every edge of a component.
//!
//! An Euler path exists when no more than two vertices are odd. Where more are, some edges have to
//! be travelled twice; which ones add the least length is [`doubling`]'s answer, and it is the
//! caller's to accept. Which edge follows which is chosen so that the wire never folds straight
//! back where another pairing exists, and then so that it bends as little as possible.

mod doubling;
mod matching;
mod network;
mod pairing;
mod trails;

use network::Network;
use pairing::Pairing;

use crate::units::Angle;
use crate::wireframe::{Component, EdgeId, VertexId, Wireframe};

pub use doubling::{Doubling, doubling};

/// One edge, travelled once.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Traversal {
    /// Which.
    pub edge: EdgeId,
    /// From here.
    pub from: VertexId,
    /// To here.
    pub to: VertexId,
    /// Whether the edge was travelled before in this route.
    pub again: bool,
}

/// A walk that uses every edge once, and every doubled edge once more.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Route {
    /// The edges in the order in which the wire runs along them.
    pub traversals: Vec<Traversal>,
}

impl Route {
    /// The vertices in the order of the walk: one more than there are traversals.
    #[must_use]
    pub fn vertices(&self) -> Vec<VertexId> {
        let first = self.traversals.first().map(|t| t.from);
        first.into_iter().chain(self.traversals.iter().map(|t| t.to)).collect()
    }

    /// The walk through vertices in an order; none where two that follow one another have no edge.
    #[must_use]
    pub fn through(wireframe: &Wireframe, vertices: &[VertexId]) -> Option<Self> {
        let mut seen = std::collections::BTreeSet::new();
        let traversal = |pair: &[VertexId]| {
            let joins =
                |edge: &EdgeId| wireframe.edge(*edge).is_some_and(|ends| ends.other(pair[0]) == pair[1]);
            let edge = wireframe.incident(pair[0]).iter().copied().find(joins)?;
            Some(Traversal { edge, from: pair[0], to: pair[1], again: !seen.insert(edge) })
        };
        vertices.windows(2).map(traversal).collect::<Option<_>>().map(|traversals| Self { traversals })
    }

    /// The same walk from its other end.
    #[must_use]
    pub fn reversed(&self) -> Self {
        let mut seen = std::collections::BTreeSet::new();
        let turned = self.traversals.iter().rev();
        let traversals = turned
            .map(|t| Traversal { edge: t.edge, from: t.to, to: t.from, again: !seen.insert(t.edge) })
            .collect();
        Self { traversals }
    }
}

/// What a route has to satisfy.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct RouteOptions {
    /// Edges that are travelled once more than they are drawn; an edge may be listed repeatedly.
    pub doubled: Vec<EdgeId>,
    /// Where the wire starts; chosen when absent.
    pub start: Option<VertexId>,
    /// Whether the wire must end where it starts.
    pub closed: bool,
    /// The largest bend that the machine makes; larger ones are avoided where possible.
    pub max_bend: Option<Angle>,
}

/// Why there is no route.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum RouteError {
    /// The component has no edges.
    #[error("there is no edge to run along")]
    NoEdges,
    /// Too many odd vertices for an open, or any for a closed route.
    #[error("{} vertices have an odd number of edges; {} allowed", odd.len(), if *closed { "none is" } else { "2 are" })]
    Odd {
        /// Which.
        odd: Vec<VertexId>,
        /// Whether a closed route was asked for.
        closed: bool,
    },
    /// The wanted start is not one of the two odd vertices, where an open route has to start.
    #[error("the wire cannot start at vertex {start}: it has to start at one of the odd vertices {} and {}", ends.0, ends.1)]
    Start {
        /// The wanted start.
        start: VertexId,
        /// The two vertices where it can.
        ends: (VertexId, VertexId),
    },
    /// The wanted start has no edge of this component.
    #[error("vertex {0} has no edge of this wire to start along")]
    StartElsewhere(VertexId),
    /// A doubled edge is not part of the component.
    #[error("edge {0} is to be doubled but is not part of this wire")]
    DoubledElsewhere(EdgeId),
    /// More edges at one vertex than can be paired.
    #[error("{ends} edge ends meet at vertex {vertex}: they can be paired for up to {max}")]
    TooManyEnds {
        /// The vertex.
        vertex: VertexId,
        /// How many ends meet there, those of doubled edges included.
        ends: usize,
        /// How many may.
        max: usize,
    },
    /// More edges, or longer ones, than are computed with.
    #[error("the edges are more than a thousand million, or 288 000 km long or more together")]
    TooLong,
}

/// The most edge ends at one vertex that are paired: time grows with their cube. No wire comes through
/// one point a hundred times.
const MAX_ENDS: usize = 200;

/// A route through every edge of a component.
///
/// The result is the same on every run. An open route starts at `start` or, without one, at the odd
/// vertex with the lower id; where every vertex is even the wire starts at `start` or so that its
/// sharpest bend is the one that need not be made.
///
/// # Errors
/// [`RouteError`] when there are too many odd vertices, or the start or a doubling does not fit.
pub fn route(
    wireframe: &Wireframe,
    component: &Component,
    options: &RouteOptions,
) -> Result<Route, RouteError> {
    if component.edges.is_empty() {
        return Err(RouteError::NoEdges);
    }
    let network = Network::new(wireframe, component);
    let position = |edge: &EdgeId| {
        let found = network.links.binary_search_by_key(edge, |link| link.id);
        found.map_err(|_| RouteError::DoubledElsewhere(*edge))
    };
    let doubled: Vec<usize> = options.doubled.iter().map(position).collect::<Result<_, _>>()?;
    let start = match options.start {
        Some(start) => Some(network.index(start).ok_or(RouteError::StartElsewhere(start))?),
        None => None,
    };
    let odd = network.odd(&doubled);
    if odd.len() > 2 || (options.closed && !odd.is_empty()) {
        let odd = odd.into_iter().map(|vertex| network.vertices[vertex]).collect();
        return Err(RouteError::Odd { odd, closed: options.closed });
    }
    let ends = match (odd.as_slice(), start) {
        (&[a, b], None) => Some((a, b)),
        (&[a, b], Some(start)) if start == a => Some((a, b)),
        (&[a, b], Some(start)) if start == b => Some((b, a)),
        (&[a, b], Some(start)) => {
            let id = |vertex: usize| network.vertices[vertex];
            return Err(RouteError::Start { start: id(start), ends: (id(a), id(b)) });
        }
        (_, start) => start.map(|start| (start, start)),
    };
    let copies: Vec<usize> = (0..network.links.len()).chain(doubled).collect();
    let mut meeting = vec![0; network.vertices.len()];
    for &copy in &copies {
        meeting[network.links[copy].a] += 1;
        meeting[network.links[copy].b] += 1;
    }
    if let Some(vertex) = meeting.iter().position(|&ends| ends > MAX_ENDS) {
        let (vertex, ends) = (network.vertices[vertex], meeting[vertex]);
        return Err(RouteError::TooManyEnds { vertex, ends, max: MAX_ENDS });
    }
    let mut pairing = Pairing::new(&network, &copies, ends, options.max_bend);
    trails::join(&mut pairing);
    let mut travelled = vec![false; network.links.len()];
    let traversals = trails::walk(&pairing)
        .into_iter()
        .map(|(copy, forward)| {
            let link = &network.links[copies[copy]];
            let (from, to) = if forward { (link.a, link.b) } else { (link.b, link.a) };
            Traversal {
                edge: link.id,
                from: network.vertices[from],
                to: network.vertices[to],
                again: std::mem::replace(&mut travelled[copies[copy]], true),
            }
        })
        .collect();
    Ok(Route { traversals })
}
