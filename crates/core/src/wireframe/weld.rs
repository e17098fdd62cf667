//! Welding: vertices that a file wrote twice become one.

use std::collections::{BTreeMap, HashMap};

use super::delta::{Delta, Draft};
use super::graph::{Edge, VertexId, Wireframe};
use super::welder::Welder;
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
    /// How far the farthest vertex was moved: never more than the tolerance.
    pub max_move: Length,
}

impl WeldReport {
    /// Whether the weld changed nothing.
    #[must_use]
    pub fn is_clean(&self) -> bool {
        self.merged_vertices + self.collapsed_edges + self.duplicate_edges == 0
    }
}

impl Wireframe {
    /// Merges each vertex into the one with the lowest id that is within `tolerance` of it and stays,
    /// and drops the edges that become points or repeat another one.
    ///
    /// A chain of vertices, each within the tolerance of the next, is not drawn together. The order
    /// is that of the ids, so the result is the same on every run.
    #[must_use]
    pub fn weld(&self, tolerance: Length) -> (Delta, WeldReport) {
        let mut draft = Draft::new(self);
        let mut report = WeldReport::default();
        let mut welder = Welder::new(tolerance);
        let mut into = BTreeMap::new();
        for (id, vertex) in self.vertices() {
            let kept = VertexId(welder.put(id.0, vertex.position));
            let Some(onto) = draft.vertex(kept).filter(|_| kept != id) else { continue };
            let moved = Length::computed((vertex.position - onto.position).norm());
            report.max_move = report.max_move.max(moved);
            report.merged_vertices += 1;
            into.insert(id, kept);
            // A support stays one when it is welded to a free vertex, and a joint is kept. The position is that of an
            // existing vertex, which is one by construction.
            let marked = onto.with_marks_of(vertex);
            if marked != onto {
                let _ = draft.set_vertex(kept, marked);
            }
        }
        let mut seen = HashMap::new();
        let target = |id: VertexId| into.get(&id).copied().unwrap_or(id);
        for (id, edge) in self.edges() {
            let welded = Edge { a: target(edge.a), b: target(edge.b), ..edge };
            if welded.a == welded.b {
                report.collapsed_edges += 1;
                draft.remove_edge(id);
            } else if let Some(&kept) = seen.get(&welded.ends()) {
                report.duplicate_edges += 1;
                draft.remove_edge(id);
                draft.keep_mark(kept, welded);
            } else {
                seen.insert(welded.ends(), id);
                if welded != edge {
                    draft.set_edge(id, welded);
                }
            }
        }
        for &gone in into.keys() {
            draft.remove_vertex(gone);
        }
        (draft.finish(), report)
    }
}

#[cfg(test)]
mod tests {
    use super::super::Vertex;
    use super::*;
    use nalgebra::Point3;

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
        assert!((report.max_move.mm() - 4e-4).abs() < 1e-12);
        assert!(w.odd_vertices(&w.components()[0], &[]).is_empty());
    }

    #[test]
    fn nothing_moves_farther_than_the_tolerance() {
        let mut w = wireframe(&[[0., 0., 0.], [0.9, 0., 0.], [1.8, 0., 0.], [9., 0., 0.]], &[(1, 3), (2, 3)]);
        let (delta, report) = w.weld(Length::from_mm(1.0).unwrap());
        w.commit(&delta).unwrap();
        assert_eq!(w.vertex_count(), 3, "a chain is not drawn together");
        assert!((report.max_move.mm() - 0.9).abs() < 1e-12);
        assert_eq!(w.edges().next().map(|(_, edge)| edge), Some(Edge::between(VertexId(0), VertexId(3))));
    }

    #[test]
    fn a_large_unwelded_model_takes_no_longer_than_it_is_large() {
        // Loose segments, as a mesh without shared vertices has them; comparing all of them with all
        // would take minutes.
        let points: Vec<[f64; 3]> = (0..40_000).map(|k| [f64::from((k + 1) / 2), 0.0, 0.0]).collect();
        let edges: Vec<(usize, usize)> = (0..20_000).map(|k| (2 * k, 2 * k + 1)).collect();
        let mut w = wireframe(&points, &edges);
        let (delta, report) = w.weld(Length::from_mm(0.1).unwrap());
        w.commit(&delta).unwrap();
        assert_eq!((report.merged_vertices, w.vertex_count(), w.edge_count()), (19_999, 20_001, 20_000));
    }

    #[test]
    fn a_clean_wireframe_is_left_alone() {
        let w = wireframe(&[[0., 0., 0.], [1., 0., 0.]], &[(0, 1)]);
        let (delta, report) = w.weld(Length::from_mm(1e-3).unwrap());
        assert!(delta.is_empty() && report.is_clean());
    }
}
