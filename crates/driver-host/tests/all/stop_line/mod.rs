//! A stop that no driver passes on: the program writes to the port itself. The port is a pair of terminals; what
//! arrives at its other end is what a machine would hear.

#![cfg(target_os = "linux")] // terminals are made as Linux makes them

mod confirmed;
mod faults;
mod lost;
mod port;

use std::path::Path;

use port::Port;
use rustix::process::{Pid, Signal, kill_process};
use serde_json::{Value, json};
use wirebend_driver_host::{
    DiscoveredDriver, Driver, HostError, Launch, OpenDriver, Place, Session, SessionError, StopLine,
    StoppedBy, TrustStore,
};

const STOP: u8 = 0x80;
/// What the machine answers.
const REPLY: &str = "x1*";

fn opened(library: &Path, settings: &Value) -> OpenDriver {
    let trust = TrustStore::open("none.json".as_ref()).unwrap();
    let found = DiscoveredDriver::at(library, Place::App, &trust);
    let launch = Launch { program: wirebend_tests_built::driver_child(), memory_bytes: 256 << 20 };
    Driver::start(&found, &launch).unwrap().open(settings).unwrap()
}

/// The program's own way to the port. It comes first: a driver may keep everybody else out.
fn line(port: &Port) -> Option<StopLine> {
    let line = StopLine::open(&port.name, &[STOP], REPLY).unwrap();
    assert!(line.is_some(), "{} is a terminal", port.name);
    line
}

fn connected(library: &Path, port: &Port) -> Session {
    let (driver, line) = (opened(library, &json!({})), line(port));
    Session::connect(driver, &port.name, line).unwrap()
}

fn kill(session: &Session) {
    let driver = i32::try_from(session.driver().process_id()).unwrap();
    kill_process(Pid::from_raw(driver).unwrap(), Signal::KILL).unwrap();
}

fn hostile(folder: &Path, name: &str) -> std::path::PathBuf {
    let library = folder.join(name);
    wirebend_tests_built::place_hostile(&library);
    library
}

#[track_caller]
fn stops(session: &mut Session, port: &Port) {
    let outcome = session.stop();
    assert_eq!((outcome.by, outcome.driver_ended), (StoppedBy::Host, true));
    let heard = port.heard(3);
    assert!(heard.len() >= 3 && heard.iter().all(|byte| *byte == STOP), "{heard:?}");
}

#[test]
fn a_driver_that_hangs_or_dies_in_a_stop_does_not_keep_it_from_the_machine() {
    let folder = tempfile::tempdir().unwrap();
    for how in ["hang", "spin", "abort", "exit", "garbage", "nonsense", "status", "null"] {
        let port = Port::new();
        let library = hostile(folder.path(), &format!("stop-{how}.so"));
        let mut session = connected(&library, &port);
        session.poll().unwrap();
        assert_eq!(port.heard_so_far(), b"", "{how}: nothing before the stop");
        stops(&mut session, &port);
    }
}

#[test]
fn a_driver_that_is_dead_already_does_not_either() {
    let port = Port::new();
    let mut session = connected(&wirebend_tests_built::driver("hostile"), &port);
    session.poll().unwrap();
    kill(&session);
    assert!(matches!(session.poll(), Err(SessionError::Host(HostError::Died { .. }))));
    stops(&mut session, &port);
    // A second press is heard as well.
    stops(&mut session, &port);
}

/// One that has the port open itself, and for itself alone.
#[test]
fn a_driver_that_had_the_port_to_itself_is_no_obstacle() {
    let port = Port::new();
    let mut session = connected(&wirebend_tests_built::driver("grbl"), &port);
    kill(&session);
    stops(&mut session, &port);
    // And another one gets it, while this program still keeps it open.
    let driver = opened(&wirebend_tests_built::driver("grbl"), &json!({}));
    Session::connect(driver, &port.name, None).unwrap();
}

#[test]
fn a_driver_that_behaves_stops_the_machine_itself() {
    let port = Port::new();
    let mut session = connected(&wirebend_tests_built::driver("hostile"), &port);
    session.poll().unwrap();
    assert_eq!(session.stop().by, StoppedBy::Driver);
    assert_eq!(port.heard_so_far(), b"");
    assert_eq!(session.last_stop().map(|outcome| outcome.by), Some(StoppedBy::Driver));
}

#[test]
fn what_is_no_device_has_no_line() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("file");
    std::fs::write(&file, b"kept").unwrap();
    let port = Port::new();
    for (name, bytes) in [
        ("sim", &[STOP][..]),
        ("/dev/wirebend-no-such-port", &[STOP]),
        ("/dev/null", &[STOP]),
        (file.to_str().unwrap(), &[STOP]),
        (port.name.as_str(), &[]),
    ] {
        assert!(StopLine::open(name, bytes, REPLY).unwrap().is_none(), "{name}");
    }
    assert_eq!(std::fs::read(file).unwrap(), b"kept");
}
