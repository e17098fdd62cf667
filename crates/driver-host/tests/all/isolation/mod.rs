//! Drivers that misbehave in every way at every call: this program is unhurt, what happened is reported, nothing
//! stays behind.

#![allow(clippy::print_stderr)] // the slowest stop is worth a line
#![cfg(target_os = "linux")] // the bookkeeping reads /proc

mod life;

use std::collections::VecDeque;
use std::path::Path;
use std::sync::Mutex;
use std::thread;
use std::time::{Duration, Instant};

use crate::awake::Awake;
use life::{CALLS, Life, Stage};
use wirebend_driver_api::deadline;
use wirebend_driver_host::{DiscoveredDriver, Launch, Place, SessionError, StoppedBy, TrustStore};

/// How often something is tried that depends on who comes first.
const TRIES: usize = 50;

/// What the machine may be busy with besides; no deadline is missed by more.
const GRACE: Duration = Duration::from_secs(1);

fn launch() -> Launch {
    Launch { program: wirebend_tests_built::driver_child(), memory_bytes: 256 << 20 }
}

/// The misbehaving driver under a name that tells it what to do.
fn told(folder: &Path, when: &str, how: &str) -> DiscoveredDriver {
    let file = folder.join(format!("{when}-{how}.so"));
    wirebend_tests_built::place_hostile(&file);
    DiscoveredDriver::at(&file, Place::App, &TrustStore::open(&folder.join("none.json")).unwrap())
}

fn descriptors() -> usize {
    std::fs::read_dir("/proc/self/fd").unwrap().count()
}

/// Processes whose parent this is, dead or alive, and strays of theirs.
fn children() -> Vec<String> {
    let own = std::process::id().to_string();
    let mut found = Vec::new();
    for entry in std::fs::read_dir("/proc").unwrap().flatten() {
        let status = std::fs::read_to_string(entry.path().join("stat")).unwrap_or_default();
        // "pid (name) state parent group …"; the name may hold anything.
        let Some((head, tail)) = status.rsplit_once(") ") else { continue };
        let fields: Vec<&str> = tail.split(' ').collect();
        let stray = head.ends_with("(sleep")
            && fields[1] == "1"
            && std::fs::read_to_string(entry.path().join("cmdline")).is_ok_and(|line| line.contains("86419"));
        if fields[1] == own || stray {
            found.push(status);
        }
    }
    found
}

/// Waits for what ends by itself in a moment, such as the thread that reads a pipe to its end.
#[track_caller]
fn settles<T: PartialEq + std::fmt::Debug>(expected: &T, now: impl Fn() -> T) {
    let given_up = Instant::now() + Duration::from_secs(20);
    while now() != *expected && Instant::now() < given_up {
        thread::sleep(Duration::from_millis(1));
    }
    assert_eq!(now(), *expected);
}

/// Does something for every pair of words, a few at a time, and stops at nothing before all are done.
#[track_caller]
fn for_each_pair(
    when: &[&'static str],
    how: &[&'static str],
    work: impl Fn(&'static str, &'static str) -> Result<(), String> + Sync,
) {
    let pairs = when.iter().flat_map(|when| how.iter().map(move |how| (*when, *how)));
    let queue: Mutex<VecDeque<_>> = Mutex::new(pairs.collect());
    let complaints = Mutex::new(Vec::new());
    thread::scope(|scope| {
        for _ in 0..6 {
            scope.spawn(|| {
                while let Some((when, how)) = { queue.lock().unwrap().pop_front() } {
                    if let Err(complaint) = work(when, how) {
                        complaints.lock().unwrap().push(format!("{when}-{how}: {complaint}"));
                    }
                }
            });
        }
    });
    let complaints = complaints.into_inner().unwrap();
    assert!(complaints.is_empty(), "{}\n{}", complaints.len(), complaints.join("\n"));
}

/// What has to be reported of a misdeed: the codes that fit it.
fn expected(when: &str, how: &str) -> &'static [&'static str] {
    match (when, how) {
        ("entry", "version") | ("entry" | "describe", "null" | "status" | "nonsense" | "flood") => {
            &["driver-load", "driver-broken"]
        }
        ("send" | "poll", "lie") => &["out-of-order"],
        ("connect" | "write-settings", "differ") => &["settings-differ"],
        // A driver may print. The next four are about answers, of which `close` has none and nothing reads
        // that of `open`, and a version is about the table.
        (_, "shout" | "version" | "old" | "lie" | "differ")
        | ("close", "null" | "status" | "nonsense" | "flood")
        | ("open", "nonsense") => &[],
        // Whatever it does instead of stopping, it is ended for it.
        ("stop", _) => &["driver-ended", "driver-died", "driver-garbage", "driver-too-large"],
        (_, "exit" | "abort" | "segfault" | "orphan") => &["driver-died"],
        (_, "hang" | "spin") => &["driver-hung"],
        // Memory can take its time to run out, and a process that has lost its pipe is not heard.
        (_, "leak" | "deaf") => &["driver-died", "driver-hung"],
        (_, "garbage") => &["driver-garbage", "driver-died"],
        (_, "torrent") => &["driver-too-large", "driver-died"],
        (_, "flood") => &["driver-broken", "driver-hung"],
        (_, "null" | "status" | "nonsense") => &["driver-broken"],
        other => panic!("no word for {other:?}"),
    }
}

fn code(error: &SessionError) -> &'static str {
    match error {
        SessionError::Host(error) => error.code().as_str(),
        SessionError::OutOfOrder { .. } => "out-of-order",
        SessionError::SettingsDiffer { .. } => "settings-differ",
        other => panic!("{other}"),
    }
}

/// One after the other would take minutes, at once the descriptors could not be counted: one test for all.
#[test]
fn no_misdeed_of_a_driver_hurts_this_program() {
    let folder = tempfile::tempdir().unwrap();
    let (well, launch) = (told(folder.path(), "never", "misbehaves"), launch());
    let before = descriptors();
    Life::whole(&well, &launch).ended.unwrap();
    settles(&Vec::<String>::new(), children);
    settles(&before, descriptors);

    let when = hostile_words("WHEN");
    let missing: Vec<_> = when.iter().filter(|when| Stage::of(when).is_none()).collect();
    assert!(missing.is_empty(), "the life of a driver has no such call: {missing:?}");
    let mut how = hostile_words("HOW");
    // What becomes of a stop that is not confirmed, and of a fault while the machine moves, takes seconds: the tests of the
    // stop line have it.
    how.retain(|how| !["mute", "fault", "numb", "gone"].contains(how));
    assert_eq!((when.len(), how.len()), (20, 19), "words were added: say here what has to happen");
    for_each_pair(&when, &how, |when, how| {
        let mut verdict = Ok(());
        for _ in 0..TRIES {
            let found = told(folder.path(), when, how);
            let life = Life::whole(&found, &launch);
            verdict = judge(&life, when, how);
            if verdict.is_ok() || !is_late(&life, when, how) {
                break;
            }
        }
        verdict
    });
    // Misdeeds of one driver are nothing to the next.
    Life::whole(&well, &launch).ended.unwrap();
    settles(&Vec::<String>::new(), children);
    settles(&before, descriptors);

    stop_works_whatever_the_driver_does(folder.path(), &launch, &how);
    settles(&Vec::<String>::new(), children);
    settles(&before, descriptors);
}

/// Whether what has to be reported was reported, and in time.
fn judge(life: &Life, when: &str, how: &str) -> Result<(), String> {
    let codes = expected(when, how);
    let error = match &life.ended {
        Ok(()) if codes.is_empty() => return Ok(()),
        Ok(()) => return Err("it was not noticed".to_owned()),
        Err(error) => error,
    };
    let (stage, took) = life.last();
    if !codes.contains(&code(error)) {
        return Err(format!("it was reported as {} at {stage:?}: {error}", code(error)));
    }
    if took > stage.deadline() + GRACE {
        return Err(format!("{stage:?} took {took:?}"));
    }
    Ok(())
}

/// Whether a driver that behaves, or does what nothing has to be reported of, was ended because a busy machine did not let it answer within
/// a short deadline.
fn is_late(life: &Life, when: &str, how: &str) -> bool {
    let (stage, _) = life.last();
    let short = [Stage::Stop, Stage::Poll, Stage::Close].contains(&stage);
    let behaves = Stage::of(when) != Some(stage) || expected(when, how).is_empty();
    let ended =
        life.ended.as_ref().is_err_and(|error| ["driver-ended", "driver-hung"].contains(&code(error)));
    short && behaves && ended
}

/// The words that the driver itself lists.
fn hostile_words(list: &str) -> Vec<&'static str> {
    let source = include_str!("../../../../../drivers/hostile/src/lib.rs");
    let start = source.find(&format!("pub const {list}:")).unwrap();
    let text = &source[start + source[start..].find("= [").unwrap() + 3..];
    let words = text[..text.find(']').unwrap()].split('"').skip(1).step_by(2);
    words.collect()
}

fn stop_works_whatever_the_driver_does(folder: &Path, launch: &Launch, how: &[&'static str]) {
    let slowest = Mutex::new((Duration::ZERO, "", ""));
    for_each_pair(&CALLS, how, |when, how| {
        // Who does not come back from what it does cannot have answered.
        let ends = ["hang", "spin"].contains(&how);
        for _ in 0..TRIES {
            let Some((by, took)) = stopped_while(folder, launch, when, how) else { return Ok(()) };
            if took > deadline::STOP + GRACE {
                return Err(format!("the stop took {took:?}"));
            }
            let mut slowest = slowest.lock().unwrap();
            if took > slowest.0 {
                *slowest = (took, when, how);
            }
            if !ends || by == StoppedBy::EndOfDriver {
                return Ok(());
            }
        }
        Err(format!("it answered each of {TRIES} stops"))
    });
    let (took, when, how) = *slowest.lock().unwrap();
    eprintln!("the slowest stop took {took:?} ({when}-{how})");
}

/// A stop while another thread has the driver misbehave: by whom, and how long it took; `None` when it does not get there.
fn stopped_while(
    folder: &Path,
    launch: &Launch,
    when: &'static str,
    how: &str,
) -> Option<(StoppedBy, Duration)> {
    let found = told(folder, when, how);
    let mut life = Life::until(&found, launch, when)?;
    let handle = life.session().stop_handle();
    let (by, took) = thread::scope(|scope| {
        let (begins, begun) = std::sync::mpsc::channel();
        let misdeed = scope.spawn({
            let life = &mut life;
            move || {
                begins.send(()).unwrap();
                life.advance(when)
            }
        });
        begun.recv().unwrap();
        thread::yield_now();
        let pressed = Awake::now();
        let by = handle.stop().by;
        let took = pressed.elapsed();
        // Whatever the call came to, it did not hold the stop up.
        let _ = misdeed.join().unwrap();
        (by, took)
    });
    if by == StoppedBy::EndOfDriver {
        life.assert_over();
    }
    Some((by, took))
}
