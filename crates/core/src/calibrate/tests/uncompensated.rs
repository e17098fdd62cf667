//! Machines that see to feeds and bends themselves: their commands are the design, and sheets are read so.

use super::*;

/// Commands are the design itself: bends are not calibrated, and nothing is deducted from feeds.
fn design_is_commanded() -> Assumed {
    Assumed { peg: None, springback: None, axis_limit: None, deducts_bends: false, ..published() }
}

/// Sides of these lengths, each fed as it is, that come out so many times as long.
fn fed_as_designed(lengths: &[f64], times: f64) -> Vec<LengthSample> {
    let sample = |&length: &f64| LengthSample {
        feed: mm(length),
        axis_before: deg(90.0),
        axis_after: deg(90.0),
        readings: [-0.02, 0.0, 0.02].map(|off| Some(mm(times * length + off))).to_vec(),
    };
    lengths.iter().map(sample).collect()
}

/// Sides that are right were fitted as if wire had been deducted for their bends: 0.992 mm for each commanded one, and K 0.6023.
#[test]
fn sides_that_are_right_leave_feed_and_k_as_they_are() {
    let lengths = fed_as_designed(&[15.0, 60.0], 1.0);
    let measured = Measurements { lengths, ..Measurements::default() };
    let found = settled(&design_is_commanded(), &measured, ShapeChoice::Better).unwrap();
    assert!(found.gaps.contains(&Gap::DeductionLeft), "{:?}", found.gaps);
    let feeds = found.feeds.unwrap();
    assert!((feeds.scale - 1.0).abs() < 1e-4 && (feeds.k_factor - 0.3).abs() < 1e-4, "{feeds:?}");
    let k = estimate(&feeds.fit, Parameter::KFactor);
    assert!(k.is_left() && (k.value.plain() - 0.3).abs() < 1e-9, "{k:?}");
    assert!(feeds.fit.before.mean_abs < 0.02, "{:?}", feeds.fit.before);
}

/// And a feed that gives more shows in sides of one length, since no wire in a bend can make up for it.
#[test]
fn a_side_of_one_length_tells_the_feed() {
    let lengths = fed_as_designed(&[60.0], 1.01);
    let measured = Measurements { lengths, ..Measurements::default() };
    let found = settled(&design_is_commanded(), &measured, ShapeChoice::Better).unwrap();
    assert!(!found.gaps.iter().any(|gap| matches!(gap, Gap::OneLength { .. })), "{:?}", found.gaps);
    let feeds = found.feeds.unwrap();
    assert!((feeds.scale - 1.01).abs() < 5e-4, "{}", feeds.scale);
    assert!(estimate(&feeds.fit, Parameter::FeedScale).is_identified(), "{:?}", feeds.fit);
}

#[test]
fn of_a_springback_that_the_machine_sees_to_it_is_said_that_it_is_not_used() {
    let sample =
        |axis: f64| AngleSample::beyond_zero(deg(axis), vec![Some(deg(axis - 2.0 * axis.signum())); 2]);
    let angles = [60.0, -60.0, 90.0, -90.0].map(sample).to_vec();
    let measured = Measurements { angles, ..Measurements::default() };
    let gaps = |assumed: &Assumed| calibrate(assumed, &measured, ShapeChoice::Better).unwrap().gaps;
    let machine = design_is_commanded();
    assert!(gaps(&machine).contains(&Gap::SpringbackLeft));
    let compensated = Assumed { springback: Some(Springback::Constant(deg(1.0))), ..machine };
    assert!(!gaps(&compensated).contains(&Gap::SpringbackLeft));
}
