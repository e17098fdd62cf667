//! The connected machine, beside the open design.

use std::time::{Duration, Instant};

use wirebend_api::ErrorRemedy;

use super::*;

/// Nothing that is waited for takes so long.
const PATIENCE: Duration = Duration::from_secs(20);

impl Window {
    /// The machine's state once it fits.
    #[track_caller]
    pub(super) fn until(&self, fits: impl Fn(&Value) -> bool) -> Value {
        let begun = Instant::now();
        loop {
            let state = self.ask("machine-state", json!({}))["state"].clone();
            if fits(&state) {
                return state;
            }
            assert!(begun.elapsed() < PATIENCE, "{state}");
            std::thread::sleep(Duration::from_millis(1));
        }
    }

    #[track_caller]
    pub(super) fn until_phase(&self, phase: &str) -> Value {
        self.until(|state| state["phase"] == phase && state["busy"] == false)
    }

    pub(super) fn connect(&self) {
        self.ask("connect", json!({"port": "sim:max"}));
        self.until_phase("connected");
    }

    pub(super) fn order(&self, order: &Value) {
        self.ask("order", json!({"request": order}));
    }

    #[track_caller]
    pub(super) fn yes(&self) {
        let asked = self.until(|state| state["question"].is_object());
        self.ask("answer", json!({"question": asked["question"]["id"], "answer": "yes"}));
    }
}

/// Who was told by *Check* that the wire runs into itself would otherwise arm the very same wire without a word of it, or carry away
/// a program or a sheet that says nothing.
#[test]
fn a_collision_is_the_same_error_for_the_check_a_program_a_job_the_sheet_and_arming() {
    let window = Window::new();
    window.ask("new", json!({}));
    // The first edge swings across the stock in the second bend; the third bend leads the wire away from it.
    let through = json!([[0, 0, 0], [300, 0, 0], [225, 130, 0], [187, 65, 0], [112, 195, 0]]);
    let draw = json!({"edit": "draw", "from": null, "through_mm": through, "to": null});
    window.ask("edit", json!({"request": draw}));
    let limits = window.ask("check", json!({"moved": []}));
    assert_eq!(limits["feasible"], json!(true), "it is within every limit: {limits}");
    let found = window.ask("collisions", json!({}));
    let codes = |found: &Value| found["contacts"].to_string();
    assert!(codes(&found).contains("meets_stock"), "{found}");

    window.connect();
    let output = |name: &str| json!({"path": window.home.path().join(name), "force": false});
    let arm = |despite: bool| json!({"request": {"order": "arm", "wire": 0, "despite_errors": despite}});
    let program = |despite: bool, name: &str| json!({"format": "wirebend-kit-text", "output": output(name), "despite_errors": despite});
    let job = |despite: bool, name: &str| json!({"output": output(name), "despite_errors": despite});
    let asked = [
        ("export", program(false, "refused.txt")),
        ("save-job", job(false, "refused.wbjob")),
        ("order", arm(false)),
    ];
    for (ask, asked) in asked {
        let refusal = window.try_ask(ask, asked).map(|_| ask).unwrap_err();
        assert_eq!(serde_json::to_value(&refusal).unwrap()["code"], json!("not-feasible"), "{ask}");
    }
    let sheet = window.ask("export", json!({"format": "job-sheet"}));
    assert_eq!(sheet["feasible"], json!(false), "the sheet says that it can be bent");
    // A person who wants it all the same gets it, and is told once more before anything moves.
    window.ask("export", program(true, "wanted.txt"));
    window.ask("save-job", job(true, "wanted.wbjob"));
    let file = |name: &str| window.home.path().join(name);
    let kept: Value = serde_json::from_slice(&std::fs::read(file("wanted.wbjob")).unwrap()).unwrap();
    assert!(kept["objections"].to_string().contains("still to be bent"), "{}", kept["objections"]);
    // The program in a file is the same wire as the design.
    let opened = window.ask("open-run-file", json!({"file": {"file": file("wanted.txt")}}));
    assert_eq!(opened["file"]["feasible"], json!(false), "{opened}");
    assert!(opened["file"]["findings"].to_string().contains("meets_stock"), "{opened}");
    for order in ["arm", "dry-run"] {
        let asked = json!({"request": {"order": order, "wire": 0, "despite_errors": false}});
        let refusal = window.try_ask("order", asked).map(|_| order).unwrap_err();
        assert_eq!(serde_json::to_value(&refusal).unwrap()["code"], json!("not-feasible"), "{order}");
    }
    window.ask("close-run-file", json!({}));
    window.ask("order", arm(true));
    let asked = window.until(|state| state["question"].is_object());
    assert!(
        asked["question"]["lines"].to_string().contains("hits the wire that is still to be bent"),
        "{asked}"
    );
}

/// Steps of one design would be lit up in another that was changed or opened since.
#[test]
fn whether_a_wire_is_of_the_open_design_is_known_by_its_hash() {
    let window = Window::new();
    window.ask("open-example", json!({"id": "house"}));
    window.connect();
    window.order(&json!({"order": "arm", "wire": 0}));
    window.yes();
    let wire = window.until_phase("armed")["wire"].clone();
    assert_eq!((&wire["name"], &wire["made"]), (&json!("House"), &json!(0)));
    let hash = || window.ask("program", json!({}))["job_hash"].clone();
    assert_eq!(hash(), wire["job_hash"]);
    window.ask("edit", json!({"request": {"edit": "move", "vertices": [0], "by_mm": [0, 0, 1]}}));
    assert_ne!(hash(), wire["job_hash"]);
    window.ask("undo", json!({}));
    assert_eq!(hash(), wire["job_hash"]);
    // It is the same wire while it is bent and when it is over.
    window.order(&json!({"order": "start"}));
    let over = window.until(|state| state["busy"] == false && state["wire"]["made"] == wire["of"]);
    for key in ["job_hash", "name", "wire", "of"] {
        assert_eq!(over["wire"][key], wire[key], "{key}");
    }
    assert_eq!(over["wire"]["in_step"], json!(0.0), "no step is under way");
    // Of nothing there is no job.
    window.ask("new", json!({}));
    assert_eq!(hash(), json!(null));
}

/// Were it counted from another place, the view would show a wire that the machine has not bent.
#[test]
fn moves_by_hand_make_a_wire_until_the_machine_is_homed_again() {
    let window = Window::new();
    window.ask("open-example", json!({"id": "house"}));
    let by_hand = || {
        let answer = window.ask("by-hand", json!({}));
        let steps = answer["wire"]["steps"].as_array().unwrap().len();
        assert_eq!(answer["wire"]["corners_mm"].as_array().unwrap().len(), steps + 1);
        (answer["moves"].as_u64().unwrap(), steps)
    };
    assert_eq!(by_hand(), (0, 1), "nothing is connected");
    window.connect();
    window.order(&json!({"order": "home"}));
    window.until_phase("ready");
    let moves = [
        json!({"move": "feed", "mm": 40.0}),
        json!({"move": "bend", "deg": 45.0}),
        json!({"move": "feed", "mm": 30.0}),
    ];
    window.order(&json!({"order": "jog", "moves": moves}));
    window.until_phase("ready");
    assert_eq!(by_hand(), (3, 2));
    // What is refused moves nothing.
    window.order(&json!({"order": "jog", "moves": [{"move": "bend", "deg": 170.0}]}));
    window.until(|state| state["problem"].is_object() && state["busy"] == false);
    assert_eq!(by_hand(), (3, 2));
    window.order(&json!({"order": "home"}));
    window.until_phase("ready");
    assert_eq!(by_hand(), (0, 1));
}

/// A machine would move by settings that its profile does not have any more, or be refused every job for ever.
#[test]
fn a_machine_that_was_connected_before_its_profile_changed_is_connected_again() {
    let window = Window::new();
    window.ask("open-example", json!({"id": "house"}));
    window.ask(
        "copy-profile",
        json!({"kind": "machine", "from": "wirebend-kit", "id": "mine", "name": "Mine"}),
    );
    window.ask("edit", json!({"request": {"edit": "machine", "machine": "mine", "material": null}}));
    window.connect();
    window.order(&json!({"order": "home"}));
    window.until_phase("ready");
    // Profiles are read again, and this one says the same.
    window.ask("copy-profile", json!({"kind": "machine", "from": "mine", "id": "other", "name": "Other"}));
    window.order(&json!({"order": "home"}));
    window.until_phase("ready");
    let set = json!({"machine": "mine", "settings": {"feed_steps_per_mm": 20.0}});
    window.ask("change-settings", set);
    for order in [
        json!({"order": "home"}),
        json!({"order": "jog", "moves": [{"move": "feed", "mm": 1.0}]}),
        json!({"order": "arm", "wire": 0}),
    ] {
        let refusal = window.try_ask("order", json!({"request": order})).unwrap_err();
        assert_eq!(refusal.code, "connected-before", "{order}");
        assert_eq!(refusal.remedies, [ErrorRemedy::ConnectAgain]);
    }
    window.order(&json!({"order": "disconnect"}));
    window.until_phase("closed");
    window.connect();
    window.order(&json!({"order": "arm", "wire": 0}));
    window.yes();
    window.until_phase("armed");
}

/// A machine would bend into the piece before, or run out of wire in the middle of one.
#[test]
fn between_two_pieces_a_person_is_asked_and_new_wire_when_what_is_left_does_not_suffice() {
    let window = Window::new();
    window.ask("open-example", json!({"id": "house"}));
    window.connect();
    // 286 mm are fed for a piece, and 686 mm have to be there: twice that does not suffice for the second.
    window.order(&json!({"order": "arm", "wire": 0, "repeat": {"pieces": 3, "stock_mm": 800.0}}));
    window.yes();
    let armed = window.until_phase("armed")["wire"].clone();
    assert_eq!((&armed["piece"], &armed["stock_left_mm"]), (&json!({"number": 1, "of": 3}), &json!(800.0)));
    window.order(&json!({"order": "start"}));
    for number in [2, 3] {
        let state = window.until(|state| state["question"]["kind"] == "piece");
        assert_eq!(state["wire"]["piece"], json!({"number": number, "of": 3}));
        let said = state["question"]["lines"].to_string();
        assert!(said.contains("cut off what was bent before"), "{said}");
        assert!(said.contains("load new wire, 800 mm"), "{said}");
        window.yes();
        window.until(|state| state["question"].is_null());
        if number == 2 {
            continue;
        }
        window.until(|state| state["busy"] == false);
    }
    let runs = window.ask("runs", json!({}))["runs"].clone();
    let pieces: Vec<&Value> = runs.as_array().unwrap().iter().map(|run| &run["piece"]["number"]).collect();
    assert_eq!(pieces, [&json!(1), &json!(2), &json!(3)]);
    assert!(runs.as_array().unwrap().iter().all(|run| run["outcome"] == "finished"));

    // Who says no ends it: what was bent stays counted, and nothing is left to resume.
    window.order(&json!({"order": "arm", "wire": 0, "repeat": {"pieces": 2}}));
    window.yes();
    window.until_phase("armed");
    window.order(&json!({"order": "start"}));
    let asked = window.until(|state| state["question"]["kind"] == "piece")["question"]["id"].clone();
    window.ask("answer", json!({"question": asked, "answer": "no"}));
    let state = window.until(|state| state["busy"] == false);
    assert_eq!((&state["unfinished"], &state["problem"]), (&json!(null), &json!(null)));
    assert_eq!(window.ask("runs", json!({}))["runs"].as_array().unwrap().len(), 4);
}
