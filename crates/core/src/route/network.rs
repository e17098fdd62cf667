//! A component laid out for walking: vertices and edges by position in a list, in order of id.

use nalgebra::{Point3, Vector3};

use crate::wireframe::{Component, EdgeId, VertexId, Wireframe};

/// Lengths are compared in whole nanometres, so that sums do not depend on their order.
const NM_PER_MM: f64 = 1.0e6;

/// An edge between two positions in the list of vertices.
#[derive(Debug, Clone, Copy)]
pub(super) struct Link {
    pub id: EdgeId,
    pub a: usize,
    pub b: usize,
    pub length_nm: i64,
    /// Unit vector from `a` to `b`; zero for an edge without length.
    pub direction: Vector3<f64>,
}

/// A component as lists.
#[derive(Debug, Clone)]
pub(super) struct Network {
    pub vertices: Vec<VertexId>,
    pub links: Vec<Link>,
}

/// Where vertices are in a list. Ids are dense but for what was deleted, so that a table of them is the fastest.
enum Places<'a> {
    Table { first: u32, places: Vec<u32> },
    Search(&'a [VertexId]),
}

impl<'a> Places<'a> {
    /// Of a list in order of id.
    fn new(vertices: &'a [VertexId]) -> Self {
        let (Some(first), Some(last)) = (vertices.first(), vertices.last()) else {
            return Self::Search(vertices);
        };
        let span = (last.0 - first.0) as usize + 1;
        if span > 4 * vertices.len() {
            return Self::Search(vertices);
        }
        let mut places = vec![u32::MAX; span];
        for (place, vertex) in (0..).zip(vertices) {
            places[(vertex.0 - first.0) as usize] = place;
        }
        Self::Table { first: first.0, places }
    }

    fn of(&self, vertex: VertexId) -> Option<usize> {
        match self {
            Self::Table { first, places } => {
                let place = places.get(vertex.0.checked_sub(*first)? as usize)?;
                (*place != u32::MAX).then_some(*place as usize)
            }
            Self::Search(vertices) => vertices.binary_search(&vertex).ok(),
        }
    }
}

impl Network {
    pub fn new(wireframe: &Wireframe, component: &Component) -> Self {
        let position = |&id: &VertexId| wireframe.vertex(id).map(|vertex| (id, vertex.position));
        let (vertices, positions): (Vec<VertexId>, Vec<Point3<f64>>) =
            component.vertices.iter().filter_map(position).unzip();
        let places = Places::new(&vertices);
        let mut links = Vec::with_capacity(component.edges.len());
        for &id in &component.edges {
            let Some(edge) = wireframe.edge(id) else { continue };
            let (Some(a), Some(b)) = (places.of(edge.a), places.of(edge.b)) else { continue };
            let vector = positions[b] - positions[a];
            let length = vector.norm();
            let direction = if length > 0.0 { vector / length } else { Vector3::zeros() };
            #[allow(clippy::cast_possible_truncation)] // a coordinate is at most 1e6 mm
            let length_nm = (length * NM_PER_MM).round() as i64;
            links.push(Link { id, a, b, length_nm, direction });
        }
        Self { vertices, links }
    }

    /// The position of a vertex in the list.
    pub fn index(&self, vertex: VertexId) -> Option<usize> {
        self.vertices.binary_search(&vertex).ok()
    }

    /// The vertices with an odd number of ends, when the listed links count once more.
    pub fn odd(&self, doubled: &[usize]) -> Vec<usize> {
        let mut odd = vec![false; self.vertices.len()];
        for link in self.links.iter().chain(doubled.iter().map(|&k| &self.links[k])) {
            odd[link.a] ^= true;
            odd[link.b] ^= true;
        }
        (0..odd.len()).filter(|&vertex| odd[vertex]).collect()
    }
}
