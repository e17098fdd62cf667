//! What is found has to be right by the check and by brute force, which share nothing with the search.

use std::ops::ControlFlow;

use wirebend_sequence::{
    GivenStep, Groups, Outcome, SearchOptions, Structure, StrutBuilder, Task, check, search,
};

use super::brute;
use super::frames::abs;

/// The steps of a sequence that was found, with which nothing is wrong.
#[track_caller]
pub fn confirmed(task: &Task<'_>, outcome: &Outcome) -> Vec<GivenStep> {
    assert!(outcome.is_found(), "{:?}", outcome.obstacle);
    let given: Vec<GivenStep> =
        outcome.steps.iter().map(|step| GivenStep::of(step, task.structure, task.builder)).collect();
    assert_eq!(check(task, &given).violations, []);
    assert_eq!(brute::faults(task, &given), []);
    given
}

/// A search in ABS. What it finds is confirmed.
#[track_caller]
pub fn searched(structure: &Structure, groups: &Groups, builder: &StrutBuilder) -> Outcome {
    let weight = abs();
    let task = Task { structure, groups, builder, weight: &weight };
    let outcome = search(&task, &SearchOptions::default(), &mut |_| ControlFlow::Continue(())).unwrap();
    if outcome.is_found() {
        confirmed(&task, &outcome);
    }
    outcome
}

/// The sags after each step that the search, the check and brute force find, which are the same; nothing is wrong by either of the
/// latter.
#[track_caller]
pub fn agreed(task: &Task<'_>, outcome: &Outcome) -> Vec<f64> {
    let given = confirmed(task, outcome);
    let sags = brute::of_task(task).sags(&brute::of_steps(&given));
    for ((brute, step), checked) in sags.iter().zip(&outcome.steps).zip(&check(task, &given).sags_mm) {
        assert!((step.max_sag_mm - brute).abs() <= 1e-9 * brute, "{} {brute}", step.max_sag_mm);
        assert!((checked.unwrap() - brute).abs() <= 1e-9 * brute, "{checked:?} {brute}");
    }
    sags
}
