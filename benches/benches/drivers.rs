//! Drivers behind a process of their own: what that costs, and how long a stop takes when the driver hangs.

#![allow(missing_docs)] // criterion's macros make public functions
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)] // a benchmark may stop at what cannot be

use std::path::{Path, PathBuf};
use std::time::Duration;

use criterion::{BatchSize, Criterion, criterion_group, criterion_main};
use serde_json::json;
use template_driver::Template;
use wirebend_driver_host::api::conformance::sample_job;
use wirebend_driver_host::api::{Job, MachineDriver};
use wirebend_driver_host::{DiscoveredDriver, Driver, Launch, Place, Session, StoppedBy, TrustStore};

const FORMAT: &str = "template-text";

fn launch() -> Launch {
    Launch { program: wirebend_tests_built::driver_child(), memory_bytes: 512 << 20 }
}

fn found(file: &Path) -> DiscoveredDriver {
    DiscoveredDriver::at(file, Place::App, &TrustStore::open(Path::new("none.json")).unwrap())
}

/// A wire of a thousand steps with numbers as long as they come out of a plan.
fn long_job() -> Job {
    let mut job = sample_job();
    let wire = &mut job.wires[0];
    let (design, machine) = (wire.design.clone(), wire.machine.clone().unwrap());
    let odd = |k: usize| 1.0 + 1.0 / (3.0 + f64::from(u32::try_from(k).unwrap()));
    wire.design = design.iter().copied().cycle().take(1000).collect();
    let steps = machine.iter().copied().cycle().take(1000).enumerate();
    wire.machine = Some(
        steps
            .map(|(k, mut step)| {
                (step.feed_mm, step.rotate_deg, step.bend_deg) =
                    (step.feed_mm * odd(k), step.rotate_deg * odd(k), step.bend_deg * odd(k));
                step
            })
            .collect(),
    );
    for (k, step) in wire.design.iter_mut().enumerate() {
        step.feed_mm *= odd(k);
    }
    wire.path_mm = (0..1001).map(|k| [f64::from(k) / 3.0, f64::from(k) / 7.0, f64::from(k) / 9.0]).collect();
    job
}

fn start(c: &mut Criterion) {
    let (found, launch) = (found(&wirebend_tests_built::driver("template")), launch());
    let mut group = c.benchmark_group("driver");
    group.sample_size(50);
    group.bench_function("start", |b| {
        b.iter_batched(|| (), |()| Driver::start(&found, &launch).unwrap(), BatchSize::PerIteration);
    });
    group.finish();
}

fn encode(c: &mut Criterion) {
    let job = long_job();
    let mut group = c.benchmark_group("driver-encode-1000");
    let here = Template::open(template_driver::Settings::default()).unwrap();
    group.bench_function("in-process", |b| b.iter(|| here.encode(FORMAT, &job).unwrap()));
    let found = found(&wirebend_tests_built::driver("template"));
    let there = Driver::start(&found, &launch()).unwrap().open(&json!({})).unwrap();
    let text = |files: &wirebend_driver_host::api::Encoded| files.files[0].text.clone();
    assert_eq!(text(&here.encode(FORMAT, &job).unwrap()), text(&there.encode(FORMAT, job.clone()).unwrap()));
    group.bench_function("child-process", |b| {
        b.iter_batched(|| job.clone(), |job| there.encode(FORMAT, job).unwrap(), BatchSize::SmallInput);
    });
    group.finish();
}

/// The driver hangs in the very call that stops it, the worst that it can do.
fn stop(c: &mut Criterion) {
    let folder = tempfile::tempdir().unwrap();
    let file: PathBuf = folder.path().join("stop-hang.so");
    std::fs::copy(wirebend_tests_built::driver("hostile"), &file).unwrap();
    let (found, launch) = (found(&file), launch());
    let mut group = c.benchmark_group("driver");
    group.sample_size(10).warm_up_time(Duration::from_millis(500));
    group.bench_function("stop-of-one-that-hangs", |b| {
        b.iter_custom(|count| {
            (0..count)
                .map(|_| {
                    let open = Driver::start(&found, &launch).unwrap().open(&json!({})).unwrap();
                    let outcome = Session::connect(open, "anywhere", None).unwrap().stop();
                    assert_eq!(outcome.by, StoppedBy::EndOfDriver);
                    outcome.took
                })
                .sum()
        });
    });
    group.finish();
}

criterion_group!(benches, start, encode, stop);
criterion_main!(benches);
