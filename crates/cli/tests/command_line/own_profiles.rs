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

    // Of the orbit both figures count, and no other makes up for one of them.
    let values = ["--from", "wirebend-kit", "bend.orbit_offset_mm=12.1", "bend.rod_radius_mm=3.2"];
    set(folder.path(), "mine", "machine", &values);
    assert_eq!(on("mine", "head_not_measured").len(), 1);
    set(folder.path(), "mine", "machine", &["bend.orbit_radius_mm=20.5"]);
    assert_eq!(on("mine", "corner_within_reach").len(), 5);
    assert!(on("mine", "head_not_measured").is_empty());
}

/// What is typed as one types it elsewhere: the error says how it is typed here.
#[test]
fn a_figure_that_is_no_number_is_refused_as_it_was_typed() {
    let folder = tempfile::tempdir().unwrap();
    let set = |value: &str| {
        let own =
            ["profile", "set", "mine", "--from", "grbl-bender", "--kind", "machine", "--source", "by me"];
        run_in(folder.path(), &[&own[..], &[value]].concat(), b"")
    };
    for typed in ["bend.pin_radius_mm=2,5", "bend.pin_radius_mm=2.5mm"] {
        let said = set(typed).ended(2).err;
        let wanted = format!(
            "error: a value is '{typed}', expected a number, with a point before its decimals; its unit"
        );
        assert!(said.starts_with(&wanted), "{said}");
    }
    set("bend.pin_radius_mm=2.5").ended(0);
    set("default_material=steel-1mm").ended(0);
}

/// 362.14 MPa · 27 mm³ / 6 = 1.630 N·m, of which an axis should have one and a half times.
#[test]
fn an_axis_that_is_hardly_strong_enough_for_the_wire_is_warned_of() {
    let folder = tempfile::tempdir().unwrap();
    let sample = example("u-sample.obj");
    for (torque, warned) in [("2.46", false), ("2.43", true)] {
        let value = format!("bend.torque_n_m={torque}");
        set(folder.path(), "weak", "machine", &["--from", "wirebend-kit", &value]);
        let low = found(folder.path(), &sample, "bend_torque_low", &["--machine", "weak"]);
        assert_eq!(low.len(), usize::from(warned), "{torque} N·m: {low:?}");
        for one in low {
            assert_eq!(one["severity"], "warning");
            let message = one["message"].as_str().unwrap();
            assert!(message.contains("1.63 N·m") && message.contains("2.43 N·m"), "{message}");
        }
    }
}

/// The outside of bends round the pin is strained by half, where a tensile test of the wire ends at 5.4 %: neither is said,
/// since the published bends hold. What is warned of is the radius that somebody saw the wire take.
#[test]
fn a_wire_that_takes_a_larger_radius_than_that_of_the_pin_is_warned_of() {
    let folder = tempfile::tempdir().unwrap();
    let sample = example("u-sample.obj");
    for (diameters, warned) in [("0.5", false), ("0.6", true)] {
        let value = format!("min_bend_radius_diameters={diameters}");
        let values = ["--from", "aluminium-6061-t6-3mm", "fracture_strain=0.01", &value];
        set(folder.path(), "brittle", "material", &values);
        let on = ["--machine", "wirebend-kit", "--material", "brittle"];
        let small = found(folder.path(), &sample, "bend_radius_small", &on);
        assert_eq!(small.len(), usize::from(warned), "{diameters} diameters: {small:?}");
        for one in small {
            assert_eq!(one["severity"], "warning", "{one}");
            assert!((one["limit"].as_f64().unwrap() - 1.8).abs() < 1e-9, "{one}");
            let message = one["message"].as_str().unwrap();
            assert!(message.contains("1.50 mm") && message.contains("1.80 mm"), "{message}");
            assert!(one["limit_source"].as_str().unwrap().contains("by me"), "{one}");
        }
    }
}
