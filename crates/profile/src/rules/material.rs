//! What a complete material profile needs and what contradicts itself in one.

use super::{FIGURE, above, within};
use crate::Kind;
use crate::heading::heading;
use crate::material::{LossPoint, MaterialProfile, Springback};
use crate::profile::{Fault, Profile};

const REQUIRED: &[(&str, &str)] = &[
    ("name", "a name for people"),
    ("alloy", "the alloy as a buyer names it"),
    ("temper", "the temper or condition"),
    ("diameter_mm", FIGURE),
    ("k_factor", FIGURE),
    ("springback", "{\"model\": \"constant\", ...} or {\"model\": \"table\", ...}"),
    ("youngs_modulus_gpa", FIGURE),
    ("yield_strength_mpa", FIGURE),
    ("ultimate_strength_mpa", FIGURE),
    ("density_kg_per_m3", FIGURE),
];

impl Profile for MaterialProfile {
    const KIND: Kind = Kind::Material;
    const WHOLE: &'static [&'static str] = &["springback"];
    heading!();

    fn required(&self) -> Vec<(&'static str, &'static str)> {
        let mut keys = REQUIRED.to_vec();
        if self.price_per_mm.is_some() {
            keys.push(("currency", "the ISO 4217 code of the price, such as \"USD\""));
        }
        keys
    }

    fn faults(&self) -> Vec<Fault> {
        let mut faults = Vec::new();
        above(&mut faults, "diameter_mm", &self.diameter_mm);
        above(&mut faults, "youngs_modulus_gpa", &self.youngs_modulus_gpa);
        above(&mut faults, "yield_strength_mpa", &self.yield_strength_mpa);
        above(&mut faults, "ultimate_strength_mpa", &self.ultimate_strength_mpa);
        above(&mut faults, "density_kg_per_m3", &self.density_kg_per_m3);
        above(&mut faults, "fracture_strain", &self.fracture_strain);
        within(&mut faults, "min_bend_radius_diameters", &self.min_bend_radius_diameters, 0.0, 1000.0);
        above(&mut faults, "process_energy_mj_per_kg", &self.process_energy_mj_per_kg);
        self.shear_faults(&mut faults);
        within(&mut faults, "k_factor", &self.k_factor, 0.0, 1.0);
        within(&mut faults, "price_per_mm", &self.price_per_mm, 0.0, f64::MAX);
        if let (Some(yields), Some(breaks)) = (&self.yield_strength_mpa, &self.ultimate_strength_mpa)
            && breaks.value < yields.value
        {
            let expected = format!("at least the yield strength, {}", yields.value);
            let fault = Fault::new("ultimate_strength_mpa", breaks.value, expected);
            faults.push(fault.against("yield_strength_mpa"));
        }
        if let Some(code) = &self.currency
            && !(code.len() == 3 && code.bytes().all(|byte| byte.is_ascii_uppercase()))
        {
            faults.push(Fault::new("currency", &code.value, "three capital letters (ISO 4217)"));
        }
        match &self.springback {
            Some(Springback::Constant { angle_deg }) => {
                let key = "springback.angle_deg";
                within(&mut faults, key, &Some(angle_deg.clone()), 0.0, 180.0);
            }
            Some(Springback::Table { positive, negative, source, .. }) => {
                table_faults(&mut faults, "springback.positive", positive);
                if let Some(negative) = negative {
                    table_faults(&mut faults, "springback.negative", negative);
                }
                if source.trim().is_empty() {
                    let expected = "where the pairs come from, or why they are an estimate";
                    faults.push(Fault::new("springback.source", "an empty text", expected));
                }
            }
            None => {}
        }
        faults
    }
}

impl MaterialProfile {
    /// An isotropic material that resists both a change of volume and one of shape has -1 < ν ≤ 0.5.
    fn shear_faults(&self, faults: &mut Vec<Fault>) {
        above(faults, "shear_modulus_gpa", &self.shear_modulus_gpa);
        if let Some(ratio) = &self.poisson_ratio
            && !(ratio.value > -1.0 && ratio.value <= 0.5)
        {
            faults.push(Fault::new("poisson_ratio", ratio.value, "more than -1 and at most 0.5"));
        }
        if let (Some(_), Some(ratio)) = (&self.shear_modulus_gpa, &self.poisson_ratio) {
            let expected = "no poisson_ratio beside shear_modulus_gpa: the one follows from the other";
            faults.push(Fault::new("poisson_ratio", ratio.value, expected).against("shear_modulus_gpa"));
        }
    }
}

/// Asks that both the formed angle and the commanded one rise from pair to pair, so that the
/// table can be read either way.
fn table_faults(faults: &mut Vec<Fault>, key: &str, points: &[LossPoint]) {
    if points.len() < 2 {
        let found = format!("{} pairs", points.len());
        faults.push(Fault::new(key, found, "two pairs or more (else use the constant model)"));
    }
    for point in points {
        if !(0.0..=180.0).contains(&point.angle_deg) {
            faults.push(Fault::new(key, point.angle_deg, "angle_deg between 0 and 180"));
        }
        if point.loss_deg < 0.0 {
            faults.push(Fault::new(key, point.loss_deg, "loss_deg of 0 or more"));
        }
    }
    for pair in points.windows(2) {
        let [before, after] = pair else { continue };
        if after.angle_deg <= before.angle_deg {
            let expected = format!("angle_deg above the pair before, {}", before.angle_deg);
            faults.push(Fault::new(key, after.angle_deg, expected));
        } else if after.angle_deg + after.loss_deg <= before.angle_deg + before.loss_deg {
            let found = after.angle_deg + after.loss_deg;
            let before = before.angle_deg + before.loss_deg;
            let expected = format!("angle_deg + loss_deg above that of the pair before, {before}");
            faults.push(Fault::new(key, found, expected));
        }
    }
}
