//! Models for other programs: what they say is asked of readers that others wrote, and of geometry.

use std::f64::consts::FRAC_PI_2;

use nalgebra::{Point3, Vector3};
use proptest::prelude::*;
use wirebend_core::wireframe::{Vertex, Wireframe};
use wirebend_files::write::{Centreline, Tube, centreline, glb, obj, wireframe_obj};

use super::{import, mm};

const TUBE: f64 = 1.5;

/// A wire with two bends of 5 mm, 50 + 40 + 30 mm between its corners, away from every plane of symmetry.
fn bent() -> Centreline {
    let path = [[0., 0., 7.], [50., 0., 7.], [50., 40., 7.], [50., 40., 37.]].map(Point3::from);
    centreline(&path, mm(5.0), mm(0.05))
}

fn tube() -> Tube {
    Tube { radius: mm(TUBE), sides: 8 }
}

/// By hand: an octagon along straights and quarter turns.
fn volume_of_bent() -> f64 {
    let octagon = 2.0 * 2.0_f64.sqrt() * TUBE * TUBE;
    octagon * (120.0 - 4.0 * 5.0 + 2.0 * 5.0 * FRAC_PI_2)
}

/// What a surface encloses; positive where its faces look outwards.
fn volume(triangles: impl Iterator<Item = [Vector3<f64>; 3]>) -> f64 {
    triangles.map(|[a, b, c]| a.dot(&b.cross(&c)) / 6.0).sum()
}

#[test]
fn the_tube_is_closed() {
    let text = obj(&[bent()], Some(tube()));
    let tube = import("wire.obj", &text).unwrap().stencil.unwrap();
    // Euler's formula for a sphere, over the vertices that faces use.
    let used: std::collections::BTreeSet<u32> = tube.faces().iter().flatten().copied().collect();
    assert_eq!(used.len() + tube.faces().len(), tube.face_edges().len() + 2);
    let fans =
        tube.faces().iter().flat_map(|face| (1..face.len() - 1).map(|k| [face[0], face[k], face[k + 1]]));
    let found = volume(fans.map(|ids| ids.map(|id| tube.vertices()[id as usize].coords)));
    assert!((found / volume_of_bent() - 1.0).abs() < 0.01, "{found}");
}

/// Read by the format's reference library, which refuses what its specification does not allow.
#[test]
fn a_gltf_is_valid_in_metres_and_upright() {
    let bytes = glb(&[bent(), bent()], tube());
    let file = gltf::Gltf::from_slice(&bytes).unwrap();
    assert_eq!(file.scenes().next().unwrap().nodes().len(), 2);
    let binary = file.blob.clone().unwrap();
    for mesh in file.meshes() {
        let primitive = mesh.primitives().next().unwrap();
        let reader = primitive.reader(|_| Some(&binary));
        let points: Vec<Vector3<f64>> =
            reader.read_positions().unwrap().map(|p| Vector3::from(p.map(f64::from)) * 1000.0).collect();
        let corners: Vec<u32> = reader.read_indices().unwrap().into_u32().collect();
        let triangles =
            corners.chunks_exact(3).map(|ids| [ids[0], ids[1], ids[2]].map(|id| points[id as usize]));
        let found = volume(triangles);
        assert!((found / volume_of_bent() - 1.0).abs() < 0.01, "{found}");
        // It rises 30 mm along y from where it lies, and goes 40 mm away from who looks along -z.
        let bounds = primitive.bounding_box();
        let edges = [(bounds.min, -TUBE, 7.0 - TUBE, -40.0 - TUBE), (bounds.max, 50.0 + TUBE, 37.0, TUBE)];
        for (found, x, y, z) in edges {
            for (found, expected) in found.into_iter().zip([x, y, z]) {
                // A corner of the octagon may be where its side is, and the ends are cut square.
                let off = (f64::from(found) * 1000.0 - expected).abs();
                assert!(off < TUBE * 1.001, "{found} m instead of {expected} mm");
            }
        }
    }
    // And our own reader takes it for the surface of the same size.
    let back = import("wire.glb", &bytes).unwrap().stencil.unwrap();
    let height = |axis: usize| {
        let along = || back.vertices().iter().map(|p| p[axis]);
        along().fold(f64::MIN, f64::max) - along().fold(f64::MAX, f64::min)
    };
    assert!((height(2) - (30.0 + TUBE)).abs() < 0.2, "z is up again: {}", height(2));
}

#[test]
fn nothing_is_a_model_without_parts() {
    assert_eq!(obj(&[Centreline::default()], None), "# bent wire, mm\n");
    let empty = glb(&[Centreline::default()], tube());
    assert_eq!(gltf::Gltf::from_slice(&empty).unwrap().meshes().len(), 0);
    assert_eq!(wireframe_obj(&Wireframe::new()), "# wireframe, mm\n");
}

/// Positions far enough from one another that none are welded, and pairs of them.
fn any_wireframe() -> impl Strategy<Value = Wireframe> {
    let points = prop::collection::vec(prop::array::uniform3(-1e5..1e5_f64), 1..30);
    (points, prop::collection::vec((0_usize..30, 0_usize..30), 0..40)).prop_map(|(points, pairs)| {
        let mut wireframe = Wireframe::new();
        let ids: Vec<_> =
            points.iter().map(|&p| wireframe.add_vertex(Vertex::at(Point3::from(p))).unwrap()).collect();
        for (a, b) in pairs {
            let (a, b) = (ids[a % ids.len()], ids[b % ids.len()]);
            let joined = wireframe.edges().any(|(_, edge)| edge.ends() == (a.min(b), a.max(b)));
            if a != b && !joined {
                wireframe.add_edge(a, b).unwrap();
            }
        }
        wireframe
    })
}

proptest! {
    /// Every vertex with all its digits, every edge once; our reader makes the same wireframe of it, and the library that
    /// reads OBJ finds the same numbers.
    #[test]
    fn a_wireframe_comes_back_as_it_was(wireframe in any_wireframe()) {
        let text = wireframe_obj(&wireframe);
        let positions: Vec<Point3<f64>> = wireframe.vertices().map(|(_, vertex)| vertex.position).collect();
        let number = |id| wireframe.vertices().position(|(other, _)| other == id).unwrap();
        let edges: Vec<[usize; 2]> = wireframe.edges().map(|(_, edge)| [number(edge.a), number(edge.b)]).collect();
        let (models, _) = tobj::load_obj_buf(
            &mut text.as_bytes(), &tobj::LoadOptions::default(), |_| Err(tobj::LoadError::OpenFileFailed),
        ).unwrap();
        let lines: usize = models.iter().map(|model| model.mesh.indices.len() / 2).sum();
        prop_assert!(edges.is_empty() || lines >= edges.len());
        if !edges.is_empty() {
            let back = import("wires.obj", &text).unwrap().wireframe;
            let found: Vec<Point3<f64>> = back.vertices().map(|(_, vertex)| vertex.position).collect();
            let used = |k: usize| edges.iter().flatten().any(|&end| end == k);
            let expected: Vec<Point3<f64>> =
                positions.iter().enumerate().filter(|&(k, _)| used(k)).map(|(_, &p)| p).collect();
            prop_assert_eq!(back.edge_count(), edges.len());
            for position in &expected {
                prop_assert!(found.contains(position), "{} is lost in {}", position, text);
            }
        }
    }
}
