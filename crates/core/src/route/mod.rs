//! The route: one walk along the wire that uses every edge of a component, or one for each of several wires.
//!
//! An Euler path exists when no more than two vertices are odd; each further wire has room for two more. Where more are odd,
//! some edges have to be travelled twice; which ones add the least length is [`doubling`]'s answer, and it is the caller's to
//! accept. Which edge follows which is chosen so that the wire never folds straight back where another pairing exists, then
//! so that as few bends as possible are beyond the limit, and then so that it bends as little as possible. Where no choice
//! avoids a bend beyond the limit, [`forced_bends`] says so, and along which edges a detour would.

mod doubling;
mod forced;
mod matching;
mod network;
mod pairing;
mod trails;

use network::Network;
use pairing::Pairing;

use crate::units::Angle;
use crate::wireframe::{Component, EdgeId, VertexId, Wireframe};

pub(crate) use doubling::doubling_weighed;
pub use doubling::{Doubling, Share, doubling, doublings, share_out};
pub use forced::{ForcedBend, StartThere, forced_bends};

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

    /// The walk from a vertex along edges in an order; none where two that follow one another do not meet.
    #[must_use]
    pub fn along(wireframe: &Wireframe, start: VertexId, edges: &[EdgeId]) -> Option<Self> {
        let mut seen = std::collections::BTreeSet::new();
        let mut from = start;
        let traversal = |&edge: &EdgeId| {
            let ends = wireframe.edge(edge).filter(|ends| ends.a == from || ends.b == from)?;
            let to = ends.other(from);
            Some(Traversal { edge, from: std::mem::replace(&mut from, to), to, again: !seen.insert(edge) })
        };
        edges.iter().map(traversal).collect::<Option<_>>().map(|traversals| Self { traversals })
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
#[derive(Debug, Clone, PartialEq)]
pub struct RouteOptions {
    /// Edges that are travelled once more than they are drawn; an edge may be listed repeatedly.
    pub doubled: Vec<EdgeId>,
    /// Where the wire starts; chosen when absent.
    pub start: Option<VertexId>,
    /// How many open wires there may be, at least one.
    pub wires: usize,
    /// Whether there is to be one wire, which must end where it starts.
    pub closed: bool,
    /// The largest bend that the machine makes; larger ones are avoided where possible.
    pub max_bend: Option<Angle>,
}

impl Default for RouteOptions {
    /// One open wire along every edge once.
    fn default() -> Self {
        Self { doubled: Vec::new(), start: None, wires: 1, closed: false, max_bend: None }
    }
}

impl RouteOptions {
    /// How many vertices may be odd: those where wires start and end.
    const fn odd_allowed(&self) -> usize {
        if self.closed { 0 } else { 2 * self.wires }
    }
}

/// Why there is no route.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum RouteError {
    /// The component has no edges.
    #[error("there is no edge to run along")]
    NoEdges,
    /// Too many odd vertices for open wires, or any for a closed one.
    #[error("{} vertices have an odd number of edges; {allowed} may have", odd.len())]
    Odd {
        /// Which.
        odd: Vec<VertexId>,
        /// How many may be odd.
        allowed: usize,
    },
    /// The wanted start is not one of the odd vertices, where open wires have to start.
    #[error("no wire can start at vertex {start}: one has to start at an odd vertex, the first of which is {}", ends[0])]
    Start {
        /// The wanted start.
        start: VertexId,
        /// The vertices where one can: two or more.
        ends: Vec<VertexId>,
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

/// The most edge ends at one vertex that are paired: time grows with about their cube. No wire comes through one point so often.
const MAX_ENDS: usize = 500;

/// A route of one wire through every edge of a component, whatever the options say of several.
///
/// # Errors
/// As [`routes`].
pub fn route(
    wireframe: &Wireframe,
    component: &Component,
    options: &RouteOptions,
) -> Result<Route, RouteError> {
    let mut found = routes(wireframe, component, &RouteOptions { wires: 1, ..options.clone() })?;
    found.routes.pop().ok_or(RouteError::NoEdges)
}

/// Routes, one for each wire, and what every such route has.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Routes {
    /// The routes.
    pub routes: Vec<Route>,
    /// The bends beyond the limit that none avoids.
    pub forced: Vec<ForcedBend>,
}

/// Routes that together pass every edge of a component: one for every two odd vertices, where each starts or ends, and where
/// `start` is even and a wire is left for it, one more that starts there.
///
/// The result is the same on every run. Open routes start at `start` or, without one, at the odd vertices with the lowest
/// ids; where every vertex is even the wire starts at `start` or so that its sharpest bend is the one that need not be made.
///
/// # Errors
/// [`RouteError`] when there are too many odd vertices, or the start or a doubling does not fit.
pub fn routes(
    wireframe: &Wireframe,
    component: &Component,
    options: &RouteOptions,
) -> Result<Routes, RouteError> {
    let network = Network::new(wireframe, component);
    let Layout { copies, wire_ends } = layout(&network, component, options)?;
    let mut pairing = Pairing::new(&network, &copies, &wire_ends, options.max_bend);
    let forced = forced::forced(wireframe, &pairing);
    trails::join(&mut pairing);
    let mut last_on = vec![usize::MAX; network.links.len()];
    let mut traversal = |wire: usize, (copy, forward): (usize, bool)| {
        let link = &network.links[copies[copy]];
        let (from, to) = if forward { (link.a, link.b) } else { (link.b, link.a) };
        let again = std::mem::replace(&mut last_on[copies[copy]], wire) == wire;
        Traversal { edge: link.id, from: network.vertices[from], to: network.vertices[to], again }
    };
    let walks = trails::walks(&pairing).into_iter().enumerate();
    let route = |(wire, walk): (usize, Vec<_>)| Route {
        traversals: walk.into_iter().map(|copy| traversal(wire, copy)).collect(),
    };
    Ok(Routes { routes: walks.map(route).collect(), forced })
}

/// What is walked: every link once and each doubled one once more, and the vertices where wires start or end.
struct Layout {
    copies: Vec<usize>,
    wire_ends: Vec<usize>,
}

fn layout(network: &Network, component: &Component, options: &RouteOptions) -> Result<Layout, RouteError> {
    if component.edges.is_empty() {
        return Err(RouteError::NoEdges);
    }
    let position = |edge: &EdgeId| {
        let found = network.links.binary_search_by_key(edge, |link| link.id);
        found.map_err(|_| RouteError::DoubledElsewhere(*edge))
    };
    let doubled: Vec<usize> = options.doubled.iter().map(position).collect::<Result<_, _>>()?;
    let start = match options.start {
        Some(start) => Some(network.index(start).ok_or(RouteError::StartElsewhere(start))?),
        None => None,
    };
    let mut odd = network.odd(&doubled);
    let ids = |odd: &[usize]| odd.iter().map(|&vertex| network.vertices[vertex]).collect();
    if odd.len() > options.odd_allowed() {
        return Err(RouteError::Odd { odd: ids(&odd), allowed: options.odd_allowed() });
    }
    let wire_ends = match start.map(|start| (start, odd.binary_search(&start))) {
        None => odd,
        Some((_, Ok(at))) => {
            odd[..=at].rotate_right(1);
            odd
        }
        // A wire may end where one starts.
        Some((start, Err(_))) if odd.is_empty() || odd.len() + 2 <= options.odd_allowed() => {
            odd.splice(..0, [start, start]);
            odd
        }
        Some((start, Err(_))) => {
            return Err(RouteError::Start { start: network.vertices[start], ends: ids(&odd) });
        }
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
    Ok(Layout { copies, wire_ends })
}
