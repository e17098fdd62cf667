//! A person's own profiles: started from another, and explained.

use std::path::Path;

use crate::{assert_fits, example, run_in};

fn read(folder: &Path, name: &str) -> String {
    std::fs::read_to_string(folder.join(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
}

#[test]
fn a_new_profile_goes_to_the_persons_own_folder_and_is_used_from_there() {
    let folder = tempfile::tempdir().unwrap();
    let run = |arguments: &[&str]| run_in(folder.path(), arguments, b"");
    let new = ["profile", "new", "my-kit", "--from", "wirebend-kit", "--kind", "machine", "--name", "My kit"];
    let said = run(&new).ended(0).err;
    // The tests' configuration folder is the folder itself.
    let file = "wirebend/machines/my-kit.json";
    assert!(said.contains(file) && said.contains("inherits from wirebend-kit"), "{said}");
    assert_eq!(read(folder.path(), file).lines().count(), 7, "five values between two braces");
    let listed = String::from_utf8(run(&["machines"]).ended(0).out).unwrap();
    assert!(listed.contains("My kit"), "{listed}");
    let cube = example("cube-8-edges.obj");
    run(&["check", &cube, "--machine", "my-kit"]).ended(0);

    assert!(run(&new).ended(2).err.contains("--force"));
    run(&[&new[..], &["--force", "--all"]].concat()).ended(0);
    // The published limit, to be replaced by what the person measures.
    let text = read(folder.path(), file);
    let source = "\"source\": \"SCF25, machine specification\", \"measured\": false }";
    let own = "\"source\": \"my cable\", \"measured\": true }";
    let mut measured = text.clone();
    for (key, published, mine) in [("max_bend_deg", "155.0", "80"), ("min_bend_deg", "-155.0", "-80")] {
        let limit = format!("\"{key}\": {{ \"value\": {published}, {source},");
        assert!(text.contains(&limit), "{limit} is not in {text}");
        measured = measured.replace(&limit, &format!("\"{key}\": {{ \"value\": {mine}, {own},"));
    }
    std::fs::write(folder.path().join(file), measured).unwrap();
    run(&["profile", "check", file]).ended(0);
    let said = run(&["check", &cube, "--machine", "my-kit"]).ended(4).err;
    assert!(said.contains("my cable"), "{said}");
}

#[test]
fn a_new_profile_is_printed_or_written_where_it_was_asked_for() {
    let folder = tempfile::tempdir().unwrap();
    let run = |arguments: &[&str]| run_in(folder.path(), arguments, b"");
    let new = ["profile", "new", "my-steel", "--from", "steel-1mm"];
    let printed = run(&[&new[..], &["-o", "-"]].concat()).ended(0);
    assert_eq!(printed.json()["inherits"], "steel-1mm");
    assert!(!folder.path().join("wirebend").exists(), "nothing else is written");
    let made = run(&[&new[..], &["-o", "my-steel.json", "--json"]].concat()).ended(0).json();
    assert_fits("profile-new", &made);
    let expected = serde_json::json!({"id": "my-steel", "kind": "material", "file": "my-steel.json",
        "inherits": "steel-1mm"});
    assert_eq!(made, expected);
    assert_eq!(read(folder.path(), "my-steel.json").as_bytes(), printed.out);
    run(&["profile", "check", "my-steel.json"]).ended(0);
    run(&["profile", "new", "My Steel", "--from", "steel-1mm"]).ended(2);
    run(&["profile", "new", "my-steel", "--from", "steel-1010"]).ended(2);
    run(&["profile", "new", "my-steel", "--from", "steel-1mm", "--kind", "colour"]).ended(2);
    assert!(!folder.path().join("wirebend").exists(), "a refusal leaves no folder behind");
}

#[test]
fn every_value_is_explained_with_its_file_and_line() {
    let folder = tempfile::tempdir().unwrap();
    let machines = folder.path().join("wirebend/machines");
    std::fs::create_dir_all(&machines).unwrap();
    let child = r#"{
  "schema_version": 1, "kind": "machine", "id": "my-kit", "inherits": "wirebend-kit",
  "limits": {
    "max_bend_deg": {"value": 120, "source": "bent ten on mine", "measured": true},
    "min_bend_deg": {"value": -155.0, "source": "bent ten on mine", "measured": true}
  },
  "error": null
}"#;
    std::fs::write(machines.join("my-kit.json"), child).unwrap();
    let run = |arguments: &[&str]| run_in(folder.path(), arguments, b"");
    let ran = run(&["profile", "explain", "my-kit"]).ended(0);
    let text = String::from_utf8(ran.out).unwrap();
    assert!(!text.contains('\u{1b}'), "no colours in a pipe");
    let line = |key: &str| {
        let found = text.lines().find(|line| line.split_whitespace().take(3).any(|word| word == key));
        found.unwrap_or_else(|| panic!("{key}: {text}")).split_whitespace().collect::<Vec<_>>().join(" ")
    };
    // The child's lines count from its opening brace.
    let bend = "120° limits.max_bend_deg my-kit:4 measured, instead of 155° from wirebend-kit";
    assert_eq!(line("limits.max_bend_deg"), bend);
    assert_eq!(
        line("limits.min_bend_deg"),
        "-155° limits.min_bend_deg my-kit:5 measured, as in wirebend-kit"
    );
    assert_eq!(line("error"), "none error my-kit:7 instead of wirebend-kit from wirebend-kit");
    assert!(line("limits.tail_mm").starts_with("400"), "{text}");
    assert!(text.contains("← wirebend-kit  shipped  machine-profiles/machines/wirebend-kit.json"), "{text}");
    assert!(text.contains("bent ten on mine"), "{text}");
    // File names may be longer than the screen; nothing else is.
    let widest = text.lines().skip(3).map(|line| line.chars().count()).max().unwrap();
    assert!(widest <= 120, "{widest}");
    let json = run(&["profile", "explain", "my-kit", "--json"]).ended(0).json();
    assert_fits("profile-explain", &json);
    let values = json["values"].as_array().unwrap();
    let bend = values.iter().find(|value| value["key"] == "limits.max_bend_deg").unwrap();
    assert_eq!(
        (bend["line"].as_u64(), bend["instead_of"]["set_by"].as_str()),
        (Some(4), Some("wirebend-kit"))
    );
    assert!(bend["file"].as_str().unwrap().ends_with("my-kit.json"));
}

#[test]
fn every_shipped_profile_can_be_explained() {
    let folder = tempfile::tempdir().unwrap();
    for kind in ["machine", "material", "noise"] {
        let sub_folder = if kind == "noise" { kind.to_owned() } else { format!("{kind}s") };
        for entry in std::fs::read_dir(crate::root().join("machine-profiles").join(sub_folder)).unwrap() {
            let path = entry.unwrap().path();
            let id = path.file_stem().unwrap().to_str().unwrap().to_owned();
            let explain = ["profile", "explain", &id, "--kind", kind];
            let text = String::from_utf8(run_in(folder.path(), &explain, b"").ended(0).out).unwrap();
            let widest = text.lines().map(|line| line.chars().count()).max().unwrap();
            assert!(widest <= 120, "{id}: {widest}");
            let json = run_in(folder.path(), &[&explain[..], &["--json"]].concat(), b"").ended(0).json();
            assert_fits("profile-explain", &json);
        }
    }
    let said = run_in(folder.path(), &["profile", "explain", "wirebend-kit"], b"").ended(2).err;
    assert!(said.contains("--kind machine or --kind noise"), "{said}");
    let said = run_in(folder.path(), &["profile", "explain", "steel-2mm"], b"").ended(2).err;
    assert!(said.contains("did you mean `steel-1mm`"), "{said}");
}

/// What somebody has measured reaches another person as one file, whatever it inherits from.
#[test]
fn a_profile_goes_from_one_person_to_another() {
    let [mine, theirs] = [(); 2].map(|()| tempfile::tempdir().unwrap());
    let set = |id: &str, from: &str, value: &str| {
        let kind = ["--kind", "machine", "--source", "caliper", "--measured"];
        run_in(mine.path(), &[&["profile", "set", id, "--from", from, value], &kind[..]].concat(), b"")
            .ended(0)
    };
    set("first", "wirebend-kit", "bend.orbit_radius_mm=20.45");
    set("second", "first", "bend.pin_radius_mm=1.6");
    let export = |more: &[&str]| {
        let kind = ["--kind", "machine"];
        run_in(mine.path(), &[&["profile", "export", "second"], &kind[..], more].concat(), b"")
    };
    let said = export(&["-o", "for-you.json"]).ended(0).err;
    assert!(said.contains("wrote for-you.json (machine 'second')"), "{said}");
    assert!(export(&["-o", "for-you.json"]).ended(2).err.contains("--force"));
    let exported = export(&["-o", "for-you.json", "--force", "--json"]).ended(0).json();
    assert_fits("profile-export", &exported);
    // Without a file it goes on to the next program.
    let text = export(&[]).ended(0).out;
    assert_eq!(text, read(mine.path(), "for-you.json").into_bytes());

    let file = mine.path().join("for-you.json");
    let import = |more: &[&str]| {
        run_in(theirs.path(), &[&["profile", "import", file.to_str().unwrap()], more].concat(), b"")
    };
    let said = import(&[]).ended(0).err;
    assert!(said.contains("machines/second.json (machine 'second')"), "{said}");
    let again = import(&[]).ended(0).err;
    assert!(again.contains("nothing to import") && again.contains("'second'"), "{again}");
    let imported = import(&["--id", "theirs", "--json"]).ended(0).json();
    assert_fits("profile-import", &imported);
    let of = |folder: &Path, id: &str| {
        let explained = ["profile", "explain", id, "--kind", "machine", "--json"];
        let found = run_in(folder, &explained, b"").ended(0).json();
        let values = found["values"].as_array().unwrap().clone();
        let plain = values.into_iter().map(|value| (value["key"].clone(), value["value"].clone()));
        plain.filter(|(key, _)| key != "id" && key != "name").collect::<Vec<_>>()
    };
    assert_eq!(of(theirs.path(), "theirs"), of(mine.path(), "second"));

    for (name, contents, expected) in [
        ("no.json", "", "no.json"),
        ("text.json", "hello", "text.json"),
        ("list.json", "[1]", "list.json"),
        ("other.json", "{\"kind\": \"noise\", \"id\": \"a\"}", "other.json"),
        (
            "open.json",
            "{\"schema_version\": 1, \"kind\": \"machine\", \"id\": \"open\", \"name\": \"Open\", \"inherits\": \"nobody\"}",
            "nobody",
        ),
    ] {
        let wrong = theirs.path().join(name);
        std::fs::write(&wrong, contents).unwrap();
        let said = run_in(theirs.path(), &["profile", "import", name], b"");
        let said = said.ended(3).err;
        assert!(said.contains(expected) && said.contains("help:"), "{name}: {said}");
    }
    let said = run_in(theirs.path(), &["profile", "import", "missing.json"], b"").ended(3).err;
    assert!(said.contains("missing.json"), "{said}");
}

/// A file that was exported with its wire is checked whole, and what is wrong in the wire is on its line.
#[test]
fn a_file_with_several_profiles_is_checked_whole() {
    let folder = tempfile::tempdir().unwrap();
    let run = |arguments: &[&str]| run_in(folder.path(), arguments, b"");
    let set = |kind: &str, id: &str, from: &str, value: &str| {
        let how = ["--kind", kind, "--source", "caliper", "--measured"];
        run(&[&["profile", "set", id, "--from", from, value], &how[..]].concat()).ended(0)
    };
    set("material", "spool", "aluminium-6061-t6-3mm", "diameter_mm=3.05");
    set("machine", "mine", "wirebend-kit", "default_material=\"spool\"");
    run(&["profile", "export", "mine", "--kind", "machine", "-o", "for-you.json"]).ended(0);
    let said = run(&["profile", "check", "for-you.json"]).ended(0).err;
    assert!(said.contains("for-you.json: ok (machine 'mine'"), "{said}");
    let text = read(folder.path(), "for-you.json");
    let wrong = text.replace("3.05", "-3.05");
    let line = wrong.lines().position(|line| line.contains("-3.05")).unwrap() + 1;
    std::fs::write(folder.path().join("wrong.json"), wrong).unwrap();
    let said = run(&["profile", "check", "wrong.json"]).ended(3).err;
    assert!(said.contains(&format!("wrong.json:{line}:")) && said.contains("diameter_mm"), "{said}");
}

/// Signs, choices, bodies and springback take a source from the command as figures do: nothing has to be written by hand.
#[test]
fn every_value_takes_its_source_from_the_command() {
    let folder = tempfile::tempdir().unwrap();
    let set = |id: &str, kind: &str, values: &[&str]| {
        let source = ["--kind", kind, "--source", "bent and looked", "--measured"];
        run_in(folder.path(), &[&["profile", "set", id], values, &source].concat(), b"")
    };
    let values = [
        "signs.bend=-1",
        "bend.before_zero=false",
        "compensation.setback=true",
        "bend.method=peg",
        "default_material=steel-3mm",
    ];
    set("mine", "machine", &[&["--from", "wirebend-kit"], &values[..]].concat()).ended(0);
    let explained = |id: &str, kind: &str| {
        let arguments = ["profile", "explain", id, "--kind", kind, "--json"];
        run_in(folder.path(), &arguments, b"").ended(0).json()["values"].clone()
    };
    let value = |values: &serde_json::Value, key: &str| {
        values.as_array().unwrap().iter().find(|value| value["key"] == key).unwrap().clone()
    };
    let machine = explained("mine", "machine");
    for given in values {
        let (key, _) = given.split_once('=').unwrap();
        let stated = value(&machine, key);
        assert_eq!(
            (&stated["source"], &stated["measured"]),
            (&"bent and looked".into(), &true.into()),
            "{key}"
        );
    }

    // One body of ten, by the keys that change; another is new, a third is gone.
    let count = |values: &serde_json::Value| value(values, "shapes")["value"].as_array().unwrap().len();
    let before = count(&machine);
    let bodies = [
        "shapes.arm of the peg={\"at_mm\": [12, 1, -20]}",
        "shapes.lamp={\"part\": \"frame\", \"solid\": {\"box\": {\"size_mm\": [9, 9, 9]}}, \"at_mm\": [0, 0, 200]}",
        "shapes.base=null",
    ];
    set("mine", "machine", &bodies).ended(0);
    let after = explained("mine", "machine");
    assert_eq!(count(&after), before);
    let after = value(&after, "shapes")["value"].clone();
    let body = |name: &str| after.as_array().unwrap().iter().find(|body| body["name"] == name).cloned();
    let arm = body("arm of the peg").unwrap();
    assert_eq!((&arm["source"], &arm["measured"]), (&"bent and looked".into(), &true.into()));
    assert_eq!(arm["at_mm"], serde_json::json!([12.0, 1.0, -20.0]));
    assert_eq!(arm["part"], "peg", "what was not named stays");
    assert_eq!(body("lamp").unwrap()["source"], "bent and looked");
    assert_eq!(body("base"), None);
    let refused = set("mine", "machine", &["shapes.nothing=null"]).ended(2).err;
    assert!(refused.contains("'nothing'") && refused.contains("a body that the machine has"), "{refused}");
    set("mine", "machine", &["shapes.lamp={\"at_mm\": 3}"]).ended(3);

    let table = "springback={\"model\": \"table\", \"positive\": [{\"angle_deg\": 0, \"loss_deg\": 1}, {\"angle_deg\": 90, \"loss_deg\": 2}]}";
    set("spool", "material", &["--from", "steel-1mm", table, "currency=EUR"]).ended(0);
    let wire = explained("spool", "material");
    for key in ["springback.positive", "currency"] {
        assert_eq!(value(&wire, key)["source"], "bent and looked", "{key}");
    }
    set("spool", "material", &["springback={\"model\": \"constant\", \"angle_deg\": 3.5}"]).ended(0);
    let wire = explained("spool", "material");
    assert_eq!(value(&wire, "springback.angle_deg")["source"], "bent and looked");
    assert_eq!(value(&wire, "springback.angle_deg")["value"], 3.5);
}

/// Who has typed a wrong dimension gets the one of before back, also where they no longer know what it was.
#[test]
fn a_value_or_the_last_change_is_taken_back() {
    let folder = tempfile::tempdir().unwrap();
    let run = |arguments: &[&str]| run_in(folder.path(), arguments, b"");
    let set = |values: &[&str]| {
        let source = ["--kind", "machine", "--source", "caliper", "--measured"];
        run(&[&["profile", "set", "mine", "--from", "wirebend-kit"], values, &source].concat()).ended(0)
    };
    set(&["bend.orbit_radius_mm=20.45"]);
    let file = "wirebend/machines/mine.json";
    let first = read(folder.path(), file);
    let refused = run(&["profile", "revert", "mine"]).ended(2).err;
    assert!(refused.contains("has not changed 'mine' since it was made"), "{refused}");
    set(&["bend.orbit_radius_mm=24.5", "bend.pin_radius_mm=1.6"]);
    let second = read(folder.path(), file);

    let said = run(&["profile", "revert", "mine"]).ended(0).err;
    assert!(said.contains("bend.orbit_radius_mm: 20.45 instead of 24.5"), "{said}");
    assert!(said.contains("bend.pin_radius_mm: 1.5 instead of 1.6"), "{said}");
    assert_eq!(read(folder.path(), file), first);
    run(&["profile", "revert", "mine"]).ended(0);
    assert_eq!(read(folder.path(), file), second, "a second revert makes the change again");

    let reverted = run(&["profile", "revert", "mine", "bend.orbit_radius_mm", "--json"]).ended(0).json();
    assert_fits("profile-revert", &reverted);
    let expected = serde_json::json!([{"key": "bend.orbit_radius_mm", "before": 24.5, "value": 20.4}]);
    assert_eq!(reverted["values"], expected);
    assert!(!read(folder.path(), file).contains("orbit_radius_mm"), "it is the parent's again");
    let refused = run(&["profile", "revert", "mine", "bend.orbit_radius_mm"]).ended(2).err;
    assert!(refused.contains("a key that the profile itself sets"), "{refused}");
    let shipped = run(&["profile", "revert", "wirebend-kit", "--kind", "machine"]).ended(2).err;
    assert!(shipped.contains("comes with the program"), "{shipped}");

    // What somebody has written by hand is not thrown away.
    let described = "\"mine\",\n  \"description\": \"by hand\",\n";
    let by_hand = read(folder.path(), file).replacen("\"mine\",\n", described, 1);
    std::fs::write(folder.path().join(file), &by_hand).unwrap();
    let refused = run(&["profile", "revert", "mine"]).ended(2).err;
    assert!(refused.contains("changed by something else"), "{refused}");
    assert_eq!(read(folder.path(), file), by_hand);
}
