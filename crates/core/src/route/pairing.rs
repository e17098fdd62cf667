//! Which edge end is followed by which at every vertex.

use nalgebra::Vector3;

use super::matching::min_cost_pairs;
use super::network::Network;
use crate::units::Angle;

/// An end of a copy of an edge: twice the copy's index, plus one at its second vertex. The highest ones are the ends of the
/// wires themselves, where there are any.
pub(super) type End = usize;

/// Cost of a fold back, of a bend beyond the limit, and of a bend per square degree. One fold back
/// weighs more than all bends beyond the limit of a vertex, one of those more than all squares.
const FOLD_BACK: i64 = 1 << 50;
const BEYOND_LIMIT: i64 = 1 << 35;
const PER_SQUARE_DEGREE: f64 = 1000.0;
/// What arithmetic may leave between a bend and a limit that it is at.
const ROUNDING_DEG: f64 = 1e-9;

/// For every vertex a perfect matching of the edge ends that meet there.
pub(super) struct Pairing<'a> {
    network: &'a Network,
    /// The link of each copy: every link once, and each doubled one once more.
    copies: &'a [usize],
    max_bend_deg: f64,
    /// Who follows whom.
    mate: Vec<End>,
    /// The pairs at each vertex.
    at: Vec<Vec<(End, End)>>,
}

impl<'a> Pairing<'a> {
    /// The cheapest pairing at each vertex, on its own. `wire_ends` are the vertices where wires start or end; without them it
    /// is one closed loop.
    pub fn new(
        network: &'a Network,
        copies: &'a [usize],
        wire_ends: &[usize],
        max_bend: Option<Angle>,
    ) -> Self {
        let mut meeting: Vec<Vec<End>> = vec![Vec::new(); network.vertices.len()];
        for (copy, &link) in copies.iter().enumerate() {
            meeting[network.links[link].a].push(2 * copy);
            meeting[network.links[link].b].push(2 * copy + 1);
        }
        for (k, &vertex) in wire_ends.iter().enumerate() {
            meeting[vertex].push(2 * copies.len() + k);
        }
        let mut pairing = Self {
            network,
            copies,
            max_bend_deg: max_bend.map_or(180.0, Angle::deg),
            mate: vec![usize::MAX; 2 * copies.len() + wire_ends.len()],
            at: Vec::with_capacity(meeting.len()),
        };
        for ends in meeting {
            // Ends of wires follow nothing, least of all each other.
            let matched = min_cost_pairs(ends.len(), |k, j| {
                let both = pairing.is_wire_end(ends[k]) && pairing.is_wire_end(ends[j]);
                (!both).then(|| pairing.cost(ends[k], ends[j]))
            });
            let matched: Vec<(End, End)> = matched.into_iter().map(|(k, j)| (ends[k], ends[j])).collect();
            for &(p, q) in &matched {
                pairing.set(p, q);
            }
            pairing.at.push(matched);
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
        let bend = self.bend_deg(p, q);
        #[allow(clippy::cast_possible_truncation)] // at most 180² · 1000
        let sharpness = (bend * bend * PER_SQUARE_DEGREE).round() as i64;
        let beyond = if self.is_within(p, q, self.max_bend_deg) { 0 } else { BEYOND_LIMIT };
        let fold = if self.copies[p / 2] == self.copies[q / 2] { FOLD_BACK } else { 0 };
        fold + beyond + sharpness
    }

    /// By how much the wire bends where one end follows the other, in degrees.
    pub fn bend_deg(&self, p: End, q: End) -> f64 {
        between_deg(self.out(p), self.out(q))
    }

    /// Whether one end may follow the other.
    pub fn allows(&self, p: End, q: End) -> bool {
        self.cost(p, q) < BEYOND_LIMIT
    }

    /// Whether the bend from one end to the other is within a limit.
    pub fn is_within(&self, p: End, q: End, limit_deg: f64) -> bool {
        self.bend_deg(p, q) <= limit_deg + ROUNDING_DEG
    }

    /// Whether an end of a link, other than that of a copy, may follow another.
    pub fn follows(&self, p: End, q: End) -> bool {
        let out = |end: End| out(self.network.links[end / 2].direction, end);
        p != q && between_deg(out(p), out(q)) <= self.max_bend_deg + ROUNDING_DEG
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

    fn set(&mut self, p: End, q: End) {
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

    /// The pairs at every vertex.
    pub fn vertices(&self) -> &[Vec<(End, End)>] {
        &self.at
    }

    /// Replaces two pairs of a vertex by two others of the same four ends.
    pub fn replace(&mut self, vertex: usize, old: [(End, End); 2], new: [(End, End); 2]) {
        for (p, q) in new {
            self.set(p, q);
        }
        let pairs = &mut self.at[vertex];
        pairs.retain(|pair| !old.contains(pair));
        pairs.extend(new);
        pairs.sort_unstable();
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

/// Unit vector out of a vertex along an end of an edge.
fn out(direction: Vector3<f64>, end: End) -> Vector3<f64> {
    if end.is_multiple_of(2) { direction } else { -direction }
}

/// By how much the wire bends that comes along one and leaves along the other of two directions out of a vertex.
fn between_deg(one: Vector3<f64>, other: Vector3<f64>) -> f64 {
    (-one.dot(&other)).clamp(-1.0, 1.0).acos().to_degrees()
}
