//! What a fillet or a shape would make is what it makes.

use nalgebra::{Point3, Vector3};
use proptest::prelude::*;
use wirebend_core::units::{Angle, Length};
use wirebend_core::wireframe::{
    ChordLimits, Edit, EditError, FilletFault, FilletOutcome, Outcome, PolygonSize, ShapeOutcome, ShapePlane,
    VertexId, Wireframe,
};

fn mm(value: f64) -> Length {
    Length::from_mm(value).unwrap()
}

fn deg(value: f64) -> Angle {
    Angle::from_deg(value).unwrap()
}

/// A machine whose feeds are as designed.
fn designed(min_edge: f64) -> ChordLimits {
    ChordLimits { min_edge: mm(min_edge), ..ChordLimits::default() }
}

/// One that takes setback and arc off its feeds of at least 25 mm: the published bender with 3 mm wire.
fn kit() -> ChordLimits {
    ChordLimits {
        min_edge: mm(20.4),
        min_feed: mm(25.0),
        bend_radius: mm(3.0),
        neutral_radius: mm(2.7),
        ..ChordLimits::default()
    }
}

fn strand(through: &[[f64; 3]]) -> Wireframe {
    let mut w = Wireframe::new();
    let through = through.iter().copied().map(Point3::from).collect();
    w.apply(&Edit::Draw { from: None, through, to: None }).unwrap();
    w
}

/// Two corners of 90° and edges of 200 mm.
fn square() -> Wireframe {
    strand(&[[0., 0., 0.], [200., 0., 0.], [200., 200., 0.], [0., 200., 0.]])
}

fn fillet(vertices: &[u32], radius: f64, step: f64, limits: ChordLimits) -> Edit {
    let vertices = vertices.iter().copied().map(VertexId).collect();
    Edit::Fillet { vertices, radius: mm(radius), step: deg(step), limits }
}

fn of_fillet(edit: &Edit, w: &Wireframe) -> FilletOutcome {
    match edit.outcome(w, &ChordLimits::default()) {
        Ok(Some(Outcome::Fillet(outcome))) => outcome,
        other => panic!("{other:?}"),
    }
}

fn of_shape(edit: &Edit, limits: &ChordLimits) -> ShapeOutcome {
    match edit.outcome(&Wireframe::new(), limits) {
        Ok(Some(Outcome::Shape(outcome))) => outcome,
        other => panic!("{other:?}"),
    }
}

fn plane() -> ShapePlane {
    ShapePlane { centre: Point3::new(5., 6., 7.), u: Vector3::x_axis(), v: Vector3::z_axis() }
}

fn polygon(size: PolygonSize, sides: u32) -> Edit {
    Edit::AddPolygon { plane: plane(), sides, size, turn: deg(10.0) }
}

/// The lengths of the edges that an edit adds.
fn added(edit: &Edit, before: &Wireframe) -> Vec<f64> {
    let mut w = before.clone();
    w.apply(edit).unwrap();
    let at = |id: VertexId| w.vertex(id).unwrap().position;
    let new = w.edges().filter(|(id, _)| before.edge(*id).is_none());
    new.map(|(_, edge)| (at(edge.b) - at(edge.a)).norm()).collect()
}

fn least(lengths: &[f64]) -> f64 {
    lengths.iter().copied().fold(f64::INFINITY, f64::min)
}

fn any_limits() -> impl Strategy<Value = ChordLimits> {
    prop_oneof![Just(ChordLimits::default()), (1.0..30.0_f64).prop_map(designed), Just(kit())]
}

proptest! {
    /// So many chords, and so short; what is refused is refused alike, and the radius that is offered instead fits all corners.
    #[test]
    fn a_fillet_makes_what_was_told(
        turns in prop::collection::vec((20.0..160.0_f64, -60.0..60.0_f64, 60.0..300.0_f64), 2..5),
        radius in 2.0..150.0_f64, step in 5.0..60.0_f64, limits in any_limits()
    ) {
        let (mut at, mut way) = (Point3::origin(), Vector3::x());
        let mut through = vec![at];
        for (turn, roll, length) in turns {
            at += way * length;
            through.push(at);
            let across = nalgebra::Rotation3::new(way * roll.to_radians()) * way.cross(&Vector3::new(0.3, 0.5, 0.8));
            way = nalgebra::Rotation3::new(across.normalize() * turn.to_radians()) * way;
        }
        through.push(at + way * 100.0);
        let corners: Vec<u32> = (1..through.len() - 1).map(|k| u32::try_from(k).unwrap()).collect();
        let w = strand(&through.iter().map(|point| [point.x, point.y, point.z]).collect::<Vec<_>>());
        let edit = fillet(&corners, radius, step, limits);
        match edit.outcome(&w, &ChordLimits::default()) {
            Ok(Some(Outcome::Fillet(told))) => {
                let made = added(&edit, &w);
                prop_assert_eq!(told.chords.len(), corners.len());
                prop_assert_eq!(usize::try_from(told.chords.iter().sum::<u32>()).unwrap(), made.len());
                prop_assert!((told.shortest.mm() - least(&made)).abs() < 1e-6);
                prop_assert!(told.shortest.mm() >= told.needed.mm() - 1e-6);
                if let Some(clear) = told.clear {
                    let again = of_fillet(&fillet(&corners, clear.mm(), step, limits), &w);
                    prop_assert_eq!(again.clear, Some(clear));
                    prop_assert!(again.shortest.mm() >= 1.05 * limits.min_edge.mm());
                }
            }
            Err(EditError::Fillet { nearest, fault, length, min_edge, radius: asked, vertex }) => {
                let again = EditError::Fillet { nearest, fault, length, min_edge, radius: asked, vertex };
                prop_assert_eq!(w.clone().apply(&edit), Err(again));
                prop_assert!(length < min_edge || limits == ChordLimits::default());
                if let Some(nearest) = nearest {
                    prop_assert!(w.clone().apply(&fillet(&corners, nearest.mm(), step, limits)).is_ok());
                }
            }
            other => panic!("{other:?}"),
        }
    }

    /// So many edges, each so long; and the number that is offered can be made, while one more cannot.
    #[test]
    fn a_shape_has_the_edges_that_were_told(
        size in 2.0..200.0_f64, sides in 3..60_u32, kind in 0..4, turns in 0.1..4.0_f64, pitch in -80.0..80.0_f64,
        limits in any_limits()
    ) {
        let shape = |sides| match kind {
            0 => polygon(PolygonSize::Corners(mm(size)), sides),
            1 => polygon(PolygonSize::Flats(mm(size)), sides),
            2 => polygon(PolygonSize::Side(mm(size)), sides),
            _ => Edit::AddHelix { plane: plane(), radius: mm(size), pitch: mm(pitch), turns, sides, left: sides % 2 == 0 },
        };
        let told = of_shape(&shape(sides), &limits);
        let made = added(&shape(sides), &Wireframe::new());
        prop_assert_eq!(usize::try_from(told.edges).unwrap(), made.len());
        prop_assert!(made.iter().all(|length| (length - told.length.mm()).abs() < 1e-6));
        prop_assert_eq!(told.fits, told.length.mm() >= told.needed.mm() - 1e-6);
        prop_assert_eq!(told.fits, told.fitting == Some(sides));
        if let Some(fitting) = told.fitting.filter(|_| !told.fits) {
            prop_assert!(of_shape(&shape(fitting), &limits).fits);
            prop_assert!(!of_shape(&shape(fitting + 1), &limits).fits);
        }
    }
}

/// A quarter in steps of 15°: six chords of 2·100·sin 7.5° = 26.105 mm at each corner. Where 20 mm are needed a radius of 60 mm has
/// four of 2·60·sin 11.25° = 23.4 mm; five of 2·60·sin 9° would be 18.8 mm.
#[test]
fn a_fillet_has_as_many_chords_as_step_and_machine_allow() {
    let told = of_fillet(&fillet(&[1, 2], 100.0, 15.0, ChordLimits::default()), &square());
    assert_eq!((told.chords, told.needed), (vec![6, 6], mm(0.0)));
    assert!((told.shortest.mm() - 26.105).abs() < 1e-3);
    let told = of_fillet(&fillet(&[1], 60.0, 15.0, designed(20.0)), &square());
    assert_eq!((told.chords, told.needed), (vec![4], mm(20.0)));
}

/// Two chords of a quarter are 2·r·sin 22.5°: 7.654 mm at 10 mm, and 21 mm, of which no check warns where 20 mm are needed, from
/// 27.44 mm on. Of 200 mm between two corners a radius of 95 mm leaves 10 mm, one of less than 89.5 mm 21 mm, and one of 100 mm
/// nothing that could be too short.
#[test]
fn a_fillet_that_does_not_fit_says_what_is_too_short_and_the_nearest_radius() {
    let refused = |edit: Edit| match edit.outcome(&square(), &ChordLimits::default()) {
        Err(EditError::Fillet { fault, length, nearest, .. }) => {
            (fault, length.mm(), nearest.map(Length::mm))
        }
        other => panic!("{other:?}"),
    };
    let (fault, length, nearest) = refused(fillet(&[1], 10.0, 15.0, designed(20.0)));
    assert_eq!((fault, nearest), (FilletFault::Chords, Some(27.5)));
    assert!((length - 7.654).abs() < 1e-3);
    let (fault, length, nearest) = refused(fillet(&[1, 2], 95.0, 15.0, designed(20.0)));
    assert_eq!((fault, nearest), (FilletFault::Edges, Some(89.4)));
    assert!((length - 10.0).abs() < 1e-9);
    of_fillet(&fillet(&[1, 2], 100.0, 15.0, designed(20.0)), &square());
}

/// By 90° and by 36.9°, whose two chords of 21 mm need 21/(2·sin 9.2°) = 65.6 mm.
#[test]
fn the_nearest_radius_fits_all_corners_not_only_the_first() {
    let two = strand(&[[0., 0., 0.], [400., 0., 0.], [400., 400., 0.], [100., 800., 0.]]);
    let Err(EditError::Fillet { vertex, nearest, .. }) =
        fillet(&[1, 2], 10.0, 15.0, designed(20.0)).outcome(&two, &ChordLimits::default())
    else {
        panic!("too small")
    };
    assert_eq!((vertex, nearest), (VertexId(1), Some(mm(65.6))));
}

/// Of edges of 47 mm no radius leaves 21 mm beside two chords of 21 mm, which take 27.44 mm; 26.2 mm leave 20.8 mm beside chords of
/// 20.05 mm, which can be made.
#[test]
fn where_no_radius_keeps_clear_of_the_limits_one_that_can_be_made_is_offered() {
    let short = strand(&[[0., 0., 0.], [47., 0., 0.], [47., 47., 0.]]);
    let Err(EditError::Fillet { nearest, .. }) =
        fillet(&[1], 10.0, 15.0, designed(20.0)).outcome(&short, &ChordLimits::default())
    else {
        panic!("too small")
    };
    assert_eq!(nearest, Some(mm(26.2)));
    assert_eq!(of_fillet(&fillet(&[1], 26.2, 15.0, designed(20.0)), &short).clear, None);
}

/// What is offered is offered as something that is not warned of: a person takes it, and reads a warning at once.
#[test]
fn a_radius_near_a_limit_is_told_with_the_nearest_that_is_not() {
    let of = |radius: f64| of_fillet(&fillet(&[1], radius, 15.0, designed(20.0)), &square());
    assert_eq!(of(26.5).clear, Some(mm(27.5)));
    assert_eq!(of(27.5).clear, Some(mm(27.5)));
    // Three chords of 2·38.9·sin 15° = 20.14 mm could be made, and two of 29.8 mm are not warned of.
    assert_eq!((of(38.9).chords, of(38.9).clear), (vec![2], Some(mm(38.9))));
    // Of 200 mm 180 leave 20, as much as can be made.
    assert_eq!(of(179.5).clear, Some(mm(178.9)));
}

/// The kit feeds 25 mm at least: beside a sharp corner of 90°, which takes 3·tan 45° of the edge, and 3·tan 11.25° at the arc,
/// 25 + 3 + 0.6 − 2.7·0.39 = 27.5 mm have to be left, not 25.6 mm.
#[test]
fn what_is_left_of_an_edge_has_room_for_the_bend_at_its_other_end() {
    let hook = strand(&[[0., 0., 0.], [200., 0., 0.], [200., 100., 0.], [0., 100., 0.]]);
    let Err(EditError::Fillet { min_edge, fault: FilletFault::Edges, .. }) =
        fillet(&[1], 73.0, 15.0, kit()).outcome(&hook, &ChordLimits::default())
    else {
        panic!("27 mm are left")
    };
    assert!((min_edge.mm() - 27.54).abs() < 1e-2, "{min_edge:?}");
}

/// The feed of a chord between bends of 45° and, at its end, 22.5° is L − 3·(tan 22.5° + tan 11.25°) + 2.7·π/8 ≥ 25 mm; at the end of
/// the wire that of an edge behind a bend of 60° is L − 3·tan 30°.
#[test]
fn more_than_the_shortest_feed_is_needed_where_bends_take_wire_away() {
    let told = of_fillet(&fillet(&[1], 60.0, 45.0, kit()), &square());
    assert!((told.needed.mm() - 25.78).abs() < 5e-3, "{told:?}");
    let told = of_shape(&polygon(PolygonSize::Corners(mm(30.0)), 6), &kit());
    assert!((told.needed.mm() - 26.732).abs() < 1e-3, "{told:?}");
}

/// A circle of 30 mm has edges of 2·30·sin(180°/9) = 20.5 mm, and of 18.5 mm if there are ten.
#[test]
fn the_most_edges_that_fit_are_offered() {
    let told = of_shape(&polygon(PolygonSize::Corners(mm(30.0)), 12), &designed(20.0));
    assert_eq!((told.edges, told.fits, told.fitting), (12, false, Some(9)));
    let told = of_shape(&polygon(PolygonSize::Side(mm(12.0)), 12), &designed(20.0));
    assert_eq!((told.length, told.fitting), (mm(12.0), None));
}

/// Of two edges (−25, 43.3, 10) and (−50, 0, 10): the one is a side of the hexagon and rises by 10 mm.
#[test]
fn the_edges_of_a_helix_climb_with_less_of_a_bend_between_them() {
    let helix = Edit::AddHelix {
        plane: plane(),
        radius: mm(50.0),
        pitch: mm(60.0),
        turns: 3.0,
        sides: 6,
        left: false,
    };
    let told = of_shape(&helix, &kit());
    let bend = ((25.0_f64 * 50.0 + 100.0) / (50.0 * 50.0 + 100.0)).acos();
    assert!((told.length.mm() - 50.0_f64.hypot(10.0)).abs() < 1e-9);
    assert!((told.needed.mm() - (25.0 + 3.0 * (bend / 2.0).tan())).abs() < 1e-9);
}

#[test]
fn what_is_no_corner_is_refused_as_by_the_edit() {
    let told = |edit: &Edit, w: &Wireframe| edit.outcome(w, &ChordLimits::default());
    let edit = fillet(&[1], 50.0, 15.0, designed(20.0));
    let mut held = square();
    held.apply(&Edit::SetSupport { vertices: vec![VertexId(1)], support: true }).unwrap();
    let straight = strand(&[[0., 0., 0.], [100., 0., 0.], [200., 0., 0.]]);
    for mut w in [held, straight, Wireframe::new()] {
        assert_eq!(told(&edit, &w).unwrap_err(), w.apply(&edit).unwrap_err());
    }
    assert_eq!(told(&fillet(&[], 50.0, 15.0, designed(20.0)), &square()), Ok(None));
    assert_eq!(told(&Edit::Weld { tolerance: mm(1.0) }, &square()), Ok(None));
}
