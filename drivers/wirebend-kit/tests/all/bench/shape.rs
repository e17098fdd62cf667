//! Where the wire lies, and which hand it has.

use proptest::prelude::*;

use super::compensation::{ALL, Step, replay};
use super::hand::{Hand, published};
use wirebend_driver_wirebend_kit::bench::Made;

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
}

/// By hand: t = +x; the bend turns it to +y. A turn by +90 about +y takes b from +z to +x, and the second
/// bend takes t from +y to n = b × t = +z.
#[test]
fn a_turn_of_the_head_is_right_handed_about_the_way_from_tip_to_nozzle() {
    let mut hand = Hand::new(published());
    let step = |feed_mm, rotate_deg, bend_deg| Step { feed_mm, rotate_deg, bend_deg };
    ALL.run(&[step(50.0, 0.0, 90.0), step(50.0, 90.0, 90.0), step(50.0, 0.0, 0.0)], &mut hand);
    let corners = hand.bench.made().corners();
    let expected = [[0.0, 0.0, 0.0], [50.0, 0.0, 0.0], [50.0, 50.0, 0.0], [50.0, 50.0, 50.0]];
    assert_eq!(corners.len(), expected.len());
    for (corner, expected) in corners.iter().zip(expected) {
        assert!(distance(*corner, expected) < 0.5, "{corners:?}");
    }
}

/// A pin of no size and a wire that stays as it is bent would follow the turtle. This one is compared with
/// the turtle that makes the angles and edges that it came to.
fn turtle_of(made: &Made) -> Vec<[f64; 3]> {
    let corners = made.corners();
    let bends = made.bends();
    let mut before = 0.0;
    let steps = corners.windows(2).enumerate().map(|(i, pair)| {
        let bend = bends.get(i);
        let head = bend.map_or(before, |bend| bend.head_deg);
        let rotate_deg = head - std::mem::replace(&mut before, head);
        let bend_deg = bend.map_or(0.0, |bend| bend.angle_deg);
        Step { feed_mm: distance(pair[0], pair[1]), rotate_deg, bend_deg }
    });
    let steps: Vec<Step> = steps.collect();
    replay(&steps)
}

fn programs() -> impl Strategy<Value = Vec<Step>> {
    let bend = prop_oneof![20.0..130.0, -130.0..-20.0];
    // With legs that are straight as far as the peg reaches, as these commands take them to be.
    let step = (60.0..110.0, -180.0..180.0, bend);
    let step = step.prop_map(|(feed_mm, rotate_deg, bend_deg)| Step { feed_mm, rotate_deg, bend_deg });
    proptest::collection::vec(step, 1..6)
}

fn made(program: &[Step]) -> Made {
    let mut hand = Hand::new(published());
    ALL.run(program, &mut hand);
    hand.feed(30.0);
    assert_eq!(hand.bench.incidents(), []);
    hand.bench.made()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn the_wire_goes_where_the_turtle_goes(program in programs()) {
        let made = made(&program);
        let path = turtle_of(&made);
        for (corner, vertex) in made.corners().iter().zip(&path) {
            prop_assert!(distance(*corner, *vertex) < 1e-8, "{:?} {path:?}", made.corners());
        }
        for (bend, step) in made.bends().iter().zip(&program) {
            prop_assert!((bend.angle_deg - step.bend_deg).abs() < 1.0, "{bend:?} {step:?}");
        }
    }

    /// The mirror image in the plane of the head's zero: bends and turns the other way round.
    #[test]
    fn negative_bends_are_mirror_images(program in programs()) {
        let mirrored: Vec<Step> = program
            .iter()
            .map(|step| Step { rotate_deg: -step.rotate_deg, bend_deg: -step.bend_deg, ..*step })
            .collect();
        for (corner, other) in made(&program).corners().iter().zip(made(&mirrored).corners()) {
            prop_assert!(distance(*corner, [other[0], -other[1], other[2]]) < 1e-8);
        }
    }

    /// Every part of the drawn line is as long as the wire, and it ends where the corners end.
    #[test]
    fn the_drawn_line_is_the_wire(program in programs()) {
        let made = made(&program);
        let line = made.centreline(0.001);
        let length: f64 = line.windows(2).map(|pair| distance(pair[0], pair[1])).sum();
        // The centreline of an arc is longer than its neutral fibre by 0.6 mm for each radian.
        let turned: f64 = made.bends().iter().map(|bend| bend.angle_deg.abs().to_radians()).sum();
        prop_assert!((length - made.length_mm() - 0.6 * turned).abs() < 0.01 * (1.0 + turned));
        let corners = made.corners();
        prop_assert_eq!(line.first(), corners.first());
        prop_assert!(distance(line[line.len() - 1], corners[corners.len() - 1]) < 1e-9);
    }

    /// The middle of every chord is as near to the finest line as was asked for.
    #[test]
    fn a_drawn_arc_is_as_near_as_was_asked(tolerance in 0.01..0.5) {
        let step = |bend_deg| Step { feed_mm: 40.0, rotate_deg: 30.0, bend_deg };
        let made = made(&[step(90.0), step(-120.0)]);
        let fine = made.centreline(0.0);
        for pair in made.centreline(tolerance).windows(2) {
            let middle = [0, 1, 2].map(|i| f64::midpoint(pair[0][i], pair[1][i]));
            // Straights have points at their ends only: the ends of the chord count as well there.
            let near = fine.iter().map(|point| distance(*point, middle)).fold(f64::INFINITY, f64::min);
            let is_straight = distance(pair[0], pair[1]) > 8.0;
            prop_assert!(is_straight || near < tolerance + 0.05, "{near} > {tolerance}");
        }
    }
}

#[test]
fn a_wire_that_was_not_fed_is_a_point() {
    let made = published().made();
    assert_eq!(made.centreline(0.1), [[0.0; 3]]);
    assert_eq!(made.corners(), [[0.0; 3], [0.0; 3]]);
    assert_eq!(made.centreline(f64::NAN).len(), 1);
}
