//! The figures of a complete profile without their sources.

pub(crate) mod machine;
pub(crate) mod strut_builder;

use serde::{Deserialize, Serialize};

use crate::material::{MaterialProfile, Springback};
use crate::noise::NoiseProfile;
use crate::resolve::example;
use crate::sourced::Sourced;
use crate::{Profile, ProfileError, Resolved};

/// A kind of profile that has plain figures once it is complete.
pub trait Complete: Profile {
    /// The plain figures.
    type Figures;
    /// The plain figures, or `None` while a required one is not set.
    fn complete(&self) -> Option<Self::Figures>;
}

impl<T: Complete> Resolved<T> {
    /// The plain figures, for the stages that need no sources.
    ///
    /// # Errors
    /// [`ProfileError::Missing`] for a profile that did not come from a library and leaves a
    /// required value open.
    pub fn figures(&self) -> Result<T::Figures, ProfileError> {
        self.profile.complete().ok_or_else(|| {
            let open = self.profile.required().into_iter().find(|(key, _)| self.origin(key).is_none());
            let (key, how) = open.unwrap_or(("a required value", "see the JSON Schema"));
            ProfileError::Missing { file: self.profile.id().into(), key: key.into(), how: example(key, how) }
        })
    }
}

/// Figures of a complete material.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct MaterialFigures {
    /// Diameter, millimetres.
    pub diameter_mm: f64,
    /// Depth of the neutral fibre from the inner face, fraction of the diameter.
    pub k_factor: f64,
    /// Springback model.
    pub springback: Springback,
    /// Young's modulus, gigapascal.
    pub youngs_modulus_gpa: f64,
    /// Yield strength, megapascal.
    pub yield_strength_mpa: f64,
    /// Ultimate strength, megapascal.
    pub ultimate_strength_mpa: f64,
    /// Density, kilograms a cubic metre.
    pub density_kg_per_m3: f64,
    /// Price of a millimetre in `currency`.
    pub price_per_mm: Option<f64>,
    /// ISO 4217 code.
    pub currency: Option<String>,
    /// Shear modulus, gigapascal: as stated, or E/(2(1 + ν)) where Poisson's ratio is; `None` where neither is.
    #[serde(default)]
    pub shear_modulus_gpa: Option<f64>,
    /// Elongation at fracture, as a ratio.
    #[serde(default)]
    pub fracture_strain: Option<f64>,
    /// Energy that forming takes, megajoule a kilogram.
    #[serde(default)]
    pub process_energy_mj_per_kg: Option<f64>,
}

impl Complete for MaterialProfile {
    type Figures = MaterialFigures;

    fn complete(&self) -> Option<MaterialFigures> {
        let youngs_modulus_gpa = v(&self.youngs_modulus_gpa)?;
        let of_poisson = v(&self.poisson_ratio).map(|ratio| youngs_modulus_gpa / (2.0 * (1.0 + ratio)));
        Some(MaterialFigures {
            diameter_mm: v(&self.diameter_mm)?,
            k_factor: v(&self.k_factor)?,
            springback: self.springback.clone()?,
            youngs_modulus_gpa,
            yield_strength_mpa: v(&self.yield_strength_mpa)?,
            ultimate_strength_mpa: v(&self.ultimate_strength_mpa)?,
            density_kg_per_m3: v(&self.density_kg_per_m3)?,
            price_per_mm: v(&self.price_per_mm),
            currency: self.currency.as_deref().cloned(),
            shear_modulus_gpa: v(&self.shear_modulus_gpa).or(of_poisson),
            fracture_strain: v(&self.fracture_strain),
            process_energy_mj_per_kg: v(&self.process_energy_mj_per_kg),
        })
    }
}

/// A systematic and a random error in one unit.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct ErrorFigures {
    /// Systematic part.
    pub bias: f64,
    /// Standard deviation.
    pub sigma: f64,
}

/// Figures of a complete noise profile.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct NoiseFigures {
    /// Of a feed, millimetres.
    pub feed_mm: ErrorFigures,
    /// Of a formed bend, degrees.
    pub bend_deg: ErrorFigures,
    /// Of a head turn, degrees.
    pub rotate_deg: ErrorFigures,
    /// Bow of a strut: rise over the distance of its ends.
    pub curvature: ErrorFigures,
}

impl Complete for NoiseProfile {
    type Figures = NoiseFigures;

    fn complete(&self) -> Option<NoiseFigures> {
        let error = |bias, sigma| Some(ErrorFigures { bias: v(bias)?, sigma: v(sigma)? });
        Some(NoiseFigures {
            feed_mm: error(&self.feed.bias_mm, &self.feed.sigma_mm)?,
            bend_deg: error(&self.bend.bias_deg, &self.bend.sigma_deg)?,
            rotate_deg: error(&self.rotate.bias_deg, &self.rotate.sigma_deg)?,
            curvature: error(&self.curvature.bias, &self.curvature.sigma)?,
        })
    }
}

/// The plain value of a figure that is set.
#[expect(clippy::ref_option, reason = "profiles hold optional figures; a field is passed as it is")]
pub(crate) fn v(figure: &Option<Sourced<f64>>) -> Option<f64> {
    figure.as_ref().map(|figure| figure.value)
}
