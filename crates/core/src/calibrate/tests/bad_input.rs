//! Tables that are not what they should be: each says what is missing, and what can be fitted all the same is fitted.

use super::*;

fn truth() -> BendModel {
    machine([20.4, 12.0, 3.0, 4.675], 12.0)
}

fn fit(angles: Vec<AngleSample>) -> Calibration {
    let measured = Measurements { angles, ..Measurements::default() };
    calibrate(&published(), &measured, ShapeChoice::Better).unwrap()
}

#[test]
fn positions_out_of_the_axis_range_are_left_out_by_name() {
    let mut angles = ladder(&truth(), &[40.0, 80.0, 120.0], 1, 0.1, &mut Normals::new(1));
    angles.push(AngleSample::beyond_zero(deg(170.0), vec![Some(deg(150.0))]));
    let found = fit(angles);
    assert_eq!(found.left_out.len(), 1);
    assert_eq!(found.left_out[0].place, ReadingPlace { sample: 6, repeat: 0 });
    assert_eq!(found.left_out[0].reason, LeftOutReason::AxisOutOfRange { limit: deg(155.0) });
    assert!(found.bends.is_some());
}

#[test]
fn one_side_is_taken_for_both_and_that_is_said() {
    let angles = ladder(&truth(), &[30.0, 60.0, 80.0, 100.0, 120.0], 2, 0.1, &mut Normals::new(2));
    let found = fit(angles.into_iter().filter(|sample| sample.axis > Angle::ZERO).collect());
    assert!(found.gaps.contains(&Gap::OneSide { missing: -1.0 }), "{:?}", found.gaps);
    let model = found.bends.unwrap().model(None);
    for angle in [90.0, -90.0] {
        let made = truth().result(model.command(deg(angle)).unwrap());
        assert!((made - deg(angle)).abs() < deg(0.5), "{angle} became {made:.2}");
    }
}

#[test]
fn equal_angles_tell_a_loss_and_no_dimension() {
    let angles = ladder(&truth(), &[90.0, 90.0], 2, 0.1, &mut Normals::new(3));
    let angles: Vec<_> = angles.into_iter().filter(|sample| sample.axis > Angle::ZERO).collect();
    let found = fit(angles);
    assert!(found.gaps.iter().any(|gap| matches!(gap, Gap::OneAngle { .. })), "{:?}", found.gaps);
    let bends = found.bends.unwrap();
    assert_eq!((bends.shape, bends.fit.rank), (SpringbackShape::Constant, 1));
    let identified: Vec<_> = bends.fit.estimates.iter().filter(|found| found.is_identified()).collect();
    assert_eq!(identified.len(), 1, "{identified:?}");
    assert_eq!(identified[0].parameter, Parameter::Springback);
    let made = truth().result(bends.model(None).command(deg(90.0)).unwrap());
    assert!((made - deg(90.0)).abs() < deg(0.3), "{made}");
}

#[test]
fn without_any_reading_nothing_is_fitted_and_what_was_measured_is() {
    let mut angles = ladder(&truth(), &[40.0, 80.0], 2, 0.1, &mut Normals::new(4));
    for sample in &mut angles {
        sample.readings = vec![None, None];
    }
    let nothing = Measurements { angles: angles.clone(), ..Measurements::default() };
    let refused = calibrate(&published(), &nothing, ShapeChoice::Better).unwrap_err();
    assert_eq!(refused, CalibrationError::NoReadings { given: 0, reason: None });

    let model = FeedModel::new(mm(1.5), mm(3.0), 0.33);
    let lengths = sides(&truth(), &model, 1.0, 0.05, &mut Normals::new(5));
    let found =
        calibrate(&published(), &Measurements { angles, lengths, turns: vec![] }, ShapeChoice::Better)
            .unwrap();
    assert!(found.gaps.contains(&Gap::NoReadings { kind: Kind::Bends, given: 0 }), "{:?}", found.gaps);
    assert!(found.bends.is_none() && found.feeds.is_some());
}

#[test]
fn one_length_cannot_tell_the_feed_from_the_wire_in_a_bend() {
    let model = FeedModel::new(mm(1.5), mm(3.0), 0.33);
    let mut lengths = sides(&truth(), &model, 1.01, 0.02, &mut Normals::new(6));
    lengths.truncate(1);
    let feed = lengths[0].feed;
    let found =
        calibrate(&published(), &Measurements { lengths, ..Measurements::default() }, ShapeChoice::Better)
            .unwrap();
    assert!(found.gaps.contains(&Gap::OneLength { feed }), "{:?}", found.gaps);
    assert_eq!(found.feeds.unwrap().fit.rank, 1);
}

#[test]
fn other_units_are_recognised_row_by_row() {
    let mut angles = ladder(&truth(), &[60.0, 80.0, 100.0, 120.0], 2, 0.1, &mut Normals::new(7));
    let degrees = angles[0].readings[0].unwrap().deg();
    angles[0].readings[0] = Some(deg(degrees.to_radians()));
    let inner = 180.0 - angles[1].readings[1].unwrap().abs().deg();
    angles[1].readings[1] = Some(deg(inner));
    let model = FeedModel::new(mm(1.5), mm(3.0), 0.3);
    let mut lengths = sides(&truth(), &model, 1.0, 0.05, &mut Normals::new(8));
    let side = lengths[1].readings[0].unwrap().mm();
    // A person reads over the outside, half a wire more at either end.
    let outside = |side: f64, unit: f64| Some(mm((side + 3.0) / unit - 3.0));
    lengths[1].readings[0] = outside(side, 25.4);
    lengths[2].readings[1] = outside(lengths[2].readings[1].unwrap().mm(), 10.0);
    let found =
        calibrate(&published(), &Measurements { angles, lengths, turns: vec![] }, ShapeChoice::Better);
    let found = found.unwrap();
    let named: Vec<_> =
        found.left_out.iter().map(|left| (left.kind, left.place.sample, left.reason)).collect();
    let unit = LeftOutReason::Unit;
    assert_eq!(
        named,
        [
            (Kind::Bends, 0, unit(OtherUnit::Radians)),
            (Kind::Bends, 1, unit(OtherUnit::InnerAngle)),
            (Kind::Feeds, 1, unit(OtherUnit::Inches)),
            (Kind::Feeds, 2, unit(OtherUnit::Centimetres)),
        ]
    );
}

#[test]
fn a_bend_to_the_other_side_and_one_that_left_nothing_are_no_angles() {
    let mut angles = ladder(&truth(), &[60.0, 80.0, 100.0], 2, 0.1, &mut Normals::new(9));
    angles[0].readings[1] = Some(deg(-60.0));
    angles.push(AngleSample::beyond_zero(deg(5.0), vec![Some(deg(0.0))]));
    let named: Vec<_> = fit(angles).left_out.iter().map(|left| left.reason).collect();
    assert_eq!(named, [LeftOutReason::OtherSide, LeftOutReason::NoBend]);
}

#[test]
fn a_curve_that_few_angles_cannot_tell_is_a_constant() {
    let angles = ladder(&truth(), &[60.0, 100.0], 2, 0.1, &mut Normals::new(10));
    let measured = Measurements { angles, ..Measurements::default() };
    let found = calibrate(&published(), &measured, ShapeChoice::Fixed(SpringbackShape::Cubic)).unwrap();
    assert!(found.gaps.contains(&Gap::FewAngles { needed: 4 }), "{:?}", found.gaps);
    assert_eq!(found.bends.unwrap().shape, SpringbackShape::Constant);
}

/// A protractor shows the angle between the legs. A table of nothing else was fitted: with a springback below zero, and dimensions a third of what
/// they are.
#[test]
fn a_table_of_inner_angles_is_no_machine() {
    let ladder = |seed, loss: f64| {
        let truth = machine([22.44, 10.8, 3.3, 5.14], loss);
        ladder(&truth, &[20.0, 40.0, 60.0, 80.0, 100.0, 120.0, 135.0], 2, 0.5, &mut Normals::new(seed))
    };
    for seed in 0..20 {
        for loss in [3.0, 11.25, 25.0] {
            let mut angles = ladder(seed, loss);
            for reading in angles.iter_mut().flat_map(|sample| sample.readings.iter_mut().flatten()) {
                *reading = deg(180.0 - reading.abs().deg());
            }
            let measured = Measurements { angles, ..Measurements::default() };
            let refused = calibrate(&published(), &measured, ShapeChoice::Better).unwrap_err();
            let reason = Some(LeftOutReason::Unit(OtherUnit::InnerAngle));
            assert_eq!(refused, CalibrationError::NoReadings { given: 28, reason }, "{seed} {loss}");
            // A slip among them is one of them.
            let mut angles = measured.angles;
            angles[3].readings[1] = Some(deg(75.0));
            let refused = calibrate(
                &published(),
                &Measurements { angles, ..Measurements::default() },
                ShapeChoice::Better,
            );
            assert_eq!(refused, Err(CalibrationError::NoReadings { given: 28, reason }), "{seed} {loss}");
            assert!(fit(ladder(seed, loss)).left_out.is_empty(), "{seed} {loss}");
        }
    }
}

/// Read in radians, every bend is off by about as much, which was taken for the springback of the wire.
#[test]
fn a_table_in_radians_is_no_wire() {
    for seed in 0..20 {
        for loss in [3.0, 11.25, 25.0] {
            let truth = machine([22.44, 10.8, 3.3, 5.14], loss);
            let bends = [20.0, 40.0, 60.0, 80.0, 100.0, 120.0, 135.0];
            let mut angles = ladder(&truth, &bends, 2, 0.5, &mut Normals::new(seed));
            for reading in angles.iter_mut().flat_map(|sample| sample.readings.iter_mut().flatten()) {
                *reading = deg(reading.rad());
            }
            let measured = Measurements { angles, ..Measurements::default() };
            let refused = calibrate(&published(), &measured, ShapeChoice::Better).unwrap_err();
            let reason = Some(LeftOutReason::Unit(OtherUnit::Radians));
            assert_eq!(refused, CalibrationError::NoReadings { given: 28, reason }, "{seed} {loss}");
        }
    }
}
