//! The strut-builder profile: a machine that builds a frame strut by strut.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::heading::profile;
use crate::profile::layer;
use crate::sourced::{Noted, Sourced};

profile! {
    /// A machine that builds a frame strut by strut: an extruder, a welder or a gripper on an arm.
    ///
    /// Lengths in millimetres, angles in degrees, times in seconds. Directions and the workspace are in the frame of the
    /// design, right-handed, z up.
    pub struct StrutBuilderProfile: StrutBuilderTag::StrutBuilder, "strut-builder" {
        /// A few sentences: what machine this is, what was and was not verified.
        description;
        /// How a strut comes to be.
        pub process: Option<Noted<StrutProcess>>,
        /// Id of the material that struts are made of unless a person asks otherwise.
        pub default_material: Option<Noted<String>>,
        /// The tool, from its tip. Replaced whole by a child.
        pub head: Option<ToolHead>,
        /// Which directions of the tool's axis are tried.
        pub directions: HeadDirections,
        /// How far the tool's axis may lean towards its motion.
        pub approach_deg: ApproachAngles,
        /// How exactly the tool finds a joint, millimetres: a joint that sags more than the strut's radius less this is
        /// missed.
        pub position_tolerance_mm: Option<Sourced<f64>>,
        /// How far the tool stays from struts that do not meet at its joint, surface to surface, millimetres.
        pub clearance_mm: Option<Sourced<f64>>,
        /// Speeds.
        pub speed: BuildSpeed,
        /// How long the tool waits at each joint, seconds: to cool, to weld, to grip.
        pub pause_per_joint_s: Option<Sourced<f64>>,
        /// Where the tip can be; absent: everywhere. Replaced whole by a child.
        pub workspace: Option<Workspace>,
        /// Whether the struts that stand on the ground are built before all others.
        pub ground_first: Option<Noted<bool>>,
    }
}

/// How a strut comes to be.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum StrutProcess {
    /// It is extruded from joint to joint.
    Extrude,
    /// A rod is held and welded at its joints.
    Weld,
    /// A rod or a bent wire is put in place and fastened.
    Place,
}

/// A convex solid of revolution about the tool's axis. The tip is at the joint, the axis points from it to the machine.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ToolHead {
    /// Half of its section: distance from the tip along the axis, rising from 0, and the radius there. Straight between two
    /// points; a first radius above 0 is a flat tip; at the last point it ends.
    #[schemars(length(min = 2))]
    pub outline: Vec<HeadPoint>,
    /// Where the dimensions come from: a drawing, a measurement, or why they are estimates.
    #[schemars(length(min = 1))]
    pub source: String,
    /// True when they were measured on the real machine.
    pub measured: bool,
}

/// A point of the outline of a tool.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct HeadPoint {
    /// Distance from the tip along the axis, millimetres.
    pub z_mm: f64,
    /// Radius there, millimetres.
    pub r_mm: f64,
}

layer! {
    /// Which directions of the tool's axis are tried, in the frame of the design.
    pub struct HeadDirections {
        /// Step of the polar angle and of the angle about z, degrees: 18 gives both poles and 9 rings of 20.
        pub step_deg: Sourced<f64>,
    }
}

layer! {
    /// Largest angle between the tool's axis, from the tip to the machine, and the direction of its motion along the strut,
    /// degrees.
    pub struct ApproachAngles {
        /// Of a strut from a built joint to a new one.
        pub create: Sourced<f64>,
        /// Of a strut between two built joints.
        pub connect: Sourced<f64>,
    }
}

layer! {
    /// Speeds of the tip.
    pub struct BuildSpeed {
        /// While a strut is built, millimetres a second.
        pub strut_mm_per_s: Sourced<f64>,
        /// Between struts, millimetres a second.
        pub travel_mm_per_s: Sourced<f64>,
    }
}

/// A box that the tip stays in, in the frame of the design.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Workspace {
    /// Its lowest corner, millimetres.
    pub min_mm: [f64; 3],
    /// Its highest corner, millimetres.
    pub max_mm: [f64; 3],
    /// Where it comes from.
    #[schemars(length(min = 1))]
    pub source: String,
    /// True when it was measured on the real machine.
    pub measured: bool,
}
