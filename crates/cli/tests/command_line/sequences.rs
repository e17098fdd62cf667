//! `sequence`: frames that are built strut by strut, sequences that are checked, and input that is none.

use serde_json::{Value, json};
use wirebend_tests_brute::Step;

use crate::frame_files::jointed;
use crate::sequences_confirmed::{on_supports, task};
use crate::{Ran, assert_fits, root, run, run_in};

/// A file that a reader is tested with.
fn data(name: &str) -> String {
    root().join("crates/files/tests/data").join(name).display().to_string()
}

fn sequence(file: &str, rest: &[&str]) -> Ran {
    run(&[&["sequence", &data(file), "--machine", "framefab-extruder", "--json"], rest].concat())
}

fn codes(found: &Value) -> Vec<&str> {
    found["diagnostics"].as_array().unwrap().iter().map(|finding| finding["code"].as_str().unwrap()).collect()
}

/// 155 of 178 steps share a vertex in the sequence of an independent search; the sag is that of three other programs, under standard
/// gravity.
#[test]
fn the_bunny_of_framefab_is_built() {
    let found = sequence("framefab/bunny0507_.pwf", &["--layers"]).ended(0).json();
    assert_fits("sequence", &found);
    assert_eq!((&found["feasible"], &found["proved"]), (&json!(true), &json!(true)));
    let steps = found["steps"].as_array().unwrap();
    assert_eq!(steps.len(), 179);
    assert_eq!(steps.iter().filter(|step| step["type"] == "ground").count(), 12);
    assert!(steps[..12].iter().all(|step| step["direction"] == json!([0.0, 0.0, 1.0])), "pillars from above");
    let sag = found["max_displacement_mm"].as_f64().unwrap();
    assert!((sag - 0.427_187 * 9.80665 / 9.80633).abs() < 1e-5, "{sag}");
    assert_eq!((&found["sharing"], &found["epsilon_mm"]), (&json!(155), &json!(0.65)));
    let layered: usize =
        found["layers"].as_array().unwrap().iter().map(|layer| layer.as_array().unwrap().len()).sum();
    assert_eq!(layered, 179, "every strut is in one layer");
}

/// The authors' own sequence can be built, each step in one of its published directions; 137 of the 166 steps after its first strut
/// share a vertex with the one before, which is their figure.
#[test]
fn the_published_sequence_of_the_bunny_is_checked() {
    let file = data("framefab/bunny_result.json");
    let found = sequence("framefab/bunny0507_.pwf", &["--check", &file]).ended(0).json();
    assert_eq!((&found["feasible"], &found["sharing"]), (&json!(true), &json!(137)));
    assert_eq!(found["steps"].as_array().unwrap().len(), 179);
    let folder = tempfile::tempdir().unwrap();
    let task = task(folder.path(), &data("framefab/bunny0507_.pwf"));
    assert_eq!(task.faults(&Step::printed(&found)), []);
}

/// The four struts hang on one pillar where it alone stands on the ground; the other goes down to where there is none.
#[test]
fn supports_of_the_command_line_are_the_ground() {
    let frame = "assembly-instances/four-frame.json";
    let first_types = |found: &Value| -> Vec<String> {
        let steps = found["steps"].as_array().unwrap().iter();
        steps.map(|step| step["type"].as_str().unwrap().to_owned()).collect()
    };
    let drawn = sequence(frame, &[]).ended(0).json();
    let same = sequence(frame, &["--supports", "design"]).ended(0).json();
    assert_eq!(drawn["steps"], same["steps"]);
    let grounds = |found: &Value| first_types(found).iter().filter(|kind| *kind == "ground").count();
    assert_eq!(grounds(&drawn), 2);
    let on_one = sequence(frame, &["--supports", "0"]).ended(0).json();
    assert_eq!((grounds(&on_one), &on_one["steps"][0]["from_vertex"]), (1, &json!(0)));
    let sag = |found: &Value| found["max_displacement_mm"].as_f64().unwrap();
    assert!(sag(&on_one) > sag(&drawn), "{} mm on one pillar, {} mm on two", sag(&on_one), sag(&drawn));

    let floats = sequence(frame, &["--supports", "free"]).ended(4).json();
    assert_eq!(codes(&floats), ["frame_unsupported"]);
    let named = |found: &Value| {
        found["notes"].as_array().unwrap().iter().map(|note| note["code"].clone()).collect::<Vec<_>>()
    };
    assert!(!named(&drawn).contains(&json!("support-unused")), "{drawn}");
    let missing = sequence(frame, &["--supports", "0,77"]).ended(3);
    assert_eq!(missing.json()["error"]["code"], "no-vertex");
    sequence(frame, &["--supports", "0;1"]).ended(2);
}

#[test]
fn a_sequence_that_was_written_is_checked_and_a_spoilt_one_refused() {
    let folder = tempfile::tempdir().unwrap();
    let frame = data("assembly-instances/simple_frame.json");
    let ask = |rest: &[&str]| {
        run_in(folder.path(), &[&["sequence", &frame, "--machine", "framefab-extruder"], rest].concat(), b"")
    };
    ask(&["-o", "order.json"]).ended(0);
    ask(&["-o", "order.json"]).ended(2);
    let checked = ask(&["--check", "order.json", "--json"]).ended(0).json();
    assert_fits("sequence", &checked);
    assert_eq!((&checked["feasible"], checked["steps"].as_array().unwrap().len()), (&json!(true), 19));

    // What other programs read says the same.
    ask(&["-o", "framefab.json", "-f", "framefab"]).ended(0);
    let framefab = ask(&["--check", "framefab.json", "--json"]).ended(0).json();
    assert_eq!(framefab["max_displacement_mm"], checked["max_displacement_mm"]);
    ask(&["-o", "instances.json", "-f", "assembly-instances"]).ended(0);
    let again = ["sequence", "instances.json", "--machine", "framefab-extruder", "--json"];
    assert_eq!(run_in(folder.path(), &again, b"").ended(0).json()["feasible"], json!(true));
    let written: Value =
        serde_json::from_slice(&std::fs::read(folder.path().join("instances.json")).unwrap()).unwrap();
    let elements = written["element_list"].as_array().unwrap();
    let steps = checked["steps"].as_array().unwrap();
    assert_eq!(elements.len(), steps.len());
    for (element, step) in elements.iter().zip(steps) {
        let ends = element["end_node_ids"].as_array().unwrap();
        assert!(ends.contains(&step["from_vertex"]), "{element} is not built from {}", step["from_vertex"]);
    }

    // What each step is, is found out where the file does not say it.
    let mut untyped: Value =
        serde_json::from_slice(&std::fs::read(folder.path().join("order.json")).unwrap()).unwrap();
    for step in untyped["steps"].as_array_mut().unwrap() {
        step.as_object_mut().unwrap().remove("type");
    }
    std::fs::write(folder.path().join("untyped.json"), untyped.to_string()).unwrap();
    let types = |found: &Value| -> Vec<Value> {
        found["steps"].as_array().unwrap().iter().map(|step| step["type"].clone()).collect()
    };
    let again = ask(&["--check", "untyped.json", "--json"]).ended(0).json();
    assert_eq!(types(&again), types(&checked));
    assert!(types(&again).contains(&json!("create")) && types(&again).contains(&json!("connect")));

    let path = folder.path().join("order.json");
    let mut spoilt: Value = serde_json::from_slice(&std::fs::read(&path).unwrap()).unwrap();
    let steps = spoilt["steps"].as_array_mut().unwrap();
    steps.reverse();
    steps.pop();
    std::fs::write(folder.path().join("spoilt.json"), spoilt.to_string()).unwrap();
    let refused = ask(&["--check", "spoilt.json", "--json"]).ended(4).json();
    assert_eq!(refused["feasible"], json!(false));
    for code in ["strut_floating", "sequence_wrong"] {
        assert!(codes(&refused).contains(&code), "{code}: {refused}");
    }
    let told = ask(&["--check", "spoilt.json"]).ended(4).err;
    assert!(told.contains("error[strut_floating]: step 1: "), "{told}");
    assert!(told.contains("1 edge is never built"), "{told}");
}

/// How far some frames may sag here, mm: they are soft, and that is not what they are for.
const EPSILON_MM: f64 = 20.0;

/// What stands at the end is the whole frame: held as its file says, with joints that weigh what the design says.
#[test]
fn the_last_step_sags_as_the_frame_does() {
    let folder = tempfile::tempdir().unwrap();
    // One leg is held altogether, the other rests on the ground.
    let node = |id: u32, [x, y, z]: [f64; 3], fixities: &[u8]| {
        let point = json!({ "X": x, "Y": y, "Z": z });
        json!({ "node_id": id, "point": point, "is_grounded": u8::from(!fixities.is_empty()), "fixities": fixities })
    };
    let legs = json!({
        "unit": "millimeter",
        "node_list": [
            node(0, [0.0; 3], &[1, 1, 1, 1, 1, 1]),
            node(1, [60.0, 0.0, 0.0], &[0, 0, 1, 0, 0, 0]),
            node(2, [30.0, 0.0, 50.0], &[]),
        ],
        "element_list": [{ "end_node_ids": [1, 2] }, { "end_node_ids": [0, 2] }],
    });
    std::fs::write(folder.path().join("legs.json"), legs.to_string()).unwrap();
    // The same as a design of its own.
    run_in(folder.path(), &["import", "legs.json", "-o", "legs.wirebend"], b"").ended(0);
    let jointed = jointed(folder.path());
    let simple = data("assembly-instances/simple_frame.json");
    let material = ["--material", "abs-1-5mm", "--json"];
    let epsilon = EPSILON_MM.to_string();
    let build = ["--machine", "framefab-extruder", "--epsilon", &epsilon];
    let mut wholes = Vec::new();
    for file in ["legs.json", "legs.wirebend", &jointed, &simple] {
        let run = |arguments: &[&str]| {
            run_in(folder.path(), &[arguments, &material[..]].concat(), b"").ended(0).json()
        };
        let whole = run(&["frame", file])["static"]["max_displacement_mm"].as_f64().unwrap();
        let written = ["-o", "built.json", "-f", "assembly-instances", "--force"];
        let found = run(&[&["sequence", file], &build[..], &written].concat());
        let last =
            found["steps"].as_array().unwrap().last().unwrap()["max_displacement_mm"].as_f64().unwrap();
        assert!((last - whole).abs() <= 1e-9 * whole, "{file}: {last} instead of {whole}");
        let (mut task, steps) = (task(folder.path(), file), Step::printed(&found));
        task.machine.max_sag_mm = EPSILON_MM;
        assert_eq!(task.faults(&steps), [], "{file}");
        let brute = task.sags(&steps).pop().unwrap();
        assert!((last - brute).abs() <= 1e-9 * brute, "{file}: {last} instead of {brute}");
        // The file that is written holds its supports as the design does.
        if file != jointed {
            let again = run(&["frame", "built.json"])["static"]["max_displacement_mm"].as_f64().unwrap();
            assert!((again - whole).abs() <= 1e-9 * whole, "{file}: {again} instead of {whole}");
        }
        wholes.push(whole);
    }
    assert!((wholes[0] - wholes[1]).abs() <= 1e-9 * wholes[0], "{wholes:?}");
    // Without the leg that is held, none stands first.
    let text = legs.to_string().replace("[1,1,1,1,1,1]", "[1,1,1,0,0,0]");
    std::fs::write(folder.path().join("pinned.json"), text).unwrap();
    let arguments = [&["sequence", "pinned.json"], &build[..], &material].concat();
    let none = run_in(folder.path(), &arguments, b"").ended(4).json();
    assert_eq!(none["proved"], json!(true));
}

/// What `frame` says of a part that nothing holds, of a support that holds nothing and of two struts in one place.
#[test]
fn parts_supports_and_doubled_struts_are_named_as_frame_names_them() {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).unwrap();
    let both = |file: &str, supports: &str, status: i32| {
        let units: &[&str] = if file.contains(".wirebend") { &[] } else { &["--units", "mm"] };
        let ask = |command: &str, rest: &[&str]| {
            let arguments = [&[command, file, "--supports", supports, "--json"], rest, units].concat();
            run_in(folder.path(), &arguments, b"").ended(status).json()
        };
        let epsilon = EPSILON_MM.to_string();
        let build = ["--machine", "framefab-extruder", "--epsilon", &epsilon];
        [ask("frame", &["--material", "abs-1-5mm"]), ask("sequence", &build)]
    };
    write("two.obj", "v 0 0 0\nv 0 0 40\nv 90 0 0\nv 90 0 40\nl 1 2\nl 3 4\n");
    for found in both("two.obj", "0", 4) {
        let finding = &found["diagnostics"][0];
        assert_eq!(finding["message"], "nothing holds the part of 1 edge at vertex 2");
        assert_eq!((&finding["vertex"], &finding["edge"]), (&json!(2), &json!(1)));
    }
    let [_, sequence] = both("two.obj", "0", 4);
    let help = sequence["diagnostics"][0]["help"].as_str().unwrap();
    assert_eq!(help, "hold it at vertices that stand on something");

    let [in_frame, in_sequence] = both(&jointed(folder.path()), "0,2,90", 0);
    let note = |found: &Value, code: &str| {
        found["notes"].as_array().unwrap().iter().find(|note| note["code"] == code).cloned().unwrap()
    };
    let unused = note(&in_sequence, "support-unused");
    assert_eq!(unused["message"], "no strut ends at the support at vertex 90: it holds nothing");
    assert_eq!(unused, note(&in_frame, "support-unused"));
    let confirm = |file: &str, supports: &[u32], found: &Value| {
        let mut task = task(folder.path(), file);
        on_supports(&mut task, supports);
        task.machine.max_sag_mm = EPSILON_MM;
        assert_eq!(task.faults(&Step::printed(found)), [], "{file}");
    };
    confirm("jointed.wirebend", &[0, 2, 90], &in_sequence);

    run_in(folder.path(), &["import", "two.obj", "--units", "mm", "-o", "doubled.wirebend"], b"").ended(0);
    let path = folder.path().join("doubled.wirebend");
    let mut design: Value = serde_json::from_slice(&std::fs::read(&path).unwrap()).unwrap();
    let edges = design["wireframe"]["edges"].as_array_mut().unwrap();
    edges.extend([json!({"id": 2, "a": 3, "b": 2}), json!({"id": 3, "a": 0, "b": 1})]);
    design["wireframe"]["next_edge"] = json!(4);
    std::fs::write(&path, design.to_string()).unwrap();
    let [in_frame, in_sequence] = both("doubled.wirebend", "0,2", 0);
    confirm("doubled.wirebend", &[0, 2], &in_sequence);
    for found in [in_frame, in_sequence] {
        assert_eq!(
            note(&found, "doubled-strut")["message"],
            "edges 1 and 2 both join vertices 2 and 3, and 1 more edge lies on another: each is a strut of its own"
        );
    }
}

#[test]
fn a_frame_that_is_too_soft_or_out_of_reach_is_refused_with_its_place() {
    let soft = sequence("framefab/bunny0507_.pwf", &["--epsilon", "0.3"]).ended(4).json();
    assert_eq!((&soft["feasible"], &soft["proved"]), (&json!(false), &json!(true)));
    assert_eq!(codes(&soft), ["frame_too_soft"]);
    // Node 34 of three other programs, which count from 1.
    assert_eq!(soft["diagnostics"][0]["vertex"], json!(33));
    assert_eq!(soft["obstacle"]["rule"], json!("whole-frame"));
    // That is known before anything is cut.
    for rest in [&["--layers"][..], &["--cost", "paper"]] {
        let arguments = [&["--epsilon", "0.3"], rest].concat();
        let layered = sequence("framefab/bunny0507_.pwf", &arguments).ended(4).json();
        assert_fits("sequence", &layered);
        assert_eq!((&layered["diagnostics"], &layered["layers"]), (&soft["diagnostics"], &Value::Null));
        assert!(layered["timings_ms"].get("layers").is_none(), "{layered}");
    }
    // What would move farther than it is large is too soft, and no mechanism; of a hinge no sag helps.
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("long.obj"), "v 0 0 0\nv 2000 0 0\nl 1 2\n").unwrap();
    let build = [
        "sequence",
        "long.obj",
        "--units",
        "mm",
        "--machine",
        "framefab-extruder",
        "--json",
        "--supports",
        "0",
    ];
    let long = run_in(folder.path(), &build, b"").ended(4).json();
    assert_eq!(codes(&long), ["frame_too_soft"]);
    let said = long["diagnostics"][0]["message"].as_str().unwrap();
    assert!(said.starts_with("the finished frame sags by 48817.3"), "{said}");
    std::fs::write(
        folder.path().join("order.json"),
        json!({"steps": [{"edge": 0, "from_vertex": 0, "direction": [0.0, 0.0, 1.0]}]}).to_string(),
    )
    .unwrap();
    let checked =
        run_in(folder.path(), &[&build[..], &["--check", "order.json"]].concat(), b"").ended(4).json();
    assert!(codes(&checked).contains(&"frame_too_soft"), "{checked}");
    assert!(checked["steps"][0]["max_displacement_mm"].as_f64().unwrap() > 48817.0, "{checked}");
    let hinge = json!({
        "unit": "millimeter",
        "node_list": [
            { "node_id": 0, "point": { "X": 0.0, "Y": 0.0, "Z": 0.0 }, "is_grounded": 1, "fixities": [1, 1, 1, 0, 0, 0] },
            { "node_id": 1, "point": { "X": 0.0, "Y": 0.0, "Z": 40.0 }, "is_grounded": 0 },
        ],
        "element_list": [{ "end_node_ids": [0, 1] }],
    });
    std::fs::write(folder.path().join("hinge.json"), hinge.to_string()).unwrap();
    let hinged = ["sequence", "hinge.json", "--machine", "framefab-extruder", "--json"];
    let hinged = run_in(folder.path(), &hinged, b"").ended(4).json();
    assert_eq!(codes(&hinged), ["frame_mechanism"]);
    assert!(!hinged["diagnostics"][0]["help"].as_str().unwrap().contains("farther off"), "{hinged}");
    // No time, no answer.
    let stopped = sequence("framefab/bunny0507_.pwf", &["--limit", "0"]).ended(4).json();
    assert_eq!((&stopped["proved"], codes(&stopped)), (&json!(false), vec!["sequence_not_found"]));
}

#[test]
fn what_is_no_frame_and_no_sequence_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).unwrap();
    let ask = |arguments: &[&str]| run_in(folder.path(), &[&["sequence"], arguments].concat(), b"");
    let frame = data("assembly-instances/four-frame.json");
    let machine = ["--machine", "framefab-extruder"];
    // A bender is no strut builder.
    let bender = ask(&[&frame, "--machine", "wirebend-kit"]).ended(2).err;
    assert!(bender.contains("no strut-builder has the id `wirebend-kit`: it is a machine"), "{bender}");
    let builder = run(&["plan", &frame, "--machine", "framefab-extruder"]).ended(2).err;
    assert!(builder.contains("framefab-extruder"), "{builder}");
    // Nothing stands on anything.
    write("line.obj", "v 0 0 0\nv 0 0 30\nl 1 2\n");
    let free = ask(&[&["line.obj", "--units", "mm", "--json"], &machine[..]].concat()).ended(4).json();
    assert_eq!(codes(&free), ["frame_unsupported"]);
    for epsilon in ["0", "-1", "NaN"] {
        ask(&[&[frame.as_str()], &machine[..], &["--epsilon", epsilon]].concat()).ended(2);
    }
    // Beyond what a clock counts.
    let limits = ["1e19", "1e300", "-1", "NaN"];
    for limit in limits.map(|limit| format!("--limit={limit}")) {
        let refused = ask(&[&[frame.as_str(), &limit, "--json"], &machine[..]].concat()).ended(2).json();
        assert_eq!(refused["error"]["code"], "value", "{limit}");
    }
    let layered = ["--group-by", "wire", "--cost", "paper"];
    let refused = ask(&[&[frame.as_str()], &machine[..], &layered].concat()).ended(2).err;
    assert!(refused.contains("the cost of FrameFab is that of single struts"), "{refused}");
    write("none.json", "{\"steps\": [{\"edge\": -3}]}");
    let none = ask(&[&[frame.as_str()], &machine[..], &["--check", "none.json"]].concat()).ended(3).err;
    assert!(none.contains("none.json, line 1: step 1: "), "{none}");
    // A file of ours that is cut off, or has no number where one has to be.
    let broken = "{\"machine\": \"mine\",\n\"steps\": [\n{\"edge\": 0, \"direction\": [";
    for (rest, line) in [("", 3), ("NaN, 0, 0]}]}", 3), ("0, 0, 1]}\n", 4)] {
        write("broken.json", &format!("{broken}{rest}"));
        let refused =
            ask(&[&[frame.as_str()], &machine[..], &["--check", "broken.json"]].concat()).ended(3).err;
        assert!(refused.contains(&format!("broken.json, line {line}")), "{refused}");
        assert!(!refused.contains("FrameFab"), "{refused}");
    }
    // A length that is no number, and none at all; also of a wire's joint.
    for direction in ["[1e200, 0, 0]", "[0, 0, 0]", "[0.3, 0, 0]"] {
        let step = |keys: &str| format!("{{\"steps\": [\n{{\"edge\": 0, {keys}}}]}}");
        write("strut.json", &step(&format!("\"from_vertex\": 0, \"direction\": {direction}")));
        let joint = format!("{{\"vertex\": 0, \"direction\": {direction}}}");
        write("wire.json", &step(&format!("\"edges\": [0, 1], \"joints\": [{joint}]")));
        for file in ["strut.json", "wire.json"] {
            let refused = ask(&[&[frame.as_str()], &machine[..], &["--check", file]].concat()).ended(3).err;
            assert!(refused.contains(&format!("{file}, line 2")), "{direction}: {refused}");
            assert!(refused.contains("expected a direction of length 1"), "{direction}: {refused}");
        }
    }
    // What is said twice of a wire, and changed once.
    let joints = "\"edges\": [0, 1], \"joints\": [{\"vertex\": 0, \"direction\": [0, 0, 1]}]";
    for (twice, expected) in [
        ("\"direction\": [0, 1, 0]", "'direction' is [0, 1, 0], and the first of 'joints' has [0, 0, 1]"),
        ("\"from_vertex\": 3", "'from_vertex' is 3, and the first of 'joints' is at 0"),
        ("\"edge\": 1", "'edge' is 1, and 'edges' begins with 0"),
    ] {
        let edge = if twice.contains("edge") { "" } else { "\"edge\": 0, " };
        write("twice.json", &format!("{{\"steps\": [\n{{{edge}{twice}, {joints}}}]}}"));
        let refused =
            ask(&[&[frame.as_str()], &machine[..], &["--check", "twice.json"]].concat()).ended(3).err;
        assert!(refused.contains(&format!("step 1: {expected}: expected the same of both")), "{refused}");
    }
    write("other.json", "[1, 2]");
    ask(&[&[frame.as_str()], &machine[..], &["--check", "other.json"]].concat()).ended(3);
    // The authors' sequence is of the bunny in another place and size.
    let published = data("framefab/bunny_result.json");
    let other = ask(&[&[frame.as_str()], &machine[..], &["--check", &published]].concat()).ended(3).err;
    assert!(other.contains("step 1 of the sequence: no vertex of the design"), "{other}");
    let wires = ask(&[&[frame.as_str()], &machine[..], &["--group-by", "wire"]].concat()).ended(2).err;
    assert!(wires.contains("has no walks of wires"), "{wires}");
}
