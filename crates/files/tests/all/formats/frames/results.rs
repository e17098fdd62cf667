//! What is written of frames: it is read back as it was, and other programs find what their formats promise.

use std::collections::BTreeMap;

use nalgebra::{Point3, Vector3};
use proptest::prelude::*;
use wirebend_core::wireframe::{Edge, EdgeId, Vertex, VertexId, Wireframe};
use wirebend_files::read::frame::{
    FrameFile, FrameMaterial, FrameMember, FrameSection, LineLoad, LoadCase, NodalLoad, SequenceFile,
    SequenceStep, StrutKind, read_loads, read_sequence,
};
use wirebend_files::read::{Imported, ReadOptions, read};
use wirebend_files::write::frame::{
    BuiltMember, ClosedResult, ClosedStrut, DeformedStrut, FrameResult, ResultMember, ResultNode,
    assembly_instances, closed_vtk, conmech_frame, conmech_loads, deformed_glb, framefab_sequence,
    members_csv, nodes_csv, vtk,
};

use crate::formats::{data, mm};

/// A strut of 100 mm along x, whose free end goes down by 2 mm and turns.
fn cantilever() -> FrameResult {
    let node = |id, x, z, turn| ResultNode {
        vertex: VertexId(id),
        position: Point3::new(x, 0.0, 0.0),
        displacement: Vector3::new(0.0, 0.0, z),
        rotation: Vector3::new(0.0, turn, 0.0),
        support: id == 4,
    };
    FrameResult {
        title: "cantilever\nin two lines".into(),
        nodes: vec![node(4, 0.0, 0.0, 0.0), node(7, 100.0, -2.0, 0.03)],
        members: vec![ResultMember {
            edge: EdgeId(9),
            ends: [0, 1],
            axial_n: -0.5,
            moment_n_mm: 12.0,
            torque_n_mm: 0.0,
            von_mises_mpa: Some(1e-7),
            utilisation: Some(0.25),
            buckling_ratio: 0.125,
            step: Some(1),
        }],
    }
}

#[test]
fn a_vtk_file_has_the_sections_that_its_format_asks_for() {
    let expected = "# vtk DataFile Version 3.0\ncantileverin two lines\nASCII\nDATASET UNSTRUCTURED_GRID\n\
        POINTS 2 double\n0 0 0\n100 0 0\nCELLS 1 3\n2 0 1\nCELL_TYPES 1\n3\n\
        POINT_DATA 2\nVECTORS displacement_mm double\n0 0 0\n0 0 -2\n\
        SCALARS vertex int 1\nLOOKUP_TABLE default\n4\n7\n\
        SCALARS support int 1\nLOOKUP_TABLE default\n1\n0\n\
        CELL_DATA 1\nSCALARS edge int 1\nLOOKUP_TABLE default\n9\n\
        SCALARS axial_n double 1\nLOOKUP_TABLE default\n-0.5\n\
        SCALARS moment_n_mm double 1\nLOOKUP_TABLE default\n12\n\
        SCALARS torque_n_mm double 1\nLOOKUP_TABLE default\n0\n\
        SCALARS von_mises_mpa double 1\nLOOKUP_TABLE default\n0.0000001\n\
        SCALARS utilisation double 1\nLOOKUP_TABLE default\n0.25\n\
        SCALARS buckling_ratio double 1\nLOOKUP_TABLE default\n0.125\n\
        SCALARS step int 1\nLOOKUP_TABLE default\n1\n";
    assert_eq!(vtk(&cantilever()), expected);
    let mut unknown = cantilever();
    unknown.members[0].utilisation = None;
    unknown.members[0].step = None;
    let text = vtk(&unknown);
    assert!(!text.contains("utilisation") && !text.contains("step"), "{text}");
    unknown.members[0].von_mises_mpa = None;
    assert!(!vtk(&unknown).contains("von_mises"), "a stress that is not known is no zero");
    assert!(vtk(&FrameResult::default()).starts_with("# vtk DataFile Version 3.0\nframe\nASCII\n"));
}

/// A strut that is walked along twice has a line for each time.
#[test]
fn a_vtk_file_of_closed_joints_has_each_strut_of_the_wire() {
    let strut =
        |axial_n, ends| ClosedStrut { edge: EdgeId(9), wire: 2, ends, axial_n, von_mises_rms_mpa: 0.5 };
    let closed = ClosedResult {
        title: "closed".into(),
        nodes: cantilever().nodes,
        struts: vec![strut(-3.0, [0, 1]), strut(4.0, [1, 0])],
    };
    let expected = "CELLS 2 6\n2 0 1\n2 1 0\nCELL_TYPES 2\n3\n3\nPOINT_DATA 2\nVECTORS displacement_mm double\n0 0 0\n0 0 -2\n";
    let text = closed_vtk(&closed);
    assert!(text.contains(expected), "{text}");
    let figures = "CELL_DATA 2\nSCALARS edge int 1\nLOOKUP_TABLE default\n9\n9\n\
        SCALARS wire int 1\nLOOKUP_TABLE default\n2\n2\n\
        SCALARS axial_n double 1\nLOOKUP_TABLE default\n-3\n4\n\
        SCALARS von_mises_rms_mpa double 1\nLOOKUP_TABLE default\n0.5\n0.5\n";
    assert!(text.ends_with(figures), "{text}");
}

#[test]
fn tables_have_a_row_for_each_node_and_each_strut() {
    let frame = cantilever();
    assert_eq!(
        nodes_csv(&frame),
        "vertex,x_mm,y_mm,z_mm,ux_mm,uy_mm,uz_mm,rx_rad,ry_rad,rz_rad,support\n\
         4,0,0,0,0,0,0,0,0,0,1\n7,100,0,0,0,0,-2,0,0.03,0,0\n"
    );
    let header = "edge,vertex_a,vertex_b,length_mm,axial_n,moment_n_mm,torque_n_mm,von_mises_mpa,utilisation,buckling_ratio,step\n";
    assert_eq!(members_csv(&frame), format!("{header}9,4,7,100,-0.5,12,0,0.0000001,0.25,0.125,1\n"));
    let mut unknown = frame;
    unknown.members[0].utilisation = None;
    unknown.members[0].step = None;
    assert_eq!(members_csv(&unknown), format!("{header}9,4,7,100,-0.5,12,0,0.0000001,,0.125,\n"));
    unknown.members[0].von_mises_mpa = None;
    assert_eq!(members_csv(&unknown), format!("{header}9,4,7,100,-0.5,12,0,,,0.125,\n"));
}

/// Rings of corners stand around the points of a strut where it has moved to, each as far from it as the strut is thick.
#[test]
fn the_deformed_shape_is_where_its_points_move_to() {
    let at: Vec<Point3<f64>> = [0.0, 50.0, 100.0].map(|x| Point3::new(x, 0.0, 0.0)).to_vec();
    let moved = vec![Vector3::zeros(), Vector3::new(0.0, 0.25, -0.625), Vector3::new(0.5, 0.0, -2.0)];
    let struts = [DeformedStrut { edge: EdgeId(9), radius: mm(0.75), at, moved }];
    for scale in [1.0, 10.0] {
        let file = deformed_glb(&struts, scale);
        assert!(String::from_utf8_lossy(&file).contains("\"edge 9\""), "a strut is found by its edge");
        let model = read(&file, "frame.glb", None, &ReadOptions::default()).unwrap();
        let surface = model.stencil.unwrap();
        let near = |point: Point3<f64>| {
            surface.vertices().iter().filter(|corner| ((*corner - point).norm() - 0.75).abs() < 1e-4).count()
        };
        for (at, moved) in struts[0].at.iter().zip(&struts[0].moved) {
            assert_eq!(near(at + moved * scale), 12, "{at} {scale}");
        }
    }
}

/// A frame of which every material and section is used.
fn any_frame() -> impl Strategy<Value = (Wireframe, FrameFile)> {
    let points = prop::collection::vec(prop::array::uniform3(-1e3..1e3_f64), 2..12);
    let figure = || 1e-3..1e3_f64;
    let section = (figure(), figure(), figure(), figure())
        .prop_map(|(area_mm2, j_mm4, iy_mm4, iz_mm4)| FrameSection { area_mm2, j_mm4, iy_mm4, iz_mm4 });
    let material = ("[A-Z][a-z]{0,6}", figure(), figure(), figure(), prop::option::of(figure())).prop_map(
        |(name, e, g, density_kg_per_m3, yield_strength_mpa)| FrameMaterial {
            name,
            youngs_modulus_mpa: e,
            shear_modulus_mpa: g,
            density_kg_per_m3,
            yield_strength_mpa,
        },
    );
    let held = prop::collection::vec(prop::array::uniform6(any::<bool>()), 12);
    let layers = prop::collection::vec(prop::option::of(0..9_i64), 12);
    (points, section, material, held, layers).prop_map(|(points, section, material, held, layers)| {
        let mut wireframe = Wireframe::new();
        let mut frame =
            FrameFile { sections: vec![section], materials: vec![material], ..FrameFile::default() };
        for ((id, at), held) in (0..).map(VertexId).zip(&points).zip(held) {
            let support = held.contains(&true);
            // Apart from all others: files weld what lies together.
            let position = Point3::from(*at) + Vector3::x() * 3e3 * f64::from(id.0);
            wireframe.insert_vertex(id, Vertex { support, ..Vertex::at(position) }).unwrap();
            frame.nodes.insert(i64::from(id.0), id);
            if support {
                frame.supports.insert(id, held);
            }
        }
        let count = u32::try_from(points.len()).unwrap();
        for ((id, k), layer) in (0..).map(EdgeId).zip(1..count).zip(layers) {
            wireframe.insert_edge(id, Edge::between(VertexId(k - 1), VertexId(k))).unwrap();
            let tag = format!("e{id}");
            frame.members.insert(id, FrameMember { section: Some(0), material: Some(0), tag, layer });
        }
        (wireframe, frame)
    })
}

/// conmech would find a node at which nothing ends free to move, and numbers of nodes have no gaps.
#[test]
fn a_vertex_without_struts_is_no_node_of_conmech() {
    let mut wireframe = Wireframe::new();
    for (id, x) in [(2, 0.0), (3, 50.0), (7, 100.0)] {
        let vertex = Vertex { support: true, ..Vertex::at(Point3::new(x, 0.0, 0.0)) };
        wireframe.insert_vertex(VertexId(id), vertex).unwrap();
    }
    wireframe.insert_edge(EdgeId(4), Edge::between(VertexId(2), VertexId(7))).unwrap();
    let pinned = [true, true, true, false, false, false];
    let frame = FrameFile { supports: [(VertexId(7), pinned)].into(), ..FrameFile::default() };
    let read = back(&conmech_frame(&wireframe, &frame, "gap"));
    let found: Vec<(VertexId, f64, bool)> =
        read.wireframe.vertices().map(|(id, vertex)| (id, vertex.position.x, vertex.support)).collect();
    assert_eq!(found, [(VertexId(0), 0.0, false), (VertexId(1), 100.0, true)]);
    assert_eq!(read.frame.unwrap().supports, [(VertexId(1), pinned)].into());
    let nodal = vec![NodalLoad { vertex: VertexId(7), force_n: [0.0, 0.0, -2.0], moment_n_mm: [0.0; 3] }];
    let text = conmech_loads(&wireframe, &[LoadCase { nodal, ..LoadCase::default() }]);
    let loads = read_loads(text.as_bytes(), "loads.json", &read.wireframe, None).unwrap();
    assert_eq!(loads[0].nodal[0].vertex, VertexId(1));
}

fn back(text: &str) -> Imported {
    read(text.as_bytes(), "frame.json", None, &ReadOptions::default())
        .unwrap_or_else(|error| panic!("{error}\n{text}"))
}

fn same_figures(found: &FrameFile, expected: &FrameFile) -> Result<(), TestCaseError> {
    let near = |a: f64, b: f64| (a - b).abs() <= 1e-12 * b.abs();
    let figures = |frame: &FrameFile| {
        let (section, material) = (frame.sections[0], &frame.materials[0]);
        let (e, g) = (material.youngs_modulus_mpa, material.shear_modulus_mpa);
        let yields = material.yield_strength_mpa.unwrap_or(-1.0);
        [
            section.area_mm2,
            section.j_mm4,
            section.iy_mm4,
            section.iz_mm4,
            e,
            g,
            material.density_kg_per_m3,
            yields,
        ]
    };
    for (a, b) in figures(found).into_iter().zip(figures(expected)) {
        prop_assert!(near(a, b), "{} {}", a, b);
    }
    prop_assert_eq!(&found.materials[0].name, &expected.materials[0].name);
    prop_assert_eq!(&found.supports, &expected.supports);
    prop_assert_eq!(&found.nodes, &expected.nodes);
    Ok(())
}

fn same_places(found: &Wireframe, expected: &Wireframe) -> Result<(), TestCaseError> {
    prop_assert_eq!(found.vertex_count(), expected.vertex_count());
    for ((_, a), (_, b)) in found.vertices().zip(expected.vertices()) {
        prop_assert!((a.position - b.position).norm() < 1e-9 && a.support == b.support);
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn a_conmech_frame_comes_back((wireframe, frame) in any_frame()) {
        let read = back(&conmech_frame(&wireframe, &frame, "any"));
        same_places(&read.wireframe, &wireframe)?;
        prop_assert!(read.wireframe.edges().eq(wireframe.edges()));
        let found = read.frame.unwrap();
        same_figures(&found, &frame)?;
        prop_assert_eq!(&found.members, &frame.members);
    }

    #[test]
    fn loads_come_back(
        (wireframe, frame) in any_frame(),
        force_n in prop::array::uniform3(-1e3..1e3_f64),
        gravity in prop::option::of(prop::array::uniform3(-2.0..2.0_f64)),
    ) {
        let nodal = vec![NodalLoad { vertex: VertexId(1), force_n, moment_n_mm: force_n.map(|part| 2.0 * part) }];
        let line = vec![LineLoad { edge: EdgeId(0), n_per_mm: force_n }];
        let cases = vec![LoadCase { name: "wind".into(), nodal, line, gravity }];
        let text = conmech_loads(&wireframe, &cases);
        let read = read_loads(text.as_bytes(), "loads.json", &wireframe, Some(&frame)).unwrap();
        prop_assert_eq!(read.len(), 1);
        prop_assert_eq!(&read[0].name, "wind");
        prop_assert_eq!(&read[0].line, &cases[0].line);
        prop_assert_eq!(read[0].gravity, gravity);
        for (a, b) in read[0].nodal[0].force_n.iter().zip(force_n) {
            prop_assert!((a - b).abs() <= 1e-12 * b.abs());
        }
        prop_assert_eq!(read[0].nodal[0].vertex, VertexId(1));
    }

    #[test]
    fn an_assembly_comes_back_in_the_order_of_building((wireframe, frame) in any_frame(), seed in any::<u64>()) {
        // Some order of some of the edges; layers rise with it.
        let count = u32::try_from(wireframe.edge_count()).unwrap();
        let mut order: Vec<u32> = (0..count).collect();
        order.rotate_left(usize::try_from(seed % u64::from(count)).unwrap());
        let built: Vec<BuiltMember> = (0..).zip(&order)
            .map(|(place, id)| BuiltMember { edge: EdgeId(*id), layer: place / 2 })
            .take(order.len() - order.len() / 3)
            .collect();
        let (material, section) = (frame.materials.first(), frame.sections.first());
        let text = assembly_instances(&wireframe, &built, &frame.supports, material, section);
        let read = back(&text);
        same_places(&read.wireframe, &wireframe)?;
        let found = read.frame.unwrap();
        same_figures(&found, &frame)?;
        let ends: BTreeMap<u32, Edge> = wireframe.edges().map(|(id, edge)| (id.0, edge)).collect();
        for (place, member) in (0..).zip(&built) {
            prop_assert_eq!(read.wireframe.edge(EdgeId(place)), Some(ends[&member.edge.0]));
            prop_assert_eq!(found.members[&EdgeId(place)].layer, Some(member.layer));
        }
        prop_assert_eq!(read.wireframe.edge_count(), wireframe.edge_count());
        let layered = found.members.values().filter(|member| member.layer.is_some()).count();
        prop_assert_eq!(layered, built.len());
    }

    #[test]
    fn a_sequence_comes_back(
        points in prop::collection::vec(prop::array::uniform3(-1e3..1e3_f64), 2..20),
        centre in prop::option::of(prop::array::uniform3(-1e3..1e3_f64)),
    ) {
        let kinds = [StrutKind::Ground, StrutKind::Create, StrutKind::Connect];
        let step = |(k, pair): (usize, &[[f64; 3]])| SequenceStep {
            start: Point3::from(pair[0]),
            end: Point3::from(pair[1]),
            kind: kinds[k % 3],
            directions: vec![Vector3::z(), Vector3::new(0.6, 0.0, -0.8)][..k % 3].to_vec(),
        };
        let steps = points.windows(2).enumerate().map(step).collect();
        let sequence = SequenceFile { base_centre: centre.map(Point3::from), steps };
        let text = framefab_sequence(&sequence);
        prop_assert_eq!(read_sequence(text.as_bytes(), "s.json").unwrap(), sequence);
    }
}

/// The published sequence, written and read again.
#[test]
fn the_published_sequence_comes_back() {
    let published = read_sequence(&data("framefab/bunny_result.json").0, "bunny.json").unwrap();
    let again = read_sequence(framefab_sequence(&published).as_bytes(), "again.json").unwrap();
    assert_eq!(again.steps.len(), published.steps.len());
    for (a, b) in again.steps.iter().zip(&published.steps) {
        assert_eq!((a.start, a.end, a.kind), (b.start, b.end, b.kind));
        assert!(a.directions.iter().zip(&b.directions).all(|(a, b)| (a - b).norm() < 1e-15));
    }
}
