//! What profiles say of a machine and a wire before a calibration, and how far that may be off.

use wirebend_core::calibrate::{Assumed, KnownLength, KnownPeg};
use wirebend_core::units::Length;
use wirebend_profile::Sourced;

use crate::PlanningError;
use crate::machine::{Setup, deg, mm};

/// A dimension that nobody measured may be off by this part of it: benders are built of what there is.
const UNMEASURED: f64 = 0.15;
/// The offset of an orbit may be given as none because nobody has looked, mm.
const OFFSET_UNMEASURED_MM: f64 = 1.0;
/// One that was measured by a hundredth, or by what a caliper reads, mm.
const MEASURED: f64 = 0.01;
const CALIPER_MM: f64 = 0.05;
/// K by so much, from handbooks and from measurements.
const K_UNMEASURED: f64 = 0.1;
const K_MEASURED: f64 = 0.03;
/// A protractor is read to half a degree, a caliper on bent wire to a tenth of a millimetre.
const PROTRACTOR_DEG: f64 = 0.5;
const READ_MM: f64 = 0.1;

/// What a calibration starts from of a figure that one before has found: the standard deviation that it had for that one.
fn before_calibration(stated: Option<&Sourced<f64>>) -> Option<f64> {
    Some(stated?.within_95_before? / 1.96)
}

fn known(value_mm: f64, stated: Option<&Sourced<f64>>) -> Result<KnownLength, PlanningError> {
    let by_hand = stated.is_some_and(|stated| stated.measured && stated.within_95.is_none());
    let off = before_calibration(stated).unwrap_or_else(|| {
        if by_hand { (MEASURED * value_mm.abs()).max(CALIPER_MM) } else { UNMEASURED * value_mm.abs() }
    });
    Ok(KnownLength { value: mm(value_mm)?, deviation: mm(off)? })
}

impl Setup {
    /// What its profiles say, for a calibration.
    pub fn assumed(&self) -> Result<Assumed, PlanningError> {
        let bend = &self.machine.profile.bend;
        let wire = self.material.figures()?;
        let machine = self.machine.figures()?;
        let half = wire.diameter_mm / 2.0;
        let model = &self.model.compensation.bend;
        let plain = |stated: &Option<Sourced<f64>>| stated.as_ref().map_or(0.0, |stated| stated.value);
        let peg = model.setback.is_some().then(|| {
            let mut orbit_offset = known(plain(&bend.orbit_offset_mm), bend.orbit_offset_mm.as_ref())?;
            if bend
                .orbit_offset_mm
                .as_ref()
                .is_none_or(|stated| !stated.measured && stated.within_95.is_none())
            {
                orbit_offset.deviation = orbit_offset.deviation.max(mm(OFFSET_UNMEASURED_MM)?);
            }
            Ok::<_, PlanningError>(KnownPeg {
                orbit_radius: known(plain(&bend.orbit_radius_mm), bend.orbit_radius_mm.as_ref())?,
                orbit_offset,
                peg_radius: known(plain(&bend.rod_radius_mm) + half, bend.rod_radius_mm.as_ref())?,
            })
        });
        let k = self.material.profile.k_factor.as_ref();
        Ok(Assumed {
            peg: peg.transpose()?,
            bend_radius: known(machine.pin_radius_mm + half, bend.pin_radius_mm.as_ref())?,
            springback: model.springback.clone(),
            axis_limit: model.axis_limit,
            diameter: Length::from_mm(wire.diameter_mm).unwrap_or_default(),
            k_factor: wire.k_factor,
            motion: self.model.compensation.motion,
            k_deviation: before_calibration(k).unwrap_or(match k {
                Some(Sourced { measured: true, within_95: None, .. }) => K_MEASURED,
                _ => K_UNMEASURED,
            }),
            deducts_bends: self.model.compensation.feed.is_some(),
            angle_reading: deg(PROTRACTOR_DEG)?,
            length_reading: mm(READ_MM)?,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What was found of one dimension is off together with the others: the next calibration starts where the first did.
    #[test]
    fn a_calibrated_figure_is_known_as_well_as_before_its_calibration() {
        let stated = |measured, within_95, within_95_before| Sourced {
            value: 20.0,
            source: "a calibration".to_owned(),
            measured,
            within_95,
            within_95_before,
        };
        let deviation = |stated: &Sourced<f64>| known(20.0, Some(stated)).unwrap().deviation.mm();
        for measured in [true, false] {
            assert!((deviation(&stated(measured, Some(1.0), Some(3.92))) - 2.0).abs() < 1e-9);
            assert!((deviation(&stated(measured, Some(1.0), None)) - 3.0).abs() < 1e-9);
        }
        assert!((deviation(&stated(true, None, None)) - 0.2).abs() < 1e-9);
        assert!((deviation(&stated(false, None, None)) - 3.0).abs() < 1e-9);
    }
}
