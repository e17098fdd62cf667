//! Minimum-weight perfect matching of a sparse graph by Edmonds' primal-dual method: trees of all free vertices grow at the
//! same time, and a heap knows when the next edge gets tight or the next dual gets to 0.
//!
//! Time is the dual that the trees have grown by. Weights are multiples of 4 and the duals of free vertices even, so that all
//! times are whole numbers.

mod events;
mod grow;
mod laminar;
mod shrink;

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use crate::graph::{NONE, id};
pub(crate) use laminar::Laminar;

/// What its dual does.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Label {
    /// In no tree: it stays.
    Free,
    /// At an even distance from the root of its tree: it grows.
    Even,
    /// At an odd distance: it shrinks.
    Odd,
}

/// A vertex, or a blossom: an odd cycle of such nodes.
#[derive(Debug)]
struct Node {
    /// The blossom that it is in; [`NONE`] when it is outermost.
    parent: u32,
    label: Label,
    /// As of the moment that its set says.
    dual: i64,
    /// Of its vertices.
    set: u32,
    size: u32,
    /// The arc to the node that it is matched with, when it is outermost; [`NONE`] when it is free.
    mate: u32,
    /// Of an odd node: the arc to the even node above it in its tree.
    up: u32,
    tree: u32,
    /// The cycle of a blossom, each with the arc to the next; none of a vertex, or of a node that is not in use.
    cycle: Vec<(u32, u32)>,
    mark: u32,
}

/// The vertices of an outermost node. When nodes join, the largest set takes in the others; the set of an inner node waits for
/// the moment when it is outermost again.
#[derive(Debug, Clone, Copy)]
struct Set {
    node: u32,
    /// Added to the radius of each of its vertices, as of the moment `since`.
    offset: i64,
    since: i64,
    /// 1, 0 or -1, by the label of the node.
    speed: i64,
}

/// What grows from a free node.
#[derive(Debug, Default)]
struct Tree {
    /// Nodes that are in it, and some that were.
    nodes: Vec<u32>,
    /// Vertices that have come into an even node of it.
    woken: Vec<u32>,
}

/// A matching in progress. An arc is an edge seen from one of its ends: twice the number of the edge, and 1 from its second.
pub(crate) struct Matching {
    /// Vertices first, then blossoms.
    nodes: Vec<Node>,
    vertices: usize,
    /// From here on, vertices are stand-ins for ends of wires.
    real: usize,
    /// Before this, edges are ways: one through a vertex is one between its neighbours, so that no dual has to be negative.
    /// From here on, duals may be.
    on_ways: usize,
    sets: Vec<Set>,
    set_of: Vec<u32>,
    /// Of a vertex, without the offset of its set: the sum of its dual and of those of all blossoms around it.
    radius: Vec<i64>,
    /// Of a vertex: edges that are shorter are all known.
    reach: Vec<i64>,
    edges: Vec<([u32; 2], i64)>,
    /// Arcs by vertex, of the edges that were there first.
    first: Vec<u32>,
    arcs: Vec<u32>,
    /// Of edges that came later: a list for each vertex.
    later: Vec<u32>,
    after: Vec<u32>,
    early: usize,
    trees: Vec<Tree>,
    growing: usize,
    now: i64,
    /// When a vertex looks at its edges again.
    due: Vec<i64>,
    /// Whether it has looked at them since it is in an even node.
    has_looked: Vec<bool>,
    queue: BinaryHeap<Reverse<(i64, u32)>>,
    unused: Vec<u32>,
    round: u32,
}

/// Why trees have ceased to grow.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Stop {
    /// All that take part are matched.
    Matched,
    /// No edge is left that could get tight.
    Stuck,
    /// A vertex grows to where further edges of it could get tight: [`Matching::widen`] is told of them.
    AtReach(u32),
}

impl Matching {
    /// Of vertices of which the first `real` are such, with edges of weights that are multiples of 4. Vertices beyond have no
    /// part in it before [`Self::bring_in`].
    pub fn new(vertices: usize, mut reach: Vec<i64>, edges: Vec<([u32; 2], i64)>) -> Self {
        let real = reach.len();
        reach.resize(vertices, i64::MAX);
        let mut first = vec![0_u32; vertices + 2];
        for &([a, b], _) in &edges {
            first[a as usize + 2] += 1;
            first[b as usize + 2] += 1;
        }
        for k in 2..first.len() {
            first[k] += first[k - 1];
        }
        let mut arcs = vec![0; 2 * edges.len()];
        for (edge, &(ends, _)) in edges.iter().enumerate() {
            for (side, &end) in ends.iter().enumerate() {
                let at = &mut first[end as usize + 1];
                arcs[*at as usize] = id(2 * edge + side);
                *at += 1;
            }
        }
        first.pop();
        let vertex = |v: usize| Node {
            parent: NONE,
            label: Label::Free,
            dual: 0,
            set: id(v),
            size: 1,
            mate: NONE,
            up: NONE,
            tree: NONE,
            cycle: Vec::new(),
            mark: 0,
        };
        let set = |v: usize| Set { node: id(v), offset: 0, since: 0, speed: 0 };
        let mut matching = Self {
            nodes: (0..vertices).map(vertex).collect(),
            vertices,
            real,
            on_ways: real,
            sets: (0..vertices).map(set).collect(),
            set_of: (0..vertices).map(id).collect(),
            radius: vec![0; vertices],
            reach,
            early: edges.len(),
            edges,
            first,
            arcs,
            later: vec![NONE; vertices],
            after: Vec::new(),
            trees: Vec::new(),
            growing: 0,
            now: 0,
            due: vec![i64::MAX; vertices],
            has_looked: vec![true; vertices],
            queue: BinaryHeap::new(),
            unused: Vec::new(),
            round: 0,
        };
        matching.begin_greedily();
        matching
    }

    /// The same where edges are no ways. `edges`: of each vertex all that are shorter than its `reach`; weights are multiples of 4.
    pub fn of_any(reach: Vec<i64>, edges: Vec<([u32; 2], i64)>) -> Self {
        Self { on_ways: 0, ..Self::new(reach.len(), reach, edges) }
    }

    /// Duals as large as the edges let them be, one vertex after the other, and the tight edges that are there then.
    fn begin_greedily(&mut self) {
        for v in 0..self.real {
            let least = self.row(v).iter().map(|&arc| self.edges[arc as usize / 2].1).min();
            self.radius[v] = least.unwrap_or(0).min(self.reach[v]) / 2;
        }
        for v in 0..self.real {
            let Some(least) = self.row(v).iter().map(|&arc| self.slack(arc)).min() else { continue };
            self.radius[v] += least.min(self.reach[v] / 2 - self.radius[v]);
            let tight =
                |arc: &&u32| self.slack(**arc) == 0 && self.nodes[self.to(**arc) as usize].mate == NONE;
            if self.nodes[v].mate == NONE
                && let Some(&arc) = self.row(v).iter().find(tight)
            {
                self.join(arc);
            }
        }
        for v in 0..self.real {
            self.nodes[v].dual = self.radius[v];
        }
    }

    /// Arcs of edges that were there first.
    fn row(&self, vertex: usize) -> &[u32] {
        &self.arcs[self.first[vertex] as usize..self.first[vertex + 1] as usize]
    }

    /// The arc after one that came later, or the first such of a vertex.
    fn next_later(&self, vertex: u32, arc: u32) -> u32 {
        if arc == NONE { self.later[vertex as usize] } else { self.after[arc as usize - 2 * self.early] }
    }

    pub fn from(&self, arc: u32) -> u32 {
        self.edges[arc as usize / 2].0[arc as usize % 2]
    }

    pub fn to(&self, arc: u32) -> u32 {
        self.edges[arc as usize / 2].0[1 - arc as usize % 2]
    }

    pub fn weight(&self, arc: u32) -> i64 {
        self.edges[arc as usize / 2].1
    }

    /// By how much an edge between outermost nodes is longer than the duals at its ends.
    fn slack(&self, arc: u32) -> i64 {
        self.weight(arc) - self.radius(self.from(arc)) - self.radius(self.to(arc))
    }

    /// Another edge; gives its arc from `a`.
    pub fn add_edge(&mut self, a: u32, b: u32, weight: i64) -> u32 {
        let arc = id(2 * self.edges.len());
        self.edges.push(([a, b], weight));
        for (end, arc) in [(a, arc), (b, arc + 1)] {
            self.after.push(std::mem::replace(&mut self.later[end as usize], arc));
        }
        arc
    }

    /// Of each vertex: edges that are shorter are all known.
    pub fn reach(&self) -> &[i64] {
        &self.reach
    }

    /// More edges of a vertex that has grown to half its reach, which is further now.
    pub fn widen(&mut self, vertex: u32, reach: i64, edges: &[(u32, i64)]) {
        self.reach[vertex as usize] = reach;
        for &(other, weight) in edges {
            self.add_edge(vertex, other, weight);
        }
        self.schedule(vertex, self.now);
    }

    /// The outermost node around a vertex.
    fn top(&self, vertex: u32) -> u32 {
        self.sets[self.set_of[vertex as usize] as usize].node
    }

    /// The sum of the duals of a vertex and of all blossoms around it, now.
    pub fn radius(&self, vertex: u32) -> i64 {
        let set = &self.sets[self.set_of[vertex as usize] as usize];
        self.radius[vertex as usize] + set.offset + set.speed * (self.now - set.since)
    }

    fn node(&self, node: u32) -> &Node {
        &self.nodes[node as usize]
    }

    fn node_mut(&mut self, node: u32) -> &mut Node {
        &mut self.nodes[node as usize]
    }

    /// The dual of an outermost node, now.
    fn dual(&self, node: u32) -> i64 {
        let set = &self.sets[self.node(node).set as usize];
        self.node(node).dual + set.speed * (self.now - set.since)
    }

    /// Gives an outermost node another label; its dual goes on from where it is.
    fn relabel(&mut self, node: u32, label: Label) {
        let at = &mut self.nodes[node as usize];
        let set = &mut self.sets[at.set as usize];
        let change = set.speed * (self.now - set.since);
        at.dual += change;
        at.label = label;
        *set = Set {
            node,
            offset: set.offset + change,
            since: self.now,
            speed: match label {
                Label::Free => 0,
                Label::Even => 1,
                Label::Odd => -1,
            },
        };
    }

    /// Matches the outermost nodes at the ends of an arc.
    fn join(&mut self, arc: u32) {
        for arc in [arc, arc ^ 1] {
            let node = self.top(self.from(arc));
            self.node_mut(node).mate = arc;
        }
    }

    /// Appends the vertices of a node.
    fn vertices_of(&self, node: u32, found: &mut Vec<u32>) {
        let mut inside = vec![node];
        while let Some(node) = inside.pop() {
            if (node as usize) < self.vertices {
                found.push(node);
            } else {
                inside.extend(self.node(node).cycle.iter().rev().map(|&(member, _)| member));
            }
        }
    }

    fn is_outermost(&self, node: u32) -> bool {
        self.node(node).parent == NONE
    }

    /// Which of a blossom's cycle has the vertex.
    fn member_with(&self, blossom: u32, vertex: u32) -> usize {
        let mut at = vertex;
        while self.node(at).parent != blossom {
            at = self.node(at).parent;
        }
        self.place(blossom, at)
    }

    /// Where in a blossom's cycle a member is.
    fn place(&self, blossom: u32, member: u32) -> usize {
        self.node(blossom).cycle.iter().position(|&(other, _)| other == member).unwrap_or_default()
    }

    /// Lets stand-ins take part, which any real vertex can be matched with at no cost. All others are matched.
    pub fn bring_in(&mut self, count: usize, before: usize) {
        let widest = (0..id(self.real)).map(|v| self.radius(v)).max().unwrap_or(0);
        for stand_in in self.real + before..self.real + before + count {
            let v = id(stand_in);
            let dual = -(widest + widest % 2).max(0);
            self.node_mut(v).dual = dual;
            self.radius[stand_in] = dual;
            for real in 0..id(self.real) {
                self.add_edge(v, real, 0);
            }
        }
    }

    /// The arc by which each of the first `vertices` is matched.
    pub fn mates(&self, vertices: usize) -> Vec<u32> {
        let mut mates = vec![NONE; vertices];
        let outermost = (0..id(self.nodes.len())).filter(|&n| self.is_outermost(n) && self.is_used(n));
        let mut left: Vec<(u32, u32)> =
            outermost.map(|n| (n, self.node(n).mate)).filter(|&(_, mate)| mate != NONE).collect();
        while let Some((node, mate)) = left.pop() {
            let mut at = self.from(mate);
            mates[at as usize] = mate;
            while at != node {
                let blossom = self.node(at).parent;
                let pairs = self.pairs(blossom, self.place(blossom, at));
                left.extend(pairs.flat_map(|(a, arc, b)| [(a, arc), (b, arc ^ 1)]));
                at = blossom;
            }
        }
        mates
    }

    /// A vertex, or a blossom that there is.
    fn is_used(&self, node: u32) -> bool {
        (node as usize) < self.vertices || !self.node(node).cycle.is_empty()
    }

    /// How the cycle of a blossom is matched when one of it is matched outside.
    fn pairs(&self, blossom: u32, base: usize) -> impl Iterator<Item = (u32, u32, u32)> {
        let cycle = &self.node(blossom).cycle;
        let at = move |k: usize| cycle[(base + k) % cycle.len()];
        (1..cycle.len()).step_by(2).map(move |k| (at(k).0, at(k).1, at(k + 1).0))
    }
}
