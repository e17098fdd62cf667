//! Lines that a person types: what may be asked when, and what is known of the machine afterwards.

use serde_json::json;
use wirebend_driver_api::{Event, Run};
use wirebend_driver_host::{DiscoveredDriver, Place, TrustStore};
use wirebend_driver_host::{Driver, Launch, PermitKind, Phase, Session, SessionError};

use crate::permits;

fn homed_with(library: &std::path::Path) -> Session {
    let trust = TrustStore::open("none.json".as_ref()).unwrap();
    let found = DiscoveredDriver::at(library, Place::App, &trust);
    let launch = Launch { program: wirebend_tests_built::driver_child(), memory_bytes: 256 << 20 };
    let open = Driver::start(&found, &launch).unwrap().open(&json!({})).unwrap();
    let mut session = Session::connect(open, "anywhere", None).unwrap();
    session.poll().unwrap();
    permits::home(&mut session).unwrap();
    session.poll().unwrap();
    assert_eq!(session.phase(), Phase::Ready);
    session
}

fn homed() -> Session {
    homed_with(&wirebend_tests_built::driver("hostile"))
}

#[test]
fn a_question_needs_no_permit_and_changes_nothing() {
    let mut session = homed();
    assert!(session.question("?what").unwrap());
    let events = session.poll().unwrap();
    assert!(matches!(events.last(), Some(Event::ConsoleDone { homed: true, moved: false })), "{events:?}");
    assert_eq!(session.phase(), Phase::Ready);
    // What may move is no question, and nothing is sent of it.
    assert!(!session.question("G1 X10").unwrap());
    assert_eq!((session.poll().unwrap(), session.phase()), (Vec::new(), Phase::Ready));
}

/// A driver that is wrong about what a line does must not have a wire begin where its axes are not.
#[test]
fn after_a_command_the_machine_has_to_be_homed_whatever_its_driver_says() {
    let folder = tempfile::tempdir().unwrap();
    let lying = folder.path().join("console-lie.so");
    std::fs::copy(wirebend_tests_built::driver("hostile"), &lying).unwrap();
    for mut session in [homed(), homed_with(&lying)] {
        permits::command(&mut session, "G1 X10").unwrap();
        assert!(session.phase().is_under_way(), "{}", session.phase());
        session.poll().unwrap();
        assert_eq!(session.phase(), Phase::Connected);
        let run = Run { steps: 1, ..Run::default() };
        assert!(matches!(permits::arm(&mut session, run), Err(SessionError::State { .. })));
    }
}

#[test]
fn a_command_needs_a_permit_of_its_own() {
    let mut session = homed();
    let permit = permits::yes(&mut session, PermitKind::ByHand);
    assert!(matches!(session.command("G1 X10", permit), Err(SessionError::NotPermitted { .. })));
    let permit = permits::yes(&mut session, PermitKind::Console);
    let _ = session.stop();
    assert!(session.command("G1 X10", permit).is_err());
}

#[test]
fn nothing_is_typed_while_a_wire_is_armed() {
    let mut session = homed();
    let _armed = permits::arm(&mut session, Run { steps: 1, ..Run::default() }).unwrap();
    assert!(matches!(session.question("?"), Err(SessionError::State { .. })));
    assert!(matches!(permits::command(&mut session, "G1 X10"), Err(SessionError::State { .. })));
}

/// To the driver they would be something else than what a person reads.
#[test]
fn what_is_no_line_of_text_is_sent_to_no_driver() {
    let mut session = homed();
    for typed in ["", "  ", "?\u{18}", "?\nG1 X10", "?\0"] {
        let error = session.question(typed).unwrap_err().to_string();
        assert!(error.contains("line"), "{typed:?}: {error}");
    }
    assert_eq!(session.poll().unwrap(), []);
}
