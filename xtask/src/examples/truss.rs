//! Tetrahedral trusses (Bhundiya & Cordero 2023): two layers of a triangular lattice joined by diagonals.
//!
//! A lattice point has integer coordinates (a, b, c) along three directions 120° apart. In the top layer a + b + c = 1,
//! so that the three points nearest to the axis form a triangle; N rings are the points with all of them in [-N, N + 1].
//! The bottom layer is the top one turned by 180° about the axis, a depth H below.

use super::{Example, Point};

/// Integer lattice coordinates in the top layer's sense.
type Lattice = [i32; 3];

const DEPTH_MM: f64 = 50.0;

pub(super) fn all() -> Vec<Example> {
    (0..=3).map(|rings| truss(rings, DEPTH_MM, equal_strut(DEPTH_MM))).collect()
}

/// The strut in mm that makes the diagonals as long as the edges of the faces: regular tetrahedra of height `depth`.
fn equal_strut(depth_mm: f64) -> f64 {
    depth_mm * 1.5_f64.sqrt()
}

/// Truss with `rings` around the middle triangle; `face_strut_mm` is the edge of the two faces.
fn truss(rings: i32, depth_mm: f64, face_strut_mm: f64) -> Example {
    let layer = layer(rings);
    let count = layer.len();
    let top = layer.iter().map(|&at| position(at, face_strut_mm, 1.0, depth_mm));
    let bottom = layer.iter().map(|&at| position(at, face_strut_mm, -1.0, 0.0));
    let mut chains = Vec::new();
    for (i, &a) in layer.iter().enumerate() {
        for (j, &b) in layer.iter().enumerate() {
            if i < j && neighbours(a, b) {
                chains.push(vec![i, j]);
                chains.push(vec![count + i, count + j]);
            }
            if joined(a, b) {
                chains.push(vec![i, count + j]);
            }
        }
    }
    chains.sort();
    let about = [
        format!("Tetrahedral truss with {rings} rings, depth {depth_mm} mm: {} vertices,", 2 * count),
        format!("{} struts of {face_strut_mm:.3} mm (depth times the root of 3/2).", chains.len()),
    ];
    let points = top.chain(bottom).collect();
    Example { file: format!("truss-{rings}.obj"), about: about.to_vec(), points, chains }
}

fn layer(rings: i32) -> Vec<Lattice> {
    let range = -rings..=rings + 1;
    let pairs = range.clone().flat_map(|a| range.clone().map(move |b| [a, b, 1 - a - b]));
    pairs.filter(|[_, _, c]| range.contains(c)).collect()
}

/// `side` is 1 in the top layer and -1 in the bottom one.
fn position(at: Lattice, face_strut_mm: f64, side: f64, z_mm: f64) -> Point {
    let [a, b, c] = at.map(f64::from);
    let x = face_strut_mm / 2.0 * (c - b);
    let y = face_strut_mm / 3.0_f64.sqrt() * (a - f64::midpoint(b, c));
    [side * x, side * y, z_mm]
}

/// Two points of one layer are one strut apart.
fn neighbours(a: Lattice, b: Lattice) -> bool {
    let apart = [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
    apart != [0; 3] && apart.iter().all(|step| step.abs() <= 1)
}

/// A diagonal joins `top` and `bottom`: their difference, top plus bottom for the turned layer, is one lattice step.
fn joined(top: Lattice, bottom: Lattice) -> bool {
    (0..3).all(|k| (0..=1).contains(&(top[k] + bottom[k])))
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
