//! What a person's yes is good for: one question, one session, once, and not after a stop.

use serde_json::json;
use wirebend_driver_api::Run;
use wirebend_driver_host::{
    DiscoveredDriver, Driver, Launch, PermitKind, Phase, Place, Session, SessionError, TrustStore,
};
use wirebend_error::ErrorRemedy;

use crate::permits;

fn session_at(driver: &str, port: &str) -> Session {
    let trust = TrustStore::open("none.json".as_ref()).unwrap();
    let found = DiscoveredDriver::at(&wirebend_tests_built::driver(driver), Place::App, &trust);
    let launch = Launch { program: wirebend_tests_built::driver_child(), memory_bytes: 256 << 20 };
    let open = Driver::start(&found, &launch).unwrap().open(&json!({})).unwrap();
    let mut session = Session::connect(open, port, None).unwrap();
    while session.phase() == Phase::Connecting {
        session.poll().unwrap();
    }
    session
}

fn session() -> Session {
    session_at("hostile", "anywhere")
}

fn homed() -> Session {
    let mut session = session();
    permits::home(&mut session).unwrap();
    session.poll().unwrap();
    session
}

fn run() -> Run {
    Run { job_hash: "0".repeat(64), name: "test".into(), steps: 3, ..Run::default() }
}

#[track_caller]
fn code(result: Result<impl Sized, SessionError>) -> &'static str {
    result.map(drop).unwrap_err().code().as_str()
}

/// A user who clicks twice has looked at the machine once.
#[test]
fn a_yes_is_taken_once() {
    let mut session = homed();
    let asked = session.ask(PermitKind::Wire);
    let (first, second) = (asked.confirm(), asked.confirm());
    let permit = session.permit(first).unwrap();
    assert_eq!(code(session.permit(second)), "confirmation-used");
    // And what it permits is one wire: arming takes the permit away.
    session.arm(run(), permit).unwrap();
}

/// It permits wires one after the other, and cuts between them, until the machine is stopped; a yes to one wire permits no cut.
#[test]
fn a_yes_to_a_row_lasts_until_a_stop() {
    let mut session = homed();
    let wire = permits::yes(&mut session, PermitKind::Wire);
    assert_eq!(code(session.cut(&wire)), "not-permitted");
    assert_eq!(code(session.permit_in_row(&wire)), "not-permitted");
    let row = permits::yes(&mut session, PermitKind::Row);
    for _ in 0..2 {
        session.cut(&row).unwrap();
        assert_eq!(code(session.cut(&row)), "session-state", "it is being cut");
        session.poll().unwrap();
        assert_eq!(session.phase(), Phase::Ready);
    }
    let next = session.permit_in_row(&row).unwrap();
    session.arm(run(), next).unwrap();
    assert_eq!(code(session.cut(&row)), "session-state", "a wire is armed");
    let _ = session.stop();
    session.poll().unwrap();
    permits::home(&mut session).unwrap();
    session.poll().unwrap();
    assert_eq!(code(session.cut(&row)), "stopped-since");
    assert_eq!(code(session.permit_in_row(&row)), "stopped-since");
}

/// A yes that arrives late may be to a question that the person does not see any more.
#[test]
fn no_is_no() {
    let mut session = homed();
    let declined = session.ask(PermitKind::Wire);
    let asked_again = session.ask(PermitKind::Wire);
    assert_eq!(code(session.permit(declined.confirm())), "confirmation-used");
    session.permit(asked_again.confirm()).unwrap();
}

/// Two machines side by side: they have looked at one of them.
#[test]
fn a_yes_is_for_one_session() {
    let (mut one, mut other) = (homed(), homed());
    let (of_one, _of_other) = (one.ask(PermitKind::Wire), other.ask(PermitKind::Wire));
    assert_eq!(code(other.permit(of_one.confirm())), "confirmation-of-another");
    let permit = one.permit(of_one.confirm()).unwrap();
    assert_eq!(code(other.home(&permit)), "confirmation-of-another");
    assert_eq!(code(other.arm(run(), permit)), "confirmation-of-another");
    assert_eq!(other.phase(), Phase::Ready);
}

/// They said yes to a machine that had not been stopped; the person who stopped it may have their hands in it.
#[test]
fn a_stop_ends_what_was_confirmed_before() {
    // The yes comes after the stop, to a question from before.
    let mut session = homed();
    let asked = session.ask(PermitKind::ByHand);
    let _ = session.stop();
    session.poll().unwrap();
    assert_eq!(session.phase(), Phase::Stopped);
    assert_eq!(code(session.permit(asked.confirm())), "stopped-since");

    // It was taken before, and not used.
    let mut session = homed();
    let (by_hand, settings) =
        (permits::yes(&mut session, PermitKind::ByHand), permits::yes(&mut session, PermitKind::Settings));
    let wire = permits::yes(&mut session, PermitKind::Wire);
    let handle = session.stop_handle();
    let _ = std::thread::spawn(move || handle.stop()).join().unwrap();
    assert_eq!(code(session.home(&wire)), "stopped-since");
    session.poll().unwrap();
    assert_eq!(session.phase(), Phase::Stopped);
    assert_eq!(code(session.home(&by_hand)), "stopped-since");
    assert_eq!(code(session.accept_differences(&wire)), "stopped-since");
    assert_eq!(code(session.write_settings(settings)), "stopped-since");
    assert_eq!(session.poll().unwrap(), [], "nothing was asked of the machine");

    // After a new yes it moves, and what was confirmed before still does not count.
    permits::home(&mut session).unwrap();
    session.poll().unwrap();
    assert_eq!(code(session.arm_by_hand(&by_hand)), "stopped-since");
    assert_eq!(code(session.arm(run(), wire)), "stopped-since");
    assert_eq!(session.phase(), Phase::Ready);
}

/// A person goes to the machine by what they read: the state must not say that it is at rest while a stop is on its way,
/// nor of the wire before when another is permitted.
#[test]
fn a_snapshot_knows_of_a_stop_and_of_a_permit_at_once() {
    let mut session = homed();
    let asked = session.ask(PermitKind::Wire);
    let permit = session.permit(asked.confirm()).unwrap();
    assert_eq!((session.snapshot().phase, session.snapshot().stops), (Phase::Armed, 0));
    session.arm(run(), permit).unwrap();
    assert_eq!(session.snapshot().wire.map(|wire| (wire.made, wire.of)), Some((0, 3)));
    let permit = permits::yes(&mut session, PermitKind::Wire);
    assert_eq!(session.snapshot().wire, None);
    let handle = session.stop_handle();
    let _ = handle.stop();
    let seen = session.snapshot();
    assert!(matches!(seen.phase, Phase::Stopping | Phase::Stopped), "{seen:?}");
    assert_eq!((seen.stops, handle.stops()), (1, 1));
    assert_eq!(code(session.home(&permit)), "stopped-since");
}

#[test]
fn a_yes_is_for_what_was_asked() {
    let mut session = homed();
    let by_hand = permits::yes(&mut session, PermitKind::ByHand);
    assert_eq!(code(session.accept_differences(&by_hand)), "not-permitted");
    assert_eq!(code(session.write_settings(by_hand)), "not-permitted");
    let by_hand = permits::yes(&mut session, PermitKind::ByHand);
    assert_eq!(code(session.arm(run(), by_hand)), "not-permitted");
    let wire = permits::yes(&mut session, PermitKind::Wire);
    assert_eq!(code(session.arm_by_hand(&wire)), "not-permitted");
    let settings = permits::yes(&mut session, PermitKind::Settings);
    let error = session.home(&settings).unwrap_err();
    assert_eq!(error.to_string(), "homing was not confirmed, only writing settings");
    assert_eq!(error.remedies(), [ErrorRemedy::AskAgain]);
}

/// Were a real machine taken for a simulated one, it would move without a word of anybody.
#[test]
fn only_a_simulated_machine_needs_no_yes() {
    assert!(session().simulated().is_none());
    let mut session = session_at("wirebend-kit", "sim:max");
    let simulation = session.simulated().unwrap();
    let permit = simulation.permit(PermitKind::Wire);
    session.home(&permit).unwrap();
    while session.phase() != Phase::Ready {
        session.poll().unwrap();
    }
    // It is this machine's, and a stop ends it.
    assert_eq!(code(homed().home(&permit)), "confirmation-of-another");
    let _ = session.stop();
    assert_eq!(code(session.accept_differences(&permit)), "stopped-since");
}
