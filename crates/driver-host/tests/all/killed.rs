//! The program itself is killed, at every moment at which it could matter, while it bends a wire with a real
//! driver and a real journal: whatever was lost, each step is done exactly once.
//!
//! The test is its own program: started again with a folder in its environment it is the one that is killed.

#![cfg(unix)] // the driver that misbehaves is

use std::cell::Cell;
use std::os::unix::process::ExitStatusExt;
use std::path::Path;
use std::process::{Command, ExitStatus};
use std::time::Duration;

use serde_json::{Value, json};
use wirebend_driver_host::jobs::{Clock, EntryKind, JobState, Journal};

use crate::jobs::shop::{STEPS, Shop};

const FOLDER: &str = "WIREBEND_TEST_FOLDER";
const KILL_AT: &str = "WIREBEND_TEST_KILL_AT";
const SIGKILL: i32 = 9;
/// More looks at the clock than a wire needs, and more starts of the program.
const MAX: u32 = 400;

/// Kills the process when it is looked at for the so-manieth time: before each line of the journal, and
/// between a line and what it is about.
struct Deadly {
    left: Cell<u32>,
}

impl Deadly {
    fn tick(&self) {
        if self.left.get() == 0 {
            let own = rustix::process::getpid();
            let _ = rustix::process::kill_process(own, rustix::process::Signal::KILL);
            // Nothing after the signal may count.
            std::process::abort();
        }
        self.left.set(self.left.get() - 1);
    }
}

impl Clock for Deadly {
    fn now(&self) -> Duration {
        self.tick();
        Duration::ZERO
    }

    fn stamp(&self) -> String {
        self.tick();
        "noon".to_owned()
    }
}

/// The program that is killed.
fn program(folder: &Path) {
    let left = std::env::var(KILL_AT).unwrap().parse().unwrap();
    let shop = Shop::at(folder);
    let mut run = shop.program(json!({"alone": 1}), Box::new(Deadly { left: Cell::new(left) }));
    shop.look_and_start(&mut run);
    for _ in 0..1000 {
        if run.is_over() {
            assert_eq!(run.journal_state().standing, JobState::Finished);
            return;
        }
        run.advance().unwrap();
    }
    panic!("it does not end: {run:?}");
}

fn start(folder: &Path, kill_at: u32) -> ExitStatus {
    let own = std::env::current_exe().unwrap();
    let mut program = Command::new(own);
    program.args(["killed::at_every_moment", "--exact", "--nocapture"]);
    program.env(FOLDER, folder).env(KILL_AT, kill_at.to_string());
    program.env("CARGO_MANIFEST_DIR", env!("CARGO_MANIFEST_DIR"));
    program.status().unwrap()
}

/// What is known after a program was killed is true, though it need not be all.
fn journal_is_true(shop: &Shop, case: &str) {
    let Ok(written) = Journal::read(&shop.journal_path()) else { return };
    let (state, made) = (written.state, shop.made());
    assert!(made.iter().all(|n| *n <= u64::from(state.sent)), "{case}: {made:?} with {state:?}");
    assert!((1..=state.done).all(|n| made.contains(&n.into())), "{case}: {made:?} with {state:?}");
    let taken = shop.machine()["accepted"].as_u64().unwrap_or_default();
    let armed = |what: &EntryKind| matches!(what, EntryKind::Armed { .. });
    if written.entries.iter().any(|entry| armed(&entry.what)) {
        assert!(taken <= u64::from(state.sent), "{case}: {taken} taken with {state:?}");
    }
}

fn is_made(shop: &Shop, case: &str) {
    let expected: Vec<u64> = (1..=u64::from(STEPS)).collect();
    assert_eq!(shop.made(), expected, "{case}");
    let written = Journal::read(&shop.journal_path()).unwrap();
    assert_eq!((written.state.done, written.state.standing), (STEPS, JobState::Finished), "{case}");
}

#[test]
fn at_every_moment() {
    if let Some(folder) = std::env::var_os(FOLDER) {
        return program(folder.as_ref());
    }
    // Built once, and not by each of the programs.
    let _ = Shop::at(Path::new("."));
    let mut kills = 0;
    // The controller stays on, or is switched off and on again.
    for reset in [false, true] {
        for kill_at in 0..MAX {
            let case = format!("killed at {kill_at}, reset: {reset}");
            let folder = tempfile::tempdir().unwrap();
            let shop = Shop::at(folder.path());
            let status = start(folder.path(), kill_at);
            if status.success() {
                is_made(&shop, &case);
                break;
            }
            assert_eq!(status.signal(), Some(SIGKILL), "{case}: {status}");
            kills += 1;
            journal_is_true(&shop, &case);
            if reset && shop.machine() != Value::Null {
                shop.change_machine(|machine| machine["session"] = Value::Null);
            }
            assert!(start(folder.path(), MAX).success(), "{case}");
            is_made(&shop, &case);
        }
    }
    // Again and again, as long as it gets a little further each time.
    for kill_at in [12, 13, 14, 17] {
        let case = format!("killed at {kill_at} each time");
        let folder = tempfile::tempdir().unwrap();
        let shop = Shop::at(folder.path());
        let ends = (0..MAX).any(|_| {
            let status = start(folder.path(), kill_at);
            journal_is_true(&shop, &case);
            kills += u32::from(!status.success());
            status.success()
        });
        assert!(ends, "{case}");
        is_made(&shop, &case);
    }
    assert!(kills > 2 * 4 * STEPS, "only {kills} kills: the moments between are not tried");
}
