//! What a driver is given to write or to run.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A planned design. It does not change; two jobs with the same hash are the same.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Job {
    /// Name of the design, for comments.
    pub name: String,
    /// Hash of the job where it has been sealed.
    #[serde(default)]
    pub job_hash: Option<String>,
    /// Hash of the design that it was planned from. Files carry it in a comment where they can.
    pub design_hash: String,
    /// The machine that it was planned for.
    pub machine: MachineRef,
    /// The wire that it was planned for.
    pub material: MaterialRef,
    /// Centreline radius of the machine's bends, mm.
    pub bend_radius_mm: f64,
    /// The wires, in the order in which they are bent.
    pub wires: Vec<Wire>,
}

/// A machine profile.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct MachineRef {
    /// Its id.
    pub id: String,
    /// Its name.
    pub name: String,
}

/// A material profile.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct MaterialRef {
    /// Its id.
    pub id: String,
    /// Its name.
    pub name: String,
    /// Diameter of the wire, mm.
    pub diameter_mm: f64,
}

/// One wire.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Wire {
    /// The points that it runs through, mm.
    pub path_mm: Vec<[f64; 3]>,
    /// The wire as designed: lengths from corner to corner, angles as they shall be, canonical signs.
    pub design: Vec<DesignStep>,
    /// What is sent to the machine's axes for each step of `design`: scheduled, compensated, in the
    /// machine's signs. Absent where the checks let none be made.
    #[serde(default)]
    pub machine: Option<Vec<Step>>,
    /// Wire that has to be put in, with what cannot be fed, mm.
    #[serde(default)]
    pub stock_mm: Option<f64>,
    /// Estimated time, s.
    #[serde(default)]
    pub time_s: Option<f64>,
}

/// Feed, then rotate, then bend.
///
/// Canonical signs: at the bending point a turtle looks along the wire, t the way in which the wire is
/// fed, b the axis of the bend. A positive rotate turns b about t, a positive bend turns t about b, both
/// by the right-hand rule. A machine's signs may be others.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Step {
    /// How far the wire is fed, mm.
    pub feed_mm: f64,
    /// How far it is turned about itself, degrees.
    pub rotate_deg: f64,
    /// How far it is bent, degrees.
    pub bend_deg: f64,
    /// Where the bend axis has to stand, or beyond, when the peg comes out to bend, degrees: of the other sign than the bend. Nearer
    /// to zero there is wire that was bent before. Absent where the machine's own place will do. Since 1.4.
    ///
    /// Since 1.6, for drivers with [`Capability::BeforeZero`](crate::Capability::BeforeZero) alone, it may have the sign of
    /// `bend_deg` and be farther from zero, or `bend_deg` be zero: the axis stops before zero, and bends to the other side than the
    /// one where the peg comes out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub approach_deg: Option<f64>,
}

impl Step {
    /// Whether its bend ends at zero or before it, on the side where the peg comes out.
    #[must_use]
    pub fn ends_before_zero(&self) -> bool {
        self.approach_deg.is_some_and(|at| at * self.bend_deg >= 0.0)
    }
}

/// A step of the design, with the length of its straight part: a type of its own, because its signs are the canonical ones
/// while those of a [`Step`] are the machine's.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct DesignStep {
    /// How far the wire is fed, from corner to corner, mm.
    pub feed_mm: f64,
    /// How far it is turned about itself, degrees.
    pub rotate_deg: f64,
    /// How far it is bent, degrees.
    pub bend_deg: f64,
    /// Length between the arcs at both ends for bends of the job's radius, mm. Below zero where they
    /// overlap; absent next to a bend of 180°, which has no corner.
    #[serde(default)]
    pub straight_mm: Option<f64>,
}

impl Wire {
    /// The machine's steps.
    ///
    /// # Errors
    /// [`DriverError::no_machine_steps`](crate::DriverError::no_machine_steps) for the wire of this
    /// index where there are none.
    pub fn machine_steps(&self, index: usize) -> Result<&[Step], crate::DriverError> {
        self.machine.as_deref().ok_or_else(|| crate::DriverError::no_machine_steps(index))
    }
}
