//! `sequence`: what is printed is confirmed by brute force, with the design as it is imported.

use serde_json::Value;
use wirebend_tests_brute::{Fault, Step, Task};

use crate::{root, run_in};

/// A frame that a reader is tested with, as brute force takes it, and its sequence.
fn asked(file: &str, rest: &[&str]) -> (Task, Value) {
    let folder = tempfile::tempdir().unwrap();
    let frame = root().join("crates/files/tests/data").join(file).display().to_string();
    run_in(folder.path(), &["import", &frame, "-o", "frame.wirebend"], b"").ended(0);
    let design = std::fs::read(folder.path().join("frame.wirebend")).unwrap();
    let task = Task::framefab(&serde_json::from_slice(&design).unwrap());
    let ask = [&["sequence", "frame.wirebend", "--machine", "framefab-extruder", "--json"], rest].concat();
    (task, run_in(folder.path(), &ask, b"").ended(0).json())
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
    for (&id, vertex) in &mut task.vertices {
        vertex.support = id == 0;
        vertex.fixed = [id == 0; 6];
    }
    assert_eq!(task.faults(&steps), []);
    // Without those before it the last step hangs on nothing.
    let last = steps.last().cloned().unwrap();
    let faults = task.faults(&[last]);
    assert!(faults.contains(&Fault::Floating { step: 1 }), "{faults:?}");
}
