//! Tetrahedral trusses (Bhundiya & Cordero 2023): two layers of a triangular lattice joined by diagonals.

use wirebend_core::units::Length;
use wirebend_core::wireframe::tetrahedral_truss;

use super::{Example, Point};

const DEPTH_MM: f64 = 50.0;

pub(super) fn all() -> Vec<Example> {
    (0..=3).map(|rings| truss(rings, DEPTH_MM, equal_strut(DEPTH_MM))).collect()
}

/// The strut in mm that makes the diagonals as long as the edges of the faces: regular tetrahedra of height `depth`.
fn equal_strut(depth_mm: f64) -> f64 {
    depth_mm * 1.5_f64.sqrt()
}

/// Truss with `rings` around the middle triangle; `face_strut_mm` is the edge of the two faces.
#[allow(clippy::expect_used)] // the examples' own parameters
fn truss(rings: u32, depth_mm: f64, face_strut_mm: f64) -> Example {
    let mm = |value| Length::from_mm(value).expect("a length");
    let truss = tetrahedral_truss(rings, mm(face_strut_mm), mm(depth_mm)).expect("a truss");
    let chains: Vec<Vec<usize>> =
        truss.edges().map(|(_, edge)| vec![edge.a.0 as usize, edge.b.0 as usize]).collect();
    let about = [
        format!(
            "Tetrahedral truss with {rings} rings, depth {depth_mm} mm: {} vertices,",
            truss.vertex_count()
        ),
        format!("{} struts of {face_strut_mm:.3} mm (depth times the root of 3/2).", chains.len()),
    ];
    let points: Vec<Point> = truss.vertices().map(|(_, vertex)| vertex.position.coords.into()).collect();
    Example { file: format!("truss-{rings}.obj"), about: about.to_vec(), points, chains }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use serde_json::Value;

    use super::super::measure::{edge_lengths, edges, length, minus, odd_vertices};
    use super::*;

    #[test]
    fn counts_are_the_published_ones() {
        // 6 (N + 1)^2 nodes; struts and odd nodes as published for N rings. One strut of any of them is H·sqrt(3/2).
        let cases = [(0, 6, 12, 0), (1, 24, 78, 24), (2, 54, 198, 48), (3, 96, 372, 84)];
        for (rings, nodes, struts, odd) in cases {
            let truss = truss(rings, 50.0, equal_strut(50.0));
            assert_eq!(truss.points.len(), nodes);
            assert_eq!(edges(&truss).len(), struts);
            assert_eq!(odd_vertices(&truss), odd, "odd vertices with {rings} rings");
            assert!(edge_lengths(&truss).iter().all(|mm| (mm - 61.237_243_57).abs() < 1e-6), "struts differ");
        }
    }

    /// The truss that was really made has the same faces (61.237 mm) on a depth of 53.033 mm instead of 50 mm.
    #[test]
    fn one_ring_is_the_truss_that_was_made() {
        let published: Value =
            serde_json::from_str(include_str!("../../testdata/tetra_prototype_nodes_path.json")).unwrap();
        let depth = 53.033_009;
        let ours = truss(1, depth, equal_strut(50.0));
        let number_in_ours = |node: &Value| {
            let at: Point = [0, 1, 2].map(|k| node[k].as_f64().unwrap());
            ours.points.iter().position(|&point| length(minus(point, at)) < 1e-5).unwrap()
        };
        let numbers: Vec<usize> = published["nodes"].as_array().unwrap().iter().map(number_in_ours).collect();
        assert_eq!(
            numbers.iter().collect::<BTreeSet<_>>().len(),
            ours.points.len(),
            "nodes are not one to one"
        );
        let step = |value: &Value| numbers[usize::try_from(value.as_u64().unwrap()).unwrap()];
        let path: Vec<usize> = published["path_0based"].as_array().unwrap().iter().map(step).collect();
        let travelled: BTreeSet<_> = path.windows(2).map(|p| (p[0].min(p[1]), p[0].max(p[1]))).collect();
        assert_eq!(travelled, edges(&ours).into_iter().collect());
    }
}
