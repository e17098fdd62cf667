//! Stencils: in the design, or in a file beside it.

use std::fs;
use std::path::Path;

use serde_json::json;
use wirebend_editor::Editor;
use wirebend_files::document::{Document, PlacementFile, StencilSource, sha256_hex};
use wirebend_planning::{DesignInput, NoProgress};

use crate::{app, edit, example};

/// A design that names a bunny beside it as its stencil.
fn opened(folder: &Path, sha256: &str) -> (Editor, Vec<(String, String)>) {
    opened_with(folder, "models/bunny.obj", sha256)
}

fn opened_with(folder: &Path, path: &str, sha256: &str) -> (Editor, Vec<(String, String)>) {
    let stencil = StencilSource::File { path: path.to_owned(), sha256: sha256.to_owned() };
    let path = folder.join("a.wirebend");
    let mut document = Document::default();
    document.add_stencil(String::new(), stencil);
    fs::write(&path, document.to_bytes().unwrap()).unwrap();
    let (editor, notes) = Editor::open(&DesignInput::file(path), None, &NoProgress).unwrap();
    (editor, notes.into_iter().map(|note| (note.code.into_owned(), note.message)).collect())
}

/// Of each stencil how many faces are here.
fn faces(editor: &Editor) -> Vec<Option<usize>> {
    let stencils = editor.state().stencils;
    stencils.into_iter().map(|stencil| Some(stencil.surface?.faces)).collect()
}

fn names(editor: &Editor) -> Vec<String> {
    editor.state().stencils.into_iter().map(|stencil| stencil.name).collect()
}

#[test]
fn a_stencil_beside_the_design_is_read_and_saved_with_it() {
    let folder = tempfile::tempdir().unwrap();
    fs::create_dir(folder.path().join("models")).unwrap();
    let bunny = fs::read(example("bunny.obj")).unwrap();
    fs::write(folder.path().join("models/bunny.obj"), &bunny).unwrap();
    let (mut editor, notes) = opened(folder.path(), &sha256_hex(&bunny));
    assert_eq!(notes[0].0, "stencil-read");
    assert_eq!(faces(&editor), [Some(110)]);
    assert_eq!(names(&editor), ["bunny.obj"]);
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
    assert_eq!((notes[0].0.as_str(), faces(&editor)), ("stencil-missing", vec![None]));
    assert!(notes[0].1.contains("models/bunny.obj"), "{}", notes[0].1);

    fs::create_dir(folder.path().join("models")).unwrap();
    fs::copy(example("bunny.obj"), folder.path().join("models/bunny.obj")).unwrap();
    let (editor, notes) = opened(folder.path(), &sha256_hex(b"bunny"));
    assert_eq!((notes[0].0.as_str(), faces(&editor)), ("stencil-changed", vec![Some(110)]));

    fs::write(folder.path().join("models/bunny.obj"), "v 0 0 0\nv 1 0 0\nl 1 2\n").unwrap();
    let (editor, notes) = opened(folder.path(), &sha256_hex(b"bunny"));
    assert_eq!((notes[0].0.as_str(), faces(&editor)), ("stencil-missing", vec![None]));
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
        assert_eq!((notes[0].0.as_str(), faces(&editor)), ("stencil-missing", vec![None]));
        assert!(notes[0].1.contains("leads out of the folder"), "{}", notes[0].1);
    }
    assert_eq!(faces(&opened_with(folder.path(), "./bunny.obj", "").0), [Some(110)]);
}

#[test]
fn the_name_of_a_stencil_is_saved_and_undone_with_it() {
    let folder = tempfile::tempdir().unwrap();
    let (mut editor, _) = Editor::open(&DesignInput::file(example("bunny.obj")), None, &NoProgress).unwrap();
    assert_eq!(names(&editor), ["bunny.obj"]);
    let saved = editor.save(Some(&folder.path().join("a.wirebend"))).unwrap();
    let (mut again, _) = Editor::open(&DesignInput::file(saved), None, &NoProgress).unwrap();
    assert_eq!(names(&again), ["bunny.obj"]);
    edit(&mut again, &json!({"edit": "remove-stencil", "stencil": 0}));
    assert!(names(&again).is_empty());
    again.undo().unwrap();
    assert_eq!((names(&again), faces(&again)), (vec!["bunny.obj".to_owned()], vec![Some(110)]));
}

/// Each is moved, turned, scaled, named, coloured and hidden by itself, and each change is one thing to undo.
#[test]
fn two_stencils_are_changed_each_by_itself() {
    let (mut editor, _) = Editor::open(&DesignInput::file(example("bunny.obj")), None, &NoProgress).unwrap();
    let (found, _) = DesignInput::file(example("bunny.obj")).stencil(&NoProgress).unwrap();
    editor.put_stencil(found).unwrap();
    let before = editor.state();
    assert_eq!(before.stencils.iter().map(|stencil| stencil.id).collect::<Vec<_>>(), [0, 1]);

    let placement = json!({"shift_mm": [0, 50, 0], "turn_deg": [0, 0, 90], "scale": 2});
    edit(&mut editor, &json!({"edit": "place-stencil", "stencil": 1, "placement": placement}));
    let placed = editor.state().stencils[1].placement;
    let [one, other] = &editor.state().stencils[..] else { panic!("two") };
    assert_eq!(one, &before.stencils[0]);
    let (was, is) = (before.stencils[1].surface.as_ref().unwrap(), other.surface.as_ref().unwrap());
    assert_eq!((was.middle_mm, was.size_mm), (is.middle_mm, is.size_mm), "as in its own frame");
    // Turned by a quarter and twice as large: x of the surface goes along y of the design.
    assert!((is.matrix[1][0] - 2.0).abs() < 1e-12 && (is.matrix[0][1] + 2.0).abs() < 1e-12, "{is:?}");

    // Once more about z of the design, as the gizmo turns it: y of the surface, which goes along -x, comes to -y.
    let turn = |deg: f64| json!({"edit": "turn-stencil", "stencil": 1, "axis": "z", "angle_deg": deg});
    let change = edit(&mut editor, &turn(90.0));
    assert_eq!(change.state.undo.as_deref(), Some("turn stencil"));
    let turned = &editor.state().stencils[1];
    assert_eq!(turned.placement, PlacementFile { turn_deg: [0.0, 0.0, 180.0], ..placed });
    assert!((turned.surface.as_ref().unwrap().matrix[1][1] + 2.0).abs() < 1e-12, "{turned:?}");
    editor.undo().unwrap();
    assert_eq!(editor.state().stencils[1].placement, placed);

    let look = json!({"name": " ear\n left ", "colour": "#C07830", "hidden": true});
    let change = edit(&mut editor, &json!({"edit": "stencil-look", "stencil": 0, "look": look}));
    assert_eq!(change.state.undo.as_deref(), Some("hide stencil"));
    assert_eq!(names(&editor), ["ear left", "bunny.obj"]);
    let removed = json!({"edit": "remove-stencil", "stencil": 0});
    edit(
        &mut editor,
        &json!({"edit": "several", "label": "two", "edits": [removed,
        {"edit": "stencil-look", "stencil": 1, "look": {"name": "", "colour": null, "hidden": false}}]}),
    );
    assert_eq!(names(&editor), [""]);
    for _ in 0..3 {
        editor.undo().unwrap();
    }
    assert_eq!(editor.state().stencils, before.stencils);
}

#[test]
fn what_is_no_stencil_or_no_place_for_one_is_told() {
    let (mut editor, _) = Editor::open(&DesignInput::file(example("bunny.obj")), None, &NoProgress).unwrap();
    let placed = |stencil: u32, scale: f64| {
        json!({"edit": "place-stencil", "stencil": stencil,
        "placement": {"shift_mm": [0, 0, 0], "turn_deg": [0, 0, 0], "scale": scale}})
    };
    for (request, said) in [
        (json!({"edit": "remove-stencil", "stencil": 4}), "there is no stencil 4 in this design"),
        (placed(4, 1.0), "there is no stencil 4"),
        (json!({"edit": "turn-stencil", "stencil": 4, "axis": "x", "angle_deg": 1}), "there is no stencil 4"),
        (placed(0, 0.0), "can be scaled by 0.001 to 1000, not by 0"),
        (json!({"edit": "part-look", "edge": 9, "look": {}}), "there is no edge 9"),
    ] {
        let request = serde_json::from_value(request).unwrap();
        let refused = editor.edit(&app(), &request).unwrap_err().to_string();
        assert!(refused.contains(said), "{refused}");
    }
    assert!(!editor.state().changed);
}

/// What was done to stencils is on the disk before anything is saved.
#[test]
fn stencils_come_back_from_the_journal() {
    let kept = tempfile::tempdir().unwrap();
    let input = DesignInput::file(example("bunny.obj"));
    let (mut editor, _) = Editor::open(&input, Some(kept.path()), &NoProgress).unwrap();
    editor.put_stencil(input.stencil(&NoProgress).unwrap().0).unwrap();
    let placement = json!({"shift_mm": [0.1, 50, 0], "turn_deg": [1, 2, 3], "scale": 0.3});
    edit(&mut editor, &json!({"edit": "place-stencil", "stencil": 0, "placement": placement}));
    edit(&mut editor, &json!({"edit": "remove-stencil", "stencil": 1}));
    editor.undo().unwrap();
    let state = editor.state();
    // As where the program was killed.
    drop(editor);
    let (unsaved, _) = Editor::unsaved(kept.path());
    let again = Editor::restore(&unsaved[0].journal).unwrap();
    assert_eq!(again.state().stencils, state.stencils);
}

/// A wire that was traced would lie beside what it was traced on.
#[test]
fn the_fix_that_scales_the_design_scales_its_stencils() {
    let folder = tempfile::tempdir().unwrap();
    fs::create_dir(folder.path().join("models")).unwrap();
    let bunny = fs::read(example("bunny.obj")).unwrap();
    fs::write(folder.path().join("models/bunny.obj"), &bunny).unwrap();
    let (mut editor, _) = opened(folder.path(), &sha256_hex(&bunny));
    let machine = json!({"edit": "machine", "machine": "wirebend-kit", "material": null});
    edit(&mut editor, &machine);
    edit(&mut editor, &json!({"edit": "draw", "through_mm": [[0, 0, 0], [15, 0, 0], [15, 15, 0]]}));
    let app = app();
    let fixes = editor.fixes(&app).unwrap();
    let scale = fixes.iter().find(|fix| fix.title == "Scale the design by 1.87").unwrap();
    let undone = editor.view();
    editor.edit(&app, &scale.edit).unwrap();
    let placement: PlacementFile = editor.state().stencils[0].placement;
    assert!((placement.scale - 1.87).abs() < 1e-12);
    // About the middle of the wire, from 0 to 15 mm along x and y.
    for (axis, middle) in [7.5, 7.5, 0.0].into_iter().enumerate() {
        assert!((placement.shift_mm[axis] - middle * (1.0 - 1.87)).abs() < 1e-9, "{placement:?}");
    }
    assert!(editor.check(&app, &[]).unwrap().feasible);
    editor.undo().unwrap();
    assert_eq!(editor.view().vertices, undone.vertices);
    assert!((editor.state().stencils[0].placement.scale - 1.0).abs() < 1e-12, "one thing to undo");
}
