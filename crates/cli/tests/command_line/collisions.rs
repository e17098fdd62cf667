//! `--collisions`: where the wire hits the machine or itself.

use std::fs;

use crate::{example, run};

/// A wire in a plane, whose last straight part crosses the middle of its first.
const THROUGH_ITSELF: &str =
    "v 0 0 0\nv 100 0 0\nv 100 60 0\nv 50 60 0\nv 50 -40 0\nl 1 2\nl 2 3\nl 3 4\nl 4 5\n";

#[test]
fn a_wire_drawn_through_itself_cannot_be_bent() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("through.obj");
    fs::write(&file, THROUGH_ITSELF).unwrap();
    let file = file.to_str().unwrap();
    let check = |more: &[&str]| run(&[&["check", file, "-m", "table-bender", "--json"], more].concat());
    // What the finished part cannot be is said without them.
    let without = check(&[]).ended(4).json();
    assert_eq!(without["collisions_checked"], false);
    let said: Vec<_> = without["diagnostics"].as_array().unwrap().iter().map(|one| &one["code"]).collect();
    assert_eq!(said, ["edges_meet"]);
    let found = check(&["--collisions"]).ended(4).json();
    assert_eq!((&found["collisions_checked"], &found["feasible"]), (&true.into(), &false.into()));
    let all = found["diagnostics"].as_array().unwrap();
    let itself: Vec<_> = all.iter().filter(|one| one["code"] == "meets_stock").collect();
    let [one] = &itself[..] else { panic!("{all:?}") };
    // While the third corner is bent, the first straight part swings onto the wire that follows.
    assert_eq!(
        (&one["severity"], &one["step"], &one["edges"]),
        (&"error".into(), &2.into(), &serde_json::json!([0, 3]))
    );
    // Centreline on centreline they are into each other by the diameter of the wire, 3 mm.
    let depth = one["value"].as_f64().unwrap();
    assert!((depth - 3.0).abs() < 0.15, "{depth}");
}

/// Two struts that cross: no bender can make one wire go through another, whatever the machine and the route.
#[test]
fn crossing_struts_are_an_error_with_their_place_and_what_to_do() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("through.obj");
    let file_name = file.to_str().unwrap();
    let check = || run(&["check", file_name, "-m", "table-bender"]);
    fs::write(&file, THROUGH_ITSELF).unwrap();
    let said = check().ended(4).err;
    assert!(
        said.contains(
            "error[edges_meet]: edges 0 and 3 meet 50.0 mm from vertex 0: 0.0 mm from centre to centre"
        ),
        "{said}"
    );
    assert!(said.contains("limit from the diameter of the wire"), "{said}");
    assert!(said.contains("help: join them there with a vertex, or move the edges apart"), "{said}");
    // With 2 mm between them, of wire 3 mm thick, they press on each other; with 4 mm there is room.
    for (height, warnings) in [("2", 1), ("4", 0)] {
        let apart = THROUGH_ITSELF.replace("50 60 0", &format!("50 60 {height}"));
        fs::write(&file, apart.replace("50 -40 0", &format!("50 -40 {height}"))).unwrap();
        let said = check().ended(0).err;
        assert_eq!(said.matches("warning[edges_meet]").count(), warnings, "{said}");
    }
}

/// A strut that comes to lie beside the last one, 2 mm of wire of 3 mm apart: swung there through it, or from its own side, or by a
/// bend in a plane beside it, where it passes over it at the same distance.
#[test]
fn what_comes_too_close_presses_or_snaps_past_by_the_bend_that_brings_it_there() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("beside.obj");
    let said = |machine: &str, x: &str, start: &str| {
        let strut = format!("v {x} -80 0\nv {x} -20 0\nv {x} -20 60\n");
        let rest = "v 60 -20 60\nv 60 0 0\nv 0 0 0\nv 0 -100 0\nl 1 2 3 4 5 6 7\n";
        fs::write(&file, strut + rest).unwrap();
        run(&["check", file.to_str().unwrap(), "-m", machine, "--start", start]).err
    };
    let snaps = "in the bend of step 5 at vertex 5 one snaps past the other, and they press on each other from then on";
    for (machine, x, start, expected) in [
        ("table-bender", "-2", "0", snaps),
        // Pressed 10 degrees farther than it stays, it goes past and comes back.
        ("wirebend-kit", "2", "0", snaps),
        ("table-bender", "2", "0", "they press on each other from the bend of step 5 at vertex 5 on"),
        ("table-bender", "-2", "6", "they press on each other from the bend of step 5 at vertex 1 on"),
    ] {
        let said = said(machine, x, start);
        assert!(
            said.contains("warning[edges_meet]") && said.contains(expected),
            "{machine}, {x} from {start}: {said}"
        );
    }
}

#[test]
fn a_body_that_is_only_estimated_is_a_warning_that_says_so() {
    let said = run(&["check", &example("house.obj"), "-m", "wirebend-kit", "--collisions"]).ended(0);
    assert!(
        said.err.contains("warning[meets_machine]") && said.err.contains("its dimensions are estimates"),
        "{}",
        said.err
    );
    assert!(said.err.contains("[wirebend-kit, shapes: head]"), "{}", said.err);
    assert!(!said.err.contains("collisions not checked"), "{}", said.err);
    let without = run(&["check", &example("house.obj"), "-m", "wirebend-kit"]).ended(0);
    assert!(without.err.contains("collisions not checked") && !without.err.contains("meets_machine"));
}

/// Straight parts that pass each other 4 mm from centre to centre, of wire 3 mm thick, have 1 mm between them.
#[test]
fn what_comes_nearer_than_the_clearance_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("passing.obj");
    let passing = THROUGH_ITSELF.replace("50 60 0", "50 60 4").replace("50 -40 0", "50 -40 4");
    fs::write(&file, passing).unwrap();
    let check =
        |more: &[&str]| run(&[&["check", file.to_str().unwrap(), "-m", "table-bender"], more].concat());
    for enough in [&["--collisions"][..], &["--collisions", "--clearance", "0.9"]] {
        let said = check(enough).ended(0).err;
        assert!(!said.contains("meets_stock"), "{said}");
    }
    let said = check(&["--collisions", "--clearance", "2"]).ended(0).err;
    let words = "warning[meets_stock]: step 3: the wire of edge 0 comes near the wire that is still to be bent when step 3";
    assert!(said.contains(words), "{said}");
    // A script that sorts by how deep it is would take the nearest for the deepest: how far they are apart does not depend on how
    // far they have to be.
    for clearance in ["2", "3"] {
        let found = check(&["--collisions", "--clearance", clearance, "--json"]).ended(0).json();
        let all = found["diagnostics"].as_array().unwrap();
        let near = all.iter().find(|one| one["code"] == "meets_stock").unwrap();
        assert!((near["value"].as_f64().unwrap() + 1.0).abs() < 0.1, "{near}");
    }
    for wrong in ["-1", "nan", "inf"] {
        let said = check(&["--collisions", "--clearance", wrong]).ended(2).err;
        assert!(
            said.contains("error: the clearance is ") && said.contains("expected zero or more"),
            "{said}"
        );
        assert!(said.contains("help: correct --clearance"), "{said}");
    }
    assert!(check(&["--clearance", "1"]).ended(2).err.contains("--collisions"));
}

#[test]
fn a_job_is_exported_as_it_was_planned() {
    let folder = tempfile::tempdir().unwrap();
    let job = folder.path().join("house.wbjob");
    let job = job.to_str().unwrap();
    run(&["plan", &example("house.obj"), "-m", "wirebend-kit", "-o", job]).ended(0);
    let refused = run(&["export", job, "--format", "svg", "-o", "-", "--collisions"]);
    assert!(refused.err.contains("--collisions"), "{}", refused.err);
    let refused = run(&["export", job, "--format", "svg", "-o", "-", "--collisions", "--clearance", "1"]).err;
    assert!(refused.contains("--collisions") && refused.contains("--clearance"), "{refused}");
}

/// What hits the head as it comes is bent another way round; the job that is written hits nothing.
#[test]
fn a_program_without_collisions_is_searched_for_and_written() {
    let folder = tempfile::tempdir().unwrap();
    let job = folder.path().join("house.wbjob");
    let job = job.to_str().unwrap();
    let search =
        ["plan", &example("house.obj"), "-m", "wirebend-kit", "--avoid-collisions", "--json", "-o", job];
    let found = run(&search).ended(0).json();
    assert_eq!((&found["search"]["found"], &found["collisions_checked"]), (&true.into(), &true.into()));
    assert_eq!(found["diagnostics"], serde_json::json!([]));
    // Every edge once, as without a search: six of them, 292 mm together.
    assert_eq!(found["route"]["feeds"], 6);
    let length = found["route"]["length_mm"].as_f64().unwrap();
    assert!((length - 292.0).abs() < 0.1, "{length}");
    // The job makes the design: without errors no vertex is off by more than arithmetic.
    let made = run(&["simulate", job, "--json"]).ended(0).json();
    let vertices = made["wires"][0]["vertices"].as_array().unwrap();
    assert_eq!(vertices.len(), 7);
    for vertex in vertices {
        assert!(vertex["mean_mm"].as_f64().unwrap() < 1e-6, "{vertex}");
    }
}

/// A script that takes what is written would bend what hits something.
#[test]
fn a_search_without_success_says_what_is_in_the_way_and_writes_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let job = folder.path().join("cup.wbjob");
    let cup = example("cup-holder.obj");
    let plan = |more: &[&str]| {
        let search = ["plan", &cup, "-m", "wirebend-kit", "--avoid-collisions", "-o", job.to_str().unwrap()];
        run(&[&search[..], more].concat())
    };
    let said = plan(&["--wires", "1"]).ended(4).err;
    assert!(said.contains("error[no_clear_program]"), "{said}");
    assert!(said.contains("every walk of one wire was tried"), "{said}");
    // It was searched for, so that it is not proposed again.
    assert!(!said.contains("--avoid-collisions"), "{said}");
    assert!(said.contains("no job was written: none without a collision was found"), "{said}");
    assert!(!job.exists());
    let json = plan(&["--wires", "1", "--json"]).ended(4).json();
    assert_eq!((&json["withheld"], &json["feasible"]), (&true.into(), &false.into()));
    // What helps is said as facts, too, and each help with the walks that it was tried with.
    let found = json["diagnostics"].as_array().unwrap().iter().find(|one| one["code"] == "no_clear_program");
    let found = &found.unwrap();
    let search = &found["search"];
    assert_eq!(
        (&search["obstacle"], &search["passed"], &search["of"]),
        (&"body".into(), &11.into(), &11.into())
    );
    assert_eq!((&search["ended"], &search["exhausted"]), (&false.into(), &true.into()));
    let helps = search["helps"].as_array().unwrap();
    let wires = helps.iter().find(|help| help["help"] == "more-wires").unwrap()["walks"].as_array().unwrap();
    let ends: Vec<String> =
        wires.iter().map(|walk| format!("from vertex {} to vertex {}", walk["from"], walk["to"])).collect();
    assert_eq!(ends.len(), 2);
    let words = format!("2 wires hit nothing, {}", ends.join(", "));
    assert!(found["message"].as_str().unwrap().contains(&words), "{found}");
    // Who has read it may have it, and the job says with what.
    let despite = plan(&["--wires", "1", "--despite-errors"]).ended(4).err;
    assert!(despite.contains("wrote") && job.exists(), "{despite}");

    // So many wires are allowed, whether or not they save something that is doubled.
    for wires in [&["--wires", "2"][..], &[]] {
        let wires = plan(&[wires, &["--json", "--force"]].concat()).ended(0).json();
        let wires = wires["wires"].as_array().unwrap();
        assert_eq!(wires.len(), 2);
        // Both were found by one search: told twice it would be taken for two.
        assert_eq!((&wires[0]["search"]["found"], wires[1].get("search")), (&true.into(), None));
    }
}

/// Who compares numbers of wires sees with which of them nothing is hit, and why a number has no row.
#[test]
fn a_table_of_wires_says_which_hit_nothing_and_which_have_no_row() {
    let table = |more: &[&str]| {
        run(&[&["plan", &example("cup-holder.obj"), "-m", "wirebend-kit"], more].concat()).ended(0)
    };
    let search = ["--avoid-collisions", "--wires", "1..4"];
    let said = table(&search).err;
    let lines: Vec<&str> = said.lines().filter(|line| !line.starts_with("note: ")).collect();
    assert!(lines[0].ends_with("collisions    program without"), "{said}");
    assert!(lines[1].starts_with("1 ") && lines[1].ends_with("1, estimated  not found"), "{said}");
    assert!(lines[2].starts_with("2 ") && lines[2].ends_with("none          found"), "{said}");
    assert_eq!(lines[3], "3 to 4 wires: no row, 2 are enough for a program without collisions");
    let json = table(&[&search[..], &["--json"]].concat()).json();
    assert_eq!(
        json["left_out"],
        serde_json::json!([{"from": 3, "to": 4, "reason": "not-needed", "enough": 2}])
    );
    let found: Vec<_> = json["rows"].as_array().unwrap().iter().map(|row| &row["search"]["found"]).collect();
    assert_eq!(found, [false, true]);
    let plain = table(&["--wires", "1..4"]).err;
    assert!(!plain.contains("collisions"), "{plain}");
    assert!(plain.ends_with("2 to 4 wires: no row, 1 is enough, more save no doubled length\n"), "{plain}");
}

/// Who sets weights, or none, reads by what the program was chosen.
#[test]
fn the_weights_of_a_search_are_told_and_refused_where_they_say_nothing() {
    let search = |more: &[&str]| {
        run(&[&["plan", &example("house.obj"), "-m", "wirebend-kit", "--avoid-collisions"], more].concat())
    };
    let usual = search(&[]).ended(0).err;
    assert!(
        usual.contains("  prefers     fewest wires, then the least doubled length, then the least time\n"),
        "{usual}"
    );
    assert_eq!(search(&["--json"]).ended(0).json()["search"]["weights"], serde_json::Value::Null);
    let weights = ["--effort", "500", "--weights", "wires=1000, time=5"];
    let weighed = search(&weights).ended(0).err;
    assert!(
        weighed.contains("  prefers     the least sum of 1000 for each wire, 5 for each second\n"),
        "{weighed}"
    );
    let weighed = search(&[&weights[..], &["--json"]].concat()).ended(0).json();
    assert_eq!(weighed["search"]["weights"], serde_json::json!({"wire": 1000, "doubled_mm": 0, "second": 5}));
    for (wrong, said) in [
        ("wires", "'wires' has no weight"),
        ("wires=-1", "'-1' is no whole number"),
        ("price=2", "'price' has no weight"),
        ("time=0", "all of them are 0"),
    ] {
        let refused = search(&["--weights", wrong]).ended(2).err;
        assert!(
            refused.contains(said) && refused.contains("such as wires=1000,doubled=1,time=5"),
            "{refused}"
        );
    }
    let alone = ["plan", &example("house.obj"), "-m", "wirebend-kit", "--weights", "time=1"];
    assert!(run(&alone).ended(2).err.contains("--avoid-collisions"));
}

#[test]
fn a_search_has_steps_to_check() {
    let search = ["plan", &example("house.obj"), "-m", "wirebend-kit", "--avoid-collisions", "--effort", "0"];
    run(&search).ended(2);
    run(&["plan", &example("house.obj"), "-m", "wirebend-kit", "--effort", "5"]).ended(2);
}

/// A table has no place for the side of a bend: without a word a machine that reads it would hit what the search went around.
#[test]
fn a_table_says_what_of_a_searched_program_it_cannot_say() {
    let folder = tempfile::tempdir().unwrap();
    let file = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let job = file("cup.wbjob");
    let plan = ["plan", &example("cup-holder.obj"), "-m", "wirebend-kit", "-o", &job];
    run(&[&plan[..], &["--avoid-collisions"]].concat()).ended(0);
    let export = |job: &str, format: &str| {
        let out = file(&format!("{format}.txt"));
        run(&["export", job, "--format", format, "-o", &out, "--force", "--json"]).ended(0).json()
    };
    let notes = |found: &serde_json::Value| -> Vec<serde_json::Value> {
        let all = found["notes"].as_array().unwrap().iter();
        all.filter(|note| note["code"] == "not-carried").cloned().collect()
    };
    // The machine's own program has the sides: bends below zero.
    let own = export(&job, "wirebend-kit-text");
    assert!(notes(&own).is_empty());
    let programs = own["files"].as_array().unwrap().iter();
    let programs: Vec<String> =
        programs.map(|file| fs::read_to_string(file.as_str().unwrap()).unwrap()).collect();
    let flipped =
        programs.iter().flat_map(|text| text.lines()).filter(|line| line.starts_with("B -")).count();
    assert!(flipped > 0, "{programs:?}");
    for format in ["lra-csv", "ybc-csv", "xyz-csv", "cumulative-csv"] {
        let notes = notes(&export(&job, format));
        let [note] = &notes[..] else { panic!("{format}: {notes:?}") };
        let message = note["message"].as_str().unwrap();
        assert!(message.contains(format) && message.contains(&format!("{flipped} bend")), "{message}");
        assert_eq!(
            note["remedies"],
            serde_json::json!([{"remedy": "export-format", "format": "wirebend-kit-text"}, {"remedy": "watch-first-wire"}])
        );
    }
    // Planned without regard to collisions it relies on nothing that a table leaves out.
    run(&[&plan[..], &["--force"]].concat()).ended(0);
    assert!(notes(&export(&job, "lra-csv")).is_empty());
    let table = run(&[
        "export",
        &example("cup-holder.obj"),
        "-m",
        "table-bender",
        "--avoid-collisions",
        "--format",
        "lra-csv",
        "-o",
        &file("x.csv"),
    ]);
    let said = table.err;
    assert!(!said.contains("--format"), "it has no program of its own: {said}");
}
