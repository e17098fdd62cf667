//! Which edges come close to each other other than by being joined nearby.

use std::cmp::Reverse;
use std::collections::{BinaryHeap, HashMap};

use nalgebra::Point3;
use wirebend_collide::{between_pieces, close_pairs};

use crate::units::Length;
use crate::wireframe::{EdgeId, VertexId, Welder, Wireframe};

/// A walk along the design shorter than so many diameters joins two places: they are close by nature. Corners up to 151°
/// that are drawn with short edges leave their legs a diameter apart there: 1/sin(29°/2) = 4.
const JOINED: f64 = 4.0;
/// Edges are side by side where they come no closer than in the middle of it by more than so many diameters.
const AS_CLOSE: f64 = 0.1;
/// No more pairs for each edge are looked at: more are in each other's way only where the design is no larger than its wire.
const MOST_FOR_ONE: usize = 128;
/// No walk goes farther than so many vertices; edges with more around them are shorter than any that can be bent.
const MOST_VERTICES: usize = 512;

/// Two edges that come close to each other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Close {
    /// Their indices, the lower one first.
    pub edges: [usize; 2],
    /// How far apart they are, mm.
    pub distance: f64,
    /// Where that is on each, from 0 at its first vertex to 1 at its second.
    pub parts: [f64; 2],
}

/// The edges of a wireframe that have a length, by indices without gaps.
pub(super) struct Layout {
    pub ids: Vec<EdgeId>,
    vertices: Vec<VertexId>,
    ends: Vec<[usize; 2]>,
    pieces: Vec<[Point3<f64>; 2]>,
    lengths: Vec<f64>,
    /// The edges of each vertex.
    around: Vec<Vec<usize>>,
}

impl Layout {
    /// Vertices within `tolerance` of each other are taken for one; edges that are no longer have no direction and are left
    /// out.
    pub fn of(wireframe: &Wireframe, tolerance: Length) -> Self {
        let count = wireframe.edge_count();
        let mut welder = Welder::new(tolerance);
        let (mut vertices, mut points) = (Vec::new(), Vec::new());
        let mut index = HashMap::with_capacity(wireframe.vertex_count());
        for (id, vertex) in wireframe.vertices() {
            let first = VertexId(welder.put(id.0, vertex.position));
            let place = index.get(&first).copied().unwrap_or(vertices.len());
            if place == vertices.len() {
                vertices.push(id);
                points.push(vertex.position);
            }
            index.insert(id, place);
        }
        let mut layout = Self {
            ids: Vec::with_capacity(count),
            ends: Vec::with_capacity(count),
            pieces: Vec::with_capacity(count),
            lengths: Vec::with_capacity(count),
            around: vec![Vec::new(); vertices.len()],
            vertices,
        };
        for (id, edge) in wireframe.edges() {
            let (Some(&a), Some(&b)) = (index.get(&edge.a), index.get(&edge.b)) else { continue };
            let length = (points[b] - points[a]).norm();
            if length > tolerance.mm() {
                layout.around[a].push(layout.ids.len());
                layout.around[b].push(layout.ids.len());
                layout.ids.push(id);
                layout.ends.push([a, b]);
                layout.pieces.push([points[a], points[b]]);
                layout.lengths.push(length);
            }
        }
        layout
    }

    pub fn first_vertex(&self, edge: usize) -> VertexId {
        self.vertices[self.ends[edge][0]]
    }

    /// How far along one of its edges a close place is, mm from its first vertex.
    pub fn along(&self, close: &Close, side: usize) -> f64 {
        close.parts[side] * self.lengths[close.edges[side]]
    }

    /// The vertex of one of its edges that a close place is within `reach` of.
    pub fn end_within(&self, close: &Close, side: usize, reach: f64) -> Option<VertexId> {
        self.nearest_end(close, side, reach).map(|end| self.vertices[end])
    }

    fn nearest_end(&self, close: &Close, side: usize, reach: f64) -> Option<usize> {
        let edge = close.edges[side];
        let along = self.along(close, side);
        let rest = self.lengths[edge] - along;
        let end = usize::from(rest < along);
        (along.min(rest) < reach).then_some(self.ends[edge][end])
    }

    /// How many edges the vertex has that a close place is within `reach` of; none where there is no such vertex.
    pub fn edges_at_end(&self, close: &Close, side: usize, reach: f64) -> Option<usize> {
        self.nearest_end(close, side, reach).map(|end| self.around[end].len())
    }

    /// The middle of the part along which two edges lie side by side, where they are about as close there: the nearest place of
    /// such edges is an end of it. Where it is inside of both they cross.
    pub fn middle(&self, close: &Close, diameter: f64) -> Option<Close> {
        let crosses = close.parts.iter().all(|&part| 0.0 < part && part < 1.0);
        if crosses || Self::shared(close.edges.each_ref().map(|&edge| &self.ends[edge])).is_some() {
            return None;
        }
        let [[from, to], [low, high]] = close.edges.map(|edge| self.pieces[edge]);
        let length = self.lengths[close.edges[0]];
        let along = (to - from) / length;
        let [one, other] = [low, high].map(|end| (end - from).dot(&along).clamp(0.0, length));
        if (one - other).abs() < 2.0 * diameter {
            return None;
        }
        let part = f64::midpoint(one, other) / length;
        let (distance, [_, across]) = between_pieces(&[from + (to - from) * part; 2], &[low, high]);
        let as_close = distance <= close.distance + AS_CLOSE * diameter;
        as_close.then_some(Close { parts: [part, across], ..*close })
    }

    /// The pairs of edges that come closer than `diameter`, away from where the design joins them.
    pub fn close(&self, diameter: f64) -> Vec<Close> {
        let most = MOST_FOR_ONE * self.ids.len();
        let pairs = close_pairs(&self.pieces, diameter, most, |pair| self.counts(pair, diameter));
        let mut walks = [Walks::of(self), Walks::of(self)];
        let mut found = Vec::new();
        for of_one in pairs.chunk_by(|one, other| one.pieces[0] == other.pieces[0]) {
            let Some(first) = of_one.first() else { continue };
            let edge = first.pieces[0];
            let mut ends = walks.iter_mut().zip(self.ends[edge]);
            if !ends.all(|(walks, end)| walks.walk(end, JOINED * diameter)) {
                continue;
            }
            found.extend(of_one.iter().filter_map(|pair| {
                let close = Close { edges: pair.pieces, distance: pair.distance, parts: pair.parts };
                self.away_from_joints(close, &walks, diameter)
            }));
        }
        found
    }

    /// The vertex that two edges have in common.
    fn shared([one, other]: [&[usize; 2]; 2]) -> Option<usize> {
        one.iter().find(|end| other.contains(end)).copied()
    }

    /// Whether two edges can be close other than by their nature. Those between the same vertices, and folds, have checks of
    /// their own.
    fn counts(&self, edges: [usize; 2], diameter: f64) -> bool {
        let [ours, theirs] = edges.each_ref().map(|&edge| &self.ends[edge]);
        let Some(shared) = Self::shared([ours, theirs]) else { return true };
        let both = ours.iter().all(|end| theirs.contains(end));
        !both && self.around[shared].len() > 2 && self.end_inside(edges, shared, diameter).is_some()
    }

    /// Of two edges with a common vertex: where the shorter one ends, if that is inside of the other.
    fn end_inside(&self, edges: [usize; 2], shared: usize, diameter: f64) -> Option<Close> {
        let short = usize::from(self.lengths[edges[1]] < self.lengths[edges[0]]);
        let (edge, long) = (edges[short], edges[1 - short]);
        let end = usize::from(self.ends[edge][0] == shared);
        if self.lengths[edge] <= JOINED * diameter {
            return None;
        }
        // Most are behind the common vertex, or farther aside than half a diameter: that is seen with less. Twice its square leaves room
        // for what is rounded.
        let [from, to] = [self.pieces[edge][1 - end], self.pieces[edge][end]];
        let far = usize::from(self.ends[long][0] == shared);
        let along = (to - from).dot(&(self.pieces[long][far] - from)) / self.lengths[long];
        let aside = (to - from).norm_squared() - along * along;
        if along <= 0.0 || aside > diameter * diameter / 2.0 {
            return None;
        }
        let (distance, [_, part]) = between_pieces(&[self.pieces[edge][end]; 2], &self.pieces[long]);
        let mut parts = [part; 2];
        parts[short] = if end == 0 { 0.0 } else { 1.0 };
        (distance < diameter / 2.0).then_some(Close { edges, distance, parts })
    }

    /// How close two edges come once both are shortened by what a walk joins: by half of what it falls short.
    fn away_from_joints(&self, close: Close, walks: &[Walks; 2], diameter: f64) -> Option<Close> {
        let other = close.edges[1];
        if let Some(shared) = Self::shared(close.edges.each_ref().map(|&edge| &self.ends[edge])) {
            return self.end_inside(close.edges, shared, diameter);
        }
        let mut cut = [[0.0_f64; 2]; 2];
        for (mine, walks) in walks.iter().enumerate() {
            for (theirs, &vertex) in self.ends[other].iter().enumerate() {
                let short = (JOINED * diameter - walks.lengths[vertex]).max(0.0) / 2.0;
                cut[0][mine] = cut[0][mine].max(short);
                cut[1][theirs] = cut[1][theirs].max(short);
            }
        }
        if cut == [[0.0; 2]; 2] {
            return Some(close);
        }
        let mut ranges = [[0.0, 1.0]; 2];
        for (side, edge) in close.edges.into_iter().enumerate() {
            let length = self.lengths[edge];
            ranges[side] = [cut[side][0] / length, 1.0 - cut[side][1] / length];
            if ranges[side][0] > ranges[side][1] {
                return None;
            }
        }
        let rest = [0, 1].map(|side| {
            let [from, to] = self.pieces[close.edges[side]];
            ranges[side].map(|part| from + (to - from) * part)
        });
        let (distance, parts) = between_pieces(&rest[0], &rest[1]);
        let whole = |side: usize| {
            let [low, high] = ranges[side];
            low + (high - low) * parts[side]
        };
        (distance < diameter).then(|| Close { distance, parts: [whole(0), whole(1)], ..close })
    }
}

/// Shortest walks from a vertex, as far as they matter. Kept from one to the next: most of them are short.
struct Walks<'a> {
    layout: &'a Layout,
    /// The length of the shortest to each vertex; infinite where none is.
    lengths: Vec<f64>,
    reached: Vec<usize>,
    /// Lengths are not negative, so that their bits are in their order.
    open: BinaryHeap<Reverse<(u64, usize)>>,
}

impl<'a> Walks<'a> {
    fn of(layout: &'a Layout) -> Self {
        let lengths = vec![f64::INFINITY; layout.vertices.len()];
        Self { layout, lengths, reached: Vec::new(), open: BinaryHeap::new() }
    }

    /// Walks from a vertex that are shorter than `most`; false where they reach too many vertices.
    fn walk(&mut self, start: usize, most: f64) -> bool {
        for vertex in self.reached.drain(..) {
            self.lengths[vertex] = f64::INFINITY;
        }
        self.open.clear();
        self.reach(start, 0.0);
        while let Some(Reverse((bits, vertex))) = self.open.pop() {
            let walked = f64::from_bits(bits);
            if self.lengths[vertex] < walked {
                continue;
            }
            for &edge in &self.layout.around[vertex] {
                let length = walked + self.layout.lengths[edge];
                let [a, b] = self.layout.ends[edge];
                let next = if a == vertex { b } else { a };
                if length < most && length < self.lengths[next] {
                    self.reach(next, length);
                }
            }
            if self.reached.len() > MOST_VERTICES {
                return false;
            }
        }
        true
    }

    fn reach(&mut self, vertex: usize, length: f64) {
        if self.lengths[vertex].is_infinite() {
            self.reached.push(vertex);
        }
        self.lengths[vertex] = length;
        self.open.push(Reverse((length.to_bits(), vertex)));
    }
}
