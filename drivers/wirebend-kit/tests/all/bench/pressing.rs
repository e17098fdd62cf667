//! Bends on bends, wire that is drawn back, and wire that is too short.

use proptest::prelude::*;
use wirebend_driver_wirebend_kit::bench::{Bender, Compliance, MadeBend, ModelWarning, Peg};

use super::hand::{Hand, on, published};

fn bends(run: impl FnOnce(&mut Hand) -> &mut Hand) -> Vec<MadeBend> {
    let mut hand = Hand::new(published());
    run(&mut hand);
    hand.bench.made().bends()
}

fn close(found: f64, expected: f64) {
    assert!((found - expected).abs() < 1e-6, "{found} instead of {expected}");
}

#[test]
fn the_same_press_again_changes_nothing() {
    let once = bends(|hand| hand.feed(60.0).press(100.0).feed(30.0));
    let twice = bends(|hand| hand.feed(60.0).press(100.0).press(100.0).feed(30.0));
    let less = bends(|hand| hand.feed(60.0).press(100.0).press(60.0).feed(30.0));
    assert_eq!(once.len(), 1);
    for other in [twice, less] {
        assert_eq!(other.len(), 1);
        close(other[0].angle_deg, once[0].angle_deg);
        close(other[0].radius_mm, once[0].radius_mm);
    }
}

#[test]
fn a_press_in_two_goes_is_the_press_in_one() {
    let once = bends(|hand| hand.feed(60.0).press(120.0).feed(30.0));
    let twice = bends(|hand| hand.feed(60.0).press(70.0).press(120.0).feed(30.0));
    assert_eq!(twice.len(), 1);
    close(twice[0].angle_deg, once[0].angle_deg);
    close(twice[0].radius_mm, once[0].radius_mm);
}

/// A long way out again and again, without letting the peg in: only the furthest place counts.
#[test]
fn only_the_furthest_place_of_a_stroke_counts() {
    let once = bends(|hand| hand.feed(60.0).press(100.0));
    let hesitant = bends(|hand| {
        hand.feed(60.0).axis_to(-20.0).peg(Peg::Out);
        hand.axis_to(80.0).axis_to(50.0).axis_to(100.0).axis_to(90.0).axis_to(95.0).axis_to(-20.0);
        hand.peg(Peg::In)
    });
    assert_eq!(once, hesitant);
}

/// Wire is fed a millimetre at a time between presses to the same place, so that a curve is pushed out.
#[test]
fn small_feeds_between_presses_keep_the_wire_at_the_pegs_angle() {
    let mut hand = Hand::new(published());
    hand.feed(60.0);
    for _ in 0..4 {
        hand.press(90.0).feed(1.0);
    }
    let made = hand.bench.made();
    let turned: f64 = made.bends().iter().map(|bend| bend.angle_deg).sum();
    let single = bends(|hand| hand.feed(60.0).press(90.0));
    // Where the arc has come off the pin the model presses a fresh bend: never less than one, never more
    // than one a press, and the wire keeps its length.
    assert!(turned >= single[0].angle_deg - 1e-6 && turned < 4.0 * single[0].angle_deg, "{turned}");
    assert!((made.length_mm() - 64.0).abs() < 0.02);
}

#[test]
fn the_wire_can_be_bent_back() {
    let mut hand = Hand::new(published());
    hand.feed(60.0).press(60.0);
    // The negative peg comes out where the leg at some 45 degrees leaves it room.
    hand.axis_to(100.0).peg(Peg::Out).axis_to(0.0).axis_to(100.0).peg(Peg::In);
    let made = hand.bench.made();
    assert_eq!(hand.bench.incidents(), []);
    let turned: f64 = made.bends().iter().map(|bend| bend.angle_deg).sum();
    let first = bends(|hand| hand.feed(60.0).press(60.0))[0].angle_deg;
    // At zero the peg has the leg at the mirror image of 13.25 degrees before touching: about -10.
    assert!(turned < first - 10.0, "{turned} of {first}");
    assert!(made.warnings().iter().any(|doubt| matches!(doubt, ModelWarning::BendOverBend { bend: 1 })));
    // What is left of the first arc and the second one have one corner: on the first edge, with the wire's
    // end at the angle that both make together.
    let [_, corner, end] = made.corners()[..] else { panic!("{:?}", made.corners()) };
    close(corner[1], 0.0);
    close((end[1] - corner[1]).atan2(end[0] - corner[0]).to_degrees(), turned);
}

#[test]
fn a_peg_that_runs_past_a_bend_presses_nothing() {
    let mut hand = Hand::new(published());
    hand.feed(60.0).press(60.0).feed(1.0).rotate(90.0).press(100.0).feed(30.0);
    let made = hand.bench.made();
    // A millimetre behind the nozzle the wire turns out of the plane: the peg meets nothing of it.
    let [ModelWarning::PegPastBend { bend: 1, straight_mm }] = made.warnings() else {
        panic!("{:?}", made.warnings())
    };
    assert!((straight_mm - 1.0).abs() < 0.02);
    assert!((made.length_mm() - 91.0).abs() < 0.02);
}

/// The peg's rod passes 12 + 20.4 - 4.675 = 27.725 mm from the nozzle at the nearest.
#[test]
fn a_wire_that_ends_within_the_orbit_is_not_bent() {
    let pressed = |feed| {
        let mut hand = Hand::new(published());
        hand.feed(feed).press(100.0).feed(40.0);
        hand.bench.made()
    };
    let short = pressed(27.6);
    assert_eq!(short.bends().len(), 1);
    close(short.bends()[0].angle_deg, 0.0);
    let [ModelWarning::PegPastTip { bend: 0, out_mm, needed_mm }] = short.warnings() else {
        panic!("{:?}", short.warnings())
    };
    close(*needed_mm, 27.725);
    assert!((out_mm - 27.6).abs() < 0.01);
    assert!(pressed(27.9).bends()[0].angle_deg > 50.0);
}

/// At 90 degrees of bend the peg holds the leg some 17 mm from the pin (by hand, 16.935 without springback).
#[test]
fn a_leg_that_ends_before_the_peg_is_told() {
    let mut hand = Hand::new(published());
    hand.feed(60.0).press(112.0).feed(18.0).press(112.0).feed(40.0);
    let made = hand.bench.made();
    let [ModelWarning::ShortLeg { bend: 1, contact_mm, straight_mm }] = made.warnings() else {
        panic!("{:?}", made.warnings())
    };
    // The arc of some 95 degrees takes 2.4·95·π/180 = 4 mm of the 18: the peg touches where the corner before begins.
    assert!((14.0..15.5).contains(contact_mm), "{contact_mm}");
    assert!((13.5..14.5).contains(straight_mm), "{straight_mm}");
}

#[test]
fn a_press_that_the_wire_takes_back_is_a_bend_of_nothing() {
    // By the law of sines the peg at 1 degree places the leg at 9, of which 10 are lost.
    let made = bends(|hand| hand.feed(60.0).press(-1.0).feed(40.0).press(80.0).feed(40.0));
    assert_eq!(made.len(), 2);
    close(made[0].angle_deg, 0.0);
    assert!(made[0].radius_mm.is_infinite());
    assert!(made[1].angle_deg > 40.0);
}

/// By the law of sines a fold back takes the axis to 148.5 degrees; its travel ends at 155.
#[test]
fn a_fold_back_has_a_corner_all_the_same() {
    let mut hand = Hand::new(on(Compliance::RIGID));
    hand.feed(60.0).press(155.0).feed(40.0);
    let made = hand.bench.made();
    assert!(made.warnings().contains(&ModelWarning::PastFoldBack { bend: 0 }), "{:?}", made.warnings());
    let angle = made.bends()[0].angle_deg;
    assert!((175.0..180.0).contains(&angle), "{angle}");
    // The tangents meet some 80 mm away; the arc is at the end of the straight, and no wider than the pin.
    let corner = made.corners()[1];
    assert!((50.0..60.0).contains(&corner[0]) && (0.0..6.5).contains(&corner[1]), "{corner:?}");
}

#[test]
fn wire_fed_back_is_fed_again() {
    let plain = bends(|hand| hand.feed(60.0).press(80.0).feed(40.0).press(80.0));
    let back = bends(|hand| hand.feed(60.0).press(80.0).feed(45.0).feed(-5.0).press(80.0));
    for (plain, back) in plain.iter().zip(&back) {
        close(plain.angle_deg, back.angle_deg);
    }
}

#[test]
fn a_softer_machine_bends_less() {
    let bent = |deg_per_n_m| {
        let mut hand = Hand::new(on(Compliance { deg_per_n_m }));
        hand.feed(60.0).press(80.0);
        hand.bench.made().bends()[0].angle_deg
    };
    assert!(bent(0.0) > bent(2.0) + 2.0 && bent(2.0) > bent(4.0) + 2.0);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    /// Further out, further bent; and never as far as the peg went.
    #[test]
    fn springback_is_monotone(axis in 0.0..140.0_f64, more in 0.5..10.0_f64) {
        let bent = |axis: f64| bends(|hand| hand.feed(60.0).press(axis))[0].angle_deg;
        let limit = Bender::PUBLISHED.axis_limit_deg;
        let (less, more) = (bent(axis), bent((axis + more).min(limit)));
        prop_assert!(more > less || (less == 0.0 && more == 0.0), "{less} {more}");
    }
}
