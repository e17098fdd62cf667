//! Program and driver are killed in the middle of a bend, and the machine resumes. Opening its port resets many a board: it is not
//! opened before the bend is over.

use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use rustix::process::{Pid, Signal, kill_process};
use serde_json::json;

use super::bender::Bender;
use super::lost::{driver_of, moves};
use super::runs::{LOOK, PATIENCE};
use crate::grbl_model::Build;
use crate::{Ran, example, run_in, wirebend};

/// The model moves at each turn of its loop, of about a millisecond; what it is sent now it does not run so soon.
const STILL: Duration = Duration::from_millis(30);

/// A bender whose profile says how fast it is.
fn bench() -> (tempfile::TempDir, Bender) {
    let folder = tempfile::tempdir().unwrap();
    // The model turns by 100 a second.
    let settings =
        json!({"feed_rate_mm_per_min": 6000, "rotate_rate_deg_per_min": 6000, "bend_rate_deg_per_min": 6000});
    let quick = json!({"schema_version": 1, "kind": "machine", "id": "quick", "inherits": "grbl-bender",
        "driver": {"settings": settings}});
    let machines = folder.path().join("profiles/machines");
    std::fs::create_dir_all(&machines).unwrap();
    std::fs::write(machines.join("quick.json"), quick.to_string()).unwrap();
    run(&folder, &["plan", &example("u-sample.obj"), "-m", "quick", "-o", "a.wbjob"]).ended(0);
    (folder, Bender::new(Build { switches: false, steps_a_turn: 8, ..Build::default() }))
}

fn run(folder: &tempfile::TempDir, arguments: &[&str]) -> Ran {
    run_in(folder.path(), &[&["--profiles", "profiles"], arguments].concat(), b"")
}

fn start(folder: &tempfile::TempDir, arguments: &[&str]) -> Child {
    let mut program = Command::new(wirebend());
    program.args(["--profiles", "profiles"]).args(arguments).current_dir(folder.path());
    program.env("XDG_CONFIG_HOME", folder.path()).env("XDG_DATA_HOME", folder.path());
    program.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap()
}

/// Nothing of the program is left, and the machine has not heard of it.
fn killed_in_a_bend(folder: &tempfile::TempDir, bender: &Bender) {
    let mut program = start(folder, &["run", "a.wbjob", "--port", &bender.port, "--yes", "--axes-at-zero"]);
    let begun = Instant::now();
    while !(bender.model.now().pin_out && bender.model.now().at[2] > 5.0) {
        assert!(begun.elapsed() < PATIENCE, "it does not bend: {:?}", bender.model.now());
        std::thread::sleep(LOOK);
    }
    let driver = driver_of(&program);
    let id = Pid::from_raw(i32::try_from(program.id()).unwrap()).unwrap();
    // The program would stop the machine, and the driver too.
    for process in [id, driver] {
        kill_process(process, Signal::STOP).unwrap();
    }
    for process in [id, driver] {
        kill_process(process, Signal::KILL).unwrap();
    }
    program.wait().unwrap();
    assert_eq!(bender.model.resets(), 0, "it was not stopped");
}

#[test]
fn a_port_is_not_opened_while_the_machine_may_be_in_a_bend() {
    for arguments in [
        &["run", "a.wbjob", "--yes", "--axes-at-zero", "--resume"][..],
        &["jog", "-m", "quick", "--yes", "--axes-at-zero", "f", "1"],
    ] {
        let (folder, bender) = bench();
        killed_in_a_bend(&folder, &bender);
        let (before, bend) = (bender.heard(), bender.stands());
        let mut program = start(&folder, &[arguments, &["--port", &bender.port]].concat());
        let begun = Instant::now();
        while bender.heard() == before && begun.elapsed() < PATIENCE {
            assert!(program.try_wait().unwrap().is_none(), "it ends without a word to the machine");
            std::thread::sleep(LOOK);
        }
        let waited = begun.elapsed();
        assert!(!moves(&bender, STILL), "it was opened in the middle of the bend, after {waited:?}");
        assert_ne!(bender.stands(), bend, "it has moved meanwhile");
        kill_process(Pid::from_raw(i32::try_from(program.id()).unwrap()).unwrap(), Signal::KILL).unwrap();
        let said = String::from_utf8(program.wait_with_output().unwrap().stderr).unwrap();
        assert!(said.contains("may still be running step"), "{said}");
        assert!(said.contains("cut the power of the machine"), "{said}");
        // The three steps take about 7 s by the profile's figures.
        assert!(waited < Duration::from_secs(20), "{waited:?}");
    }
}
