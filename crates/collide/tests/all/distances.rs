//! Distances of pieces that stand still.

use nalgebra::{Isometry3, Point3, UnitQuaternion, Vector3};
use proptest::prelude::*;
use wirebend_collide::{Ring, Sector, Solid, between_pieces, close_pairs, to_solid};

use crate::sampled;

proptest! {
    #[test]
    fn a_piece_is_as_far_from_a_solid_as_its_nearest_point(ends in sampled::points(2), solid in sampled::solid()) {
        let near = to_solid([&ends[0], &ends[1]], &solid, 1e-6);
        let wanted = sampled::piece(&solid, [ends[0], ends[1]], 2000);
        prop_assert!(near.distance <= wanted.least + 1e-6, "{near:?} but {}", wanted.least);
        prop_assert!(near.distance >= wanted.least - wanted.step - 1e-6, "{near:?} but {}", wanted.least);
        let at = ends[0] + (ends[1] - ends[0]) * near.part;
        prop_assert!((sampled::distance(&solid, &at) - near.distance).abs() < 1e-9);
    }

    #[test]
    fn two_pieces_are_as_far_apart_as_capsules_of_no_thickness(ends in sampled::points(4)) {
        let [one, other] = [[ends[0], ends[1]], [ends[2], ends[3]]];
        let (distance, [s, t]) = between_pieces(&one, &other);
        let at = |[from, to]: [Point3<f64>; 2], part: f64| from + (to - from) * part;
        prop_assert!(((at(one, s) - at(other, t)).norm() - distance).abs() < 1e-9);
        let steps = 0..=60;
        let sampled = steps.clone().flat_map(|i| steps.clone().map(move |j| (i, j)));
        let least = sampled.map(|(i, j)| {
            (at(one, f64::from(i) / 60.0) - at(other, f64::from(j) / 60.0)).norm()
        });
        prop_assert!(least.fold(f64::INFINITY, f64::min) >= distance - 1e-9);
        // The same by the signed distance of a thin capsule.
        let half_length = (other[1] - other[0]).norm() / 2.0;
        let way = other[1] - other[0];
        let lie = nalgebra::UnitQuaternion::rotation_between(&nalgebra::Vector3::z(), &way);
        if let Some(lie) = lie {
            let place = nalgebra::Isometry3::from_parts(nalgebra::center(&other[0], &other[1]).into(), lie).inverse();
            let [a, b] = one.map(|end| place * end);
            let near = to_solid([&a, &b], &Solid::Capsule { radius: 0.0, half_length }, 1e-7);
            prop_assert!((near.distance - distance).abs() < 1e-5, "{} {distance}", near.distance);
        }
    }

    #[test]
    fn close_pairs_are_all_that_a_look_at_every_pair_finds(ends in sampled::points(0..80), reach in 0.1..15.0_f64) {
        let pieces: Vec<[Point3<f64>; 2]> = ends.chunks_exact(2).map(|pair| {
            [pair[0], pair[0] + (pair[1] - pair[0]) * 0.2]
        }).collect();
        let found: Vec<[usize; 2]> = close_pairs(&pieces, reach, usize::MAX, |[one, other]| one + 1 != other)
            .iter().map(|pair| pair.pieces).collect();
        let mut wanted = Vec::new();
        for one in 0..pieces.len() {
            for other in one + 2..pieces.len() {
                if between_pieces(&pieces[one], &pieces[other]).0 < reach {
                    wanted.push([one, other]);
                }
            }
        }
        prop_assert_eq!(&found, &wanted);
        // As many looks as there are pairs suffice, and with fewer only the last ones are missed.
        let pairs = pieces.len() * pieces.len().saturating_sub(1) / 2;
        for most in [pairs, pairs / 2] {
            let found = close_pairs(&pieces, reach, most, |[one, other]| one + 1 != other);
            let found: Vec<[usize; 2]> = found.iter().map(|pair| pair.pieces).collect();
            prop_assert!(most < pairs || found == wanted);
            let complete = found.last().map_or(0, |pair| pair[0]);
            prop_assert!(wanted.iter().take_while(|pair| pair[0] < complete).all(|pair| found.contains(pair)));
        }
    }
}

/// A design in metres that is read as one in millimetres: everything is within reach of everything.
#[test]
fn what_is_crowded_takes_no_longer_than_told() {
    let pieces: Vec<[Point3<f64>; 2]> = (0..1000)
        .map(|k| [Point3::new(f64::from(k) * 1e-4, 0.0, 0.0), Point3::new(f64::from(k) * 1e-4, 1.0, 0.0)])
        .collect();
    let looked = std::cell::Cell::new(0);
    let counts = |_| {
        looked.set(looked.get() + 1);
        true
    };
    assert_eq!(close_pairs(&pieces, 3.0, 5000, counts).len(), 5000);
    assert_eq!(looked.get(), 5000);
}

#[test]
fn pieces_without_length_and_parallel_ones_have_their_distances() {
    let point = [Point3::new(1.0, 2.0, 3.0); 2];
    let line = [Point3::new(-5.0, 2.0, 0.0), Point3::new(5.0, 2.0, 0.0)];
    let beside = [Point3::new(7.0, 2.0, 4.0), Point3::new(20.0, 2.0, 4.0)];
    for (one, other, wanted) in
        [(&point, &point, 0.0), (&point, &line, 3.0), (&line, &beside, 20.0_f64.sqrt()), (&line, &line, 0.0)]
    {
        let (distance, _) = between_pieces(one, other);
        assert!((distance - wanted).abs() < 1e-12, "{distance} instead of {wanted}");
    }
}

proptest! {
    /// A solid that is not all in its ring would be passed by.
    #[test]
    fn a_ring_holds_its_solid(
        solid in sampled::solid(), ends in sampled::points(2), lie in prop::array::uniform3(-3.0..3.0_f64),
    ) {
        let at = Isometry3::new(ends[0].coords, Vector3::from(lie));
        for axis in [Vector3::x_axis(), Vector3::z_axis()] {
            let ring = Ring::around(&solid, &at, &axis);
            let place = |point: &Point3<f64>| {
                let along = point.coords.dot(&axis);
                (along, point.coords - axis.into_inner() * along)
            };
            let (along, across) = place(&ends[1]);
            let apart = sampled::distance(&solid, &(at.inverse() * ends[1]));
            prop_assert!(ring.distance(along, across.norm()) <= apart + 1e-9);
            // All of the piece between them, as vectors across the axis.
            let flat = |point: &Point3<f64>| {
                let (along, across) = place(point);
                (along, if axis == Vector3::x_axis() { across.yz() } else { across.xy() })
            };
            let ends = [Point3::from(ends[1].coords * 0.5), ends[1]];
            let nearest = sampled::piece(&solid, ends.map(|end| at.inverse() * end), 200).least;
            prop_assert!(ring.distance_of_piece([flat(&ends[0]), flat(&ends[1])]) <= nearest + 1e-9);
        }
    }

    /// Likewise of a solid that turns out of the room that its walls leave it.
    #[test]
    fn walls_have_between_them_all_that_a_solid_sweeps(
        solid in sampled::solid(), ends in sampled::points(3), lie in prop::array::uniform3(-3.0..3.0_f64),
        from in -3.0..3.0_f64, turns in -4.0..4.0_f64, goes_through in any::<bool>(),
    ) {
        // A solid about the axis has no walls, and one whose end is on it has thick ones.
        let half_length = match solid {
            Solid::Box { .. } => 0.0,
            Solid::Cylinder { half_length, .. } | Solid::Capsule { half_length, .. } => half_length,
        };
        let mut at = Isometry3::new(ends[0].coords, Vector3::from(lie));
        if goes_through {
            at.translation = (at.rotation * Vector3::z() * half_length).into();
        }
        let sector = Sector::around(&solid, &at, [Vector3::x_axis(), Vector3::y_axis()]);
        let Some(walls) = sector.and_then(|sector| sector.swept([from, from + turns])) else { return Ok(()) };
        let [a, b] = [ends[1], ends[2]];
        for step in 0..=20 {
            let turned = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), from + turns * f64::from(step) / 20.0);
            let into_solid = (turned * at).inverse();
            prop_assert!(walls.distance(a.xy().coords) <= sampled::distance(&solid, &(into_solid * a)) + 1e-9);
            let nearest = sampled::piece(&solid, [into_solid * a, into_solid * b], 50).least;
            prop_assert!(walls.distance_of_piece([a.xy().coords, b.xy().coords]) <= nearest + 1e-9);
        }
    }
}

/// In a room of more than half a turn a point is nearer to the walls than it is deep in the solid.
#[test]
fn walls_that_leave_out_little_say_nothing_of_what_is_between_them() {
    let arm = Solid::Box { half: Vector3::new(35.0, 15.0, 9.0) };
    let at = Isometry3::translation(-62.0, 0.0, -30.0);
    let sector = Sector::around(&arm, &at, [Vector3::y_axis(), Vector3::z_axis()]).unwrap();
    for degrees in [150_u32, 200, 250, 260, 270, 280] {
        let turns = f64::from(degrees).to_radians();
        let walls = sector.swept([0.0, turns]).unwrap();
        for step in 0..=20 {
            let turned = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), turns * f64::from(step) / 20.0);
            for deep in [0.0, 2.0, 5.0, 8.5] {
                let point = turned * at * Point3::new(0.0, 0.0, deep);
                let apart = sampled::distance(&arm, &((turned * at).inverse() * point));
                assert!(walls.distance(point.yz().coords) <= apart + 1e-9, "{degrees} degrees, {deep} mm");
            }
        }
        // On the other side there is no room.
        let beside =
            UnitQuaternion::from_axis_angle(&Vector3::x_axis(), turns / 2.0) * Point3::new(0.0, 0.0, 30.0);
        assert!(walls.distance(beside.yz().coords) > 2.0, "{degrees} degrees");
    }
}
