//! `sequence`: what is printed is confirmed by brute force, with the design as it is imported.

use std::path::Path;

use serde_json::Value;
use wirebend_tests_brute::{Fault, Step, Task};

use crate::{root, run_in};

/// A frame in a file as brute force takes it.
pub(crate) fn task(folder: &Path, file: &str) -> Task {
    let imported = folder.join("imported.wirebend").display().to_string();
    let design = if file.ends_with(".wirebend") {
        folder.join(file)
    } else {
        run_in(folder, &["import", file, "-o", &imported, "--force"], b"").ended(0);
        imported.into()
    };
    Task::framefab(&serde_json::from_slice(&std::fs::read(design).unwrap()).unwrap())
}

/// The same on other supports, which hold all.
pub(crate) fn on_supports(task: &mut Task, supports: &[u32]) {
    for (id, vertex) in &mut task.vertices {
        vertex.support = supports.contains(id);
        vertex.fixed = [vertex.support; 6];
    }
}

/// A frame that a reader is tested with, and its sequence.
fn asked(file: &str, rest: &[&str]) -> (Task, Value) {
    let folder = tempfile::tempdir().unwrap();
    let frame = root().join("crates/files/tests/data").join(file).display().to_string();
    let ask = [&["sequence", &frame, "--machine", "framefab-extruder", "--json"], rest].concat();
    (task(folder.path(), &frame), run_in(folder.path(), &ask, b"").ended(0).json())
}

#[test]
fn every_sequence_that_is_printed_can_be_built() {
    for file in [
        "framefab/bunny0507_.pwf",
        "assembly-instances/C_shape.json",
        "assembly-instances/simple_frame.json",
        "assembly-instances/four-frame.json",
    ] {
        for rest in [&[][..], &["--cost", "paper"]] {
            let (task, found) = asked(file, rest);
            let steps = Step::printed(&found);
            assert_eq!(task.faults(&steps), [], "{file} {rest:?}");
            assert_eq!(steps.len(), task.edges.len());
            let sags = task.sags(&steps);
            for (step, sag) in found["steps"].as_array().unwrap().iter().zip(sags) {
                let printed = step["max_displacement_mm"].as_f64().unwrap();
                assert!((printed - sag).abs() <= 1e-9 * sag, "{file}: {printed} mm instead of {sag}");
            }
        }
    }
}

/// Where one foot alone stands, its pillar is the only strut on the ground.
#[test]
fn a_sequence_on_other_supports_is_that_of_a_frame_on_these() {
    let (mut task, found) = asked("assembly-instances/four-frame.json", &["--supports", "0"]);
    let steps = Step::printed(&found);
    on_supports(&mut task, &[0]);
    assert_eq!(task.faults(&steps), []);
    // Without those before it the last step hangs on nothing.
    let last = steps.last().cloned().unwrap();
    let faults = task.faults(&[last]);
    assert!(faults.contains(&Fault::Floating { step: 1 }), "{faults:?}");
}

/// A machine of one's own that welds what is placed: the head stands at both ends of a rod, and draws none.
#[test]
fn rods_are_fastened_and_not_drawn() {
    let folder = tempfile::tempdir().unwrap();
    let builders = folder.path().join("mine/strut-builders");
    std::fs::create_dir_all(&builders).unwrap();
    let frame =
        root().join("crates/files/tests/data/assembly-instances/simple_frame.json").display().to_string();
    for process in ["extrude", "weld", "place"] {
        let child = format!(
            r#"{{"schema_version": 1, "kind": "strut-builder", "id": "mine", "inherits": "framefab-extruder",
                "process": {{"value": "{process}", "source": "mine", "measured": true}}}}"#
        );
        std::fs::write(builders.join("mine.json"), child).unwrap();
        let ask = ["--profiles", "mine", "sequence", &frame, "--machine", "mine", "--json"];
        let found = run_in(folder.path(), &ask, b"").ended(0).json();
        let steps = Step::printed(&found);
        let mut task = task(folder.path(), &frame);
        task.machine.places = process != "extrude";
        assert_eq!(task.faults(&steps), [], "{process}");
        let both_ends = steps.iter().filter(|step| step.joints.len() == 2).count();
        assert_eq!(both_ends > 0, task.machine.places, "{process}");
        std::fs::write(folder.path().join("found.json"), found.to_string()).unwrap();
        let again = [&ask[..], &["--check", "found.json"]].concat();
        assert_eq!(run_in(folder.path(), &again, b"").ended(0).json()["feasible"], true, "{process}");
        let paper = [&ask[..], &["--cost", "paper"]].concat();
        run_in(folder.path(), &paper, b"").ended(if task.machine.places { 2 } else { 0 });
    }
}
