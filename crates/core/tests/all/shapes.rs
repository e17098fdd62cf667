//! Shapes from a few figures, and corners that are rounded.

use nalgebra::{Point3, Vector3};
use proptest::prelude::*;
use wirebend_core::units::{Angle, Length};
use wirebend_core::wireframe::{
    ChordLimits, EdgeId, Edit, EditError, FilletFault, PolygonSize, ShapePlane, VertexId, Wireframe,
};

fn mm(value: f64) -> Length {
    Length::from_mm(value).unwrap()
}

fn deg(value: f64) -> Angle {
    Angle::from_deg(value).unwrap()
}

fn front(centre: [f64; 3]) -> ShapePlane {
    ShapePlane { centre: centre.into(), u: Vector3::x_axis(), v: Vector3::z_axis() }
}

fn at(w: &Wireframe, id: VertexId) -> Point3<f64> {
    w.vertex(id).unwrap().position
}

fn lengths(w: &Wireframe) -> Vec<f64> {
    w.edges().map(|(_, edge)| (at(w, edge.b) - at(w, edge.a)).norm()).collect()
}

fn drawn(edit: &Edit) -> Wireframe {
    let mut w = Wireframe::new();
    let delta = w.apply(edit).unwrap();
    let mut undone = w.clone();
    undone.commit(&delta.inverse()).unwrap();
    assert_eq!(undone, Wireframe::new());
    w
}

/// A hexagon has sides as long as its circle's radius; across its flats it is √3 of that.
#[test]
fn a_hexagon_is_the_same_by_corners_flats_and_sides() {
    let by = |size| drawn(&Edit::AddPolygon { plane: front([5., 6., 7.]), sides: 6, size, turn: deg(0.0) });
    let one = by(PolygonSize::Corners(mm(20.0)));
    assert_eq!((one.vertex_count(), one.edge_count()), (6, 6));
    assert!(lengths(&one).iter().all(|length| (length - 20.0).abs() < 1e-9));
    assert!((at(&one, VertexId(0)) - Point3::new(25., 6., 7.)).norm() < 1e-9);
    assert!((at(&one, VertexId(1)) - Point3::new(15., 6., 7. + 10.0 * 3.0_f64.sqrt())).norm() < 1e-9);
    for other in [by(PolygonSize::Flats(mm(10.0 * 3.0_f64.sqrt()))), by(PolygonSize::Side(mm(20.0)))] {
        let same = one.vertices().all(|(id, vertex)| (vertex.position - at(&other, id)).norm() < 1e-9);
        assert!(same, "{other:?}");
    }
    let size = PolygonSize::Corners(mm(20.0));
    let turned = drawn(&Edit::AddPolygon { plane: front([0.; 3]), sides: 4, size, turn: deg(90.0) });
    assert!((at(&turned, VertexId(0)) - Point3::new(0., 0., 20.)).norm() < 1e-9);
}

/// Twelve edges a turn for two and a half turns; the length of each is that of a chord and its part of the pitch.
#[test]
fn a_helix_winds_about_the_normal_as_far_as_its_turns() {
    let helix = |left| Edit::AddHelix {
        plane: ShapePlane { centre: Point3::origin(), u: Vector3::x_axis(), v: Vector3::y_axis() },
        radius: mm(15.0),
        pitch: mm(6.0),
        turns: 2.5,
        sides: 12,
        left,
    };
    let w = drawn(&helix(false));
    assert_eq!((w.vertex_count(), w.edge_count()), (31, 30));
    let expected = (2.0 * 15.0 * 15.0_f64.to_radians().sin()).hypot(0.5);
    assert!(lengths(&w).iter().all(|length| (length - expected).abs() < 1e-9));
    assert!((at(&w, VertexId(30)) - Point3::new(-15., 0., 15.)).norm() < 1e-9);
    assert!((at(&w, VertexId(3)) - Point3::new(0., 15., 1.5)).norm() < 1e-9);
    assert!((at(&drawn(&helix(true)), VertexId(3)) - Point3::new(0., -15., 1.5)).norm() < 1e-9);
}

#[test]
fn what_is_no_shape_is_refused() {
    let plane = front([0.; 3]);
    let polygon = |sides, size| Edit::AddPolygon { plane, sides, size, turn: deg(0.0) };
    let helix = |turns, sides, radius| Edit::AddHelix {
        plane,
        radius: mm(radius),
        pitch: mm(5.0),
        turns,
        sides,
        left: false,
    };
    for (edit, expected) in [
        (polygon(2, PolygonSize::Side(mm(5.0))), EditError::Sides { sides: 2, max: 10_000 }),
        (polygon(5, PolygonSize::Side(mm(0.0))), EditError::ShapeSize(0.0)),
        (helix(0.0, 12, 5.0), EditError::Turns(0.0)),
        (helix(1.0, 2, 5.0), EditError::Sides { sides: 2, max: 10_000 }),
        (helix(1.0, 12, -5.0), EditError::ShapeSize(-5.0)),
        (helix(1000.0, 10_000, 5.0), EditError::TooMuch { count: 10_000_000, max: 1_000_000 }),
    ] {
        assert_eq!(Wireframe::new().apply(&edit), Err(expected));
    }
    assert!(Wireframe::new().apply(&helix(f64::NAN, 12, 5.0)).is_err());
}

/// A corner of so many degrees between edges of two lengths, its vertex at the origin.
fn corner(between: f64, a: f64, b: f64) -> Wireframe {
    let (sin, cos) = between.to_radians().sin_cos();
    let through = vec![Point3::new(a, 0., 0.), Point3::origin(), Point3::new(b * cos, 0., b * sin)];
    let mut w = Wireframe::new();
    w.apply(&Edit::Draw { from: None, through, to: None }).unwrap();
    w
}

/// A machine that feeds edges as they are designed.
fn designed(min_edge: f64) -> ChordLimits {
    ChordLimits { min_edge: mm(min_edge), ..ChordLimits::default() }
}

fn fillet(radius: f64, step: f64, min_edge: f64) -> Edit {
    Edit::Fillet {
        vertices: vec![VertexId(1)],
        radius: mm(radius),
        step: deg(step),
        limits: designed(min_edge),
    }
}

/// The vertices from one end of a chain to the other.
fn walk(w: &Wireframe, from: VertexId) -> Vec<Point3<f64>> {
    let (mut last, mut found, mut used) = (from, vec![at(w, from)], Vec::<EdgeId>::new());
    while let Some((id, edge)) =
        w.edges().find(|(id, edge)| !used.contains(id) && (edge.a == last || edge.b == last))
    {
        last = if edge.a == last { edge.b } else { edge.a };
        used.push(id);
        found.push(at(w, last));
    }
    found
}

proptest! {
    /// Every vertex of the arc is as far from one centre as was typed, the arc touches both edges, and nothing is too short.
    #[test]
    fn a_fillet_has_the_typed_radius_and_no_edge_that_is_too_short(
        between in 20.0..160.0_f64, a in 30.0..200.0_f64, b in 30.0..200.0_f64, radius in 1.0..120.0_f64,
        step in 5.0..60.0_f64, min_edge in prop_oneof![Just(0.0), 1.0..25.0_f64]
    ) {
        let before = corner(between, a, b);
        let mut w = before.clone();
        let made = w.apply(&fillet(radius, step, min_edge));
        let Ok(delta) = made else {
            let Err(EditError::Fillet { nearest, fault, .. }) = made else { panic!("{made:?}") };
            if let Some(nearest) = nearest {
                // It can be made, and is on the right side of what was typed.
                prop_assert!((nearest.mm() > radius) == (fault == FilletFault::Chords));
                prop_assert!(w.apply(&fillet(nearest.mm(), step, min_edge)).is_ok(), "{}", nearest);
            }
            return Ok(());
        };
        let points = walk(&w, VertexId(0));
        let arc = &points[1..points.len() - 1];
        let half = (90.0 - between / 2.0).to_radians();
        let bisector = (points[0].coords.normalize() + points[points.len() - 1].coords.normalize()).normalize();
        let centre = Point3::from(bisector * (radius / half.cos()));
        for point in arc {
            prop_assert!(((point - centre).norm() - radius).abs() < 1e-6);
        }
        for (end, touching) in [(points[0], arc[0]), (points[points.len() - 1], arc[arc.len() - 1])] {
            prop_assert!((end - touching).dot(&(centre - touching)).abs() < 1e-6);
        }
        prop_assert!(arc.len() >= 3);
        prop_assert!(lengths(&w).iter().all(|&length| length >= min_edge - 1e-5), "{:?}", lengths(&w));
        w.commit(&delta.inverse()).unwrap();
        prop_assert_eq!(w, before);
    }
}

/// By hand: a quarter turn of radius 30 in two chords has chords of 60 sin 22.5° = 22.96 mm, in three of 15.5 mm,
/// which are near 15 mm and so warned of.
#[test]
fn a_quarter_has_as_many_chords_as_the_shortest_edge_allows() {
    for (min_edge, chords) in [(20.4, 2), (15.0, 2), (14.5, 3), (0.0, 6)] {
        let mut w = corner(90.0, 100.0, 80.0);
        w.apply(&fillet(30.0, 15.0, min_edge)).unwrap();
        assert_eq!(w.edge_count(), 2 + chords, "{min_edge}");
        let points = walk(&w, VertexId(0));
        assert!((points[1] - Point3::new(30., 0., 0.)).norm() < 1e-9);
        assert!((points[points.len() - 2] - Point3::new(0., 0., 30.)).norm() < 1e-9);
    }
}

/// Where 20.4 mm have to be left, 21.42 mm are warned of by no check: 21.42 / (2 sin 22.5°) = 27.99 mm, and one of 10 mm has chords of
/// 7.65 mm; an edge of 50 mm has 28.58 mm to give.
#[test]
fn a_radius_that_cannot_be_made_is_answered_with_the_nearest() {
    let refused = |radius, edge| corner(90.0, 100.0, edge).apply(&fillet(radius, 15.0, 20.4)).unwrap_err();
    for (radius, edge, fault, length, nearest) in [
        (10.0, 50.0, FilletFault::Chords, 20.0 * 22.5_f64.to_radians().sin(), Some(28.0)),
        (40.0, 50.0, FilletFault::Edges, 10.0, Some(28.5)),
        (27.0, 40.0, FilletFault::Edges, 13.0, None),
    ] {
        let EditError::Fillet { length: told, .. } = refused(radius, edge) else { panic!("{radius}") };
        assert!((told.mm() - length).abs() < 1e-9, "{radius}: {told}");
        let expected = EditError::Fillet {
            vertex: VertexId(1),
            radius: mm(radius),
            length: told,
            min_edge: mm(20.4),
            fault,
            nearest: nearest.map(mm),
        };
        assert_eq!(refused(radius, edge), expected);
    }
}

/// Two corners take from the edge between them together: of 100 mm twice 39.2 mm, so that 21.6 mm are left, of which no
/// check warns where 20.4 mm are needed.
#[test]
fn an_edge_between_two_corners_is_shortened_at_both_ends() {
    let through = [[0., 0., 0.], [0., 0., 100.], [100., 0., 100.], [100., 0., 0.]].map(Point3::from).to_vec();
    let mut w = drawn(&Edit::Draw { from: None, through, to: None });
    let both = |radius| Edit::Fillet {
        vertices: vec![VertexId(1), VertexId(2)],
        radius: mm(radius),
        step: deg(15.0),
        limits: designed(20.4),
    };
    let Err(EditError::Fillet { nearest, .. }) = w.apply(&both(45.0)) else { panic!("too large") };
    assert_eq!(nearest, Some(mm(39.2)));
    w.apply(&both(39.2)).unwrap();
    // In three chords 78.4 sin 15° = 20.3 mm are too short: there are two.
    assert_eq!(w.edge_count(), 7);
    assert!(lengths(&w).iter().any(|length| (length - 21.6).abs() < 1e-9));
}

/// Where the arc touches the very end of an edge nothing of it is left, and the chords begin at its vertex.
#[test]
fn an_arc_that_takes_up_an_edge_begins_at_its_vertex() {
    let mut w = corner(90.0, 30.0, 30.0);
    w.apply(&fillet(30.0, 30.0, 5.0)).unwrap();
    assert_eq!((w.vertex_count(), w.edge_count()), (4, 3));
    assert!(lengths(&w).iter().all(|length| (length - 60.0 * 15.0_f64.to_radians().sin()).abs() < 1e-9));
    assert_eq!((at(&w, VertexId(0)), walk(&w, VertexId(0)).len()), (Point3::new(30., 0., 0.), 4));
}

#[test]
fn what_is_no_corner_is_refused() {
    let straight = corner(180.0, 30.0, 30.0);
    let mut branched = corner(90.0, 50.0, 50.0);
    branched
        .apply(&Edit::Draw { from: Some(VertexId(1)), through: vec![Point3::new(0., 9., 0.)], to: None })
        .unwrap();
    let mut held = corner(90.0, 50.0, 50.0);
    held.apply(&Edit::SetSupport { vertices: vec![VertexId(1)], support: true }).unwrap();
    let cases = [
        (&straight, fillet(5.0, 15.0, 0.0), EditError::StraightCorner(VertexId(1))),
        (&branched, fillet(5.0, 15.0, 0.0), EditError::NoCorner { vertex: VertexId(1), edges: 3 }),
        (&held, fillet(5.0, 15.0, 0.0), EditError::HeldCorner(VertexId(1))),
        (&straight, fillet(0.0, 15.0, 0.0), EditError::FilletRadius(0.0)),
        (&straight, fillet(5.0, 0.0, 0.0), EditError::ArcStep(deg(0.0))),
    ];
    for (before, edit, expected) in cases {
        let mut w = before.clone();
        assert_eq!(w.apply(&edit), Err(expected));
        assert_eq!(&w, before);
    }
}
