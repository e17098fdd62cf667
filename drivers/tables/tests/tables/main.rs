//! What the driver writes: examples from elsewhere, each setting, and what holds for every wire.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)] // a test may stop at what cannot be

mod examples;
mod properties;
mod refusals;
mod rounding;
mod settings;

use serde_json::{Value, json};
use wirebend_driver_api::conformance::{self, sample_job};
use wirebend_driver_api::{DesignStep, DriverError, Encoded, Job, MachineDriver};
use wirebend_driver_tables::{Settings, Tables};

#[test]
fn keeps_the_rules() {
    conformance::assert_kept::<Tables>();
}

/// Settings as a profile gives them.
fn open(settings: Value) -> Result<Tables, DriverError> {
    let settings: Settings = serde_json::from_value(settings).expect("settings of the right shape");
    Tables::open(settings)
}

fn encoded(format: &str, settings: Value, job: &Job) -> Encoded {
    open(settings).unwrap().encode(format, job).unwrap()
}

fn table(format: &str, settings: Value, job: &Job) -> String {
    encoded(format, settings, job).files.remove(0).text
}

/// A table without its header, at so many decimals, with more settings.
fn rows(format: &str, decimals: u8, more: &Value, job: &Job) -> String {
    let mut settings = json!({"decimals": decimals, "header": false});
    for (key, value) in more.as_object().into_iter().flatten() {
        settings[key] = value.clone();
    }
    table(format, settings, job)
}

/// A job of one wire of feed, rotate and bend, with bends of this radius.
fn job_of(radius_mm: f64, steps: &[(f64, f64, f64)]) -> Job {
    let mut job = sample_job();
    job.bend_radius_mm = radius_mm;
    job.wires[0].machine = None;
    // Half an angle's tangent at each end; a bend of 180° has no corner and so no length beside it.
    let taken = |bend: f64| (bend.abs() < 179.9).then(|| radius_mm * (bend.abs().to_radians() / 2.0).tan());
    let mut before = Some(0.0);
    let mut design = Vec::new();
    for &(feed_mm, rotate_deg, bend_deg) in steps {
        let after = taken(bend_deg);
        let straight_mm = before.zip(after).map(|(before, after)| feed_mm - before - after);
        design.push(DesignStep { feed_mm, rotate_deg, bend_deg, straight_mm });
        before = after;
    }
    job.wires[0].design = design;
    job
}
