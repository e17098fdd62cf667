//! The driver as the program uses it, on the simulated machine.

mod table;

use std::time::Duration;

use serde_json::json;
use table::Table;
use wirebend_driver_api::{Axis, Direction, Event, HeadBy, Motion, PausedBy, Step};

#[test]
fn a_machine_is_met_homed_and_armed() {
    let mut table = Table::new(json!({}));
    let Event::Connected { identity, settings, homed, resume, .. } = table.connected() else { panic!() };
    assert_eq!((identity.as_str(), homed, resume), ("WireBend-kit, firmware 1.13", false, None));
    assert_eq!(settings, [], "a machine that was set up as its profile says");
    table.home();
    let token = table.arm(0, 1, 0.0);
    assert!(token.ends_with("-0"), "{token}");
}

/// The published cube: eight edges of 30 mm with seven right angles, every second pair in another plane.
/// Lengths and angles by the equations of the paper, written out: 30 - 2 (3 tan 45°) + 2.4 π/2 between two
/// bends, 110.398° for a right angle and 10.23° of springback.
fn cube(compensated: bool) -> Vec<Step> {
    let (end, between, bend) = if compensated {
        (30.0 - 3.0, 30.0 - 6.0 + 2.4 * std::f64::consts::FRAC_PI_2, 110.398_337)
    } else {
        (30.0, 30.0, 90.0)
    };
    let arc = if compensated { 2.4 * std::f64::consts::FRAC_PI_2 } else { 0.0 };
    let turns = [0.0, 0.0, -90.0, 0.0, 90.0, 0.0, -90.0, 0.0];
    let step = |(k, rotate_deg): (usize, f64)| match k {
        0 => Step { feed_mm: end + arc, rotate_deg, bend_deg: bend, approach_deg: None },
        7 => Step { feed_mm: end, rotate_deg: 0.0, bend_deg: 0.0, approach_deg: None },
        _ => Step { feed_mm: between, rotate_deg, bend_deg: bend, approach_deg: None },
    };
    turns.into_iter().enumerate().map(step).collect()
}

/// The corners of the same by a turtle of its own.
fn corners() -> Vec<[f64; 3]> {
    use nalgebra::{Rotation3, Unit, Vector3};
    let mut frame = Rotation3::identity();
    let mut at = Vector3::zeros();
    let mut corners = vec![[0.0; 3]];
    for (k, step) in cube(false).iter().enumerate() {
        at += frame * Vector3::x() * 30.0;
        corners.push([at.x, at.y, at.z]);
        let about = |axis: Vector3<f64>, deg: f64| {
            Rotation3::from_axis_angle(&Unit::new_normalize(axis), deg.to_radians())
        };
        let bend = if k < 7 { 90.0 } else { 0.0 };
        frame = frame * about(Vector3::x(), step.rotate_deg) * about(Vector3::z(), bend);
    }
    corners
}

fn worst(made: &[[f64; 3]]) -> f64 {
    let design = corners();
    assert_eq!(made.len(), design.len(), "corners of the wire");
    let apart = |(a, b): (&[f64; 3], &[f64; 3])| (0..3).map(|k| (a[k] - b[k]).powi(2)).sum::<f64>().sqrt();
    made.iter().zip(&design).map(apart).fold(0.0, f64::max)
}

#[test]
fn a_cube_comes_out_as_designed_when_it_is_compensated_for() {
    let made = |compensated| {
        let mut table = Table::new(json!({}));
        table.connected();
        table.home();
        table.make(&cube(compensated))
    };
    let (with, without) = (worst(&made(true)), worst(&made(false)));
    println!("worst corner: {with:.3} mm compensated, {without:.3} mm not");
    assert!(with < 0.5, "{with} mm");
    assert!(without > 10.0 * with, "{without} mm without compensation");
}

/// A computer that is busy looks rarely. Between two looks at a machine in real time much less than a second passes; at one that
/// runs 10,000 times as fast 20 s do, in which it would think that no program is there, and hold.
#[test]
fn a_fast_machine_that_is_looked_at_rarely_does_not_hold() {
    let mut table = Table::at("sim:10000", json!({}));
    table.rarely = Duration::from_millis(2);
    table.connected();
    table.home();
    table.jog(Motion::new(Axis::Feed, 200.0));
    assert!((table.position().feed_mm - 200.0).abs() < 0.1);
}

/// A jog of the bend axis would bend a wire, were there one. In a dry run the peg stays in, and the axis is at zero in the end.
#[test]
fn a_move_of_a_dry_run_is_sent_as_one() {
    let mut table = Table::new(json!({}));
    table.connected();
    table.home();
    let sent = |table: &mut Table, motion: Motion| -> Vec<char> {
        table.seen.clear();
        table.jog(motion);
        let lines = table.seen.iter().filter_map(|event| match event {
            Event::Console { direction: Direction::ToMachine, text } => text.chars().next(),
            _ => None,
        });
        lines.filter(|letter| matches!(letter, 'M' | 'Y')).collect()
    };
    let dry = |axis, by| Motion { dry: true, ..Motion::new(axis, by) };
    assert_eq!(sent(&mut table, Motion::new(Axis::Bend, 30.0)), ['M']);
    assert_eq!(sent(&mut table, dry(Axis::Rotate, 90.0)), ['Y']);
    assert_eq!(sent(&mut table, dry(Axis::Bend, -80.0)), ['Y']);
    let at = table.position();
    assert!(at.bend_deg.abs() < 1e-9 && (at.rotate_deg - 90.0).abs() < 0.03, "{at:?}");
    let refused = table.session.jog(dry(Axis::Bend, 500.0)).unwrap_err();
    assert_eq!(refused.code, "beyond");
}

/// A wire that was slowed down does not slow down what comes after it.
#[test]
fn the_speed_override_ends_with_its_wire() {
    let mut table = Table::new(json!({}));
    table.connected();
    table.home();
    let steps = cube(true);
    table.arm(0, u32::try_from(steps.len()).unwrap(), 0.0);
    assert_eq!(table.session.set_speed(150).unwrap_err().code, "no-faster");
    table.session.set_speed(40).unwrap();
    table.until(|event| *event == Event::Speed { percent: 40 });
    table.send(&steps);
    table.until(|event| *event == Event::Finished);
    table.until(|event| *event == Event::Speed { percent: 100 });
}

/// Homing turns the head back, so that the next wire starts from zero.
#[test]
fn homing_turns_the_head_back() {
    let mut table = Table::new(json!({}));
    table.connected();
    table.home();
    table.jog(Motion::new(Axis::Rotate, 90.0));
    assert!((table.position().rotate_deg - 90.0).abs() < 0.03);
    table.home();
    assert!(table.position().rotate_deg.abs() < 1e-9);
}

/// A controller that was switched on counts its head from wherever it stands. With that position set, homing unwinds the cable,
/// and its own limit counts from there, too.
#[test]
fn homing_turns_a_head_back_that_stands_where_the_program_says() {
    let mut table = Table::new(json!({}));
    let Event::Connected { head, .. } = table.connected() else { unreachable!() };
    assert_eq!(head, HeadBy::Program);
    let beyond = table.session.home_from(450.0).unwrap_err();
    assert_eq!(beyond.code, "head-beyond");
    table.session.home_from(-270.0).unwrap();
    table.until(|event| *event == Event::Homed);
    assert!(table.position().rotate_deg.abs() < 1e-9);
    let told = table.seen.iter().filter_map(|event| match event {
        Event::Position(step) => Some(step.rotate_deg),
        _ => None,
    });
    let least = told.fold(0.0, f64::min);
    assert!((least + 270.0).abs() < 0.03, "it was never sent there: {least}");
    table.jog(Motion::new(Axis::Rotate, 350.0));
}

/// A wire that is resumed needs the head where the finished part has left it, to the step.
#[test]
fn after_a_stop_the_head_is_turned_again_as_far_as_it_was() {
    let steps = [0.0, -90.0, 0.0].map(|rotate_deg| Step {
        feed_mm: 30.0,
        rotate_deg,
        bend_deg: 60.0,
        approach_deg: None,
    });
    let mut table = Table::new(json!({}));
    table.connected();
    table.home();
    table.arm(0, 3, 0.0);
    table.send(&steps);
    table.until(|event| matches!(event, Event::Done { n: 2 }));
    table.session.stop().unwrap();
    table.stopped = true;
    table.until(|event| matches!(event, Event::Stopped { .. }));
    table.home();
    table.arm(2, 3, -90.0);
    table.send(&steps);
    table.until(|event| *event == Event::Finished);
    let stands = table.position().rotate_deg;
    assert!((stands + 90.0).abs() < 0.03, "{stands}");
}

/// The wire of before the stop and the rest of it lie in one plane where they should, although the head has play: it was last turned against
/// the way on which it comes from zero. Turned with the step alone, as before, the rest lies aside by the play.
#[test]
fn a_head_with_play_is_turned_to_its_place_by_a_move_of_its_own() {
    let steps = [(0.0, 60.0), (-90.0, 60.0), (30.0, 60.0), (0.0, 60.0), (0.0, 0.0)]
        .map(|(rotate_deg, bend_deg)| Step { feed_mm: 40.0, rotate_deg, bend_deg, approach_deg: None });
    let begun = || {
        let mut table = Table::new(json!({}));
        table.backlash_deg = 1.5;
        table.connected();
        table.home();
        table
    };
    let whole = begun().make(&steps);
    let resumed = |rotate_at_deg: f64, more: f64| {
        let mut table = begun();
        table.arm(0, 5, 0.0);
        table.send_part(&steps[..3], false);
        table.until(|event| matches!(event, Event::Done { n: 3 }));
        table.session.stop().unwrap();
        table.stopped = true;
        table.until(|event| matches!(event, Event::Stopped { .. }));
        table.home();
        table.arm(3, 5, rotate_at_deg);
        let mut rest = steps;
        rest[3].rotate_deg = more;
        table.send(&rest);
        let made = table.until(|event| matches!(event, Event::Made { .. }));
        let Event::Made { corners_mm, .. } = made else { unreachable!() };
        let off = corners_mm
            .iter()
            .zip(&whole)
            .map(|(made, whole)| (0..3).map(|axis| (made[axis] - whole[axis]).powi(2)).sum::<f64>().sqrt());
        off.fold(0.0, f64::max)
    };
    let (there_and_back, straight) = (resumed(-62.5, 2.5), resumed(-60.0, 0.0));
    assert!(there_and_back < 0.1, "{there_and_back} mm");
    assert!(straight > 0.5, "{straight} mm");
}

/// The head goes there and back before the first bend.
#[test]
fn a_wire_is_whole_that_takes_up_the_play_of_the_head_first() {
    let mut steps = [(0.0, 60.0), (-90.0, 60.0), (0.0, 0.0)].map(|(rotate_deg, bend_deg)| Step {
        feed_mm: 40.0,
        rotate_deg,
        bend_deg,
        approach_deg: None,
    });
    let mut begun = |at_deg: f64| {
        let mut table = Table::new(json!({}));
        table.backlash_deg = 1.5;
        table.connected();
        table.home();
        table.arm(0, 3, at_deg);
        steps[0].rotate_deg = -at_deg;
        table.send(&steps);
        let Event::Made { corners_mm, .. } = table.until(|event| matches!(event, Event::Made { .. })) else {
            unreachable!()
        };
        corners_mm
    };
    let (at_zero, before) = (begun(0.0), begun(2.5));
    assert_eq!(at_zero.len(), before.len());
    // All of it is turned by the play, as no head knows where in that its zero is.
    let apart = |made: &[[f64; 3]], k: usize, l: usize| {
        (0..3).map(|axis| (made[k][axis] - made[l][axis]).powi(2)).sum::<f64>().sqrt()
    };
    for k in 0..at_zero.len() {
        for l in 0..k {
            let (a, b) = (apart(&at_zero, k, l), apart(&before, k, l));
            assert!((a - b).abs() < 0.05, "{k} and {l}: {a} and {b}");
        }
    }
}

#[test]
fn a_stop_ends_everything_until_the_machine_is_homed() {
    let mut table = Table::new(json!({}));
    table.connected();
    table.home();
    table.arm(0, 8, 0.0);
    table.send(&cube(true));
    table.until(|event| matches!(event, Event::Done { n: 2 }));
    table.session.stop().unwrap();
    table.stopped = true;
    assert_eq!(table.until(|event| matches!(event, Event::Stopped { .. })), Event::Stopped { homed: false });
    let refused = table.session.jog(Motion::new(Axis::Feed, 1.0)).unwrap_err();
    assert_eq!(refused.code, "not-homed");
    table.home();
    table.jog(Motion::new(Axis::Feed, 1.0));
}

/// A startled user presses STOP more than once. How far the step had come is asked once more each time, and reported.
#[test]
fn a_stop_that_is_repeated_still_tells_how_far_the_step_had_come() {
    let steps = [Step { feed_mm: 30.0, rotate_deg: 0.0, bend_deg: 60.0, approach_deg: None }; 3];
    for looks in 0..12 {
        let mut table = Table::new(json!({}));
        table.connected();
        table.home();
        table.arm(0, 3, 0.0);
        table.send(&steps);
        table.until(|event| matches!(event, Event::Done { n: 1 }));
        table.session.stop().unwrap();
        for _ in 0..looks {
            table.seen.extend(table.session.poll().unwrap());
        }
        table.session.stop().unwrap();
        table.stopped = true;
        table.until(|event| matches!(event, Event::Stopped { .. }));
        let told = table.seen.iter().find_map(|event| match event {
            Event::PartMade { step, made, .. } => Some((*step, made.is_some())),
            _ => None,
        });
        assert_eq!(told, Some((2, true)), "stopped again after {looks} looks: {:?}", table.seen);
    }
}

/// Turns of the axes by hand meanwhile were not counted: this is reported, and nothing is moved before it was homed.
#[test]
fn motors_that_were_released_at_rest_ask_for_homing() {
    let mut table = Table::new(json!({ "release_after_s": 5 }));
    let Event::Connected { settings, .. } = table.connected() else { panic!() };
    assert_eq!(settings, []);
    table.home();
    table.stopped = true; // a warning is what is waited for
    let warning = table.until(|event| matches!(event, Event::Warning(_)));
    let Event::Warning(warning) = warning else { unreachable!() };
    assert_eq!(warning.code, "released");
    table.until(|event| *event == Event::Stopped { homed: false });
    assert_eq!(table.session.jog(Motion::new(Axis::Feed, 1.0)).unwrap_err().code, "not-homed");
    table.home();
    table.jog(Motion::new(Axis::Feed, 1.0));
}

#[test]
fn a_pause_holds_and_is_left() {
    let mut table = Table::new(json!({}));
    table.connected();
    table.home();
    table.arm(0, 8, 0.0);
    table.send(&cube(true));
    table.until(|event| matches!(event, Event::Done { n: 1 }));
    table.session.pause().unwrap();
    table.until(|event| *event == Event::Paused { by: PausedBy::Program });
    let stands = table.position();
    table.session.resume().unwrap();
    table.until(|event| *event == Event::Resumed);
    table.until(|event| *event == Event::Finished);
    assert!((table.position().feed_mm - stands.feed_mm) > 100.0);
}

/// Other settings than those of the machine are reported, and written when a person says so.
#[test]
fn settings_are_written_and_read_back() {
    let mut table =
        Table::new(json!({ "feed_steps_per_mm": 48.0, "peg_out_us": 1900, "bend_inverted": true }));
    table.connected();
    table.home();
    table.session.write_settings().unwrap();
    let written = table.until(|event| matches!(event, Event::SettingsWritten { .. }));
    let Event::SettingsWritten { settings, limits } = written else { panic!("{written:?}") };
    assert_eq!(settings, []);
    let feed = limits.limits.iter().find(|limit| limit.axis == Axis::Feed).unwrap();
    // `feed_most_mm`, in whole steps by now.
    assert!((feed.most - 7347.54).abs() < 1.0 / 48.0, "{feed:?}");
    assert_eq!(table.session.jog(Motion::new(Axis::Feed, 1.0)).unwrap_err().code, "not-homed");
    table.home();
}

#[test]
fn what_the_machine_cannot_make_is_refused_before_it_is_sent() {
    let mut table = Table::new(json!({}));
    table.connected();
    table.home();
    table.arm(0, 1, 0.0);
    for step in [
        Step { feed_mm: 8000.0, rotate_deg: 0.0, bend_deg: 0.0, approach_deg: None },
        Step { feed_mm: 10.0, rotate_deg: 800.0, bend_deg: 0.0, approach_deg: None },
        Step { feed_mm: 10.0, rotate_deg: 0.0, bend_deg: 155.1, approach_deg: None },
        Step { feed_mm: f64::NAN, rotate_deg: 0.0, bend_deg: 0.0, approach_deg: None },
    ] {
        assert_eq!(table.refused(step).code, "beyond", "{step:?}");
    }
}
