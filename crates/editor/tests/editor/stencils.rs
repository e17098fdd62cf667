//! Stencils: in the design, or in a file beside it.

use std::fs;
use std::path::Path;

use serde_json::json;
use wirebend_editor::Editor;
use wirebend_files::document::{Document, StencilSource, sha256_hex};
use wirebend_planning::{DesignInput, NoProgress};

use crate::{edit, example};

/// A design that names a bunny beside it as its stencil.
fn opened(folder: &Path, sha256: &str) -> (Editor, Vec<(String, String)>) {
    opened_with(folder, "models/bunny.obj", sha256)
}

fn opened_with(folder: &Path, path: &str, sha256: &str) -> (Editor, Vec<(String, String)>) {
    let stencil = Some(StencilSource::File { path: path.to_owned(), sha256: sha256.to_owned() });
    let path = folder.join("a.wirebend");
    fs::write(&path, Document { stencil, ..Document::default() }.to_bytes().unwrap()).unwrap();
    let (editor, notes) = Editor::open(&DesignInput::file(path), None, &NoProgress).unwrap();
    (editor, notes.into_iter().map(|note| (note.code.into_owned(), note.message)).collect())
}

#[test]
fn a_stencil_beside_the_design_is_read_and_saved_with_it() {
    let folder = tempfile::tempdir().unwrap();
    fs::create_dir(folder.path().join("models")).unwrap();
    let bunny = fs::read(example("bunny.obj")).unwrap();
    fs::write(folder.path().join("models/bunny.obj"), &bunny).unwrap();
    let (mut editor, notes) = opened(folder.path(), &sha256_hex(&bunny));
    assert_eq!(notes[0].0, "stencil-read");
    assert_eq!(editor.view().stencil, Some([57, 110]));
    assert_eq!(editor.state().stencil.as_deref(), Some("bunny.obj"));
    assert!(!editor.state().changed);

    let elsewhere = tempfile::tempdir().unwrap();
    let saved = editor.save(Some(&elsewhere.path().join("b.wirebend"))).unwrap();
    let (again, notes) = Editor::open(&DesignInput::file(saved), None, &NoProgress).unwrap();
    assert_eq!((again.view(), notes.len()), (editor.view(), 0));
}

#[test]
fn a_stencil_that_has_changed_or_is_gone_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let (editor, notes) = opened(folder.path(), &sha256_hex(b"bunny"));
    assert_eq!((notes[0].0.as_str(), editor.view().stencil), ("stencil-missing", None));
    assert!(notes[0].1.contains("models/bunny.obj"), "{}", notes[0].1);

    fs::create_dir(folder.path().join("models")).unwrap();
    fs::copy(example("bunny.obj"), folder.path().join("models/bunny.obj")).unwrap();
    let (editor, notes) = opened(folder.path(), &sha256_hex(b"bunny"));
    assert_eq!((notes[0].0.as_str(), editor.view().stencil), ("stencil-changed", Some([57, 110])));

    fs::write(folder.path().join("models/bunny.obj"), "v 0 0 0\nv 1 0 0\nl 1 2\n").unwrap();
    let (editor, notes) = opened(folder.path(), &sha256_hex(b"bunny"));
    assert_eq!((notes[0].0.as_str(), editor.view().stencil), ("stencil-missing", None));
    assert!(notes[0].1.contains("has no surface"), "{}", notes[0].1);
}

/// A design of a stranger has no business with what is kept elsewhere.
#[test]
fn a_stencil_outside_the_folder_of_the_design_is_not_read() {
    let folder = tempfile::tempdir().unwrap();
    let inner = folder.path().join("inner");
    fs::create_dir(&inner).unwrap();
    fs::copy(example("bunny.obj"), folder.path().join("bunny.obj")).unwrap();
    let absolute = folder.path().join("bunny.obj");
    for path in ["../bunny.obj", absolute.to_str().unwrap()] {
        let (editor, notes) = opened_with(&inner, path, &sha256_hex(b""));
        assert_eq!((notes[0].0.as_str(), editor.view().stencil), ("stencil-missing", None));
        assert!(notes[0].1.contains("leads out of the folder"), "{}", notes[0].1);
    }
    assert!(opened_with(folder.path(), "./bunny.obj", "").0.view().stencil.is_some());
}

#[test]
fn the_name_of_a_stencil_is_saved_and_undone_with_it() {
    let folder = tempfile::tempdir().unwrap();
    let (mut editor, _) = Editor::open(&DesignInput::file(example("bunny.obj")), None, &NoProgress).unwrap();
    assert_eq!(editor.state().stencil.as_deref(), Some("bunny.obj"));
    let saved = editor.save(Some(&folder.path().join("a.wirebend"))).unwrap();
    let (mut again, _) = Editor::open(&DesignInput::file(saved), None, &NoProgress).unwrap();
    assert_eq!(again.state().stencil.as_deref(), Some("bunny.obj"));
    edit(&mut again, &json!({"edit": "remove-stencil"}));
    assert_eq!(again.state().stencil, None);
    again.undo().unwrap();
    assert_eq!(again.state().stencil.as_deref(), Some("bunny.obj"));
}
