//! What a controller should never do is seen, once, at the pulse at which it begins.

use wirebend_driver_api::Axis;
use wirebend_driver_wirebend_kit::bench::{
    Bench, BenchError, Bender, Compliance, Peg, Scale, Violation, Wire,
};

use super::hand::pulses;

/// Tenths, so that steps are easily counted.
const TENTHS: Scale = Scale { feed_mm_per_step: 0.1, rotate_deg_per_step: 0.1, bend_deg_per_step: 0.1 };

fn bench() -> Bench {
    Bench::new(Bender::PUBLISHED, Wire::PUBLISHED, TENTHS, Compliance::published().unwrap()).unwrap()
}

/// 60 mm of wire are out and the peg stands below it at -20 degrees: 800 pulses.
fn ready() -> Bench {
    let mut bench = bench();
    pulses(&mut bench, Axis::Feed, 600);
    pulses(&mut bench, Axis::Bend, -200);
    bench
}

fn told(bench: &Bench) -> Vec<(u64, Violation)> {
    bench.incidents().iter().map(|incident| (incident.pulse, incident.what)).collect()
}

#[test]
fn wire_is_not_fed_and_the_head_not_turned_with_the_peg_out() {
    let mut bench = ready();
    bench.peg(Peg::Out);
    pulses(&mut bench, Axis::Feed, 50);
    pulses(&mut bench, Axis::Bend, 900); // to 70 degrees
    pulses(&mut bench, Axis::Rotate, 50);
    pulses(&mut bench, Axis::Feed, 10);
    assert_eq!(
        told(&bench),
        [
            (801, Violation::FedWithPeg { touching: false }),
            (1751, Violation::RotatedWithPeg { touching: true }),
            (1801, Violation::FedWithPeg { touching: true }),
        ]
    );
    assert_eq!(bench.incidents()[0].to_string(), "pulse 801: fed with the peg out");
    assert_eq!(bench.incidents()[2].to_string(), "pulse 1801: fed with the peg against the wire");
}

#[test]
fn the_peg_does_not_come_out_into_the_wire() {
    // Straight wire is touched from ±13.25 degrees on.
    for (axis, overlaps) in [(-140, false), (-131, true), (0, true), (131, true), (140, false)] {
        let mut bench = bench();
        pulses(&mut bench, Axis::Feed, 600);
        pulses(&mut bench, Axis::Bend, axis);
        bench.peg(Peg::Between);
        bench.peg(Peg::Out);
        let is_told = matches!(told(&bench)[..], [(_, Violation::PegIntoWire { .. })]);
        assert_eq!(is_told, overlaps, "{axis}: {:?}", told(&bench));
    }
    // No wire, nothing to hit.
    let mut empty = self::bench();
    empty.peg(Peg::Out);
    assert_eq!(told(&empty), []);
}

/// 60 mm from the tip a bend of some 40 degrees to the other side, and 15 mm behind it the next: what was bent lies where the peg comes
/// out for straight wire, and not beyond.
#[test]
fn the_peg_does_not_come_out_into_wire_that_was_bent() {
    for (axis, overlaps) in [(-182, true), (-300, true), (-600, false)] {
        let mut bench = bench();
        pulses(&mut bench, Axis::Feed, 600);
        pulses(&mut bench, Axis::Bend, 200);
        bench.peg(Peg::Out);
        pulses(&mut bench, Axis::Bend, -800);
        pulses(&mut bench, Axis::Bend, 800);
        bench.peg(Peg::In);
        pulses(&mut bench, Axis::Bend, -200);
        pulses(&mut bench, Axis::Feed, 200);
        pulses(&mut bench, Axis::Bend, axis);
        bench.peg(Peg::Out);
        let is_told = matches!(told(&bench)[..], [(_, Violation::PegIntoWire { .. })]);
        assert_eq!(is_told, overlaps, "{axis}: {:?}", told(&bench));
    }
}

#[test]
fn the_peg_comes_back_before_it_goes_in() {
    let mut bench = ready();
    bench.peg(Peg::Out);
    pulses(&mut bench, Axis::Bend, 1000); // to 80
    pulses(&mut bench, Axis::Bend, -50); // to 75: the wire still follows
    bench.peg(Peg::In);
    assert!(matches!(told(&bench)[..], [(1850, Violation::PegInUnderLoad { .. })]), "{:?}", told(&bench));
    // The bend stays in the wire anyway.
    assert!(bench.made().bends()[0].angle_deg > 50.0);
}

#[test]
fn the_axis_waits_for_the_peg() {
    let mut bench = ready();
    bench.peg(Peg::Between);
    pulses(&mut bench, Axis::Bend, 5);
    bench.peg(Peg::Out);
    pulses(&mut bench, Axis::Bend, 5);
    assert_eq!(told(&bench), [(801, Violation::BentWithPegBetween)]);
}

#[test]
fn axes_stay_within_their_travel() {
    let mut bench = bench().with_head_limit(360.0).unwrap();
    pulses(&mut bench, Axis::Bend, 1550);
    pulses(&mut bench, Axis::Rotate, -3600);
    assert_eq!(told(&bench), []);
    pulses(&mut bench, Axis::Bend, 20);
    pulses(&mut bench, Axis::Rotate, -20);
    assert!(
        matches!(told(&bench)[..], [
            (5151, Violation::BendPastLimit { axis_deg }),
            (5171, Violation::HeadPastLimit { head_deg }),
        ] if (axis_deg - 155.1).abs() < 1e-9 && (head_deg + 360.1).abs() < 1e-9),
        "{:?}",
        told(&bench)
    );
}

#[test]
fn an_axis_that_was_pushed_by_hand_stands_elsewhere_than_it_was_told() {
    let mut bench = bench().with_bend_axis_at(-150.0).unwrap();
    assert!((bench.bend_axis_deg() + 150.0).abs() < 1e-9);
    pulses(&mut bench, Axis::Bend, -100);
    assert!(matches!(told(&bench)[..], [(51, Violation::BendPastLimit { .. })]), "{:?}", told(&bench));
}

#[test]
fn bends_and_tip_stay_out_of_the_nozzle() {
    let mut bench = ready();
    bench.peg(Peg::Out);
    pulses(&mut bench, Axis::Bend, 1000);
    pulses(&mut bench, Axis::Bend, -1000);
    bench.peg(Peg::In);
    pulses(&mut bench, Axis::Feed, 10);
    let before = bench.made();
    pulses(&mut bench, Axis::Feed, -15);
    pulses(&mut bench, Axis::Rotate, 1);
    let [(2825, Violation::PulledTooFar { by_mm })] = told(&bench)[..] else { panic!("{:?}", told(&bench)) };
    assert!((by_mm - 0.5).abs() < 1e-9);
    assert!((before.length_mm() - bench.made().length_mm() - 1.0).abs() < 1e-9);

    let mut unbent = self::bench();
    pulses(&mut unbent, Axis::Feed, -7);
    unbent.peg(Peg::Out);
    assert!(matches!(told(&unbent)[..], [(7, Violation::PulledTooFar { .. })]));
}

#[test]
fn figures_that_cannot_be_are_refused_with_what_they_should_be() {
    let give = Compliance::RIGID;
    let refused = |bender, wire, scale, give| Bench::new(bender, wire, scale, give).unwrap_err().to_string();
    let (bender, wire) = (Bender::PUBLISHED, Wire::PUBLISHED);
    let cases = [
        (
            refused(Bender { pin_radius_mm: 0.0, ..bender }, wire, TENTHS, give),
            "the pin's radius is 0, which should be more than zero; correct the profile",
        ),
        (
            refused(Bender { axis_limit_deg: 180.0, ..bender }, wire, TENTHS, give),
            "the bend axis' limit is 180, which should be an angle between 0 and 180; correct the profile",
        ),
        (
            refused(bender, Wire { k_factor: f64::NAN, ..wire }, TENTHS, give),
            "the K-factor is NaN, which should be a part of the diameter, from 0 to 1; correct the profile",
        ),
        (
            refused(bender, Wire { ultimate_strength_mpa: 200.0, ..wire }, TENTHS, give),
            "the ultimate strength is 200, which should be the yield strength or more; correct the profile",
        ),
        (
            refused(bender, wire, Scale { feed_mm_per_step: -0.1, ..TENTHS }, give),
            "the feed of a pulse is -0.1, which should be more than zero; correct the profile",
        ),
        (
            refused(bender, wire, TENTHS, Compliance { deg_per_n_m: -1.0 }),
            "the machine's compliance is -1, which should be zero or more; correct the profile",
        ),
        (
            refused(Bender { orbit_offset_mm: 100.0, ..bender }, wire, TENTHS, give),
            // By hand: a leg at 14.58 degrees is the furthest that this peg reaches, a quarter turn ahead of it.
            "with the bend axis at 105 degrees the peg pushes the wire less far than before; check the orbit's \
             radius and offset, the pin, the rod and the axis' limit",
        ),
    ];
    for (message, expected) in cases {
        assert_eq!(message, expected);
    }
    assert!(matches!(bench().with_bend_axis_at(181.0), Err(BenchError::Figure { .. })));
    assert!(matches!(bench().with_head_limit(f64::NAN), Err(BenchError::Figure { .. })));
}
