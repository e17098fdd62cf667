//! What acts on the open design as a frame, what is written of it, and what is asked of trusses and wires besides.

use wirebend_tests_brute::{Step, Task};

use super::*;

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("no number: {value}"))
}

/// A beam along x, 100 mm long, clamped where it begins.
fn cantilever(window: &Window) {
    let beam = window.file("beam.obj", b"v 0 0 0\nv 100 0 0\nl 1 2\n");
    window.ask("open", file(&beam));
    window.ask("edit", json!({"request": {"edit": "support", "vertices": [0], "support": true}}));
}

const UNITS: &str = r#""force_unit": "kN", "moment": [0, 0, 0], "moment_unit": "kN m""#;

/// Forces of a person and of a file act together: the tip of a cantilever goes down by F L³/(3 E I), as textbooks have it.
#[test]
fn forces_bend_a_beam_as_textbooks_have_it() {
    let window = Window::new();
    cantilever(&window);
    // ABS: E 3457 MPa, diameter 1.5 mm.
    let bends_mm = |force_n: f64| {
        let inertia = std::f64::consts::PI * 1.5_f64.powi(4) / 64.0;
        force_n * 100.0_f64.powi(3) / (3.0 * 3457.0 * inertia)
    };
    let moved = |asked: &Value| {
        number(&window.ask("frame", asked.clone())["result"]["static"]["max_displacement_mm"])
    };
    let mut asked = json!({"material": "abs-1-5mm", "gravity": [0, 0, 0], "supports": {"vertices": [0]}});
    asked["forces"] = json!([{"vertex": 1, "force_n": [0, 0, -0.01]}]);
    assert!((moved(&asked) / bends_mm(0.01) - 1.0).abs() < 1e-6, "{}", moved(&asked));

    let case = |kilonewton: f64| {
        format!(r#"{{"ploads": [{{"node_ind": 1, "force": [0, 0, {kilonewton}], {UNITS}}}]}}"#)
    };
    let text = format!(r#"{{"loadcases": {{"light": {}, "heavy": {}}}}}"#, case(-0.00001), case(-0.00002));
    let loads = window.file("loads.json", text.as_bytes());
    let cases = window.ask("load-cases", json!({"file": {"file": loads}}));
    let names: Vec<&str> =
        cases["cases"].as_array().unwrap().iter().map(|case| case["name"].as_str().unwrap()).collect();
    assert_eq!(names, ["heavy", "light"]);
    assert!((number(&cases["cases"][0]["forces"][0]["force_n"][2]) + 0.02).abs() < 1e-12);

    asked["loads"] = json!({"file": {"file": loads}, "case": "heavy"});
    assert!((moved(&asked) / bends_mm(0.03) - 1.0).abs() < 1e-6, "{}", moved(&asked));
    asked["loads"]["case"] = json!("none");
    assert_eq!(window.try_ask("frame", asked).unwrap_err().code, "load-case");
}

/// What acts on nothing is refused by name, and so is a file that is none.
#[test]
fn loads_that_act_on_nothing_are_refused() {
    let window = Window::new();
    cantilever(&window);
    let with = |force: &Value| {
        window.try_ask("frame", json!({"material": "abs-1-5mm", "forces": [force]})).unwrap_err()
    };
    let none = with(&json!({"vertex": 7, "force_n": [0, 0, 1]}));
    assert!(none.message.contains('7'), "{}", none.message);
    let paste = json!({"edit": "paste", "vertices": [{"at_mm": [0, 50, 0]}], "edges": []});
    window.ask("edit", json!({"request": paste}));
    let loose = with(&json!({"vertex": 2, "force_n": [0, 0, 1]}));
    assert!(loose.message.contains("vertex 2, at which no strut ends"), "{}", loose.message);
    let wrong = window.file("wrong.json", b"[1, 2]");
    let refusal = window.try_ask("load-cases", json!({"file": {"file": wrong}})).unwrap_err();
    assert!(refusal.message.contains("wrong.json"), "{}", refusal.message);
}

/// What is shown is what is written; a file that is there stays unless a person says so, and a frame that floats writes none.
#[test]
fn a_loaded_frame_is_written_for_other_programs() {
    let window = Window::new();
    cantilever(&window);
    let path = |name: &str| window.home.path().join(name);
    let frame = json!({"material": "abs-1-5mm", "modes": 3});
    let files = json!({
        "vtk": {"path": path("f.vtk")}, "csv": {"path": path("f.csv")}, "glb": {"path": path("f.glb")},
        "displacement_scale": 20,
    });
    let asked = json!({"frame": frame, "files": files});
    let saved = window.ask("save-frame", asked.clone());
    let names = ["f.vtk", "f-nodes.csv", "f-members.csv", "f.glb"];
    assert_eq!(saved["files"], json!(names.map(path)));
    assert!(names.iter().all(|name| path(name).metadata().unwrap().len() > 0));
    assert_eq!(window.try_ask("save-frame", asked).unwrap_err().code, "exists");

    let floats = json!({"frame": {"supports": "free", "material": "abs-1-5mm"}, "files": {"vtk": {"path": path("g.vtk")}}});
    let saved = window.ask("save-frame", floats);
    assert_eq!(saved["files"], json!([]));
    assert!(saved["notes"].as_array().unwrap().iter().any(|note| note["code"] == "not-written"));
}

/// A person who stops a long computation is told so, and the next one is computed.
#[test]
fn computing_a_frame_is_stopped() {
    let window = Window::new();
    window.ask("open-example", json!({"id": "truss"}));
    let close = json!({"errors": "bend-forming", "runs": 1_000_000, "seed": 1});
    let asked = json!({"material": "steel-0-9mm", "supports": "free", "close": close, "double": true});
    std::thread::scope(|scope| {
        let computing = scope.spawn(|| window.try_ask("frame", asked).unwrap_err());
        while !computing.is_finished() {
            window.ask("stop-frame", json!({}));
            std::thread::yield_now();
        }
        assert_eq!(computing.join().unwrap().code, "stopped");
    });
    assert_eq!(window.ask("stop-frame", json!({})), json!({}));
    window.ask("frame", json!({"material": "steel-0-9mm", "supports": "free", "modes": 1}));
}

/// Faces come from a file, for the closed frame and for the tolerance; a face that cannot be off is refused.
#[test]
fn faces_are_those_of_a_file_or_of_a_selection() {
    let window = Window::new();
    window.ask("open-example", json!({"id": "truss"}));
    let close = |faces: Value| {
        let close = json!({"errors": "bend-forming", "runs": 3, "seed": 1, "faces": faces});
        json!({"material": "steel-0-9mm", "supports": "free", "close": close, "double": true})
    };
    let surface = |asked: Value| number(&window.ask("frame", asked)["result"]["closing"]["surface_rms_mm"]);
    let faces = window.file("faces.json", b"[[0, 1, 2, 3, 4, 5]]");
    let of_file = surface(close(json!({"input": {"file": faces}})));
    assert!((of_file - surface(close(Value::Null))).abs() > 1e-9);
    let selected = surface(close(json!({"vertices": [[5, 4, 3, 2, 1, 0]]})));
    assert!((selected / of_file - 1.0).abs() < 1e-12, "{selected} {of_file}");
    let tolerance = json!({
        "material": "steel-0-9mm", "required": {"surface_mm": 0.1}, "double": true, "faces": {"input": {"file": faces}},
    });
    assert_eq!(window.ask("tolerance", tolerance)["governed_by"], "surface");
    let three = window.file("three.json", b"[[0, 1, 2]]");
    let refusal = window.try_ask("frame", close(json!({"input": {"file": three}}))).unwrap_err();
    assert!(refusal.message.contains("three.json"), "{}", refusal.message);
    let refusal =
        window.try_ask("frame", close(json!({"vertices": [[0, 1, 2, 3], [0, 1, 1, 2]]}))).unwrap_err();
    let says = "what was selected is no list of faces: face 2 has 3 different vertices of 4";
    assert!(refusal.message.starts_with(says), "{}", refusal.message);
}

/// A truss that is too large to solve: 8.40 µm for 1 mm of surface by Bend-Forming's formulas, of a depth of 50 mm and 50 m across.
#[test]
fn a_large_truss_has_its_tolerance_without_a_design() {
    let window = Window::new();
    let truss = json!({"rings": 408, "depth_mm": 50, "diameter_mm": 50_000});
    let asked =
        |required: Value| json!({"material": "steel-0-9mm", "required": required, "continuum": truss});
    let found = window.ask("tolerance", asked(json!({"surface_mm": 1})));
    assert!((number(&found["feed_sigma_mm"]) / 8.40e-3 - 1.0).abs() < 1e-2, "{found}");
    assert_eq!(found["achieved"]["stress_mpa"], Value::Null);
    assert_eq!(
        window.try_ask("tolerance", asked(json!({"stress_mpa": 1}))).unwrap_err().code,
        "only-lengths"
    );
}

/// The struts of a wire are placed at once, along the walks that were chosen; without walks it is refused. Moved, a wire is
/// fastened wherever it meets what stands.
#[test]
fn wires_are_placed_as_a_whole() {
    let window = Window::new();
    window.ask("open", file(&example("four-frame.json")));
    let asked = json!({"machine": "framefab-extruder", "material": "abs-1-5mm", "group_by": "wire"});
    assert_eq!(window.try_ask("sequence", asked.clone()).unwrap_err().code, "no-walks");
    let walks = json!([{"start": 0, "edges": [0, 2]}, {"start": 1, "edges": [1, 3]}]);
    window.ask("edit", json!({"request": {"edit": "walks", "walks": walks}}));
    let found = window.ask("sequence", asked.clone());
    let steps = found["sequence"]["steps"].as_array().unwrap();
    assert_eq!(steps.len(), 2, "{found}");
    let saved = window.home.path().join("wires.wirebend");
    window.ask("save", json!({"path": saved}));
    let task = Task::framefab(&serde_json::from_slice(&std::fs::read(saved).unwrap()).unwrap());
    assert_eq!(task.faults(&Step::printed(&found["sequence"])), []);
    for (step, head) in steps.iter().zip(found["moves"].as_array().unwrap()) {
        assert_eq!(step["edges"].as_array().unwrap().len(), 2);
        assert_eq!(head["from_mm"], head["to_mm"], "the head stands where it fastens a wire");
    }
    let step = |step: &Value| {
        let keys = ["edge", "edges", "from_vertex", "direction"];
        Value::Object(keys.iter().map(|key| ((*key).to_owned(), step[key].clone())).collect())
    };
    let order: Vec<Value> = steps.iter().map(step).collect();
    let mut same = asked;
    same["order"] = order.into();
    let checked = window.ask("sequence", same);
    assert_eq!(checked["sequence"]["feasible"], true, "{checked}");
}
