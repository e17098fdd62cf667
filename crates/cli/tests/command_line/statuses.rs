//! Exit statuses, help, and how the program behaves between others.

use crate::{assert_fits, example, run, run_in, wirebend};

#[test]
fn statuses_tell_whose_turn_it_is() {
    let cube = example("cube-8-edges.obj");
    run(&["--help"]).ended(0);
    run(&["--version"]).ended(0);
    run(&["plan", &cube, "--machine", "wirebend-kit"]).ended(0);
    for wrong_use in [
        &["plan"][..],
        &["plan", &cube],
        &["plan", &cube, "--machine", "wirebend-kti"],
        &["plan", &cube, "--machine", "wirebend-kit", "--material", "cheese"],
        &["plan", &cube, "--machine", "wirebend-kit", "--scale", "0"],
        &["plan", &cube, "--machine", "wirebend-kit", "--weld", "-1"],
        &["plan", &cube, "--machine", "wirebend-kit", "--units", "parsec"],
        &["export", &cube, "--machine", "wirebend-kit", "--format", "gcode"],
        &["export", &cube, "--machine", "grbl-bender", "--format", "pensa-script"],
        &["driver"],
        &["driver", "trust"],
        &["bend", &cube],
    ] {
        let ran = run(wrong_use).ended(2);
        assert!(!ran.err.is_empty() && ran.out.is_empty(), "{wrong_use:?}");
    }
    run(&["plan", "nowhere.obj", "--machine", "wirebend-kit"]).ended(3);
    run(&["plan", &cube, "--machine", "wirebend-kit", "--start", "99"]).ended(3);
    run(&["plan", &example("cube.obj"), "--machine", "wirebend-kit"]).ended(4);
    run(&["check", &example("fold-back.obj"), "--machine", "wirebend-kit"]).ended(4);
    run(&["dump", "route", &example("cube.obj"), "--machine", "wirebend-kit"]).ended(4);
}

#[test]
fn a_misspelt_machine_is_guessed() {
    let said = run(&["plan", &example("cube.obj"), "--machine", "wirebend-kti"]).ended(2).err;
    assert!(said.contains("wirebend-kit"), "{said}");
    let said = run(&["plan", &example("cube.obj")]).ended(2).err;
    assert!(said.contains("pensa-diwire-pro"), "all machines are named: {said}");
}

#[test]
fn every_command_has_help_with_an_example() {
    let commands: &[&[&str]] = &[
        &["machines"],
        &["materials"],
        &["drivers"],
        &["driver", "check"],
        &["driver", "trust"],
        &["import"],
        &["check"],
        &["plan"],
        &["export"],
        &["simulate"],
        &["dump"],
        &["profile", "check"],
        &["profile", "new"],
        &["profile", "explain"],
        &["completions"],
        &["man"],
    ];
    for command in commands {
        let help = run(&[command, &["--help"][..]].concat()).ended(0);
        let text = String::from_utf8(help.out).unwrap();
        assert!(text.contains("Example"), "{command:?} has no example");
        assert!(text.contains(&format!("wirebend {}", command.join(" "))), "{command:?}");
    }
}

#[test]
fn shells_and_man_get_theirs() {
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let text = String::from_utf8(run(&["completions", shell]).ended(0).out).unwrap();
        assert!(text.contains("face-edges") && text.contains("simulate"), "{shell}");
    }
    let page = String::from_utf8(run(&["man"]).ended(0).out).unwrap();
    assert!(page.contains(".TH wirebend 1"), "{}", &page[..200]);
}

#[test]
fn a_pipe_carries_a_job_from_plan_to_simulate_and_sees_no_progress_bar() {
    let folder = tempfile::tempdir().unwrap();
    let cube = std::fs::read(example("cube-8-edges.obj")).unwrap();
    let plan = run_in(folder.path(), &["plan", "-", "--from", "obj", "-m", "wirebend-kit", "-o", "-"], &cube);
    let plan = plan.ended(0);
    let bent =
        run_in(folder.path(), &["simulate", "-", "--noise", "none", "--runs", "3", "--json"], &plan.out);
    assert_eq!(bent.ended(0).json()["runs"], 3);
    let text = run_in(folder.path(), &["export", "-"], &plan.out).ended(0);
    assert!(String::from_utf8(text.out).unwrap().contains("B 110.398\n"));
    assert!(plan.err.chars().all(|c| c == '\n' || !c.is_control()), "{:?}", plan.err);
}

#[test]
fn a_reader_that_has_enough_is_no_failure() {
    use std::process::{Command, Stdio};
    let mut child = Command::new(wirebend())
        .args(["dump", "wireframe", &example("isogrid.obj")])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    let done = child.wait_with_output().unwrap();
    assert_eq!(done.status.code(), Some(0), "{}", String::from_utf8_lossy(&done.stderr));
    for arguments in [&["--help"][..], &["plan", "--help"], &["--version"], &["man"]] {
        let (unread, output) = std::io::pipe().unwrap();
        drop(unread);
        let done = Command::new(wirebend()).args(arguments).stdout(output).output().unwrap();
        assert_eq!(done.status.code(), Some(0), "{arguments:?}: {}", String::from_utf8_lossy(&done.stderr));
    }
}

#[test]
fn own_profiles_are_used_and_broken_ones_said() {
    let folder = tempfile::tempdir().unwrap();
    let machines = folder.path().join("mine/machines");
    std::fs::create_dir_all(&machines).unwrap();
    let limit = r#"{"value": 80, "source": "my cable", "measured": true}"#;
    let child = format!(
        r#"{{"schema_version": 1, "kind": "machine", "id": "mine", "inherits": "wirebend-kit",
            "limits": {{"max_bend_deg": {limit}, "min_bend_deg": {{"value": -80, "source": "my cable", "measured": true}}}}}}"#
    );
    std::fs::write(machines.join("mine.json"), child).unwrap();
    std::fs::write(machines.join("broken.json"), "{\n  \"kind\": \"machine\",\n  \"colour\": 3\n}").unwrap();
    let cube = example("cube-8-edges.obj");
    let arguments = ["--profiles", "mine", "check", &cube, "--machine", "mine"];
    let said = run_in(folder.path(), &arguments, b"").ended(4).err;
    assert!(said.contains("bend_too_sharp") && said.contains("my cable"), "{said}");
    assert!(said.contains("broken.json") && said.contains("colour"), "{said}");
    let checked = run_in(folder.path(), &["profile", "check", "mine/machines/broken.json"], b"").ended(3);
    assert!(checked.err.contains("line 3") || checked.err.contains(":3"), "{}", checked.err);
}

#[test]
fn a_profile_that_no_command_could_use_is_refused_when_it_is_checked() {
    let folder = tempfile::tempdir().unwrap();
    let check = |child: &str| {
        let head = r#"{"schema_version": 1, "kind": "machine", "id": "mine", "inherits": "wirebend-kit","#;
        std::fs::write(folder.path().join("mine.json"), format!("{head}\n{child}}}")).unwrap();
        run_in(folder.path(), &["profile", "check", "mine.json"], b"").ended(3).err
    };
    let said = check(r#""bend": {"rod_radius_mm": {"value": 30, "source": "mine", "measured": true}}"#);
    assert!(said.contains("orbit_radius_mm") || said.contains("rod_radius_mm"), "{said}");
    let said = check(r#""export": {"formats": ["wirebend-kti-text"]}"#);
    assert!(said.contains("wirebend-kti-text") && said.contains("wirebend-kit-text"), "{said}");
}

#[test]
fn options_that_would_have_no_effect_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let run = |arguments: &[&str]| run_in(folder.path(), arguments, b"");
    run(&["import", &example("u-sample.obj"), "-o", "u.wirebend"]).ended(0);
    run(&["plan", "u.wirebend", "-m", "wirebend-kit", "-o", "u.wbjob"]).ended(0);
    run(&["plan", "u.wirebend", "-m", "wirebend-kit", "--scale", "10"]).ended(2);
    for options in [
        &["--material", "steel-3mm"][..],
        &["--start", "3"],
        &["--closed"],
        &["--scale", "2"],
        &["--from", "obj"],
    ] {
        run(&[&["export", "u.wbjob"], options].concat()).ended(2);
    }
    run(&["export", "u.wbjob", "--material", "aluminium-6061-t6-3mm"]).ended(0);
    run(&["simulate", "u.wbjob", "--svg", "-"]).ended(2);
    run(&["simulate", "u.wbjob", "--noise", "none", "--runs", "0"]).ended(2);
    run(&["simulate", "u.wbjob", "--seed", "4"]).ended(2);
    run(&["plan", "u.wirebend", "-m", "wirebend-kit", "--avoid-collisions", "--weights", "wires=1,wires=2"])
        .ended(2);
    run(&["simulate", "u.wirebend"]).ended(2);
    run(&["check", "u.wbjob", "-m", "wirebend-kit"]).ended(2);
    let said = run(&["frame", "u.wirebend", "--material", "steel-1mm", "--pieces", "3"]).ended(2).err;
    assert!(said.contains("--modes"), "{said}");
}

/// Whoever lets a file be replaced, or a job be written, believes that it is written.
#[test]
fn what_is_said_of_a_file_needs_one() {
    let folder = tempfile::tempdir().unwrap();
    let run = |arguments: &[&str]| run_in(folder.path(), arguments, b"");
    let cube = example("cube-8-edges.obj");
    run(&["plan", &cube, "-m", "wirebend-kit", "-o", "a.wbjob"]).ended(0);
    for (command, option) in [
        (&["import", &cube][..], "-o"),
        (&["generate", "truss", "--rings", "1", "--strut", "50"], "-o"),
        (&["plan", &cube, "-m", "wirebend-kit"], "-o"),
        (&["export", "a.wbjob"], "-o"),
        (&["profile", "export", "steel-1mm"], "-o"),
        (&["runs", "export", "3f2a"], "-o"),
        (&["simulate", "a.wbjob"], "--svg"),
        (&["frame", &cube, "--material", "steel-1mm"], "--vtk"),
        (&["sequence", &cube, "--machine", "framefab-extruder"], "--output"),
        (&["run", "a.wbjob"], "--record"),
        (&["jog", "-m", "wirebend-kit", "f", "1"], "--record"),
    ] {
        let said = run(&[command, &["--force"]].concat()).ended(2).err;
        assert!(said.contains(option), "{command:?}: {said}");
    }
    let said = run(&["plan", &cube, "-m", "wirebend-kit", "--despite-errors"]).ended(2).err;
    assert!(said.contains("-o"), "{said}");
}

#[test]
fn a_record_goes_to_a_file() {
    for command in ["run a.wbjob", "jog f 10 -m wirebend-kit"] {
        let words: Vec<&str> = command.split(' ').chain(["--yes", "--record", "-"]).collect();
        let refused = run(&words).ended(2).err;
        assert!(refused.contains("name one after --record"), "{refused}");
    }
}

#[test]
fn a_start_without_an_edge_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let lone = r#"{"format": "wirebend", "version": 1, "wireframe": {"next_vertex": 3, "next_edge": 1,
        "vertices": [{"id": 0, "at_mm": [0, 0, 0]}, {"id": 1, "at_mm": [60, 0, 0]}, {"id": 2, "at_mm": [0, 60, 0]}],
        "edges": [{"id": 0, "a": 0, "b": 1}]}}"#;
    std::fs::write(folder.path().join("lone.wirebend"), lone).unwrap();
    let arguments = ["plan", "lone.wirebend", "-m", "wirebend-kit", "--start", "2"];
    let said = run_in(folder.path(), &arguments, b"").ended(3).err;
    assert!(said.contains("vertex 2"), "{said}");
}

#[test]
fn accepted_doublings_are_kept_where_they_suffice_and_their_loss_is_said() {
    let folder = tempfile::tempdir().unwrap();
    let star = |accepted: &str| {
        format!(
            r#"{{"format": "wirebend", "version": 1, "wireframe": {{"next_vertex": 4, "next_edge": 3,
            "vertices": [{{"id": 0, "at_mm": [0, 0, 0]}}, {{"id": 1, "at_mm": [60, 0, 0]}},
                {{"id": 2, "at_mm": [0, 70, 0]}}, {{"id": 3, "at_mm": [0, 0, 80]}}],
            "edges": [{{"id": 0, "a": 0, "b": 1}}, {{"id": 1, "a": 0, "b": 2}}, {{"id": 2, "a": 0, "b": 3}}]}},
            "doublings": [{accepted}]}}"#
        )
    };
    let doubled = |accepted: &str| {
        std::fs::write(folder.path().join("star.wirebend"), star(accepted)).unwrap();
        let arguments = ["plan", "star.wirebend", "-m", "pensa-diwire-pro", "--double", "--json"];
        run_in(folder.path(), &arguments, b"").json()
    };
    let kept = doubled("2");
    assert_eq!(kept["route"]["doubled"], serde_json::json!([2]), "the person's choice, though dearer");
    assert_eq!(kept["route"]["optimal"], false);
    // One doubling is not enough for the cube: the cheapest three are used, and that is said.
    run_in(folder.path(), &["import", &example("cube.obj"), "-o", "cube.wirebend"], b"").ended(0);
    let path = folder.path().join("cube.wirebend");
    let document = std::fs::read_to_string(&path).unwrap();
    let end = document.rfind('}').unwrap();
    std::fs::write(&path, format!("{}, \"doublings\": [5]}}", document[..end].trim_end())).unwrap();
    let arguments = ["plan", "cube.wirebend", "-m", "wirebend-kit", "--double", "--json"];
    let replaced = run_in(folder.path(), &arguments, b"").json();
    assert_eq!(replaced["route"]["doubled_edges"], 3, "{replaced}");
    assert!(replaced["notes"].to_string().contains("doublings-replaced"), "{}", replaced["notes"]);
}

/// A script reads the standard output, whatever is wrong.
#[test]
fn wrong_arguments_are_an_object_too() {
    let house = example("house.obj");
    for (arguments, said) in [
        (&["plan", "--json"][..], "the following required arguments were not provided:\n  <WIREFRAME>"),
        (&["nonsense", "--json"], "unrecognized subcommand 'nonsense'"),
        (&["--json", "calibrate"], "a command is missing"),
        (&["--json", "plan", &house, "--colour", "red"], "unexpected argument '--colour' found"),
    ] {
        let ran = run(arguments).ended(2);
        let found = ran.json();
        assert_fits("error", &found);
        assert_eq!((&found["error"]["code"], &found["error"]["message"]), (&"usage".into(), &said.into()));
        assert_eq!(ran.err, "");
    }
    // What is asked for is no failure, and a name of a file is no option.
    assert!(run(&["--json", "--version"]).ended(0).out.starts_with(b"wirebend "));
    assert!(run(&["plan", "--", "--json", "x"]).ended(2).err.starts_with("error: unexpected argument"));
}

/// It was taken for an option, with a hint that does not help.
#[test]
fn a_number_below_zero_is_the_value_of_its_option() {
    let house = example("house.obj");
    let ran = run(&["plan", &house, "--machine", "wirebend-kit", "--scale", "-1"]).ended(2);
    assert!(ran.err.starts_with("error: scale is -1, expected a number above 0"), "{}", ran.err);
}
