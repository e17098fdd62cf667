//! Formats and settings of drivers, on the command line and in profiles.

use std::fs;

use serde_json::json;

use super::in_c::Home;
use crate::{assert_fits, example};

#[test]
fn settings_are_given_for_one_export() {
    let home = Home::new();
    let house = example("house.obj");
    let export = |rest: &[&str]| {
        let arguments = [&["export", &house, "-o", "-"], rest].concat();
        home.run(&arguments)
    };
    let text = |rest: &[&str]| String::from_utf8(export(rest).ended(0).out).unwrap();
    assert!(text(&["-m", "grbl-bender"]).contains("\nG91\n"));
    let absolute = text(&["-m", "grbl-bender", "--set", "mode=absolute", "--set", "decimals=1"]);
    assert!(absolute.contains("\nG90\nG92 X0 Y0 Z0\n") && !absolute.contains(".000 "), "{absolute}");
    let lines = text(&["-m", "grbl-bender", "--set", "end_block=[\"M30\"]", "--set", "comments=none"]);
    assert!(lines.ends_with("\nM30\n") && lines.starts_with("G21\n"), "{lines}");
    let table = text(&["-m", "table-bender", "--set", "preset=decimal-comma"]);
    assert!(table.starts_with("L_mm;R_deg;") && table.contains(','), "{table}");
    // A setting goes before that of the profile, which divides feeds above 682 mm.
    let words = text(&["-m", "howtomechatronics", "--set", "most_feed_mm=30"]);
    let feeds: Vec<u32> = words.lines().filter_map(|line| line.strip_prefix('f')?.parse().ok()).collect();
    assert!(feeds.contains(&30) && feeds.iter().all(|&feed| feed <= 30), "{words}");
}

#[test]
fn a_setting_that_does_not_fit_is_named() {
    let home = Home::new();
    let house = example("house.obj");
    let export = |rest: &[&str]| home.run(&[&["export", &house, "-o", "house.out"], rest].concat());
    let said = export(&["-m", "grbl-bender", "--set", "digits=2"]).ended(3).err;
    assert!(said.contains("'grbl'") && said.contains("digits") && said.contains("decimals"), "{said}");
    let said = export(&["-m", "grbl-bender", "--set", "decimals=9"]).ended(3).err;
    assert!(said.contains("'decimals' is 9") && said.contains("0 to 4"), "{said}");
    let said = export(&["-m", "pensa-diwire-pro", "--set", "case=loud"]).ended(3).err;
    assert!(said.contains("loud") && said.contains("title"), "{said}");
    let error = export(&["-m", "grbl-bender", "--set", "decimals=9", "--json"]).ended(3).json();
    assert_fits("error", &error);
    assert_eq!(error["error"]["code"], "driver-settings");
    let said = export(&["-m", "grbl-bender", "--set", "decimals"]).ended(2).err;
    assert!(said.contains("KEY=VALUE"), "{said}");
    for format in ["svg", "obj"] {
        let said = export(&["-m", "grbl-bender", "-f", format, "--set", "decimals=2"]).ended(2).err;
        assert!(said.contains(&format!("{format} has no settings")), "{said}");
    }
    assert!(!home.path("house.out").exists());
}

#[test]
fn an_unknown_format_lists_the_known_ones() {
    let home = Home::new();
    let arguments = ["export", &example("house.obj"), "-m", "grbl-bender", "-f", "g-code"];
    let said = home.run(&arguments).ended(2).err;
    for known in
        ["'g-code'", "gcode", "howtomechatronics-serial", "lra-csv", "pensa-script", "svg", "xyz-csv"]
    {
        assert!(said.contains(known), "{known} is not in {said}");
    }
    let error = home.run(&[&arguments[..], &["--json"]].concat()).ended(2).json();
    assert_fits("error", &error);
}

/// A picture or a table in the place of a program would be taken for it.
#[test]
fn the_own_format_of_a_machine_without_its_driver_is_not_replaced_in_silence() {
    let home = Home::new();
    let ran = home.run_installed(&["export", &example("house.obj"), "--machine", "howtomechatronics"]);
    assert!(ran.status != 0 && ran.out.is_empty(), "{}", ran.err);
    for said in ["howtomechatronics-serial", "there is no driver 'howtomechatronics'", "--driver-path"] {
        assert!(ran.err.contains(said), "{said}: {}", ran.err);
    }
}

/// A profile with a driver and its settings, each on a line of its own.
fn profile(driver: &str, settings: &serde_json::Value) -> String {
    format!(
        "{{\n\"schema_version\": 1,\n\"kind\": \"machine\",\n\"id\": \"mine\",\n\"inherits\": \"grbl-bender\",\n\
         \"driver\": {{\n\"id\": \"{driver}\",\n\"settings\": {settings}\n}}\n}}\n"
    )
}

#[test]
fn a_profile_with_settings_that_its_driver_does_not_take_is_refused() {
    let home = Home::new();
    let check = |driver: &str, settings: &serde_json::Value| {
        fs::write(home.path("mine.json"), profile(driver, settings)).unwrap();
        home.run(&["profile", "check", "mine.json", "--json"])
    };
    let right = check("grbl", &json!({"decimals": 2})).ended(0).json();
    assert_fits("profile-check", &right);
    assert_eq!(right["files"][0]["notes"], json!([]));
    for (settings, says) in [
        (json!({"decimals": 9}), "'decimals' is 9"),
        (json!({"digits": 2}), "digits"),
        (json!({"feed_axis": "Y"}), "'rotate_axis' is Y, and so is 'feed_axis'"),
    ] {
        let wrong = check("grbl", &settings).ended(3).json();
        assert_fits("profile-check", &wrong);
        let error = wrong["files"][0]["errors"][0].as_str().unwrap().to_owned();
        // The settings stand on line 8.
        assert!(error.starts_with("mine.json:8: driver.settings"), "{error}");
        assert!(error.contains(says) && error.contains("'grbl'"), "{error}");
    }
    let unknown = check("elsewhere", &json!({"decimals": 2})).ended(0).json();
    assert_fits("profile-check", &unknown);
    let note = unknown["files"][0]["notes"][0].as_str().unwrap();
    assert!(note.contains("were not checked") && note.contains("'elsewhere'"), "{note}");
    let said = home.run(&["profile", "check", "mine.json"]).ended(0).err;
    assert!(said.contains("were not checked"), "{said}");
}
