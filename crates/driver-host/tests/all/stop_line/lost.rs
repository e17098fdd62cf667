//! A driver that is lost while the machine may move: in every way, in every state of a session.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use serde_json::json;
use wirebend_driver_api::{Axis, Motion, NumberedStep, Run, Step};
use wirebend_driver_host::{Armed, Phase, Session, Standstill};

use super::port::Port;
use super::{STOP, connected, kill, line, opened};
use crate::awake::Awake;
use crate::permits;

/// A finger needs as long. What this computer is busy with besides comes on top.
const AT_ONCE: Duration = Duration::from_millis(150);
const GRACE: Duration = Duration::from_secs(1);

/// What a session does when its driver is lost.
pub const STATES: [&str; 5] = ["homing", "jogging", "running", "paused", "interrupted"];

fn run() -> Run {
    Run { job_hash: "5a".repeat(32), name: "test".into(), wire: 0, steps: 9, ..Run::default() }
}

fn steps() -> Vec<NumberedStep> {
    let step = Step { feed_mm: 30.0, rotate_deg: 0.0, bend_deg: 45.0, approach_deg: None };
    (1..=2).map(|n| NumberedStep { n, step }).collect()
}

/// A driver that behaves until it is let loose.
pub struct Kept {
    pub library: PathBuf,
}

impl Kept {
    pub fn new(folder: &Path, how: &str) -> Self {
        let library = folder.join(format!("poll-{how}.so"));
        wirebend_tests_built::place_hostile(&library);
        let kept = Self { library };
        fs::write(kept.leash(), "").unwrap();
        kept
    }

    fn leash(&self) -> PathBuf {
        self.library.with_extension("leash")
    }

    pub fn let_loose(&self) {
        fs::remove_file(self.leash()).unwrap();
    }
}

/// A session that has something moving, or that may.
pub fn in_state(library: &Path, port: &Port, state: &str) -> (Session, Option<Armed>) {
    if state == "interrupted" {
        let mut session =
            Session::connect_resuming(opened(library, &json!({})), &port.name, "hostile-1", line(port))
                .unwrap();
        session.poll().unwrap();
        assert_eq!(session.phase(), Phase::Interrupted);
        return (session, None);
    }
    let mut session = connected(library, port);
    session.poll().unwrap();
    permits::home(&mut session).unwrap();
    if state == "homing" {
        return (session, None);
    }
    session.poll().unwrap();
    if state == "jogging" {
        let armed = permits::arm_by_hand(&mut session).unwrap();
        session.jog(&armed, Motion::new(Axis::Feed, 1.0)).unwrap();
        return (session, Some(armed));
    }
    let armed = permits::arm(&mut session, run()).unwrap();
    session.send(&armed, &steps()).unwrap();
    if state == "paused" {
        session.pause().unwrap();
        session.poll().unwrap();
        assert_eq!(session.phase(), Phase::Holding);
    }
    (session, Some(armed))
}

/// The stop bytes come at once, and are repeated until the machine confirms.
#[track_caller]
pub fn is_stopped(session: &mut Session, port: &Port, case: &str) -> Duration {
    let lost = Awake::now();
    let heard = port.heard(5);
    let took = lost.elapsed();
    assert!(heard.len() >= 5 && heard.iter().all(|byte| *byte == STOP), "{case}: {heard:?}");
    assert!(took < AT_ONCE + GRACE, "{case}: {took:?}");
    // Not once and for all: what was lost on the line comes again.
    assert!(port.heard(5).len() >= 5, "{case}");
    assert_eq!(session.standstill(), Some(Standstill::Awaited), "{case}");
    port.says(b"x1*37f2\n");
    settles(session, Standstill::Confirmed, case);
    took
}

#[track_caller]
pub fn settles(session: &mut Session, wanted: Standstill, case: &str) {
    let begun = Instant::now();
    while session.standstill() == Some(Standstill::Awaited) && begun.elapsed() < Duration::from_secs(20) {
        // While the machine is waited for there is nothing to complain of.
        session.poll().unwrap_or_default();
        std::thread::sleep(Duration::from_millis(1));
    }
    assert_eq!(session.standstill(), Some(wanted), "{case}");
    assert_eq!(session.phase(), Phase::Failed, "{case}: it has to be connected anew");
}

#[test]
#[allow(clippy::print_stderr)] // the slowest is worth a line
fn a_driver_that_is_lost_while_the_machine_moves_leaves_it_stopped() {
    let folder = tempfile::tempdir().unwrap();
    let mut slowest = (Duration::ZERO, String::new());
    for how in [
        "exit", "abort", "segfault", "hang", "garbage", "torrent", "deaf", "null", "status", "nonsense",
        "lie",
    ] {
        for state in STATES {
            let case = format!("{how} while {state}");
            let (port, kept) = (Port::new(), Kept::new(folder.path(), how));
            let (mut session, _armed) = in_state(&kept.library, &port, state);
            assert_eq!(port.heard_so_far(), b"", "{case}: nothing before");
            kept.let_loose();
            session.poll().map(|events| format!("{events:?}")).unwrap_err();
            let took = is_stopped(&mut session, &port, &case);
            if took > slowest.0 {
                slowest = (took, case);
            }
        }
    }
    eprintln!("the slowest stop of a lost driver came after {:?} ({})", slowest.0, slowest.1);
}

/// The session is not polled at that moment: the window may be busy, or a person be asked.
#[test]
fn a_driver_that_is_killed_is_missed_by_itself() {
    for state in STATES {
        let folder = tempfile::tempdir().unwrap();
        let (port, kept) = (Port::new(), Kept::new(folder.path(), "exit"));
        let (mut session, _armed) = in_state(&kept.library, &port, state);
        kill(&session);
        is_stopped(&mut session, &port, state);
    }
}

/// It is given up once, and reported: another question gets the same answer at once.
#[test]
fn a_machine_that_moves_and_never_answers_is_given_up() {
    let (folder, port) = (tempfile::tempdir().unwrap(), Port::new());
    let kept = Kept::new(folder.path(), "exit");
    let (mut session, _armed) = in_state(&kept.library, &port, "running");
    kill(&session);
    port.heard(5);
    let begun = Instant::now();
    settles(&mut session, Standstill::NotConfirmed, "for ever");
    for _ in 0..3 {
        session.poll().unwrap_err();
        assert_eq!(session.standstill(), Some(Standstill::NotConfirmed));
    }
    assert!(begun.elapsed() < Duration::from_secs(15), "{:?}", begun.elapsed());
}

/// Were it stopped, a machine that waits for its next wire would have to be homed for nothing.
#[test]
fn a_machine_at_rest_is_left_alone() {
    let port = Port::new();
    let mut session = connected(&wirebend_tests_built::driver("hostile"), &port);
    session.poll().unwrap();
    permits::home(&mut session).unwrap();
    session.poll().unwrap();
    assert_eq!(session.phase(), Phase::Ready);
    kill(&session);
    session.poll().unwrap_err();
    assert_eq!((session.standstill(), port.heard_so_far().as_slice()), (None, &[][..]));
}

/// What moves on has no more to do with this program: there is nothing to write to it.
#[test]
fn a_machine_without_stop_bytes_may_still_move() {
    let mut session =
        Session::connect(opened(&wirebend_tests_built::driver("hostile"), &json!({})), "anywhere", None)
            .unwrap();
    session.poll().unwrap();
    permits::home(&mut session).unwrap();
    kill(&session);
    session.poll().unwrap_err();
    assert_eq!(session.standstill(), Some(Standstill::NotConfirmed));
}
