//! Machine profiles and their drivers' settings, through inheritance.

use std::fs;

use super::in_c::Home;
use crate::example;

fn write(home: &Home, name: &str, rest: &str) {
    let file = home.path(name);
    fs::create_dir_all(file.parent().unwrap()).unwrap();
    fs::write(&file, format!("{{\"schema_version\": 1, \"kind\": \"machine\", {rest}}}")).unwrap();
}

const PARENT: &str = r#""id": "p", "inherits": "grbl-bender",
    "driver": {"settings": {"feed_axis": "Y", "rotate_axis": "A"}}"#;

/// It would be found out at the first export.
#[test]
fn a_native_format_that_nobody_writes_is_refused() {
    let home = Home::new();
    write(&home, "a.json", r#""id": "a", "inherits": "grbl-bender", "export": {"native": "no-such-format"}"#);
    assert!(home.run(&["profile", "check", "a.json"]).ended(3).err.contains("no-such-format"));
}

/// It is known to another driver, which does not write it for a machine of this one. A table is for every machine.
#[test]
fn a_format_that_only_another_driver_writes_is_refused() {
    let home = Home::new();
    for (rest, status) in [
        (r#""export": {"native": "pensa-script"}"#, 3),
        (r#""export": {"formats": ["svg", "pensa-script"]}"#, 3),
        (r#""export": {"native": "gcode", "formats": ["svg", "lra-csv"]}"#, 0),
        // The format of the parent was for the driver of the parent.
        (r#""driver": {"id": "pensa"}"#, 3),
        (r#""driver": {"id": "pensa"}, "export": {"native": "pensa-script"}"#, 0),
    ] {
        write(&home, "a.json", &format!(r#""id": "a", "inherits": "grbl-bender", {rest}"#));
        let said = home.run(&["profile", "check", "a.json"]).ended(status).err;
        assert_eq!(said.contains("a.json:") && said.contains("for this machine"), status == 3, "{said}");
    }
}

/// A child gives some settings and its parent the others: what is checked is what an export gets.
#[test]
fn settings_are_checked_as_they_are_inherited() {
    let home = Home::new();
    write(&home, "wirebend/machines/p.json", PARENT);
    // The parent's Y and A, the driver's own Z: X is free, and A is taken twice.
    for (id, axis, status) in [("c", r#""rotate_axis": "X""#, 0), ("d", r#""bend_axis": "A""#, 3)] {
        let file = format!("wirebend/machines/{id}.json");
        write(
            &home,
            &file,
            &format!(r#""id": "{id}", "inherits": "p", "driver": {{"settings": {{{axis}}}}}"#),
        );
        home.run(&["export", &example("house.obj"), "-m", id, "-o", "-"]).ended(status);
        home.run(&["profile", "check", &file]).ended(status);
    }
}

#[test]
fn settings_for_the_driver_of_a_parent_beside_the_file_are_checked() {
    let home = Home::new();
    write(&home, "x/machines/p.json", PARENT);
    let bad = r#""id": "r", "inherits": "p", "driver": {"settings": {"decimals": 9}}"#;
    write(&home, "x/machines/r.json", bad);
    home.run(&["profile", "check", "x/machines/r.json"]).ended(3);
}

/// What was not checked has to be said.
#[test]
fn a_driver_that_is_not_installed_is_noted() {
    let home = Home::new();
    write(&home, "b.json", r#""id": "b", "inherits": "grbl-bender", "driver": {"id": "elsewhere"}"#);
    let found = home.run(&["profile", "check", "b.json", "--json"]).ended(0).json();
    assert!(found["files"][0]["notes"].to_string().contains("elsewhere"), "{found:#}");
}

/// A path that is mistyped is noticed.
#[test]
fn a_driver_path_that_is_not_there_is_said_by_every_command() {
    let home = Home::new();
    let arguments =
        ["export", &example("house.obj"), "-m", "grbl-bender", "-f", "mine", "--driver-path", "nowhere"];
    assert!(home.run(&arguments).ended(2).err.contains("nowhere"));
}

/// Another driver knows the format, but not the settings that the machine's own has.
#[test]
fn only_the_machines_own_driver_writes_its_program() {
    let home = Home::new();
    let other =
        r#""id": "a", "inherits": "grbl-bender", "driver": {"id": "elsewhere", "settings": {"axis": "A"}}"#;
    write(&home, "wirebend/machines/a.json", other);
    let said = home.run(&["export", &example("house.obj"), "-m", "a", "-o", "-"]).ended(5).err;
    assert!(said.contains("'gcode'") && said.contains("there is no driver 'elsewhere'"), "{said}");
}

/// Two wires in a row would wind the cables of the head up.
#[test]
fn a_head_that_is_left_turned_is_told() {
    let home = Home::new();
    let export = |design: &str| {
        home.run(&["export", &example(design), "--double", "-m", "pensa-diwire-pro", "-o", "-"])
    };
    assert!(export("truss-1.obj").ended(0).err.contains("the head ends"));
    // By a driver or by the program itself, it is the same head.
    let own = home.run(&["export", &example("cup-holder.obj"), "-m", "wirebend-kit", "-o", "-"]).ended(0);
    assert!(own.err.contains("the head ends"), "{}", own.err);
    // Flat wires are bent without a turn.
    assert!(!export("u-sample.obj").ended(0).err.contains("the head ends"));
}
