//! Profiles that are edited in the window.

use super::*;

fn value<'a>(view: &'a Value, key: &str) -> &'a Value {
    let values = view["profile"]["values"].as_array().unwrap();
    values.iter().find(|value| value["key"] == key).unwrap_or(&Value::Null)
}

/// Who measures their head and types it in gets another program for the open design at once, and can go back value by value.
#[test]
fn a_dimension_of_a_copy_is_set_with_its_source_and_taken_back() {
    let window = Window::new();
    window.ask("open-example", json!({"id": "house"}));
    let copy = json!({"kind": "machine", "from": "wirebend-kit", "id": "mine", "name": "Mine"});
    window.ask("copy-profile", copy);
    window.ask("edit", json!({"request": {"edit": "machine", "machine": "mine", "material": null}}));
    let first = window.ask("profile-view", json!({"kind": "machine", "id": "mine"}));
    assert_eq!((&first["shipped"], &first["has_last_change"]), (&json!(false), &json!(false)));
    assert_eq!(first["head"]["peg"]["orbit_radius_mm"], 20.4);
    let before = window.ask("program", json!({}));

    let set = |values: Value| json!({"kind": "machine", "id": "mine", "values": values, "source": "measured by me on 2026-11-26", "measured": true});
    let radius = [json!({"key": "bend.orbit_radius_mm", "value": 21.0})];
    let view = window.ask("set-profile", set(json!(radius)));
    let set_value = value(&view, "bend.orbit_radius_mm");
    assert_eq!(set_value["value"], 21.0);
    assert_eq!(set_value["source"], "measured by me on 2026-11-26");
    assert_eq!((&set_value["measured"], &set_value["set_by"]), (&json!(true), &json!("mine")));
    assert_eq!(set_value["instead_of"], json!({"value": 20.4, "set_by": "wirebend-kit"}));
    // The drawing is of the head as it is now, and so is the program of the open design.
    assert_eq!(view["head"]["peg"]["orbit_radius_mm"], 21.0);
    let told = |program: &Value| program["wires"][0]["steps"][1]["told"]["bend_deg"].as_f64().unwrap();
    let after = window.ask("program", json!({}));
    assert!((told(&before) - told(&after)).abs() > 0.01, "{} {}", told(&before), told(&after));

    // What cannot be is refused, and nothing is written.
    let file = std::fs::read(view["file"].as_str().unwrap()).unwrap();
    let wrong = [json!({"key": "bend.orbit_radius_mm", "value": -3})];
    assert_eq!(window.try_ask("set-profile", set(json!(wrong))).unwrap_err().code, "profile-rule");
    assert_eq!(std::fs::read(view["file"].as_str().unwrap()).unwrap(), file);

    let window_revert =
        |keys: Value| window.ask("revert-profile", json!({"kind": "machine", "id": "mine", "keys": keys}));
    let two = json!([{"key": "signs.bend", "value": -1}, {"key": "time.fixed_per_bend_s", "value": 2}]);
    window.ask("set-profile", set(two));
    let back = window_revert(json!(["bend.orbit_radius_mm"]));
    assert_eq!(value(&back, "bend.orbit_radius_mm")["set_by"], "wirebend-kit");
    assert_eq!(value(&back, "signs.bend")["set_by"], "mine");
    let again = window_revert(json!([]));
    assert_eq!(value(&again, "bend.orbit_radius_mm")["value"], 21.0, "the last change was the revert");
    assert_eq!(again["has_last_change"], true);
}

/// The drawing of the head follows what is typed, by the same rules as what is written, and the file stays as it is.
#[test]
fn the_head_is_drawn_with_values_that_are_not_written() {
    let window = Window::new();
    let copy = json!({"kind": "machine", "from": "wirebend-kit", "id": "mine", "name": "Mine"});
    window.ask("copy-profile", copy);
    let view = window.ask("profile-view", json!({"kind": "machine", "id": "mine"}));
    let file = std::fs::read(view["file"].as_str().unwrap()).unwrap();
    let typed =
        |value: f64| json!({"id": "mine", "values": [{"key": "bend.orbit_radius_mm", "value": value}]});
    let head = window.ask("draw-head", typed(30.0));
    assert_eq!(head["peg"]["orbit_radius_mm"], 30.0);
    // At a right angle the peg touches the outside of the leg: 1.5 mm pin, 3 mm wire, 3.175 mm peg.
    assert!((head["peg"]["at_mm"][0].as_f64().unwrap() - 7.675).abs() < 1e-9);
    let (x, y) = (7.675 - 12.0, head["peg"]["at_mm"][1].as_f64().unwrap());
    assert!((f64::hypot(x, y) - 30.0).abs() < 1e-9, "it is on the orbit that was typed");
    assert_eq!(window.try_ask("draw-head", typed(-1.0)).unwrap_err().code, "profile-rule");
    assert_eq!(std::fs::read(view["file"].as_str().unwrap()).unwrap(), file);
}

/// A springback that was measured takes the place of a table as a whole, and a list of bodies that of the parent's.
#[test]
fn values_that_are_replaced_as_a_whole_are_set_as_a_whole() {
    let window = Window::new();
    let copy = json!({"kind": "material", "from": "aluminium-3-175mm", "id": "spool", "name": "My spool"});
    window.ask("copy-profile", copy);
    let loss =
        json!({"model": "constant", "angle_deg": {"value": 6.5, "source": "three bends", "measured": true}});
    let values = json!([{"key": "springback", "value": loss}]);
    let set = json!({"kind": "material", "id": "spool", "values": values, "source": "three bends", "measured": true});
    let view = window.ask("set-profile", set);
    assert_eq!(value(&view, "springback.angle_deg")["value"], 6.5);
    assert_eq!(value(&view, "springback.positive"), &Value::Null);
    let back =
        window.ask("revert-profile", json!({"kind": "material", "id": "spool", "keys": ["springback"]}));
    assert!(value(&back, "springback.positive").is_object());
}

/// A machine is passed on as one file, also where it inherits from another one of the person's own.
#[test]
fn a_profile_goes_to_another_computer_as_one_file() {
    let window = Window::new();
    let copy = |from: &str, id: &str| json!({"kind": "machine", "from": from, "id": id, "name": id});
    window.ask("copy-profile", copy("wirebend-kit", "base"));
    window.ask("copy-profile", copy("base", "mine"));
    let set = |id: &str, key: &str, value: Value| {
        let values = json!([{"key": key, "value": value}]);
        window.ask(
            "set-profile",
            json!({"kind": "machine", "id": id, "values": values, "source": "caliper", "measured": true}),
        )
    };
    set("base", "bend.pin_radius_mm", json!(1.6));
    // A value that the base takes away stays away.
    set("base", "bend.torque_n_m", Value::Null);
    let mine = set("mine", "bend.orbit_radius_mm", json!(20.5));
    let file = window.home.path().join("mine.json");
    let export = json!({"kind": "machine", "id": "mine", "output": {"path": file}});
    window.ask("export-profile", export.clone());
    assert_eq!(window.try_ask("export-profile", export).unwrap_err().code, "exists");

    let other = Window::new();
    let import = json!({"file": file});
    assert!(std::fs::read_to_string(&file).unwrap().contains("\"torque_n_m\": null"));
    let taken = other.ask("import-profile", import.clone());
    let told = |key: &str| taken[key].clone();
    assert_eq!(["kind", "id", "name"].map(told), [json!("machine"), json!("mine"), json!("mine")]);
    let view = other.ask("profile-view", json!({"kind": "machine", "id": "mine"}));
    let plain = |view: &Value| -> Vec<[Value; 2]> {
        let values = view["profile"]["values"].as_array().unwrap().iter();
        values
            .filter(|value| !value["value"].is_null())
            .map(|value| [value["key"].clone(), value["value"].clone()])
            .collect()
    };
    assert_eq!(plain(&view), plain(&mine));
    assert_eq!(view["profile"]["chain"][1]["id"], "wirebend-kit");
    assert_eq!(taken["known"], json!(false));
    // Nothing differs: it is there already, and there is no second one.
    let again = other.ask("import-profile", import.clone());
    assert_eq!(
        [&again["known"], &again["id"], &again["file"]],
        [&json!(true), &json!("mine"), &taken["file"]]
    );
    // Who wants another one all the same can tell them apart.
    let taken = other.ask("import-profile", json!({"file": file, "id": "second"}));
    let told = ["id", "name", "own_name"].map(|key| taken[key].clone());
    assert_eq!(told, [json!("second"), json!("mine (2)"), json!("mine")]);
    let asked = json!({"kind": "machine", "id": "mine", "source": "caliper", "measured": true,
        "values": [{"key": "bend.orbit_radius_mm", "value": 21.0}]});
    other.ask("set-profile", asked);
    let known = other.ask("import-profile", import.clone());
    assert_eq!([&known["known"], &known["id"]], [&json!(true), &json!("second")], "the copy is the same");
    // A file that is no profile is none, whatever it is called.
    std::fs::write(&file, "{\"kind\": \"cat\"}").unwrap();
    assert_eq!(
        other.try_ask("import-profile", json!({"file": file})).unwrap_err().code,
        "profile-unknown-kind"
    );
}

/// A machine goes to a colleague with the wire that it was calibrated with. A wire of theirs that has its id stays as it is, and what is
/// there already is not taken in twice.
#[test]
fn a_machine_is_passed_on_with_its_own_wire() {
    let copy = |window: &Window, kind: &str, from: &str, id: &str| {
        window.ask("copy-profile", json!({"kind": kind, "from": from, "id": id, "name": id}))
    };
    let set = |window: &Window, kind: &str, id: &str, key: &str, value: Value| {
        let values = json!([{"key": key, "value": value}]);
        let asked = json!({"kind": kind, "id": id, "values": values, "source": "coupons", "measured": true});
        window.ask("set-profile", asked)
    };
    let loss = |deg: f64| json!({"model": "constant", "angle_deg": deg});
    let window = Window::new();
    copy(&window, "material", "aluminium-6061-t6-3mm", "spool");
    set(&window, "material", "spool", "springback", loss(9.25));
    copy(&window, "machine", "wirebend-kit", "mine");
    set(&window, "machine", "mine", "default_material", json!("spool"));
    let file = window.home.path().join("mine.json");
    let export = |alone: bool, file: &std::path::Path| {
        let output = json!({"path": file, "force": true});
        window
            .ask("export-profile", json!({"kind": "machine", "id": "mine", "output": output, "alone": alone}))
    };
    assert_eq!(export(false, &file)["with"], json!([{"kind": "material", "id": "spool"}]));

    let wire_of = |window: &Window, machine: &str| {
        let view = window.ask("profile-view", json!({"kind": "machine", "id": machine}));
        value(&view, "default_material")["value"].as_str().unwrap().to_owned()
    };
    let loss_of = |window: &Window, wire: &str| {
        let view = window.ask("profile-view", json!({"kind": "material", "id": wire}));
        value(&view, "springback.angle_deg").clone()
    };
    let other = Window::new();
    let taken = other.ask("import-profile", json!({"file": file}));
    assert_eq!(taken["with"], json!([{"kind": "material", "id": "spool"}]));
    assert_eq!(wire_of(&other, "mine"), "spool");
    let found = loss_of(&other, "spool");
    assert_eq!(
        (&found["value"], &found["source"], &found["measured"]),
        (&json!(9.25), &json!("coupons"), &json!(true))
    );

    // A second time the wire is there; once it is changed, the one of the file gets another id.
    other.ask("import-profile", json!({"file": file, "id": "second"}));
    assert_eq!(wire_of(&other, "second"), "spool");
    set(&other, "material", "spool", "springback", loss(4.0));
    let taken = other.ask("import-profile", json!({"file": file, "id": "third"}));
    assert_eq!(taken["with"], json!([{"kind": "material", "id": "spool-2"}]));
    assert_eq!((wire_of(&other, "third"), wire_of(&other, "mine")), ("spool-2".into(), "spool".into()));
    assert_eq!(loss_of(&other, "spool")["value"], 4.0);
    assert_eq!(loss_of(&other, "spool-2")["value"], 9.25);
    let name =
        other.ask("profile-view", json!({"kind": "material", "id": "spool-2"}))["profile"]["name"].clone();
    assert_eq!(name, "spool (2)", "both would be called alike in every list");
    // Not once more under a third id.
    let taken = other.ask("import-profile", json!({"file": file, "id": "fourth"}));
    assert_eq!(taken["with"], json!([{"kind": "material", "id": "spool-2"}]));

    // Alone it names a wire that others have not; a file with a wrong wire is refused as a whole.
    assert_eq!(export(true, &file)["with"], json!([]));
    let third = Window::new();
    assert_eq!(
        third.try_ask("import-profile", json!({"file": file})).unwrap_err().code,
        "profile-unknown-reference"
    );
    export(false, &file);
    let exported = std::fs::read_to_string(&file).unwrap();
    let (before, after) = exported.rsplit_once("\"name\":").unwrap();
    let with_a_wrong_key = format!("{before}\"nom\":{after}");
    // What is wrong in the wire is found by its line in the file that the person has: a rule that is broken, and a key that is none.
    for (wrong, code) in
        [(exported.replace("9.25", "-9.25"), "profile-rule"), (with_a_wrong_key, "profile-shape")]
    {
        let changed = wrong.lines().zip(exported.lines()).position(|(a, b)| a != b).unwrap() + 1;
        assert!(changed > 10, "the wire stands behind the machine");
        std::fs::write(&file, wrong).unwrap();
        let refused = third.try_ask("import-profile", json!({"file": file})).unwrap_err();
        assert_eq!(refused.code, code, "{}", refused.message);
        assert!(refused.message.contains(&format!("mine.json:{changed}:")), "{changed}: {}", refused.message);
    }
    assert_eq!(
        third.try_ask("profile-view", json!({"kind": "material", "id": "spool"})).unwrap_err().code,
        "profile-unknown"
    );
}
