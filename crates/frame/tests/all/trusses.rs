//! The tetrahedral trusses of Bend-Forming (Bhundiya et al. 2022): two faces of triangles, H apart, and struts between them.

use std::path::Path;

use nalgebra::{Point3, Rotation3, Unit, Vector3};
use wirebend_frame::{Member, Model, NodeId, Section, SectionId};

use crate::frames::STEEL;

/// Depth of the published truss, mm; its struts are all as long, H √(3/2).
const DEPTH: f64 = 50.0;

fn strut() -> f64 {
    DEPTH * 1.5_f64.sqrt()
}

/// The truss with so many rings, (2N + 1) struts across, each strut once. A face has the outline of a triangle of 3N + 1 struts
/// without three corners of N; the other face is its mirror image through the middle of the truss.
pub fn truss(rings: usize) -> Model {
    let side = 3 * rings + 1;
    let mut nodes = Vec::new();
    let l = strut();
    for row in 0..=side {
        for place in 0..=side - row {
            let corner = [row, place, side - row - place].into_iter().max() > Some(side - rings);
            if !corner {
                #[allow(clippy::cast_precision_loss, reason = "small numbers")]
                let (row, place, side) = (row as f64, place as f64, side as f64);
                let x = (place + row / 2.0 - side / 2.0) * l;
                let y = (row - side / 3.0) * l * 0.75_f64.sqrt();
                nodes.push(Point3::new(x, y, DEPTH / 2.0));
            }
        }
    }
    nodes.extend(nodes.clone().iter().map(|node| -node));
    joined(nodes)
}

/// A strut between all nodes that are one strut apart.
fn joined(nodes: Vec<Point3<f64>>) -> Model {
    let mut members = Vec::new();
    for (b, second) in nodes.iter().enumerate() {
        for (a, first) in nodes[..b].iter().enumerate() {
            if ((second - first).norm() - strut()).abs() < 1e-6 * strut() {
                members.push(Member::new(NodeId(a), NodeId(b), SectionId(0)));
            }
        }
    }
    Model { nodes, members, sections: vec![Section::round(0.9, &STEEL)], supports: Vec::new() }
}

/// The wire of the authors' accuracy test (HaaarshB/Bend-Forming, 57988a9, MIT): feeds, rotations and bends of the Pensa D.I.Wire.
/// Where it comes by a node again, it is joined.
pub fn accuracy_test_wire() -> Model {
    let file = "tests/data/bend-forming/AccuracyTest_TetraTruss.txt";
    let text = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(file)).expect("the file");
    let mut frame = Rotation3::identity();
    let mut at = Point3::origin();
    let mut model =
        Model { nodes: vec![at], sections: vec![Section::round(0.9, &STEEL)], ..Model::default() };
    let mut last = NodeId(0);
    for line in text.lines() {
        let Some((word, figure)) = line.split_once(' ') else { continue };
        let figure: f64 = figure.trim().parse().expect("a number");
        match word {
            "FEED" => {
                at += frame * Vector3::x() * figure;
                let met = model.nodes.iter().position(|node| (node - at).norm() < 0.01 * strut());
                let node = NodeId(met.unwrap_or(model.nodes.len()));
                if met.is_none() {
                    model.nodes.push(at);
                }
                model.members.push(Member::new(last, node, SectionId(0)));
                last = node;
            }
            "BEND" => frame *= turn(Vector3::z_axis(), figure),
            "ROTATE" => frame *= turn(Vector3::x_axis(), figure),
            other => panic!("{other}"),
        }
    }
    model
}

fn turn(axis: Unit<Vector3<f64>>, degrees: f64) -> Rotation3<f64> {
    Rotation3::from_axis_angle(&axis, degrees.to_radians())
}

/// Nodes and struts as the paper's figures have them.
#[test]
fn trusses_have_the_nodes_and_struts_of_the_paper() {
    for (rings, nodes, struts) in [(1, 24, 78), (2, 54, 198), (3, 96, 372), (5, 216, 882)] {
        let truss = truss(rings);
        assert_eq!((truss.nodes.len(), truss.members.len()), (nodes, struts));
    }
    let wire = accuracy_test_wire();
    assert_eq!((wire.nodes.len(), wire.members.len()), (24, 90));
}
