//! Opening, editing, saving, and what is left after a crash.

use super::*;

fn triangles(mesh: &[u8]) -> (usize, usize) {
    let number = |at: usize| u32::from_le_bytes(mesh[at..at + 4].try_into().unwrap()) as usize;
    (number(0), number(4))
}

/// A newcomer's first click: every example opens, and shows what its description promises.
#[test]
fn every_example_opens() {
    let window = Window::new();
    let examples = window.ask("examples", json!({}));
    let examples = examples["examples"].as_array().unwrap();
    assert_eq!(examples.len(), 9);
    for example in examples {
        let (id, lines) = (example["id"].as_str().unwrap(), example["lines_mm"].as_array().unwrap());
        assert!(!lines.is_empty(), "{id} has no picture");
        let opened = window.ask("open-example", json!({"id": id}));
        let edges = opened["design"]["edges"].as_array().unwrap().len();
        assert_eq!(opened["design"]["state"]["changed"], false, "{id}");
        assert_eq!(opened["design"]["state"]["machine"], "wirebend-kit", "{id}");
        if id == "bunny-stencil" {
            assert_eq!((edges, opened["design"]["state"]["stencils"][0]["surface"].is_object()), (0, true));
        } else {
            assert_eq!(edges, lines.len(), "{id}");
        }
    }
    let house = window.ask("open-example", json!({"id": "house"}));
    assert_eq!(house["design"]["state"]["name"], "House");
    assert_eq!(window.ask("check", json!({}))["feasible"], true);
    assert_eq!(window.try_ask("open-example", json!({"id": "boat"})).unwrap_err().code, "no-example");
}

/// A stencil in inches that is taken for millimetres is traced 25 times too small: a person is asked.
#[test]
fn a_look_tells_size_and_whether_units_are_open() {
    let window = Window::new();
    let cube = b"v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 3\nf 1 2 3 4\nf 1 2 3\n";
    let path = window.file("cube.obj", cube);
    let seen = window.ask("look", file(&path));
    assert_eq!((&seen["seen"], &seen["asks_units"]), (&json!("stencil"), &json!(true)));
    assert_eq!(seen["size_mm"], json!([2.0, 1.0, 3.0]));
    let mut inches = file(&path);
    inches["design"]["units"] = json!("inch");
    let height = window.ask("look", inches)["size_mm"][2].as_f64().unwrap();
    assert!((height - 76.2).abs() < 1e-9, "{height}");
    // A drawing says its units.
    assert_eq!(window.ask("look", file(&example("hook.dxf")))["asks_units"], false);
    assert_eq!(window.ask("look", file(&path))["faces"], 2);
}

/// What is drawn is the surface of the file: a quad is two triangles.
#[test]
fn a_stencil_is_put_into_the_design_and_drawn_as_triangles() {
    let window = Window::new();
    window.ask("open-example", json!({"id": "house"}));
    assert!(window.workspace.stencil_mesh(0).is_empty());
    let path = window.file("quad.obj", b"v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 3\nf 1 2 3 4\nf 1 2 3\n");
    let put = window.ask("put-stencil", file(&path));
    assert_eq!(put["change"]["state"]["stencils"][0]["name"], "quad.obj");
    assert_eq!(put["change"]["state"]["undo"], "add stencil");
    let mesh = window.workspace.stencil_mesh(0);
    assert_eq!(triangles(&mesh), (4, 3));
    assert_eq!(mesh.len(), 8 + 4 * 12 + 3 * 12);
    let last: Vec<u32> =
        mesh[mesh.len() - 24..].chunks(4).map(|b| u32::from_le_bytes(b.try_into().unwrap())).collect();
    assert_eq!(last, [0, 2, 3, 0, 1, 2]);
    // It stays in what is saved, and goes with an undo.
    let saved = window.home.path().join("with.wirebend");
    window.ask("save", json!({"path": saved}));
    window.ask("undo", json!({}));
    assert!(window.workspace.stencil_mesh(0).is_empty());
    window.ask("open", file(&saved));
    assert_eq!(triangles(&window.workspace.stencil_mesh(0)), (4, 3));
    // Of a design whose stencil is in a file that is gone, it is that file which is reported.
    let mut naming: Value = serde_json::from_slice(&std::fs::read(&saved).unwrap()).unwrap();
    naming["stencils"][0]["surface"] = json!({"file": {"path": "gone.stl", "sha256": "0".repeat(64)}});
    let naming = window.file("naming.wirebend", naming.to_string().as_bytes());
    let refused = window.try_ask("put-stencil", file(&naming)).unwrap_err();
    assert!(refused.code == "stencil-missing" && refused.message.contains("gone.stl"), "{refused:?}");
    // Lines are no surface.
    assert_eq!(window.try_ask("put-stencil", file(&example("house.obj"))).unwrap_err().code, "no-surface");
}

/// A drawing comes beside the wire that is there, where it lies in its file, and goes with one undo.
#[test]
fn the_wireframe_of_a_file_is_added_to_the_design() {
    let window = Window::new();
    window.ask("open-example", json!({"id": "house"}));
    let before = window.ask("start", json!({}))["design"].take();
    let path = window.file("two.obj", b"v 0 0 500\nv 70 0 500\nv 70 50 500\nl 1 2 3\n");
    let put = window.ask("put-wireframe", file(&path));
    let change = &put["change"];
    let at: Vec<Value> =
        change["vertices"].as_array().unwrap().iter().map(|vertex| vertex["at_mm"].clone()).collect();
    assert_eq!(at, [json!([0.0, 0.0, 500.0]), json!([70.0, 0.0, 500.0]), json!([70.0, 50.0, 500.0])]);
    let ids: Vec<&Value> =
        change["vertices"].as_array().unwrap().iter().map(|vertex| &vertex["id"]).collect();
    let edges = change["edges"].as_array().unwrap().iter();
    let ends: Vec<[&Value; 2]> = edges.map(|edge| [&edge["a"], &edge["b"]]).collect();
    assert_eq!(ends, [[ids[0], ids[1]], [ids[1], ids[2]]]);
    assert_eq!(
        (change["gone_edges"].as_array().map(Vec::len), &change["state"]["undo"]),
        (Some(0), &json!("add two.obj"))
    );
    window.ask("undo", json!({}));
    let after = window.ask("start", json!({}))["design"].take();
    assert_eq!((&before["vertices"], &before["edges"]), (&after["vertices"], &after["edges"]));
}

/// The list of recent files is how most people open their work.
#[test]
fn what_was_opened_and_saved_is_remembered_once_and_last_first() {
    let window = Window::new();
    let (a, b) = (window.home.path().join("a.wirebend"), window.home.path().join("b.wirebend"));
    window.ask("open-example", json!({"id": "cube"}));
    window.ask("save", json!({"path": a}));
    window.ask("save", json!({"path": b}));
    window.ask("open", file(&a));
    std::fs::remove_file(&b).unwrap();
    let Window { home, .. } = window;
    let window = Window::at(home);
    let recent = window.ask("start", json!({}))["recent"].clone();
    let found: Vec<_> =
        recent.as_array().unwrap().iter().map(|entry| (&entry["name"], &entry["there"])).collect();
    assert_eq!(found, [(&json!("a.wirebend"), &json!(true)), (&json!("b.wirebend"), &json!(false))]);
    assert_eq!(window.ask("clear-recent", json!({}))["recent"], json!([]));
}

/// A program that is killed loses nothing but the drag in progress, and offers it at the next start.
#[test]
fn an_unsaved_design_is_offered_restored_or_thrown_away() {
    let home = tempfile::tempdir().unwrap();
    let told = Arc::new(Told::default());
    // It is leaked as a killed process leaves it, with its journal.
    let workspace = Box::leak(Box::new(Workspace::new(places(home.path()), told).unwrap()));
    workspace.ask_json(r#"{"ask": "open-example", "id": "cube"}"#).unwrap();
    let moved = r#"{"ask": "edit", "request": {"edit": "move", "vertices": [1], "by_mm": [0, 0, 2.5]}}"#;
    workspace.ask_json(moved).unwrap();
    let copy = tempfile::tempdir().unwrap();
    let (from, to) = (home.path().join("state/unsaved"), copy.path().join("state/unsaved"));
    std::fs::create_dir_all(&to).unwrap();
    for entry in std::fs::read_dir(from).unwrap() {
        let entry = entry.unwrap();
        std::fs::copy(entry.path(), to.join(format!("before-{}", entry.file_name().display()))).unwrap();
    }

    let window = Window::at(copy);
    let unsaved = window.ask("start", json!({}))["unsaved"].clone();
    assert_eq!((unsaved.as_array().unwrap().len(), &unsaved[0]["changes"]), (1, &json!(1)), "{unsaved}");
    assert_eq!(unsaved[0]["name"], "Cube", "as it was called, not as its file was");
    let restored = window.ask("restore", json!({"journal": unsaved[0]["journal"]}));
    let at = restored["design"]["vertices"][1]["at_mm"][2].as_f64().unwrap();
    assert!((at - 2.5).abs() < 1e-9, "{at}");
    assert_eq!(restored["design"]["state"]["undo"], "move vertex");
    window.ask("close", json!({}));
    assert_eq!(window.ask("start", json!({}))["unsaved"], json!([]));
    // Only what is offered is deleted.
    let file = window.file("mine.txt", b"mine");
    window.ask("discard", json!({"journal": file}));
    assert!(file.exists());
}

/// A user who says "do not save" does not want to be asked about it again at the next start.
#[test]
fn what_was_given_up_is_not_offered_again() {
    let window = Window::new();
    let journals = || std::fs::read_dir(window.home.path().join("state/unsaved")).unwrap().count();
    window.ask("open-example", json!({"id": "cube"}));
    window.ask("edit", json!({"request": {"edit": "move", "vertices": [1], "by_mm": [0, 0, 2.5]}}));
    for _ in 0..2 {
        let closed = window.ask("close", json!({}));
        assert_eq!(
            (&closed["design"]["edges"], &closed["design"]["state"]["changed"]),
            (&json!([]), &json!(false))
        );
        assert_eq!(journals(), 1, "that of the empty design");
    }
    window.workspace.leave();
    assert_eq!(journals(), 0);
    window.workspace.leave();
    // What the user was not asked about is kept.
    let window = Window::new();
    window.ask("open-example", json!({"id": "cube"}));
    window.ask("edit", json!({"request": {"edit": "move", "vertices": [1], "by_mm": [0, 0, 2.5]}}));
    window.workspace.leave();
    let Window { home, workspace, .. } = window;
    drop(workspace);
    assert_eq!(Window::at(home).ask("start", json!({}))["unsaved"][0]["changes"], 1);
}

/// A design of a machine that this computer does not know would keep its window open for ever.
#[test]
fn a_design_of_an_unknown_machine_can_be_closed() {
    let window = Window::new();
    let path = window.home.path().join("x.wirebend");
    window.ask("open-example", json!({"id": "cube"}));
    window.ask("save", json!({"path": path}));
    let text = std::fs::read_to_string(&path).unwrap();
    std::fs::write(&path, text.replacen("\"id\": \"wirebend-kit\"", "\"id\": \"of-a-friend\"", 1)).unwrap();
    let opened = window.ask("open", file(&path));
    assert_eq!(opened["design"]["state"]["machine"], "of-a-friend");
    assert_eq!(window.ask("close", json!({}))["design"]["state"]["machine"], "wirebend-kit");
}

/// A journal that cannot be deleted is no reason to say that a file was not opened when it was.
#[test]
fn a_design_is_opened_although_the_journal_before_cannot_be_deleted() {
    let window = Window::new();
    let folder = window.home.path().join("state/unsaved");
    for entry in std::fs::read_dir(&folder).unwrap() {
        let path = entry.unwrap().path();
        std::fs::remove_file(&path).unwrap();
        // A folder is not removed as a file is.
        std::fs::create_dir(&path).unwrap();
    }
    assert_eq!(window.ask("open-example", json!({"id": "cube"}))["design"]["state"]["name"], "Cube");
}

/// A window that does not come up because of a folder would keep a person from their files.
#[test]
fn a_state_folder_that_cannot_be_written_is_told_with_the_design() {
    let home = tempfile::tempdir().unwrap();
    std::fs::write(home.path().join("state"), "a file").unwrap();
    let started = Window::at(home).ask("start", json!({}));
    assert!(started["design"]["state"]["unkept"]["message"].as_str().unwrap().contains("state"), "{started}");
}

/// The window asks for collisions after each change, and again and again while it looks for them.
#[test]
fn collisions_are_found_beside_the_other_checks_and_stopping_when_nothing_runs_is_no_error() {
    let window = Window::new();
    window.ask("open-example", json!({"id": "house"}));
    let found = window.ask("collisions", json!({}));
    assert_eq!((&found["checked"], &found["stopped"]), (&true.into(), &false.into()));
    let contacts = found["contacts"].as_array().unwrap();
    assert_eq!(contacts[0]["finding"]["code"], "meets_machine");
    assert_eq!(window.ask("stop-collisions", json!({})), json!({}));
    assert_eq!(window.ask("collisions", json!({"moved": []}))["contacts"], found["contacts"]);
    for fix in window.ask("fixes", json!({"collisions": true}))["fixes"].as_array().unwrap() {
        assert_eq!(fix["mends"]["code"], "meets_machine");
    }
    let others = window.ask("fixes", json!({}))["fixes"].to_string();
    assert!(!others.contains("meets_machine"), "{others}");
}
