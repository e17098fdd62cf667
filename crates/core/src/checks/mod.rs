//! Checks: what cannot be made and why, each with its measured value, the limit, where the limit
//! comes from and what to do.
//!
//! A check is one file. The checks of a design, in `design`, look at the wireframe alone; those of a wire look at
//! whatever stages it has got through, so that a design that cannot be bent is still explained.

mod bend_angle;
mod code;
mod contact;
mod corner_within_reach;
mod design;
mod diagnostic;
mod edge_length;
mod euler_path;
mod fact;
mod feed_length;
mod fold_back;
mod limit;
mod remedy;
mod rotation;
pub mod sequence;
mod sharp_vertex;
mod slight_bend;
mod small_corner;
mod stock_length;
mod strength;
mod wire_diameter;

pub use code::Code;
pub use design::{Design, check_crossings, check_design};
pub use diagnostic::{Diagnostic, Location, Severity};
pub(crate) use euler_path::check_odd;
pub use fact::{BendOf, ClosingBend, Fact, Meeting};
pub use limit::{Limit, LimitSource, Quantity, ReachLimit, Source, Sourced};
pub use remedy::Remedy;
pub use strength::TORQUE_MARGIN;

use crate::bend::NominalProgram;
use crate::clearance::{Body, FirstContact};
use crate::compensate::{CompensatedProgram, Compensation, StepError};
use crate::route::{Doubling, ForcedBend, Route};
use crate::sag::Sag;
use crate::schedule::{RotationOutOfRange, ScheduledProgram};
use crate::units::{Angle, Length};
use crate::wireframe::{Component, EdgeId, NEAR_LIMIT, VertexId, Wireframe};

/// What a machine can do.
#[derive(Debug, Clone, PartialEq)]
pub struct MachineLimits {
    /// The bend farthest to the negative side; zero or less.
    pub min_bend: Sourced<Angle>,
    /// The bend farthest to the positive side; zero or more.
    pub max_bend: Sourced<Angle>,
    /// The shortest designed edge between two bends.
    pub min_edge: Sourced<Length>,
    /// The shortest feed.
    pub min_feed: Sourced<Length>,
    /// The longest single feed, if there is one.
    pub max_feed: Option<Sourced<Length>>,
    /// The longest stock that it takes, if there is one.
    pub max_stock: Option<Sourced<Length>>,
    /// The end of the stock that cannot be fed.
    pub tail: Sourced<Length>,
    /// The thinnest wire.
    pub min_diameter: Sourced<Length>,
    /// The thickest wire.
    pub max_diameter: Sourced<Length>,
    /// What the bend axis can give for what its wire asks, where both are known.
    pub bend_torque: Option<BendTorque>,
    /// What the pin bends the wire to beside what its material takes, where that is stated.
    pub bend_radius: Option<BendRadius>,
    /// Where the lower limit of the head's rotation comes from; [`HeadLimits`](crate::schedule::HeadLimits) has its value.
    pub min_rotation_source: Source,
    /// Where the upper limit of the head's rotation comes from.
    pub max_rotation_source: Source,
    /// Where the limit of the bend axis comes from; `BendModel` has its value.
    pub axis_source: Source,
    /// Whether it bends about a peg whose orbit was not measured.
    pub head_not_measured: bool,
}

/// The torque of a bend axis beside that which bends its wire.
#[derive(Debug, Clone, PartialEq)]
pub struct BendTorque {
    /// What the axis has for the wire, N·m.
    pub available_n_m: Sourced<f64>,
    /// Plastic moment of the wire, N·m.
    pub needed_n_m: f64,
}

impl BendTorque {
    /// Beside a round wire: its plastic moment is σ·d³/6, with the ultimate strength σ for what it hardens.
    #[must_use]
    pub fn beside(available_n_m: Sourced<f64>, diameter: Length, ultimate_strength_mpa: f64) -> Self {
        Self { available_n_m, needed_n_m: ultimate_strength_mpa * diameter.mm().powi(3) / 6.0 / 1000.0 }
    }
}

/// The radius that a wire is bent to beside the smallest that it takes.
#[derive(Debug, Clone, PartialEq)]
pub struct BendRadius {
    /// Of the inside of every bend: that of the pin.
    pub inner: Length,
    /// Within how much of that it is known; zero where nothing is said of it.
    pub inner_within: Length,
    /// Of the wire.
    pub diameter: Length,
    /// The smallest inner radius that the material takes, in diameters.
    pub least_diameters: Sourced<f64>,
}

impl BendRadius {
    /// The smallest inner radius that the wire takes.
    #[must_use]
    pub fn least(&self) -> Length {
        Length::computed(self.diameter.mm() * self.least_diameters.value)
    }
}

/// One wire, with the stages that it has got through.
#[derive(Debug, Clone, Copy)]
pub struct WireStages<'a> {
    /// The wireframe.
    pub wireframe: &'a Wireframe,
    /// The component that this wire covers.
    pub component: &'a Component,
    /// Edges that are travelled twice.
    pub doubled: &'a [EdgeId],
    /// How many vertices of it may be odd.
    pub odd_allowed: usize,
    /// The cheapest doubling, where it has no route without one.
    pub proposal: Option<&'a Doubling>,
    /// Bends that no route avoids, or without a route none with the proposed doubling.
    pub forced: &'a [ForcedBend],
    /// Edges that are passed more than once, and how often: by this wire, or by several of which it is the last.
    pub passed_again: &'a [(EdgeId, usize)],
    /// Its route.
    pub route: Option<&'a Route>,
    /// Its nominal program.
    pub nominal: Option<&'a NominalProgram>,
    /// Its schedule.
    pub scheduled: Option<&'a ScheduledProgram>,
    /// Why it has none.
    pub rotation: Option<&'a RotationOutOfRange>,
    /// Its compensated program.
    pub compensated: Option<&'a CompensatedProgram>,
    /// Why it has none.
    pub unbendable: &'a [StepError],
    /// Whether a walk, signs and windings that meet nothing were searched for.
    pub searched: bool,
    /// How far the part already bent sags at most; none where nobody asked.
    pub sag: Option<Sag>,
    /// Where it meets the machine or itself, as far as somebody looked.
    pub contacts: &'a [FirstContact],
    /// The bodies of the machine.
    pub bodies: &'a [Body],
    /// How it is compensated for.
    pub compensation: &'a Compensation,
    /// How thick it is.
    pub diameter: Length,
    /// Centreline radius of its bends, whether or not feeds are compensated for them.
    pub bend_radius: Length,
    /// A change of direction up to this is not bent.
    pub straight: Angle,
    /// How far bends scatter on the machine (one standard deviation), where that is known.
    pub scatter: Option<&'a Sourced<Angle>>,
    /// What the machine can do.
    pub limits: &'a MachineLimits,
}

impl WireStages<'_> {
    /// The vertex at which a step bends, or at which the wire ends.
    fn vertex_of_step(&self, step: usize) -> Option<VertexId> {
        let last = self.nominal?.spans.get(step)?.end.checked_sub(1)?;
        Some(self.route?.traversals.get(last)?.to)
    }

    /// The edges along which a step feeds.
    fn edges_of_step(&self, step: usize) -> Vec<EdgeId> {
        let span = self.nominal.and_then(|program| program.spans.get(step)).cloned();
        let traversals = self.route.zip(span).and_then(|(route, span)| route.traversals.get(span));
        traversals.into_iter().flatten().map(|t| t.edge).collect()
    }

    /// A step, the vertex at its bend and the edges of its feed.
    fn location_of_step(&self, step: usize) -> Location {
        Location {
            vertices: self.vertex_of_step(step).into_iter().collect(),
            edges: self.edges_of_step(step),
            step: Some(step),
        }
    }
}

/// Everything worth saying about a wire on a machine, in the order of the checks.
#[must_use]
pub fn check_wire(wire: &WireStages) -> Vec<Diagnostic> {
    let checks = [
        euler_path::check,
        edge_length::check,
        bend_angle::check,
        sharp_vertex::check,
        slight_bend::check,
        fold_back::check,
        corner_within_reach::check,
        small_corner::check,
        feed_length::check,
        rotation::check,
        stock_length::check,
        wire_diameter::check,
        strength::torque,
        strength::radius,
        strength::sag,
        contact::check,
    ];
    let mut found = Vec::new();
    for check in checks {
        check(wire, &mut found);
    }
    found
}

/// What is said of the contacts of a wire alone, one for each in their order.
pub(crate) fn check_contacts(wire: &WireStages) -> Vec<Diagnostic> {
    let mut found = Vec::new();
    contact::check(wire, &mut found);
    found
}

/// What arithmetic may leave between a value and a limit that it is at, mm or degrees.
const ROUNDING: f64 = 1e-9;

/// Whether a value is on the right side of a limit, but near it.
fn is_near(distance: f64, limit: f64) -> bool {
    distance >= 0.0 && distance < NEAR_LIMIT * limit.abs()
}

#[cfg(test)]
mod tests;
