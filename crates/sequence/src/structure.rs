//! The frame as a sequence sees it: struts between nodes, and the parts that are placed at once.

use nalgebra::Point3;
use wirebend_core::units::Length;
use wirebend_core::wireframe::{EdgeId, VertexId, Wireframe};

/// A strut between two nodes, by their places in [`Structure::nodes`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Strut {
    /// The edge of the design that it is.
    pub edge: EdgeId,
    /// Its ends, as the edge was drawn.
    pub ends: [usize; 2],
}

/// A point where struts meet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Node {
    /// The vertex of the design that it is.
    pub vertex: VertexId,
    /// Where it is, mm.
    pub at: Point3<f64>,
    /// Whether the ground holds it.
    pub support: bool,
    /// Which of its displacements along x, y, z and rotations about them the ground holds.
    pub fixed: [bool; 6],
    /// What joins the struts there, g. It stands with the first of them.
    pub joint_g: f64,
}

/// Why a wireframe is no frame that can be built strut by strut.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum StructureError {
    /// There is no edge.
    #[error("the design has no edges")]
    NoEdges,
    /// Nothing is held.
    #[error("no vertex with an edge is a support")]
    NoSupport,
    /// An edge has no direction.
    #[error("edge {edge} has no length")]
    ZeroLength {
        /// The edge.
        edge: EdgeId,
    },
    /// Edges that no walk joins to a support.
    #[error("{} edges, with edge {}, hang on no support", .edges.len(), .edges.first().map_or(0, |edge| edge.0))]
    Floating {
        /// All of them, in order of id.
        edges: Vec<EdgeId>,
    },
}

/// Struts that hang together and on the ground.
#[derive(Debug, Clone, PartialEq)]
pub struct Structure {
    nodes: Vec<Node>,
    struts: Vec<Strut>,
    around: Vec<Vec<usize>>,
}

impl Structure {
    /// The frame that a wireframe draws. Vertices without edges are left out.
    ///
    /// # Errors
    /// [`StructureError`] where it cannot be built one strut after the other, whatever the order.
    pub fn new(wireframe: &Wireframe) -> Result<Self, StructureError> {
        let mut nodes = Vec::new();
        let mut place = std::collections::BTreeMap::new();
        for (vertex, there) in wireframe.vertices() {
            if !wireframe.incident(vertex).is_empty() {
                place.insert(vertex, nodes.len());
                nodes.push(Node {
                    vertex,
                    at: there.position,
                    support: there.support,
                    fixed: there.fixed(),
                    joint_g: there.joint.map_or(0.0, |joint| joint.mass_g),
                });
            }
        }
        let mut struts = Vec::new();
        let mut around = vec![Vec::new(); nodes.len()];
        for (edge, there) in wireframe.edges() {
            let ends = [place[&there.a], place[&there.b]];
            if nodes[ends[0]].at == nodes[ends[1]].at {
                return Err(StructureError::ZeroLength { edge });
            }
            for node in ends {
                around[node].push(struts.len());
            }
            struts.push(Strut { edge, ends });
        }
        let structure = Self { nodes, struts, around };
        if structure.struts.is_empty() {
            return Err(StructureError::NoEdges);
        }
        if !structure.nodes.iter().any(|node| node.support) {
            return Err(StructureError::NoSupport);
        }
        let far = structure.distances_from_ground();
        let floating = structure.struts.iter().filter(|strut| far[strut.ends[0]].is_infinite());
        let edges: Vec<EdgeId> = floating.map(|strut| strut.edge).collect();
        if edges.is_empty() { Ok(structure) } else { Err(StructureError::Floating { edges }) }
    }

    /// Its nodes, in order of their vertices' ids.
    #[must_use]
    pub fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    /// Its struts, in order of their edges' ids.
    #[must_use]
    pub fn struts(&self) -> &[Strut] {
        &self.struts
    }

    /// The struts at a node, rising.
    #[must_use]
    pub fn around(&self, node: usize) -> &[usize] {
        &self.around[node]
    }

    /// The strut that an edge is.
    #[must_use]
    pub fn strut_of(&self, edge: EdgeId) -> Option<usize> {
        self.struts.binary_search_by_key(&edge, |strut| strut.edge).ok()
    }

    /// The ends of a strut, mm.
    #[must_use]
    pub fn ends(&self, strut: usize) -> [&Point3<f64>; 2] {
        self.struts[strut].ends.map(|node| &self.nodes[node].at)
    }

    /// How long a strut is.
    #[must_use]
    pub fn length(&self, strut: usize) -> Length {
        let [a, b] = self.ends(strut);
        Length::computed((b - a).norm())
    }

    /// Whether the ground holds an end of a strut.
    #[must_use]
    pub fn is_grounded(&self, strut: usize) -> bool {
        self.struts[strut].ends.iter().any(|&node| self.nodes[node].support)
    }

    /// Whether two struts share a node.
    #[must_use]
    pub fn share_a_node(&self, one: usize, other: usize) -> bool {
        self.struts[one].ends.iter().any(|node| self.struts[other].ends.contains(node))
    }

    /// The highest z of its nodes, mm.
    #[must_use]
    pub fn top(&self) -> f64 {
        self.nodes.iter().map(|node| node.at.z).fold(f64::NEG_INFINITY, f64::max)
    }

    /// How far each node is from the nearest support along struts, mm; infinite where nothing leads to one.
    #[must_use]
    pub fn distances_from_ground(&self) -> Vec<f64> {
        let mut far = vec![f64::INFINITY; self.nodes.len()];
        let mut open = std::collections::BTreeSet::new();
        for node in (0..self.nodes.len()).filter(|&node| self.nodes[node].support) {
            far[node] = 0.0;
            open.insert((0_u64, node));
        }
        // Of numbers from 0 the bits are in order as the numbers are.
        while let Some((bits, node)) = open.pop_first() {
            for &strut in &self.around[node] {
                let ends = self.struts[strut].ends;
                let next = if ends[0] == node { ends[1] } else { ends[0] };
                let through = f64::from_bits(bits) + self.length(strut).mm();
                if through < far[next] {
                    far[next] = through;
                    open.insert((through.to_bits(), next));
                }
            }
        }
        far
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use wirebend_core::wireframe::Vertex;

    fn wireframe(points: &[[f64; 3]], supports: &[usize], edges: &[[u32; 2]]) -> Wireframe {
        let mut made = Wireframe::new();
        for (k, point) in points.iter().enumerate() {
            let position = Point3::from(*point);
            made.add_vertex(Vertex { support: supports.contains(&k), ..Vertex::at(position) }).unwrap();
        }
        for [a, b] in edges {
            made.add_edge(VertexId(*a), VertexId(*b)).unwrap();
        }
        made
    }

    const POINTS: [[f64; 3]; 5] =
        [[0.0; 3], [0.0, 0.0, 10.0], [10.0, 0.0, 10.0], [50.0, 0.0, 0.0], [60.0, 0.0, 0.0]];

    #[test]
    fn what_cannot_be_built_strut_by_strut_is_refused_with_its_edges() {
        let of =
            |supports: &[usize], edges: &[[u32; 2]]| Structure::new(&wireframe(&POINTS, supports, edges));
        assert_eq!(of(&[0], &[]), Err(StructureError::NoEdges));
        assert_eq!(of(&[4], &[[0, 1]]), Err(StructureError::NoSupport), "a support that no strut touches");
        assert_eq!(of(&[0], &[[0, 1], [3, 4]]), Err(StructureError::Floating { edges: vec![EdgeId(1)] }));
        assert_eq!(of(&[0], &[[0, 1], [1, 1]]), Err(StructureError::ZeroLength { edge: EdgeId(1) }));
        assert!(of(&[0, 4], &[[0, 1], [3, 4]]).is_ok(), "two parts that both stand");
    }

    #[test]
    fn nodes_are_as_far_from_the_ground_as_the_shortest_way_along_struts() {
        let structure =
            Structure::new(&wireframe(&POINTS, &[0, 3], &[[0, 1], [1, 2], [0, 2], [3, 4]])).unwrap();
        let wanted = [0.0, 10.0, 200.0_f64.sqrt(), 0.0, 10.0];
        for (far, wanted) in structure.distances_from_ground().iter().zip(wanted) {
            assert!((far - wanted).abs() < 1e-12);
        }
        assert!(structure.is_grounded(0) && !structure.is_grounded(1));
        assert!(structure.share_a_node(0, 1) && !structure.share_a_node(1, 3));
    }
}
