//! The connected machine, beside the open design.

use std::time::{Duration, Instant};

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
            std::thread::yield_now();
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
    // It is the same wire while it is made and when it is over.
    window.order(&json!({"order": "start"}));
    let over = window.until(|state| state["busy"] == false && state["wire"]["made"] == wire["of"]);
    for key in ["job_hash", "name", "wire", "of"] {
        assert_eq!(over["wire"][key], wire[key], "{key}");
    }
    // Of nothing there is no job.
    window.ask("new", json!({}));
    assert_eq!(hash(), json!(null));
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
        assert!(refusal.message.contains("disconnect it, and connect it again"), "{}", refusal.message);
    }
    window.order(&json!({"order": "disconnect"}));
    window.until_phase("closed");
    window.connect();
    window.order(&json!({"order": "arm", "wire": 0}));
    window.yes();
    window.until_phase("armed");
}
