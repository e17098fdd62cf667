//! Which edge end is followed by which at every vertex.

use nalgebra::Vector3;

use super::matching::min_cost_pairs;
use super::network::Network;
use crate::units::Angle;

/// An end of a copy of an edge: twice the copy's index, plus one at its second vertex. The two
/// highest ones are the ends of the wire itself, where there are any.
pub(super) type End = usize;

/// Cost of a fold back, of a bend beyond the limit, and of a bend per square degree. One fold back
/// weighs more than all bends beyond the limit of a vertex, one of those more than all squares.
const FOLD_BACK: i64 = 1 << 50;
const BEYOND_LIMIT: i64 = 1 << 35;
const PER_SQUARE_DEGREE: f64 = 1000.0;

/// For every vertex a perfect matching of the edge ends that meet there.
pub(super) struct Pairing<'a> {
    network: &'a Network,
    /// The link of each copy: every link once, and each doubled one once more.
    copies: &'a [usize],
    max_bend_deg: f64,
    has_wire_ends: bool,
    /// Who follows whom.
    mate: Vec<End>,
    /// The pairs at each vertex.
    at: Vec<Vec<(End, End)>>,
}

impl<'a> Pairing<'a> {
    /// The cheapest pairing at each vertex, on its own. `ends` are the vertices where the wire starts
    /// and ends; without them it is a closed loop.
    pub fn new(
        network: &'a Network,
        copies: &'a [usize],
        ends: Option<(usize, usize)>,
        max_bend: Option<Angle>,
    ) -> Self {
        let mut meeting: Vec<Vec<End>> = vec![Vec::new(); network.vertices.len()];
        for (copy, &link) in copies.iter().enumerate() {
            meeting[network.links[link].a].push(2 * copy);
            meeting[network.links[link].b].push(2 * copy + 1);
        }
        if let Some((start, end)) = ends {
            meeting[start].push(2 * copies.len());
            meeting[end].push(2 * copies.len() + 1);
        }
        let mut pairing = Self {
            network,
            copies,
            max_bend_deg: max_bend.map_or(180.0, Angle::deg),
            has_wire_ends: ends.is_some(),
            mate: vec![usize::MAX; 2 * copies.len() + if ends.is_some() { 2 } else { 0 }],
            at: Vec::with_capacity(meeting.len()),
        };
        for ends in meeting {
            // The two ends of the wire follow nothing, least of all each other.
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
        let direction = self.network.links[self.copies[end / 2]].direction;
        if end.is_multiple_of(2) { direction } else { -direction }
    }

    /// What it costs that one end follows the other.
    pub fn cost(&self, p: End, q: End) -> i64 {
        if self.is_wire_end(p) || self.is_wire_end(q) {
            return 0;
        }
        let bend = (-self.out(p).dot(&self.out(q))).clamp(-1.0, 1.0).acos().to_degrees();
        #[allow(clippy::cast_possible_truncation)] // at most 180² · 1000
        let sharpness = (bend * bend * PER_SQUARE_DEGREE).round() as i64;
        let beyond = if bend > self.max_bend_deg { BEYOND_LIMIT } else { 0 };
        let fold = if self.copies[p / 2] == self.copies[q / 2] { FOLD_BACK } else { 0 };
        fold + beyond + sharpness
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

    /// Whether an end is one where the wire starts or ends.
    pub fn is_wire_end(&self, end: End) -> bool {
        end >= 2 * self.copies.len()
    }

    /// Whether the wire has ends at all.
    pub fn has_wire_ends(&self) -> bool {
        self.has_wire_ends
    }
}
