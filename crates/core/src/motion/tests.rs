use nalgebra::{Point3, Rotation3, UnitQuaternion, Vector3};
use proptest::prelude::*;

use super::*;
use crate::bend::{Frame, Step, program_of_path, replay};
use crate::estimate::StepSeconds;
use crate::schedule::{HeadLimits, schedule};
use crate::simulate::scheduled_start;
use crate::testing::{deg, mm};
use crate::units::Angle;

const NEAR: f64 = 1e-6;

fn step(feed: f64, rotate: f64, bend: f64) -> Step {
    Step { feed: mm(feed), rotate: deg(rotate), bend: deg(bend) }
}

/// The machine alone, with no look at the path: the wire that is out is pushed along +x, the head turns by -rotate about
/// +x, and the wire turns about the head's z by the bend. Ends of the straight parts, the one bent first in front, at the
/// end of the last feed.
fn bender(steps: &[Step]) -> Vec<Point3<f64>> {
    let mut out = vec![Point3::origin()];
    let mut head = 0.0;
    for (k, step) in steps.iter().enumerate() {
        for at in &mut out {
            at.x += step.feed.mm();
        }
        if k + 1 == steps.len() {
            break;
        }
        head -= step.rotate.rad();
        let z = Rotation3::from_axis_angle(&Vector3::x_axis(), head) * Vector3::z_axis();
        for at in &mut out {
            *at = Rotation3::from_axis_angle(&z, step.bend.rad()) * *at;
        }
        out.push(Point3::origin());
    }
    out.push(Point3::origin());
    out
}

/// The points of a path up to `end`, turned as the machine has them with that one at the bend point.
fn placed(path: &[Point3<f64>], end: usize, turn: UnitQuaternion<f64>) -> Vec<Point3<f64>> {
    path[..=end].iter().map(|at| Point3::from(turn * (at - path[end]))).collect()
}

fn assert_same(found: &[Point3<f64>], wanted: &[Point3<f64>]) {
    assert_eq!(found.len(), wanted.len());
    for (k, (found, wanted)) in found.iter().zip(wanted).enumerate() {
        assert!((found - wanted).norm() < NEAR, "point {k}: {found} instead of {wanted}");
    }
}

fn assert_same_turn(one: UnitQuaternion<f64>, other: UnitQuaternion<f64>) {
    assert!(one.angle_to(&other) < 1e-7, "{one} is not {other}");
}

/// A wire with the frame in which it begins: as its program makes it, and as it is scheduled.
type Case = (Vec<Point3<f64>>, Frame, Vec<Step>);

fn cases() -> Vec<Case> {
    let paths: [&[[f64; 3]]; 6] = [
        // The house, a wire in two planes, two mirror images, a part of a cube, a fold back.
        &[[0., 0., 97.], [35., 0., 60.], [35., 0., 0.], [-35., 0., 0.], [-35., 0., 60.], [0., 0., 97.]],
        &[[0., 0., 0.], [90., 0., 0.], [90., 120., 0.], [90., 120., 70.], [50., 120., 70.]],
        LEFT,
        RIGHT,
        &[
            [0., 0., 0.],
            [30., 0., 0.],
            [30., 30., 0.],
            [0., 30., 0.],
            [0., 30., 30.],
            [30., 30., 30.],
            [30., 0., 30.],
        ],
        &[[-40., 0., 0.], [0., 0., 0.], [0., -30., 0.], [0., 0., 0.], [40., 0., 0.]],
    ];
    paths.into_iter().flat_map(both).collect()
}

const LEFT: &[[f64; 3]] =
    &[[0., 0., 0.], [50., 0., 0.], [50., 40., 0.], [80., 40., 40.], [95., 85., 40.], [45., 85., 75.]];
const RIGHT: &[[f64; 3]] =
    &[[0., 0., 0.], [50., 0., 0.], [50., 40., 0.], [80., 40., -40.], [95., 85., -40.], [45., 85., -75.]];

fn both(path: &[[f64; 3]]) -> [Case; 2] {
    let path: Vec<Point3<f64>> = path.iter().copied().map(Point3::from).collect();
    let (start, nominal) = program_of_path(&path, deg(1e-9)).unwrap();
    let limits =
        HeadLimits { min: deg(-200.0), max: deg(200.0), seconds_per_degree: 1.0, seconds_per_turn: 0.0 };
    let scheduled = schedule(&nominal, &limits, |_| Some(1.0)).unwrap().steps;
    let begins = scheduled_start(start, &scheduled);
    [(path.clone(), start, nominal.steps), (path, begins, scheduled)]
}

#[test]
fn the_wire_is_where_a_bender_has_it_that_knows_only_the_steps() {
    for (path, start, steps) in cases() {
        for made in [poses(start, &steps), poses_of_points(&path, &start, &steps)] {
            assert_eq!(made.len(), steps.len());
            let end = made.last().unwrap().turn;
            assert_same(&placed(&path, steps.len(), end), &bender(&steps));
        }
    }
}

#[test]
fn the_fed_part_lies_on_the_axis_in_front_of_the_nozzle() {
    for (path, start, steps) in cases() {
        for made in [poses(start, &steps), poses_of_points(&path, &start, &steps)] {
            for (k, pose) in made.iter().enumerate() {
                let at = placed(&path, k + 1, pose.turn);
                assert_same(&at[k..], &[Point3::new(steps[k].feed.mm(), 0.0, 0.0), Point3::origin()]);
            }
        }
    }
}

#[test]
fn a_bend_turns_about_the_heads_axis_by_its_angle() {
    for (path, start, steps) in cases() {
        for made in [poses(start, &steps), poses_of_points(&path, &start, &steps)] {
            let mut head = Angle::ZERO;
            for (step, pose) in steps.iter().zip(&made).take(steps.len() - 1) {
                head -= step.rotate;
                let z = Rotation3::from_axis_angle(&Vector3::x_axis(), head.rad()) * Vector3::z_axis();
                let asked = UnitQuaternion::from_axis_angle(&z, step.bend.rad());
                assert_same_turn(asked * pose.turn, pose.turned(1.0));
            }
        }
    }
}

#[test]
fn mirror_images_are_kept_apart() {
    let [left, right] = [LEFT, RIGHT].map(|path| {
        let [(path, start, steps), _] = both(path);
        placed(&path, steps.len(), poses(start, &steps).last().unwrap().turn)
    });
    // The same lengths and angles, laid on each other at both ends of their last part.
    let apart = left.iter().zip(&right).map(|(a, b)| (a - b).norm()).fold(0.0, f64::max);
    assert!(apart > 1.0, "{apart}");
}

#[test]
fn a_wire_of_fewer_points_than_its_program_is_shown_as_far_as_it_goes() {
    let steps = [step(5.0, 0.0, 90.0), step(5.0, 0.0, 0.0)];
    let made = |points: &[[f64; 3]]| {
        let points: Vec<_> = points.iter().copied().map(Point3::from).collect();
        poses_of_points(&points, &Frame::default(), &steps).len()
    };
    assert_eq!([made(&[]), made(&[[0.; 3]]), made(&[[0.; 3], [0., 5., 0.]])], [0, 0, 1]);
}

#[test]
fn a_made_wire_bends_nowhere_else_and_goes_on_where_a_part_has_no_length() {
    let points = [[0., 0., 0.], [10., 0., 0.], [10., 0., 0.], [10., 0., 20.]].map(Point3::from);
    let steps = [10.0, 0.0, 20.0].map(|feed| step(feed, 0.0, 0.0));
    let bends = poses_of_points(&points, &Frame::default(), &steps);
    let bends: Vec<f64> = bends.iter().map(|pose| pose.bend.deg().round()).collect();
    assert_eq!(bends, [0.0, 90.0, 0.0]);
}

prop_compose! {
    fn any_step()(feed in 0.5..200.0_f64, rotate in -300.0..300.0_f64, size in 1.0..179.0_f64, left: bool) -> Step {
        step(feed, rotate, if left { size } else { -size })
    }
}

prop_compose! {
    fn any_start()(at in prop::array::uniform3(-100.0..100.0_f64), t in prop::array::uniform3(-1.0..1.0_f64),
        n in prop::array::uniform3(-1.0..1.0_f64)) -> Frame {
        Frame::looking(Point3::from(at), Vector3::from(t) + Vector3::x() * 2.0, Vector3::from(n)).unwrap()
    }
}

proptest! {
    #[test]
    fn any_program_ends_as_the_wire_that_it_makes(start in any_start(), steps in prop::collection::vec(any_step(), 1..30)) {
        let path = replay(start, &steps);
        let made = poses(start, &steps);
        assert_same(&placed(&path, steps.len(), made.last().unwrap().turn), &bender(&steps));
        // The same from the points alone.
        for (one, other) in made.iter().zip(poses_of_points(&path, &start, &steps)).take(steps.len() - 1) {
            for bent in [0.0, 0.4, 1.0] {
                assert_same_turn(one.turned(bent), other.turned(bent));
            }
        }
    }

    #[test]
    fn a_bend_keeps_what_is_out_as_it_is_and_ends_where_the_next_step_begins(
        start in any_start(), steps in prop::collection::vec(any_step(), 2..30), bent in 0.0..1.0_f64,
    ) {
        let path = replay(start, &steps);
        let made = poses(start, &steps);
        for (k, pose) in made.iter().enumerate() {
            let at = placed(&path, k + 1, pose.turned(bent));
            for (pair, step) in at.windows(2).zip(&steps) {
                prop_assert!(((pair[1] - pair[0]).norm() - step.feed.mm()).abs() < NEAR);
            }
            for (a, b) in at.iter().zip(&path) {
                // Nothing is bent but at the bend point.
                prop_assert!(((a - at[0]).norm() - (b - path[0]).norm()).abs() < NEAR);
            }
            prop_assert!((pose.turned(bent).norm() - 1.0).abs() < 1e-12);
            prop_assert!(at[k + 1].coords.norm() < NEAR);
            // The head is all that moves between a bend and the next feed.
            if let Some(next) = made.get(k + 1) {
                assert_same_turn(pose.turned(1.0), next.turn);
            }
        }
    }
}

/// 50 mm, 90°, a bend of 40° for which the axis goes to 52°.
fn machine_step(seconds: [f64; 4]) -> MachineStep {
    let [feed, rotate, bend, wait] = seconds;
    let seconds = StepSeconds { feed, rotate, bend, wait };
    let (designed, told) = (step(50.0, 90.0, 40.0), step(48.0, 90.0, 52.0));
    MachineStep { designed, told, comes_out: None, seconds }
}

/// Feed, rotation, bend, bend axis and peg at a part of the step's time, each from 0 to 1.
fn at(moments: &[Moment], time: f64) -> [f64; 5] {
    let k = moments.partition_point(|moment| moment.at < time).max(1).min(moments.len() - 1);
    let (from, to) = (moments[k - 1], moments[k]);
    let part = if to.at > from.at { (time - from.at) / (to.at - from.at) } else { 0.0 };
    let between = |of: fn(&Moment) -> f64| ((of(&from) + (of(&to) - of(&from)) * part) * 1e9).round() / 1e9;
    [
        between(|moment| moment.fed),
        between(|moment| moment.head.deg() / -90.0) + 0.0,
        between(|moment| moment.bent),
        between(|moment| moment.bend_axis.deg() / 52.0),
        between(|moment| moment.peg_out),
    ]
}

#[test]
fn a_step_of_ten_seconds_has_come_so_far() {
    let made = moments(&[machine_step([1.0, 2.0, 4.0, 3.0])]);
    // 1 s feed, 2 s rotate, 1.5 s the peg comes out, 2 s there, 2 s back, 1.5 s it goes in.
    for (seconds, wanted) in [
        (0.0, [0.0, 0.0, 0.0, 0.0, 0.0]),
        (0.5, [0.5, 0.0, 0.0, 0.0, 0.0]),
        (2.0, [1.0, 0.5, 0.0, 0.0, 0.0]),
        (3.0, [1.0, 1.0, 0.0, 0.0, 0.0]),
        (3.75, [1.0, 1.0, 0.0, 0.0, 0.5]),
        (4.5, [1.0, 1.0, 0.0, 0.0, 1.0]),
        (5.5, [1.0, 1.0, 0.5, 0.5, 1.0]),
        (6.5, [1.0, 1.0, 1.0, 1.0, 1.0]),
        (7.5, [1.0, 1.0, 1.0, 0.5, 1.0]),
        (8.5, [1.0, 1.0, 1.0, 0.0, 1.0]),
        (9.25, [1.0, 1.0, 1.0, 0.0, 0.5]),
        (10.0, [1.0, 1.0, 1.0, 0.0, 0.0]),
    ] {
        assert_eq!(at(&made[0], seconds / 10.0)[..], wanted, "after {seconds} s");
    }
}

/// It would come out within the wire at zero. Of the 3 s that it takes it is a quarter on the way, and a quarter comes out.
#[test]
fn the_bend_axis_is_beside_the_wire_when_the_peg_comes_out() {
    let step = MachineStep { comes_out: Some(deg(-26.0)), ..machine_step([1.0, 2.0, 4.0, 3.0]) };
    let made = moments(&[step]);
    for (seconds, wanted) in [
        (3.0, [1.0, 1.0, 0.0, 0.0, 0.0]),
        (3.375, [1.0, 1.0, 0.0, -0.25, 0.0]),
        (3.75, [1.0, 1.0, 0.0, -0.5, 0.0]),
        (4.125, [1.0, 1.0, 0.0, -0.5, 0.5]),
        (4.5, [1.0, 1.0, 0.0, -0.5, 1.0]),
        (5.5, [1.0, 1.0, 0.5, 0.25, 1.0]),
        (6.5, [1.0, 1.0, 1.0, 1.0, 1.0]),
        (8.5, [1.0, 1.0, 1.0, 0.0, 1.0]),
        (10.0, [1.0, 1.0, 1.0, 0.0, 0.0]),
    ] {
        assert_eq!(at(&made[0], seconds / 10.0)[..], wanted, "after {seconds} s");
    }
}

/// On its way to zero the peg would bend the wire on: it goes back to where it came out, goes in, and the axis returns without it.
#[test]
fn the_peg_goes_in_beside_the_wire_that_is_bent_before_zero() {
    let whole = machine_step([1.0, 2.0, 4.0, 3.0]);
    let told = Step { bend: deg(-10.4), ..whole.told };
    let made = moments(&[MachineStep { comes_out: Some(deg(-26.0)), told, ..whole }]);
    for (seconds, wanted) in [
        (4.5, [1.0, 1.0, 0.0, -0.5, 1.0]),
        (6.5, [1.0, 1.0, 1.0, -0.2, 1.0]),
        (8.5, [1.0, 1.0, 1.0, -0.5, 1.0]),
        (9.25, [1.0, 1.0, 1.0, -0.5, 0.0]),
        (10.0, [1.0, 1.0, 1.0, 0.0, 0.0]),
    ] {
        assert_eq!(at(&made[0], seconds / 10.0)[..], wanted, "after {seconds} s");
    }
}

#[test]
fn the_head_goes_on_from_where_the_step_before_has_left_it() {
    let steps = [machine_step([1.0, 2.0, 4.0, 3.0]), machine_step([1.0, 2.0, 4.0, 3.0])];
    let head: Vec<f64> = moments(&steps)[1].iter().map(|moment| moment.head.deg().round()).collect();
    assert_eq!((head[0], head[2], head.last()), (-90.0, -180.0, Some(&-180.0)));
}

#[test]
fn the_peg_stays_in_while_a_step_only_feeds_and_out_on_a_machine_that_never_waits_for_it() {
    let straight = MachineStep {
        designed: step(50.0, 0.0, 0.0),
        told: step(50.0, 0.0, 0.0),
        comes_out: None,
        seconds: StepSeconds { feed: 1.0, ..StepSeconds::default() },
    };
    let pegs = |steps: &[MachineStep]| -> Vec<f64> {
        moments(steps).last().unwrap().iter().map(|moment| moment.peg_out).collect()
    };
    assert!(pegs(&[machine_step([1.0, 2.0, 4.0, 3.0]), straight]).iter().all(|&out| out == 0.0));
    assert!(pegs(&[straight, machine_step([1.0, 2.0, 4.0, 0.0])]).iter().all(|&out| out > 0.999));
}

#[test]
fn parts_take_the_same_where_the_machine_tells_no_times_and_none_where_they_do_not_move() {
    let mut turned = machine_step([0.0; 4]);
    turned.designed.rotate = Angle::ZERO;
    assert_eq!(at(&moments(&[turned])[0], 0.5)[..3], [1.0, 0.0, 0.0]);
    let straight = MachineStep { designed: step(5.0, 0.0, 0.0), told: step(5.0, 0.0, 0.0), ..turned };
    let made = moments(&[straight]);
    assert!((at(&made[0], 0.5)[0] - 0.5).abs() < 1e-12);
    assert!(made[0].iter().all(|moment| moment.at.is_finite()) && made[0].last().unwrap().at > 0.999);
}
