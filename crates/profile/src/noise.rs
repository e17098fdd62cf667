//! The noise profile: how far feeds, bends, rotations and straight struts stray, for simulation.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::Kind;
use crate::machine_rules::{FIGURE, within};
use crate::profile::{Fault, Profile, header, is_default, layer};
use crate::sourced::{Reference, Sourced};

/// The `kind` of a noise profile.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum NoiseTag {
    /// The only word.
    Noise,
}

/// Errors of a bender: each is a bias plus a normal deviate (Bend-Forming, Eq. 1).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct NoiseProfile {
    /// Address or path of the JSON Schema, for editors. Not read by the program.
    #[serde(rename = "$schema", default, skip_serializing_if = "Option::is_none")]
    pub schema: Option<String>,
    /// Version of this format.
    #[schemars(range(min = 1, max = 1))]
    pub schema_version: u32,
    /// Says that this is a noise profile.
    pub kind: NoiseTag,
    /// Slug of lower-case letters, digits and hyphens; equals the file's name without `.json`.
    #[schemars(regex(pattern = r"^[a-z0-9]+(-[a-z0-9]+)*$"))]
    pub id: String,
    /// Id of the noise profile that gives every value not set here.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub inherits: Option<String>,
    /// True for a base that only serves to be inherited from and may leave values open.
    #[serde(rename = "abstract", default, skip_serializing_if = "is_default")]
    pub is_abstract: bool,
    /// Name for people.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// A few sentences: whose errors these are.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub description: Option<String>,
    /// Error of a feed.
    #[serde(default, skip_serializing_if = "is_default")]
    pub feed: LengthError,
    /// Error of a formed bend; a positive bias overbends either way.
    #[serde(default, skip_serializing_if = "is_default")]
    pub bend: AngleError,
    /// Error of a head turn.
    #[serde(default, skip_serializing_if = "is_default")]
    pub rotate: AngleError,
    /// Bow of a strut that should be straight: the rise of its arc over the distance of its ends,
    /// which stay in line.
    #[serde(default, skip_serializing_if = "is_default")]
    pub curvature: RatioError,
    /// Publications that the `source` texts name.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sources: Option<Vec<Reference>>,
}

layer! {
    /// Error of a length.
    pub struct LengthError {
        /// Systematic part, millimetres.
        pub bias_mm: Sourced<f64>,
        /// Standard deviation, millimetres.
        pub sigma_mm: Sourced<f64>,
    }
}

layer! {
    /// Error of an angle.
    pub struct AngleError {
        /// Systematic part, degrees.
        pub bias_deg: Sourced<f64>,
        /// Standard deviation, degrees.
        pub sigma_deg: Sourced<f64>,
    }
}

layer! {
    /// Error without a unit.
    pub struct RatioError {
        /// Systematic part.
        pub bias: Sourced<f64>,
        /// Standard deviation.
        pub sigma: Sourced<f64>,
    }
}

impl Profile for NoiseProfile {
    const KIND: Kind = Kind::Noise;
    const WHOLE: &'static [&'static str] = &[];
    header!();

    fn required(&self) -> Vec<(&'static str, &'static str)> {
        vec![
            ("name", "a name for people"),
            ("feed.bias_mm", FIGURE),
            ("feed.sigma_mm", FIGURE),
            ("bend.bias_deg", FIGURE),
            ("bend.sigma_deg", FIGURE),
            ("rotate.bias_deg", FIGURE),
            ("rotate.sigma_deg", FIGURE),
            ("curvature.bias", FIGURE),
            ("curvature.sigma", FIGURE),
        ]
    }

    fn faults(&self) -> Vec<Fault> {
        let mut faults = Vec::new();
        within(&mut faults, "feed.sigma_mm", &self.feed.sigma_mm, 0.0, f64::MAX);
        within(&mut faults, "bend.sigma_deg", &self.bend.sigma_deg, 0.0, f64::MAX);
        within(&mut faults, "rotate.sigma_deg", &self.rotate.sigma_deg, 0.0, f64::MAX);
        within(&mut faults, "curvature.sigma", &self.curvature.sigma, 0.0, f64::MAX);
        faults
    }
}
