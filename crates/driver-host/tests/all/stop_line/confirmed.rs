//! Sent is not stopped: what is said of a machine that does not hear, or is not heard.

use std::thread;
use std::time::{Duration, Instant};

use wirebend_driver_host::{Phase, Standstill, StoppedBy};

use super::lost::settles;
use super::port::Port;
use super::{STOP, connected, hostile, kill};

/// The line is dead for a while: the stop is repeated until it comes through, and only then the machine stands.
#[test]
fn a_stop_that_is_lost_comes_again() {
    for dead in [0, 300, 1000, 5000].map(Duration::from_millis) {
        let folder = tempfile::tempdir().unwrap();
        let port = Port::new();
        let mut session = connected(&hostile(folder.path(), "stop-abort.so"), &port);
        session.poll().unwrap();
        let begun = Instant::now();
        assert_eq!(session.stop().by, StoppedBy::Host);
        let standing = thread::scope(|scope| {
            let machine = scope.spawn(|| {
                while begun.elapsed() < dead {
                    // These go nowhere.
                    port.heard(1);
                }
                assert!(port.heard(1).contains(&STOP), "it is repeated after {dead:?}");
                port.says(b"t3,1,0,0,0,4,4,0,0,0*11aa\nx1*37f2\n");
                begun.elapsed()
            });
            settles(&mut session, Standstill::Confirmed, &format!("{dead:?}"));
            machine.join().unwrap()
        });
        assert!(standing >= dead && begun.elapsed() >= standing, "it is not said before it is true");
    }
}

/// What was on its way before the stop says nothing about it.
#[test]
fn a_reply_of_before_confirms_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let port = Port::new();
    let mut session = connected(&hostile(folder.path(), "stop-hang.so"), &port);
    session.poll().unwrap();
    port.says(b"x1*37f2\n");
    assert_eq!(session.stop().by, StoppedBy::Host);
    port.heard(50);
    assert_eq!(session.standstill(), Some(Standstill::Awaited));
    port.says(b"x1*37f2\n");
    settles(&mut session, Standstill::Confirmed, "at its own reply");
}

/// A driver that was ended by a stop from another thread is not asked again, even if nobody has polled it since: it would only
/// fail once more, for the same reason.
#[test]
fn a_driver_that_a_stop_has_ended_is_not_asked_again() {
    let folder = tempfile::tempdir().unwrap();
    let port = Port::new();
    let mut session = connected(&hostile(folder.path(), "stop-hang.so"), &port);
    session.poll().unwrap();
    let outcome = session.stop_handle().stop();
    assert!(outcome.driver_ended);
    port.says(b"x1*37f2\n");
    settles(&mut session, Standstill::Confirmed, "at its reply");
    assert_eq!(session.take_stop(), Some(outcome));
    assert_eq!(session.phase(), Phase::Failed);
}

/// It is said within seconds, and a person presses again for as long as they like.
#[test]
fn a_machine_that_never_answers_is_never_called_stopped() {
    let folder = tempfile::tempdir().unwrap();
    let port = Port::new();
    let mut session = connected(&hostile(folder.path(), "stop-exit.so"), &port);
    session.poll().unwrap();
    let begun = Instant::now();
    assert_eq!(session.stop().by, StoppedBy::Host);
    settles(&mut session, Standstill::NotConfirmed, "for ever");
    assert!(begun.elapsed() < Duration::from_secs(15), "{:?}", begun.elapsed());
    port.heard_so_far();
    assert_eq!(session.stop().by, StoppedBy::Host);
    assert_eq!(session.standstill(), Some(Standstill::Awaited));
    assert!(port.heard(5).len() >= 5);
    port.says(b"x1*37f2\n");
    settles(&mut session, Standstill::Confirmed, "at the second press");
}

/// The cable is out: there is nothing to wait for.
#[test]
fn a_port_that_is_gone_is_not_waited_for() {
    let port = Port::new();
    let mut session = connected(&wirebend_tests_built::driver("hostile"), &port);
    session.poll().unwrap();
    // First: a stop is on the port as soon as the driver is lost.
    port.unplug();
    kill(&session);
    let begun = Instant::now();
    session.poll().unwrap_err();
    assert_eq!(session.stop().by, StoppedBy::EndOfDriver);
    settles(&mut session, Standstill::NotConfirmed, "the port is gone");
    assert!(begun.elapsed() < Duration::from_secs(5), "{:?}", begun.elapsed());
}

/// A driver that takes the stop and never brings the machine's answer is not waited for: the program asks itself.
#[test]
fn a_driver_that_never_confirms_is_taken_over() {
    let folder = tempfile::tempdir().unwrap();
    let port = Port::new();
    let mut session = connected(&hostile(folder.path(), "stop-mute.so"), &port);
    session.poll().unwrap();
    assert_eq!(session.stop().by, StoppedBy::Driver);
    assert_eq!((session.phase(), port.heard_so_far().as_slice()), (Phase::Stopping, &[][..]));
    let begun = Instant::now();
    while session.phase() == Phase::Stopping && begun.elapsed() < Duration::from_secs(20) {
        session.poll().unwrap();
    }
    assert!(port.heard(5).len() >= 5);
    assert_eq!(session.standstill(), Some(Standstill::Awaited));
    port.says(b"x1*37f2\n");
    settles(&mut session, Standstill::Confirmed, "by the program itself");
}
