//! What the figures of a person's own machine and wire change in what is found.

use std::fmt::Write as _;
use std::path::Path;

use serde_json::Value;

use crate::{example, run_in};

/// Six bends of 30° to one side, 28 mm apart: each but the first is pressed on wire that was bent before.
fn hexagon_half(folder: &Path) -> String {
    let (mut at, mut text) = ([0.0_f64, 0.0], String::from("v 0 0 0\n"));
    for k in 0..7 {
        let way = f64::to_radians(30.0 * f64::from(k));
        at = [at[0] + 28.0 * way.cos(), at[1] + 28.0 * way.sin()];
        writeln!(text, "v {} {} 0\nl {} {}", at[0], at[1], k + 1, k + 2).unwrap();
    }
    let file = folder.join("bends.obj");
    std::fs::write(&file, text).unwrap();
    file.display().to_string()
}

/// Makes a profile of a person's own, or changes one.
fn set(folder: &Path, id: &str, kind: &str, values: &[&str]) {
    let source = ["--kind", kind, "--source", "by me", "--measured"];
    run_in(folder, &[&["profile", "set", id], values, &source].concat(), b"").ended(0);
}

/// What is found of a design that can be made, with this code.
fn found(folder: &Path, file: &str, code: &str, on: &[&str]) -> Vec<Value> {
    let checked = run_in(folder, &[&["check", file, "--json"], on].concat(), b"").ended(0).json();
    let all = checked["diagnostics"].as_array().unwrap().iter();
    all.filter(|one| one["code"] == code).cloned().collect()
}

#[test]
fn a_head_that_nobody_measured_is_named_where_it_matters() {
    let folder = tempfile::tempdir().unwrap();
    let bends = hexagon_half(folder.path());
    let on = |machine: &str, code: &str| found(folder.path(), &bends, code, &["--machine", machine]);
    let near = on("wirebend-kit", "corner_within_reach");
    assert_eq!(near.len(), 5);
    let [told] = &on("wirebend-kit", "head_not_measured")[..] else { panic!("it is not told once") };
    assert_eq!((&told["severity"], &told["value"]), (&"info".into(), &5.0.into()), "{told}");
    assert_eq!(told["remedies"][0]["remedy"], "calibrate", "{told}");

    // A bend out of reach of any other has nothing to do with it.
    let single = example("u-sample.obj");
    assert!(found(folder.path(), &single, "head_not_measured", &["--machine", "wirebend-kit"]).is_empty());

    set(folder.path(), "mine", "machine", &["--from", "wirebend-kit", "bend.orbit_offset_mm=12.1"]);
    assert_eq!(on("mine", "corner_within_reach").len(), 5);
    assert!(on("mine", "head_not_measured").is_empty());
}
