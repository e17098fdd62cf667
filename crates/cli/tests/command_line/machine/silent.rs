//! A machine that acknowledges nothing, or none at all at its port: no step is reported as done that was not observed.

use serde_json::{Value, json};

use super::board::terminal;
use crate::{Ran, assert_fits, example, run_in};

/// A clone whose commands take no time, and its job.
fn clone_with_a_job() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let settings = json!({"boot_s": 0.1, "command_s": 0, "bend_extra_s": 0, "negative_bend_extra_s": 0, "margin_percent": 0,
        "feed_rate_mm_per_s": 10000, "rotate_rate_deg_per_s": 10000, "bend_rate_deg_per_s": 10000,
        "bend_return_rate_deg_per_s": 10000});
    let clone = json!({"schema_version": 1, "kind": "machine", "id": "clone", "inherits": "howtomechatronics",
        "driver": {"settings": settings}});
    let machines = folder.path().join("profiles/machines");
    std::fs::create_dir_all(&machines).unwrap();
    std::fs::write(machines.join("clone.json"), clone.to_string()).unwrap();
    run(&folder, &["plan", &example("u-sample.obj"), "-m", "clone", "-o", "a.wbjob"]).ended(0);
    folder
}

fn run(folder: &tempfile::TempDir, arguments: &[&str]) -> Ran {
    run_in(folder.path(), &[&["--profiles", "profiles"], arguments].concat(), b"")
}

fn text(ran: &Ran) -> String {
    format!("{}{}", ran.err, String::from_utf8_lossy(&ran.out))
}

/// It ended as "done, all steps" with no machine at the port.
#[test]
fn a_wire_that_nobody_acknowledges_is_sent_and_not_made() {
    let folder = clone_with_a_job();
    let (_far, _near, port) = terminal();
    let ran = run(&folder, &["run", "a.wbjob", "--port", &port, "--yes"]).ended(0);
    let said = text(&ran);
    assert!(said.contains("this machine does not report whether it runs what it is sent"), "before: {said}");
    assert!(said.contains("sent, all 3 steps; the machine does not report whether it ran them"), "{said}");
    assert!(!said.contains("finished in"), "{said}");
    // Nor later: not when it is resumed, nor in its record.
    let said = text(&run(&folder, &["run", "a.wbjob", "--port", &port, "--yes", "--resume"]).ended(0));
    assert!(
        said.contains("the machine does not report whether it ran them") && !said.contains("finished before"),
        "{said}"
    );
    let said = text(&run(&folder, &["runs"]).ended(0));
    assert!(said.contains("sent, not acknowledged"), "{said}");
    let list = run(&folder, &["runs", "--json"]).ended(0).json();
    assert_fits("runs", &list);
    assert_eq!(list["runs"][0]["outcome"], "sent");
    let id = list["runs"][0]["id"].as_str().unwrap();
    let record = run(&folder, &["runs", "show", id, "--json"]).ended(0).json();
    assert_eq!(
        (&record["record"]["outcome"], &record["record"]["job"]["done_by"]),
        (&json!("sent"), &json!("clock"))
    );
}

/// A script reads the same.
#[test]
fn a_script_is_told_that_nobody_acknowledges() {
    let folder = clone_with_a_job();
    let (_far, _near, port) = terminal();
    let found = run(&folder, &["run", "a.wbjob", "--port", &port, "--yes", "--json"]).ended(0).json();
    assert_fits("run", &found);
    let wire: &Value = &found["wires"][0];
    assert_eq!((&wire["outcome"], &wire["done_by"]), (&json!("sent"), &json!("clock")));
    // A machine that acknowledges is another matter.
    run(&folder, &["plan", &example("u-sample.obj"), "-m", "wirebend-kit", "-o", "b.wbjob"]).ended(0);
    let found = run(&folder, &["run", "b.wbjob", "--port", "sim:max", "--yes", "--json"]).ended(0).json();
    let wire: &Value = &found["wires"][0];
    assert_eq!((&wire["outcome"], &wire["done_by"]), (&json!("made"), &json!("machine")));
}
