//! Contacts of solids that move.

use nalgebra::{Isometry3, Point3, Vector3};
use proptest::prelude::*;
use wirebend_collide::{Chain, Interval, Parts, Solid, Task, closest, first_contact};

use crate::sampled::{self, Screw};

const TOLERANCE: f64 = 0.005;

/// The least sampled distance of a chain at a time, and what the exact one can be below.
fn at_time(chain: &Chain, solid: &Solid, motion: &Screw, time: f64) -> (f64, f64) {
    use wirebend_collide::Motion;
    let pose = motion.pose(time);
    let mut least = (f64::INFINITY, 0.0_f64);
    for index in 0..chain.pieces() {
        let ends = chain.piece(index).map(|end| pose * end);
        let piece = sampled::piece(solid, ends, 200);
        least = (least.0.min(piece.least), least.1.max(piece.step));
    }
    least
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(256))]

    #[test]
    fn the_first_contact_is_the_first_that_sampling_finds(
        points in sampled::points(2..12), solid in sampled::solid(), motion in sampled::screw(), reach in 0.5..4.0_f64,
    ) {
        use wirebend_collide::Motion;
        let chain = Chain::new(points);
        let task = Task {
            parts: &Parts::whole(&chain), solid: &solid, motion: &motion, reach, tolerance: TOLERANCE,
        };
        let found = first_contact(&task);
        let steps = 200;
        let times = (0..=steps).map(|k| f64::from(k) / f64::from(steps));
        let sampled = times.clone().find(|&time| at_time(&chain, &solid, &motion, time).0 <= reach);
        if let Some(time) = sampled {
            let found = found.expect("a contact that sampling finds");
            prop_assert!(found.time <= time + 1e-9, "{} after {time}", found.time);
        }
        if let Some(found) = found {
            let pose = motion.pose(found.time);
            let index = found.piece;
            let [from, to] = chain.piece(index).map(|end| pose * end);
            let part = (found.along - chain.interval(index).from) / (to - from).norm();
            let distance = sampled::distance(&solid, &(from + (to - from) * part));
            prop_assert!(distance <= reach + TOLERANCE + 1e-9, "a false contact at {distance}");
            prop_assert!((distance - found.distance).abs() < 1e-6);
        }
        let nearest = closest(&task, 0.0, 0.0);
        let least = times.map(|time| at_time(&chain, &solid, &motion, time).0).fold(f64::INFINITY, f64::min);
        match nearest {
            None => prop_assert!(least >= reach - 1e-9, "{least}"),
            Some(nearest) => {
                prop_assert!(nearest.distance <= least + 2.0 * TOLERANCE, "{} above {least}", nearest.distance);
                prop_assert!(at_time(&chain, &solid, &motion, nearest.time).0 >= nearest.distance - TOLERANCE);
            }
        }
    }

    #[test]
    fn parts_that_do_not_count_are_as_if_they_were_not_there(
        points in sampled::points(4..12), motion in sampled::screw(), solid in sampled::solid(),
    ) {
        let chain = Chain::new(points.clone());
        let [from, to] = [chain.along()[1], chain.along()[3]];
        let task = |parts| Task { parts, solid: &solid, motion: &motion, reach: 1.0, tolerance: TOLERANCE };
        let alone = Chain::new(points[1..4].to_vec());
        let some = Parts::of(&chain, vec![Interval { from, to }]);
        let (all, none) = (Parts::whole(&alone), Parts::of(&chain, Vec::new()));
        let (one, other) = (first_contact(&task(&some)), first_contact(&task(&all)));
        prop_assert_eq!(one.is_some(), other.is_some());
        if let (Some(one), Some(other)) = (one, other) {
            prop_assert!((one.time - other.time).abs() < 0.01);
        }
        prop_assert!(first_contact(&task(&none)).is_none());
    }
}

#[test]
fn a_chain_fed_against_a_wall_meets_it_where_it_is() {
    let chain = Chain::new(vec![Point3::origin(), Point3::new(-50.0, 0.0, 0.0)]);
    let wall = Solid::Box { half: Vector3::new(1.0, 50.0, 50.0) };
    let motion = Screw {
        begin: Isometry3::translation(-30.0, 0.0, 0.0),
        turn: Vector3::zeros(),
        shift: Vector3::new(100.0, 0.0, 0.0),
    };
    let parts = Parts::whole(&chain);
    let task = |reach| Task { parts: &parts, solid: &wall, motion: &motion, reach, tolerance: TOLERANCE };
    // Its front is 30 mm before the middle of a wall of 2 mm, and a wire of 3 mm reaches 1.5 mm ahead: 27.5 mm to go.
    let contact = first_contact(&task(1.5)).expect("the wall is in the way");
    assert!((contact.time - 0.275).abs() < 1e-4 && contact.piece == 0 && contact.along < 1e-6, "{contact:?}");
    // It goes through the middle: 1 mm deep, measured from the centreline.
    let deepest = closest(&task(1.5), 0.0, 0.0).expect("the wall is in the way");
    assert!((deepest.distance + 1.0).abs() < 2.0 * TOLERANCE, "{deepest:?}");
}

#[test]
fn a_chain_without_pieces_meets_nothing() {
    let solid = Solid::Capsule { radius: 100.0, half_length: 0.0 };
    let motion = Screw { begin: Isometry3::identity(), turn: Vector3::zeros(), shift: Vector3::zeros() };
    for points in [vec![], vec![Point3::origin()]] {
        let chain = Chain::new(points);
        let task = Task {
            parts: &Parts::whole(&chain),
            solid: &solid,
            motion: &motion,
            reach: 1.0,
            tolerance: TOLERANCE,
        };
        assert!(first_contact(&task).is_none() && closest(&task, 0.0, 0.0).is_none());
    }
}
