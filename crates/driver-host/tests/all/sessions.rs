//! A session with a machine that behaves: what may be done when, and what a stop ends.

use std::path::Path;

use serde_json::json;
use wirebend_driver_api::{Axis, Event, Motion, NumberedStep, Run, Step};
use wirebend_driver_host::{
    Armed, DiscoveredDriver, Driver, HostError, Launch, PermitKind, Phase, Place, Session, SessionError,
    Standstill, StoppedBy, TrustStore,
};

use crate::permits;

fn session() -> Session {
    session_with(&wirebend_tests_built::driver("hostile"))
}

fn session_with(library: &Path) -> Session {
    let trust = TrustStore::open("none.json".as_ref()).unwrap();
    let found = DiscoveredDriver::at(library, Place::App, &trust);
    let launch = Launch { program: wirebend_tests_built::driver_child(), memory_bytes: 256 << 20 };
    let open = Driver::start(&found, &launch).unwrap().open(&json!({})).unwrap();
    Session::connect(open, "anywhere", None).unwrap()
}

fn run(steps: u32) -> Run {
    Run { job_hash: "0".repeat(64), name: "test".into(), wire: 0, steps, ..Run::default() }
}

fn steps(numbers: std::ops::RangeInclusive<u32>) -> Vec<NumberedStep> {
    numbers
        .map(|n| NumberedStep {
            n,
            step: Step { feed_mm: 30.0, rotate_deg: 0.0, bend_deg: 45.0, approach_deg: None },
        })
        .collect()
}

fn homed() -> Session {
    let mut session = session();
    session.poll().unwrap();
    permits::home(&mut session).unwrap();
    session.poll().unwrap();
    session
}

fn running(total: u32) -> (Session, Armed) {
    let mut session = homed();
    let armed = permits::arm(&mut session, run(total)).unwrap();
    session.send(&armed, &steps(1..=2)).unwrap();
    session.poll().unwrap();
    (session, armed)
}

#[track_caller]
fn refused(result: Result<impl Sized, SessionError>) -> String {
    match result.map(drop).unwrap_err() {
        error @ SessionError::State { .. } => error.to_string(),
        other => panic!("{other}"),
    }
}

#[test]
fn a_wire_is_made_from_start_to_end() {
    let mut session = session();
    assert_eq!(session.phase(), Phase::Connecting);
    assert!(matches!(session.poll().unwrap()[..], [Event::Connected { homed: false, .. }]));
    assert_eq!(session.phase(), Phase::Connected);
    permits::home(&mut session).unwrap();
    session.poll().unwrap();
    assert_eq!(session.phase(), Phase::Ready);
    let armed = permits::arm(&mut session, run(3)).unwrap();
    assert_eq!(session.phase(), Phase::Armed);
    assert_eq!(session.send(&armed, &steps(1..=2)).unwrap().accepted, 2);
    session.poll().unwrap();
    assert_eq!((session.phase(), session.progress()), (Phase::Making, (2, 2)));
    session.pause().unwrap();
    session.poll().unwrap();
    assert_eq!(session.phase(), Phase::Holding);
    session.resume(&armed).unwrap();
    session.poll().unwrap();
    session.send(&armed, &steps(3..=3)).unwrap();
    let events = session.poll().unwrap();
    assert_eq!(events, [Event::Done { n: 3 }, Event::Finished]);
    assert!(session.is_done());
    // The next wire: armed anew, and the old token is worth nothing.
    let next = permits::arm(&mut session, run(3)).unwrap();
    assert!(matches!(session.send(&armed, &steps(1..=1)), Err(SessionError::Stale)));
    session.send(&next, &steps(1..=1)).unwrap();
    session.disconnect().unwrap().close().unwrap();
}

#[test]
fn nothing_moves_out_of_turn() {
    let mut session = session();
    assert!(refused(permits::home(&mut session)).contains("while the machine is being connected"));
    session.poll().unwrap();
    assert!(refused(permits::arm(&mut session, run(3))).contains("homed, or done"));
    assert!(refused(session.pause()).contains("running"));
    let mut session = homed();
    let armed = permits::arm_by_hand(&mut session).unwrap();
    // Its driver is older than that.
    let dry = Motion { dry: true, ..Motion::new(Axis::Bend, -5.0) };
    assert!(matches!(session.jog(&armed, dry), Err(SessionError::Unsupported { .. })));
    session.jog(&armed, Motion::new(Axis::Bend, -5.0)).unwrap();
    assert!(matches!(session.send(&armed, &steps(1..=1)), Err(SessionError::NotForAWire)));
    let (mut session, armed) = running(3);
    assert!(refused(session.jog(&armed, Motion::new(Axis::Feed, 1.0))).contains("no wire in hand"));
    assert!(refused(permits::home(&mut session)).contains("at rest"));
    assert!(refused(session.resume(&armed)).contains("paused"));
}

#[test]
fn steps_come_in_order_and_end_with_the_wire() {
    let (mut session, armed) = running(3);
    for wrong in [steps(4..=4), steps(2..=3), steps(3..=4), vec![]] {
        let error = session.send(&armed, &wrong).unwrap_err();
        assert!(matches!(error, SessionError::Steps { sent: 2, total: 3 }), "{error}");
    }
    assert_eq!(session.phase(), Phase::Making, "a wrong request changes nothing");
}

fn jog(axis: Axis, by: f64) -> Motion {
    Motion::new(axis, by)
}

/// A program counts from where the axes stand: a bend of 90° would become one of 110°.
#[test]
fn a_wire_starts_where_its_axes_are_at_zero() {
    let mut session = homed();
    let by_hand = permits::arm_by_hand(&mut session).unwrap();
    session.jog(&by_hand, jog(Axis::Feed, 100.0)).unwrap();
    session.jog(&by_hand, jog(Axis::Bend, 20.0)).unwrap();
    let error = permits::arm(&mut session, run(3)).unwrap_err();
    assert!(error.to_string().contains("bend axis 20.000°"), "{error}");
    let by_hand = permits::arm_by_hand(&mut session).unwrap();
    session.jog(&by_hand, jog(Axis::Bend, -20.0)).unwrap();
    permits::arm(&mut session, run(3)).unwrap();
}

/// The cables of the head have an end: two wires may not add up to a turn that neither has.
#[test]
fn the_head_is_turned_back_between_wires() {
    let mut session = homed();
    let armed = permits::arm(&mut session, run(1)).unwrap();
    let step = NumberedStep {
        n: 1,
        step: Step { feed_mm: 30.0, rotate_deg: 180.0, bend_deg: 45.0, approach_deg: None },
    };
    session.send(&armed, &[step]).unwrap();
    session.poll().unwrap();
    assert!(session.is_done());
    let error = permits::arm(&mut session, run(1)).unwrap_err();
    assert!(error.to_string().contains("the head stands 180.000°"), "{error}");
    permits::home(&mut session).unwrap();
    session.poll().unwrap();
    permits::arm(&mut session, run(1)).unwrap();
}

/// To a driver that does not know of it, such a bend would be one to the other side.
#[test]
fn a_bend_that_ends_before_zero_is_only_for_a_driver_that_can() {
    let mut session = homed();
    let armed = permits::arm(&mut session, run(2)).unwrap();
    let step = |n, bend_deg, approach_deg| NumberedStep {
        n,
        step: Step { feed_mm: 30.0, rotate_deg: 0.0, bend_deg, approach_deg: Some(approach_deg) },
    };
    for (bend, approach) in [(-5.0, -18.25), (0.0, 18.25), (5.0, 18.25)] {
        let error = session.send(&armed, &[step(1, bend, approach)]).unwrap_err().to_string();
        assert!(error.contains("step 1") && error.contains("which side"), "{error}");
    }
    session.send(&armed, &[step(1, 45.0, -18.25)]).unwrap();
}

#[test]
fn hands_stay_off_while_a_wire_is_in_hand() {
    let mut session = homed();
    let armed = permits::arm(&mut session, run(3)).unwrap();
    assert!(matches!(session.jog(&armed, jog(Axis::Feed, 1.0)), Err(SessionError::ForAWire)));
}

/// Two machines side by side.
#[test]
fn a_token_is_for_one_session() {
    let (mut one, mut other) = (homed(), homed());
    let armed = permits::arm(&mut one, run(3)).unwrap();
    let _of_other = permits::arm(&mut other, run(3)).unwrap();
    assert!(matches!(other.send(&armed, &steps(1..=1)), Err(SessionError::Stale)));
    one.send(&armed, &steps(1..=1)).unwrap();
}

/// With other steps for each millimetre every wire comes out wrong.
#[test]
fn settings_that_differ_are_accepted_by_a_person_or_nothing_is_made() {
    let folder = tempfile::tempdir().unwrap();
    let library = folder.path().join("connect-differ.so");
    wirebend_tests_built::place_hostile(&library);
    let mut session = session_with(&library);
    session.poll().unwrap();
    permits::home(&mut session).unwrap();
    session.poll().unwrap();
    let error = permits::arm(&mut session, run(3)).unwrap_err();
    assert!(error.to_string().contains("$100 is 80, not 40"), "{error}");
    permits::arm_by_hand(&mut session).unwrap();
    let permit = permits::yes(&mut session, PermitKind::Wire);
    session.accept_differences(&permit).unwrap();
    permits::arm(&mut session, run(3)).unwrap();
}

#[test]
fn a_stop_ends_the_permission_to_move() {
    let (mut session, armed) = running(5);
    let outcome = session.stop();
    // Sent is not stopped: that the machine says.
    assert_eq!((outcome.by, session.phase()), (StoppedBy::Driver, Phase::Stopping));
    assert_eq!(session.standstill(), Some(Standstill::Awaited));
    assert!(matches!(session.send(&armed, &steps(3..=3)), Err(SessionError::Stale)));
    assert!(matches!(session.resume(&armed), Err(SessionError::Stale)));
    assert!(refused(permits::arm(&mut session, run(3))).contains("while the machine is being stopped"));
    assert!(refused(permits::home(&mut session)).contains("while the machine is being stopped"));
    session.poll().unwrap();
    assert_eq!((session.phase(), session.standstill()), (Phase::Stopped, Some(Standstill::Confirmed)));
    permits::home(&mut session).unwrap();
    session.poll().unwrap();
    permits::arm(&mut session, run(3)).unwrap();
}

/// The window's button, Ctrl-C and the network of a workshop are all on other threads.
#[test]
fn a_stop_from_elsewhere_is_noticed_before_the_next_motion() {
    let (mut session, armed) = running(5);
    let handle = session.stop_handle();
    assert_eq!(std::thread::spawn(move || handle.stop()).join().unwrap().by, StoppedBy::Driver);
    assert!(matches!(session.send(&armed, &steps(3..=3)), Err(SessionError::Stale)));
    session.poll().unwrap();
    assert_eq!(session.phase(), Phase::Stopped);

    // Between being homed and being armed.
    let mut session = homed();
    assert_eq!(session.stop_handle().stop().by, StoppedBy::Driver);
    let error = permits::arm(&mut session, run(3)).unwrap_err();
    assert!(matches!(error, SessionError::Host(HostError::StoppedBefore { .. })), "{error}");
    assert_eq!(session.phase(), Phase::Stopping);
}

/// Between a person's yes and homing: it was for a machine that had not been stopped.
#[test]
fn a_machine_that_was_stopped_is_not_homed_at_a_word_of_before() {
    let mut session = homed();
    assert_eq!(session.stop_handle().stop().by, StoppedBy::Driver);
    assert!(matches!(permits::home(&mut session), Err(SessionError::Stale)));
    assert_eq!(session.poll().unwrap(), [], "it does not home");
    assert_eq!(session.phase(), Phase::Stopped);
    // At a new word it is, and the stop is history.
    assert_eq!(session.take_stop().map(|stop| stop.by), Some(StoppedBy::Driver));
    assert_eq!((session.last_stop(), session.phase()), (None, Phase::Stopped));
    permits::home(&mut session).unwrap();
    session.poll().unwrap();
    assert_eq!(session.phase(), Phase::Ready);
}

#[test]
fn a_driver_that_only_writes_files_has_no_session() {
    let trust = TrustStore::open("none.json".as_ref()).unwrap();
    let found = DiscoveredDriver::at(&wirebend_tests_built::driver("template"), Place::App, &trust);
    let launch = Launch { program: wirebend_tests_built::driver_child(), memory_bytes: 256 << 20 };
    let open = Driver::start(&found, &launch).unwrap().open(&json!({})).unwrap();
    let error = Session::connect(open, "anywhere", None).unwrap_err();
    assert!(
        matches!(error, SessionError::Unsupported { .. }) && error.to_string().contains("'live'"),
        "{error}"
    );
}

/// What is written is asked for again: a machine that has not kept it would bend by other numbers.
#[test]
fn settings_that_were_not_taken_are_seen_when_they_were_written() {
    let folder = tempfile::tempdir().unwrap();
    let library = folder.path().join("write-settings-differ.so");
    wirebend_tests_built::place_hostile(&library);
    let mut session = session_with(&library);
    assert!(refused(permits::write_settings(&mut session)).contains("while the machine is being connected"));
    session.poll().unwrap();
    permits::home(&mut session).unwrap();
    session.poll().unwrap();
    assert_eq!(session.differences(), []);
    permits::write_settings(&mut session).unwrap();
    assert_eq!(session.phase(), Phase::Connected, "with other settings its axes count otherwise");
    session.poll().unwrap();
    assert_eq!(session.differences()[0].machine, "80");
    permits::home(&mut session).unwrap();
    session.poll().unwrap();
    assert!(matches!(permits::arm(&mut session, run(3)), Err(SessionError::SettingsDiffer { .. })));
    let (mut session, _armed) = running(3);
    assert!(refused(permits::write_settings(&mut session)).contains("at rest"));
}

#[test]
fn ports_are_listed_before_one_is_opened() {
    let trust = TrustStore::open("none.json".as_ref()).unwrap();
    let launch = Launch { program: wirebend_tests_built::driver_child(), memory_bytes: 256 << 20 };
    let open = |folder: &str| {
        let found = DiscoveredDriver::at(&wirebend_tests_built::driver(folder), Place::App, &trust);
        Driver::start(&found, &launch).unwrap().open(&json!({})).unwrap()
    };
    let ports = open("hostile").ports().unwrap();
    assert_eq!((ports.len(), ports[0].name.as_str(), ports[0].likely), (1, "anywhere", true));
    let error = open("template").ports().unwrap_err();
    assert!(matches!(&error, HostError::Refused { error, .. } if error.code == "unsupported"), "{error}");
}

/// Taken at its word, the machine would be sent the rest of a wire that it never began.
#[test]
fn a_machine_goes_on_with_what_it_was_asked_for_alone() {
    let folder = tempfile::tempdir().unwrap();
    let library = folder.path().join("connect-lie.so");
    wirebend_tests_built::place_hostile(&library);
    let mut session = session_with(&library);
    session.poll().unwrap();
    assert_eq!((session.phase(), session.resume_state()), (Phase::Connected, None));
    let permit = permits::yes(&mut session, PermitKind::Wire);
    assert!(matches!(session.reattach(Run::default(), &[], 0.0, permit), Err(SessionError::State { .. })));

    let mut session =
        Session::connect_resuming(session.disconnect().unwrap(), "anywhere", "7", None).unwrap();
    assert!(matches!(session.poll(), Err(SessionError::OutOfOrder { .. })));
    assert_eq!(session.phase(), Phase::Failed);
}

/// The head stands where the finished part of the wire has left it, and is turned back before the next wire.
#[test]
fn the_rest_of_a_wire_begins_after_what_is_made() {
    let mut session = homed();
    let rest =
        |after, rotate_at_deg| Run { name: "test".into(), steps: 3, after, rotate_at_deg, ..Run::default() };
    for (after, rotate_at_deg) in [(4, 0.0), (1, f64::NAN)] {
        let error = permits::arm(&mut session, rest(after, rotate_at_deg)).unwrap_err();
        assert!(matches!(error, SessionError::Steps { .. }), "{after}, {rotate_at_deg}: {error}");
    }
    let armed = permits::arm(&mut session, rest(2, 30.0)).unwrap();
    assert_eq!((armed.token(), session.progress(), session.head_deg()), (Some("hostile-1"), (2, 2), 30.0));
    assert!(matches!(session.send(&armed, &steps(1..=3)), Err(SessionError::Steps { sent: 2, total: 3 })));
    session.send(&armed, &steps(3..=3)).unwrap();
    session.poll().unwrap();
    assert!(session.is_done());
    let error = permits::arm(&mut session, run(1)).unwrap_err();
    assert!(error.to_string().contains("the head stands 30.000°"), "{error}");
}

/// It would pass over how much is done, and bend from where its head happens to stand.
#[test]
fn a_driver_of_1_0_makes_whole_wires_alone() {
    let folder = tempfile::tempdir().unwrap();
    let library = folder.path().join("entry-old.so");
    wirebend_tests_built::place_hostile(&library);
    let mut session = session_with(&library);
    session.poll().unwrap();
    permits::home(&mut session).unwrap();
    session.poll().unwrap();
    let rest = Run { name: "test".into(), steps: 3, after: 1, ..Run::default() };
    let error = permits::arm(&mut session, rest).unwrap_err();
    assert!(matches!(error, SessionError::TooOld { after: 1, .. }), "{error}");
    permits::arm(&mut session, run(3)).unwrap();
}
