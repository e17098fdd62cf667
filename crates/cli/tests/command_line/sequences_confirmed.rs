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
