//! The bodies of a machine: what it looks like, and what a wire can hit.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::profile::Fault;

/// What a body moves with.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Part {
    /// It stands still.
    Frame,
    /// It turns with the head about the wire.
    Head,
    /// It goes with the bend axis, which turns with the head.
    Peg,
}

/// A solid about its own centre.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub enum Solid {
    /// A box.
    Box {
        /// Its edges along x, y and z, millimetres.
        size_mm: [f64; 3],
    },
    /// A cylinder about `axis`.
    Cylinder {
        /// Its radius, millimetres.
        radius_mm: f64,
        /// Its length, millimetres.
        length_mm: f64,
    },
}

/// A body of a machine. Frame: the origin is where a bend begins, x the way the wire leaves, z the bend axis, right-handed;
/// the head at its reference, the bend axis at 0.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Shape {
    /// What it is called.
    #[schemars(length(min = 1))]
    pub name: String,
    /// What it moves with.
    pub part: Part,
    /// What it is.
    pub solid: Solid,
    /// Its centre, millimetres.
    pub at_mm: [f64; 3],
    /// Where a cylinder's axis, or the z of a box, points; of any length. Absent: along z.
    #[serde(default = "along_z")]
    pub axis: [f64; 3],
    /// So far from the bend point, along the wire that is being bent, that wire may touch the body, millimetres: for what
    /// guides or bends the wire. Absent: nowhere.
    #[serde(default, skip_serializing_if = "is_zero")]
    #[schemars(range(min = 0.0))]
    pub contact_zone_mm: f64,
    /// So far from a vertex other struts that meet there may touch the body, millimetres: they give way. Only with
    /// `contact_zone_mm`. Absent: nowhere.
    #[serde(default, skip_serializing_if = "is_zero")]
    #[schemars(range(min = 0.0))]
    pub vertex_zone_mm: f64,
    /// Where the dimensions come from: a drawing, a measurement, or why they are estimates.
    #[schemars(length(min = 1))]
    pub source: String,
    /// True when they were measured on the real machine.
    pub measured: bool,
}

const fn along_z() -> [f64; 3] {
    [0.0, 0.0, 1.0]
}

#[allow(clippy::trivially_copy_pass_by_ref)] // as serde calls it
fn is_zero(value: &f64) -> bool {
    *value == 0.0
}

impl Shape {
    /// What cannot be in one.
    pub(crate) fn faults(&self, faults: &mut Vec<Fault>) {
        let sizes = match self.solid {
            Solid::Box { size_mm } => size_mm.to_vec(),
            Solid::Cylinder { radius_mm, length_mm } => vec![radius_mm, length_mm],
        };
        for size in sizes.into_iter().filter(|size| *size <= 0.0) {
            faults.push(Fault::new("shapes", size, format!("sizes of '{}' above 0", self.name)));
        }
        let zones = [self.contact_zone_mm, self.vertex_zone_mm];
        for zone in zones.into_iter().filter(|zone| *zone < 0.0) {
            faults.push(Fault::new("shapes", zone, format!("zones of '{}' of 0 or more", self.name)));
        }
        if self.contact_zone_mm <= 0.0 && self.vertex_zone_mm > 0.0 {
            let expected = format!("a contact_zone_mm of '{}' above 0 beside its vertex_zone_mm", self.name);
            faults.push(Fault::new("shapes", self.contact_zone_mm, expected));
        }
        if self.axis.iter().all(|part| *part == 0.0) {
            let expected = format!("a direction for the axis of '{}' that is not 0 0 0", self.name);
            faults.push(Fault::new("shapes", "an axis without direction", expected));
        }
    }
}
