//! Connected components: each one that has edges is a wire of its own.

use petgraph::visit::NodeIndexable;

use super::graph::{EdgeId, VertexId, Wireframe};

/// Vertices that edges join, and those edges, both in order of id.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Component {
    /// The vertices.
    pub vertices: Vec<VertexId>,
    /// The edges; none when the only vertex is isolated.
    pub edges: Vec<EdgeId>,
}

impl Wireframe {
    /// The connected components, ordered by their lowest vertex id. An isolated vertex is a
    /// component without edges.
    #[must_use]
    pub fn components(&self) -> Vec<Component> {
        let mut component_of = vec![None; self.graph.node_bound()];
        let mut components: Vec<Component> = Vec::new();
        for &start in self.vertices.values() {
            if component_of[start.index()].is_some() {
                continue;
            }
            component_of[start.index()] = Some(components.len());
            let mut reached = vec![start];
            let mut next = 0;
            while let Some(&vertex) = reached.get(next) {
                next += 1;
                for other in self.graph.neighbors(vertex) {
                    if component_of[other.index()].is_none() {
                        component_of[other.index()] = Some(components.len());
                        reached.push(other);
                    }
                }
            }
            let ids = reached.iter().filter_map(|&vertex| self.graph.node_weight(vertex));
            let mut vertices: Vec<VertexId> = ids.map(|&(id, _)| id).collect();
            vertices.sort_unstable();
            components.push(Component { vertices, edges: Vec::new() });
        }
        for (&id, &index) in &self.edges {
            let ends = self.graph.edge_endpoints(index);
            if let Some(component) = ends.and_then(|(a, _)| component_of[a.index()]) {
                components[component].edges.push(id);
            }
        }
        components
    }

    /// The vertices of a component at which an odd number of edge ends meet, in order of id. The
    /// edges in `doubled` count twice; a loop has both its ends at its vertex.
    #[must_use]
    pub fn odd_vertices(&self, component: &Component, doubled: &[EdgeId]) -> Vec<VertexId> {
        let ends = component.edges.iter().chain(doubled).filter_map(|&id| self.edge(id));
        let mut ends: Vec<VertexId> = ends.flat_map(|edge| [edge.a, edge.b]).collect();
        ends.sort_unstable();
        let meeting = ends.chunk_by(PartialEq::eq);
        meeting.filter(|ends| ends.len() % 2 == 1).map(|ends| ends[0]).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::wireframe::Vertex;
    use nalgebra::Point3;

    #[test]
    fn two_wires_and_a_stray_vertex() {
        let mut w = Wireframe::new();
        let v: Vec<VertexId> =
            (0..5).map(|k| w.add_vertex(Vertex::at(Point3::new(f64::from(k), 0.0, 0.0))).unwrap()).collect();
        let first = w.add_edge(v[0], v[3]).unwrap();
        let second = w.add_edge(v[4], v[1]).unwrap();
        let components = w.components();
        assert_eq!(
            components,
            [
                Component { vertices: vec![v[0], v[3]], edges: vec![first] },
                Component { vertices: vec![v[1], v[4]], edges: vec![second] },
                Component { vertices: vec![v[2]], edges: vec![] },
            ]
        );
        assert_eq!(w.odd_vertices(&components[0], &[]), [v[0], v[3]]);
        assert_eq!(w.odd_vertices(&components[0], &[first]), []);
    }
}
