//! The proof that a join is the cheapest: moats around sets of odd vertices, which every join has to cross.
//!
//! A moat is as wide as its dual; moats lie within each other and never overlap on an edge. Each set has an odd number of odd
//! vertices, so some edge of any join crosses its moat: the widths together are a bound from below, and a join that weighs
//! as much is the cheapest.

use std::collections::{BTreeSet, BinaryHeap};

use crate::graph::{Graph, NONE, id};
use crate::matching::{Laminar, Matching};
use crate::nested;
use crate::search::Queued;

/// Edges that meet each odd vertex an odd number of times and every other an even number of times, but for those that are
/// left as they are.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Join {
    /// The edges, in order.
    pub edges: Vec<u32>,
    /// Their weights together.
    pub weight: u64,
    /// The odd vertices that are left as they are, in order.
    pub left: Vec<u32>,
    /// That no join is cheaper.
    pub certificate: Certificate,
}

/// Moats, by the sets that they are around, and where the vertices of the graph lie among them. Lengths are four times those of
/// the graph, and so whole numbers.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Certificate {
    /// Sets: first each odd vertex alone, in the order in which they were given, then the stand-in of each that is left, then
    /// larger sets. For each the number of the next larger set around it, which comes later; [`NO_SET`] where there is none.
    pub parents: Vec<u32>,
    /// The width of the moat around each; that of a stand-in may be negative.
    pub widths: Vec<i64>,
    /// For each vertex of the graph the odd vertex, by its place in the order, in whose moats it lies; [`NO_SET`] where it lies
    /// outside of all.
    pub inside: Vec<u32>,
    /// How far from that one it lies.
    pub depths: Vec<i64>,
}

/// No set.
pub const NO_SET: u32 = NONE;

/// What is wrong with a certificate.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum Broken {
    /// Lists have other lengths than the problem, or name what there is not.
    #[error("the certificate is not of this problem")]
    Shape,
    /// The edges are no join of these vertices.
    #[error("vertex {0} is met by the wrong number of edges")]
    NoJoin(u32),
    /// A vertex that is left is none of those asked for, or is left twice.
    #[error("vertex {0} is not one of the odd vertices that can be left")]
    Left(u32),
    /// A moat with a negative width.
    #[error("the moat of set {0} has a negative width")]
    Negative(usize),
    /// A set that a join need not leave.
    #[error("set {0} has an even number of odd vertices")]
    Even(usize),
    /// An odd vertex is not where its own moats begin.
    #[error("odd vertex {0} does not lie in its own moat")]
    Elsewhere(u32),
    /// Moats overlap.
    #[error("the moats on edge {0} are wider than it is long")]
    Overlap(u32),
    /// The moats of an odd vertex and of a stand-in overlap.
    #[error("the moats between odd vertex {0} and a stand-in are wider than nothing")]
    OverlapAtEnd(u32),
    /// The join weighs something else.
    #[error("the edges weigh {weight}, not {told}")]
    Weight {
        /// What the join says.
        told: u64,
        /// What its edges weigh.
        weight: u64,
    },
    /// The bound is less than the join weighs.
    #[error("the moats are {bound} wide together, four times the weight of the join is {weight}")]
    NotTight {
        /// The widths of all moats.
        bound: i64,
        /// Four times the weight.
        weight: i64,
    },
}

impl Certificate {
    /// Of a matching that all of the odd vertices and so many stand-ins take part in. Each vertex of the graph goes to the odd one
    /// that it lies deepest in.
    pub(crate) fn new(graph: &Graph, odd: &[u32], left: usize, matching: &Matching) -> Self {
        let Laminar { parents, duals } = matching.laminar(odd.len() + left);
        let start = |(number, &vertex): (usize, &u32)| (id(number), vertex, matching.radius(id(number)));
        let nearest = flood(graph, odd.iter().enumerate().map(start));
        let inside = nearest.iter().map(|at| at.odd).collect();
        let depth = |at: &Nearest| if at.odd == NONE { 0 } else { at.beyond + matching.radius(at.odd) };
        Self { parents, widths: duals, inside, depths: nearest.iter().map(depth).collect() }
    }
}

/// Which odd vertex a vertex lies nearest to, when from the distance the radius is taken.
#[derive(Clone, Copy)]
struct Nearest {
    odd: u32,
    /// Four times the distance, less the radius.
    beyond: i64,
}

/// From odd vertices on, each with its radius, as far as they reach. An odd vertex that is listed is its own at a tie.
fn flood(graph: &Graph, starts: impl ExactSizeIterator<Item = (u32, u32, i64)>) -> Vec<Nearest> {
    let mut nearest = vec![Nearest { odd: NONE, beyond: i64::MAX }; graph.vertices()];
    let mut queue = Vec::with_capacity(starts.len());
    for (odd, vertex, radius) in starts {
        nearest[vertex as usize] = Nearest { odd, beyond: -radius };
        queue.push(Queued { distance: -radius, vertex });
    }
    let mut queue = BinaryHeap::from(queue);
    while let Some(Queued { distance: beyond, vertex }) = queue.pop() {
        let at = nearest[vertex as usize];
        if beyond > at.beyond {
            continue;
        }
        for arc in graph.at(vertex) {
            let further = beyond + 4 * arc.weight;
            let other = &mut nearest[arc.to as usize];
            if further < other.beyond.min(0) {
                *other = Nearest { odd: at.odd, beyond: further };
                queue.push(Queued { distance: further, vertex: arc.to });
            }
        }
    }
    nearest
}

/// Lengths beyond this are none of a graph; sums of a few below it do not overflow.
const MAX_LENGTH: u64 = 1 << 61;

/// Whether no sum of them can overflow.
fn are_small(widths: &[i64]) -> bool {
    let sum = widths.iter().try_fold(0_u64, |sum, width| sum.checked_add(width.unsigned_abs()));
    sum.is_some_and(|sum| sum <= MAX_LENGTH)
}

/// Proves that a join is the cheapest, by its certificate alone: with the graph and the vertices that it was asked for.
///
/// # Errors
/// [`Broken`], the first thing that is wrong.
pub fn verify(graph: &Graph, odd: &[u32], join: &Join) -> Result<(), Broken> {
    let Certificate { parents, widths, inside, depths } = &join.certificate;
    let (sets, singles) = (parents.len(), odd.len() + join.left.len());
    let later = |(set, &parent): (usize, &u32)| {
        parent == NO_SET || (parent as usize > set && (parent as usize) < sets)
    };
    let outer = |parent: u32| parent == NO_SET || parent as usize >= singles;
    let known = |&odd_one: &u32| odd_one == NO_SET || (odd_one as usize) < odd.len();
    if singles > sets
        || widths.len() != sets
        || [inside.len(), depths.len()] != [graph.vertices(); 2]
        || !parents.iter().enumerate().all(later)
        || !parents.iter().all(|&parent| outer(parent))
        || !inside.iter().all(known)
        || odd.iter().any(|&vertex| vertex as usize >= graph.vertices())
        || join.edges.iter().any(|&edge| edge as usize >= graph.edges())
        || !are_small(widths)
        || depths.iter().any(|depth| depth.unsigned_abs() > MAX_LENGTH)
    {
        return Err(Broken::Shape);
    }
    let mut can_be_left: BTreeSet<u32> = odd.iter().copied().collect();
    if let Some(&vertex) = join.left.iter().find(|&vertex| !can_be_left.remove(vertex)) {
        return Err(Broken::Left(vertex));
    }
    // What is left changes nothing at its vertex, all other odd vertices are met an odd number of times.
    let mut met = vec![false; graph.vertices()];
    let ends = join.edges.iter().flat_map(|&edge| graph.ends(edge));
    for vertex in odd.iter().copied().chain(join.left.iter().copied()).chain(ends) {
        met[vertex as usize] ^= true;
    }
    if let Some(vertex) = met.iter().position(|&met| met) {
        return Err(Broken::NoJoin(id(vertex)));
    }
    // Which sets a join has to leave.
    let mut is_odd: Vec<bool> = (0..sets).map(|set| set < singles).collect();
    for set in 0..sets {
        if widths[set] < 0 && !(odd.len()..singles).contains(&set) {
            return Err(Broken::Negative(set));
        }
        if !is_odd[set] {
            return Err(Broken::Even(set));
        }
        if parents[set] != NO_SET {
            is_odd[parents[set] as usize] ^= true;
        }
    }
    let around = nested::around(parents, widths);
    for (k, &vertex) in odd.iter().enumerate() {
        if inside[vertex as usize] as usize != k || depths[vertex as usize] != 0 {
            return Err(Broken::Elsewhere(vertex));
        }
    }
    for stand_in in odd.len()..singles {
        // What each set has in common with it.
        let mut both = vec![None; sets];
        let mut set = id(stand_in);
        while set != NO_SET {
            both[set as usize] = Some(around[set as usize]);
            set = parents[set as usize];
        }
        for set in (0..sets).rev().filter(|&set| parents[set] != NO_SET) {
            both[set] = both[set].or(both[parents[set] as usize]);
        }
        for (k, &vertex) in odd.iter().enumerate() {
            if around[k] + around[stand_in] > 2 * both[k].unwrap_or(0) {
                return Err(Broken::OverlapAtEnd(vertex));
            }
        }
    }
    for edge in 0..id(graph.edges()) {
        let ends = graph.ends(edge).map(|end| (inside[end as usize], depths[end as usize]));
        let (a, b) = (ends[0].0, ends[1].0);
        let both = if a == NO_SET || b == NO_SET { 0 } else { nested::common(parents, &around, a, b) };
        // How far from each end to where the moats begin that are around both, and how far into those it lies.
        let [(own_a, in_a), (own_b, in_b)] = ends.map(|(odd_one, depth)| {
            if odd_one == NO_SET {
                return (0, 0);
            }
            let further = depth - (around[odd_one as usize] - both);
            ((-further).max(0), further.clamp(0, both))
        });
        if own_a + own_b + (in_a - in_b).abs() > 4 * graph.weight(edge) {
            return Err(Broken::Overlap(edge));
        }
    }
    let bound: i64 = widths.iter().sum();
    let weight: i64 = join.edges.iter().map(|&edge| graph.weight(edge)).sum();
    if weight.cast_unsigned() != join.weight {
        return Err(Broken::Weight { told: join.weight, weight: weight.cast_unsigned() });
    }
    let weight = 4 * weight;
    if bound == weight { Ok(()) } else { Err(Broken::NotTight { bound, weight }) }
}
