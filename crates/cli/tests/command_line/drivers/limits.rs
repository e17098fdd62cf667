//! What a machine's driver will refuse is known before the first step, and by every command alike.

use std::fs;
use std::path::Path;

use serde_json::{Value, json};

use super::in_c::Home;
use crate::{assert_fits, example};

/// A machine of one's own with settings for its driver.
pub fn machine(config: &Path, id: &str, inherits: &str, settings: &Value) {
    let file = config.join(format!("wirebend/machines/{id}.json"));
    fs::create_dir_all(file.parent().unwrap()).unwrap();
    let profile = json!({
        "schema_version": 1, "kind": "machine", "id": id, "inherits": inherits, "driver": {"settings": settings},
    });
    fs::write(&file, profile.to_string()).unwrap();
}

/// What a command says of a design with a code.
fn said<'a>(found: &'a Value, code: &str) -> Vec<&'a Value> {
    let all = found["diagnostics"].as_array().unwrap();
    all.iter().filter(|diagnostic| diagnostic["code"] == code).collect()
}

fn design(home: &Home, text: &str) -> String {
    fs::write(home.path("design.obj"), text).unwrap();
    home.word("design.obj")
}

/// The controller stops at it with the wire in the machine.
#[test]
fn a_feed_that_the_driver_refuses_is_found_before_a_wire_is_begun() {
    let home = Home::new();
    let long = design(&home, "v 0 0 0\nv 8000 0 0\nv 8000 100 0\nl 1 2 3\n");
    let found = home.run(&["check", &long, "-m", "wirebend-kit", "--json"]).ended(4).json();
    assert_fits("check", &found);
    let [feed] = said(&found, "feed_too_long")[..] else { panic!("{found:#}") };
    // README.md of the firmware: the largest feed of a line is 400000 steps of 54.44 a mm.
    assert_eq!((&feed["limit"], &feed["step"]), (&json!(7347.54), &json!(0)));
    assert!(feed["limit_source"].as_str().unwrap().contains("driver setting feed_most_mm"), "{feed}");
    for command in [&["plan", &long, "-o", "a.wbjob"], &["export", &long, "-o", "a.txt"]] {
        home.run(&[&command[..], &["-m", "wirebend-kit"]].concat()).ended(4);
    }
    assert!(!home.path("a.wbjob").exists() && !home.path("a.txt").exists());
}

#[test]
fn a_bend_limit_of_the_drivers_settings_holds_for_every_command() {
    let home = Home::new();
    machine(&home.path(""), "short", "wirebend-kit", &json!({"bend_limit_deg": 80}));
    let cube = example("cube-8-edges.obj");
    let found = home.run(&["check", &cube, "-m", "short", "--json"]).ended(4).json();
    // All seven bends are right angles, for which the axis has to go to more than a hundred degrees (Eq. 2).
    let bends = said(&found, "bend_out_of_reach");
    assert_eq!(bends.len(), 7, "{found:#}");
    let source = bends[0]["limit_source"].as_str().unwrap();
    assert!(source.contains("goes to 80.0°") && source.contains("driver setting bend_limit_deg"), "{source}");
    let planned = home.run(&["plan", &cube, "-m", "short", "-o", "a.wbjob", "--json"]).ended(4).json();
    assert_eq!((&planned["feasible"], &planned["time_s"]), (&json!(false), &Value::Null));
    home.run(&["export", &cube, "-m", "short", "-o", "a.txt"]).ended(4);
    let compared = home.run(&["plan", &cube, "-m", "wirebend-kit", "--compare", "short", "--json"]);
    let compared = compared.ended(0).json();
    let findings = &compared["to"][0]["newly_infeasible"]["diagnostics"];
    assert_eq!(findings.as_array().unwrap().len(), 7, "{compared:#}");
    // Bends of 60° need 71.9° and what springs back, 80.2°; of 45° less: they are bent as before.
    let gentle = design(&home, "v 0 0 0\nv 60 0 0\nv 102.426 42.426 0\nl 1 2 3\n");
    home.run(&["check", &gentle, "-m", "short"]).ended(0);
}

/// A design that is exported is checked with the settings that it is written with; a job was planned before them.
#[test]
fn what_is_set_for_an_export_is_checked() {
    let home = Home::new();
    let u = example("u-sample.obj");
    let native = |more: &[&str]| {
        home.run(&[&["export", &u, "-m", "wirebend-kit", "-o", "a.out", "--json"][..], more].concat())
    };
    native(&["--set", "bend_limit_deg=120"]).ended(0);
    fs::remove_file(home.path("a.out")).unwrap();
    let error = native(&["--set", "bend_limit_deg=80"]).ended(4).json();
    assert!(error.to_string().contains("driver setting bend_limit_deg"), "{error:#}");
    let error = native(&["--set", "feed_most_mm=30"]).ended(4).json();
    assert_eq!(said(&error["error"]["report"], "feed_too_long").len(), 3, "{error:#}");
    home.run(&["plan", &u, "-m", "wirebend-kit", "-o", "u.wbjob"]).ended(0);
    let job = |more: &[&str]| home.run(&[&["export", "u.wbjob", "-o", "a.out", "--json"][..], more].concat());
    let error = job(&["--set", "bend_limit_deg=80"]).ended(4).json();
    assert_eq!(error["error"]["code"], "beyond-limit");
    let message = error["error"]["message"].as_str().unwrap();
    assert!(message.contains("no more than 80.000°"), "{message}");
    assert!(!home.path("a.out").exists());
    job(&["--set", "bend_limit_deg=120"]).ended(0);
}

/// The head is turned another way where it can, and refused where it cannot.
#[test]
fn a_limit_of_the_head_in_the_drivers_settings_is_planned_for() {
    let home = Home::new();
    machine(&home.path(""), "tied", "wirebend-kit", &json!({"rotate_limit_deg": 100}));
    machine(&home.path(""), "close", "wirebend-kit", &json!({"rotate_limit_deg": 60}));
    machine(&home.path(""), "bound", "wirebend-kit", &json!({"rotate_limit_deg": 40}));
    // Three planes at right angles: a quarter turn from each to the next.
    let twisted = design(&home, "v 0 0 0\nv 60 0 0\nv 60 60 0\nv 60 60 60\nv 120 60 60\nl 1 2 3 4 5\n");
    // With less than a quarter turn to either side it turns before the first bend, so that the others are in reach.
    for (id, most) in [("tied", 100.0), ("close", 60.0)] {
        let planned = home.run(&["plan", &twisted, "-m", id, "--json"]).ended(0).json();
        let mut head = 0.0;
        for step in planned["compensated"]["steps"].as_array().unwrap() {
            head += step["rotate_deg"].as_f64().unwrap();
            assert!(f64::abs(head) <= most, "{planned:#}");
        }
    }
    // A machine that reads a table begins with the head at zero.
    let table = home.run(&["export", &twisted, "-m", "close", "-f", "lra-csv", "-o", "a.csv", "--json"]);
    let notes = table.ended(0).json()["notes"].to_string();
    assert!(
        notes.contains("so that the head reaches every bend") && notes.contains("before the first bend"),
        "{notes}"
    );
    let found = home.run(&["check", &twisted, "-m", "bound", "--json"]).ended(4).json();
    let [head] = said(&found, "rotation_out_of_range")[..] else { panic!("{found:#}") };
    assert!(head["limit_source"].as_str().unwrap().contains("driver setting rotate_limit_deg"), "{head}");
    assert!((head["limit"].as_f64().unwrap().abs() - 40.0).abs() < 0.5);
}

/// The program that the machine is run with moves at these rates, whatever the profile says elsewhere.
#[test]
fn a_rate_of_the_drivers_settings_changes_the_time() {
    let home = Home::new();
    machine(&home.path(""), "slow", "wirebend-kit", &json!({"feed_rate_mm_per_s": 11.02}));
    let cube = example("cube-8-edges.obj");
    let on = |id: &str| home.run(&["plan", &cube, "-m", id, "--json"]).ended(0).json();
    let (quick, slow) = (on("wirebend-kit"), on("slow"));
    let fed = quick["compensated"]["feed_mm"].as_f64().unwrap();
    // 110.2 mm/s in the profile, a tenth of it in the settings.
    let longer = fed / 11.02 - fed / 110.2;
    let time = |plan: &Value| plan["time_s"].as_f64().unwrap();
    assert!((time(&slow) - time(&quick) - longer).abs() < 1e-6, "{} and {}", time(&slow), time(&quick));
}

/// What no setting says: grbl counts in single precision.
#[test]
fn a_range_that_only_the_driver_knows_is_checked() {
    let home = Home::new();
    machine(
        &home.path(""),
        "fine",
        "grbl-bender",
        &json!({"feed_units_per_mm": 10000, "feed_rate_mm_per_min": 60}),
    );
    let found = home.run(&["check", &example("u-sample.obj"), "-m", "fine", "--json"]).ended(4).json();
    // 1000000 units are 100 mm; three sides of 35 mm are more.
    let [stock] = said(&found, "stock_too_long")[..] else { panic!("{found:#}") };
    let source = stock["limit_source"].as_str().unwrap();
    assert!(source.contains("grbl counts up to 1000000 units") && source.contains("driver grbl"), "{source}");
    home.run(&["check", &example("u-sample.obj"), "-m", "grbl-bender"]).ended(0);
}

#[test]
fn settings_that_the_driver_does_not_take_are_no_machine_to_check_on() {
    let home = Home::new();
    machine(&home.path(""), "wrong", "wirebend-kit", &json!({"bend_limit_deg": 170}));
    let error = home.run(&["check", &example("house.obj"), "-m", "wrong", "--json"]).ended(3).json();
    assert_eq!(error["error"]["code"], "driver-settings");
    assert!(error["error"]["message"].as_str().unwrap().contains("home_position_deg"), "{error}");
}

/// A plan that was not held against the driver must not look like one that was.
#[test]
fn a_driver_that_cannot_be_asked_is_told() {
    let home = Home::new();
    let checked = home.run_installed(&["check", &example("house.obj"), "-m", "grbl-bender", "--json"]);
    let notes = checked.ended(0).json()["notes"].clone();
    let note = notes.as_array().unwrap().iter().find(|note| note["code"] == "driver-limits-unknown");
    let message = note.unwrap_or_else(|| panic!("{notes:#}"))["message"].as_str().unwrap();
    assert!(message.contains("there is no driver 'grbl'"), "{message}");
}
