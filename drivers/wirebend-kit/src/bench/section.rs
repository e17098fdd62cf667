//! The moment of a round section against its curvature.

use std::f64::consts::{FRAC_PI_2, PI};

use super::settings::Wire;

/// Intervals of Simpson's rule on a smooth part of the integral.
const INTERVALS: u32 = 64;

/// E·I of a wire in N·mm².
pub(super) fn rigidity(wire: &Wire) -> f64 {
    wire.youngs_modulus_gpa * 1e3 * PI * wire.diameter_mm.powi(4) / 64.0
}

/// Moment in N·mm that holds a wire at a curvature in 1/mm.
///
/// Sections stay plane, so that the strain is κ·y. With y = r·sin u and the width 2·r·cos u the moment
/// is 4·r³·∫ σ·sin u·cos² u du over a quarter turn.
pub(super) fn moment(wire: &Wire, curvature: f64) -> f64 {
    let radius = wire.diameter_mm / 2.0;
    let surface = curvature * radius;
    let integrand = |u: f64| stress(wire, surface * u.sin()) * u.sin() * u.cos().powi(2);
    // The stress has corners where yielding begins and where hardening ends; Simpson's rule stops there.
    let reached = |strain: f64| if surface > strain { (strain / surface).asin() } else { FRAC_PI_2 };
    let (yields, ends) = (reached(wire.yield_strain()), reached(wire.strain_at_ultimate));
    let parts = [(0.0, yields), (yields, ends), (ends, FRAC_PI_2)];
    4.0 * radius.powi(3) * parts.iter().map(|&(from, to)| simpson(from, to, integrand)).sum::<f64>()
}

/// Stress in N/mm² at a strain, both of tension.
fn stress(wire: &Wire, strain: f64) -> f64 {
    let (yields, ends) = (wire.yield_strain(), wire.strain_at_ultimate);
    if strain <= yields {
        return strain * wire.youngs_modulus_gpa * 1e3;
    }
    let hardened = ((strain - yields) / (ends - yields)).min(1.0);
    wire.yield_strength_mpa + (wire.ultimate_strength_mpa - wire.yield_strength_mpa) * hardened
}

fn simpson(from: f64, to: f64, value: impl Fn(f64) -> f64) -> f64 {
    let h = (to - from) / f64::from(INTERVALS);
    let weight = |i: u32| match i {
        0 | INTERVALS => 1.0,
        _ if i % 2 == 1 => 4.0,
        _ => 2.0,
    };
    (0..=INTERVALS).map(|i| weight(i) * value(from + h * f64::from(i))).sum::<f64>() * h / 3.0
}

#[cfg(test)]
mod tests {
    use super::*;

    const WIRE: Wire = Wire::PUBLISHED;

    /// Relative difference.
    fn off(found: f64, expected: f64) -> f64 {
        (found / expected - 1.0).abs()
    }

    #[test]
    fn below_yield_it_is_a_spring() {
        // π·3⁴/64 = 3.976078 mm⁴; times 68030 MPa.
        assert!(off(rigidity(&WIRE), 270_492.6) < 1e-6, "{}", rigidity(&WIRE));
        // The surface yields at κ = 268.47/68030/1.5 = 0.0026309.
        assert!(off(moment(&WIRE, 0.0026), rigidity(&WIRE) * 0.0026) < 1e-6);
    }

    #[test]
    fn a_fully_plastic_section_bears_a_sixth_of_the_cube() {
        let plastic = Wire { yield_strength_mpa: 362.14, strain_at_ultimate: 0.5, ..WIRE };
        // 362.14·3³/6 = 1629.63 N·mm, the published 1.630 N·m.
        assert!(off(moment(&plastic, 1e3), 1629.63) < 1e-5, "{}", moment(&plastic, 1e3));
    }

    #[test]
    fn the_published_bend_is_nearly_plastic_whatever_the_strain_at_ultimate() {
        let at = |strain_at_ultimate| moment(&Wire { strain_at_ultimate, ..WIRE }, 1.0 / 3.0);
        assert!(off(at(0.08), at(0.17)) < 0.02);
        assert!(at(0.12) < 1629.63);
        assert!(off(at(0.12), 1629.63) < 0.02, "{}", at(0.12));
    }

    /// Strips of a thousandth of the radius, counted one by one.
    #[test]
    fn strips_of_the_section_add_up_to_it() {
        for curvature in [0.002, 0.01, 0.05, 0.1, 1.0 / 3.0] {
            let strip = |i: u32| {
                let y = 1.5 * (f64::from(i) + 0.5) / 10_000.0;
                let hardening = 268.47
                    + (362.14 - 268.47) * (curvature * y - 268.47 / 68030.0) / (0.12 - 268.47 / 68030.0);
                let stress = (68030.0 * curvature * y).min(hardening).min(362.14);
                2.0 * stress * y * 2.0 * (2.25 - y * y).sqrt() * 1.5 / 10_000.0
            };
            let strips: f64 = (0..10_000).map(strip).sum();
            assert!(off(moment(&WIRE, curvature), strips) < 1e-4, "at {curvature}");
        }
    }
}
