//! What a simulated machine has to know, so that its wire comes out as a real one would.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A bender, a wire, and how far both are from perfect.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Bench {
    /// The bender.
    pub bender: BenchBender,
    /// The wire.
    pub wire: BenchWire,
    /// Errors of the machine; absent: it has none.
    #[serde(default)]
    pub noise: Option<BenchNoise>,
}

/// A bender with a pin inside of the bend and a peg that goes about it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct BenchBender {
    /// Radius of the pins that the wire is bent about, mm.
    pub pin_radius_mm: f64,
    /// Radius of the rod of the peg, mm.
    pub rod_radius_mm: f64,
    /// Radius of the circle on which the middle of the peg goes, mm.
    pub orbit_radius_mm: f64,
    /// From the exit of the nozzle to the middle of that circle, along the wire, mm.
    pub orbit_offset_mm: f64,
    /// How far the bend axis goes to each side, degrees. At zero the middle of the peg is on the wire's axis.
    pub axis_limit_deg: f64,
    /// Wire that is fed for each mm that the motor makes by its steps.
    #[serde(default = "exact")]
    pub feed_scale: f64,
    /// What each turn of the head is off by, degrees, in the machine's sign.
    #[serde(default)]
    pub rotate_offset_deg: f64,
    /// What a turn of the head loses that goes against the one before, degrees.
    #[serde(default)]
    pub rotate_backlash_deg: f64,
}

const fn exact() -> f64 {
    1.0
}

/// A round wire.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct BenchWire {
    /// Diameter, mm.
    pub diameter_mm: f64,
    /// Where its neutral fibre is in a bend: fraction of the diameter, from the inner face.
    pub k_factor: f64,
    /// Young's modulus, `GPa`.
    pub youngs_modulus_gpa: f64,
    /// Yield strength, `MPa`.
    pub yield_strength_mpa: f64,
    /// Ultimate strength, `MPa`.
    pub ultimate_strength_mpa: f64,
}

/// Errors of a machine, drawn anew for each of its moves. The same seed gives the same wire.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct BenchNoise {
    /// Where the row of random numbers begins.
    pub seed: u64,
    /// Of each feed, mm.
    #[serde(default)]
    pub feed_mm: Spread,
    /// Of each rotation, degrees.
    #[serde(default)]
    pub rotate_deg: Spread,
    /// Of each bend, degrees.
    #[serde(default)]
    pub bend_deg: Spread,
}

/// A normal distribution, in the unit of what it is of.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Spread {
    /// Its mean: what is wrong every time.
    #[serde(default)]
    pub bias: f64,
    /// Its standard deviation.
    #[serde(default)]
    pub sigma: f64,
}
