//! Checks of a design, before any machine is asked.

mod coincident;
mod edges_meet;
mod parallel_edges;
mod wires;
mod zero_length;

use super::Diagnostic;
use crate::units::Length;
use crate::wireframe::{Component, Wireframe};

/// A wireframe and how thick its wire is, before any machine is asked.
#[derive(Debug, Clone, Copy)]
pub struct Design<'a> {
    /// The wireframe.
    pub wireframe: &'a Wireframe,
    /// Its components.
    pub components: &'a [Component],
    /// Vertices closer than this are taken to be meant as one.
    pub weld_tolerance: Length,
    /// How thick the wire is.
    pub diameter: Length,
}

/// Everything worth saying about a design, in the order of the checks.
#[must_use]
pub fn check_design(design: &Design) -> Vec<Diagnostic> {
    let checks =
        [zero_length::check, parallel_edges::check, coincident::check, edges_meet::check, wires::check];
    let mut found = Vec::new();
    for check in checks {
        check(design, &mut found);
    }
    found
}

/// Edges of such a diameter that run through each other where no vertex joins them, which nothing can be built of: nearer than half of
/// it, also where one ends there. `tolerance`: up to this far apart vertices are taken for one.
#[must_use]
pub fn check_crossings(wireframe: &Wireframe, diameter: Length, tolerance: Length) -> Vec<Diagnostic> {
    let mut found = Vec::new();
    let design = Design { wireframe, components: &[], weld_tolerance: tolerance, diameter };
    edges_meet::check_rigid(&design, &mut found);
    found.retain(Diagnostic::is_error);
    found
}
