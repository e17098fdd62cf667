//! Machines that count the other way, and tables for the other hand.

use serde_json::{Value, json};
use wirebend_api::{Command, ExportRequest, Installation, NoProgress, Response};
use wirebend_core::bend::{Convention, Sign, Step};

use crate::cases::{self, Case, drivers};
use crate::exports::bounds::Off;
use crate::exports::compared::{Rounding, assert_same_wire, assert_steps, path};
use crate::exports::gcode_bender::Bender;
use crate::exports::scripts;

fn case(name: &str) -> Case {
    Case::load(&cases::root().join("tests/golden").join(name))
}

/// The text of a case for a machine whose profile is in this folder.
fn text_for(folder: &std::path::Path, name: &str, machine: &str, format: &str, settings: &Value) -> String {
    let app = Installation::new(&[folder.to_owned()]).unwrap().with_drivers(drivers());
    assert!(app.refused_profiles().is_empty(), "{:?}", app.refused_profiles());
    let case = case(name);
    let request = ExportRequest {
        design: case.input(),
        choices: case.choices(machine),
        format: Some(format.to_owned()),
        settings: settings.as_object().cloned().unwrap_or_default(),
        output: None,
        despite_errors: false,
    };
    match Command::Export(request).run(&app, &NoProgress).unwrap() {
        Response::Export(found) => cases::texts(&found).remove(0),
        other => panic!("{other:?}"),
    }
}

/// A profile that inherits from a machine and counts as it is set.
fn counting(folder: &std::path::Path, id: &str, parent: &str, bend: i32, rotate: i32) {
    let profile = json!({
        "schema_version": 1, "kind": "machine", "id": id, "inherits": parent,
        "signs": {"bend": bend, "rotate": rotate, "note": "a test"},
    });
    let machines = folder.join("machines");
    std::fs::create_dir_all(&machines).unwrap();
    std::fs::write(machines.join(format!("{id}.json")), profile.to_string()).unwrap();
}

/// A machine that is wired the other way round gets its own signs in its own program. In a table signs are those of the
/// format, whatever the machine counts: a table is for a control that knows its machine.
#[test]
fn a_machine_that_counts_the_other_way_gets_its_own_signs() {
    let folder = tempfile::tempdir().unwrap();
    let plain =
        |format: &str, machine: &str| text_for(folder.path(), "mirror-left", machine, format, &Value::Null);
    for (bend, rotate) in [(1, -1), (-1, 1), (-1, -1)] {
        for parent in ["grbl-bender", "pensa-diwire-pro", "table-bender"] {
            counting(folder.path(), &format!("other-{parent}"), parent, bend, rotate);
        }
        let sign = |sign: i32| if sign < 0 { Sign::Opposite } else { Sign::Same };
        let convention = Convention { bend: sign(bend), rotate: sign(rotate) };
        for (parent, format, read) in [
            ("grbl-bender", "gcode", (|text| Bender::run(text).steps) as fn(&str) -> Vec<_>),
            ("pensa-diwire-pro", "pensa-script", scripts::steps_of),
        ] {
            let meant = read(&plain(format, parent));
            let counted = read(&plain(format, &format!("other-{parent}")));
            let as_ours: Vec<_> = counted.iter().map(|&step| convention.apply(step)).collect();
            assert!(counted != meant, "{format}: the signs are the same");
            assert_steps(format, &as_ours, &meant, 1e-6, [Rounding::Each; 3]);
        }
        assert_eq!(plain("lra-csv", "table-bender"), plain("lra-csv", "other-table-bender"));
    }
}

/// What would be bent if a sign were lost on the way: these tests can fail.
#[test]
#[should_panic(expected = "rotate, step 1: ")]
fn a_rotation_the_other_way_round_is_found_in_the_steps() {
    let (meant, text) = with_other_rotations();
    assert_steps("mirror-left", &Bender::run(&text).steps, &meant, 1e-3, [Rounding::Sum; 3]);
}

/// The same, seen at the wire.
#[test]
#[should_panic(expected = "mirror-left: vertex 3 is ")]
fn a_rotation_the_other_way_round_is_found_in_the_wire() {
    let (meant, text) = with_other_rotations();
    let steps = Bender::run(&text).steps;
    let off = vec![Off { feed_mm: 1e-3, angles_deg: 1e-3 }; steps.len()];
    assert_same_wire("mirror-left", &path(&steps), &path(&meant), &off);
}

/// The steps of a program, and its text with every move of the rotation the other way round.
fn with_other_rotations() -> (Vec<Step>, String) {
    let text =
        text_for(tempfile::tempdir().unwrap().path(), "mirror-left", "grbl-bender", "gcode", &Value::Null);
    let turned = text.replace(" Y-", " Y+").replace(" Y", " Y-").replace(" Y-+", " Y");
    assert_ne!(text, turned);
    (Bender::run(&text).steps, turned)
}

/// The left one of two mirror images, counted by the left hand, reads like the right one counted by the right hand: the
/// two designs were drawn, not computed from one another.
#[test]
fn a_table_for_the_other_hand_is_that_of_the_mirror_image() {
    let folder = tempfile::tempdir().unwrap();
    let table = |name: &str, handedness: &str| {
        let settings = json!({ "handedness": handedness });
        text_for(folder.path(), name, "table-bender", "lra-csv", &settings)
    };
    assert_eq!(table("mirror-left", "left"), table("mirror-right", "right"));
    assert_eq!(table("mirror-left", "right"), table("mirror-right", "left"));
    assert_ne!(table("mirror-left", "right"), table("mirror-right", "right"));
}
