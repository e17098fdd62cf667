//! Exit statuses, help, and how the program behaves between others.

use crate::{example, run, run_in};

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
        &["export", &cube, "--machine", "grbl-bender"],
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
fn the_own_format_of_a_machine_without_its_driver_is_not_replaced_in_silence() {
    let said = run(&["export", &example("house.obj"), "--machine", "howtomechatronics"]).ended(2).err;
    assert!(said.contains("howtomechatronics-serial") && said.contains("lra-csv"), "{said}");
}

#[test]
fn every_command_has_help_with_an_example() {
    let commands: &[&[&str]] = &[
        &["machines"],
        &["materials"],
        &["import"],
        &["check"],
        &["plan"],
        &["export"],
        &["simulate"],
        &["dump"],
        &["profile", "check"],
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
    let mut child = Command::new(env!("CARGO_BIN_EXE_wirebend"))
        .args(["dump", "wireframe", &example("isogrid.obj")])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    let done = child.wait_with_output().unwrap();
    assert_eq!(done.status.code(), Some(0), "{}", String::from_utf8_lossy(&done.stderr));
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
