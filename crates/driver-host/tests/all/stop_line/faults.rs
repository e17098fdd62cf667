//! A fault that the driver itself reports while the machine may move: the run is over, and the machine is not yet.

use std::time::{Duration, Instant};

use serde_json::json;
use wirebend_driver_api::Event;
use wirebend_driver_host::{Phase, Session, SessionError, Standstill};

use super::lost::{Kept, STATES, in_state, is_stopped, settles};
use super::port::Port;
use super::{connected, opened};
use crate::permits;

/// Polls until the driver has reported its fault.
#[track_caller]
fn faults(session: &mut Session, case: &str) {
    let events = session.poll().unwrap();
    assert!(events.iter().any(|event| matches!(event, Event::Fault { .. })), "{case}: {events:?}");
    assert_eq!(session.phase(), Phase::Failed, "{case}");
    // No person has asked for this stop.
    assert_eq!(session.last_stop(), None, "{case}");
}

/// The driver gets the stop, and passes the machine's confirmation on.
#[test]
fn a_machine_whose_driver_tells_of_a_fault_is_stopped_through_it() {
    let folder = tempfile::tempdir().unwrap();
    for state in STATES {
        let (port, kept) = (Port::new(), Kept::new(folder.path(), "fault"));
        let (mut session, _armed) = in_state(&kept.library, &port, state);
        kept.let_loose();
        faults(&mut session, state);
        assert_eq!(session.standstill(), Some(Standstill::Awaited), "{state}");
        settles(&mut session, Standstill::Confirmed, state);
        assert_eq!(port.heard_so_far(), b"", "{state}: the driver has done it");
    }
}

/// It takes the stop and never says that the machine stands.
#[test]
fn a_driver_that_does_not_confirm_after_its_fault_is_taken_over() {
    let folder = tempfile::tempdir().unwrap();
    let (port, kept) = (Port::new(), Kept::new(folder.path(), "numb"));
    let (mut session, _armed) = in_state(&kept.library, &port, "running");
    kept.let_loose();
    faults(&mut session, "numb");
    let begun = Instant::now();
    while port.heard_so_far().is_empty() && begun.elapsed() < Duration::from_secs(20) {
        session.poll().unwrap();
    }
    is_stopped(&mut session, &port, "numb");
}

/// It has let the port go, and refuses the stop.
#[test]
fn a_machine_whose_driver_has_given_up_is_stopped_by_the_program() {
    let folder = tempfile::tempdir().unwrap();
    for state in STATES {
        let (port, kept) = (Port::new(), Kept::new(folder.path(), "gone"));
        let (mut session, _armed) = in_state(&kept.library, &port, state);
        kept.let_loose();
        faults(&mut session, state);
        is_stopped(&mut session, &port, state);
    }
}

/// Until it stands, or is given up, nothing else is asked of it.
#[test]
fn a_machine_that_is_being_stopped_after_a_fault_is_not_homed() {
    let folder = tempfile::tempdir().unwrap();
    let (port, kept) = (Port::new(), Kept::new(folder.path(), "fault"));
    let (mut session, armed) = in_state(&kept.library, &port, "running");
    kept.let_loose();
    faults(&mut session, "homing");
    let refused = |result: Result<(), SessionError>| {
        let error = result.unwrap_err();
        assert!(matches!(error, SessionError::State { .. }), "{error}");
        assert!(error.to_string().contains("being stopped"), "{error}");
    };
    refused(permits::write_settings(&mut session));
    refused(permits::home(&mut session));
    assert!(session.resume(&armed.unwrap()).is_err());
    settles(&mut session, Standstill::Confirmed, "homing");
    permits::home(&mut session).unwrap();
    session.poll().unwrap();
    assert_eq!(session.phase(), Phase::Ready);
}

/// There is no driver to stop it, and there are no stop bytes.
#[test]
fn a_machine_without_stop_bytes_whose_driver_has_given_up_may_still_move() {
    let folder = tempfile::tempdir().unwrap();
    let kept = Kept::new(folder.path(), "gone");
    let mut session = Session::connect(opened(&kept.library, &json!({})), "anywhere", None).unwrap();
    session.poll().unwrap();
    permits::home(&mut session).unwrap();
    kept.let_loose();
    faults(&mut session, "no stop bytes");
    assert_eq!(session.standstill(), Some(Standstill::NotConfirmed));
}

/// Were it stopped, a machine that waits for its next wire would have to be homed for nothing.
#[test]
fn a_machine_at_rest_is_left_alone_after_a_fault() {
    let folder = tempfile::tempdir().unwrap();
    let (port, kept) = (Port::new(), Kept::new(folder.path(), "fault"));
    let mut session = connected(&kept.library, &port);
    session.poll().unwrap();
    permits::home(&mut session).unwrap();
    session.poll().unwrap();
    kept.let_loose();
    faults(&mut session, "at rest");
    assert_eq!((session.standstill(), port.heard_so_far().as_slice()), (None, &[][..]));
}
