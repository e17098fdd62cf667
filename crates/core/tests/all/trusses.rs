//! Tetrahedral trusses: as many vertices and struts as were published, as stiff in length errors, and the one that was really made.

use nalgebra::Point3;
use wirebend_core::units::Length;
use wirebend_core::wireframe::{TrussError, VertexId, Wireframe, regular_depth, tetrahedral_truss};

fn mm(value: f64) -> Length {
    Length::from_mm(value).unwrap()
}

fn regular(rings: u32, strut_mm: f64) -> Wireframe {
    tetrahedral_truss(rings, mm(strut_mm), regular_depth(mm(strut_mm))).unwrap()
}

/// Counts of Bhundiya and Cordero's trusses. The root of redundant struts over struts is what a strut of random length does to the
/// forces of a pin-jointed truss: 0.3922 0.4606 0.4919 0.5099 0.5216, found by solving the frames themselves.
#[test]
fn counts_are_the_published_ones() {
    let cases = [
        (0, 6, 12, 0.0),
        (1, 24, 78, 0.3922),
        (2, 54, 198, 0.4606),
        (3, 96, 372, 0.4919),
        (4, 150, 600, 0.5099),
        (5, 216, 882, 0.5216),
    ];
    for (rings, nodes, struts, force) in cases {
        let truss = regular(rings, 100.0);
        assert_eq!((truss.vertex_count(), truss.edge_count()), (nodes, struts), "{rings} rings");
        let redundant = f64::from(u32::try_from(struts + 6 - 3 * nodes).unwrap());
        let ratio = (redundant / f64::from(u32::try_from(struts).unwrap())).sqrt();
        assert!((ratio - force).abs() < 5e-5, "{rings} rings: {ratio}");
        assert_eq!(truss.components().len(), 1);
    }
}

/// At the regular depth every strut is as long as every other; at any depth nothing else joins the vertices.
#[test]
fn struts_of_a_regular_truss_are_alike() {
    for rings in 0..5 {
        let truss = regular(rings, 70.0);
        for (id, _) in truss.edges() {
            assert!((truss.edge_length(id).mm() - 70.0).abs() < 1e-9);
        }
        let vertices: Vec<Point3<f64>> = truss.vertices().map(|(_, vertex)| vertex.position).collect();
        let close = vertices.iter().enumerate().map(|(k, a)| {
            let others = &vertices[k + 1..];
            others.iter().filter(|b| (*b - a).norm() < 70.0 * 1.001).count()
        });
        assert_eq!(close.sum::<usize>(), truss.edge_count(), "all pairs a strut apart are joined");
    }
}

/// The widest place is 2N + 1 struts across, the middle is on the z axis, and half a turn about a level axis changes nothing but the
/// layers.
#[test]
fn a_truss_is_as_wide_as_its_rings_say() {
    let truss = tetrahedral_truss(3, mm(100.0), mm(40.0)).unwrap();
    let at: Vec<Point3<f64>> = truss.vertices().map(|(_, vertex)| vertex.position).collect();
    let sum = at.iter().fold(Point3::origin(), |sum, point| sum + point.coords);
    assert!(sum.coords.xy().norm() < 1e-9, "{sum}");
    let widest = at.iter().map(|point| point.x).fold(f64::NEG_INFINITY, f64::max);
    assert!((2.0 * widest - 700.0).abs() < 1e-9, "{widest}");
    let heights: Vec<f64> = at.iter().map(|point| point.z).collect();
    assert!(heights.iter().take(48).all(|z| (z - 40.0).abs() < 1e-12), "the top comes first");
    assert!(heights.iter().skip(48).all(|z| *z == 0.0));
    // A vertex inside has nine struts: six in its face, three to the other.
    let most = (0..96).map(|id| truss.incident(VertexId(id)).len()).max();
    assert_eq!(most, Some(9));
}

#[test]
fn what_is_no_truss_is_refused() {
    let error = |rings, strut, depth| tetrahedral_truss(rings, mm(strut), mm(depth)).unwrap_err();
    assert_eq!(error(101, 1.0, 1.0), TrussError::Rings(101));
    assert_eq!(error(1, 0.0, 1.0), TrussError::Strut(Length::ZERO));
    assert_eq!(error(1, -1.0, 1.0).to_string(), "struts of -1.0 mm; they are longer than 0");
    assert_eq!(error(1, 1.0, -2.0).to_string(), "a depth of -2.0 mm; it is more than 0");
    assert!(matches!(error(100, 1e6, 1.0), TrussError::Wireframe(_)));
    assert_eq!(regular(100, 1.0).edge_count(), 27 * 10_000 + 39 * 100 + 12);
}
