//! The machine profile: what a bender can do, in its own figures.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};

use crate::heading::profile;
use crate::profile::layer;
use crate::shape::Shape;
use crate::sourced::{Noted, Sign, Sourced};

profile! {
    /// A wire bender: driver, export formats, limits, axes, compensation and sign conventions.
    ///
    /// Lengths in millimetres, angles in degrees, times in seconds. Signs are canonical (right-handed
    /// turtle) except where a machine's own axis is named.
    pub struct MachineProfile: MachineTag::Machine, "machine" {
        /// A few sentences: what machine this is, what was and was not verified.
        description;
        /// Which driver speaks to the machine.
        pub driver: Driver,
        /// Which files can be written for it.
        pub export: Export,
        /// Id of the material that a new document starts with.
        pub default_material: Option<Noted<String>>,
        /// Wire that fits.
        pub wire: Wire,
        /// What may be asked of the machine.
        pub limits: Limits,
        /// Feed axis.
        pub feed: Feed,
        /// Rotate axis.
        pub rotate: Rotate,
        /// Bend axis and the geometry of its pin and peg.
        pub bend: Bend,
        /// What is compensated for this machine unless a person asks otherwise.
        pub compensation: Compensation,
        /// The machine's conventions against the canonical ones.
        pub signs: Signs,
        /// Time model beyond the rates of the axes.
        pub time: Time,
        /// What the machine looks like, and what a wire can hit.
        pub shapes: Option<Vec<Shape>>,
        /// Id of the noise profile with the scatter of this machine, for checks and for the accuracy of wires; `simulate` takes one by `--noise`.
        pub error: Option<Noted<String>>,
        /// The calibration that figures of this version of the machine and of its wire come from.
        pub calibrated: Calibrated,
    }
}

layer! {
    /// A calibration, as it was applied.
    pub struct Calibrated {
        /// The day of the measurement, such as `2026-11-25`.
        pub date: String,
        /// How many readings it was from, those that were left out aside.
        pub readings: u32,
        /// Id of the machine that it was made from.
        pub machine: String,
        /// Id of the wire that it was made from.
        pub material: String,
    }
}

layer! {
    /// Which driver speaks to the machine.
    pub struct Driver {
        /// Id of the driver.
        pub id: String,
        /// The driver's own settings; their schema is the driver's. Dropped by a child that names
        /// another driver.
        pub settings: Map<String, Value>,
        /// Bytes that stop the machine at once, whatever else it was sent: what the program itself writes to
        /// the port when the driver does not answer any more. Dropped like the settings.
        pub stop_bytes: Vec<u8>,
        /// Text that the machine sends once it stands after its stop bytes, by which the program knows that it does.
        /// Dropped like the settings.
        pub stop_reply: String,
    }
}

layer! {
    /// Which files can be written for the machine.
    pub struct Export {
        /// Ids of built-in formats; the first is the default.
        pub formats: Vec<String>,
        /// Id of a format that the driver writes itself.
        pub native: String,
    }
}

layer! {
    /// Wire that fits the machine.
    pub struct Wire {
        /// Thinnest wire, millimetres.
        pub min_diameter_mm: Sourced<f64>,
        /// Thickest wire, millimetres.
        pub max_diameter_mm: Sourced<f64>,
    }
}

layer! {
    /// What may be asked of the machine. Angles are canonical.
    pub struct Limits {
        /// Most negative formed angle, degrees, 0 or below.
        pub min_bend_deg: Sourced<f64>,
        /// Most positive formed angle, degrees, 0 or above.
        pub max_bend_deg: Sourced<f64>,
        /// Shortest designed edge, vertex to vertex, millimetres.
        pub min_edge_mm: Sourced<f64>,
        /// Shortest feed that can be commanded, after compensation, millimetres.
        pub min_feed_mm: Sourced<f64>,
        /// Longest feed that can be commanded at once, after compensation, millimetres; absent: no limit.
        pub max_feed_mm: Sourced<f64>,
        /// Longest stock that the machine takes, millimetres; absent: no limit (a spool).
        pub max_stock_mm: Sourced<f64>,
        /// End of the stock that cannot be fed, millimetres.
        pub tail_mm: Sourced<f64>,
        /// Lowest absolute head angle, degrees, 0 or below.
        pub min_rotation_deg: Sourced<f64>,
        /// Highest absolute head angle, degrees, 0 or above.
        pub max_rotation_deg: Sourced<f64>,
    }
}

layer! {
    /// Feed axis.
    pub struct Feed {
        /// Speed, millimetres a second.
        pub rate_mm_per_s: Sourced<f64>,
        /// Smallest step that can be commanded, millimetres.
        pub resolution_mm: Sourced<f64>,
        /// Wire that is fed for each commanded millimetre; 1 if absent.
        pub scale: Sourced<f64>,
    }
}

layer! {
    /// Rotate axis.
    pub struct Rotate {
        /// Speed, degrees a second.
        pub rate_deg_per_s: Sourced<f64>,
        /// Smallest step that can be commanded, degrees.
        pub resolution_deg: Sourced<f64>,
        /// What every turn is off by, degrees; none if absent.
        pub offset_deg: Sourced<f64>,
        /// What a turn loses that goes against the one before, degrees; nothing if absent.
        pub backlash_deg: Sourced<f64>,
    }
}

/// How the bend axis makes an angle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum BendMethod {
    /// A peg orbits off the pin's centre; the axis angle follows from the setback equation.
    Peg,
    /// The machine's axis angle is the bend angle.
    Direct,
}

layer! {
    /// Bend axis and its geometry. The centreline radius of a bend is pin radius plus wire radius.
    pub struct Bend {
        /// How the axis makes an angle.
        pub method: Noted<BendMethod>,
        /// Speed, degrees a second.
        pub rate_deg_per_s: Sourced<f64>,
        /// Smallest step that can be commanded, degrees.
        pub resolution_deg: Sourced<f64>,
        /// Radius of the pin that the wire wraps, millimetres.
        pub pin_radius_mm: Sourced<f64>,
        /// Peg: radius of the rod that pushes the wire, millimetres.
        pub rod_radius_mm: Sourced<f64>,
        /// Peg: radius R of the peg's orbit, millimetres.
        pub orbit_radius_mm: Sourced<f64>,
        /// Peg: offset s of the orbit's centre from the start of the bend along the wire,
        /// millimetres; below zero where it lies before it.
        pub orbit_offset_mm: Sourced<f64>,
        /// Largest commanded axis angle either way, degrees.
        pub axis_limit_deg: Sourced<f64>,
        /// Peg: whether the controller can be told to which side it bends, so that the axis of a small bend may stop at zero or
        /// before it, short of where the peg comes out; absent: no.
        pub before_zero: Noted<bool>,
        /// Torque that the axis has for the wire, newton metres; absent: not known.
        pub torque_n_m: Sourced<f64>,
    }
}

layer! {
    /// What is compensated for the machine by default.
    pub struct Compensation {
        /// Bend deduction of the feeds.
        pub feed: Noted<bool>,
        /// Setback of the peg.
        pub setback: Noted<bool>,
        /// Springback of the wire; false where the machine does it itself.
        pub springback: Noted<bool>,
    }
}

layer! {
    /// Machine value = sign times canonical value.
    pub struct Signs {
        /// Of the bend axis.
        pub bend: Noted<Sign>,
        /// Of the rotate axis.
        pub rotate: Noted<Sign>,
        /// How the machine's own frame lies and how the signs were found.
        pub note: String,
    }
}

layer! {
    /// Time model beyond the rates of the axes.
    pub struct Time {
        /// Time of a bend that is not the stroke: pin, settling; seconds.
        pub fixed_per_bend_s: Sourced<f64>,
        /// Time of a feed that is not its motion, such as a pause of the controller before it; seconds, none if absent.
        pub fixed_per_feed_s: Sourced<f64>,
        /// The same of a turn of the head.
        pub fixed_per_turn_s: Sourced<f64>,
    }
}
