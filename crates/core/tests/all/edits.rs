//! Edits: each can be undone and redone to the very same wireframe, and a bad one changes nothing.

use nalgebra::{Affine3, Matrix4, Point3, Unit, Vector3};
use proptest::prelude::*;
use wirebend_core::units::{Angle, Length};
use wirebend_core::wireframe::{
    Delta, Edge, EdgeId, Edit, EditError, Joint, JointKind, MergeAt, MirrorMode, Rest, StaleDelta, Vertex,
    VertexId, Wireframe, WireframeError,
};

fn mm(value: f64) -> Length {
    Length::from_mm(value).unwrap()
}

/// A square in the xy plane with corners 0, 1, 2, 3.
fn square() -> Wireframe {
    let mut w = Wireframe::new();
    for (x, y) in [(0., 0.), (10., 0.), (10., 10.), (0., 10.)] {
        w.add_vertex(Vertex::at(Point3::new(x, y, 0.))).unwrap();
    }
    for (a, b) in [(0, 1), (1, 2), (2, 3), (3, 0)] {
        w.add_edge(VertexId(a), VertexId(b)).unwrap();
    }
    w
}

fn all(w: &Wireframe) -> Vec<VertexId> {
    w.vertices().map(|(id, _)| id).collect()
}

fn move_along_z(by: f64) -> Affine3<f64> {
    Affine3::from_matrix_unchecked(Matrix4::new_translation(&Vector3::new(0., 0., by)))
}

#[test]
fn ids_are_never_used_twice() {
    let mut w = square();
    let gone = Edit::Delete { vertices: vec![VertexId(3)], edges: vec![] };
    w.apply(&gone).unwrap();
    assert_eq!((w.vertex_count(), w.edge_count()), (3, 2));
    w.apply(&Edit::AddVertex { position: Point3::new(5., 5., 5.) }).unwrap();
    w.apply(&Edit::Connect { a: VertexId(2), b: VertexId(4) }).unwrap();
    assert_eq!(w.edge(EdgeId(4)), Some(Edge::between(VertexId(2), VertexId(4))));
    assert_eq!(w.vertex(VertexId(3)), None);
}

#[test]
fn splitting_keeps_the_id_of_the_first_part() {
    let mut w = square();
    w.apply(&Edit::SplitEdge { edge: EdgeId(1), at: 0.25 }).unwrap();
    assert_eq!(w.vertex(VertexId(4)).unwrap().position, Point3::new(10., 2.5, 0.));
    assert_eq!(w.edge(EdgeId(1)), Some(Edge::between(VertexId(1), VertexId(4))));
    assert_eq!(w.edge(EdgeId(4)), Some(Edge::between(VertexId(4), VertexId(2))));
}

#[test]
fn merging_drops_what_collapses_and_what_repeats() {
    let mut w = square();
    // Opposite corners become one: two pairs of edges fall onto each other.
    w.apply(&Edit::Merge { vertices: vec![VertexId(2), VertexId(0)], at: MergeAt::Centre }).unwrap();
    assert_eq!(w.vertex(VertexId(2)).unwrap().position, Point3::new(5., 5., 0.));
    assert_eq!((w.vertex_count(), w.edge_count()), (3, 2));
    // Neighbours become one: the edge between them is gone.
    let mut w = square();
    w.apply(&Edit::Merge { vertices: vec![VertexId(0), VertexId(1)], at: MergeAt::Last }).unwrap();
    assert_eq!((w.vertex_count(), w.edge_count()), (3, 3));
    assert_eq!(w.vertex(VertexId(0)).unwrap().position, Point3::new(10., 0., 0.));
}

/// Click after click of a person who traces, as one strand: from a corner, through two points, back to another.
#[test]
fn a_strand_joins_what_is_there_by_way_of_what_is_new() {
    let mut w = square();
    let points = [Point3::new(0., 0., 5.), Point3::new(10., 10., 5.)];
    let (from, to) = (Some(VertexId(0)), Some(VertexId(2)));
    w.apply(&Edit::Draw { from, through: points.to_vec(), to }).unwrap();
    let drawn: Vec<(u32, u32)> = w.edges().skip(4).map(|(_, edge)| (edge.a.0, edge.b.0)).collect();
    assert_eq!(drawn, [(0, 4), (4, 5), (5, 2)]);
    // One point alone, and an edge alone.
    w.apply(&Edit::Draw { from: None, through: vec![Point3::origin()], to: None }).unwrap();
    assert!(w.incident(VertexId(6)).is_empty());
    w.apply(&Edit::Draw { from: Some(VertexId(6)), through: vec![], to }).unwrap();
    assert_eq!(w.incident(VertexId(6)).len(), 1);
    for (from, to, error) in [
        (None, None, EditError::EmptyStrand),
        (from, from, EditError::Loop(VertexId(0))),
        (from, Some(VertexId(1)), EditError::Connected(VertexId(0), VertexId(1))),
        (from, Some(VertexId(9)), EditError::Wireframe(WireframeError::NoVertex(VertexId(9)))),
    ] {
        assert_eq!(w.apply(&Edit::Draw { from, through: vec![], to }), Err(error));
    }
}

/// What was copied elsewhere comes with its supports, under ids of its own.
#[test]
fn a_piece_is_pasted_whole_or_not_at_all() {
    let mut w = square();
    let piece = [
        Vertex::at(Point3::new(1., 2., 3.)),
        Vertex { support: true, ..Vertex::at(Point3::new(4., 5., 6.)) },
    ];
    w.apply(&Edit::Paste { vertices: piece.to_vec(), edges: vec![(1, 0)] }).unwrap();
    assert_eq!(w.vertex(VertexId(5)), Some(piece[1]));
    assert_eq!(w.edge(EdgeId(4)), Some(Edge::between(VertexId(5), VertexId(4))));
    for (edge, error) in
        [((0, 2), EditError::NotInPiece { index: 2, count: 2 }), ((1, 1), EditError::Loop(VertexId(7)))]
    {
        let paste = Edit::Paste { vertices: piece.to_vec(), edges: vec![(0, 1), edge] };
        assert_eq!(w.apply(&paste), Err(error));
    }
    assert_eq!((w.vertex_count(), w.edge_count()), (6, 5));
}

#[test]
fn a_mirror_copy_shares_what_lies_on_the_plane() {
    let mut w = square();
    let plane = (Point3::new(10., 3., 3.), Unit::new_normalize(Vector3::x()));
    let mirror =
        |mode, vertices| Edit::Mirror { vertices, point: plane.0, normal: plane.1, mode, weld: mm(1e-3) };
    w.apply(&mirror(MirrorMode::Copy, all(&w))).unwrap();
    assert_eq!((w.vertex_count(), w.edge_count()), (6, 7), "two squares with a common side");
    assert_eq!(w.vertex(VertexId(4)).unwrap().position, Point3::new(20., 0., 0.));
    let mut w = square();
    w.apply(&mirror(MirrorMode::InPlace, vec![VertexId(0)])).unwrap();
    assert_eq!(w.vertex(VertexId(0)).unwrap().position, Point3::new(20., 0., 0.));
    assert_eq!(w.edge_count(), 4);
}

#[test]
fn an_array_of_touching_copies_shares_their_common_vertices() {
    let mut w = square();
    let step = Affine3::from_matrix_unchecked(Matrix4::new_translation(&Vector3::new(10., 0., 0.)));
    w.apply(&Edit::Array { vertices: all(&w), step, count: 3, weld: mm(1e-3) }).unwrap();
    assert_eq!((w.vertex_count(), w.edge_count()), (10, 13), "a ladder of four cells");
}

#[test]
fn a_bad_edit_says_what_is_wrong_and_changes_nothing() {
    let flat =
        Affine3::from_matrix_unchecked(Matrix4::from_diagonal(&nalgebra::Vector4::new(1., 1., 0., 1.)));
    let nowhere = Point3::new(f64::NAN, 0., 0.);
    let wireframe = EditError::Wireframe;
    let cases = [
        (Edit::AddVertex { position: nowhere }, wireframe(WireframeError::Position(nowhere))),
        (Edit::Connect { a: VertexId(0), b: VertexId(9) }, wireframe(WireframeError::NoVertex(VertexId(9)))),
        (Edit::Connect { a: VertexId(0), b: VertexId(0) }, EditError::Loop(VertexId(0))),
        (Edit::Connect { a: VertexId(1), b: VertexId(0) }, EditError::Connected(VertexId(1), VertexId(0))),
        (Edit::Delete { vertices: vec![], edges: vec![EdgeId(9)] }, EditError::NoEdge(EdgeId(9))),
        (
            Edit::Move { vertices: vec![VertexId(0), VertexId(0)], by: Vector3::x() },
            EditError::Repeated(VertexId(0)),
        ),
        (
            Edit::Move { vertices: vec![VertexId(0)], by: Vector3::x() * 1e7 },
            wireframe(WireframeError::Position(Point3::new(1e7, 0., 0.))),
        ),
        (Edit::SplitEdge { edge: EdgeId(0), at: 1.0 }, EditError::SplitAt(1.0)),
        (Edit::SplitEdge { edge: EdgeId(0), at: f64::NAN }, EditError::SplitAt(f64::NAN)),
        (Edit::Merge { vertices: vec![VertexId(1)], at: MergeAt::First }, EditError::MergeCount(1)),
        (Edit::Merge { vertices: vec![], at: MergeAt::First }, EditError::MergeCount(0)),
        (Edit::Transform { vertices: vec![VertexId(1)], transform: flat }, EditError::Singular),
        (
            Edit::Array {
                vertices: vec![VertexId(1)],
                step: move_along_z(1.),
                count: u32::MAX,
                weld: mm(0.),
            },
            EditError::ArrayCount { copies: u32::MAX, max: 1_000_000 },
        ),
    ];
    for (edit, expected) in cases {
        let mut w = square();
        let error = w.apply(&edit).unwrap_err();
        // As text, since NaN is not equal to itself.
        assert_eq!(format!("{error:?}"), format!("{expected:?}"));
        assert_eq!(w, square());
    }
    let error = square().apply(&Edit::Place { vertex: VertexId(8), position: Point3::origin() });
    assert_eq!(error, Err(EditError::Wireframe(WireframeError::NoVertex(VertexId(8)))));
}

#[test]
fn a_stale_difference_is_refused() {
    let mut w = square();
    let moved = w.apply(&Edit::Move { vertices: vec![VertexId(0)], by: Vector3::x() }).unwrap();
    assert_eq!(w.commit(&moved), Err(StaleDelta::Vertex(VertexId(0))));
    let cut = w.apply(&Edit::Delete { vertices: vec![], edges: vec![EdgeId(0)] }).unwrap();
    assert_eq!(w.commit(&cut), Err(StaleDelta::Edge(EdgeId(0))));
    let added = w.apply(&Edit::AddVertex { position: Point3::origin() }).unwrap();
    assert_eq!(w.commit(&added), Err(StaleDelta::Next));
    // Undone out of order, the edge would be left without its vertex.
    w.apply(&Edit::Connect { a: VertexId(4), b: VertexId(2) }).unwrap();
    let undo = added.inverse();
    let mut forged = undo.clone();
    forged.next = (w.next_ids(), undo.next.1);
    assert_eq!(w.commit(&forged), Err(StaleDelta::Edge(EdgeId(4))));
}

fn any_edit() -> impl Strategy<Value = Edit> {
    let v = || (0..12_u32).prop_map(VertexId);
    let some = || prop::collection::btree_set((0..12_u32).prop_map(VertexId), 0..5).prop_map(Vec::from_iter);
    let point = || prop::array::uniform3(-50..50_i32).prop_map(|c| Point3::from(c.map(f64::from)));
    let edges = || prop::collection::btree_set((0..12_u32).prop_map(EdgeId), 0..6).prop_map(Vec::from_iter);
    let weld = Just(Length::from_mm(1.5).unwrap());
    let rest = || prop_oneof![Just(Rest::Stays), Just(Rest::Follows)];
    prop_oneof![
        point().prop_map(|position| Edit::AddVertex { position }),
        (v(), v()).prop_map(|(a, b)| Edit::Connect { a, b }),
        (prop::option::of(v()), prop::collection::vec(point(), 0..4), prop::option::of(v()))
            .prop_map(|(from, through, to)| Edit::Draw { from, through, to }),
        (prop::collection::vec(point(), 0..4), prop::collection::vec((0..4_usize, 0..4_usize), 0..4))
            .prop_map(|(points, edges)| Edit::Paste {
                vertices: points.into_iter().map(Vertex::at).collect(),
                edges
            }),
        (some(), prop::collection::vec((0..12_u32).prop_map(EdgeId), 0..3))
            .prop_map(|(vertices, edges)| Edit::Delete { vertices, edges }),
        (some(), point()).prop_map(|(vertices, by)| Edit::Move { vertices, by: by.coords }),
        (v(), point()).prop_map(|(vertex, position)| Edit::Place { vertex, position }),
        ((0..12_u32).prop_map(EdgeId), 0.0..1.0_f64).prop_map(|(edge, at)| Edit::SplitEdge { edge, at }),
        ((0..12_u32).prop_map(EdgeId), v(), -1.0..60.0_f64, rest())
            .prop_map(|(edge, stays, to, rest)| { Edit::SetLength { edge, length: mm(to), stays, rest } }),
        (v(), -10.0..200.0_f64, rest()).prop_map(|(vertex, to, rest)| Edit::SetAngle {
            vertex,
            between: None,
            angle: Angle::from_deg(to).unwrap(),
            normal: Some(Vector3::z_axis()),
            rest
        }),
        (some(), prop_oneof![Just(MergeAt::First), Just(MergeAt::Last), Just(MergeAt::Centre)])
            .prop_map(|(vertices, at)| Edit::Merge { vertices, at }),
        (some(), point(), any::<bool>(), weld).prop_map(|(vertices, point, copy, weld)| {
            Edit::Mirror {
                vertices,
                point,
                normal: Unit::new_normalize(Vector3::new(1., 2., 3.)),
                mode: if copy { MirrorMode::Copy } else { MirrorMode::InPlace },
                weld,
            }
        }),
        (some(), 0..3_u32, weld).prop_map(|(vertices, count, weld)| Edit::Array {
            vertices,
            step: move_along_z(1.0),
            count,
            weld
        }),
        (some(), any::<bool>()).prop_map(|(vertices, support)| Edit::SetSupport { vertices, support }),
        (some(), prop::option::of(0.0..50.0_f64)).prop_map(|(vertices, mass)| Edit::SetJoint {
            vertices,
            joint: mass.map(|mass_g| Joint { kind: JointKind::SnapFit, mass_g })
        }),
        (edges(), any::<bool>()).prop_map(|(edges, ceiling)| Edit::SetCeiling { edges, ceiling }),
        weld.prop_map(|tolerance| Edit::Weld { tolerance }),
        edges().prop_map(|edges| Edit::Detach { edges }),
        (edges(), 0.0..60.0_f64)
            .prop_map(|(edges, tolerance)| Edit::Straighten { edges, tolerance: mm(tolerance) }),
        (edges(), 0.0..60.0_f64, 1.0..180.0_f64).prop_map(|(edges, tolerance, step)| Edit::Round {
            edges,
            tolerance: mm(tolerance),
            step: Angle::from_deg(step).unwrap(),
            min_edge: mm(1.0)
        }),
    ]
}

proptest! {
    #[test]
    fn every_history_can_be_walked_back_and_forth(edits in prop::collection::vec(any_edit(), 1..60)) {
        let mut w = Wireframe::new();
        let mut states = vec![w.clone()];
        let mut deltas = Vec::new();
        for edit in &edits {
            let before = w.clone();
            if let Ok(delta) = w.apply(edit) {
                deltas.push(delta);
                states.push(w.clone());
            } else {
                prop_assert_eq!(&w, &before);
            }
            for (id, edge) in w.edges() {
                prop_assert!(w.vertex(edge.a).is_some() && w.vertex(edge.b).is_some(), "edge {} hangs", id);
                prop_assert!(edge.a != edge.b);
            }
        }
        for (delta, state) in deltas.iter().zip(&states).rev() {
            w.commit(&delta.inverse()).unwrap();
            prop_assert_eq!(&w, state);
        }
        for (delta, state) in deltas.iter().zip(&states[1..]) {
            w.commit(delta).unwrap();
            prop_assert_eq!(&w, state);
        }
        // All of them as one.
        let whole = deltas.iter().fold(Delta::none(&states[0]), Delta::then);
        w.commit(&whole.inverse()).unwrap();
        prop_assert_eq!(&w, &states[0]);
        w.commit(&whole).unwrap();
        prop_assert_eq!(Some(&w), states.last());
    }
}
