//! What a window asks and hears: everything that the editor can do goes through here.

mod calibrations;
mod designs;
mod frame_loads;
mod frames;
mod machines;
mod predictions;
mod profiles;
mod run_files;
mod running;
mod wrong_files;

use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};

use serde_json::{Value, json};
use wirebend_api::{ApiErrorReport, EventSink, Places, REQUESTS, WindowEvent, Workspace};
use wirebend_tests_built::{driver_child, shipped_drivers};

/// What was reported, in order.
#[derive(Default)]
struct Told(Mutex<Vec<Value>>);

impl EventSink for Told {
    fn emit(&self, event: &WindowEvent) {
        self.0.lock().unwrap().push(serde_json::to_value(event).unwrap());
    }
}

/// A workspace in a folder of its own.
struct Window {
    home: tempfile::TempDir,
    workspace: Workspace,
    told: Arc<Told>,
}

fn places(home: &Path) -> Places {
    Places {
        own: Some(home.join("own")),
        shipped_drivers: Some(vec![shipped_drivers()]),
        driver_program: Some(driver_child()),
        runs: Some(home.join("runs")),
        state: Some(home.join("state")),
        ..Places::default()
    }
}

impl Window {
    fn new() -> Self {
        Self::at(tempfile::tempdir().unwrap())
    }

    fn at(home: tempfile::TempDir) -> Self {
        let told = Arc::new(Told::default());
        let workspace = Workspace::new(places(home.path()), Arc::clone(&told) as _).unwrap();
        Self { home, workspace, told }
    }

    fn try_ask(&self, name: &str, request: Value) -> Result<Value, ApiErrorReport> {
        let mut ask = request;
        ask["ask"] = json!(name);
        let answer = self.workspace.ask_json(&ask.to_string())?;
        Ok(serde_json::from_str(answer.get()).unwrap())
    }

    fn ask(&self, name: &str, request: Value) -> Value {
        self.try_ask(name, request).unwrap_or_else(|refusal| panic!("{name}: {refusal:?}"))
    }

    fn file(&self, name: &str, contents: &[u8]) -> PathBuf {
        let path = self.home.path().join(name);
        std::fs::write(&path, contents).unwrap();
        path
    }
}

fn example(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples").join(name)
}

fn file(path: &Path) -> Value {
    json!({"design": {"input": {"file": path}}})
}

/// A window that asks with a name that is not known, or leaves out what is needed, would hang without an answer.
#[test]
fn what_cannot_be_asked_is_refused_with_what_can() {
    let window = Window::new();
    let refusal = window.try_ask("nonsense", json!({})).unwrap_err();
    assert_eq!(refusal.code, "ask");
    assert!(REQUESTS.iter().all(|name| refusal.message.contains(name)), "{}", refusal.message);
    assert!(window.workspace.ask_json("{").unwrap_err().message.starts_with("invalid request"));
    assert!(window.try_ask("open-example", json!({})).unwrap_err().message.contains("id"));
}

/// The types of the editor are generated from these schemas: an answer that breaks one would be shown wrong.
#[test]
fn answers_keep_their_schema() {
    let window = Window::new();
    let schemas = wirebend_api::request_schemas();
    let responses = &schemas.iter().find(|(name, _)| *name == "asks.responses").unwrap().1;
    let asks = [
        ("start", json!({})),
        ("about", json!({})),
        ("examples", json!({})),
        ("open-example", json!({"id": "house"})),
        ("look", file(&example("bunny.obj"))),
        ("edit", json!({"request": {"edit": "move", "vertices": [0], "by_mm": [0, 0, 10]}})),
        ("undo", json!({})),
        ("redo", json!({})),
        ("redo", json!({})),
        ("check", json!({"moved": [{"vertex": 0, "at_mm": [0, 0, 0]}]})),
        ("program", json!({})),
        ("made", json!({})),
        ("compare", json!({"against": ["pensa-diwire-pro"]})),
        ("exports", json!({})),
        ("export", json!({"format": "wirebend-kit-text"})),
        ("machines", json!({})),
        ("materials", json!({})),
        ("machine-view", json!({"machine": "wirebend-kit"})),
        ("profile-explain", json!({"id": "wirebend-kit", "kind": "machine"})),
        ("drivers", json!({})),
        ("ports", json!({"machine": "wirebend-kit"})),
        ("runs", json!({})),
        ("save", json!({"path": window.home.path().join("x.wirebend")})),
        ("new", json!({})),
    ];
    for (name, request) in asks {
        let answer = window.ask(name, request);
        let mut schema = responses["properties"][name].clone();
        schema["$defs"] = responses["$defs"].clone();
        let validator = jsonschema::validator_for(&schema).unwrap();
        let errors: Vec<String> =
            validator.iter_errors(&answer).map(|error| error.instance_path().to_string()).collect();
        assert!(errors.is_empty(), "{name}: {errors:?}");
    }
}
