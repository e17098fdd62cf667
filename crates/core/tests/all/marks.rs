//! What a design says of its vertices and edges beside where they are: joints, ceilings, supports. No edit drops it.

use nalgebra::Point3;
use wirebend_core::units::Length;
use wirebend_core::wireframe::{
    Edge, EdgeId, Edit, EditError, Joint, JointKind, MergeAt, Vertex, VertexId, Wireframe, WireframeError,
};

const TIE: Joint = Joint { kind: JointKind::ZipTie, mass_g: 0.3 };

/// Vertices on a line, 10 mm apart, each joined to the next.
fn line(count: u32) -> Wireframe {
    let mut w = Wireframe::new();
    for k in 0..count {
        w.add_vertex(Vertex::at(Point3::new(10.0 * f64::from(k), 0.0, 0.0))).unwrap();
    }
    for k in 1..count {
        w.add_edge(VertexId(k - 1), VertexId(k)).unwrap();
    }
    w
}

fn joint(vertices: &[u32], joint: Option<Joint>) -> Edit {
    Edit::SetJoint { vertices: vertices.iter().copied().map(VertexId).collect(), joint }
}

fn ceiling(edges: &[u32], ceiling: bool) -> Edit {
    Edit::SetCeiling { edges: edges.iter().copied().map(EdgeId).collect(), ceiling }
}

fn ceilings(w: &Wireframe) -> Vec<u32> {
    w.edges().filter(|(_, edge)| edge.ceiling).map(|(id, _)| id.0).collect()
}

fn joints(w: &Wireframe) -> Vec<u32> {
    w.vertices().filter(|(_, vertex)| vertex.joint.is_some()).map(|(id, _)| id.0).collect()
}

#[test]
fn marks_are_set_and_undone() {
    let mut w = line(3);
    let before = w.clone();
    let first = w.apply(&joint(&[0, 2], Some(TIE))).unwrap();
    let second = w.apply(&ceiling(&[1], true)).unwrap();
    assert_eq!(w.vertex(VertexId(2)).unwrap().joint, Some(TIE));
    assert_eq!((joints(&w), ceilings(&w)), (vec![0, 2], vec![1]));
    w.apply(&joint(&[2], None)).unwrap();
    w.apply(&ceiling(&[1], false)).unwrap();
    assert_eq!((joints(&w), ceilings(&w)), (vec![0], vec![]));
    w.apply(&joint(&[2], Some(TIE))).unwrap();
    w.apply(&ceiling(&[1], true)).unwrap();
    w.commit(&second.inverse()).unwrap();
    w.commit(&first.inverse()).unwrap();
    assert_eq!(w, before);
}

/// What is merged is held as each was; marked anew, a vertex is held altogether, and freed not at all.
#[test]
fn a_support_that_leaves_motions_free_stays_so_until_it_is_marked_anew() {
    let [along_z, about_x] = [2, 3].map(|axis| std::array::from_fn(|k| k != axis));
    let mut w = Wireframe::new();
    for (x, support, free) in [
        (0.0, true, along_z),
        (0.0, true, about_x),
        (0.0, false, [false; 6]),
        (50.0, false, [false; 6]),
        (50.0, true, about_x),
        (90.0, true, along_z),
    ] {
        let position = Point3::new(x, 0.0, 0.0);
        w.add_vertex(Vertex { support, free, ..Vertex::at(position) }).unwrap();
    }
    let fixed = |w: &Wireframe, id: u32| w.vertex(VertexId(id)).unwrap().fixed();
    let before = w.clone();
    let welded = w.weld(Length::from_mm(0.1).unwrap()).0;
    w.commit(&welded).unwrap();
    assert_eq!(fixed(&w, 0), [false, false, true, true, false, false]);
    assert_eq!(fixed(&w, 3), [false, false, false, true, false, false]);
    w.commit(&welded.inverse()).unwrap();
    assert_eq!(w, before);
    let mark = |support| Edit::SetSupport { vertices: vec![VertexId(5)], support };
    let undo = w.apply(&mark(true)).unwrap().inverse();
    assert_eq!(fixed(&w, 5), [true; 6]);
    w.apply(&mark(false)).unwrap();
    assert_eq!(w.vertex(VertexId(5)).unwrap(), Vertex::at(Point3::new(90.0, 0.0, 0.0)));
    w.apply(&mark(true)).unwrap();
    w.commit(&undo).unwrap();
    assert_eq!(w, before);
}

#[test]
fn a_joint_has_a_mass_and_a_place() {
    let mut w = line(3);
    for mass_g in [f64::NAN, f64::INFINITY, -0.1, 1.1e6] {
        let error = w.apply(&joint(&[0], Some(Joint { mass_g, ..TIE }))).unwrap_err();
        assert!(matches!(error, EditError::Wireframe(WireframeError::JointMass(_))), "{error}");
    }
    let error = w.apply(&joint(&[0], Some(Joint { mass_g: -2.0, ..TIE }))).unwrap_err();
    assert_eq!(error.to_string(), "-2 g is no mass of a joint: it must be a number from 0 to 1 000 000 g");
    let none = EditError::Wireframe(WireframeError::NoVertex(VertexId(9)));
    assert_eq!(w.apply(&joint(&[9], Some(TIE))), Err(none));
    assert_eq!(w.apply(&joint(&[1, 1], None)), Err(EditError::Repeated(VertexId(1))));
    assert_eq!(w.apply(&ceiling(&[7], true)), Err(EditError::NoEdge(EdgeId(7))));
    assert_eq!(w.apply(&ceiling(&[0, 0], true)), Err(EditError::RepeatedEdge(EdgeId(0))));
    assert_eq!(w, line(3));
}

#[test]
fn an_edge_that_is_split_or_redrawn_stays_ceiling() {
    let mut w = line(2);
    w.apply(&ceiling(&[0], true)).unwrap();
    w.apply(&Edit::SplitEdge { edge: EdgeId(0), at: 0.5 }).unwrap();
    assert_eq!(ceilings(&w), [0, 1]);
    let tolerance = Length::from_mm(1.0).unwrap();
    w.apply(&Edit::Straighten { edges: vec![EdgeId(0), EdgeId(1)], tolerance }).unwrap();
    assert_eq!((w.edge_count(), ceilings(&w)), (1, vec![0]));
}

/// A joint in the middle of a chain holds something there.
#[test]
fn a_vertex_with_a_joint_is_not_straightened_away() {
    let mut w = line(4);
    w.apply(&joint(&[1], Some(TIE))).unwrap();
    let tolerance = Length::from_mm(1.0).unwrap();
    let edges = vec![EdgeId(0), EdgeId(1), EdgeId(2)];
    w.apply(&Edit::Straighten { edges, tolerance }).unwrap();
    assert_eq!((w.vertex_count(), joints(&w)), (3, vec![1]));
}

#[test]
fn what_is_merged_or_welded_keeps_its_marks() {
    let mut w = line(4);
    w.apply(&joint(&[2], Some(TIE))).unwrap();
    w.apply(&ceiling(&[1], true)).unwrap();
    // Vertices 0 and 2 become one, so that the edges 0 and 1 join the same two.
    w.apply(&Edit::Merge { vertices: vec![VertexId(0), VertexId(2)], at: MergeAt::First }).unwrap();
    assert_eq!((joints(&w), ceilings(&w)), (vec![0], vec![0]));

    let mut w = line(2);
    for x in [0.0, 10.0] {
        w.add_vertex(Vertex { joint: Some(TIE), ..Vertex::at(Point3::new(x, 1e-4, 0.0)) }).unwrap();
    }
    let mark = Edge { ceiling: true, ..Edge::between(VertexId(2), VertexId(3)) };
    w.insert_edge(EdgeId(1), mark).unwrap();
    w.apply(&Edit::Weld { tolerance: Length::from_mm(1e-3).unwrap() }).unwrap();
    assert_eq!((joints(&w), ceilings(&w), w.edge_count()), (vec![0, 1], vec![0], 1));
}

/// What is taken off takes no second joint with it; a copy of a piece has its joints.
#[test]
fn a_joint_is_counted_once() {
    let mut w = line(3);
    w.apply(&joint(&[1], Some(TIE))).unwrap();
    w.apply(&Edit::Detach { edges: vec![EdgeId(1)] }).unwrap();
    assert_eq!((w.vertex_count(), joints(&w)), (4, vec![1]));
}
