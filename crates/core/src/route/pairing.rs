//! Which edge end is followed by which at every vertex.

use nalgebra::Vector3;

use super::matching::min_cost_pairs;
use super::network::Network;
use crate::units::Angle;

/// An end of a copy of an edge: twice the copy's index, plus one at its second vertex. The highest ones are the ends of the
/// wires themselves, where there are any.
pub(super) type End = usize;

/// Cost of a fold back, of a bend beyond the limit, and of a bend per square degree. One fold back weighs more than all bends beyond
/// the limit of a vertex, one of those more than all squares: this holds for up to 1000 ends, and 500 are paired.
const FOLD_BACK: i64 = 1 << 46;
pub(super) const BEYOND_LIMIT: i64 = 1 << 35;
const PER_SQUARE_DEGREE: f64 = 1000.0;
/// What arithmetic may leave between a bend and a limit that it is at.
const ROUNDING_DEG: f64 = 1e-9;

/// For every vertex a perfect matching of the edge ends that meet there.
pub(super) struct Pairing<'a> {
    network: &'a Network,
    /// The link of each copy: every link once, and each doubled one once more.
    copies: &'a [usize],
    /// The vertices where wires start or end.
    at_wire_ends: &'a [usize],
    /// The cosine of the limit.
    min_cos: f64,
    /// The ends that meet at each vertex, in order, one vertex after the other.
    ends: Vec<End>,
    /// Where those of each vertex begin, and where those of the last end.
    first: Vec<usize>,
    /// Who follows whom.
    mate: Vec<End>,
}

impl<'a> Pairing<'a> {
    /// The cheapest pairing at each vertex, on its own. `wire_ends` are the vertices where wires start or end; without them it
    /// is one closed loop.
    pub fn new(
        network: &'a Network,
        copies: &'a [usize],
        wire_ends: &'a [usize],
        max_bend: Option<Angle>,
    ) -> Self {
        let of_copies = copies.iter().flat_map(|&link| [network.links[link].a, network.links[link].b]);
        let at: Vec<usize> = of_copies.chain(wire_ends.iter().copied()).collect();
        let (first, ends) = by_vertex(network.vertices.len(), &at);
        let mate = vec![usize::MAX; at.len()];
        let min_cos = min_cos(max_bend.map_or(180.0, Angle::deg));
        let mut pairing = Self { network, copies, at_wire_ends: wire_ends, min_cos, ends, first, mate };
        for vertex in 0..network.vertices.len() {
            let ends = pairing.ends(vertex);
            // Ends of wires follow nothing, least of all each other.
            let matched = min_cost_pairs(ends.len(), |k, j| {
                let both = pairing.is_wire_end(ends[k]) && pairing.is_wire_end(ends[j]);
                (!both).then(|| pairing.cost(ends[k], ends[j]))
            });
            for (k, j) in matched {
                let ends = pairing.ends(vertex);
                pairing.set(ends[k], ends[j]);
            }
        }
        pairing
    }

    /// Unit vector out of the vertex along an end.
    fn out(&self, end: End) -> Vector3<f64> {
        out(self.network.links[self.copies[end / 2]].direction, end)
    }

    /// What it costs that one end follows the other.
    pub fn cost(&self, p: End, q: End) -> i64 {
        if self.is_wire_end(p) || self.is_wire_end(q) {
            return 0;
        }
        let cos = cos_of_bend(self.out(p), self.out(q));
        let bend = bend_deg(cos);
        #[allow(clippy::cast_possible_truncation)] // at most 180² · 1000
        let sharpness = (bend * bend * PER_SQUARE_DEGREE).round() as i64;
        let beyond = if cos >= self.min_cos { 0 } else { BEYOND_LIMIT };
        let fold = if self.copies[p / 2] == self.copies[q / 2] { FOLD_BACK } else { 0 };
        fold + beyond + sharpness
    }

    /// By how much the wire bends where one end follows the other, in degrees.
    pub fn bend_deg(&self, p: End, q: End) -> f64 {
        bend_deg(cos_of_bend(self.out(p), self.out(q)))
    }

    /// Whether one end may follow the other.
    pub fn allows(&self, p: End, q: End) -> bool {
        if self.is_wire_end(p) || self.is_wire_end(q) {
            return true;
        }
        let folds = self.copies[p / 2] == self.copies[q / 2];
        !folds && cos_of_bend(self.out(p), self.out(q)) >= self.min_cos
    }

    /// Whether an end of a link, other than that of a copy, may follow another.
    pub fn follows(&self, p: End, q: End) -> bool {
        let out = |end: End| out(self.network.links[end / 2].direction, end);
        p != q && cos_of_bend(out(p), out(q)) >= self.min_cos
    }

    /// The end of the link of which an end is a copy; none of the end of a wire.
    pub fn link_end(&self, end: End) -> Option<End> {
        self.copies.get(end / 2).map(|link| 2 * link + end % 2)
    }

    /// Whether the edge of an end has a direction: none without length has.
    pub fn has_direction(&self, end: End) -> bool {
        self.is_wire_end(end) || self.out(end) != Vector3::zeros()
    }

    /// What it is the pairing of.
    pub fn network(&self) -> &'a Network {
        self.network
    }

    /// Lets two ends follow each other.
    pub fn set(&mut self, p: End, q: End) {
        self.mate[p] = q;
        self.mate[q] = p;
    }

    /// Who follows an end.
    pub fn mate(&self, end: End) -> End {
        self.mate[end]
    }

    /// How many copies of edges there are.
    pub fn copy_count(&self) -> usize {
        self.copies.len()
    }

    /// How many ends there are, those of the wire included.
    pub fn end_count(&self) -> usize {
        self.mate.len()
    }

    /// How many vertices there are.
    pub fn vertex_count(&self) -> usize {
        self.network.vertices.len()
    }

    /// The vertex that an end is at.
    pub fn vertex(&self, end: End) -> usize {
        let Some(&link) = self.copies.get(end / 2) else {
            return self.at_wire_ends[end - 2 * self.copies.len()];
        };
        let link = &self.network.links[link];
        if end.is_multiple_of(2) { link.a } else { link.b }
    }

    /// The ends that meet at a vertex, in order: first those of links, one each, then those of their other copies, then those of
    /// wires.
    pub fn ends(&self, vertex: usize) -> &[End] {
        &self.ends[self.first[vertex]..self.first[vertex + 1]]
    }

    /// The ends of links that meet at a vertex.
    pub fn link_ends(&self, vertex: usize) -> impl Iterator<Item = End> {
        let links = self.network.links.len();
        self.ends(vertex).iter().copied().take_while(move |&end| end < 2 * links)
    }

    /// The pairs at a vertex, each with its lower end first.
    pub fn pairs(&self, vertex: usize) -> impl Iterator<Item = (End, End)> + Clone {
        self.ends(vertex).iter().map(|&p| (p, self.mate[p])).filter(|(p, q)| p < q)
    }

    /// Whether an end is one where a wire starts or ends.
    pub fn is_wire_end(&self, end: End) -> bool {
        end >= 2 * self.copies.len()
    }

    /// The ends where wires start or end.
    pub fn wire_ends(&self) -> std::ops::Range<End> {
        2 * self.copies.len()..self.mate.len()
    }
}

/// Ends `0..` by the vertex that each is at: where those of each vertex begin, with the end of the last, and all of them.
fn by_vertex(vertices: usize, at: &[usize]) -> (Vec<usize>, Vec<End>) {
    let mut first = vec![0; vertices + 2];
    for &vertex in at {
        first[vertex + 2] += 1;
    }
    for k in 2..first.len() {
        first[k] += first[k - 1];
    }
    // Each row is written from its beginning: `first[vertex + 1]` moves from there to where it ends.
    let mut ends = vec![0; at.len()];
    for (end, &vertex) in at.iter().enumerate() {
        let next = &mut first[vertex + 1];
        ends[*next] = end;
        *next += 1;
    }
    first.pop();
    (first, ends)
}

/// Unit vector out of a vertex along an end of an edge.
fn out(direction: Vector3<f64>, end: End) -> Vector3<f64> {
    if end.is_multiple_of(2) { direction } else { -direction }
}

/// The cosine of the bend of a wire that comes along one and leaves along the other of two directions out of a vertex.
fn cos_of_bend(one: Vector3<f64>, other: Vector3<f64>) -> f64 {
    -one.dot(&other)
}

fn bend_deg(cos: f64) -> f64 {
    cos.clamp(-1.0, 1.0).acos().to_degrees()
}

/// The least cosine of bends up to a limit.
fn min_cos(limit_deg: f64) -> f64 {
    let limit = limit_deg + ROUNDING_DEG;
    if limit < 180.0 { limit.to_radians().cos() } else { f64::NEG_INFINITY }
}
