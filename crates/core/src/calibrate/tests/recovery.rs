//! Without scatter, what readings tell is found exactly; with it, what is commanded next comes out right.

use super::*;
use crate::compensate::{SpringbackCurve, SpringbackPoint};

const ANGLES: [f64; 10] = [15.0, 30.0, 45.0, 60.0, 75.0, 90.0, 105.0, 120.0, 130.0, 140.0];

/// Everything 10 % off: were it not found, every bend would be about 3 degrees off.
#[test]
fn a_machine_that_is_all_off_by_a_tenth_makes_what_it_is_told_once_it_is_calibrated() {
    let truth = machine([22.44, 10.8, 3.3, 5.14], 11.25);
    let measured = Measurements {
        angles: ladder(&truth, &ANGLES, 3, 0.5, &mut Normals::new(1)),
        ..Measurements::default()
    };
    let found = calibrate(&published(), &measured, ShapeChoice::Better).unwrap();
    let bends = found.bends.unwrap();
    let model = bends.model(None);
    for angle in [20.0, 50.0, 90.0, 135.0, -20.0, -90.0, -135.0] {
        let made = truth.result(model.command(deg(angle)).unwrap());
        assert!((made - deg(angle)).abs() < deg(0.5), "{angle} became {made:.2}");
    }
    assert!(bends.fit.before.mean_abs > 4.0 * bends.fit.after.mean_abs, "{:?}", bends.fit);
    // Readings scatter by 0.5.
    assert!((bends.fit.scatter.plain() - 0.5).abs() < 0.12, "{:?}", bends.fit.scatter);
    assert!(found.left_out.is_empty() && found.gaps.len() == 2, "{:?} {:?}", found.left_out, found.gaps);
}

/// Bends tell only ratios, so a caliper has to say how large the orbit is.
#[test]
fn dimensions_are_found_once_one_of_them_is_known() {
    let truth = machine([22.44, 10.8, 3.3, 5.14], 11.25);
    let mut assumed = published();
    assumed.peg.as_mut().unwrap().orbit_radius = KnownLength { value: mm(22.44), deviation: mm(0.001) };
    let readings = ladder(&truth, &ANGLES, 3, 0.02, &mut Normals::new(2));
    let measured = Measurements { angles: readings, ..Measurements::default() };
    let bends = calibrate(&assumed, &measured, ShapeChoice::Better).unwrap().bends.unwrap();
    assert_eq!(bends.shape, SpringbackShape::Constant);
    let known =
        [(Parameter::OrbitOffset, 10.8), (Parameter::PegRadius, 5.14), (Parameter::Springback, 11.25)];
    for (parameter, truth) in known {
        let found = estimate(&bends.fit, parameter);
        assert!(covers(&found, truth), "{found:?}");
        assert!(found.is_identified(), "{found:?}");
        assert!((found.value.plain() / truth - 1.0).abs() < 0.05, "{found:?}");
    }
}

/// The two sides of 1/8 inch aluminium differ: a constant would be off by two degrees.
#[test]
fn a_springback_that_grows_with_the_angle_is_found_as_a_curve() {
    let truth = |axis: Angle| {
        let geometry = machine([20.4, 12.0, 3.0, 4.675], 0.0);
        let bent = geometry.result(axis).abs().deg();
        // 4.9 degrees lost at 10, 8.6 at 130, and a degree less to the other side.
        let loss = 4.9 + 3.7 * (bent - 14.9) / 123.7;
        axis.signum() * (bent - loss + if axis < Angle::ZERO { 1.0 } else { 0.0 })
    };
    let mut random = Normals::new(3);
    let asked = published().bend_model().unwrap();
    let axes =
        ANGLES.iter().flat_map(|&angle| [angle, -angle]).map(|angle| asked.command(deg(angle)).unwrap());
    let samples = axes.map(|axis| {
        let readings = (0..3).map(|_| Some(deg(truth(axis) + random.next(0.2))));
        AngleSample::beyond_zero(axis, readings.collect())
    });
    let measured = Measurements { angles: samples.collect(), ..Measurements::default() };
    let bends = calibrate(&published(), &measured, ShapeChoice::Better).unwrap().bends.unwrap();
    assert_eq!(bends.shape, SpringbackShape::Cubic);
    let (_, constant) = bends.other.unwrap();
    assert!(bends.fit.leave_one_out.rms < 0.8 * constant.rms, "{:?} {constant:?}", bends.fit.leave_one_out);
    for angle in [25.0, 80.0, 110.0, -25.0, -80.0, -110.0] {
        let made = truth(bends.model(None).command(deg(angle)).unwrap());
        assert!((made - angle).abs() < 0.3, "{angle} became {made:.2}");
    }
    let [positive, negative] = bends.pairs.unwrap();
    assert!(positive.len() > 4 && negative.len() > 4);
}

#[test]
fn the_feed_and_the_wire_in_a_bend_are_found_from_two_lengths() {
    let truth = machine([20.4, 12.0, 3.0, 4.675], 10.23);
    let model = FeedModel::new(mm(1.5), mm(3.0), 0.33);
    let mut random = Normals::new(4);
    let measured =
        Measurements { lengths: sides(&truth, &model, 1.012, 0.02, &mut random), ..Measurements::default() };
    let mut assumed = published();
    assumed.bend_radius.deviation = mm(0.01);
    let feeds = calibrate(&assumed, &measured, ShapeChoice::Better).unwrap().feeds.unwrap();
    assert!((feeds.scale - 1.012).abs() < 0.001, "{}", feeds.scale);
    assert!((feeds.k_factor - 0.33).abs() < 0.02, "{}", feeds.k_factor);
    assert!(covers(&estimate(&feeds.fit, Parameter::KFactor), 0.33));
}

#[test]
fn the_play_of_the_head_shows_in_turns_that_reverse() {
    let sample = |rotate: f64, reverses: bool, reading: f64| TurnSample {
        rotate: deg(rotate),
        reverses,
        readings: [-0.1, 0.0, 0.1].map(|off| Some(deg(reading + off))).to_vec(),
    };
    let turns = vec![sample(90.0, false, 90.4), sample(-90.0, true, -88.1), sample(90.0, true, 88.9)];
    let measured = Measurements { turns, ..Measurements::default() };
    let found = calibrate(&published(), &measured, ShapeChoice::Better).unwrap();
    let turns = found.turns.unwrap();
    // 90 + 0.4; -90 + 0.4 + 1.5; 90 + 0.4 - 1.5.
    assert!((turns.offset_deg - 0.4).abs() < 0.02 && (turns.backlash_deg - 1.5).abs() < 0.02, "{turns:?}");
}

/// Coupons are bent one after the other, and each ends with a turn back: the next would begin with one, and its turns would be short on
/// both sides, which is an offset of -2 and twice the backlash.
#[test]
fn a_twist_pair_that_is_bent_again_finds_the_same_backlash() {
    for turn in [90.0, -90.0] {
        let plan =
            CouponPlan { angles: Vec::new(), sides: Vec::new(), turn: Some(deg(turn)), edge: mm(60.0) };
        let coupon = plan.coupons().remove(0);
        let steps = &coupon.program.steps;
        let head = MotionModel { rotate_backlash: deg(2.0), ..MotionModel::default() };
        let made = head.result(&steps.repeat(4)).into_owned();
        let sample = |&(step, what): &(usize, Measured)| {
            // The first wire is left out: nobody knows how the head stood before it.
            let readings = (1..4).map(|wire| Some(made[wire * steps.len() + step].rotate)).collect();
            let reverses = matches!(what, Measured::Turn { reverses: true });
            TurnSample { rotate: steps[step].rotate, reverses, readings }
        };
        let turns = coupon.measured.iter().map(sample).collect();
        let measured = Measurements { turns, ..Measurements::default() };
        let turns = calibrate(&published(), &measured, ShapeChoice::Better).unwrap().turns.unwrap();
        assert!(
            turns.offset_deg.abs() < 0.05 && (turns.backlash_deg - 2.0).abs() < 0.05,
            "{turn}: {turns:?}"
        );
    }
}

/// A wire that takes back 10 degrees more than was known: right angles come out as 80, and a side of 35 is
/// 32.770 - 2.4 * 1.396 + 2 * 3 * tan 40 = 34.454 mm. The figures of before said 35, whatever the bends of the same sheet tell.
#[test]
fn what_sides_were_off_by_before_is_by_the_bends_of_before() {
    let [expected, truth] = [10.23, 20.23].map(|loss| machine([20.4, 12.0, 3.0, 4.675], loss));
    let model = FeedModel::new(mm(1.5), mm(3.0), 0.3);
    let mut random = Normals::new(11);
    let angles = ladder(&truth, &[40.0, 60.0, 80.0, 100.0, 120.0], 2, 0.0, &mut random);
    let before = |angles: &[AngleSample], lengths: &[LengthSample]| {
        let measured = Measurements { angles: angles.to_vec(), lengths: lengths.to_vec(), turns: Vec::new() };
        let found = calibrate(&published(), &measured, ShapeChoice::Better).unwrap();
        assert!(found.left_out.is_empty(), "{:?}", found.left_out);
        found.feeds.unwrap().fit.before.mean_abs
    };
    let right = sides(&expected, &model, 1.0, 0.0, &mut random);
    let short = sides(&truth, &model, 1.0, 0.0, &mut random);
    assert!((short[0].readings[0].unwrap().mm() - 34.454).abs() < 1e-3, "{:?}", short[0]);
    for angles in [Vec::new(), angles] {
        let rows = angles.len();
        let (as_expected, off) = (before(&angles, &right), before(&angles, &short));
        assert!(as_expected < 1e-6, "{as_expected} with {rows} rows of bends");
        assert!((off - 0.546).abs() < 2e-3, "{off} with {rows} rows of bends");
    }
}

/// A wire that was measured well, and then is bent hard once: three angles tell no curve, and a constant would forget the one that is known.
#[test]
fn a_known_curve_is_kept_where_the_readings_tell_no_other() {
    let pair = |formed, loss| SpringbackPoint { formed: deg(formed), loss: deg(loss) };
    let curve = |more: f64| {
        let pairs = [(10.0, 3.0), (60.0, 6.0), (100.0, 9.5), (135.0, 14.0)];
        SpringbackCurve::new(&pairs.map(|(formed, loss)| pair(formed, loss + more))).unwrap()
    };
    let springback =
        |more: [f64; 2]| Springback::Table { positive: curve(more[0]), negative: curve(more[1]) };
    let mut assumed = published();
    assumed.springback = Some(springback([0.0, 0.5]));
    let truth =
        BendModel { springback: Some(springback([1.5, 2.0])), ..machine([20.4, 12.0, 3.0, 4.675], 0.0) };
    let asked = assumed.bend_model().unwrap();
    for angles in [&[90.0][..], &[30.0, 90.0], &[-45.0, 30.0, 120.0]] {
        let sample = |&angle: &f64| {
            let axis = asked.command(deg(angle)).unwrap();
            AngleSample::beyond_zero(axis, vec![Some(truth.result(axis)); 3])
        };
        let measured =
            Measurements { angles: angles.iter().map(sample).collect(), ..Measurements::default() };
        let bends = settled(&assumed, &measured, ShapeChoice::Better).unwrap().bends.unwrap();
        assert_eq!(bends.shape, SpringbackShape::Moved);
        let shift = estimate(&bends.fit, Parameter::SpringbackShift);
        assert!((shift.value.plain() - 1.5).abs() < 0.05, "{angles:?}: {shift:?}");
        let off = |model: &BendModel| {
            let made = |angle: f64| (truth.result(model.command(deg(angle)).unwrap()).deg() - angle).abs();
            (-13..=13).filter(|tens| *tens != 0).map(|tens| made(10.0 * f64::from(tens))).fold(0.0, f64::max)
        };
        let constant = settled(&assumed, &measured, ShapeChoice::Fixed(SpringbackShape::Constant)).unwrap();
        let constant = constant.bends.unwrap().model(None);
        let moved = bends.model(None);
        assert!(off(&moved) < 0.1 && off(&constant) > 2.0, "{angles:?}: {} {}", off(&moved), off(&constant));
        let [positive, negative] = bends.pairs.unwrap();
        assert_eq!((positive.len(), negative.len()), (4, 4), "a profile keeps the pairs that it has");
    }
}
