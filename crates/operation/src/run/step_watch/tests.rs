use super::*;

/// 40 mm in 4 s, 90° in 2 s, a bend of -100° there and back in 3 s, the peg out and in within 1 s.
const STEP: CommandedStep = CommandedStep {
    commanded: axes(40.0, 90.0, -100.0),
    seconds: StepSeconds { feed: 4.0, rotate: 2.0, bend: 3.0, wait: 1.0 },
};

const fn axes(feed_mm: f64, rotate_deg: f64, bend_deg: f64) -> JobStep {
    JobStep { feed_mm, rotate_deg, bend_deg, approach_deg: None }
}

fn watch() -> StepWatch {
    StepWatch::new(vec![STEP; 9])
}

/// Where it is after each report, to a thousandth of a step.
fn seen(watch: &mut StepWatch, made: usize, places: &[JobStep]) -> Vec<f64> {
    places.iter().map(|&place| (watch.part(made, Some(place)) * 1000.0).round() / 1000.0).collect()
}

#[test]
fn it_goes_with_the_axes_through_feed_rotate_and_bend() {
    let fed = [axes(100., -30., 0.), axes(120., -30., 0.), axes(140., -30., 0.), axes(140., 15., 0.)];
    let bent = [axes(140., 60., 0.), axes(140., 60., -50.), axes(140., 60., -100.), axes(140., 60., -50.)];
    let places = [fed, bent].concat();
    assert_eq!(seen(&mut watch(), 3, &places), [0.0, 0.2, 0.4, 0.5, 0.6, 0.725, 0.8, 0.875]);
    let back = [places, vec![axes(140., 60., 0.)]].concat();
    assert_eq!(seen(&mut watch(), 3, &back).last(), Some(&0.95));
}

#[test]
fn a_step_begins_where_the_one_before_ends_although_that_is_reported_late() {
    let mut watch = watch();
    seen(&mut watch, 0, &[axes(0., 0., 0.), axes(31., 0., 0.)]);
    assert_eq!(seen(&mut watch, 1, &[axes(44., 90., 0.), axes(60., 90., 0.)]), [0.04, 0.2]);
    let next = [axes(70., 90., 0.), axes(80., 180., 0.), axes(100., 180., 0.)];
    assert_eq!(seen(&mut watch, 2, &next), [0.0, 0.0, 0.2]);
}

#[test]
fn the_way_back_of_the_bend_axis_is_no_bend_of_the_next_step_nor_is_the_pegs_way_to_its_side() {
    let mut watch = watch();
    seen(&mut watch, 0, &[axes(0., 0., 0.), axes(20., 0., 0.), axes(40., 90., -5.)]);
    let places = [axes(40., 90., -4.), axes(80., 90., 0.), axes(80., 180., 18.), axes(80., 180., -20.)];
    assert_eq!(seen(&mut watch, 1, &places), [0.0, 0.4, 0.6, 0.68]);
}

#[test]
fn a_bend_is_measured_from_where_its_axis_rests() {
    // Far from its zero, after homing.
    let homed = [axes(0., 0., -199.), axes(20., 0., -199.), axes(40., 90., -199.), axes(40., 90., -249.)];
    assert_eq!(seen(&mut watch(), 0, &homed), [0.0, 0.2, 0.6, 0.725]);
    // A machine whose axis stays: there is no way back.
    let mut staying = watch();
    seen(&mut staying, 0, &[axes(0., 0., 0.), axes(20., 0., 0.), axes(40., 90., -100.)]);
    let places = [axes(60., 90., -100.), axes(80., 180., -100.), axes(80., 180., -150.)];
    assert_eq!(seen(&mut staying, 1, &places), [0.2, 0.6, 0.725]);
}

#[test]
fn it_follows_a_zero_that_is_set_anew_for_the_next_wire() {
    let places = [axes(400., 0., 0.), axes(0., 0., 0.), axes(20., 0., 0.)];
    assert_eq!(seen(&mut watch(), 0, &places), [0.0, 0.0, 0.2]);
}

#[test]
fn a_position_of_before_the_step_is_no_new_zero() {
    let short = CommandedStep { commanded: axes(5.0, 0.0, 0.0), ..STEP };
    let mut watch = StepWatch::new(vec![STEP, short]);
    seen(&mut watch, 0, &[axes(100., 0., 0.), axes(110., 0., 0.)]);
    assert_eq!(seen(&mut watch, 1, &[axes(110., 0., 0.), axes(142., 90., 0.)]), [0.0, 0.16]);
}

#[test]
fn it_does_not_go_back_when_a_machine_draws_its_wire_back_and_not_past_the_end_of_the_step() {
    let places = [axes(0., 0., 0.), axes(20., 0., 0.), axes(18., 0., 0.)];
    assert_eq!(seen(&mut watch(), 0, &places), [0.0, 0.2, 0.2]);
    let mut watch = watch();
    seen(&mut watch, 0, &[axes(0., 0., 0.)]);
    assert!(watch.part(0, Some(axes(900., 900., -900.))) < 1.0);
}

#[test]
fn it_waits_for_a_position_and_for_a_step() {
    let mut watch = watch();
    assert_eq!((watch.part(0, None), watch.part(99, Some(axes(1., 2., 3.)))), (0.0, 0.0));
    let timeless = CommandedStep { seconds: StepSeconds::default(), ..STEP };
    let mut watch = StepWatch::new(vec![timeless]);
    assert_eq!(seen(&mut watch, 0, &[axes(1., 2., 3.), axes(9., 2., 3.)]), [0.0, 0.0]);
}

#[test]
fn it_takes_what_it_knows_anew_where_steps_were_missed() {
    let mut watch = watch();
    seen(&mut watch, 0, &[axes(0., 0., 0.), axes(30., 0., 0.)]);
    assert_eq!(seen(&mut watch, 4, &[axes(500., 0., 0.), axes(520., 0., 0.)]), [0.0, 0.2]);
}

/// On its way to where the peg comes out, and back from there, the axis passes where it bends to.
#[test]
fn a_bend_that_ends_before_zero_begins_where_the_peg_comes_out() {
    let step = CommandedStep {
        commanded: JobStep { approach_deg: Some(-20.0), ..axes(40.0, 0.0, -5.0) },
        seconds: StepSeconds { feed: 4.0, rotate: 0.0, bend: 4.0, wait: 2.0 },
    };
    let bend = [0.0, -10.0, -20.0, -12.5, -5.0, -12.5, -20.0, 0.0].map(|at| axes(40.0, 0.0, at));
    let places = [&[axes(0.0, 0.0, 0.0)][..], &bend].concat();
    let expected = [0.0, 0.4, 0.4, 0.4, 0.6, 0.7, 0.8, 0.9, 0.9];
    assert_eq!(seen(&mut StepWatch::new(vec![step]), 0, &places), expected);
}
