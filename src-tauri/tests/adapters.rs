//! The adapters without a display: what the editor asks arrives, and what is reported comes back.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)] // a test may stop at what cannot be

use std::path::PathBuf;
use std::sync::Arc;

use serde_json::{Value, json};
use tauri::WebviewWindow;
use tauri::ipc::{CallbackFn, InvokeBody, InvokeResponseBody};
use tauri::test::{MockRuntime, get_ipc_response, mock_builder, mock_context, noop_assets};
use tauri::webview::InvokeRequest;
use wirebend_api::{Places, Workspace};
use wirebend_window::{EventChannel, FilesToOpen, with_adapters};

/// A window without a screen, on a desk in a folder of its own.
struct Window {
    _home: tempfile::TempDir,
    _app: tauri::App<MockRuntime>,
    page: WebviewWindow<MockRuntime>,
}

fn window(files: Vec<PathBuf>) -> Window {
    let home = tempfile::tempdir().unwrap();
    let places = Places {
        own: Some(home.path().join("own")),
        shipped_drivers: Some(Vec::new()),
        state: Some(home.path().join("state")),
        ..Places::default()
    };
    let event_channel = Arc::new(EventChannel::default());
    let desk = Workspace::new(places, Arc::clone(&event_channel) as _).unwrap();
    let builder =
        with_adapters(mock_builder(), event_channel, FilesToOpen::new(files)).manage(Arc::new(desk));
    let app = builder.build(mock_context(noop_assets())).unwrap();
    let page = tauri::WebviewWindowBuilder::new(&app, "main", tauri::WebviewUrl::default()).build().unwrap();
    Window { _home: home, _app: app, page }
}

impl Window {
    fn invoke(&self, command: &str, body: Value) -> Result<InvokeResponseBody, Value> {
        get_ipc_response(
            &self.page,
            InvokeRequest {
                cmd: command.to_owned(),
                callback: CallbackFn(0),
                error: CallbackFn(1),
                url: "tauri://localhost".parse().unwrap(),
                body: InvokeBody::Json(body),
                headers: tauri::http::HeaderMap::default(),
                invoke_key: tauri::test::INVOKE_KEY.to_owned(),
            },
        )
    }

    fn ask(&self, ask: &Value) -> Result<Value, Value> {
        self.invoke("ask", json!({ "ask": ask })).map(|answer| answer.deserialize().unwrap())
    }
}

/// The editor would wait for an answer that never comes.
#[test]
fn an_ask_is_answered_as_json() {
    let window = window(Vec::new());
    let opened = window.ask(&json!({"ask": "open-example", "id": "house"})).unwrap();
    assert_eq!(opened["design"]["state"]["name"], "House");
    assert_eq!(opened["design"]["edges"].as_array().unwrap().len(), 6);
    assert_eq!(window.ask(&json!({"ask": "check", "moved": []})).unwrap()["feasible"], true);
}

/// A person would read "[object Object]" instead of what is wrong.
#[test]
fn a_refusal_arrives_with_code_and_message() {
    let window = window(Vec::new());
    let refusal = window.ask(&json!({"ask": "open-example", "id": "boat"})).unwrap_err();
    assert_eq!((&refusal["code"], &refusal["kind"]), (&json!("no-example"), &json!("usage")));
    assert!(refusal["message"].as_str().unwrap().contains("boat"));
    assert_eq!(window.ask(&json!({"ask": "no-such"})).unwrap_err()["code"], "ask");
}

/// As text a large stencil takes seconds.
#[test]
fn a_stencil_arrives_as_bytes() {
    let window = window(Vec::new());
    window.ask(&json!({"ask": "open-example", "id": "bunny-stencil"})).unwrap();
    let InvokeResponseBody::Raw(bytes) = window.invoke("stencil_mesh", json!({"stencil": 0})).unwrap() else {
        panic!("the stencil came as text");
    };
    let corners = u32::from_le_bytes(bytes[..4].try_into().unwrap());
    let triangles = u32::from_le_bytes(bytes[4..8].try_into().unwrap());
    assert_eq!(bytes.len(), 8 + 12 * (corners as usize + triangles as usize));
    assert!(triangles > 100);
}

/// Without a machine there is nothing to stop, and that is no failure.
#[test]
fn a_stop_is_always_answered() {
    assert!(window(Vec::new()).invoke("stop", json!({})).is_ok());
}

/// A file that is opened by a double click waits until the editor is there, and is opened once.
#[test]
fn files_of_the_command_line_are_handed_over_once() {
    let window = window(vec![PathBuf::from("/here/a.wirebend")]);
    let files =
        |window: &Window| window.invoke("files_to_open", json!({})).unwrap().deserialize::<Value>().unwrap();
    assert_eq!(files(&window), json!(["/here/a.wirebend"]));
    assert_eq!(files(&window), json!([]));
}
