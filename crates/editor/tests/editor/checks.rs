//! Checks while a person drags: the same as after they have let go, and nothing is changed by asking.

use serde_json::json;
use wirebend_editor::{Editor, EditorError, Moved};
use wirebend_planning::plan::CheckRequest;
use wirebend_planning::{DesignInput, DriverFolders, Installation, NoProgress, PlanChoices, PlanningError};

use crate::{app, edit, example, open};

#[test]
fn a_check_while_dragging_is_that_of_the_place_where_it_is_let_go() {
    let mut editor = open("cube-8-edges.obj");
    let before = editor.document().clone();
    let still = editor.check(&app(), &[]).unwrap();
    assert!(still.feasible && still.diagnostics.is_empty(), "{still:?}");
    // A corner that comes too near its neighbour.
    let dragged = [Moved { vertex: 1, at_mm: [10.0, 2.0, 1.0] }];
    let check = editor.check(&app(), &dragged).unwrap();
    assert!(!check.feasible);
    assert!(
        check.diagnostics.iter().any(|d| d.code.as_str() == "edge_too_short" && d.edge.is_some()),
        "{check:?}"
    );
    assert_eq!(editor.document(), &before, "nothing was changed by asking");
    edit(&mut editor, &json!({"edit": "place", "positions": [{"vertex": 1, "at_mm": [10.0, 2.0, 1.0]}]}));
    assert_eq!(editor.check(&app(), &[]).unwrap(), check);
    editor.undo().unwrap();
    assert_eq!(editor.check(&app(), &[]).unwrap(), still);
    assert!(editor.check(&app(), &[Moved { vertex: 99, at_mm: [0.0; 3] }]).is_err());
}

/// The window and the command line say the same of a file.
#[test]
fn it_says_what_the_command_says() {
    for name in ["bunny.wirebend", "cube.obj", "house.obj", "two-parts.obj", "spring.obj"] {
        let file = if name == "bunny.wirebend" { example("bunny.obj") } else { example(name) };
        let mut input = DesignInput::file(file);
        input.face_edges = name == "bunny.wirebend";
        let (mut editor, _) = Editor::open(&input, None, &NoProgress).unwrap();
        edit(&mut editor, &json!({"edit": "machine", "machine": "wirebend-kit", "material": null}));
        let choices = PlanChoices { machine: Some("wirebend-kit".into()), ..PlanChoices::default() };
        let request = CheckRequest { design: input, choices };
        let said = wirebend_planning::plan::check(&app(), &request, &NoProgress).unwrap();
        let check = editor.check(&app(), &[]).unwrap();
        assert_eq!((check.feasible, check.diagnostics), (said.feasible, said.diagnostics), "{name}");
    }
}

#[test]
fn another_machine_is_checked_at_once_and_without_one_nothing_is() {
    let mut editor = open("house.obj");
    let kit = editor.check(&app(), &[]).unwrap();
    edit(&mut editor, &json!({"edit": "machine", "machine": "pensa-diwire-pro", "material": null}));
    let pensa = editor.check(&app(), &[]).unwrap();
    assert_ne!(kit.wires[0].time_s, pensa.wires[0].time_s);
    editor.undo().unwrap();
    assert_eq!(editor.check(&app(), &[]).unwrap(), kit);
    let mut bare = Editor::new(&app(), None, None).unwrap();
    assert!(matches!(bare.check(&app(), &[]), Err(EditorError::Planning(PlanningError::NoMachine { .. }))));
}

/// A corner that is dragged away from a straight part makes a feed that the controller refuses in the middle of a wire.
#[test]
fn a_check_while_dragging_knows_the_limits_of_the_driver() {
    let folder = wirebend_tests_built::driver("wirebend-kit").parent().unwrap().to_owned();
    let drivers = DriverFolders {
        own: Some(vec![folder]),
        program: Some(wirebend_tests_built::driver_child()),
        ..DriverFolders::default()
    };
    let app = Installation::new(&[]).unwrap().with_drivers(drivers);
    let mut editor = open("u-sample.obj");
    assert!(editor.check(&app, &[]).unwrap().feasible);
    // The first side of the U lies along its first edge: 8 m of it.
    let there = editor.document().wireframe.vertices().next().unwrap().1.position;
    let next = editor.document().wireframe.vertices().nth(1).unwrap().1.position;
    let away = there + (there - next).normalize() * 8000.0;
    let check = editor.check(&app, &[Moved { vertex: 0, at_mm: [away.x, away.y, away.z] }]).unwrap();
    let long = check.diagnostics.iter().find(|d| d.code.as_str() == "feed_too_long").unwrap();
    assert!(long.limit_source.as_ref().unwrap().contains("driver setting feed_most_mm"), "{long:?}");
    assert!(!check.feasible);
}
