//! The noise profile: how far feeds, bends, rotations and straight struts stray, for simulation.

use crate::Kind;
use crate::heading::{heading, profile};
use crate::profile::{Fault, Profile, layer};
use crate::rules::{FIGURE, within};
use crate::sourced::Sourced;

profile! {
    /// Errors of a bender: each is a bias plus a normal deviate (Bend-Forming, Eq. 1).
    pub struct NoiseProfile: NoiseTag::Noise, "noise" {
        /// A few sentences: whose errors these are.
        description;
        /// Error of a feed.
        pub feed: LengthError,
        /// Error of a formed bend; a positive bias overbends either way.
        pub bend: AngleError,
        /// Error of a head turn.
        pub rotate: AngleError,
        /// Bow of a strut that should be straight: the rise of its arc over the distance of its ends,
        /// which stay in line.
        pub curvature: RatioError,
    }
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
    heading!();

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
