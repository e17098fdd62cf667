//! The connected machine, beside the open design.

use std::time::{Duration, Instant};

use wirebend_api::ErrorRemedy;

use super::*;

/// Nothing that is waited for takes so long.
const PATIENCE: Duration = Duration::from_secs(20);

impl Window {
    /// The machine's state once it fits.
    #[track_caller]
    fn until(&self, fits: impl Fn(&Value) -> bool) -> Value {
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
    fn until_phase(&self, phase: &str) -> Value {
        self.until(|state| state["phase"] == phase && state["busy"] == false)
    }

    fn connect(&self) {
        self.ask("connect", json!({"port": "sim:max"}));
        self.until_phase("connected");
    }

    fn order(&self, order: &Value) {
        self.ask("order", json!({"request": order}));
    }

    #[track_caller]
    fn yes(&self) {
        let asked = self.until(|state| state["question"].is_object());
        self.ask("answer", json!({"question": asked["question"]["id"], "answer": "yes"}));
    }
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
    window.ask("copy-machine", json!({"machine": "wirebend-kit", "id": "mine", "name": "Mine"}));
    window.ask("edit", json!({"request": {"edit": "machine", "machine": "mine", "material": null}}));
    window.connect();
    window.order(&json!({"order": "home"}));
    window.until_phase("ready");
    // Profiles are read again, and this one says the same.
    window.ask("copy-machine", json!({"machine": "mine", "id": "other", "name": "Other"}));
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
