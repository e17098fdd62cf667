//! Files that are open to be run, in place of the design.

use wirebend_api::ErrorRemedy;

use super::*;

/// What a file holds would be compensated, or the design run in its place, without a word.
#[test]
fn a_job_a_program_and_a_recording_are_shown_and_run_as_they_are() {
    let window = Window::new();
    window.ask("open-example", json!({"id": "house"}));
    let designed = window.ask("program", json!({}))["job_hash"].clone();
    let job = window.home.path().join("house.wbjob");
    window.ask("save-job", json!({"output": {"path": job, "force": false}}));
    window.ask("new", json!({"machine": "wirebend-kit"}));
    let open = |path: &Path| window.ask("open-run-file", json!({"file": {"file": path}}))["file"].clone();
    let figures = |told: &Value| {
        let steps = told["steps"].as_array().unwrap().iter();
        steps.map(|step| step["told"].clone()).collect::<Vec<_>>()
    };

    let file = open(&job);
    assert_eq!(
        (&file["kind"], &file["job_hash"], &file["feasible"]),
        (&json!("job"), &designed, &json!(true))
    );
    assert_eq!(window.ask("program", json!({}))["job_hash"], designed);
    assert_eq!(window.ask("made", json!({}))["by_machine"], json!(true));

    let text = window.file("two.txt", b"F 40\nB 60.5\nF 35\n");
    assert_eq!(window.ask("look", super::file(&text))["runs"], json!(true));
    let file = open(&text);
    assert_eq!((&file["kind"], &file["feasible"]), (&json!("program"), &json!(true)));
    let program = window.ask("program", json!({}));
    let told = figures(&program["wires"][0]);
    assert_eq!(told[0], json!({"feed_mm": 40.0, "rotate_deg": 0.0, "bend_deg": 60.5}), "not compensated");
    window.connect();
    window.order(&json!({"order": "arm", "wire": 0}));
    let asked = window.until(|state| state["question"].is_object())["question"].clone();
    assert!(asked["lines"].to_string().contains("two.txt runs as it stands"), "{asked}");
    window.yes();
    window.until_phase("armed");
    window.order(&json!({"order": "start"}));
    let over = window.until(|state| state["busy"] == false && state["wire"]["made"] == 2);
    assert_eq!(
        over["wire"]["job_hash"], program["job_hash"],
        "the steps light up in the program that is shown"
    );

    // What the machine cannot make is refused unless a person wants it.
    let bad = open(&window.file("bad.txt", b"F 10\nB 45\nF 30\n"));
    assert_eq!(bad["feasible"], json!(false));
    assert_eq!(bad["findings"][0]["severity"], json!("error"));
    let refused = window.try_ask("order", json!({"request": {"order": "arm", "wire": 0}})).unwrap_err();
    assert_eq!(serde_json::to_value(&refused).unwrap()["code"], json!("not-feasible"));

    let moves = json!({"format": "wbmoves", "version": 1, "machine": "wirebend-kit", "profile_hash": "0".repeat(64),
        "moves": [{"move": "home"}, {"move": "feed", "mm": 40.0}, {"move": "bend", "deg": 45.0}, {"move": "feed", "mm": 30.0}]});
    let moves = window.file("corner.wbmoves", moves.to_string().as_bytes());
    assert_eq!(window.ask("look", super::file(&moves))["seen"], json!("moves"));
    let file = open(&moves);
    assert_eq!((&file["kind"], &file["moves"]), (&json!("moves"), &json!(4)));
    let program = window.ask("program", json!({}));
    assert_eq!(program["job_hash"], json!(null), "no wire of a job is one of it");
    assert_eq!(figures(&program["wires"][0]).len(), 2);
    assert!(window.try_ask("order", json!({"request": {"order": "arm", "wire": 0}})).is_err());
    // It becomes a design, and then it is the design that is run.
    let opened = window.ask("open", super::file(&moves));
    assert_eq!(opened["design"]["edges"].as_array().unwrap().len(), 2);
    assert_eq!(window.ask("run-file", json!({}))["file"], json!(null));
}

/// Another program writes the file anew while it is open: a person would be told of a profile that nobody has changed, or run what they
/// have not seen.
#[test]
fn a_file_that_has_changed_on_the_disk_is_read_again_before_anything_of_it_moves() {
    let window = Window::new();
    window.ask("new", json!({"machine": "wirebend-kit"}));
    let moves = |hash: &str, mm: f64| {
        json!({"format": "wbmoves", "version": 1, "machine": "wirebend-kit", "profile_hash": hash.repeat(64),
            "moves": [{"move": "home"}, {"move": "feed", "mm": mm}]})
        .to_string()
    };
    let text = window.file("two.txt", b"F 40\nB 60.5\nF 35\n");
    let recording = window.file("feed.wbmoves", moves("0", 40.0).as_bytes());
    window.connect();
    let orders = |path: &Path| match path.extension() {
        Some(extension) if extension == "txt" => {
            vec![json!({"order": "arm", "wire": 0}), json!({"order": "dry-run", "wire": 0})]
        }
        _ => vec![json!({"order": "replay", "file": path, "other_machine": true})],
    };
    for (path, other) in [(&text, "F 45\nB 60.5\nF 35\n".to_owned()), (&recording, moves("1", 45.0))] {
        window.ask("open-run-file", json!({"file": {"file": path}}));
        std::fs::write(path, other).unwrap();
        for order in orders(path) {
            let refusal = window.try_ask("order", json!({"request": order})).unwrap_err();
            assert_eq!(refusal.code, "file-changed", "{order}: {}", refusal.message);
            assert!(
                refusal.message.contains(path.file_name().unwrap().to_str().unwrap()),
                "{}",
                refusal.message
            );
            assert_eq!(refusal.remedies, [ErrorRemedy::ReadAgain]);
        }
        window.ask("open-run-file", json!({"file": {"file": path}}));
        window.order(&orders(path)[0]);
        let id = window.until(|state| state["question"].is_object())["question"]["id"].clone();
        window.ask("answer", json!({"question": id, "answer": "no"}));
        window.until(|state| state["busy"] == false);
    }
    // What is gone is not another file: what was read of it is what was looked at.
    window.ask("open-run-file", json!({"file": {"file": text}}));
    std::fs::remove_file(&text).unwrap();
    window.order(&json!({"order": "arm", "wire": 0}));
    window.yes();
    window.until_phase("armed");
}

/// A program would keep findings and times of a machine that is no longer so; a file that others have written meanwhile would take its
/// place without a word.
#[test]
fn what_is_open_to_be_run_is_checked_with_a_changed_profile_as_it_was_read() {
    let window = Window::new();
    window.ask(
        "copy-profile",
        json!({"kind": "machine", "from": "wirebend-kit", "id": "mine", "name": "Mine"}),
    );
    window.ask("new", json!({"machine": "mine"}));
    assert_eq!(window.ask("check-run-file", json!({}))["file"], json!(null), "none is open");
    let most = |deg: f64| {
        let values = [
            json!({"key": "limits.max_bend_deg", "value": deg}),
            json!({"key": "limits.min_bend_deg", "value": -deg}),
        ];
        window.ask(
            "set-profile",
            json!({"kind": "machine", "id": "mine", "values": values, "source": "me", "measured": true}),
        );
        window.ask("check-run-file", json!({}))["file"].clone()
    };
    let text = window.file("two.txt", b"F 40\nB 60.5\nF 35\n");
    for file in
        [json!({"file": text}), json!({"bytes": {"name": "two.txt", "bytes": b"F 40\nB 60.5\nF 35\n"}})]
    {
        let opened = window.ask("open-run-file", json!({"file": file}))["file"].clone();
        // The design behind it has another machine by now.
        window.ask(
            "edit",
            json!({"request": {"edit": "machine", "machine": "wirebend-kit", "material": null}}),
        );
        let refused = most(30.0);
        assert_eq!(
            [&refused["feasible"], &refused["findings"][0]["severity"]],
            [&json!(false), &json!("error")]
        );
        let allowed = most(90.0);
        for figure in ["path", "name", "kind", "machine", "wires", "feasible", "findings", "notes"] {
            assert_eq!(allowed[figure], opened[figure], "{figure}");
        }
        window.ask("undo", json!({}));
    }
    window.ask("open-run-file", json!({"file": {"file": text}}));
    std::fs::write(&text, "F 45\nB 60.5\nF 35\n").unwrap();
    assert_eq!(most(91.0)["wires"][0]["length_mm"], json!(75.0), "what a person has looked at");
    window.connect();
    let refusal = window.try_ask("order", json!({"request": {"order": "arm", "wire": 0}})).unwrap_err();
    assert_eq!(refusal.code, "file-changed");
}

/// The numbers of another machine's program mean something else.
#[test]
fn a_program_of_another_machine_is_not_run() {
    let window = Window::new();
    window.ask("new", json!({"machine": "grbl-bender"}));
    let text = window.file("two.txt", b"F 40\nB 60.5\nF 35\n");
    assert_eq!(window.ask("look", super::file(&text))["runs"], json!(false));
    let refused = window.try_ask("open-run-file", json!({"file": {"file": text}})).unwrap_err();
    assert_eq!(serde_json::to_value(&refused).unwrap()["code"], json!("format-of-another"));
}
