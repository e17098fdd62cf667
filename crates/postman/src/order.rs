//! A graph with its vertices in another order, so that what is near in the graph is near in memory, too.

use crate::certificate::{Certificate, Join};
use crate::graph::{Graph, NONE, id};

/// A graph and its odd vertices, both in the order in which a search finds them that goes breadth first. Edges keep their numbers.
pub(crate) struct Ordered {
    pub graph: Graph,
    pub odd: Vec<u32>,
    /// Of each vertex its place in the order.
    place: Vec<u32>,
    /// Of each odd vertex its number in the graph that was given, and its place in the list.
    given: Vec<(u32, u32)>,
}

impl Ordered {
    /// The vertex instead, when one is listed twice or is not in the graph.
    pub fn new(graph: &Graph, odd: &[u32]) -> Result<Self, u32> {
        let mut listed = vec![NONE; graph.vertices()];
        for (k, &vertex) in odd.iter().enumerate() {
            match listed.get_mut(vertex as usize) {
                Some(listed) if *listed == NONE => *listed = id(k),
                _ => return Err(vertex),
            }
        }
        let order = breadth_first(graph);
        let mut place = vec![NONE; order.len()];
        let (mut given, mut moved) = (Vec::with_capacity(odd.len()), Vec::with_capacity(odd.len()));
        for (k, &vertex) in order.iter().enumerate() {
            place[vertex as usize] = id(k);
            if listed[vertex as usize] != NONE {
                given.push((vertex, listed[vertex as usize]));
                moved.push(id(k));
            }
        }
        Ok(Self { graph: graph.in_order(&order, &place), odd: moved, place, given })
    }

    /// The number of an odd vertex in the graph that was given.
    pub fn given(&self, odd: u32) -> u32 {
        self.given[odd as usize].0
    }

    /// A join, of the graph that was given.
    pub fn restore(&self, join: Join) -> Join {
        let Certificate { mut parents, mut widths, inside, depths } = join.certificate;
        let (own_parents, own_widths) = (parents.clone(), widths.clone());
        for (k, &(_, listed)) in self.given.iter().enumerate() {
            parents[listed as usize] = own_parents[k];
            widths[listed as usize] = own_widths[k];
        }
        let listed = |odd: u32| self.given.get(odd as usize).map_or(NONE, |&(_, listed)| listed);
        let certificate = Certificate {
            parents,
            widths,
            inside: self.place.iter().map(|&place| listed(inside[place as usize])).collect(),
            depths: self.place.iter().map(|&place| depths[place as usize]).collect(),
        };
        Join { certificate, ..join }
    }
}

/// All vertices, those of each part of the graph by how many edges they are away from its first.
fn breadth_first(graph: &Graph) -> Vec<u32> {
    let mut order = Vec::with_capacity(graph.vertices());
    let mut seen = vec![false; graph.vertices()];
    let mut next = 0;
    for first in 0..id(graph.vertices()) {
        if !std::mem::replace(&mut seen[first as usize], true) {
            order.push(first);
        }
        while next < order.len() {
            for arc in graph.at(order[next]) {
                if !std::mem::replace(&mut seen[arc.to as usize], true) {
                    order.push(arc.to);
                }
            }
            next += 1;
        }
    }
    order
}
