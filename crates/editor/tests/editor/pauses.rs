//! Pause points of the open design.

use serde_json::{Value, json};
use wirebend_editor::EditRequest;

use crate::{app, edit, open};

/// One note at a place: a second one takes its place, and none takes it away.
#[test]
fn a_pause_point_is_kept_by_vertex_and_pass() {
    let mut editor = open("cube.obj");
    let mut pause = |pass: u32, note: Value| {
        let change = edit(&mut editor, &json!({"edit": "pause", "vertex": 5, "pass": pass, "note": note}));
        let pauses = change.state.pauses.into_iter();
        pauses.map(|pause| (pause.vertex, pause.pass, pause.note)).collect::<Vec<_>>()
    };
    pause(2, json!("clip the joint"));
    let both = pause(1, json!("  turn\nthe part "));
    assert_eq!(both, [(5, 1, "turn the part".to_owned()), (5, 2, "clip the joint".to_owned())]);
    assert_eq!(pause(2, json!("clip it"))[1].2, "clip it");
    assert_eq!(pause(1, Value::Null), [(5, 2, "clip it".to_owned())]);
    // It goes with its vertex, and comes back with it.
    let gone = edit(&mut editor, &json!({"edit": "delete", "vertices": [5]}));
    assert_eq!(gone.state.pauses, []);
    assert_eq!(editor.undo().unwrap().unwrap().state.pauses.len(), 1);
}

#[test]
fn a_pause_point_that_cannot_be_is_refused() {
    let mut editor = open("cube.obj");
    for (vertex, pass, note, code, said) in [
        (50, 1, "turn the part", "no-vertex", "no vertex 50 for the machine to wait at"),
        (5, 1, " \n", "edit", "a pause point needs a note"),
        (5, 0, "turn the part", "edit", "no pass 0"),
    ] {
        let request = json!({"edit": "pause", "vertex": vertex, "pass": pass, "note": note});
        let request: EditRequest = serde_json::from_value(request).unwrap();
        let error = editor.edit(&app(), &request).unwrap_err();
        assert!(error.to_string().contains(said), "{error}");
        assert_eq!(error.code(), code);
    }
    assert_eq!(editor.document().pauses, []);
}
