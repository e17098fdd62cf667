//! Wires that are interrupted: what the driver reports of where the axes stand, and what it asks for then.

use serde_json::json;
use wirebend_driver_api::{Event, MachineSession, Run, Step};

use crate::pty::model::Build;
use crate::pty::{Bench, arm_and_send, built, until, until_told};

/// A bend that takes the model a second.
const WIRE: [Step; 2] = [
    Step { feed_mm: 30.0, rotate_deg: 45.0, bend_deg: 90.0, approach_deg: None },
    Step { feed_mm: 10.0, rotate_deg: 0.0, bend_deg: 0.0, approach_deg: None },
];

/// A machine without switches, which a person has put to zero away from where it was switched on.
fn zeroed() -> Bench {
    let build = Build { switches: false, steps_a_turn: 8, ..Build::default() };
    let mut bench = built(json!({"pin_dwell_s": 0}), build);
    let session = bench.session.as_mut();
    until(session, |event| matches!(event, Event::Connected { .. }));
    home(session);
    for (axis, by) in [(wirebend_driver_api::Axis::Rotate, -20.0), (wirebend_driver_api::Axis::Bend, 5.0)] {
        session.jog(wirebend_driver_api::Motion::new(axis, by)).unwrap();
        until(session, |event| *event == Event::Jogged);
    }
    home(session);
    bench
}

fn home(session: &mut dyn MachineSession) {
    session.home().unwrap();
    assert_eq!(until(session, |event| *event == Event::Homed), [Event::Homed]);
}

/// In the middle of the bend.
fn bending() -> Bench {
    let mut bench = zeroed();
    arm_and_send(bench.session.as_mut(), &WIRE);
    let model = &bench.model;
    until_told(bench.session.as_mut(), |_| model.now().pin_out && model.now().at[2] > 5.0 + 30.0);
    bench
}

fn is_position(event: &Event) -> bool {
    matches!(event, Event::Position(_))
}

const fn is_part(event: &Event) -> bool {
    matches!(event, Event::PartMade { .. })
}

/// What is reported of the step that was ended in its middle, against where the machine stands.
#[track_caller]
fn assert_part(told: &[Event], of: u32, at: Option<[f64; 3]>, exactly: bool) {
    let parts: Vec<_> = told.iter().filter(|event| is_part(event)).collect();
    let [Event::PartMade { step, made, exact }] = parts.as_slice() else { panic!("{parts:?}") };
    assert_eq!((*step, made.is_some(), *exact), (of, at.is_some(), exactly));
    let (Some(made), Some(at)) = (made, at) else { return };
    let same = |a: f64, b: f64| (a - b).abs() < 0.001;
    let [feed, rotate, bend] = at;
    let so =
        same(made.feed_mm, feed) && same(made.rotate_deg, rotate + 20.0) && same(made.bend_deg, bend - 5.0);
    assert!(so, "{made:?} {at:?}");
}

/// Where the last position that was reported is, and where the machine stands, both from where the wire began.
#[track_caller]
fn assert_told(bench: &Bench, told: &[Event]) {
    let Some(Event::Position(told)) = told.iter().rev().find(|event| is_position(event)) else {
        panic!("no position is reported: {told:?}")
    };
    let now = bench.model.now().at;
    let began = [0.0, -20.0, 5.0];
    let [feed, rotate, bend]: [f64; 3] = std::array::from_fn(|axis| now[axis] - began[axis]);
    // A last digit of a report.
    let same = |a: f64, b: f64| (a - b).abs() < 0.001;
    assert!(
        same(told.feed_mm, feed) && same(told.rotate_deg, rotate) && same(told.bend_deg, bend),
        "{told:?} {now:?}"
    );
    assert!(
        feed > 29.9 && rotate > 44.9 && (30.0..90.0).contains(&bend),
        "in the middle of the bend: {now:?}"
    );
}

fn refuses_to_arm(session: &mut dyn MachineSession) {
    let run = Run { job_hash: "5a".repeat(32), name: "corner".to_owned(), steps: 2, ..Run::default() };
    let code = session.arm(&run).expect_err("it was not confirmed where the axes stand").code;
    assert!(code == "not-homed" || code == "alarm", "{code}");
}

/// G92 is lost with the reset: positions count on from where the wire began anyway, or the program could not tell how
/// far the step has come.
#[test]
fn a_stop_tells_how_far_the_step_has_come() {
    let mut bench = bending();
    let session = bench.session.as_mut();
    session.stop().unwrap();
    let told = until_told(session, |event| matches!(event, Event::Stopped { .. }));
    assert_eq!(told.last(), Some(&Event::Stopped { homed: false }));
    let last = told.iter().rposition(is_position).unwrap();
    let reset = told
        .iter()
        .rposition(|event| matches!(event, Event::Console { text, .. } if text.starts_with("Grbl")));
    assert!(reset.unwrap() < last, "it is reported once the machine stands");
    assert_told(&bench, &told);
    // grbl itself says that a reset in motion may lose steps.
    assert_part(&told, 1, Some(bench.model.now().at), false);
    refuses_to_arm(bench.session.as_mut());
    // A zero that a person sets anew counts from there.
    home(bench.session.as_mut());
}

/// grbl does nothing for half a second after an alarm of its switches, and forgets a reset that comes before it says that
/// it waits for one.
#[test]
fn an_alarm_tells_how_far_the_step_has_come() {
    let mut bench = bending();
    bench.model.hit_limit();
    let session = bench.session.as_mut();
    let events = until(session, |event| matches!(event, Event::Fault { .. }));
    let [Event::Fault { error, in_doubt: Some(1), disconnected: false }] = events.as_slice() else {
        panic!("{events:?}")
    };
    assert_eq!(error.code, "grbl-alarm-1");
    let told = until_told(session, is_position);
    let answers = |event: &&Event| matches!(event, Event::Console { text, .. } if text == "\\x18");
    assert_eq!(told.iter().filter(answers).count(), 2, "at once, and when it is waited for: {told:?}");
    assert_told(&bench, &told);
    assert_eq!(bench.model.resets(), 2);
    let told = until_told(bench.session.as_mut(), is_part);
    assert_part(&told, 1, None, false);
    refuses_to_arm(bench.session.as_mut());
}

/// A board that has started anew counts from zero wherever it stands: nothing that it says of that is reported.
#[test]
fn a_board_that_starts_anew_does_not_know_where_it_stands() {
    let mut bench = bending();
    bench.model.cut_power();
    let session = bench.session.as_mut();
    let events = until(session, |event| matches!(event, Event::Fault { .. }));
    let Some(Event::Fault { error, in_doubt: Some(1), .. }) = events.last() else { panic!("{events:?}") };
    assert_eq!(error.code, "controller-reset");
    let resting = |event: &Event| matches!(event, Event::Console { text, .. } if text.starts_with("<Idle"));
    let told = until_told(session, resting);
    assert!(!told.iter().any(is_position), "{told:?}");
    let told = [told, until_told(session, is_part)].concat();
    assert_part(&told, 1, None, false);
    refuses_to_arm(bench.session.as_mut());
    home(bench.session.as_mut());
    let told = until_told(bench.session.as_mut(), is_position);
    assert_eq!(told.last(), Some(&Event::Position(Step::default())));
}

/// What slows down before it is reset keeps its place.
#[test]
fn a_hold_before_the_stop_tells_exactly_how_far_the_step_has_come() {
    let mut bench = bending();
    let session = bench.session.as_mut();
    session.pause().unwrap();
    until(session, |event| matches!(event, Event::Paused { .. }));
    session.stop().unwrap();
    let told = until_told(session, |event| matches!(event, Event::Stopped { .. }));
    assert_part(&told, 1, Some(bench.model.now().at), true);
}
