//! The material profile: one wire of one alloy and diameter.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::profile::is_default;
use crate::sourced::{Reference, Sourced};

/// The `kind` of a material profile.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum MaterialTag {
    /// The only word.
    Material,
}

/// A wire: diameter, neutral fibre, springback, strength, density, price.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MaterialProfile {
    /// Address or path of the JSON Schema, for editors. Not read by the program.
    #[serde(rename = "$schema", default, skip_serializing_if = "Option::is_none")]
    pub schema: Option<String>,
    /// Version of this format.
    #[schemars(range(min = 1, max = 1))]
    pub schema_version: u32,
    /// Says that this is a material profile.
    pub kind: MaterialTag,
    /// Slug of lower-case letters, digits and hyphens; equals the file's name without `.json`.
    #[schemars(regex(pattern = r"^[a-z0-9]+(-[a-z0-9]+)*$"))]
    pub id: String,
    /// Id of the material profile that gives every value not set here.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub inherits: Option<String>,
    /// True for a base that only serves to be inherited from and may leave values open.
    #[serde(rename = "abstract", default, skip_serializing_if = "is_default")]
    pub is_abstract: bool,
    /// Name for people.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// A few sentences: what wire this is, what was and was not measured.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub description: Option<String>,
    /// Alloy, as a buyer names it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub alloy: Option<String>,
    /// Temper or condition.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub temper: Option<String>,
    /// Diameter of the wire, millimetres.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub diameter_mm: Option<Sourced<f64>>,
    /// Depth of the neutral fibre from the inner face of a bend, as a fraction of the diameter.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub k_factor: Option<Sourced<f64>>,
    /// What the wire loses when it is let go. Replaced whole by a child.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub springback: Option<Springback>,
    /// Young's modulus, gigapascal.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub youngs_modulus_gpa: Option<Sourced<f64>>,
    /// Yield strength, megapascal.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub yield_strength_mpa: Option<Sourced<f64>>,
    /// Ultimate strength, megapascal.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub ultimate_strength_mpa: Option<Sourced<f64>>,
    /// Density, kilograms a cubic metre.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub density_kg_per_m3: Option<Sourced<f64>>,
    /// Price of a millimetre of wire in `currency`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub price_per_mm: Option<Sourced<f64>>,
    /// ISO 4217 code of the price.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(regex(pattern = r"^[A-Z]{3}$"))]
    pub currency: Option<String>,
    /// Publications that the `source` texts name.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sources: Option<Vec<Reference>>,
}

/// How much of a bend the wire loses when it is let go. Angles in degrees, unsigned.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "model", rename_all = "kebab-case", deny_unknown_fields)]
pub enum Springback {
    /// The same loss at every angle.
    Constant {
        /// The loss, degrees, 0 or above.
        angle_deg: Sourced<f64>,
    },
    /// Measured or computed pairs, linear between them.
    Table {
        /// Pairs of bends of positive sign, formed angles ascending.
        #[schemars(length(min = 2))]
        positive: Vec<LossPoint>,
        /// Pairs of bends of negative sign; absent: as `positive`.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        #[schemars(length(min = 2))]
        negative: Option<Vec<LossPoint>>,
        /// Where the pairs come from.
        #[schemars(length(min = 1))]
        source: String,
        /// True when somebody measured them.
        measured: bool,
    },
}

/// One pair of a springback table.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LossPoint {
    /// Formed angle, after springback, unsigned degrees.
    pub angle_deg: f64,
    /// Degrees that were lost: the bend was made to `angle_deg + loss_deg`.
    pub loss_deg: f64,
}
