//! Welding: vertices that a file wrote twice become one.

use std::collections::{BTreeMap, BTreeSet, HashMap};

use nalgebra::Point3;
use petgraph::unionfind::UnionFind;

use super::delta::{Delta, Draft};
use super::graph::{Edge, VertexId, Wireframe};
use crate::units::Length;

/// What a weld did; nothing is merged or dropped without being counted here.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct WeldReport {
    /// Vertices that are gone because they lay on another one.
    pub merged_vertices: usize,
    /// Edges that are gone because both their ends became the same vertex.
    pub collapsed_edges: usize,
    /// Edges that are gone because another one joins the same two vertices.
    pub duplicate_edges: usize,
    /// How far the farthest vertex was moved. A chain of close vertices can make this more than the
    /// tolerance.
    pub largest_move: Length,
}

impl WeldReport {
    /// Whether the weld changed nothing.
    #[must_use]
    pub fn is_clean(&self) -> bool {
        self.merged_vertices + self.collapsed_edges + self.duplicate_edges == 0
    }
}

impl Wireframe {
    /// Merges vertices that are within `tolerance` of each other into the one with the lowest id,
    /// and drops the edges that become points or repeat another one.
    ///
    /// Closeness is transitive: a chain of vertices, each within the tolerance of the next, becomes
    /// one vertex. The order is that of the ids, so the result is the same on every run.
    #[must_use]
    pub fn weld(&self, tolerance: Length) -> (Delta, WeldReport) {
        let mut draft = Draft::new(self);
        let mut report = WeldReport::default();
        let ids: Vec<VertexId> = self.vertices().map(|(id, _)| id).collect();
        let positions: Vec<Point3<f64>> = self.vertices().map(|(_, vertex)| vertex.position).collect();
        let survivor_of = clusters(&positions, tolerance.mm());
        let mut into = BTreeMap::new();
        for (k, &root) in survivor_of.iter().enumerate() {
            if root == k {
                continue;
            }
            let moved = Length::computed((positions[k] - positions[root]).norm());
            report.largest_move = report.largest_move.max(moved);
            report.merged_vertices += 1;
            into.insert(ids[k], ids[root]);
            // A support stays one when it is welded to a free vertex.
            if let (Some(gone), Some(kept)) = (self.vertex(ids[k]), draft.vertex(ids[root]))
                && gone.support
                && !kept.support
            {
                // The position is that of an existing vertex, which is one by construction.
                let _ = draft.set_vertex(ids[root], super::graph::Vertex { support: true, ..kept });
            }
        }
        let mut seen = BTreeSet::new();
        let target = |id: VertexId| into.get(&id).copied().unwrap_or(id);
        for (id, edge) in self.edges() {
            let welded = Edge { a: target(edge.a), b: target(edge.b) };
            if welded.a == welded.b {
                report.collapsed_edges += 1;
                draft.remove_edge(id);
            } else if !seen.insert(welded.ends()) {
                report.duplicate_edges += 1;
                draft.remove_edge(id);
            } else if welded != edge {
                draft.set_edge(id, welded);
            }
        }
        for &gone in into.keys() {
            draft.remove_vertex(gone);
        }
        (draft.finish(), report)
    }
}

/// For each point the lowest index of the points that it is chained to.
pub(crate) fn clusters(positions: &[Point3<f64>], tolerance: f64) -> Vec<usize> {
    let mut sets = UnionFind::<usize>::new(positions.len());
    // A cell is never smaller than what a coordinate of a kilometre can resolve.
    let cell = tolerance.max(1e-9);
    #[allow(clippy::cast_possible_truncation)] // ±1e6 mm over 1e-9 mm fits into 64 bits
    let key = |p: &Point3<f64>| [p.x, p.y, p.z].map(|c| (c / cell).floor() as i64);
    let mut cells: HashMap<[i64; 3], Vec<usize>> = HashMap::new();
    for (k, point) in positions.iter().enumerate() {
        let [x, y, z] = key(point);
        for (dx, dy, dz) in (0..27).map(|n| (n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1)) {
            for &other in cells.get(&[x + dx, y + dy, z + dz]).into_iter().flatten() {
                if (positions[other] - point).norm() <= tolerance {
                    sets.union(other, k);
                }
            }
        }
        cells.entry([x, y, z]).or_default().push(k);
    }
    let mut lowest: HashMap<usize, usize> = HashMap::new();
    (0..positions.len()).map(|k| *lowest.entry(sets.find(k)).or_insert(k)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::wireframe::Vertex;

    fn wireframe(points: &[[f64; 3]], edges: &[(usize, usize)]) -> Wireframe {
        let mut w = Wireframe::new();
        let ids: Vec<VertexId> =
            points.iter().map(|&p| w.add_vertex(Vertex::at(Point3::from(p))).unwrap()).collect();
        for &(a, b) in edges {
            w.add_edge(ids[a], ids[b]).unwrap();
        }
        w
    }

    #[test]
    fn a_square_written_as_four_loose_segments_becomes_a_loop() {
        let mut w = wireframe(
            &[
                [0., 0., 0.],
                [10., 0., 0.],
                [10., 0., 4e-4],
                [10., 10., 0.],
                [10., 10., 0.],
                [0., 10., 0.],
                [0., 10., 0.],
                [-3e-4, 0., 0.],
            ],
            &[(0, 1), (2, 3), (4, 5), (6, 7), (0, 7), (1, 3)],
        );
        let (delta, report) = w.weld(Length::from_mm(1e-3).unwrap());
        w.commit(&delta).unwrap();
        assert_eq!((w.vertex_count(), w.edge_count()), (4, 4));
        assert_eq!((report.merged_vertices, report.collapsed_edges, report.duplicate_edges), (4, 1, 1));
        assert!((report.largest_move.mm() - 4e-4).abs() < 1e-12);
        assert!(w.odd_vertices(&w.components()[0], &[]).is_empty());
    }

    #[test]
    fn a_chain_of_close_vertices_reports_how_far_it_moved() {
        let mut w = wireframe(&[[0., 0., 0.], [0.9, 0., 0.], [1.8, 0., 0.], [9., 0., 0.]], &[(2, 3)]);
        let (delta, report) = w.weld(Length::from_mm(1.0).unwrap());
        w.commit(&delta).unwrap();
        assert_eq!(w.vertex_count(), 2);
        assert!((report.largest_move.mm() - 1.8).abs() < 1e-12);
        assert_eq!(w.edges().next().map(|(_, edge)| edge), Some(Edge { a: VertexId(0), b: VertexId(3) }));
    }

    #[test]
    fn a_clean_wireframe_is_left_alone() {
        let w = wireframe(&[[0., 0., 0.], [1., 0., 0.]], &[(0, 1)]);
        let (delta, report) = w.weld(Length::from_mm(1e-3).unwrap());
        assert!(delta.is_empty() && report.is_clean());
    }
}
