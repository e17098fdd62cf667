//! What readings do not determine stays as it was, and what is fitted beside it still leads to the same bends.

use super::*;

const ANGLES: [f64; 7] = [20.0, 40.0, 60.0, 80.0, 100.0, 120.0, 135.0];

/// Of machines as far off as is assumed, with bends that scatter by a quarter of a degree.
#[test]
fn what_is_not_determined_stays_and_the_others_are_fitted_to_it() {
    let mut random = Normals::new(71);
    let (mut left, mut covered, mut all) = (0, 0, 0);
    for _ in 0..20 {
        let dimensions = [20.4, 12.0, 3.0, 4.675].map(|value| value + random.next(0.1 * value));
        let loss = 10.23 + random.next(2.0);
        let truth = machine(dimensions, loss);
        let angles = ladder(&truth, &ANGLES, 2, 0.25, &mut random);
        let measured = Measurements { angles, ..Measurements::default() };
        let free = calibrate(&published(), &measured, ShapeChoice::Better).unwrap().bends.unwrap();
        let found = settled(&published(), &measured, ShapeChoice::Better).unwrap().bends.unwrap();
        assert_eq!(found.shape, free.shape);
        for estimate in &found.fit.estimates {
            assert!(estimate.is_identified() || estimate.is_left(), "{estimate:?}");
            left += usize::from(estimate.is_left());
        }
        let peg = found.peg.unwrap();
        let fitted = [peg.orbit_radius, peg.orbit_offset, peg.bend_radius, peg.peg_radius].map(Length::mm);
        for ((estimate, truth), value) in found.fit.estimates.iter().zip(dimensions).zip(fitted) {
            assert!((estimate.value.plain() - value).abs() < 1e-3, "{estimate:?}: {value}");
            covered += usize::from(covers(estimate, truth));
            all += 1;
        }
        let off = |fit: &BendFit| {
            let model = fit.model(None);
            let off = |axis: f64| (model.result(deg(axis)) - truth.result(deg(axis))).deg().abs();
            [40.0, 60.0, 90.0, 110.0, 125.0].map(off).into_iter().fold(0.0, f64::max)
        };
        let (before, after) = (off(&free), off(&found));
        assert!(after < before + 0.05, "{dimensions:?}: {after} instead of {before}");
    }
    assert!(left > 10, "{left} of {all} were left");
    assert!(100 * covered >= 92 * all, "{covered} of {all}");
}

#[test]
fn without_a_turn_back_the_backlash_stays_as_it_was() {
    let motion = MotionModel { rotate_backlash: deg(1.5), ..MotionModel::default() };
    let turn = TurnSample { rotate: deg(90.0), reverses: false, readings: vec![Some(deg(91.0)); 3] };
    let measured = Measurements { turns: vec![turn], ..Measurements::default() };
    let assumed = Assumed { motion, ..published() };
    let turns = settled(&assumed, &measured, ShapeChoice::Better).unwrap().turns.unwrap();
    let backlash = estimate(&turns.fit, Parameter::RotationBacklash);
    assert!(backlash.is_left() && (backlash.value.plain() - 1.5).abs() < 1e-9, "{backlash:?}");
    assert!((turns.offset_deg - 1.0).abs() < 0.05, "{}", turns.offset_deg);
}
