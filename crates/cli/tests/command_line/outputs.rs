//! Files that are written: whole or not at all, and none that is there is lost.

use std::path::Path;

use crate::{assert_fits, example, run_in};

fn read(folder: &Path, name: &str) -> String {
    std::fs::read_to_string(folder.join(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
}

#[test]
fn a_file_that_is_there_is_replaced_only_on_request() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("cube.txt"), "mine").unwrap();
    let cube = example("cube-8-edges.obj");
    let export = ["export", &cube, "-m", "wirebend-kit", "-o", "cube.txt"];
    let said = run_in(folder.path(), &export, b"").ended(2).err;
    assert!(said.contains("error: cube.txt exists already\n"), "{said}");
    assert!(said.contains("help: replace it with --force"), "{said}");
    let json = run_in(folder.path(), &[&export[..], &["--json"]].concat(), b"").ended(2).json();
    let remedies =
        serde_json::json!([{"remedy": "choose-other-file"}, {"remedy": "overwrite", "path": "cube.txt"}]);
    assert_eq!((&json["error"]["code"], &json["error"]["remedies"]), (&"exists".into(), &remedies), "{json}");
    assert_eq!(json["error"]["message"], "cube.txt exists already");
    assert_eq!(json["error"]["help"][1], "replace it with --force");
    assert_eq!(read(folder.path(), "cube.txt"), "mine");
    run_in(folder.path(), &[&export[..], &["--force"]].concat(), b"").ended(0);
    assert!(read(folder.path(), "cube.txt").contains("F 30.770"));
    let left: Vec<_> = std::fs::read_dir(folder.path()).unwrap().collect();
    assert_eq!(left.len(), 1, "nothing is left beside it: {left:?}");
}

/// Whoever opens a PDF under the name of a page of the web is told that it is damaged.
#[test]
fn a_name_with_the_end_of_another_kind_of_file_is_noted() {
    let folder = tempfile::tempdir().unwrap();
    let cube = example("cube-8-edges.obj");
    let noted = |machine: &str, format: &str, name: &str| {
        let export = ["export", &cube, "-m", machine, "-f", format, "-o", name, "--json"];
        let made = run_in(folder.path(), &export, b"").ended(0).json();
        let notes = made["notes"].as_array().unwrap().iter();
        let misnamed: Vec<String> =
            notes.filter(|note| note["code"] == "misnamed").map(|note| note["message"].to_string()).collect();
        assert!(folder.path().join(name).exists(), "it is what was asked for");
        misnamed
    };
    let said = noted("wirebend-kit", "job-sheet", "sheet.html");
    assert_eq!(
        said,
        [r#""the name ends in .html, and what is written is 'job-sheet', whose names end in .pdf""#]
    );
    assert_eq!(noted("grbl-bender", "gcode", "program.svg").len(), 1);
    for (machine, format, name) in [
        ("wirebend-kit", "job-sheet", "sheet.PDF"),
        ("wirebend-kit", "job-sheet", "sheet"),
        ("wirebend-kit", "gltf", "model.glb"),
        ("grbl-bender", "gcode", "program.tap"),
        ("table-bender", "lra-csv", "table.csv"),
    ] {
        assert!(noted(machine, format, name).is_empty(), "{name}");
    }
    for name in ["a.wirebend", "a.wbjob", "a.gltf", "a.csv", "a.json", "a.stl"] {
        assert_eq!(noted("wirebend-kit", "wirebend-kit-text", name).len(), 1, "{name}");
    }
}

/// Another program would say of such a file that it is damaged.
#[test]
fn what_this_program_keeps_under_the_name_of_another_kind_is_noted() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("post.obj"), "v 0 0 0\nv 0 0 30\nl 1 2\n").unwrap();
    let cube = example("cube-8-edges.obj");
    let truss = ["generate", "truss", "--rings", "1", "--strut", "50"];
    let sequence =
        ["sequence", "post.obj", "--units", "mm", "--machine", "framefab-extruder", "--supports", "0"];
    let frame = ["frame", "post.obj", "--units", "mm", "--material", "steel-1mm", "--supports", "0"];
    for (command, option, wrong, right) in [
        (&["import", &cube][..], "-o", &["a.stl", "a.svg", "a.txt"][..], &["a.wirebend", "a.OBJ", "a"][..]),
        (&truss, "-o", &["b.stl", "b.csv"], &["b.wirebend", "b.obj", "b.json"]),
        (&["plan", &cube, "-m", "wirebend-kit"], "-o", &["c.stl", "c.wirebend"], &["c.wbjob", "c.json"]),
        (&sequence, "-o", &["d.wbjob"], &["d.json"]),
        (&["profile", "export", "steel-1mm"], "-o", &["e.txt"], &["e.json"]),
        (&frame, "--conmech", &["f.stl"], &["f.json"]),
        (&frame, "--vtk", &["g.csv"], &["g.vtk"]),
    ] {
        for (name, noted) in
            wrong.iter().map(|&name| (name, true)).chain(right.iter().map(|&name| (name, false)))
        {
            let made = run_in(folder.path(), &[command, &[option, name, "--json"]].concat(), b"").ended(0);
            let notes = made.json()["notes"].as_array().unwrap().clone();
            assert_eq!(notes.iter().any(|note| note["code"] == "misnamed"), noted, "{name}: {notes:?}");
            assert!(folder.path().join(name).exists(), "it is what was asked for");
        }
    }
    let said = run_in(folder.path(), &[&truss[..], &["-o", "t.stl"]].concat(), b"").ended(0).err;
    let note = "note: the name ends in .stl, and what is written is a WireBend project, whose names end in .wirebend or .json\n";
    assert!(said.contains(note) && said.contains("wrote t.stl"), "{said}");
}

#[test]
fn a_folder_that_is_not_there_is_said() {
    let folder = tempfile::tempdir().unwrap();
    let cube = example("cube-8-edges.obj");
    let ran = run_in(folder.path(), &["export", &cube, "-m", "wirebend-kit", "-o", "no/such/cube.txt"], b"");
    assert!(ran.status != 0 && ran.err.contains("no/such"), "{}", ran.err);
}

#[test]
fn every_format_of_every_machine_can_be_written() {
    let folder = tempfile::tempdir().unwrap();
    let house = example("house.obj");
    let run = |arguments: &[&str]| run_in(folder.path(), arguments, b"");
    for (format, sign) in [
        ("wirebend-kit-text", "F "),
        ("lra-csv", "L"),
        ("ybc-csv", ",43.336"),
        ("xyz-csv", "x_mm"),
        ("cumulative-csv", "D_mm,Rabs_deg"),
        ("svg", "<svg"),
        ("obj", "\nl "),
        ("obj-tube", "\nf "),
    ] {
        run(&["export", &house, "-m", "wirebend-kit", "-f", format, "-o", format]).ended(0);
        let text = read(folder.path(), format);
        assert!(text.contains(sign), "{format}: {}", &text[..text.len().min(200)]);
    }
    run(&["export", &house, "-m", "wirebend-kit", "-f", "gltf", "-o", "house.glb"]).ended(0);
    assert_eq!(&std::fs::read(folder.path().join("house.glb")).unwrap()[..4], b"glTF");
    run(&["export", &house, "-m", "wirebend-kit", "-f", "png", "-o", "house.png"]).ended(0);
    let png = std::fs::read(folder.path().join("house.png")).unwrap();
    assert_eq!(&png[..8], b"\x89PNG\r\n\x1a\n");
    // The kit's angles in a Pensa's script would bend another part.
    let said =
        run(&["export", &house, "-m", "wirebend-kit", "-f", "pensa-script", "-o", "no.dsw"]).ended(2).err;
    assert!(said.contains("compensated for that machine alone"), "{said}");
    run(&["export", &house, "-m", "pensa-diwire-pro", "-o", "house.dsw"]).ended(0);
    assert!(read(folder.path(), "house.dsw").trim_end().lines().last().unwrap().starts_with("FEED "));
    // Each machine has its own format without being asked, by its driver.
    for (machine, format, driver, sign) in [
        ("grbl-bender", "gcode", "grbl", "\nG91\n"),
        ("howtomechatronics", "howtomechatronics-serial", "howtomechatronics", "manual\n"),
        ("table-bender", "lra-csv", "tables", "L_mm,R_deg"),
    ] {
        let made = run(&["export", &house, "-m", machine, "-o", machine, "--json"]).ended(0).json();
        assert_fits("export", &made);
        assert_eq!((made["format"].as_str(), made["driver"].as_str()), (Some(format), Some(driver)));
        assert!(read(folder.path(), machine).contains(sign), "{machine}");
    }
}

#[test]
fn several_wires_go_to_files_with_numbers() {
    let folder = tempfile::tempdir().unwrap();
    let two = example("two-parts.obj");
    let export = ["export", &two, "-m", "wirebend-kit", "-o", "part.txt"];
    let said = run_in(folder.path(), &export, b"").ended(0).err;
    assert!(said.contains("part-1.txt") && said.contains("part-2.txt"), "{said}");
    assert!(read(folder.path(), "part-2.txt").contains("F "));
    // The second one is there: nothing is written, the first one included.
    std::fs::remove_file(folder.path().join("part-1.txt")).unwrap();
    run_in(folder.path(), &export, b"").ended(2);
    assert!(!folder.path().join("part-1.txt").exists());
    let said = run_in(folder.path(), &["export", &two, "-m", "wirebend-kit"], b"");
    assert!(said.status != 0 && said.out.is_empty() && said.err.contains("-o"), "{}", said.err);
}

#[test]
fn what_cannot_be_made_is_written_only_on_request() {
    let folder = tempfile::tempdir().unwrap();
    let bunny = example("bunny.obj");
    let export = ["export", &bunny, "--face-edges", "--double", "-m", "wirebend-kit", "-o", "bunny.txt"];
    let said = run_in(folder.path(), &export, b"").ended(4).err;
    assert!(said.contains("bend_too_sharp") && said.contains("--despite-errors"), "{said}");
    assert!(!folder.path().join("bunny.txt").exists());
    let said = run_in(folder.path(), &[&export[..], &["--despite-errors"]].concat(), b"").ended(0).err;
    assert!(said.contains("warning"), "{said}");
    assert!(read(folder.path(), "bunny.txt").lines().count() > 400);
    // A job that was written anyway keeps what was objected to.
    let plan = ["plan", &bunny, "--face-edges", "--double", "-m", "wirebend-kit", "-o", "b.wbjob"];
    let said = run_in(folder.path(), &plan, b"").ended(4).err;
    assert!(said.contains("no job was written"), "{said}");
    run_in(folder.path(), &[&plan[..], &["--despite-errors"]].concat(), b"").ended(4);
    let said = run_in(folder.path(), &["export", "b.wbjob", "-o", "b.txt"], b"").ended(0).err;
    assert!(said.contains("the job was planned despite an error") && said.contains("155.0°"), "{said}");
    // A picture is no program.
    let picture =
        ["export", &bunny, "--face-edges", "--double", "-m", "wirebend-kit", "-f", "svg", "-o", "b.svg"];
    run_in(folder.path(), &picture, b"").ended(0);
}

#[test]
fn a_job_is_for_its_machine_and_refused_when_changed() {
    let folder = tempfile::tempdir().unwrap();
    let run = |arguments: &[&str]| run_in(folder.path(), arguments, b"");
    run(&["plan", &example("cube-8-edges.obj"), "-m", "wirebend-kit", "-o", "cube.wbjob"]).ended(0);
    let said = run(&["export", "cube.wbjob", "--machine", "pensa-diwire-pro"]).ended(2).err;
    assert!(said.contains("wirebend-kit") && said.contains("plan"), "{said}");
    run(&["export", "cube.wbjob", "--machine", "wirebend-kit", "-o", "a.txt"]).ended(0);
    run(&["export", &example("cube-8-edges.obj"), "--machine", "wirebend-kit", "-o", "b.txt"]).ended(0);
    assert_eq!(read(folder.path(), "a.txt"), read(folder.path(), "b.txt"), "by way of a job or not");
    let changed = read(folder.path(), "cube.wbjob").replacen("27.769", "97.769", 1);
    std::fs::write(folder.path().join("cube.wbjob"), changed).unwrap();
    let said = run(&["simulate", "cube.wbjob"]).ended(3).err;
    assert!(said.contains("cube.wbjob") && said.contains("hash"), "{said}");
}

#[test]
fn a_document_keeps_what_was_imported() {
    let folder = tempfile::tempdir().unwrap();
    let run = |arguments: &[&str]| run_in(folder.path(), arguments, b"");
    run(&["import", &example("teapot.obj"), "--face-edges", "-o", "teapot.wirebend"]).ended(0);
    let direct =
        ["plan", &example("teapot.obj"), "--face-edges", "--double", "-m", "pensa-diwire-pro", "--json"];
    let kept = ["plan", "teapot.wirebend", "--double", "-m", "pensa-diwire-pro", "--json"];
    assert_eq!(run(&direct).json()["program"], run(&kept).json()["program"]);
    let scaled =
        ["import", &example("cube.obj"), "--scale", "2", "--units", "inch", "--json", "-o", "c.wirebend"];
    let size = run(&scaled).ended(0).json()["size_mm"].clone();
    assert_eq!(size, serde_json::json!([1524.0, 1524.0, 1524.0]), "30 inches, twice");
}

#[test]
fn simulations_are_drawn() {
    let folder = tempfile::tempdir().unwrap();
    let run = |arguments: &[&str]| run_in(folder.path(), arguments, b"");
    run(&["plan", &example("cup-holder.obj"), "-m", "wirebend-kit", "-o", "cup.wbjob"]).ended(0);
    let bend = [
        "simulate",
        "cup.wbjob",
        "--noise",
        "wirebend-kit",
        "--runs",
        "50",
        "--svg",
        "c.svg",
        "--png",
        "c.png",
    ];
    let said = run(&bend).ended(0).err;
    assert!(said.contains("95 %") && said.contains("c.svg"), "{said}");
    assert!(read(folder.path(), "c.svg").contains("simulated"));
    run(&bend).ended(2);
}

#[test]
fn what_is_not_written_to_the_output_is_said() {
    let folder = tempfile::tempdir().unwrap();
    let run = |arguments: &[&str]| run_in(folder.path(), arguments, b"");
    // Infeasible: there is no job to print, so the report is.
    let report =
        run(&["plan", &example("fold-back.obj"), "--double", "-m", "wirebend-kit", "-o", "-", "--json"]);
    assert_eq!(report.ended(4).json()["withheld"], true);
    // The document takes the output: what was assumed goes to the error stream.
    let document = run(&["import", &example("house.obj"), "--json"]).ended(0);
    assert_eq!(document.json()["format"], "wirebend");
    assert!(document.err.contains("taken as mm"), "{}", document.err);
    run(&["export", &example("two-parts.obj"), "-m", "wirebend-kit", "-f", "xyz-csv"]).ended(2);
}

/// Two bends to opposite sides on a short leg: beside the first, the peg comes out farther before the second. A line of the text has no
/// place for that, and the machine would bring it out into the wire.
#[test]
fn what_the_text_of_a_machine_cannot_say_is_noted() {
    let folder = tempfile::tempdir().unwrap();
    let z = "v 0 0 0\nv 60 0 0\nv 80.683 17.355 0\nv 140.683 17.355 0\nl 1 2 3 4\n";
    std::fs::write(folder.path().join("z.obj"), z).unwrap();
    let said =
        run_in(folder.path(), &["export", "z.obj", "-m", "wirebend-kit", "-o", "z.txt"], b"").ended(0).err;
    assert!(said.contains("1 bend needs the peg to come out farther from the wire"), "{said}");
}
