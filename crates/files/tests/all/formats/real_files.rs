//! What others published is read as they count it.

use std::collections::BTreeMap;

use nalgebra::{Matrix3, Point3, Vector3};
use serde_json::Value;
use wirebend_core::bend::{Frame, Step, program_of_path, replay};
use wirebend_core::units::{Angle, Length};
use wirebend_core::wireframe::{VertexId, Wireframe};
use wirebend_files::read::{Format, LengthUnit, ReadError, ReadOptions, read};

use super::{data, import_data, mm, notes};

fn face_edges() -> ReadOptions {
    ReadOptions { face_edges: true, ..ReadOptions::default() }
}

fn counts(wireframe: &Wireframe) -> (usize, usize, usize) {
    let supports = wireframe.vertices().filter(|(_, vertex)| vertex.support).count();
    (wireframe.vertex_count(), wireframe.edge_count(), supports)
}

#[test]
fn the_bunny_is_the_published_wireframe() {
    let bunny = import_data("bend-forming/BunnyPolygonScaled_v2.obj", &face_edges());
    assert_eq!(counts(&bunny.wireframe), (57, 165, 0));
    // 57 - 165 + 110 = 2: a closed surface, so no edge is missing and none is a diagonal.
    assert_eq!(bunny.stencil.as_ref().unwrap().faces().len(), 110);
    let second = bunny.wireframe.vertex(VertexId(1)).unwrap().position;
    let expected = Point3::new(-17.541_111_374_063_977, -95.547_468_272_715_97, -75.779_840_362_337_6);
    assert_eq!(second, expected, "ids follow the order of the file, numbers are exact");
    let expected = [
        "1 comment ignored",
        "2 object, group or material names ignored",
        "222 normals ignored",
        "units not given: taken as mm",
    ];
    assert_eq!(notes(&bunny.notes), expected);
}

#[test]
fn without_the_option_a_model_is_a_stencil_only() {
    let bunny = import_data("bend-forming/BunnyPolygonScaled_v2.obj", &ReadOptions::default());
    assert_eq!((counts(&bunny.wireframe), bunny.stencil.unwrap().vertices().len()), ((0, 0, 0), 57));
}

#[test]
fn the_teapot_keeps_its_polygons() {
    let teapot = import_data("bend-forming/Teapot_123Faces_Final.obj", &face_edges());
    // Euler: V - E + F of a surface with holes; an edge of one diagonal more would break the sum
    // that the faces give: each edge has one or two faces.
    let corners: usize = teapot.stencil.as_ref().unwrap().faces().iter().map(Vec::len).sum();
    let (vertices, edges, _) = counts(&teapot.wireframe);
    assert_eq!(teapot.stencil.as_ref().unwrap().faces().len(), 123);
    assert_eq!(vertices, 67);
    assert!(2 * edges >= corners && edges < corners, "{edges} edges, {corners} corners");
}

#[test]
fn frames_have_their_struts_and_supports() {
    let frame = import_data("assembly-instances/simple_frame.json", &ReadOptions::default());
    assert_eq!(
        (frame.format, frame.wireframe.vertex_count(), frame.wireframe.edge_count()),
        (Format::Assembly, 12, 19)
    );
    let four = import_data("assembly-instances/four-frame.json", &ReadOptions::default());
    let value: Value = serde_json::from_slice(&data("assembly-instances/four-frame.json").0).unwrap();
    let grounded =
        value["node_list"].as_array().unwrap().iter().filter(|node| node["is_grounded"] == 1).count();
    assert!(grounded > 0);
    assert_eq!(counts(&four.wireframe), (5, 4, grounded));
    assert_eq!(four.wireframe.vertex(VertexId(0)).unwrap().position, Point3::new(0.0, -20.0, -10.0));
    let shape = import_data("assembly-instances/C_shape.json", &ReadOptions::default());
    assert_eq!((shape.wireframe.vertex_count(), shape.wireframe.edge_count()), (77, 199));
}

#[test]
fn a_frame_in_metres_is_scaled_by_its_own_unit() {
    let (bytes, name) = data("assembly-instances/four-frame.json");
    let text = String::from_utf8(bytes).unwrap().replace("\"millimeter\"", "\"meter\"");
    let frame = read(text.as_bytes(), &name, None, &ReadOptions::default()).unwrap();
    assert_eq!(frame.wireframe.vertex(VertexId(0)).unwrap().position, Point3::new(0.0, -20_000.0, -10_000.0));
    let options = ReadOptions { units: Some(LengthUnit::Millimetre), scale: 0.5, ..ReadOptions::default() };
    let frame = read(text.as_bytes(), &name, None, &options).unwrap();
    assert_eq!(frame.wireframe.vertex(VertexId(0)).unwrap().position, Point3::new(0.0, -10.0, -5.0));
    assert!(notes(&frame.notes).contains(&"the file names another unit; yours was used".to_owned()));
}

#[test]
fn the_framefab_bunny_stands_on_its_pillars() {
    let bunny = import_data("framefab/bunny0507_.pwf", &ReadOptions::default());
    // 167 struts and 12 pillars; the 6 ceiling marks name struts that are there already.
    assert_eq!(counts(&bunny.wireframe), (91, 179, 12));
    let ground = (79..91).map(|k| bunny.wireframe.vertex(VertexId(k)).unwrap());
    assert!(ground.into_iter().all(|vertex| vertex.support));
    // What is written on its `c` lines, counted from 1 there.
    let lines = String::from_utf8(data("framefab/bunny0507_.pwf").0).unwrap();
    let ends = |line: &str| -> [u32; 2] {
        let mut ends: Vec<u32> =
            line.split_whitespace().map(|word| word.parse::<u32>().unwrap() - 1).collect();
        ends.sort_unstable();
        [ends[0], ends[1]]
    };
    let mut marked: Vec<[u32; 2]> =
        lines.lines().filter_map(|line| line.strip_prefix("c ")).map(ends).collect();
    let ceiling = bunny.wireframe.edges().filter(|(_, edge)| edge.ceiling);
    let mut found: Vec<[u32; 2]> = ceiling.map(|(_, edge)| edge.ends()).map(|(a, b)| [a.0, b.0]).collect();
    marked.sort_unstable();
    found.sort_unstable();
    assert_eq!((found.len(), found), (6, marked));
}

/// Its authors feed straight past vertices: all of the published model comes back, and nothing beside.
#[test]
fn the_script_of_the_bunny_makes_the_bunny() {
    let model = import_data("bend-forming/BunnyPolygonScaled_v2.obj", &face_edges());
    let options = ReadOptions { weld: mm(1.0), ..ReadOptions::default() };
    let script = import_data("bend-forming/AccuracyTest_BunnyPath.txt", &options);
    assert_eq!(counts(&script.wireframe), counts(&model.wireframe));
    let [ours, theirs] = [script.wireframe.total_length(), model.wireframe.total_length()];
    assert!((ours - theirs).mm().abs() < 1.0, "{ours} of {theirs}");
}

#[test]
fn the_isogrid_script_is_the_isogrid_path() {
    let isogrid = import_data("bend-forming/isogrid_prototype.txt", &ReadOptions::default());
    assert_eq!(isogrid.format, Format::Pensa);
    let program = isogrid.program.unwrap();
    let value: Value = serde_json::from_slice(&data("bend-forming/isogrid_nodes_path.json").0).unwrap();
    assert_eq!(program.path.len(), value["path_0based"].as_array().unwrap().len());
    // Published: 27.362 m and 271 bends.
    assert!((program.program.length().mm() / 1000.0 - 27.362).abs() < 1e-3);
    assert_eq!(program.program.bend_count(), 271);
}

/// Table 1 of Bend-Forming has a teapot of 10.609 m with 216 bends; its wire of 0.9 mm is 52.6 of the 54 g.
#[test]
fn the_path_of_the_teapot_takes_what_table_1_has() {
    let value: Value = serde_json::from_slice(&data("bend-forming/teapot_nodes_path.json").0).unwrap();
    let place = |id: &Value| {
        let node = &value["nodes"][usize::try_from(id.as_u64().unwrap()).unwrap()];
        Point3::from([0, 1, 2].map(|axis| node[axis].as_f64().unwrap()))
    };
    let path: Vec<Point3<f64>> = value["path_0based"].as_array().unwrap().iter().map(place).collect();
    let (_, program) = program_of_path(&path, Angle::from_deg(1e-4).unwrap()).unwrap();
    assert_eq!(program.bend_count(), 216);
    let length = program.length().mm();
    assert!((length / 1000.0 - 10.609).abs() < 1e-3, "{length}");
    let wire_g = length * std::f64::consts::PI * 0.45 * 0.45 * 7.8e-3;
    assert!((wire_g / 52.6 - 1.0).abs() < 1e-3, "{wire_g}");
}

/// The best proper rotation and shift of `from` onto `onto` (Kabsch), and the largest error left.
fn misfit(from: &[Point3<f64>], onto: &[Point3<f64>]) -> f64 {
    let centre = |points: &[Point3<f64>]| {
        let count = f64::from(u32::try_from(points.len()).unwrap());
        points.iter().map(|p| p.coords).sum::<Vector3<f64>>() / count
    };
    let (a, b) = (centre(from), centre(onto));
    let pairs = || from.iter().zip(onto).map(|(p, q)| (p.coords - a, q.coords - b));
    let covariance: Matrix3<f64> = pairs().map(|(p, q)| p * q.transpose()).sum();
    let svd = covariance.svd(true, true);
    let (u, v) = (svd.u.unwrap(), svd.v_t.unwrap().transpose());
    let proper = Matrix3::from_diagonal(&Vector3::new(1.0, 1.0, (v * u.transpose()).determinant().signum()));
    let rotation = v * proper * u.transpose();
    pairs().map(|(p, q)| (rotation * p - q).norm()).fold(0.0, f64::max)
}

#[test]
fn the_truss_script_makes_the_truss_and_not_its_mirror_image() {
    let truss = import_data(
        "bend-forming/AccuracyTest_TetraTruss.txt",
        &ReadOptions { weld: mm(0.5), ..ReadOptions::default() },
    );
    let program = truss.program.unwrap();
    let value: Value =
        serde_json::from_slice(&data("bend-forming/tetra_prototype_nodes_path.json").0).unwrap();
    let number = |value: &Value| value.as_f64().unwrap();
    let nodes: Vec<Point3<f64>> = value["nodes"]
        .as_array()
        .unwrap()
        .iter()
        .map(|node| Point3::new(number(&node[0]), number(&node[1]), number(&node[2])))
        .collect();
    let ids: Vec<usize> = value["path_0based"]
        .as_array()
        .unwrap()
        .iter()
        .map(|id| usize::try_from(id.as_u64().unwrap()).unwrap())
        .collect();
    let path: Vec<Point3<f64>> = ids.iter().map(|&id| nodes[id]).collect();
    assert_eq!(program.path.len(), path.len());
    let error = misfit(&program.path, &path);
    assert!(error < 0.5, "{error} mm");
    // Angles of 5 decimals over 91 nodes: the error is of rounding, not of a wrong frame.
    let mirrored: Vec<Point3<f64>> = path.iter().map(|p| Point3::new(-p.x, p.y, p.z)).collect();
    assert!(misfit(&program.path, &mirrored) > 10.0, "a mirror image must not fit");
    // Published: 5.589 m and 79 bends.
    assert!((program.program.length().mm() / 1000.0 - 5.589).abs() < 1e-3);
    assert_eq!(program.program.bend_count(), 79);
    // The 24 nodes and 78 struts of the truss with one ring, and the walk that its authors made.
    assert_eq!((truss.wireframe.vertex_count(), truss.wireframe.edge_count()), (24, 78));
    let mut name = BTreeMap::new();
    for (ours, theirs) in program.traversal.iter().zip(&ids) {
        assert_eq!(name.entry(*ours).or_insert(*theirs), theirs, "one vertex, one node");
    }
    assert_eq!(replay(Frame::default(), &program.program.steps), program.path);

    // Our program of the authors' path has the steps of their script: lengths to 0.000005 mm and angles to
    // 0.000005°, as it writes them, and nodes to 0.000001 mm.
    let straight = Angle::from_deg(1e-3).unwrap();
    let (_, ours) = program_of_path(&path, straight).unwrap();
    let theirs = as_ours_are(&program.program.steps);
    assert_eq!(theirs.len(), ours.steps.len());
    for (n, (theirs, ours)) in theirs.iter().zip(&ours.steps).enumerate() {
        let off_mm = (theirs.feed.mm() - ours.feed.mm()).abs();
        let off = |a: Angle, b: Angle| (a - b).wrapped().deg().abs();
        let off_deg = off(theirs.rotate, ours.rotate).max(off(theirs.bend, ours.bend));
        assert!(off_mm < 5e-5 && off_deg < 1e-4, "step {n}: {theirs:?} {ours:?}");
    }
    assert_eq!(ours.bend_count(), program.program.bend_count());
    // And it makes the same wire. Theirs feeds straight joints in two steps: compare at the bends of ours.
    let corners: Vec<Point3<f64>> = std::iter::once(program.path[0])
        .chain(ours.spans.iter().map(|span| program.path[span.end]))
        .collect();
    let error = misfit(&replay(Frame::default(), &ours.steps), &corners);
    assert!(error < 0.01, "{error} mm");
}

/// A program of another tool as ours are: one feed up to a bend, bends of 0° to 180°, and no rotation where it
/// makes no difference, before the first bend and before a fold back.
fn as_ours_are(steps: &[Step]) -> Vec<Step> {
    let mut made: Vec<Step> = Vec::new();
    let (mut feed, mut rotate) = (Length::ZERO, Angle::ZERO);
    for step in steps {
        feed += step.feed;
        rotate += step.rotate;
        if step.bend == Angle::ZERO {
            continue;
        }
        // (φ, -θ) is (φ + 180°, θ) and then 180°.
        let turned = if step.bend < Angle::ZERO { Angle::HALF_TURN } else { Angle::ZERO };
        let before = rotate + turned;
        let is_fold = step.bend.abs() == Angle::HALF_TURN;
        // φ and then a fold back is the fold back and then -φ.
        let free = made.is_empty() || is_fold;
        rotate = if is_fold { turned - before } else { turned };
        let rotated = if free { Angle::ZERO } else { before.wrapped() };
        made.push(Step { feed, rotate: rotated, bend: step.bend.abs() });
        feed = Length::ZERO;
    }
    made.push(Step { feed, ..Step::default() });
    made
}

#[test]
fn instructions_to_a_person_are_refused_with_their_line() {
    let (bytes, name) = data("bend-forming/tetratruss_prototype_instructions.txt");
    let error = read(&bytes, &name, None, &ReadOptions::default()).unwrap_err();
    assert!(matches!(error, ReadError::Syntax { .. }));
    assert_eq!(error.line(), Some(40));
    expect_test::expect![[r#"tetratruss_prototype_instructions.txt, line 40: found "Rotate wire 108 degrees", expected a command: FEED, ROTATE, BEND or PINZ and one number"#]]
        .assert_eq(&error.to_string());
}
