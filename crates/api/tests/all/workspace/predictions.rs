//! How far off the open design will be.

use wirebend_api::{Command, Input, Response, SimulateRequest};

use super::*;
use crate::cases::run;

fn asked(noise: &str, runs: u32) -> Value {
    json!({"noise": noise, "runs": runs, "seed": 1})
}

/// The window and the command line say the same of the same design.
#[test]
fn a_design_is_predicted_as_its_job_is_simulated() {
    let window = Window::new();
    window.ask("open-example", json!({"id": "house"}));
    let found = window.ask("predict", asked("bend-forming", 100))["found"].take();
    let [wire] = found["wires"].as_array().unwrap().as_slice() else { panic!("one wire: {found}") };
    assert_eq!((&found["noise"], &found["runs"]), (&json!("bend-forming"), &json!(100)));
    assert_eq!(found["tolerance"], Value::Null);
    let folder = tempfile::tempdir().unwrap();
    let job = folder.path().join("house.wbjob");
    window.ask("save-job", json!({"output": {"path": job, "force": false}}));
    let simulated = run(&Command::Simulate(SimulateRequest {
        noise: Some("bend-forming".to_owned()),
        runs: 100,
        ..SimulateRequest::of(Input::File(job))
    }));
    let Ok(Response::Simulate(simulated)) = simulated else { panic!("the job is not simulated") };
    let simulated = serde_json::to_value(&simulated.wires[0]).unwrap();
    for figure in ["worst_mean_mm", "worst_radius_95_mm", "sources", "steps"] {
        assert_eq!(wire[figure], simulated[figure], "{figure}");
    }
}

/// What cannot be predicted is refused with the reason, and changes nothing.
#[test]
fn what_cannot_be_predicted_is_refused() {
    let window = Window::new();
    window.ask("open-example", json!({"id": "house"}));
    let refused = |request: Value| format!("{:?}", window.try_ask("predict", request).unwrap_err());
    assert!(refused(asked("nobody's", 100)).contains("nobody's"));
    assert!(refused(asked("none", 0)).contains("number of runs"));
    let mut within = asked("none", 10);
    within["within_mm"] = json!(-1.0);
    assert!(refused(within).contains("accuracy"));
    window.ask("new", json!({}));
    window.try_ask("predict", asked("none", 10)).unwrap_err();
}

/// One of a million wires ends while it is under way, with no figures, and the next one is not touched by that.
#[test]
fn a_prediction_is_stopped_in_its_middle() {
    let window = Window::new();
    window.ask("open-example", json!({"id": "house"}));
    let is_under_way = || {
        let told = window.told.0.lock().unwrap();
        told.iter()
            .any(|event| event["value"]["ask"] == "predict" && event["value"]["done"].as_u64() > Some(0))
    };
    std::thread::scope(|scope| {
        let predicted = scope.spawn(|| window.ask("predict", asked("bend-forming", 1_000_000)));
        let begun = std::time::Instant::now();
        while !is_under_way() {
            assert!(begun.elapsed().as_secs() < 60, "no progress is reported");
            assert!(!predicted.is_finished(), "a million wires in no time");
            std::thread::sleep(std::time::Duration::from_millis(5));
        }
        window.ask("stop-prediction", json!({}));
        assert_eq!(predicted.join().unwrap()["found"], Value::Null);
    });
    assert_eq!(window.ask("predict", asked("bend-forming", 100))["found"]["runs"], 100);
}
