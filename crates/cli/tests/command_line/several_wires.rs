//! `--wires`: one design from several wires.

use serde_json::Value;

use crate::{assert_fits, example, run, run_in};

fn plan(design: &str, rest: &[&str]) -> crate::Ran {
    run(&[&["plan", &example(design), "-m", "wirebend-kit"], rest].concat())
}

/// A cube has 8 odd vertices, all of them next to each other: each wire leaves two of them, and each two others take one edge
/// of 30 mm.
#[test]
fn each_further_wire_of_a_cube_saves_an_edge() {
    let found = plan("cube.obj", &["--wires", "1..6", "--json"]).ended(0).json();
    assert_fits("wires", &found);
    let rows = found["rows"].as_array().unwrap();
    let figures: Vec<_> =
        rows.iter().map(|row| [&row["wires"], &row["doubled_edges"]].map(|n| n.as_u64().unwrap())).collect();
    assert_eq!(figures, [[1, 3], [2, 2], [3, 1], [4, 0]], "a fifth wire saves nothing");
    for row in rows {
        let figure = |key: &str| row[key].as_f64().unwrap();
        assert!((figure("doubled_mm") - 30.0 * figure("doubled_edges")).abs() < 1e-9);
        assert!((figure("length_mm") - figure("doubled_mm") - 12.0 * 30.0).abs() < 1e-9);
        assert!(figure("stock_cost") > figure("cost"), "each wire has a tail that cannot be fed");
    }
    let said = plan("cube.obj", &["--wires", "2..6"]).ended(0).err;
    assert!(said.lines().any(|line| line.starts_with("2      2        60.0 mm")), "{said}");
    assert!(!said.contains("\n1  "), "{said}");
}

/// What wires make twice is told of one of them each time: together it is what the row of so many wires says.
#[test]
fn what_wires_make_beside_each_other_is_told_of_one_of_them() {
    for (wires, of_all) in [("2", 2), ("3", 1)] {
        let found = plan("cube.obj", &["--wires", wires, "--double", "--json"]).ended(0).json();
        assert_fits("plan", &found);
        let routes: Vec<&Value> =
            found["wires"].as_array().unwrap().iter().map(|wire| &wire["route"]).collect();
        let told = |key: &str| routes.iter().map(|route| route[key].as_array().unwrap().len()).sum::<usize>();
        assert_eq!(told("doubled") + told("beside"), of_all);
        let mm = |key: &str| routes.iter().map(|route| route[key].as_f64().unwrap()).sum::<f64>();
        let more = mm("length_mm") - 12.0 * 30.0;
        assert!((mm("doubled_mm") + mm("beside_mm") - more).abs() < 1e-9, "{routes:?}");
    }
    let said = plan("cube.obj", &["--wires", "3", "--double"]).ended(0).err;
    let lines = |of: &str| said.lines().filter(|line| line.contains(of)).count();
    assert_eq!(
        (lines("1 edge beside a wire before it, 30.0 mm"), lines("the least possible")),
        (1, 0),
        "{said}"
    );
}

/// The first row is the doubling that other programs have found too.
#[test]
fn the_wires_of_a_mesh_share_what_is_doubled() {
    let found = plan("bunny.obj", &["--face-edges", "--wires", "1..3", "--json"]).ended(4).json();
    let rows = found["rows"].as_array().unwrap();
    assert_eq!((rows.len(), rows[0]["doubled_edges"].as_u64()), (3, Some(11)));
    assert!((rows[0]["length_mm"].as_f64().unwrap() - 11821.4).abs() < 0.1);
    let doubled: Vec<f64> = rows.iter().map(|row| row["doubled_mm"].as_f64().unwrap()).collect();
    assert!(doubled[0] > doubled[1] && doubled[1] > doubled[2], "{doubled:?}");
    assert!(doubled[0] - doubled[1] >= doubled[1] - doubled[2], "the second wire saves most: {doubled:?}");
}

#[test]
fn a_job_of_several_wires_is_made_and_bent() {
    let folder = tempfile::tempdir().unwrap();
    let run = |arguments: &[&str]| run_in(folder.path(), arguments, b"");
    let cube = example("cube.obj");
    let plan = ["plan", &cube, "-m", "wirebend-kit", "--wires", "4", "-o", "cube.wbjob", "--json"];
    let planned = run(&plan).ended(0).json();
    assert_fits("plan", &planned);
    let edges = planned["wires"]
        .as_array()
        .unwrap()
        .iter()
        .flat_map(|wire| wire["route"]["edges"].as_array().unwrap());
    let mut edges: Vec<u64> = edges.map(|edge| edge.as_u64().unwrap()).collect();
    edges.sort_unstable();
    assert_eq!(edges, (0..12).collect::<Vec<u64>>(), "every edge once");
    assert_eq!(
        run(&["simulate", "cube.wbjob", "--json"]).ended(0).json()["wires"].as_array().unwrap().len(),
        4
    );
    // Two wires are too few without doubled edges.
    let refused = run(&["check", &cube, "-m", "wirebend-kit", "--wires", "2"]).ended(4).err;
    assert!(refused.contains("needs more than 2 wires (8 odd corners)"), "{refused}");
    assert!(refused.contains("run the wire along 2 edges twice: that adds 60.0 mm"), "{refused}");
}

/// Two parts that do not touch need a wire each, and a third goes where it saves something.
#[test]
fn wires_are_shared_out_to_parts() {
    let folder = tempfile::tempdir().unwrap();
    // A line, and a star of four struts, of which one wire goes along two twice.
    let star = "v 0 0 0\nv 90 0 0\nv 200 0 0\nv 300 0 0\nv 200 50 0\nv 200 0 60\nv 130 0 0\nl 1 2\nl 3 4\nl 3 5\nl 3 6\nl 3 7\n";
    std::fs::write(folder.path().join("parts.obj"), star).unwrap();
    let wires = ["plan", "parts.obj", "-m", "wirebend-kit", "--wires", "1..6", "--json"];
    let found = run_in(folder.path(), &wires, b"").ended(0).json();
    let rows = found["rows"].as_array().unwrap();
    let figures: Vec<_> =
        rows.iter().map(|row| [&row["wires"], &row["doubled_edges"]].map(|n| n.as_u64().unwrap())).collect();
    assert_eq!(figures, [[2, 2], [3, 0]]);
}

/// What was accepted for one wire does not keep further ones from saving it.
#[test]
fn further_wires_save_what_was_accepted_for_one() {
    let folder = tempfile::tempdir().unwrap();
    let run = |arguments: &[&str]| run_in(folder.path(), arguments, b"");
    let cube = example("cube.obj");
    let planned = run(&["plan", &cube, "-m", "wirebend-kit", "--double", "--json"]).ended(0).json();
    run(&["import", &cube, "-o", "cube.wirebend"]).ended(0);
    let path = folder.path().join("cube.wirebend");
    let document = std::fs::read_to_string(&path).unwrap();
    let end = document.rfind('}').unwrap();
    let accepted = &planned["route"]["doubled"];
    std::fs::write(&path, format!("{}, \"doublings\": {accepted}}}", document[..end].trim_end())).unwrap();
    let plan = |rest: &[&str]| {
        run(&[&["plan", "cube.wirebend", "-m", "wirebend-kit", "--json"], rest].concat()).ended(0).json()
    };
    let found = plan(&["--wires", "1..6"]);
    let doubled = found["rows"].as_array().unwrap().iter().map(|row| row["doubled_edges"].as_u64().unwrap());
    assert_eq!(doubled.collect::<Vec<_>>(), [3, 2, 1, 0]);
    let four = plan(&["--wires", "4", "--double"]);
    let wires = four["wires"].as_array().unwrap_or_else(|| panic!("{four}"));
    assert_eq!((wires.len(), wires[0]["route"]["doubled_edges"].as_u64()), (4, Some(0)));
    let note = four["notes"].to_string();
    assert!(note.contains("3 accepted doublings add more length than so many wires need"), "{note}");
    // Without --double nothing was asked for instead of them.
    assert_eq!(plan(&["--wires", "4"])["route"]["doubled"], *accepted);
}

#[test]
fn numbers_of_wires_that_cannot_be_are_refused() {
    for (rest, words) in [
        (&["--wires", "0"][..], "expected a number of wires, at least 1"),
        (&["--wires", "3..2"], "expected a number of wires, at least 1"),
        (&["--wires", "many"], "expected a number of wires, at least 1"),
        (&["--wires", "2", "--closed"], "cannot be used with"),
        (&["--wires", "1..2", "-o", "cube.wbjob"], "give one number of wires"),
        (&["--wires", "1..2", "--compare", "pensa-diwire-pro"], "cannot be combined with --compare"),
    ] {
        let said = plan("cube.obj", rest).ended(2).err;
        assert!(said.contains(words), "{said}");
    }
    let cube = example("cube.obj");
    let said = run(&["check", &cube, "-m", "wirebend-kit", "--wires", "1..2"]).ended(2).err;
    assert!(said.contains("give one number of wires"), "{said}");
}

/// A wire that starts at such a corner does not bend beyond the limit there, and is longer by what is said: before there is a route as
/// with one.
#[test]
fn a_start_at_such_a_corner_adds_what_is_said() {
    let length = |found: &Value| found["route"]["length_mm"].as_f64().unwrap();
    let planned = |rest: &[&str]| {
        plan("bunny.obj", &[&["--face-edges", "--double", "--json"], rest].concat()).ended(4).json()
    };
    let routed = planned(&[]);
    let drawn =
        run(&["check", &example("bunny.obj"), "-m", "wirebend-kit", "--face-edges", "--json"]).ended(4);
    let sharp = |found: &Value| -> Vec<Value> {
        let all = found["diagnostics"].as_array().unwrap().iter();
        all.filter(|finding| finding["code"] == "bend_too_sharp").cloned().collect()
    };
    for found in [&routed, &drawn.json()] {
        let forced = sharp(found);
        let mut offered = 0;
        for bend in &forced {
            let remedies = bend["remedies"].as_array().unwrap();
            let Some(there) = remedies
                .iter()
                .find(|remedy| remedy["added_mm"].is_number() && remedy["remedy"] == "start_at_vertex")
            else {
                continue;
            };
            offered += 1;
            let vertex = &bend["vertex"];
            let started = planned(&["--start", &vertex.to_string()]);
            assert!(sharp(&started).iter().all(|other| other["vertex"] != *vertex), "{started}");
            let added = length(&started) - length(&routed);
            assert!(
                (there["added_mm"].as_f64().unwrap() - added).abs() < 1e-3,
                "{added} at {vertex}: {there}"
            );
        }
        assert_eq!((forced.len(), offered), (2, 2), "{forced:?}");
    }
}

/// Two corners of the bunny bend too far whatever follows what there.
#[test]
fn detours_lead_around_bends_that_no_route_avoids() {
    let sharp = |rest: &[&str]| {
        let arguments = [&["--face-edges", "--double", "--json"], rest].concat();
        let found = plan("bunny.obj", &arguments).ended(4).json();
        let all = found["diagnostics"].as_array().unwrap().clone();
        all.into_iter().filter(|diagnostic| diagnostic["code"] == "bend_too_sharp").collect::<Vec<_>>()
    };
    let forced = sharp(&[]);
    assert_eq!(forced.len(), 2);
    for bend in &forced {
        assert!(
            bend["message"].as_str().unwrap().ends_with("; no other order of the edges avoids it"),
            "{bend}"
        );
        let remedies = bend["remedies"].as_array().unwrap();
        assert!(remedies.iter().any(|remedy| remedy["remedy"] == "detour"), "{bend}");
    }
    assert_eq!(sharp(&["--detours"]).len(), 0);
}
