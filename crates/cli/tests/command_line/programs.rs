//! Programs that are planned again: nothing is compensated twice, and the order stays where a person wants that.

use std::path::Path;

use crate::{example, run_in};

/// Letter and value of each command of a WireBend-kit program.
fn commands(folder: &Path, name: &str) -> Vec<(char, f64)> {
    let text = std::fs::read_to_string(folder.join(name)).unwrap();
    let lines = text.lines().filter(|line| !line.starts_with('#'));
    lines.map(|line| (line.chars().next().unwrap(), line[2..].parse().unwrap())).collect()
}

/// The cube with its doubled edges, as a file for the machine.
fn cube_of_kit(folder: &Path) -> Vec<(char, f64)> {
    let cube = example("cube.obj");
    run_in(folder, &["export", &cube, "-m", "wirebend-kit", "--double", "-o", "cube.txt"], b"").ended(0);
    commands(folder, "cube.txt")
}

/// The file of the machine, planned for the same machine, is the same file: what was compensated is turned back first,
/// and the walk is that of the program, from its start to its end, along doubled edges twice.
#[test]
fn a_program_planned_again_in_its_order_is_the_same_program() {
    let folder = tempfile::tempdir().unwrap();
    let first = cube_of_kit(folder.path());
    let again = ["export", "cube.txt", "-m", "wirebend-kit", "--keep-order", "-o", "again.txt"];
    let said = run_in(folder.path(), &again, b"").ended(0).err;
    assert!(said.contains("turned back into the design with the compensation of wirebend-kit"), "{said}");
    // Three decimals were kept: bends in one plane may be a thousandth of a degree out of it.
    let is_command = |&(letter, value): &(char, f64)| letter != 'R' || value.abs() > 0.01;
    let second: Vec<_> = commands(folder.path(), "again.txt").into_iter().filter(is_command).collect();
    assert_eq!(first.len(), second.len());
    for ((letter, value), (other, again)) in first.iter().zip(&second) {
        assert_eq!(letter, other);
        // The head may make a bend from the other side where that takes as long.
        let off = if *letter == 'F' { value - again } else { value.abs() - again.abs() };
        assert!(off.abs() < 0.02, "{letter} {value} became {again}");
    }
}

/// Without the option the planner walks the edges anew, and the feeds are still those of the design.
#[test]
fn a_compensated_program_is_never_compensated_twice() {
    let folder = tempfile::tempdir().unwrap();
    let first = cube_of_kit(folder.path());
    let plan = |more: &[&str]| {
        let arguments =
            [&["plan", "cube.txt", "-m", "wirebend-kit", "--json", "--keep-order"], more].concat();
        run_in(folder.path(), &arguments, b"")
    };
    let bends = |of: &serde_json::Value, stage: &str| -> Vec<f64> {
        let steps = of[stage]["steps"].as_array().unwrap();
        steps.iter().map(|step| step["bend_deg"].as_f64().unwrap().abs()).collect()
    };
    // A cube has bends of 90° and, where it doubles an edge or crosses, others; the design's own plan shows which.
    let cube = example("cube.obj");
    let own = run_in(folder.path(), &["plan", &cube, "-m", "wirebend-kit", "--double", "--json"], b"")
        .ended(0)
        .json();
    let turned = plan(&[]).ended(0).json();
    for (own, turned) in bends(&own, "program").iter().zip(bends(&turned, "program")) {
        assert!((own - turned).abs() < 0.01, "{own} became {turned}");
    }
    // Taken as it stands, its bends are those of the file.
    let taken = plan(&["--program", "nominal"]).json();
    let told: Vec<f64> =
        first.iter().filter(|(letter, _)| *letter == 'B').map(|(_, value)| value.abs()).collect();
    for (told, taken) in told.iter().zip(bends(&taken, "program")) {
        assert!((told - taken).abs() < 0.01, "{told} became {taken}");
    }
    assert!(told[0] > bends(&own, "program")[0] + 1.0, "compensation makes a difference");

    // Nothing names the machine: no design can be made of it.
    let refused = run_in(folder.path(), &["import", "cube.txt"], b"").ended(3).err;
    assert!(refused.contains("--machine") && refused.contains("--program nominal"), "{refused}");
    run_in(folder.path(), &["import", "cube.txt", "--program", "nominal", "-o", "as-it-is.wirebend"], b"")
        .ended(0);
    // Where the wire comes back to a corner, three decimals leave it some micrometres away.
    let import = ["import", "cube.txt", "-m", "wirebend-kit", "--weld", "0.1", "-o", "cube.obj"];
    run_in(folder.path(), &import, b"").ended(0);
    let corners = std::fs::read_to_string(folder.path().join("cube.obj")).unwrap();
    assert_eq!(corners.lines().filter(|line| line.starts_with("v ")).count(), 8, "{corners}");
}

#[test]
fn a_program_that_does_not_say_what_it_is_says_what_was_assumed() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("by-hand.txt"), "F 60\nB 45\nF 60\n").unwrap();
    let plan = |more: &[&str]| {
        let arguments = [&["plan", "by-hand.txt", "-m", "wirebend-kit", "--json"], more].concat();
        let ran = run_in(folder.path(), &arguments, b"").ended(0);
        let json = ran.json();
        let notes =
            json["notes"].as_array().unwrap().iter().map(|note| note["code"].as_str().unwrap().to_owned());
        (notes.collect::<Vec<_>>(), json["program"]["steps"][0]["bend_deg"].as_f64().unwrap().abs())
    };
    let (notes, bend) = plan(&[]);
    assert!(notes.contains(&"program-nominal".to_owned()) && (bend - 45.0).abs() < 1e-9, "{notes:?} {bend}");
    let (notes, bend) = plan(&["--program", "nominal"]);
    assert!(
        !notes.iter().any(|code| code.starts_with("program-")) && (bend - 45.0).abs() < 1e-9,
        "{notes:?} {bend}"
    );
    let (notes, bend) = plan(&["--program", "compensated"]);
    assert!(notes.contains(&"program-turned-back".to_owned()) && bend < 44.0, "{notes:?} {bend}");
    // What is told 45° of a machine that needs no more than that leaves 45°.
    let told = run_in(
        folder.path(),
        &["plan", "by-hand.txt", "-m", "pensa-diwire-pro", "--program", "compensated", "--json"],
        b"",
    );
    let bend = told.json()["program"]["steps"][0]["bend_deg"].as_f64().unwrap();
    assert!((bend.abs() - 45.0).abs() < 1e-9, "{bend}");
}

#[test]
fn an_order_is_kept_of_programs_only() {
    let folder = tempfile::tempdir().unwrap();
    let house = example("house.obj");
    let refused =
        run_in(folder.path(), &["plan", &house, "-m", "wirebend-kit", "--keep-order"], b"").ended(3).err;
    assert!(refused.contains("no order to keep"), "{refused}");
    run_in(folder.path(), &["plan", &house, "-m", "wirebend-kit", "--keep-order", "--double"], b"").ended(2);
    // A table, never read from its end to its start: the first feed stays the first.
    std::fs::write(folder.path().join("part.csv"), "L,R,A\n30,0,45\n50,0,-45\n90,,\n").unwrap();
    let plan = ["plan", "part.csv", "-m", "wirebend-kit", "--clr", "0", "--keep-order", "--json"];
    let json = run_in(folder.path(), &plan, b"").json();
    let feeds: Vec<f64> = json["program"]["steps"]
        .as_array()
        .unwrap()
        .iter()
        .map(|step| step["feed_mm"].as_f64().unwrap())
        .collect();
    for (feed, expected) in feeds.iter().zip([30.0, 50.0, 90.0]) {
        assert!((feed - expected).abs() < 1e-9, "{feeds:?}");
    }
}

/// A model and its buffer in one folder, by the program itself, and without the folder.
#[test]
fn a_gltf_with_its_buffer_beside_it_is_imported() {
    let folder = tempfile::tempdir().unwrap();
    let json = r#"{"asset": {"version": "2.0"}, "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "mode": 3}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 2, "type": "VEC3"}],
        "bufferViews": [{"buffer": 0, "byteLength": 24}], "buffers": [{"uri": "part.bin", "byteLength": 24}]}"#;
    std::fs::create_dir(folder.path().join("models")).unwrap();
    std::fs::write(folder.path().join("models/part.gltf"), json).unwrap();
    let missing = run_in(folder.path(), &["import", "models/part.gltf"], b"").ended(3).err;
    assert!(missing.contains("part.bin") && missing.contains("no such file beside it"), "{missing}");
    let bytes: Vec<u8> = [0.0_f32, 0.0, 0.0, 0.03, 0.0, 0.0].iter().flat_map(|c| c.to_le_bytes()).collect();
    std::fs::write(folder.path().join("models/part.bin"), bytes).unwrap();
    let read = run_in(folder.path(), &["import", "models/part.gltf", "-o", "part.wirebend", "--json"], b"")
        .ended(0)
        .json();
    // 0.03 m in single precision.
    assert!((read["length_mm"].as_f64().unwrap() - 30.0).abs() < 1e-5, "{read}");
    let piped = run_in(folder.path(), &["import", "-", "--from", "gltf"], json.as_bytes()).ended(3).err;
    assert!(piped.contains("part.bin") && piped.contains("open the file itself"), "{piped}");
}

/// Figures with three decimals lead past the vertices to which the wire comes back, the farther the longer it is.
#[test]
fn what_is_exported_is_read_back_with_the_same_vertices_and_edges() {
    let folder = tempfile::tempdir().unwrap();
    let closed = |name: &str, sides: u32, side: f64| {
        let turn = std::f64::consts::TAU / f64::from(sides);
        let radius = side / 2.0 / (turn / 2.0).sin();
        let corner = |k| (radius * (turn * f64::from(k)).cos(), radius * (turn * f64::from(k)).sin());
        let corners: Vec<String> =
            (0..sides).map(corner).map(|(x, y)| format!("v {x:.9} {y:.9} 0\n")).collect();
        let walk: Vec<String> = (0..=sides).map(|k| format!("{}", k % sides + 1)).collect();
        std::fs::write(folder.path().join(name), format!("{}l {}\n", corners.concat(), walk.join(" ")))
            .unwrap();
        name.to_owned()
    };
    let square = closed("square.obj", 4, 60.0);
    let pentagon = closed("pentagon.obj", 5, 314.0);
    let [cup, bunny] = ["cup-holder.obj", "bunny.obj"].map(example);
    for (design, reading, more, machine, file) in [
        (&square, ["--units", "mm"].as_slice(), [].as_slice(), "wirebend-kit", "a.txt"),
        (&pentagon, &["--units", "mm"], &[], "wirebend-kit", "b.txt"),
        (&pentagon, &["--units", "mm"], &[], "table-bender", "b.csv"),
        (&cup, &[], &["--double"], "wirebend-kit", "c.txt"),
        (&bunny, &["--face-edges"], &["--double"], "table-bender", "d.csv"),
    ] {
        let counts = |arguments: &[&str]| {
            let arguments = [arguments, &["-o", "read.wirebend", "--force", "--json"]].concat();
            let report = run_in(folder.path(), &arguments, b"").ended(0).json();
            ["vertices", "edges"].map(|what| report[what].as_u64().unwrap())
        };
        run_in(folder.path(), &[&["export", design, "-m", machine, "-o", file], reading, more].concat(), b"");
        let designed = counts(&[&["import", design], reading].concat());
        assert_eq!(counts(&["import", file, "-m", machine]), designed, "{design} by {machine}");
        if file == "a.txt" {
            // A person who says how near is near enough is taken at their word.
            assert_eq!(counts(&["import", file, "-m", machine, "--weld", "0.0005"]), [5, 4]);
        }
    }
}

/// Whoever names the machine of a program believes that it is turned back for it.
#[test]
fn a_machine_for_which_nothing_is_turned_back_is_told() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("by-hand.txt"), "F 60\nB 45\nF 60\n").unwrap();
    let import = |file: &str, more: &[&str]| {
        let arguments = [&["import", file, "-o", "read.wirebend", "--force", "--json"], more].concat();
        run_in(folder.path(), &arguments, b"")
    };
    let told = |file: &str, more: &[&str]| {
        let found = import(file, more).ended(0).json();
        let notes = found["notes"].as_array().unwrap().iter();
        notes.filter(|note| note["code"] == "without-effect").cloned().collect::<Vec<_>>()
    };
    let (house, bracket) = (example("house.obj"), example("bracket.svg"));
    let kit = ["-m", "wirebend-kit", "--material", "aluminium-6061-t6-3mm"];
    for file in [house.as_str(), "by-hand.txt"] {
        let [note] = &told(file, &kit)[..] else { panic!("it is not told once of {file}") };
        assert_eq!(note["message"], "what is read is the design itself: machine and material had no effect");
        let inputs = serde_json::json!(["machine", "material"]);
        assert_eq!(note["remedies"], serde_json::json!([{"remedy": "leave-out", "inputs": inputs}]));
    }
    let said = run_in(folder.path(), &["import", &house, "-m", "wirebend-kit"], b"").ended(0).err;
    assert!(said.contains("machine had no effect\n  help: leave out --machine\n"), "{said}");
    // These are read for the machine.
    assert!(told("by-hand.txt", &[&kit[..], &["--program", "compensated"]].concat()).is_empty());
    assert!(told(&bracket, &["-m", "wirebend-kit", "--shortest-edge", "machine"]).is_empty());
    assert!(told(&house, &[]).is_empty());
    // An id that nobody knows is refused as by every other command.
    for wrong in [&["-m", "wirebend-kti"][..], &["-m", "wirebend-kit", "--material", "cheese"]] {
        let refused = import(&house, wrong).ended(2).json();
        assert_eq!(refused["error"]["code"], "profile-unknown", "{refused}");
    }
}

/// A job has its machine and its wire: others beside it would be passed over.
#[test]
fn a_job_is_run_with_no_other_machine_and_no_other_wire() {
    let folder = tempfile::tempdir().unwrap();
    let house = example("house.obj");
    run_in(folder.path(), &["plan", &house, "-m", "wirebend-kit", "--double", "-o", "house.wbjob"], b"")
        .ended(0);
    let run = |command: &str, option: &str, id: &str| {
        let words = [command, "house.wbjob", "--port", "sim:max", "--yes", option, id];
        run_in(folder.path(), &words, b"").ended(2).err
    };
    for command in ["run", "dry-run"] {
        let said = run(command, "--machine", "pensa-diwire-pro");
        assert!(said.contains("planned for machine 'wirebend-kit', not 'pensa-diwire-pro'"), "{said}");
        let said = run(command, "--material", "steel-0-9mm");
        assert!(said.contains("material would have no effect"), "{said}");
    }
    let same = ["run", "house.wbjob", "--port", "sim:max", "--yes", "--material", "aluminium-6061-t6-3mm"];
    run_in(folder.path(), &same, b"").ended(0);
}
