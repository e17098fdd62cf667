//! How long it takes to find in which order a frame is built. What is measured is confirmed by brute force.

#![allow(missing_docs)] // criterion's macros make public functions
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)] // a benchmark may stop at what cannot be

#[path = "../../crates/core/tests/all/sequence/brute.rs"]
#[allow(dead_code)] // the tests of the sequence use the rest
mod brute;
#[path = "../../crates/core/tests/all/sequence/frames.rs"]
#[allow(dead_code)] // the tests of the sequence use the rest
mod frames;

use std::hint::black_box;
use std::ops::ControlFlow;

use criterion::{Criterion, criterion_group, criterion_main};
use wirebend_core::sequence::{
    GivenStep, Groups, LayerOptions, Outcome, SearchOptions, Task, layers, search, search_by_paper,
};

fn searched(task: &Task<'_>) -> Outcome {
    search(task, &SearchOptions::default(), &mut |_| ControlFlow::Continue(())).unwrap()
}

fn by_paper(task: &Task<'_>) -> Outcome {
    let layers = layers(task, &[], &LayerOptions::default()).unwrap();
    search_by_paper(task, &layers, 1000, &mut |_| ControlFlow::Continue(())).unwrap()
}

fn confirm(name: &str, task: &Task<'_>, outcome: &Outcome) {
    assert!(outcome.is_found(), "{name}: {:?}", outcome.obstacle);
    let given: Vec<GivenStep> =
        outcome.steps.iter().map(|step| GivenStep::of(step, task.structure, task.builder)).collect();
    assert_eq!(brute::faults(task, &given), [], "{name}");
}

fn sequences(c: &mut Criterion) {
    let mut group = c.benchmark_group("sequence");
    group.sample_size(10);
    let (builder, weight) = (frames::builder(), frames::abs());
    for (name, structure) in frames::both() {
        let groups = Groups::single(&structure);
        let task = Task { structure: &structure, groups: &groups, builder: &builder, weight: &weight };
        confirm(name, &task, &searched(&task));
        group.bench_function(name, |b| b.iter(|| searched(black_box(&task))));
        confirm(name, &task, &by_paper(&task));
        group.bench_function(format!("{name}-by-paper"), |b| b.iter(|| by_paper(black_box(&task))));
        group.bench_function(format!("{name}-layers"), |b| {
            b.iter(|| layers(black_box(&task), &[], &LayerOptions::default()).unwrap());
        });
    }
    group.finish();
}

criterion_group!(benches, sequences);
criterion_main!(benches);
