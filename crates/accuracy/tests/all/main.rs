//! Closed frames against figures that were found before this program by other means: closed formulas, an independent program of matrices
//! checked with `OpenSees`, and the nonlinear runs of the authors of Bend-Forming.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)] // a test may stop at what cannot be

mod angles;
mod bows;
mod frequencies;
mod lengths;
mod properties;
mod truss;

use wirebend_core::simulate::{ErrorModel, ErrorTerm};

fn sigma(sigma: f64) -> ErrorTerm {
    ErrorTerm { bias: 0.0, sigma }
}

/// Feeds with a standard deviation, mm.
fn feeds(mm: f64) -> ErrorModel {
    ErrorModel { feed_mm: sigma(mm), ..ErrorModel::default() }
}

/// Bends and rotations with a standard deviation, degrees.
fn angles(deg: f64) -> ErrorModel {
    ErrorModel { bend_deg: sigma(deg), rotate_deg: sigma(deg), ..ErrorModel::default() }
}

#[track_caller]
fn near(value: f64, expected: f64, part: f64) {
    assert!((value / expected - 1.0).abs() < part, "{value} instead of {expected}");
}
