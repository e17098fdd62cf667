//! Lengths and angles that are typed: they come out as typed, and what is to stay stays.

use nalgebra::{Point3, Unit, Vector3};
use proptest::prelude::*;
use wirebend_core::units::{Angle, Length};
use wirebend_core::wireframe::{EdgeId, Edit, EditError, Rest, Vertex, VertexId, Wireframe};

fn mm(value: f64) -> Length {
    Length::from_mm(value).unwrap()
}

fn deg(value: f64) -> Angle {
    Angle::from_deg(value).unwrap()
}

/// A chain through points: vertices and edges in its order.
fn chain(points: &[[f64; 3]]) -> Wireframe {
    let mut w = Wireframe::new();
    let through = points.iter().copied().map(Point3::from).collect();
    w.apply(&Edit::Draw { from: None, through, to: None }).unwrap();
    w
}

fn at(w: &Wireframe, id: u32) -> Point3<f64> {
    w.vertex(VertexId(id)).unwrap().position
}

fn length(w: &Wireframe, a: u32, b: u32) -> f64 {
    (at(w, b) - at(w, a)).norm()
}

/// The angle at `corner` between the ways to two vertices, degrees: by the tangent of its half (Kahan), not as the edit has it.
fn angle(w: &Wireframe, corner: u32, a: u32, b: u32) -> f64 {
    let way = |id| (at(w, id) - at(w, corner)).normalize();
    let (a, b) = (way(a), way(b));
    2.0 * (a - b).norm().atan2((a + b).norm()).to_degrees()
}

fn set_length(edge: u32, to: f64, stays: u32, rest: Rest) -> Edit {
    Edit::SetLength { edge: EdgeId(edge), length: mm(to), stays: VertexId(stays), rest }
}

fn set_angle(vertex: u32, between: Option<(u32, u32)>, to: f64, rest: Rest) -> Edit {
    let between = between.map(|(stays, turns)| (EdgeId(stays), EdgeId(turns)));
    Edit::SetAngle { vertex: VertexId(vertex), between, angle: deg(to), normal: None, rest }
}

/// Four vertices of a chain of which no two are near each other.
fn any_chain() -> impl Strategy<Value = [[f64; 3]; 4]> {
    prop::array::uniform4(prop::array::uniform3(-300.0..300.0_f64)).prop_filter("vertices apart", |points| {
        let apart = |a: &[f64; 3], b: &[f64; 3]| (Point3::from(*a) - Point3::from(*b)).norm() > 5.0;
        points.iter().enumerate().all(|(k, a)| points[..k].iter().all(|b| apart(a, b)))
    })
}

fn any_rest() -> impl Strategy<Value = Rest> {
    prop_oneof![Just(Rest::Stays), Just(Rest::Follows)]
}

proptest! {
    #[test]
    fn a_length_is_what_was_typed_and_one_end_stays(
        points in any_chain(), to in 0.01..2000.0_f64, rest in any_rest(), first in any::<bool>()
    ) {
        let before = chain(&points);
        let mut w = before.clone();
        // The middle edge, and the vertices beyond either end of it.
        let (stays, goes, behind, beyond) = if first { (1, 2, 0, 3) } else { (2, 1, 3, 0) };
        let delta = w.apply(&set_length(1, to, stays, rest)).unwrap();
        prop_assert!((length(&w, 1, 2) - to).abs() < 1e-9);
        prop_assert_eq!((at(&w, stays), at(&w, behind)), (at(&before, stays), at(&before, behind)));
        let (way, was) = (at(&w, goes) - at(&w, stays), at(&before, goes) - at(&before, stays));
        prop_assert!(way.normalize().cross(&was.normalize()).norm() < 1e-9 && way.dot(&was) > 0.0);
        match rest {
            Rest::Stays => prop_assert_eq!(at(&w, beyond), at(&before, beyond)),
            Rest::Follows => {
                prop_assert!((length(&w, goes, beyond) - length(&before, goes, beyond)).abs() < 1e-9);
                let (is, was) = (angle(&w, goes, stays, beyond), angle(&before, goes, stays, beyond));
                prop_assert!((is - was).abs() < 1e-6, "{} from {}", is, was);
            }
        }
        w.commit(&delta.inverse()).unwrap();
        prop_assert_eq!(w, before);
    }

    #[test]
    fn an_angle_is_what_was_typed_and_one_edge_stays(
        points in any_chain(), to in 0.01..=180.0_f64, rest in any_rest()
    ) {
        let before = chain(&points);
        prop_assume!((1.0..179.0).contains(&angle(&before, 1, 0, 2)));
        let mut w = before.clone();
        let delta = w.apply(&set_angle(1, Some((0, 1)), to, rest)).unwrap();
        prop_assert!((angle(&w, 1, 0, 2) - to).abs() < 1e-9, "{}", angle(&w, 1, 0, 2));
        prop_assert_eq!((at(&w, 0), at(&w, 1)), (at(&before, 0), at(&before, 1)));
        prop_assert!((length(&w, 1, 2) - length(&before, 1, 2)).abs() < 1e-9);
        // It has turned in the plane of both.
        let normal = (at(&before, 0) - at(&before, 1)).cross(&(at(&before, 2) - at(&before, 1))).normalize();
        prop_assert!(normal.dot(&(at(&w, 2) - at(&w, 1))).abs() < 1e-9 * 1000.0);
        match rest {
            Rest::Stays => prop_assert_eq!(at(&w, 3), at(&before, 3)),
            Rest::Follows => {
                prop_assert!((length(&w, 2, 3) - length(&before, 2, 3)).abs() < 1e-9);
                let (is, was) = (angle(&w, 2, 1, 3), angle(&before, 2, 1, 3));
                prop_assert!((is - was).abs() < 1e-6, "{} from {}", is, was);
            }
        }
        w.commit(&delta.inverse()).unwrap();
        prop_assert_eq!(w, before);
    }
}

#[test]
fn edges_in_line_turn_in_the_plane_that_is_named() {
    let mut w = chain(&[[0., 0., 0.], [10., 0., 0.], [30., 0., 0.]]);
    let turn = |normal: Option<Vector3<f64>>| Edit::SetAngle {
        vertex: VertexId(1),
        between: None,
        angle: deg(90.0),
        normal: normal.map(Unit::new_normalize),
        rest: Rest::Stays,
    };
    assert_eq!(w.apply(&turn(None)), Err(EditError::InLine(VertexId(1))));
    assert_eq!(w.apply(&turn(Some(Vector3::x()))), Err(EditError::InLine(VertexId(1))));
    // About +z a quarter turn from -x is -y; a normal that is not across the edges is taken as far as it is.
    for normal in [Vector3::z(), Vector3::new(3.0, 0.0, 1.0)] {
        let mut turned = w.clone();
        turned.apply(&turn(Some(normal))).unwrap();
        assert!((at(&turned, 2) - Point3::new(10., -20., 0.)).norm() < 1e-9, "{}", at(&turned, 2));
    }
}

#[test]
fn what_no_edge_can_be_is_refused_and_nothing_changes() {
    // A triangle with a tail: vertex 2 has three edges.
    let mut w = chain(&[[0., 0., 0.], [10., 0., 0.], [0., 10., 0.], [0., 20., 5.]]);
    w.apply(&Edit::Connect { a: VertexId(2), b: VertexId(0) }).unwrap();
    w.add_vertex(Vertex::at(Point3::new(0., 20., 5.))).unwrap();
    w.add_edge(VertexId(3), VertexId(4)).unwrap();
    w.add_edge(VertexId(3), VertexId(4)).unwrap();
    let before = w.clone();
    let apart = |turns| set_angle(3, Some((2, turns)), 90.0, Rest::Stays);
    let cases = [
        (set_length(0, 0.0, 0, Rest::Stays), EditError::EdgeLength(0.0)),
        (set_length(0, -2.0, 0, Rest::Stays), EditError::EdgeLength(-2.0)),
        (set_length(9, 5.0, 0, Rest::Stays), EditError::NoEdge(EdgeId(9))),
        (set_length(0, 5.0, 3, Rest::Stays), EditError::NotAnEnd { edge: EdgeId(0), vertex: VertexId(3) }),
        (set_length(0, 5.0, 0, Rest::Follows), EditError::InLoop(EdgeId(0))),
        (set_length(4, 5.0, 3, Rest::Stays), EditError::NoDirection(EdgeId(4))),
        (set_angle(1, None, 0.0, Rest::Stays), EditError::CornerAngle(0.0)),
        (set_angle(1, None, 180.1, Rest::Stays), EditError::CornerAngle(deg(180.1).deg())),
        (set_angle(1, None, 45.0, Rest::Follows), EditError::InLoop(EdgeId(1))),
        (set_angle(2, None, 90.0, Rest::Stays), EditError::NoCorner { vertex: VertexId(2), edges: 3 }),
        (set_angle(1, Some((1, 1)), 90.0, Rest::Stays), EditError::RepeatedEdge(EdgeId(1))),
        (
            set_angle(1, Some((0, 2)), 90.0, Rest::Stays),
            EditError::NotAnEnd { edge: EdgeId(2), vertex: VertexId(1) },
        ),
        (set_angle(3, Some((4, 5)), 90.0, Rest::Stays), EditError::SameEnds(EdgeId(4), EdgeId(5))),
        (apart(4), EditError::NoDirection(EdgeId(4))),
    ];
    for (edit, expected) in cases {
        assert_eq!(w.apply(&edit), Err(expected));
        assert_eq!(w, before);
    }
    // Between edges that are named an angle is set at any vertex, and the tail follows where the triangle cannot.
    w.apply(&set_angle(2, Some((1, 2)), 90.0, Rest::Follows)).unwrap();
    assert!((angle(&w, 2, 1, 3) - 90.0).abs() < 1e-9);
    assert!((at(&w, 3) - at(&w, 4)).norm() < 1e-9);
}
