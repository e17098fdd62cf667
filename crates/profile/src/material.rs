//! The material profile: one wire of one alloy and diameter.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::heading::profile;
use crate::sourced::{Noted, Sourced};

profile! {
    /// A wire: diameter, neutral fibre, springback, stiffness, strength, density, price.
    pub struct MaterialProfile: MaterialTag::Material, "material" {
        /// A few sentences: what wire this is, what was and was not measured.
        description;
        /// Alloy, as a buyer names it.
        pub alloy: Option<String>,
        /// Temper or condition.
        pub temper: Option<String>,
        /// Diameter of the wire, millimetres.
        pub diameter_mm: Option<Sourced<f64>>,
        /// Depth of the neutral fibre from the inner face of a bend, as a fraction of the diameter.
        pub k_factor: Option<Sourced<f64>>,
        /// What the wire loses when it is let go. Replaced whole by a child.
        pub springback: Option<Springback>,
        /// Young's modulus, gigapascal.
        pub youngs_modulus_gpa: Option<Sourced<f64>>,
        /// Shear modulus, gigapascal. Either this or `poisson_ratio`, never both; a child that states one takes the other
        /// away. Without either, no frame of this wire can be computed.
        pub shear_modulus_gpa: Option<Sourced<f64>>,
        /// Poisson's ratio: more than -1, up to 0.5.
        pub poisson_ratio: Option<Sourced<f64>>,
        /// Yield strength, megapascal.
        pub yield_strength_mpa: Option<Sourced<f64>>,
        /// Ultimate strength, megapascal.
        pub ultimate_strength_mpa: Option<Sourced<f64>>,
        /// Elongation at fracture, as a ratio: 0.2 is 20 percent.
        pub fracture_strain: Option<Sourced<f64>>,
        /// Smallest inner radius of a bend that the wire takes without cracks, in diameters of the wire.
        pub min_bend_radius_diameters: Option<Sourced<f64>>,
        /// Energy that the process takes to form a kilogram of this wire, megajoule a kilogram.
        pub process_energy_mj_per_kg: Option<Sourced<f64>>,
        /// Density, kilograms a cubic metre.
        pub density_kg_per_m3: Option<Sourced<f64>>,
        /// Price of a millimetre of wire in `currency`.
        pub price_per_mm: Option<Sourced<f64>>,
        /// ISO 4217 code of the price.
        pub currency: Option<Noted<String>>,
    }
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
        /// True when they were measured.
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
