//! `check` of a design alone, and what it says before anything is doubled.

use std::fmt::Write;

use serde_json::{Value, json};

use crate::{example, run, run_in};

/// Two edges that pass each other 1 mm apart, in one wire.
const CROSSING: &[u8] = b"v 0 0 0\nv 100 0 0\nv 100 50 1\nv 50 50 1\nv 50 -50 1\nl 1 2 3 4 5\n";

fn codes(found: &Value, list: &str, key: &str) -> Vec<String> {
    found[list].as_array().unwrap().iter().map(|one| one[key].as_str().unwrap().to_owned()).collect()
}

#[test]
fn a_design_is_checked_without_a_machine() {
    let cube = example("cube.obj");
    let found = run(&["check", &cube, "--json"]).ended(4).json();
    assert_eq!(
        [&found["machine"], &found["material"], &found["feasible"]],
        [&json!(null), &json!(null), &json!(false)]
    );
    assert_eq!(codes(&found, "diagnostics", "code"), ["no_euler_path"]);
    assert!(codes(&found, "notes", "code").contains(&"machine-not-named".to_owned()), "{found}");
    // What the choices of wires say counts without one, too.
    for solved in [&["--double"][..], &["--wires", "4"]] {
        let found = run(&[&["check", &cube, "--json"], solved].concat()).ended(0).json();
        assert_eq!(found["feasible"], json!(true), "{found}");
    }
    let said = run(&["check", &cube, "--closed", "--wires", "2"]).ended(2).err;
    assert!(said.contains("closed"), "{said}");
    let said = run(&["check", &cube, "--start", "99"]).ended(3).err;
    assert!(said.contains("no vertex 99"), "{said}");
}

#[test]
fn edges_that_are_too_close_together_are_found_once_the_wire_is_known() {
    let folder = tempfile::tempdir().unwrap();
    let check = |more: &[&str]| {
        run_in(folder.path(), &[&["check", "-", "--from", "obj", "--units", "mm"], more].concat(), CROSSING)
    };
    let unknown = check(&[]).ended(0).err;
    assert!(unknown.contains("not whether edges are too close together"), "{unknown}");
    assert!(unknown.contains("no error in the design: 0 errors"), "{unknown}");
    let said = check(&["--material", "aluminium-6061-t6-3mm"]).ended(4).err;
    assert!(said.contains("cannot be bent on any machine with aluminium-6061-t6-3mm: 1 error"), "{said}");
    let thick = check(&["--material", "aluminium-6061-t6-3mm", "--json"]).ended(4).json();
    assert_eq!(codes(&thick, "diagnostics", "code"), ["edges_meet"]);
    assert_eq!(thick["material"], json!("aluminium-6061-t6-3mm"));
    // 1 mm apart, a wire of 1 mm passes.
    let thin = check(&["--material", "steel-1mm", "--json"]).ended(0).json();
    assert_eq!(codes(&thin, "diagnostics", "code"), [""; 0]);
    let said = check(&["--material", "cheese"]).ended(2).err;
    assert!(said.contains("steel-1mm"), "{said}");
}

#[test]
fn what_only_a_machine_can_tell_needs_one() {
    let house = example("house.obj");
    for asked in [&["--collisions"][..], &["--avoid-collisions"], &["--sag"], &["--detours"]] {
        let said = run(&[&["check", &house], asked].concat()).ended(2).err;
        assert!(said.contains("no machine is named"), "{asked:?}: {said}");
    }
}

#[test]
fn a_vertex_with_more_edge_ends_than_can_be_paired_is_named_before_anything_is_doubled() {
    let spokes = 601;
    let (mut cone, mut edges) = ("v 0 0 900\n".to_owned(), String::new());
    for spoke in 0..spokes {
        let (sin, cos) = (f64::from(spoke) / f64::from(spokes) * std::f64::consts::TAU).sin_cos();
        writeln!(cone, "v {} {} 0", 9000.0 * cos, 9000.0 * sin).unwrap();
        writeln!(edges, "l 1 {}", spoke + 2).unwrap();
        writeln!(edges, "l {} {}", spoke + 2, (spoke + 1) % spokes + 2).unwrap();
    }
    cone.push_str(&edges);
    let folder = tempfile::tempdir().unwrap();
    for machine in [&[][..], &["--machine", "wirebend-kit"]] {
        let asked = [&["check", "-", "--from", "obj", "--units", "mm", "--json"], machine].concat();
        let found = run_in(folder.path(), &asked, cone.as_bytes()).ended(4).json();
        assert_eq!(codes(&found, "diagnostics", "code"), ["no_euler_path", "route_refused"], "{machine:?}");
        assert_eq!(found["diagnostics"][1]["vertex"], json!(0), "{machine:?}");
    }
}
