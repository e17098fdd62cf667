//! The open design as a frame, and the order in which its struts are built.

use wirebend_tests_brute::{Step, Task};

use super::*;

fn opened(name: &str, units: Option<&str>) -> Window {
    let window = Window::new();
    let mut asked = file(&example(name));
    asked["design"]["units"] = json!(units);
    window.ask("open", asked);
    window
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("no number: {value}"))
}

/// How far a point has moved.
fn moved(by: &Value) -> f64 {
    by.as_array().unwrap().iter().map(number).map(|part| part * part).sum::<f64>().sqrt()
}

/// What is drawn is what the table says: the farthest vertex is as far from the drawing as its figure. OpenSees, `PyNite` and pyconmech
/// give 0.427187 mm for this frame, with a gravity of 9.80633 m/s².
#[test]
fn a_frame_is_drawn_as_its_figures_say() {
    let window = opened("bunny-frame.pwf", Some("mm"));
    let shown = window.ask("frame", json!({"material": "abs-1-5mm", "modes": 2}));
    let (result, shapes) = (&shown["result"], &shown["shapes"]);
    let sag_mm = number(&result["static"]["max_displacement_mm"]);
    assert!((sag_mm - 0.427_187 * 9.806_65 / 9.806_33).abs() < 1e-5, "{sag_mm}");
    let (struts, loaded) = (shapes["struts"].as_array().unwrap(), shapes["loaded"].as_array().unwrap());
    assert_eq!((struts.len(), loaded.len()), (179, 179));
    let ends = loaded.iter().flat_map(|strut| [&strut[0], &strut[8]]);
    let farthest = ends.map(moved).fold(0.0, f64::max);
    assert!((farthest - sag_mm).abs() < 1e-9, "{farthest}");
    for mode in shapes["modes"].as_array().unwrap() {
        let points = mode.as_array().unwrap().iter().flat_map(|strut| strut.as_array().unwrap());
        let most = points.map(moved).fold(0.0, f64::max);
        assert!((most - 1.0).abs() < 1e-9, "a mode has no size of its own: {most}");
    }
}

/// Chosen supports hold, none lets it float, and one that is not there is refused by name.
#[test]
fn a_frame_is_held_where_a_person_says() {
    let window = Window::new();
    window.ask("open-example", json!({"id": "house"}));
    let held = window.ask("frame", json!({"supports": {"vertices": [0, 1]}}));
    assert_eq!(held["result"]["frame"]["supports"], 2);
    assert!(held["shapes"]["loaded"].is_array());
    let free = window.ask("frame", json!({"supports": "free", "modes": 1}));
    assert!(free["shapes"]["loaded"].is_null());
    assert_eq!(free["shapes"]["modes"].as_array().unwrap().len(), 7, "six of them are rigid");
    let none = window.ask("frame", json!({}));
    assert_eq!(none["result"]["diagnostics"][0]["code"], "frame_unsupported");
    assert!(window.try_ask("frame", json!({"supports": {"vertices": [99]}})).is_err());
}

/// A beam that is clamped at one end and rests on the other bears 3/8 of its weight there, as textbooks have it; clamped at both, a half.
#[test]
fn what_a_support_leaves_free_is_kept_in_the_design() {
    let window = Window::new();
    let node = |x: f64, fixities: [u8; 6]| json!({"point": {"X": x, "Y": 0.0, "Z": 0.0}, "is_grounded": 1, "fixities": fixities});
    let beam = json!({
        "unit": "millimeter",
        "node_list": [node(0.0, [1; 6]), node(60.0, [0, 0, 1, 0, 0, 0])],
        "element_list": [{"end_node_ids": [0, 1]}],
    });
    window.ask("open", file(&window.file("beam.json", beam.to_string().as_bytes())));
    let share = || {
        let result = window.ask("frame", json!({"material": "abs-1-5mm"}))["result"].clone();
        let borne = result["static"]["reactions"].as_array().unwrap().iter();
        let borne: Vec<f64> = borne.map(|reaction| number(&reaction["force_n"][2])).collect();
        borne[1] / (borne[0] + borne[1])
    };
    assert!((share() - 3.0 / 8.0).abs() < 1e-9, "{}", share());
    window.ask("edit", json!({"request": {"edit": "support", "vertices": [1], "support": true}}));
    assert!((share() - 0.5).abs() < 1e-9, "marked anew it is held altogether: {}", share());
    window.ask("undo", json!({}));
    assert!((share() - 3.0 / 8.0).abs() < 1e-9, "{}", share());
    let saved = window.home.path().join("beam.wirebend");
    window.ask("save", json!({"path": saved}));
    window.ask("open", file(&saved));
    assert!((share() - 3.0 / 8.0).abs() < 1e-9, "{}", share());
}

/// As made, a wire is off by what its errors add up to; closed, by far less.
#[test]
fn a_closed_frame_is_drawn_before_and_after() {
    let window = Window::new();
    window.ask("open-example", json!({"id": "truss"}));
    let choices = window.ask("frame-choices", json!({}));
    assert!(choices["errors"].as_array().unwrap().iter().any(|entry| entry["id"] == "bend-forming"));
    let close = json!({"errors": "bend-forming", "runs": 2, "seed": 1});
    let asked = json!({"material": "steel-0-9mm", "supports": "free", "close": close, "double": true});
    let shown = window.ask("frame", asked);
    let closed = &shown["shapes"]["closed"];
    let [made_mm, closed_mm] = ["max_made_mm", "max_closed_mm"].map(|key| number(&closed[key]));
    assert!(made_mm > 10.0 * closed_mm && closed_mm > 0.0, "{made_mm} {closed_mm}");
    let points = closed["made"].as_array().unwrap().iter().flat_map(|wire| wire["by_mm"].as_array().unwrap());
    assert!((points.map(moved).fold(0.0, f64::max) - made_mm).abs() < 1e-9);
    let tolerance = window
        .ask("tolerance", json!({"material": "steel-0-9mm", "required": {"force_n": 20.0}, "double": true}));
    assert_eq!(tolerance["governed_by"], "force");
    assert!((number(&tolerance["achieved"]["force_n"]) - 20.0).abs() < 1e-6);
}

/// The order of the command line, with how the head moves; a step where it cannot be is named at once.
#[test]
fn a_sequence_is_found_drawn_and_changed() {
    let window = opened("four-frame.json", None);
    let asked = json!({"machine": "framefab-extruder", "material": "abs-1-5mm"});
    let found = window.ask("sequence", asked.clone());
    let steps = found["sequence"]["steps"].as_array().unwrap();
    assert_eq!((steps.len(), &found["sequence"]["feasible"]), (4, &json!(true)));
    let saved = window.home.path().join("frame.wirebend");
    window.ask("save", json!({"path": saved}));
    let task = Task::framefab(&serde_json::from_slice(&std::fs::read(saved).unwrap()).unwrap());
    assert_eq!(task.faults(&Step::printed(&found["sequence"])), []);
    for (step, head) in steps.iter().zip(found["moves"].as_array().unwrap()) {
        let free = head["free"].as_array().unwrap();
        assert_eq!(free.len() as u64, step["free_directions"].as_u64().unwrap());
        let taken = &step["direction"];
        assert!(free.iter().any(|place| {
            let way = &found["directions"][usize::try_from(place.as_u64().unwrap()).unwrap()];
            (0..3).all(|axis| (number(&way[axis]) - number(&taken[axis])).abs() < 1e-9)
        }));
    }
    let order = |places: [usize; 4]| -> Value {
        let step = |place: usize| {
            let step = &steps[place];
            json!({"edge": step["edge"], "from_vertex": step["from_vertex"], "direction": step["direction"]})
        };
        places.map(step).to_vec().into()
    };
    let mut same = asked.clone();
    same["order"] = order([0, 1, 2, 3]);
    let same = window.ask("sequence", same);
    assert_eq!(same["sequence"]["feasible"], true);
    assert_eq!(task.faults(&Step::printed(&same["sequence"])), []);
    // It is kept in a file, from which it is read again.
    let file = window.home.path().join("order.json");
    let mut kept = asked.clone();
    kept["order"] = order([0, 1, 2, 3]);
    kept["output"] = json!({"path": file});
    assert_eq!(window.ask("sequence", kept.clone())["sequence"]["feasible"], true);
    assert_eq!(window.try_ask("sequence", kept).unwrap_err().code, "exists");
    let mut again = asked.clone();
    again["file"] = json!(file);
    let again = window.ask("sequence", again);
    assert_eq!((&again["sequence"]["feasible"], &again["moves"]), (&json!(true), &same["moves"]));
    // Ground struts come first, and the last one needs both vertices.
    let mut changed = asked;
    changed["order"] = order([3, 0, 1, 2]);
    let changed = window.ask("sequence", changed);
    assert_eq!(changed["sequence"]["feasible"], false);
    assert_eq!(changed["sequence"]["diagnostics"][0]["step"], 0);
    assert_ne!(task.faults(&Step::printed(&changed["sequence"])), []);
    assert_eq!(changed["sequence"]["steps"].as_array().unwrap().len(), 4);
    assert_eq!(window.ask("stop-sequence", json!({})), json!({}));
}
