//! Wrong files: each is refused with its name, where in it and what to do, and nothing panics.

use crate::run_in;

/// File name, contents, and what the message has to say beside the name.
fn wrong_files() -> Vec<(&'static str, Vec<u8>, &'static str)> {
    let text = |text: &str| text.as_bytes().to_vec();
    let stl_of_billions = [&[b' '; 80][..], &u32::MAX.to_le_bytes(), &[0; 50]].concat();
    vec![
        ("empty.obj", text(""), ""),
        ("noise.obj", (0..4096_u32).map(|k| ((k * 7919) >> 3).to_le_bytes()[0]).collect(), ""),
        ("index.obj", text("v 0 0 0\nv 1 0 0\nl 1 3\n"), "3"),
        ("zero.obj", text("v 0 0 0\nv 1 0 0\nl 0 1\n"), "3"),
        ("nan.obj", text("v 0 0 0\nv nan 0 0\nl 1 2\n"), "2"),
        ("infinite.obj", text("v 0 0 0\nv 1e999 0 0\nl 1 2\n"), "2"),
        ("short.obj", text("v 0 0\nv 1 0 0\nl 1 2\n"), "1"),
        ("word.obj", text("v 0 0 0\nv 1 zero 0\nl 1 2\n"), "2"),
        ("far.obj", text("v 0 0 0\nv 1e9 0 0\nl 1 2\n"), ""),
        ("billions.stl", stl_of_billions, ""),
        (
            "truncated.ply",
            text("ply\nformat ascii 1.0\nelement vertex 9\nproperty float x\nend_header\n1\n"),
            "",
        ),
        (
            "huge.ply",
            text("ply\nformat ascii 1.0\nelement vertex 4000000000\nproperty float x\nend_header\n"),
            "",
        ),
        ("letters.csv", text("0,0,0\n1,b,0\n"), "2"),
        ("one.csv", text("x,y,z\n1,2,3\n"), ""),
        ("broken.json", text("{\"node_list\": [}"), "1"),
        ("other.json", text("{\"recipes\": []}"), ""),
        ("index.pwf", text("v 0 0 0\nv 10 0 0\nl 1 7\n"), "3"),
        ("manual.txt", text("FEED 10\nRotate wire 108 degrees\nFEED 10\n"), "2"),
        ("letters.txt", text("F 10.0\nB ninety\nF 10.0\n"), "2"),
        ("newer.wirebend", text("{\"format\": \"wirebend\", \"version\": 99}"), "99"),
        ("not.wirebend", text("{\"format\": \"wirebend\", \"version\": 1, \"vertices\": 3}"), ""),
        ("cut.wbjob", text("{\"format\": \"wbjob\", \"version\": 1"), ""),
        ("picture.png", b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR".to_vec(), ""),
    ]
}

#[test]
fn wrong_files_are_refused_by_name_and_place() {
    let folder = tempfile::tempdir().unwrap();
    for (name, contents, place) in wrong_files() {
        std::fs::write(folder.path().join(name), contents).unwrap();
        let command = if name == "cut.wbjob" { "simulate" } else { "plan" };
        let mut arguments = vec![command, name];
        if command == "plan" {
            arguments.extend(["--machine", "wirebend-kit"]);
        }
        let ran = run_in(folder.path(), &arguments, b"").ended(3);
        assert!(ran.err.contains(name), "{name} is not named: {}", ran.err);
        assert!(ran.err.contains(place), "{name}: {place} is not in: {}", ran.err);
        assert!(!ran.err.contains("panicked"), "{name}: {}", ran.err);
    }
}

/// A job that was cut off while it was copied, whichever command meets it.
#[test]
fn an_empty_document_is_bad_input_and_says_what_it_should_be() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("empty.wbjob"), "").unwrap();
    std::fs::write(folder.path().join("blank.wirebend"), " \n").unwrap();
    std::fs::write(folder.path().join("empty.txt"), "").unwrap();
    std::fs::write(folder.path().join("empty.stl"), "").unwrap();
    let machine = ["--machine", "wirebend-kit"];
    for (arguments, expected) in [
        (["simulate", "empty.wbjob"].as_slice(), "expected a WireBend job"),
        (&["simulate", "-"], "expected a WireBend job"),
        (&["export", "empty.wbjob", "-o", "out.svg"], "expected a WireBend job"),
        (&["run", "empty.wbjob", "--port", "sim"], "expected a WireBend job"),
        (&[&["plan", "empty.wbjob"], machine.as_slice()].concat(), "expected a WireBend job"),
        (&[&["plan", "blank.wirebend"], machine.as_slice()].concat(), "expected a WireBend project"),
        (&["import", "empty.txt"], "empty.txt: the file is empty"),
        (&["import", "empty.stl"], "empty.stl: the file is empty"),
        (&["import", "-"], "standard input: the file is empty"),
    ] {
        let ran = run_in(folder.path(), arguments, b"").ended(3);
        assert!(ran.err.contains(expected), "{arguments:?}: {}", ran.err);
    }
}

#[test]
fn a_surface_without_lines_says_how_to_get_some() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("face.obj"), "v 0 0 0\nv 40 0 0\nv 0 40 0\nf 1 2 3\n").unwrap();
    let ran = run_in(folder.path(), &["plan", "face.obj", "--machine", "wirebend-kit"], b"").ended(3);
    assert!(ran.err.contains("--face-edges"), "{}", ran.err);
    run_in(folder.path(), &["plan", "face.obj", "--face-edges", "--machine", "wirebend-kit"], b"").ended(0);
    // A document is taken as it is, and refuses the option.
    let run = |arguments: &[&str]| run_in(folder.path(), arguments, b"");
    run(&["import", "face.obj", "-o", "face.wirebend"]).ended(0);
    for command in [
        &["plan", "face.wirebend", "-m", "wirebend-kit"][..],
        &["check", "face.wirebend"],
        &["frame", "face.wirebend", "--material", "steel-1mm"],
        &["sequence", "face.wirebend", "--machine", "framefab-extruder"],
    ] {
        let said = run(command).ended(3).err;
        assert!(said.contains("help: import its model again with --face-edges"), "{command:?}: {said}");
    }
    let said = run(&["import", "face.wirebend", "-o", "again.wirebend"]).ended(0).err;
    assert!(said.contains("help: import its model again with --face-edges"), "{said}");
}

/// There are no faces whose edges could be taken.
#[test]
fn nothing_at_all_is_not_answered_with_the_edges_of_faces() {
    let folder = tempfile::tempdir().unwrap();
    let empty = r#"{"format": "wirebend", "version": 1, "wireframe": {"next_vertex": 1, "next_edge": 0,
        "vertices": [{"id": 0, "at_mm": [0, 0, 0]}], "edges": []}}"#;
    std::fs::write(folder.path().join("empty.wirebend"), empty).unwrap();
    for command in [
        &["plan", "empty.wirebend", "-m", "wirebend-kit"][..],
        &["check", "empty.wirebend"],
        &["frame", "empty.wirebend", "--material", "steel-1mm"],
        &["sequence", "empty.wirebend", "--machine", "framefab-extruder"],
    ] {
        let said = run_in(folder.path(), command, b"").ended(4).err;
        assert!(said.contains("draw edges") && !said.contains("faces"), "{command:?}: {said}");
    }
}

#[test]
fn a_folder_is_no_file() {
    let folder = tempfile::tempdir().unwrap();
    let ran = run_in(folder.path(), &["plan", ".", "--machine", "wirebend-kit"], b"").ended(3);
    assert!(!ran.err.contains("panicked"), "{}", ran.err);
}

/// Whoever gives an option believes that it has done something.
#[test]
fn options_that_say_nothing_of_a_format_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    for (name, contents) in [
        ("a.obj", "v 0 0 0\nv 40 0 0\nl 1 2\n"),
        ("a.csv", "x,y,z\n0,0,0\n40,0,0\n"),
        ("a.txt", "F 40.0\nB 90.0\nF 40.0\n"),
    ] {
        std::fs::write(folder.path().join(name), contents).unwrap();
    }
    for (name, option, value) in [
        ("a.obj", "--clr", Some("3")),
        ("a.obj", "--handedness", Some("left")),
        ("a.obj", "--program", Some("nominal")),
        ("a.obj", "--tolerance", Some("0.2")),
        ("a.obj", "--shortest-edge", Some("20")),
        ("a.csv", "--face-edges", None),
        ("a.txt", "--handedness", Some("left")),
    ] {
        let arguments: Vec<&str> = ["import", name, option].into_iter().chain(value).collect();
        let ran = run_in(folder.path(), &arguments, b"").ended(2);
        assert!(ran.err.contains("no effect") && ran.err.contains(option), "{arguments:?}: {}", ran.err);
    }
    run_in(folder.path(), &["import", "a.obj", "--face-edges", "-o", "a.wirebend"], b"").ended(0);
}
