//! What a bend loses between the peg's place and the wire in the hand.
//!
//! Three things give, all in proportion to the moment that holds the wire on the pin: the machine, the leg
//! from the pin to the peg (a cantilever, taken as elastic), and the arc itself, whose curvature goes back
//! by M/(E·I) once it is let go. Angles are radians, lengths mm, moments N·mm.
//!
//! Next to the pin the leg yields as well; that is left out, and a compliance that was fitted to measured
//! bends takes it up. So the mean loss of a fitted machine is no finding of this model. That it hardly
//! changes with the angle is: leg and arc of the published machine lose 3.5 to 3.8 degrees from 30 to 150,
//! since the leg gets shorter as the arc gets longer.

use super::contact::{Contact, rising_root};
use super::section::{moment, rigidity};
use super::settings::{BenchError, Bender, Wire, demand};

/// How much the machine gives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Compliance {
    /// Degrees by which a loaded wire stays behind the place where the bend axis has the peg, for each
    /// N·m in the bend: gears, rod and nozzle together.
    pub deg_per_n_m: f64,
}

impl Compliance {
    /// A machine that does not give.
    pub const RIGID: Self = Self { deg_per_n_m: 0.0 };

    /// Of the published machine, whose bends lose 10.23 degrees with setback compensated (Faruqi et al.,
    /// SCF '25: 10.23 ± 1.63). About 4 degrees for each N·m.
    ///
    /// # Errors
    /// None with the published figures.
    pub fn published() -> Result<Self, BenchError> {
        Self::fitted(&Bender::PUBLISHED, &Wire::PUBLISHED, 10.23)
    }

    /// The one with which bends whose peg goes to the place of 30, 40, … 150 degrees lose `loss_deg` in
    /// the mean.
    ///
    /// # Errors
    /// [`BenchError::Loss`] where a stiff machine loses more, or where no machine loses as much.
    pub fn fitted(bender: &Bender, wire: &Wire, loss_deg: f64) -> Result<Self, BenchError> {
        let stiff = Press::new(bender, wire, Self::RIGID)?;
        let mean_loss = |deg_per_n_m| {
            let press = stiff.on(Self { deg_per_n_m });
            let losses = (3..=15).map(|tens| {
                let placed = f64::from(tens * 10).to_radians();
                (placed - press.released(press.wrapped(placed))).to_degrees()
            });
            losses.sum::<f64>() / 13.0
        };
        let stiff_deg = mean_loss(0.0);
        // The give at which about the whole of the smallest bend is lost.
        let smallest = stiff.wrapped(30_f64.to_radians()).max(0.0);
        let softest = (smallest / stiff.moment).to_degrees() * 1e3;
        if !(loss_deg >= stiff_deg && loss_deg <= mean_loss(softest)) {
            return Err(BenchError::Loss { wanted_deg: loss_deg, stiff_deg, soft_deg: mean_loss(softest) });
        }
        let deg_per_n_m = rising_root(0.0, softest, |give| mean_loss(give) - loss_deg);
        Ok(Self { deg_per_n_m })
    }
}

/// A wire on a pin.
#[derive(Debug, Clone, Copy)]
pub(super) struct Press {
    pub contact: Contact,
    /// Radius of the neutral fibre on the pin.
    neutral: f64,
    /// From the neutral fibre out to the middle of the wire.
    off_centre: f64,
    /// Moment that holds the wire on the pin.
    moment: f64,
    rigidity: f64,
    /// Radians for each N·mm.
    give: f64,
}

impl Press {
    pub fn new(bender: &Bender, wire: &Wire, compliance: Compliance) -> Result<Self, BenchError> {
        bender.check()?;
        wire.check()?;
        let give = compliance.deg_per_n_m;
        demand(give.is_finite() && give >= 0.0, "the machine's compliance", give, "zero or more")?;
        let wire_radius = wire.diameter_mm / 2.0;
        let centreline = bender.pin_radius_mm + wire_radius;
        let neutral = bender.pin_radius_mm + wire.k_factor * wire.diameter_mm;
        Ok(Self {
            contact: Contact::new(bender, wire_radius)?,
            neutral,
            off_centre: centreline - neutral,
            moment: moment(wire, 1.0 / centreline),
            rigidity: rigidity(wire),
            give: 0.0,
        }
        .on(compliance))
    }

    /// The same wire on a machine that gives otherwise.
    fn on(self, compliance: Compliance) -> Self {
        Self { give: compliance.deg_per_n_m.to_radians() * 1e-3, ..self }
    }

    /// How far the wire is wrapped around the pin under load, with the peg at the place of a straight leg
    /// at `placed`. Not positive where the wire only gives.
    ///
    /// The leg bows towards the peg's push, so that its tangent at the pin is behind its chord by M·l/(3·E·I).
    pub fn wrapped(&self, placed: f64) -> f64 {
        self.wrapped_by(placed, self.leg(placed))
    }

    /// The same where the peg holds the wire at `arm` from the pin.
    pub fn wrapped_by(&self, placed: f64, arm: f64) -> f64 {
        self.held(placed) - self.moment * arm / (3.0 * self.rigidity)
    }

    /// Distance from the pin to where the peg holds the leg, with the peg at that place.
    pub fn leg(&self, placed: f64) -> f64 {
        self.contact.leg_length(self.held(placed))
    }

    /// Where the machine really has the peg.
    pub fn held(&self, placed: f64) -> f64 {
        placed - self.give * self.moment
    }

    /// What stays of an arc that was wrapped so far. Nothing is lost of none.
    pub fn released(&self, wrapped: f64) -> f64 {
        let centreline = self.neutral + self.off_centre;
        wrapped.max(0.0) * (1.0 - self.moment * centreline / self.rigidity).max(0.0)
    }

    /// Length of the neutral fibre that is wrapped. It stays the arc's when the arc opens.
    pub fn fibre(&self, wrapped: f64) -> f64 {
        wrapped.max(0.0) * self.neutral
    }

    /// The angle that so much of the neutral fibre is wrapped around.
    pub fn angle_of(&self, fibre: f64) -> f64 {
        fibre / self.neutral
    }

    /// From the neutral fibre of an arc out to its centreline.
    pub fn off_centre(&self) -> f64 {
        self.off_centre
    }
}
