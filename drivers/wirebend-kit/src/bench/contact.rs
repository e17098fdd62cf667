//! Where the peg pushes the wire: the tangency of peg, leg and pin in the plane of the bend.
//!
//! The leg is the straight wire behind the bend. Its centreline is tangent to the circle of radius
//! `wrap` about (0, wrap), or about (0, -wrap) where it is bent the other way, and the peg is a circle of
//! radius `reach` on its right side. Only positive bends are known here: negative ones are their mirror
//! images. Angles are radians.

use std::f64::consts::{FRAC_PI_2, PI};

use nalgebra::Vector2;

use super::settings::{BenchError, Bender, demand};

/// Halvings of an interval of up to π: what is left is below the resolution of a float.
const HALVINGS: usize = 60;

/// The circles that touch the wire's centreline.
#[derive(Debug, Clone, Copy)]
pub(super) struct Contact {
    /// Radius of the pin and half the wire.
    wrap: f64,
    /// Radius of the peg's rod and half the wire.
    reach: f64,
    /// Radius of the orbit of the peg's centre.
    orbit: f64,
    /// Place of the orbit's centre on the x axis.
    offset: f64,
}

impl Contact {
    /// Errors where the peg would push less far somewhere in the axis' travel than before it, or would
    /// not come clear of a straight wire.
    pub fn new(bender: &Bender, wire_radius_mm: f64) -> Result<Self, BenchError> {
        let contact = Self {
            wrap: bender.pin_radius_mm + wire_radius_mm,
            reach: bender.rod_radius_mm + wire_radius_mm,
            orbit: bender.orbit_radius_mm,
            offset: bender.orbit_offset_mm,
        };
        let clears = contact.orbit > contact.reach;
        demand(clears, "the orbit's radius", contact.orbit, "more than the rod's radius and half the wire")?;
        let mut before = contact.leg_angle(-bender.axis_limit_deg.to_radians());
        // Whole degrees: the angles go with the sine of the axis, which has no finer features.
        let mut axis_deg = -bender.axis_limit_deg;
        while axis_deg < bender.axis_limit_deg {
            axis_deg = (axis_deg + 1.0).min(bender.axis_limit_deg);
            let leg = contact.leg_angle(axis_deg.to_radians());
            if leg < before {
                return Err(BenchError::Orbit { axis_deg });
            }
            before = leg;
        }
        Ok(contact)
    }

    /// Angle of the leg that the peg touches with the bend axis at `axis`: it pushes every leg of less.
    /// From -π, where it touches none, to π.
    pub fn leg_angle(&self, axis: f64) -> f64 {
        // The touching point is ahead of the arc, so that the peg is less than a right angle from the leg.
        let (low, high) = ((axis - FRAC_PI_2).max(-PI), (axis + FRAC_PI_2).min(PI));
        if self.gap(low, axis) >= 0.0 {
            return -PI;
        }
        if self.gap(high, axis) <= 0.0 {
            return high;
        }
        rising_root(low, high, |leg| self.gap(leg, axis))
    }

    /// Axis at which the peg touches a leg at `leg`; the end of the range where it never does.
    pub fn axis_angle(&self, leg: f64) -> f64 {
        rising_root(leg - FRAC_PI_2, leg + FRAC_PI_2, |axis| -self.gap(leg, axis))
    }

    /// Distance from the end of the arc to where the peg touches a leg at `leg`. Not negative.
    pub fn leg_length(&self, leg: f64) -> f64 {
        (self.peg(self.axis_angle(leg)) - self.end_of_arc(leg)).dot(&along(leg)).max(0.0)
    }

    /// Farther from the pin than this the peg touches nothing.
    pub fn farthest(&self) -> f64 {
        self.offset.abs() + self.orbit + self.reach + 2.0 * self.wrap
    }

    /// From the peg's centre to the middle of a wire that it touches.
    pub fn reach(&self) -> f64 {
        self.reach
    }

    /// Distance from the nozzle within which a wire that is straight meets no peg.
    pub fn clear_of_orbit(&self) -> f64 {
        self.offset + self.orbit - self.reach
    }

    /// Between the peg and a leg at `leg`: negative where they overlap or the peg is on the left side.
    fn gap(&self, leg: f64, axis: f64) -> f64 {
        let to_the_right = Vector2::new(leg.sin(), -leg.cos());
        (self.peg(axis) - self.end_of_arc(leg)).dot(&to_the_right) - self.reach
    }

    pub fn peg(&self, axis: f64) -> Vector2<f64> {
        Vector2::new(self.offset, 0.0) + along(axis) * self.orbit
    }

    pub fn end_of_arc(&self, leg: f64) -> Vector2<f64> {
        Vector2::new(leg.abs().sin(), leg.signum() * (1.0 - leg.cos())) * self.wrap
    }
}

fn along(angle: f64) -> Vector2<f64> {
    Vector2::new(angle.cos(), angle.sin())
}

/// Where a function that is negative at `low` and positive at `high` changes its sign; an end of the
/// interval where it does not.
pub(super) fn rising_root(mut low: f64, mut high: f64, value: impl Fn(f64) -> f64) -> f64 {
    for _ in 0..HALVINGS {
        let middle = f64::midpoint(low, high);
        if value(middle) < 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    f64::midpoint(low, high)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn published() -> Contact {
        Contact::new(&Bender::PUBLISHED, 1.5).unwrap()
    }

    /// The figures are those of the law of sines, worked out apart from this:
    /// axis = θ + asin((12 sin θ - 4.675 - 3 (1 - cos θ)) / 20.4).
    #[test]
    fn the_peg_stands_where_the_law_of_sines_has_it() {
        let figures = [
            (0.0, -13.25),
            (30.0, 32.594),
            (60.0, 71.931),
            (90.0, 102.240),
            (120.0, 123.421),
            (150.0, 137.909),
        ];
        for (leg, axis) in figures {
            let close = if leg == 0.0 { 5e-3 } else { 1e-3 };
            let found = published().axis_angle(f64::to_radians(leg)).to_degrees();
            assert!((found - axis).abs() < close, "a leg at {leg} is touched at {found}");
            let back = published().leg_angle(f64::to_radians(axis)).to_degrees();
            assert!((back - leg).abs() < close, "at {axis} the peg touches {back}");
        }
    }

    /// Every leg of a fine fan is compared with the peg, point by point along the wire.
    #[test]
    fn the_leg_is_the_first_that_points_of_a_wire_clear_the_peg() {
        let contact = published();
        for axis_deg in [-10.0_f64, 5.0, 40.0, 77.0, 110.0, 135.0] {
            let axis = axis_deg.to_radians();
            let peg = Vector2::new(12.0 + 20.4 * axis.cos(), 20.4 * axis.sin());
            let nearest = |leg: f64| {
                let end = Vector2::new(3.0 * leg.sin(), 3.0 - 3.0 * leg.cos());
                let points =
                    (0..40_000).map(|i| end + Vector2::new(leg.cos(), leg.sin()) * (f64::from(i) * 1e-3));
                points.map(|p| (p - peg).norm()).fold(f64::INFINITY, f64::min)
            };
            let leg = contact.leg_angle(axis);
            assert!((nearest(leg) - 4.675).abs() < 1e-6, "at {axis_deg}: {}", nearest(leg));
            assert!(nearest(leg - 1e-3) < 4.675, "at {axis_deg} the wire could be bent less");
        }
    }

    #[test]
    fn a_wire_that_is_bent_the_other_way_is_met_earlier() {
        let touch = |leg: f64| published().axis_angle(leg.to_radians()).to_degrees();
        // By hand for a leg at -30 on the other pin: T = (1.5, -0.401924), the leg's right is (-0.5, -0.866025);
        // (12 - 1.5)(-0.5) + 0.401924 (-0.866025) + 20.4 sin(-30° - axis) = 4.675: axis = -30° - asin(0.503582).
        assert!(
            (touch(-30.0) - (-30.0 - 0.503_582_f64.asin().to_degrees())).abs() < 1e-3,
            "{}",
            touch(-30.0)
        );
        assert!(touch(-30.0) < touch(0.0));
    }

    #[test]
    fn an_orbit_that_comes_back_is_refused() {
        let far = Bender { orbit_offset_mm: 100.0, ..Bender::PUBLISHED };
        assert!(matches!(Contact::new(&far, 1.5), Err(BenchError::Orbit { .. })));
        let thick = Contact::new(&Bender::PUBLISHED, 18.0);
        assert!(matches!(thick, Err(BenchError::Figure { what: "the orbit's radius", .. })));
    }
}
