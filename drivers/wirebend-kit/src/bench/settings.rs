//! What is bent, on what, and how far a pulse goes.

/// The bend head. All of it is measured from the nozzle's exit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bender {
    /// Radius of the pins that the wire wraps.
    pub pin_radius_mm: f64,
    /// Radius of the peg's rod.
    pub rod_radius_mm: f64,
    /// Radius of the circle that the peg's centre runs on.
    pub orbit_radius_mm: f64,
    /// How far along the wire from the nozzle's exit the centre of that circle lies.
    pub orbit_offset_mm: f64,
    /// How far the bend axis can go, either way of zero.
    pub axis_limit_deg: f64,
}

impl Bender {
    /// The bend head of Faruqi et al., SCF '25 (doi 10.1145/3745778.3766662).
    pub const PUBLISHED: Self = Self {
        pin_radius_mm: 1.5,
        rod_radius_mm: 3.175,
        orbit_radius_mm: 20.4,
        orbit_offset_mm: 12.0,
        axis_limit_deg: 155.0,
    };

    pub(super) fn check(&self) -> Result<(), BenchError> {
        positive("the pin's radius", self.pin_radius_mm)?;
        positive("the rod's radius", self.rod_radius_mm)?;
        positive("the orbit's radius", self.orbit_radius_mm)?;
        let offset = self.orbit_offset_mm;
        demand(
            offset.is_finite(),
            "the orbit's offset",
            offset,
            "a length, below zero before the start of the bend",
        )?;
        let limit = self.axis_limit_deg;
        demand(limit > 0.0 && limit < 180.0, "the bend axis' limit", limit, "an angle between 0 and 180")
    }
}

/// The wire: a round section, elastic up to its yield strength, then hardening in a straight line up to
/// its ultimate strength, which it keeps from there on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wire {
    pub diameter_mm: f64,
    /// Depth of the neutral fibre in a bend from its inner face, as a part of the diameter.
    pub k_factor: f64,
    pub youngs_modulus_gpa: f64,
    /// Stress at which it begins to yield.
    pub yield_strength_mpa: f64,
    /// Largest stress that it bears.
    pub ultimate_strength_mpa: f64,
    /// Strain at which it bears that. Rarely known of a wire, and of little weight where the bend is
    /// tight: [`Wire::STRAIN_AT_ULTIMATE`].
    pub strain_at_ultimate: f64,
}

impl Wire {
    /// Estimate: handbooks give 6061-T6 an elongation at break of 12 to 17 %, most of it even along the
    /// bar. The surface of a wire as thick as the pin is strained by half, so that 8 or 17 % change the
    /// moment of the published wire by less than 1 %.
    pub const STRAIN_AT_ULTIMATE: f64 = 0.12;

    /// The 3 mm wire of 6061-T6 of Faruqi et al., SCF '25.
    pub const PUBLISHED: Self = Self {
        diameter_mm: 3.0,
        k_factor: 0.3,
        youngs_modulus_gpa: 68.03,
        yield_strength_mpa: 268.47,
        ultimate_strength_mpa: 362.14,
        strain_at_ultimate: Self::STRAIN_AT_ULTIMATE,
    };

    pub(super) fn check(&self) -> Result<(), BenchError> {
        positive("the wire's diameter", self.diameter_mm)?;
        let k = self.k_factor;
        demand((0.0..=1.0).contains(&k), "the K-factor", k, "a part of the diameter, from 0 to 1")?;
        positive("Young's modulus", self.youngs_modulus_gpa)?;
        positive("the yield strength", self.yield_strength_mpa)?;
        let ultimate = self.ultimate_strength_mpa;
        let bears_more = ultimate.is_finite() && ultimate >= self.yield_strength_mpa;
        demand(bears_more, "the ultimate strength", ultimate, "the yield strength or more")?;
        let strain = self.strain_at_ultimate;
        let is_later = strain.is_finite() && strain > self.yield_strain();
        demand(is_later, "the strain at the ultimate strength", strain, "more than the strain at yield")
    }

    /// Strain at which it begins to yield.
    pub(super) fn yield_strain(&self) -> f64 {
        self.yield_strength_mpa / (self.youngs_modulus_gpa * 1e3)
    }
}

/// How far an axis goes with one pulse, by the mechanics: not by what the controller believes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scale {
    /// Wire fed by a pulse.
    pub feed_mm_per_step: f64,
    /// Turn of the head by a pulse.
    pub rotate_deg_per_step: f64,
    /// Turn of the bend axis by a pulse.
    pub bend_deg_per_step: f64,
}

impl Scale {
    pub(super) fn check(&self) -> Result<(), BenchError> {
        positive("the feed of a pulse", self.feed_mm_per_step)?;
        positive("the head's turn by a pulse", self.rotate_deg_per_step)?;
        positive("the bend axis' turn by a pulse", self.bend_deg_per_step)
    }
}

/// What feed and head make of their pulses besides: a machine that was calibrated knows it of itself.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Drives {
    /// Wire fed for each mm that the pulses make.
    pub feed_scale: f64,
    /// What each turn of the head is off by.
    pub rotate_offset_deg: f64,
    /// What a turn of the head loses that goes against the one before.
    pub rotate_backlash_deg: f64,
}

impl Drives {
    /// Feed and head do what their pulses say.
    pub const EXACT: Self = Self { feed_scale: 1.0, rotate_offset_deg: 0.0, rotate_backlash_deg: 0.0 };

    pub(super) fn check(&self) -> Result<(), BenchError> {
        positive("the scale of the feed", self.feed_scale)?;
        let offset = self.rotate_offset_deg;
        demand(offset.is_finite(), "the offset of the head", offset, "a finite angle")?;
        let backlash = self.rotate_backlash_deg;
        let fits = backlash.is_finite() && backlash >= 0.0;
        demand(fits, "the backlash of the head", backlash, "an angle of zero or more")
    }
}

/// Why there is no such bench.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum BenchError {
    /// A figure that cannot be.
    #[error("{what} is {value}, which should be {expected}; correct the profile")]
    Figure {
        what: &'static str,
        value: f64,
        /// What it should be.
        expected: &'static str,
    },
    /// The peg does not push the wire further and further over the travel of its axis.
    #[error(
        "with the bend axis at {axis_deg:.0} degrees the peg pushes the wire less far than before; \
         check the orbit's radius and offset, the pin, the rod and the axis' limit"
    )]
    Orbit {
        /// Where that begins.
        axis_deg: f64,
    },
    /// No stiffness of the machine makes the bends lose so little, or so much.
    #[error(
        "no machine loses {wanted_deg} degrees of a bend in this wire: a stiff one loses {stiff_deg:.2}, \
         the softest that can bend it {soft_deg:.2}; check the wire's figures"
    )]
    Loss {
        /// What it should lose.
        wanted_deg: f64,
        /// What is lost on a machine that does not give.
        stiff_deg: f64,
        /// What is lost on a machine that hardly makes a bend of 30 degrees any more.
        soft_deg: f64,
    },
}

pub(super) fn positive(what: &'static str, value: f64) -> Result<(), BenchError> {
    demand(value.is_finite() && value > 0.0, what, value, "more than zero")
}

pub(super) fn demand(
    holds: bool,
    what: &'static str,
    value: f64,
    expected: &'static str,
) -> Result<(), BenchError> {
    if holds { Ok(()) } else { Err(BenchError::Figure { what, value, expected }) }
}
