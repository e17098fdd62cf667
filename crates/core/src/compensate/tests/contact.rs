//! The peg on wire that is bent within its reach.

use super::super::contact::{Beyond, FormedWire, Piece};
use super::super::shape::Shape;
use super::*;
use crate::schedule::ScheduledProgram;
use nalgebra::{Point2, Point3, Rotation3, Vector2, Vector3};

/// Bends in one plane or another, each after an edge of so many mm and a turn of the head, degrees.
pub(super) fn program(edges: &[(f64, f64, f64)]) -> ScheduledProgram {
    let step = |&(feed, rotate, bend)| Step { feed: mm(feed), rotate: deg(rotate), bend: deg(bend) };
    ScheduledProgram { steps: edges.iter().map(step).collect(), head: vec![Angle::ZERO; edges.len()] }
}

fn published_compensation() -> Compensation {
    Compensation {
        feed: Some(FeedModel::new(mm(1.5), mm(3.0), 0.3)),
        bend: published(),
        motion: MotionModel::default(),
    }
}

/// Where the peg goes for a bend of 30 degrees after one of 30 degrees to the same side or the other.
fn after_a_corner(edge: f64, before: f64) -> f64 {
    let program = program(&[(100.0, 0.0, before), (edge, 0.0, 30.0)]);
    compensate(&program, &published_compensation()).unwrap().steps()[1].bend.deg()
}

#[test]
fn a_corner_within_reach_moves_the_place_that_the_peg_touches() {
    // By marching along the wire and round the orbit, outside of this program.
    assert!((after_a_corner(20.4, 30.0) - 56.726).abs() < 1e-3, "{}", after_a_corner(20.4, 30.0));
    assert!((after_a_corner(25.0, -30.0) - 39.289).abs() < 1e-3, "{}", after_a_corner(25.0, -30.0));
    // What a straight leg needs, whichever way the corner goes, once it is out of reach.
    for before in [30.0, -30.0] {
        assert!((after_a_corner(45.0, before) - 46.889).abs() < 1e-3);
    }
}

/// The peg must not come out into wire that was bent towards it, nor on the far side of it. The places are found by marching along
/// the wire, outside of this program.
#[test]
fn the_peg_comes_out_clear_of_wire_that_is_bent_towards_it() {
    let approach = |edge: f64, before: f64, bend: f64| {
        let program = program(&[(100.0, 0.0, before), (edge, 0.0, bend)]);
        let compensation = published_compensation();
        let told = compensate(&program, &compensation).unwrap();
        let commands: Vec<ToldStep> = told.told().collect();
        let found = approaches(&commands, &compensation)[1];
        // A job that is read again has it alike, and both say how much farther that is.
        let on_straight = Angle::computed(-bend.signum() * f64::to_radians(18.25));
        for program in [&told, &CompensatedProgram::from_job_steps(told.told(), &compensation)] {
            let at = program.peg_comes_out(1).expect("it bends");
            assert!((at - found.unwrap_or(on_straight)).abs().deg() < 0.01, "{at}, {found:?}");
            let further = found.map_or(0.0, |at| at.abs().deg() - 18.25);
            assert!((program.peg_detour(1).deg() - further).abs() < 0.01, "{}", program.peg_detour(1));
        }
        found
    };
    for (before, bend) in [(-30.0, 30.0), (30.0, -30.0)] {
        let at = approach(25.0, before, bend).expect("another place");
        assert!(at.signum() * bend < 0.0, "on the side from which it bends: {at}");
        // The leg is so long at the pin; what is beyond goes the other way from there.
        let leg = 25.0 - 2.0 * 3.0 * 15.0_f64.to_radians().tan();
        let leg = leg + 0.0_f64.max(bend.abs().to_radians() * 2.4);
        let points = marched(0.0, leg, &[(0.0, -30.0, 60.0)], 13.0);
        let gap = |deg: f64| {
            let axis = deg.to_radians();
            let peg = Point2::new(12.0 + 20.4 * axis.cos(), 20.4 * axis.sin());
            points.iter().map(|point| (point - peg).norm()).fold(f64::INFINITY, f64::min) - 4.675
        };
        assert!(gap(-at.abs().deg()) > 0.5, "it comes out into the wire: {at}");
        assert!(gap(-18.25) < 0.0, "where it comes out for straight wire there is wire");
    }
    // Bent out of its way, out of its reach, or straight: the machine's own place.
    for (edge, before) in [(25.0, 30.0), (45.0, -30.0)] {
        assert_eq!(approach(edge, before, 30.0), None, "{edge} {before}");
    }
}

#[test]
fn an_arc_at_the_pin_is_touched_later_than_a_straight_leg() {
    let centre = Point2::new(0.0, 30.0);
    let shape = Shape::Arc { centre, radius: 30.0, begin: -std::f64::consts::FRAC_PI_2, sweep: 3.0 };
    let arc = Beyond(vec![Piece { shape, past_other: false }]);
    for (pressed, straight, expected) in [(0.0, -13.248, 33.079), (15.23, 10.653, 50.636)] {
        let axis = |beyond: &Beyond| {
            published_peg().touch(f64::to_radians(pressed), 0.0, beyond).unwrap().axis.to_degrees()
        };
        assert!((axis(&Beyond::default()) - straight).abs() < 1e-3);
        assert!((axis(&arc) - expected).abs() < 1e-3, "{} for {pressed}", axis(&arc));
    }
}

#[test]
fn small_bends_one_after_the_other_need_more_and_more_until_the_reach_is_full() {
    // A quarter of a circle of 50 mm in 12 bends, each axis by marching outside of this program.
    let side = 6.1611 + 6.0 * 3.75_f64.to_radians().tan();
    let mut edges = vec![(side, 0.0, 7.5); 12];
    edges[0].0 = 60.0;
    let told = compensate(&program(&edges), &published_compensation()).unwrap();
    let axes: Vec<f64> = told.steps().iter().map(|step| step.bend.deg()).collect();
    for (axis, expected) in axes.iter().zip([14.461, 23.403, 29.746, 33.499, 34.657, 34.657, 34.657]) {
        assert!((axis - expected).abs() < 2e-3, "{axes:?}");
    }
}

/// Points along a wire that is pressed on the pin, as far as a peg of `half` mm to either side reaches: nothing of this is in the
/// formula. Each corner with its turn of the head, its bend and the straight wire behind it, degrees and mm.
fn marched(pressed: f64, leg: f64, corners: &[(f64, f64, f64)], half: f64) -> Vec<Point2<f64>> {
    let radius = 3.0;
    let mut at = Point3::new(radius * pressed.sin(), radius * (1.0 - pressed.cos()), 0.0);
    let mut axes = Rotation3::from_axis_angle(&Vector3::z_axis(), pressed);
    let mut points = Vec::new();
    let mut go = |length: f64, turn: f64, axes: &mut Rotation3<f64>| {
        let parts = (length / 0.05).ceil().max(1.0);
        let half_turn = Rotation3::from_axis_angle(&Vector3::z_axis(), turn / parts / 2.0);
        let mut part = 0.0;
        while part < parts {
            *axes *= half_turn;
            at += *axes * Vector3::x() * (length / parts);
            *axes *= half_turn;
            if at.z.abs() <= half {
                points.push(at.xy());
            }
            part += 1.0;
        }
    };
    go(leg, 0.0, &mut axes);
    for &(rotate, turn, straight) in corners {
        axes *= Rotation3::from_axis_angle(&Vector3::x_axis(), rotate.to_radians());
        go(radius * turn.to_radians().abs(), turn.to_radians(), &mut axes);
        go(straight, 0.0, &mut axes);
    }
    points
}

/// A wire that is pressed so far, degrees, in points a hundredth of a millimetre apart: pieces of so many mm that turn by so many
/// degrees, from the pin on.
fn laid(pressed: f64, pieces: &[(f64, f64)]) -> Vec<Point2<f64>> {
    let mut towards = pressed.to_radians();
    let mut at = Point2::new(3.0 * towards.sin(), 3.0 * (1.0 - towards.cos()));
    let mut points = vec![at];
    for &(length, turn) in pieces {
        let parts = (length / 0.01).ceil().max(1.0);
        let half_turn = turn.to_radians() / parts / 2.0;
        let mut part = 0.0;
        while part < parts {
            towards += half_turn;
            at += Vector2::new(towards.cos(), towards.sin()) * (length / parts);
            towards += half_turn;
            points.push(at);
            part += 1.0;
        }
    }
    points
}

/// Where the peg, which comes from beside the pin, first is as near to a point as it gets, degrees.
fn first_touched(points: &[Point2<f64>]) -> f64 {
    let gap = |axis: f64| {
        let peg = Point2::new(12.0 + 20.4 * axis.cos(), 20.4 * axis.sin());
        points.iter().map(|point| (point - peg).norm_squared()).fold(f64::INFINITY, f64::min).sqrt() - 4.675
    };
    let mut clear = f64::to_radians(-80.0);
    assert!(gap(clear) > 0.0, "it begins in the wire");
    while gap(clear + 0.01) > 0.0 {
        clear += 0.01;
    }
    let mut touching = clear + 0.01;
    for _ in 0..30 {
        let middle = f64::midpoint(clear, touching);
        if gap(middle) > 0.0 {
            clear = middle;
        } else {
            touching = middle;
        }
    }
    clear.to_degrees()
}

/// The figures of the formulas above, by a peg that is moved past points of the wire: no equation of contact is in it.
#[test]
fn moving_the_peg_past_points_of_the_wire_finds_the_same_places() {
    let corner = 3.0 * 15.0_f64.to_radians().tan();
    let bent = |edge: f64, turn: f64| {
        vec![(edge - 2.0 * corner, 0.0), (3.0 * f64::abs(turn).to_radians(), turn), (80.0, 0.0)]
    };
    let ring = vec![(30.0 * 170.0_f64.to_radians(), 170.0)];
    let straight = vec![(80.0, 0.0)];
    let mut rows = vec![
        (0.0, straight.clone(), -13.248, 1e-3),
        (15.23, straight.clone(), 10.653, 1e-3),
        (40.23, straight, 46.889, 1e-3),
        (0.0, ring.clone(), 33.079, 1e-3),
        (15.23, ring, 50.636, 1e-3),
        (40.23, bent(20.4, 30.0), 56.726, 1e-3),
        (40.23, bent(25.0, -30.0), 39.289, 1e-3),
    ];
    // The quarter of a circle of 50 mm, after so many of its bends.
    for (before, axis) in [14.461, 23.403, 29.746, 33.499, 34.657, 34.657].into_iter().enumerate() {
        let arcs = (0..before).flat_map(|_| [(6.1611, 0.0), (3.0 * 7.5_f64.to_radians(), 7.5)]);
        rows.push((17.73, arcs.chain([(60.0, 0.0)]).collect(), axis, 2e-3));
    }
    for (pressed, pieces, axis, within) in rows {
        let found = first_touched(&laid(pressed, &pieces));
        assert!((found - axis).abs() < within, "{found} for {axis}: {pieces:?}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(32))]

    /// The peg comes no nearer to the wire than it may on its way, and touches it there.
    #[test]
    fn the_peg_touches_there_and_nowhere_before(
        pressed in 5.0..100.0_f64,
        leg in 14.0..34.0_f64,
        mut corners in prop::collection::vec((-180.0..180.0_f64, -70.0..70.0_f64, 8.0..25.0_f64), 1..3),
        flat in any::<bool>(),
        half in 1.0..13.0_f64,
    ) {
        let peg = published_peg().with_peg_length(mm(2.0 * half));
        if flat {
            for corner in &mut corners {
                corner.0 = 0.0;
            }
        }
        let last = corners.len() - 1;
        corners[last].2 = 100.0;
        let mut wire = FormedWire::new(&peg);
        // From its tip on: what turns the head before a bend is told with that bend's own step.
        let mut rotate = 0.0;
        for &(next, turn, straight) in corners.iter().rev() {
            wire.push(straight, deg(rotate), deg(turn));
            rotate = next;
        }
        let beyond = wire.beyond(deg(rotate), 1.0, leg);
        let points = marched(pressed.to_radians(), leg, &corners, half);
        let gap = |axis: f64| {
            let peg = Point2::new(12.0 + 20.4 * axis.cos(), 20.4 * axis.sin());
            points.iter().map(|point| (point - peg).norm()).fold(f64::INFINITY, f64::min) - 4.675
        };
        prop_assume!(gap(-1.75) > 0.0);
        let touch = peg.touch(pressed.to_radians(), leg, &beyond);
        let end = touch.map_or(3.1, |touch| touch.axis);
        let mut axis = -1.75;
        while axis < end - 2e-3 {
            prop_assert!(gap(axis) > -0.06, "{} at {}", gap(axis), axis.to_degrees());
            axis += 0.02;
        }
        if let Ok(approach) = peg.approach(leg, &beyond) {
            let points = marched(0.0, leg, &corners, half);
            let clear = |axis: f64| {
                let peg = Point2::new(12.0 + 20.4 * axis.cos(), 20.4 * axis.sin());
                points.iter().map(|point| (point - peg).norm()).fold(f64::INFINITY, f64::min) - 4.675 > -0.06
            };
            let at = approach.unwrap_or(f64::to_radians(-18.25));
            prop_assert!(clear(at), "the peg comes out into the wire at {}", at.to_degrees());
        }
        if touch.is_some() {
            prop_assert!(gap(end).abs() < 0.06, "gap {} at {}", gap(end), end.to_degrees());
        }
    }

    /// Commands leave the bends that they are for.
    #[test]
    fn commands_leave_what_they_are_for(
        bends in prop::collection::vec((22.0..45.0_f64, -180.0..180.0_f64, 12.0..80.0_f64, any::<bool>()), 1..12),
    ) {
        let edges: Vec<_> = bends
            .iter()
            .map(|&(edge, rotate, bend, left)| (edge, rotate, if left { bend } else { -bend }))
            .collect();
        let program = program(&edges);
        let compensation = published_compensation();
        if let Ok(told) = compensate(&program, &compensation)
            && told.unpressed().is_empty()
        {
            let commands: Vec<ToldStep> = told.told().collect();
            let left = results(&commands, &compensation);
            for (left, step) in left.iter().zip(&program.steps) {
                prop_assert!((left.deg() - step.bend.deg()).abs() < 1e-6, "{left} for {}", step.bend);
            }
        }
    }

    /// What lies beyond the peg's reach changes nothing.
    #[test]
    fn a_corner_out_of_reach_changes_nothing(before in -150.0..150.0_f64, bend in 12.0..140.0_f64) {
        let program = program(&[(300.0, 0.0, before), (250.0, 0.0, bend)]);
        if let Ok(told) = compensate(&program, &published_compensation()) {
            let straight = published().command(deg(bend)).unwrap();
            prop_assert!((told.steps()[1].bend.deg() - straight.deg()).abs() < 1e-12);
            prop_assert!(told.near_corners().is_empty());
        }
    }
}
