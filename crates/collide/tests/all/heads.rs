//! A head carried along a line, against sampling.

use nalgebra::{Point3, UnitVector3, Vector3};
use proptest::prelude::*;
use wirebend_collide::{DirectionSet, Head, HeadError, Passage};

/// The head of FrameFab: a cone of 30° to each side, 20 mm high, then a cylinder.
const OUTLINE: [[f64; 2]; 3] = [[0.0, 0.0], [20.0, 11.547], [100.0, 11.547]];

/// How deep a point is inside the head, by the nearest of its surfaces; none outside.
fn depth(from_tip: &Vector3<f64>, axis: &Vector3<f64>) -> Option<f64> {
    let z = from_tip.dot(axis);
    let rho = from_tip.cross(axis).norm();
    let angle = 11.547_f64.atan2(20.0);
    let depths = [z * angle.sin() - rho * angle.cos(), 11.547 - rho, z, 100.0 - z];
    Some(depths.into_iter().fold(f64::INFINITY, f64::min)).filter(|depth| *depth > 0.0)
}

fn direction() -> impl Strategy<Value = UnitVector3<f64>> {
    prop::array::uniform3(-1.0..1.0_f64)
        .prop_filter_map("no direction", |v| UnitVector3::try_new(Vector3::from(v), 0.1))
}

fn points(count: usize) -> impl Strategy<Value = Vec<Point3<f64>>> {
    prop::collection::vec(prop::array::uniform3(-60.0..60.0_f64).prop_map(Point3::from), count)
}

proptest! {
    #[test]
    fn a_head_meets_what_a_dense_look_finds_inside_it(
        ends in points(4), axes in prop::collection::vec(direction(), 6), shared: bool,
    ) {
        let head = Head::new(&OUTLINE).unwrap();
        let [from, to, begin, end] = [ends[0], ends[1], if shared { ends[1] } else { ends[2] }, ends[3]];
        let passage = Passage { motion: [&from, &to], piece: [&begin, &end], limit: -0.1, tolerance: 0.001 };
        let met = head.meets(&passage, &axes, DirectionSet::first(axes.len()));
        for (k, axis) in axes.iter().enumerate() {
            let deepest = (0..=120).flat_map(|i| (0..=120).map(move |j| (f64::from(i) / 120.0, f64::from(j) / 120.0)))
                .filter_map(|(s, t)| depth(&(begin + (end - begin) * t - (from + (to - from) * s)), axis))
                .fold(0.0, f64::max);
            // Between two samples a point is no deeper than half a step of both.
            let between = ((to - from).norm() + (end - begin).norm()) / 240.0;
            if met.contains(k) {
                prop_assert!(deepest + between > 0.1, "{k} is met, but no deeper than {deepest}");
            } else {
                prop_assert!(deepest <= 0.1 + 0.001, "{k} is free, but {deepest} deep");
            }
        }
    }

    #[test]
    fn directions_together_are_as_each_alone_and_a_motion_is_as_its_reverse(
        ends in points(4), axes in prop::collection::vec(direction(), 20), limit in -0.5..2.0_f64,
    ) {
        let head = Head::new(&OUTLINE).unwrap();
        let look = |motion, piece, asked| {
            head.meets(&Passage { motion, piece, limit, tolerance: 1e-6 }, &axes, asked)
        };
        let all = look([&ends[0], &ends[1]], [&ends[2], &ends[3]], DirectionSet::first(20));
        let alone: DirectionSet = (0..20)
            .filter(|&k| !look([&ends[0], &ends[1]], [&ends[2], &ends[3]], std::iter::once(k).collect()).is_empty())
            .collect();
        prop_assert_eq!(all, alone);
        let back = look([&ends[1], &ends[0]], [&ends[3], &ends[2]], DirectionSet::first(20));
        prop_assert_eq!(all, back);
    }

    /// Outside, the bound may be less than the distance, never more: a strut that is too near is never passed by.
    #[test]
    fn a_point_is_no_nearer_than_the_bound(at in prop::array::uniform3(-150.0..150.0_f64), axis in direction()) {
        let head = Head::new(&OUTLINE).unwrap();
        let at = Vector3::from(at);
        let (z, rho) = (at.dot(&axis), at.cross(&axis).norm());
        let nearest = OUTLINE.windows(2).flat_map(|ends| (0..=400).map(move |k| {
            let part = f64::from(k) / 400.0;
            let [a, b] = [ends[0], ends[1]];
            (a[0] + (b[0] - a[0]) * part - z).hypot(a[1] + (b[1] - a[1]) * part - rho)
        })).chain(std::iter::once((z - 100.0).hypot((rho - 11.547).max(0.0)))).fold(f64::INFINITY, f64::min);
        let bound = head.min_distance(&at, &axis);
        prop_assert_eq!(depth(&at, &axis).is_some(), bound < 0.0);
        prop_assert!(bound <= nearest + 1e-9);
    }
}

#[test]
fn an_outline_that_is_none_is_refused_with_its_point() {
    for (outline, wanted) in [
        (&[[0.0, 1.0]][..], HeadError::TooFew(1)),
        (&[[1.0, 1.0], [2.0, 1.0]], HeadError::Tip(1.0)),
        (&[[0.0, 1.0], [0.0, 2.0]], HeadError::Point(1)),
        (&[[0.0, 1.0], [5.0, -2.0]], HeadError::Point(1)),
        (&[[0.0, 0.0], [5.0, 0.0]], HeadError::Point(1)),
        (&[[0.0, 0.0], [5.0, f64::NAN]], HeadError::Point(1)),
        (&[[0.0, 3.0], [5.0, 1.0], [9.0, 2.0]], HeadError::Hollow(1)),
    ] {
        assert_eq!(Head::new(outline), Err(wanted), "{outline:?}");
    }
}

#[test]
fn a_set_of_directions_is_a_set() {
    let mut set: DirectionSet = [3, 64, 191, 500].into_iter().collect();
    assert_eq!(set.iter().collect::<Vec<_>>(), [3, 64, 191], "what is beyond the capacity is left out");
    set.remove(64);
    assert_eq!((set.len(), set.contains(64), set.contains(3)), (2, false, true));
    let low = DirectionSet::first(4);
    assert_eq!((set.and(low).len(), set.or(low).len(), set.without(low).len()), (1, 5, 1));
}
