//! A path and its program are the same thing: one gives the other back, with its handedness.

use nalgebra::{Isometry3, Point3, Vector3};
use proptest::prelude::*;
use wirebend_core::bend::{
    Frame, NominalProgram, PathError, Step, TangentError, intersection_lengths, program_of_path, replay,
    straight_lengths,
};
use wirebend_core::units::{Angle, Length};

fn deg(value: f64) -> Angle {
    Angle::from_deg(value).unwrap()
}

fn mm(value: f64) -> Length {
    Length::from_mm(value).unwrap()
}

fn points(coordinates: &[[f64; 3]]) -> Vec<Point3<f64>> {
    coordinates.iter().map(|&c| Point3::from(c)).collect()
}

fn program(path: &[Point3<f64>]) -> NominalProgram {
    program_of_path(path, deg(1e-9)).unwrap().1
}

fn rounded(program: &NominalProgram) -> Vec<(f64, f64, f64)> {
    let round = |value: f64| (value * 1e6).round() / 1e6 + 0.0;
    program.steps.iter().map(|s| (round(s.feed.mm()), round(s.rotate.deg()), round(s.bend.deg()))).collect()
}

#[test]
fn a_collinear_vertex_is_a_feed_continued_and_the_plane_is_carried_on() {
    let path = points(&[
        [0., 0., 0.],
        [10., 0., 0.],
        [10., 10., 0.],
        [10., 20., 0.],
        [10., 20., 10.],
        [10., 20., 30.],
    ]);
    let made = program(&path);
    assert_eq!(rounded(&made), [(10., 0., 90.), (20., 90., 90.), (30., 0., 0.)]);
    assert_eq!(made.spans, [0..1, 1..3, 3..5]);
}

#[test]
fn a_fold_back_keeps_the_plane() {
    let path = points(&[[0., 0., 0.], [10., 0., 0.], [10., 10., 0.], [10., 0., 0.], [10., 0., 5.]]);
    let made = program(&path);
    assert_eq!(rounded(&made)[..2], [(10., 0., 90.), (10., 0., 180.)]);
    // After the fold the wire runs along -y, its normal is -n: the plane of the next bend is -z.
    let (start, _) = program_of_path(&path, deg(1e-9)).unwrap();
    let again = replay(start, &made.steps);
    assert!((again[4] - path[4]).norm() < 1e-12);
}

#[test]
fn paths_without_a_direction_are_refused() {
    assert_eq!(program_of_path(&points(&[[0.; 3]]), deg(0.0)), Err(PathError::TooShort(1)));
    let still = points(&[[0., 0., 0.], [1., 0., 0.], [1., 0., 0.]]);
    assert_eq!(program_of_path(&still, deg(0.0)), Err(PathError::NoDirection(1)));
}

#[test]
fn a_straight_wire_is_one_feed() {
    let made = program(&points(&[[0., 0., 0.], [1., 1., 1.], [2., 2., 2.], [5., 5., 5.]]));
    assert_eq!(made.steps.len(), 1);
    assert_eq!(made.spans, [std::ops::Range { start: 0, end: 3 }]);
}

#[test]
fn the_published_tube_sample_comes_out_as_its_table_says() {
    // Corner points and centreline radius 560 of a tube in Creo's documentation, and its LRA table.
    let path = points(&[
        [0., 0., 0.],
        [0., 0., 1495.39],
        [0., 10100., 1495.39],
        [0., 10100., 3989.39],
        [5718.30, 10136.89, 3989.39],
    ]);
    let made = program(&path);
    let straight: Vec<_> = straight_lengths(&made.steps, mm(560.0)).into_iter().map(Option::unwrap).collect();
    let table = [(935.39, 0.0, 90.0), (8980.0, 180.0, 90.0), (1374.0, 90.37, 90.0), (5158.41, 0.0, 0.0)];
    for ((step, straight), (length, turn, bend)) in made.steps.iter().zip(&straight).zip(table) {
        assert!((straight.mm() - length).abs() < 0.011, "{straight:.3} for {length}");
        assert!((step.rotate.deg().abs() - turn).abs() < 0.01, "{:.3} for {turn}", step.rotate);
        assert!((step.bend.deg() - bend).abs() < 0.01, "{:.3} for {bend}", step.bend);
    }
    assert!(made.steps[2].rotate > Angle::ZERO, "the last plane is turned right-handed about the travel");
}

#[test]
fn arcs_that_overlap_leave_less_than_nothing() {
    let made = program(&points(&[[0., 0., 0.], [10., 0., 0.], [10., 4., 0.], [20., 4., 0.]]));
    // Right angles: each takes the radius off both of its sides.
    let straight: Vec<_> = straight_lengths(&made.steps, mm(3.0)).iter().map(|s| s.unwrap().mm()).collect();
    assert!(
        straight.iter().zip([7.0, -2.0, 7.0]).all(|(s, expected)| (s - expected).abs() < 1e-9),
        "{straight:?}"
    );
    let folded = [Step { feed: mm(5.0), bend: deg(180.0), ..Step::default() }];
    assert_eq!(straight_lengths(&folded, mm(3.0)), [None]);
    let refused = intersection_lengths(&folded, mm(3.0)).unwrap_err();
    assert!(matches!(refused, TangentError::NoCorner { step: 0, .. }));
    assert!(refused.to_string().starts_with("step 1: "), "{refused}");
}

fn any_path() -> impl Strategy<Value = Vec<Point3<f64>>> {
    let point = prop::array::uniform3(-500.0..500.0_f64).prop_map(Point3::from);
    prop::collection::vec(point, 2..60)
}

/// Paths on a coarse grid: full of straight joints and fold backs.
fn any_grid_path() -> impl Strategy<Value = Vec<Point3<f64>>> {
    prop::collection::vec((0..3_usize, prop::bool::ANY), 1..60).prop_map(|moves| {
        let mut path = vec![Point3::origin()];
        for (axis, forward) in moves {
            let mut next = path[path.len() - 1];
            next[axis] += if forward { 25.0 } else { -25.0 };
            path.push(next);
        }
        path
    })
}

/// The vertices of `path` at which a program bends or ends.
fn corners(path: &[Point3<f64>], program: &NominalProgram) -> Vec<Point3<f64>> {
    std::iter::once(path[0]).chain(program.spans.iter().map(|span| path[span.end])).collect()
}

proptest! {
    #[test]
    fn replay_gives_the_path_back(path in prop_oneof![any_path(), any_grid_path()]) {
        let (start, made) = program_of_path(&path, deg(1e-10)).unwrap();
        let total = made.length().mm();
        let again = replay(start, &made.steps);
        for (a, b) in corners(&path, &made).iter().zip(&again) {
            prop_assert!((a - b).norm() <= 1e-9 * total, "{:e}", (a - b).norm() / total);
        }
        for (k, step) in made.steps.iter().enumerate() {
            prop_assert!(step.bend >= Angle::ZERO && step.bend <= Angle::HALF_TURN);
            prop_assert!(step.rotate > -Angle::HALF_TURN && step.rotate <= Angle::HALF_TURN);
            prop_assert!(k > 0 || step.rotate == Angle::ZERO);
        }
    }

    #[test]
    fn mirror_images_differ_in_the_sign_of_their_turns_alone(path in any_path()) {
        let mirrored: Vec<_> = path.iter().map(|p| Point3::new(p.x, p.y, -p.z)).collect();
        let (one, other) = (program(&path), program(&mirrored));
        prop_assert_eq!(one.steps.len(), other.steps.len());
        for (a, b) in one.steps.iter().zip(&other.steps) {
            prop_assert!((a.feed.mm() - b.feed.mm()).abs() < 1e-9);
            prop_assert!((a.bend.rad() - b.bend.rad()).abs() < 1e-9);
            prop_assert!((a.rotate + b.rotate).wrapped().abs().rad() < 1e-6 || a.rotate.abs().deg() > 179.99);
        }
    }

    #[test]
    fn where_a_path_lies_does_not_matter(
        path in any_path(), by in prop::array::uniform3(-900.0..900.0_f64), turn in prop::array::uniform3(-3.0..3.0_f64),
    ) {
        let placed = Isometry3::new(Vector3::from(by), Vector3::from(turn));
        let moved: Vec<_> = path.iter().map(|p| placed * p).collect();
        let (one, other) = (program(&path), program(&moved));
        for (a, b) in one.steps.iter().zip(&other.steps) {
            prop_assert!((a.feed.mm() - b.feed.mm()).abs() < 1e-8);
            prop_assert!((a.bend.rad() - b.bend.rad()).abs() < 1e-6);
        }
    }

    #[test]
    fn tangent_and_corner_lengths_are_inverse(path in any_path(), radius in 0.1..3.0_f64) {
        let made = program(&path);
        if let Some(straight) = straight_lengths(&made.steps, mm(radius)).into_iter().collect::<Option<Vec<_>>>() {
            let steps: Vec<Step> = made.steps.iter().zip(&straight).map(|(s, &feed)| Step { feed, ..*s }).collect();
            let corner = intersection_lengths(&steps, mm(radius)).unwrap();
            for (a, b) in made.steps.iter().zip(&corner) {
                prop_assert!((a.feed.mm() - b.mm()).abs() < 2e-6);
            }
        }
    }

    #[test]
    fn bends_too_small_to_make_do_not_let_directions_drift(angles in prop::collection::vec(0.0..0.02_f64, 2..80)) {
        // A gentle curve of bends that all lie below what counts as straight.
        let mut path = vec![Point3::origin()];
        let mut heading: f64 = 0.0;
        for angle in angles {
            heading += f64::to_radians(angle);
            let last = path[path.len() - 1];
            path.push(last + Vector3::new(heading.cos(), heading.sin(), 0.0) * 30.0);
        }
        let (start, made) = program_of_path(&path, deg(0.02)).unwrap();
        let mut frame: Frame = start;
        for step in &made.steps {
            frame.rotate(step.rotate);
            frame.bend(step.bend);
        }
        let last = (path[path.len() - 1] - path[path.len() - 2]).normalize();
        prop_assert!(frame.t().angle(&last) <= f64::to_radians(0.0201));
    }
}
