//! Machines, programs and exports of the open design.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD as BASE64;

use super::*;

/// What is played is the design: each corner is a vertex, and the time is the plan's.
#[test]
fn the_program_that_is_played_is_that_of_the_plan() {
    let window = Window::new();
    window.ask("open-example", json!({"id": "house"}));
    let program = window.ask("program", json!({}));
    let wire = &program["wires"][0];
    let steps = wire["steps"].as_array().unwrap();
    assert_eq!(wire["corners_mm"].as_array().unwrap().len(), steps.len() + 1);
    let total: f64 =
        steps.iter().flat_map(|step| step["seconds"].as_array().unwrap()).map(|s| s.as_f64().unwrap()).sum();
    assert!((total - wire["time_s"].as_f64().unwrap()).abs() < 1e-9);
    let check = window.ask("check", json!({}));
    assert_eq!(check["wires"][0]["time_s"], wire["time_s"]);
    // Feeds as designed are the distances from corner to corner.
    let corner = |k: usize| -> [f64; 3] { serde_json::from_value(wire["corners_mm"][k].clone()).unwrap() };
    for (k, step) in steps.iter().enumerate() {
        let [a, b] = [corner(k), corner(k + 1)];
        let distance = (0..3).map(|i| (a[i] - b[i]).powi(2)).sum::<f64>().sqrt();
        assert!((distance - step["designed"]["feed_mm"].as_f64().unwrap()).abs() < 1e-9, "step {k}");
    }
}

/// A window that is given no poses, or other ones than its wire has corners, draws a machine without a wire.
#[test]
fn a_wire_is_laid_on_its_machine_step_by_step() {
    let window = Window::new();
    window.ask("open-example", json!({"id": "house"}));
    let wire = window.ask("program", json!({}))["wires"][0].clone();
    let made = window.ask("made", json!({}))["wires"][0].clone();
    let steps = wire["steps"].as_array().unwrap();
    let poses = steps.iter().map(|step| &step["pose"]).chain(made["poses"].as_array().unwrap());
    for pose in poses.clone() {
        let turn: [f64; 4] = serde_json::from_value(pose["turn"].clone()).unwrap();
        let axis: [f64; 3] = serde_json::from_value(pose["bend_axis"].clone()).unwrap();
        for size in [turn.iter().map(|x| x * x).sum::<f64>(), axis.iter().map(|x| x * x).sum::<f64>()] {
            assert!((size - 1.0).abs() < 1e-9, "{pose}");
        }
    }
    assert_eq!(poses.count(), 2 * steps.len());
    let mut head = json!(0.0);
    for step in steps {
        let moments = step["moments"].as_array().unwrap();
        let (begin, end) = (moments.first().unwrap(), moments.last().unwrap());
        assert_eq!((&begin["at"], &end["at"], &begin["head_deg"]), (&json!(0.0), &json!(1.0), &head));
        assert_eq!(
            (&end["fed"], &end["bent"], &end["bend_axis_deg"]),
            (&json!(1.0), &json!(1.0), &json!(0.0))
        );
        // The axis goes as far as is sent to the machine.
        let farthest = moments.iter().max_by(|a, b| axis_of(a).total_cmp(&axis_of(b))).unwrap();
        assert_eq!(farthest["bend_axis_deg"], step["told"]["bend_deg"]);
        head = end["head_deg"].clone();
    }
}

fn axis_of(moment: &Value) -> f64 {
    moment["bend_axis_deg"].as_f64().unwrap().abs()
}

/// "As made" is the simulated machine's wire: compensated, it is nearer to the design than a wire's thickness.
#[test]
fn a_wire_is_shown_as_the_simulated_machine_makes_it() {
    let window = Window::new();
    window.ask("open-example", json!({"id": "house"}));
    let made = window.ask("made", json!({}));
    assert_eq!(made["by_machine"], true, "{}", made["notes"]);
    let wire = &made["wires"][0];
    assert!(wire["worst_mm"].as_f64().unwrap() < 3.0, "{}", wire["worst_mm"]);
    assert!(!wire["wire_mm"].as_array().unwrap().is_empty());
    let program = window.ask("program", json!({}));
    assert_eq!(
        wire["corners_mm"].as_array().unwrap().len(),
        program["wires"][0]["corners_mm"].as_array().unwrap().len()
    );
    assert!(
        window
            .told
            .0
            .lock()
            .unwrap()
            .iter()
            .any(|tell| tell["value"]["stage"] == "bending on the simulated machine")
    );
}

/// What a person exports is compensated for the machine that they have chosen; the preview is the file.
#[test]
fn a_preview_is_the_beginning_of_the_file() {
    let window = Window::new();
    window.ask("open-example", json!({"id": "house"}));
    let formats = window.ask("exports", json!({}))["formats"].clone();
    let ids: Vec<&str> =
        formats.as_array().unwrap().iter().map(|format| format["id"].as_str().unwrap()).collect();
    assert_eq!(ids[0], "wirebend-kit-text");
    assert!(ids.contains(&"job-sheet") && ids.contains(&"ybc-csv"), "{ids:?}");
    // A Pensa's script has a Pensa's angles.
    assert!(!ids.contains(&"pensa-script"), "{ids:?}");
    for id in ids {
        let shown = window.ask("export", json!({"format": id}));
        let path = window.home.path().join(format!("house.{id}"));
        let written = window.ask("export", json!({"format": id, "output": {"path": path}}));
        assert_eq!(written["files"], json!([path]), "{id}");
        let bytes = std::fs::read(&path).unwrap();
        // What is looked at before it is saved is the file.
        assert_eq!(shown["contents"], json!([]), "{id}");
        let seen = window.ask("export", json!({"format": id, "contents": true}))["contents"][0].clone();
        assert!(BASE64.decode(seen.as_str().unwrap()).unwrap() == bytes, "{id}");
        if let Some(beginning) = shown["beginnings"][0].as_str() {
            let text = String::from_utf8(bytes).unwrap().replace("\r\n", "\n");
            assert!(text.starts_with(beginning), "{id}");
        } else {
            assert!(["png", "gltf", "job-sheet", "template-pdf"].contains(&id), "{id}");
        }
        // A file that is there is not replaced by itself.
        assert_eq!(
            window.try_ask("export", json!({"format": id, "output": {"path": path}})).unwrap_err().code,
            "exists"
        );
    }
}

/// What cannot be made is not written for a machine, and its reasons come with the refusal.
#[test]
fn a_job_of_what_cannot_be_made_is_refused_with_the_reasons() {
    let window = Window::new();
    window.ask("open-example", json!({"id": "bunny"}));
    let path = window.home.path().join("bunny.wbjob");
    let refusal = window.try_ask("save-job", json!({"output": {"path": path}})).unwrap_err();
    assert!(
        refusal.diagnostics.iter().any(|diagnostic| diagnostic.code.as_str() == "no_euler_path"),
        "{refusal:?}"
    );
    assert!(!path.exists());
    window.ask("open-example", json!({"id": "house"}));
    assert_eq!(
        window.ask("save-job", json!({"output": {"path": path}}))["job_hash"].as_str().unwrap().len(),
        64
    );
    // It is run, not edited.
    assert_eq!(window.ask("look", file(&path))["seen"], "job");
    assert_eq!(window.try_ask("open", file(&path)).unwrap_err().code, "is-a-job");
}

/// A shipped profile stays as it is; a copy is a person's own, and its settings are written with their source.
#[test]
fn a_machine_is_copied_and_then_set() {
    let window = Window::new();
    let view = window.ask("machine-view", json!({"machine": "wirebend-kit"}));
    assert_eq!((&view["shipped"], &view["driver_problem"]), (&json!(true), &json!(null)));
    assert!(view["shapes"].as_array().unwrap().iter().any(|shape| shape["part"] == "peg"));
    // The peg goes about the centre of its orbit, s = 12 mm along the wire.
    assert_eq!(view["pivot_mm"], json!([12.0, 0.0, 0.0]));
    // Its rod is 26 mm long about z = -4.
    assert_eq!(view["peg_top_mm"], json!(9.0));
    let key = view["settings"][0]["key"].as_str().unwrap().to_owned();
    let value = view["settings"][0]["value"].clone();
    let set = json!({"machine": "wirebend-kit", "settings": {key.clone(): value}});
    assert_eq!(window.try_ask("change-settings", set).unwrap_err().code, "shipped-profile");

    window.ask(
        "copy-profile",
        json!({"kind": "machine", "from": "wirebend-kit", "id": "mine", "name": "Mine"}),
    );
    let mine = window.ask("machine-view", json!({"machine": "mine"}));
    assert_eq!((&mine["shipped"], &mine["inherits"]), (&json!(false), &json!("wirebend-kit")));
    let changed = window.ask("change-settings", json!({"machine": "mine", "settings": {key.clone(): value}}));
    let setting =
        changed["machine"]["settings"].as_array().unwrap().iter().find(|s| s["key"] == key.as_str()).cloned();
    assert_eq!(setting.unwrap()["set_by"], "mine");
    let before = std::fs::read(changed["file"].as_str().unwrap()).unwrap();
    let refusal = window
        .try_ask("change-settings", json!({"machine": "mine", "settings": {"no_such": 1}}))
        .unwrap_err();
    assert!(refusal.message.contains("no_such"), "{}", refusal.message);
    assert_eq!(std::fs::read(changed["file"].as_str().unwrap()).unwrap(), before);
    // Taken out again, it is the driver's default.
    let back = window.ask("change-settings", json!({"machine": "mine", "settings": {}}));
    let setting =
        back["machine"]["settings"].as_array().unwrap().iter().find(|s| s["key"] == key.as_str()).cloned();
    assert_eq!(setting.unwrap()["set_by"], json!(null));
}

/// Another machine is chosen with its own wire in it, and what changes is known before.
#[test]
fn a_machine_is_compared_before_it_is_chosen() {
    let window = Window::new();
    window.ask("open-example", json!({"id": "house"}));
    let compared = window.ask("compare", json!({"against": ["pensa-diwire-pro"]}));
    assert_eq!(compared["from"]["machine"], "wirebend-kit");
    assert!(compared["to"][0]["change"]["time_s"].is_number());
    let edit = json!({"request": {"edit": "machine", "machine": "pensa-diwire-pro", "material": null}});
    let changed = window.ask("edit", edit);
    assert_eq!(changed["change"]["state"]["machine"], "pensa-diwire-pro");
    assert_eq!(changed["change"]["state"]["undo"], "machine");
    // The next start begins with it.
    let Window { home, .. } = window;
    let state = Window::at(home).ask("start", json!({}))["design"]["state"].clone();
    assert_eq!(state["machine"], "pensa-diwire-pro");
}

/// A card that names a shorter edge than the checks ask for sends a person into an error.
#[test]
fn the_edge_beside_a_bend_that_a_machine_names_is_the_shortest_that_the_checks_take() {
    let window = Window::new();
    window.ask("new", json!({}));
    let view = window.ask("machine-view", json!({"machine": "wirebend-kit"}));
    let between = view["min_edge_between_mm"].as_f64().unwrap();
    assert!(between > view["min_edge_mm"].as_f64().unwrap() + 1.0, "{between}");
    for (edge, fits) in [(between + 0.01, true), (between - 0.01, false)] {
        // A flat U: whichever way it runs, its last edge gives a part of itself to the bend before it.
        let through = json!([[0, edge, 0], [0, 0, 0], [100, 0, 0], [100, edge, 0]]);
        window.ask("new", json!({}));
        window.ask(
            "edit",
            json!({"request": {"edit": "draw", "from": null, "through_mm": through, "to": null}}),
        );
        let check = window.ask("check", json!({"moved": []}));
        assert_eq!(check["feasible"], json!(fits), "{edge}: {check}");
    }
}
