//! Setback: how far a peg that orbits off the wire's axis has to go for a bend.

use crate::units::{Angle, Length};

/// A peg that orbits a fixed pin. The centreline leaves the nozzle along +x and wraps a pin of
/// centreline radius `r_n` about (0, `r_n`); the peg's centre goes round F = (s, 0) at radius R and
/// touches the outside of the bent leg at effective radius `r_e`. The axis is at zero where the
/// peg's centre is on the wire's axis.
///
/// Derived from the law of sines in the triangle of the leg's crossing with the axis, the peg and F;
/// WireBend-kit's Eq. 2 (doi 10.1145/3745778.3766662) has the fraction upside down.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PegGeometry {
    pub(super) orbit_radius: f64,
    pub(super) offset: f64,
    pub(super) pin: f64,
    pub(super) peg: f64,
    reach: f64,
    pub(super) peg_length: Length,
}

/// A radius of [`PegGeometry`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PegRadius {
    /// Radius R of the peg's orbit.
    Orbit,
    /// Centreline radius `r_n` of the wire around the pin.
    Pin,
    /// Effective radius `r_e` of the peg.
    Peg,
}

/// Why dimensions are not those of a peg bender.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum PegGeometryError {
    /// A radius is not more than zero.
    #[error("the radius of the {radius:?} is {value}; it is more than 0 mm")]
    NotPositive {
        /// Which radius.
        radius: PegRadius,
        /// Its value.
        value: Length,
    },
    /// The peg cannot touch a straight wire.
    #[error("an orbit of radius {orbit_radius} is smaller than the contact distance {peg} of the peg")]
    NoContact {
        /// R.
        orbit_radius: Length,
        /// `r_e`.
        peg: Length,
    },
    /// The peg meets the wire's axis only behind the pin.
    #[error("an orbit of offset {offset} and radius {orbit_radius} ends before the pin")]
    Behind {
        /// s.
        offset: Length,
        /// R.
        orbit_radius: Length,
    },
}

impl PegGeometry {
    /// The geometry from the radius R of the peg's orbit, the offset s of its centre from the pin
    /// along the wire (below zero where it lies before the pin), the centreline radius `r_n` of the bend (pin and half the wire) and the
    /// effective radius `r_e` of the peg (rod and half the wire).
    ///
    /// # Errors
    /// [`PegGeometryError`] when a radius is not positive or the peg cannot reach the wire.
    pub fn new(
        orbit_radius: Length,
        offset: Length,
        pin: Length,
        peg: Length,
    ) -> Result<Self, PegGeometryError> {
        for (radius, value) in
            [(PegRadius::Orbit, orbit_radius), (PegRadius::Pin, pin), (PegRadius::Peg, peg)]
        {
            if value <= Length::ZERO {
                return Err(PegGeometryError::NotPositive { radius, value });
            }
        }
        if peg >= orbit_radius {
            return Err(PegGeometryError::NoContact { orbit_radius, peg });
        }
        let mut geometry = Self {
            orbit_radius: orbit_radius.mm(),
            offset: offset.mm(),
            pin: pin.mm(),
            peg: peg.mm(),
            reach: 0.0,
            peg_length: orbit_radius,
        };
        // Where it touches straight wire: s + √(R² - r_e²) ahead of the pin.
        if geometry.offset + (geometry.orbit_radius.powi(2) - geometry.peg.powi(2)).sqrt() <= 0.0 {
            return Err(PegGeometryError::Behind { offset, orbit_radius });
        }
        geometry.reach = geometry.find_reach();
        Ok(geometry)
    }

    /// The same with a peg that is so long, half of it on either side of the wire: wire that is farther from the plane of a bend
    /// passes it. Where nobody says, it is as long as the radius of its orbit.
    #[must_use]
    pub fn with_peg_length(mut self, length: Length) -> Self {
        self.peg_length = length;
        self
    }

    /// The sine of the angle that the setback adds.
    fn sine(&self, bend: f64) -> f64 {
        (self.offset * bend.sin() - self.peg - self.pin * (1.0 - bend.cos())) / self.orbit_radius
    }

    /// Where the axis has to go for a bend of this size (radians, not negative), or `None` beyond
    /// the reach of the peg.
    pub(super) fn axis(&self, bend: f64) -> Option<f64> {
        (bend <= self.reach).then(|| bend + self.sine(bend).asin())
    }

    /// The largest bend up to which the axis only ever moves forward, within half a turn.
    fn find_reach(&self) -> f64 {
        // How the axis moves on with the bend is 1 + slope/rise, by the derivative of the arcsine.
        let parts = |bend: f64| {
            let sine = self.sine(bend);
            let slope = (self.offset * bend.cos() - self.pin * bend.sin()) / self.orbit_radius;
            (sine.abs() < 1.0).then(|| ((1.0 - sine * sine).sqrt(), slope))
        };
        let forward = |bend: f64| parts(bend).is_some_and(|(rise, slope)| slope > -rise);
        // A grid of 0.1° cannot miss where it turns: the slope changes by less than 1 % in a cell. Far from there neither
        // does one of 1°: the slope changes by 0.018·steepest in a cell, and the rise by less than 0.07·steepest.
        let steepest = (self.offset.abs() + self.pin) / self.orbit_radius;
        let (mut last, mut tenths) = (0.0, 1);
        while tenths <= 1800 {
            let bend = f64::from(tenths).to_radians() / 10.0;
            match parts(bend).filter(|(rise, slope)| slope > &-rise) {
                None => {
                    let beyond = |at: f64| if forward(at) { -1.0 } else { 1.0 };
                    return super::increasing_root(last, bend, beyond) - 1e-9;
                }
                Some((rise, slope)) => {
                    let far = rise > 0.25 + 0.1 * steepest && slope + rise > 0.11 * steepest;
                    tenths += if far && tenths <= 1790 { 10 } else { 1 };
                }
            }
            last = bend;
        }
        std::f64::consts::PI
    }

    /// The largest bend that the peg can press.
    #[must_use]
    pub fn reach(&self) -> Angle {
        Angle::computed(self.reach)
    }

    /// Where the axis has to stop to press a bend (magnitude); `None` beyond [`PegGeometry::reach`].
    /// Small bends give negative positions: the peg touches the wire before its centre reaches it.
    ///
    /// ```
    /// use wirebend_core::compensate::PegGeometry;
    /// use wirebend_core::units::{Angle, Length};
    /// let mm = |x| Length::from_mm(x);
    /// let peg = PegGeometry::new(mm(20.4)?, mm(12.0)?, mm(3.0)?, mm(4.675)?)?;
    /// let axis = peg.axis_for(Angle::from_deg(90.0)?).ok_or("out of reach")?;
    /// assert!((axis.deg() - 102.240).abs() < 1e-3);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn axis_for(&self, bend: Angle) -> Option<Angle> {
        self.axis(bend.abs().rad()).map(Angle::computed)
    }

    /// The bend (magnitude) that the wire has while the axis is at a position: the inverse of
    /// [`PegGeometry::axis_for`]. Zero before the peg touches; the reach beyond it.
    #[must_use]
    pub fn bend_at(&self, axis: Angle) -> Angle {
        let gap = |bend: f64| bend + self.sine(bend).asin() - axis.rad();
        if gap(0.0) >= 0.0 {
            return Angle::ZERO;
        }
        Angle::computed(super::increasing_root(0.0, self.reach, gap))
    }
}
