//! The open design: edits, undo, what is drawn anew, checks while dragging, and what is left after a crash.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)] // a test may stop at what cannot be
#![allow(clippy::print_stdout)] // what the program that is killed says

mod checks;
mod collisions;
mod construction;
mod edits;
mod fixes;
mod kept;
mod outcomes;
mod pauses;
mod stencils;

use std::path::{Path, PathBuf};

use serde_json::Value;
use wirebend_editor::{EditRequest, Editor, ViewChange};
use wirebend_planning::{DesignInput, Installation, NoProgress};

fn app() -> Installation {
    Installation::new(&[]).unwrap()
}

fn example(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples").join(name)
}

/// An example on the 293 dollar bender.
fn open(name: &str) -> Editor {
    let (mut editor, _) = Editor::open(&DesignInput::file(example(name)), None, &NoProgress).unwrap();
    edit(&mut editor, &serde_json::json!({"edit": "machine", "machine": "wirebend-kit", "material": null}));
    editor
}

/// An edit as a front end sends it.
fn edit(editor: &mut Editor, request: &Value) -> ViewChange {
    let request: EditRequest = serde_json::from_value(request.clone()).unwrap();
    editor.edit(&app(), &request).unwrap()
}
