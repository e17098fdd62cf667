//! Bends beyond the limit that no choice of what follows what avoids, and the shortest detours around them.

use std::cmp::Reverse;
use std::collections::{BTreeMap, BinaryHeap};

use super::doubling::Doubling;
use super::matching::min_cost_pairs;
use super::network::Network;
use super::pairing::{End, Pairing};
use super::{Layout, RouteError, RouteOptions, layout};
use crate::units::{Angle, Length};
use crate::wireframe::{Component, EdgeId, VertexId, Wireframe};

/// By how much further the next search for walks goes, where those found leave open which are the shortest.
const FURTHER: i64 = 4;
/// Longer walks are none: 35 km, beyond every coil.
const MAX_WALK_NM: i64 = 1 << 45;

/// A vertex whose edges cannot follow each other without a bend beyond the limit.
#[derive(Debug, Clone, PartialEq)]
pub struct ForcedBend {
    /// The vertex.
    pub vertex: VertexId,
    /// Two edges that the wire bends between, by the least that the sharpest bend at this vertex can be.
    pub edges: [EdgeId; 2],
    /// By how much, as a magnitude.
    pub bend: Angle,
    /// Edges to travel once more, so that the wire leaves the vertex and comes back another way: the shortest such walks, for this
    /// vertex alone and with no bend beyond the limit of their own. Where a walk passes a vertex it may as well change places with
    /// what passes there already, and serve another forced bend: the least that does for all vertices together is a matching of
    /// all ends at once, and about half as long on small graphs of a plane (the tests compare). None where no
    /// walk leads back within the limit.
    pub detour: Option<Doubling>,
    /// What comes of starting the wire at this vertex.
    pub start: StartThere,
}

/// What comes of starting the wire at the vertex of a forced bend.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum StartThere {
    /// It was not tried.
    NotTried,
    /// The bend stays, or others beyond the limit take its place.
    HelpsNot,
    /// Fewer bends are beyond the limit then and none there, and the doubled length changes by this; negative where it gets shorter.
    Adds(Length),
}

/// The vertices at which every route with these options has a bend beyond the limit, where one may be missing: as
/// [`routes`](super::routes) finds them.
///
/// # Errors
/// As [`routes`](super::routes).
pub fn forced_bends(
    wireframe: &Wireframe,
    component: &Component,
    options: &RouteOptions,
) -> Result<Vec<ForcedBend>, RouteError> {
    let network = Network::new(wireframe, component);
    let Layout { copies, wire_ends } = layout(&network, component, options)?;
    Ok(forced(wireframe, &Pairing::new(&network, &copies, &wire_ends, options.max_bend)))
}

/// The vertices at which a pairing has a bend beyond the limit although it is the best there. An edge that the wire has to go back
/// along from a dead end is none: only the edges of two others are paired. One closed wire with a free start has its ends at the
/// only one, where it needs no bend.
fn forced_vertices(pairing: &Pairing) -> Vec<usize> {
    let is_forced = |&vertex: &usize| {
        pairing.pairs(vertex).any(|(p, q)| !pairing.allows(p, q))
            && pairing.ends(vertex).iter().all(|&end| pairing.has_direction(end))
            && has_two_edges(pairing, vertex)
    };
    let forced: Vec<usize> = (0..pairing.vertex_count()).filter(is_forced).collect();
    if let ([only], true) = (forced.as_slice(), pairing.wire_ends().is_empty()) {
        let beyond = pairing.pairs(*only).filter(|&(p, q)| !pairing.allows(p, q));
        if beyond.count() == 1 {
            return Vec::new();
        }
    }
    forced
}

/// The forced bends of a pairing, with detours around them.
pub(super) fn forced(wireframe: &Wireframe, pairing: &Pairing) -> Vec<ForcedBend> {
    let forced = forced_vertices(pairing);
    if forced.is_empty() {
        return Vec::new();
    }
    let mut detours = Detours::new(pairing);
    forced.into_iter().map(|vertex| forced_at(wireframe, pairing, vertex, &mut detours)).collect()
}

fn has_two_edges(pairing: &Pairing, vertex: usize) -> bool {
    let mut edges = pairing.ends(vertex).iter().filter_map(|&end| pairing.link_end(end));
    edges.next().is_some_and(|first| edges.any(|other| other != first))
}

fn forced_at(wireframe: &Wireframe, pairing: &Pairing, vertex: usize, detours: &mut Detours) -> ForcedBend {
    let network = pairing.network();
    let ends = pairing.ends(vertex);
    let (p, q) = gentlest(pairing, ends);
    let edge = |end: End| network.links[pairing.link_end(end).unwrap_or_default() / 2].id;
    ForcedBend {
        vertex: network.vertices[vertex],
        edges: [edge(p), edge(q)],
        bend: Angle::computed(pairing.bend_deg(p, q).to_radians()),
        detour: detours.around(ends).map(|links| {
            let mut edges: Vec<EdgeId> = links.into_iter().map(|link| network.links[link].id).collect();
            edges.sort_unstable();
            let added = edges.iter().map(|&edge| wireframe.edge_length(edge)).sum();
            Doubling { edges, added }
        }),
        start: StartThere::NotTried,
    }
}

/// The sharpest pair of the pairing whose sharpest is the gentlest.
fn gentlest(pairing: &Pairing, ends: &[End]) -> (End, End) {
    let mut pairs: Vec<(f64, (End, End))> = Vec::new();
    for (k, &p) in ends.iter().enumerate() {
        let others = ends[k + 1..].iter().filter(|&&q| !pairing.is_wire_end(p) && !pairing.is_wire_end(q));
        pairs.extend(others.map(|&q| (pairing.bend_deg(p, q), (p, q))));
    }
    pairs.sort_by(|a, b| a.0.total_cmp(&b.0));
    // With more pairs allowed there is a perfect pairing at once or never.
    let is_enough = |&(limit, _): &(f64, (End, End))| {
        let allowed = |k: usize, j: usize| match [ends[k], ends[j]].map(|end| pairing.is_wire_end(end)) {
            [true, true] => false,
            [false, false] => pairing.bend_deg(ends[k], ends[j]) <= limit,
            _ => true,
        };
        let matched = min_cost_pairs(ends.len(), |k, j| allowed(k, j).then_some(0));
        2 * matched.len() == ends.len()
    };
    let at = pairs.partition_point(|pair| !is_enough(pair));
    pairs.get(at).or(pairs.last()).map_or((ends[0], ends[0]), |&(_, pair)| pair)
}

/// Shortest walks from a vertex back to it, with no bend beyond the limit. Ends are those of links: twice the link, plus one at its
/// second vertex.
struct Detours<'a> {
    pairing: &'a Pairing<'a>,
    search: Search,
}

impl<'a> Detours<'a> {
    fn new(pairing: &'a Pairing<'a>) -> Self {
        Self { pairing, search: Search::new(2 * pairing.network().links.len()) }
    }

    /// The links to travel once more so that all ends of a vertex can be paired, together the shortest; none where no walks
    /// do it.
    fn around(&mut self, ends: &[End]) -> Option<Vec<usize>> {
        let of_link: Vec<Option<End>> = ends.iter().map(|&end| self.pairing.link_end(end)).collect();
        let mut from: Vec<End> = of_link.iter().copied().flatten().collect();
        from.sort_unstable();
        from.dedup();
        let links = &self.pairing.network().links;
        let around: i64 = from.iter().map(|end| links[end / 2].length_nm).sum();
        let mut within = around.clamp(1, MAX_WALK_NM);
        loop {
            let walks: BTreeMap<End, Walks> =
                from.iter().map(|&p| (p, self.walks(p, &from, within))).collect();
            // The way back is as long as the way there.
            let known = |p: End, q: End| walks[&p.min(q)].to.get(&p.max(q));
            let is_open = |p: End, q: End| within < MAX_WALK_NM && !walks[&p].are_all && !walks[&q].are_all;
            let cost = |k: usize, j: usize| match (of_link[k], of_link[j]) {
                (Some(p), Some(q)) if self.pairing.follows(p, q) => Some(0),
                (Some(p), Some(q)) => {
                    let length = known(p, q).map(|(length, _)| *length);
                    length.or_else(|| is_open(p, q).then_some(within + 1))
                }
                (None, None) => None,
                _ => Some(0),
            };
            let matched = min_cost_pairs(ends.len(), cost);
            if 2 * matched.len() < ends.len() {
                return None;
            }
            // What is not known is longer than all of it.
            let length: i64 = matched.iter().filter_map(|&(k, j)| cost(k, j)).sum();
            if length <= within || within == MAX_WALK_NM {
                let walked = matched.into_iter().filter_map(|(k, j)| {
                    let (p, q) = (of_link[k]?, of_link[j]?);
                    (!self.pairing.follows(p, q)).then(|| known(p, q))?
                });
                return Some(walked.flat_map(|(_, links)| links.iter().copied()).collect());
            }
            within = (within * FURTHER).min(MAX_WALK_NM);
        }
    }

    /// From an end by which the wire comes, the shortest walks of up to a length to the ends after it by which it can leave the
    /// same vertex, where it cannot at once.
    fn walks(&mut self, from: End, to: &[End], within: i64) -> Walks {
        let home = self.pairing.vertex(from);
        let mut wanted: Vec<End> =
            to.iter().copied().filter(|&q| q >= from && !self.pairing.follows(from, q)).collect();
        let mut walks = Walks::default();
        self.search.begin();
        self.go_on(from, 0, None);
        while !wanted.is_empty()
            && let Some((length, leaving)) = self.search.next()
        {
            if length > within {
                return walks;
            }
            let end = leaving ^ 1;
            if self.pairing.vertex(end) == home {
                wanted.retain(|&q| {
                    let is_back = self.pairing.follows(end, q);
                    if is_back {
                        walks.to.insert(q, (length, self.search.links_to(leaving)));
                    }
                    !is_back
                });
            }
            self.go_on(end, length, Some(leaving));
        }
        walks.are_all = !wanted.is_empty();
        walks
    }

    /// Goes on from an end by which the wire comes, after the link that it left by another.
    fn go_on(&mut self, end: End, length: i64, before: Option<End>) {
        let Self { pairing, search } = self;
        let links = &pairing.network().links;
        let ends = pairing.link_ends(pairing.vertex(end));
        for next in ends.filter(|&next| pairing.follows(end, next)) {
            search.reach(next, length + links[next / 2].length_nm, before);
        }
    }
}

/// Shortest walks from an end of a vertex.
#[derive(Default)]
struct Walks {
    /// The length in nm and the links of each, by the end to which it leads.
    to: BTreeMap<End, (i64, Vec<usize>)>,
    /// Whether there are no others from this end, however long.
    are_all: bool,
}

/// Dijkstra's algorithm over the ends by which links are left; its memory is used again by the next search.
struct Search {
    round: u32,
    reached: Vec<Reached>,
    queue: BinaryHeap<Reverse<(i64, End)>>,
}

#[derive(Clone, Copy)]
struct Reached {
    round: u32,
    length: i64,
    before: Option<End>,
}

impl Search {
    fn new(ends: usize) -> Self {
        let reached = vec![Reached { round: 0, length: 0, before: None }; ends];
        Self { round: 0, reached, queue: BinaryHeap::new() }
    }

    fn begin(&mut self) {
        self.round += 1;
        self.queue.clear();
    }

    fn reach(&mut self, end: End, length: i64, before: Option<End>) {
        let reached = &mut self.reached[end];
        if reached.round != self.round || length < reached.length {
            *reached = Reached { round: self.round, length, before };
            self.queue.push(Reverse((length, end)));
        }
    }

    /// The next end by which the shortest walk leaves, with its length to the other end of that link.
    fn next(&mut self) -> Option<(i64, End)> {
        loop {
            let Reverse((length, end)) = self.queue.pop()?;
            if length == self.reached[end].length {
                return Some((length, end));
            }
        }
    }

    /// The links of a walk, the last first.
    fn links_to(&self, last: End) -> Vec<usize> {
        std::iter::successors(Some(last), |&end| self.reached[end].before).map(|end| end / 2).collect()
    }
}

#[cfg(test)]
mod tests;
