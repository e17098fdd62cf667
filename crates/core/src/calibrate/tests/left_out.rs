//! Leave-one-out is computed by the straight lines about the solution. Here each sample is really left out.

#![allow(clippy::print_stdout, reason = "figures, for --nocapture")]

use super::*;

/// How far off fits are, in the root of the mean square, for the samples that each has not seen.
fn refitted(angles: &[AngleSample], choice: ShapeChoice) -> f64 {
    let mut errors = Vec::new();
    for left_out in 0..angles.len() {
        let mut others = angles.to_vec();
        let sample = others.remove(left_out);
        let measured = Measurements { angles: others, ..Measurements::default() };
        let found = calibrate(&published(), &measured, choice).unwrap();
        assert!(found.left_out.is_empty(), "{:?}", found.left_out);
        let predicted = found.bends.unwrap().model(None).result_to(sample.side, sample.axis);
        errors.extend(sample.readings.iter().flatten().map(|reading| (*reading - predicted).deg()));
    }
    Misfit::of(&errors).rms
}

#[test]
fn a_fit_that_has_not_seen_a_sample_is_as_far_off_as_is_stated() {
    let mut random = Normals::new(1_000);
    // A curve whose first or last angle is left out has its knots elsewhere, which the straight lines do not know.
    for (shape, few, each, all) in
        [(SpringbackShape::Constant, 3, 0.01, 0.01), (SpringbackShape::Cubic, 6, 0.4, 0.15)]
    {
        let (mut stated, mut refits, mut worst) = (0.0, 0.0, 0.0_f64);
        for round in 0..6 {
            let mut near = |value: f64| value * (1.0 + random.next(0.05));
            let truth = machine([near(20.4), near(12.0), near(3.0), near(4.675)], near(10.23));
            let count = few + round % 3;
            let angles: Vec<f64> =
                (0..count).map(|k| 25.0 + 105.0 * f64::from(k) / f64::from(count - 1)).collect();
            let angles = ladder(&truth, &angles, 2, 0.5, &mut random);
            let choice = ShapeChoice::Fixed(shape);
            let measured = Measurements { angles: angles.clone(), ..Measurements::default() };
            let fit = calibrate(&published(), &measured, choice).unwrap().bends.unwrap().fit;
            let (one, other) = (fit.leave_one_out.rms, refitted(&angles, choice));
            println!("{shape:?}, {count} angles a side: stated {one:.3}, refitted {other:.3} degrees rms");
            stated += one;
            refits += other;
            worst = worst.max((one / other - 1.0).abs());
        }
        println!("{shape:?}: in all {:.3} of the refits, at worst {worst:.3} off", stated / refits);
        assert!(worst < each, "{shape:?}: {worst}");
        assert!((stated / refits - 1.0).abs() < all, "{shape:?}: {stated} for {refits}");
    }
}
