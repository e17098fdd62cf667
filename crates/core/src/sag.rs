//! Sag: how far the part already bent hangs down under its own weight while the machine holds it at the bend point.
//!
//! Linear beam theory of slender round wire, clamped at the bend point: it bends (Euler and Bernoulli) and twists. The part
//! is taken as straight from corner to corner, and as undeformed where its weight acts, so that what sags by more than a
//! tenth of its reach is only indicated. Gravity is along -z of the machine ([`crate::motion`]).

use nalgebra::{Matrix3, Vector3};

use crate::bend::{Frame, Step};
use crate::estimate::WireModel;
use crate::motion::poses;
use crate::units::{Angle, Length};

/// Standard gravity, m/s².
const GRAVITY: f64 = 9.80665;
/// Poisson's ratio, between the 0.29 of steel and the 0.34 of copper (handbook values): a twist differs by 4 % at most.
const POISSON: f64 = 0.33;
/// While a bend is made, the sag is worked out this often: between two it differs by less than a thousandth.
const SLICE_DEG: f64 = 2.5;

/// The largest sag of a program.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sag {
    /// Index of the step, from 0: at the end of its feed, or while it bends.
    pub step: usize,
    /// How far the free end is from where it would be without weight.
    pub deflection: Length,
}

/// The largest sag while a machine runs scheduled steps that begin at `start`; none without a step, or where the wire is of
/// no thickness.
///
/// ```
/// use wirebend_core::bend::{Frame, Step};
/// use wirebend_core::estimate::WireModel;
/// use wirebend_core::sag::max_sag;
/// use wirebend_core::units::Length;
/// let mm = Length::from_mm;
/// let wire = WireModel { diameter: mm(3.0)?, density_kg_per_m3: 2700.0, youngs_modulus_gpa: 68.03, price_per_mm: None };
/// let straight = Step { feed: mm(500.0)?, ..Step::default() };
/// let sag = max_sag(Frame::default(), &[straight], &wire).map(|sag| sag.deflection.mm());
/// // A cantilever: w L⁴ / (8 E I), with w = 1.8716e-4 N/mm and E I = 270.5e3 N mm².
/// assert!(sag.is_some_and(|sag| (sag - 5.406).abs() < 1e-3));
/// # Ok::<(), wirebend_core::units::NotFinite>(())
/// ```
#[must_use]
pub fn max_sag(start: Frame, steps: &[Step], wire: &WireModel) -> Option<Sag> {
    let mut part = Part::new(wire)?;
    let mut frame = start;
    let mut largest: Option<Sag> = None;
    for (step, (made, pose)) in steps.iter().zip(poses(start, steps)).enumerate() {
        part.add(frame.t() * made.feed.mm());
        frame.feed(made.feed);
        frame.rotate(made.rotate);
        frame.bend(made.bend);
        let slices = slices(pose.bend);
        for slice in 0..=slices {
            let turn = pose.turned(f64::from(slice) / f64::from(slices));
            let deflection = Length::computed(part.deflection(&(turn.inverse() * -Vector3::z())).norm());
            if largest.is_none_or(|largest| deflection > largest.deflection) {
                largest = Some(Sag { step, deflection });
            }
        }
    }
    largest
}

#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // whole, positive and at most 360 / 2.5
fn slices(bend: Angle) -> u32 {
    (bend.abs().deg() / SLICE_DEG).ceil().clamp(1.0, 360.0) as u32
}

/// What is out of the machine: from its free end, where it begins, to the bend point, where it is held.
///
/// A piece of the wire is bent and twisted by the moment of what lies on its free side, which does not depend on where the
/// wire is held. So the deflection of the free end is a matrix times the direction of gravity, to which each straight part
/// adds its own.
#[derive(Debug, Clone)]
struct Part {
    /// Weight of a length, N/mm.
    weight: f64,
    /// 1/(E I) and 1/(G J), 1/(N mm²).
    bends: f64,
    twists: f64,
    /// Where the wire ends now, seen from its free end, mm.
    end: Vector3<f64>,
    length: f64,
    /// The integral of places along the wire, mm².
    moment: Vector3<f64>,
    /// From the direction of gravity to the deflection of the free end, mm.
    answer: Matrix3<f64>,
}

/// Places and weights of Gauss and Legendre from -1 to 1, exact to the fifth power; what is summed up has the third.
const GAUSS: [(f64, f64); 3] =
    [(-0.774_596_669_241_483_4, 5.0 / 9.0), (0.0, 8.0 / 9.0), (0.774_596_669_241_483_4, 5.0 / 9.0)];

impl Part {
    /// Nothing is out yet. None where the wire has no stiffness.
    fn new(wire: &WireModel) -> Option<Self> {
        let diameter = wire.diameter.mm();
        let second_moment = std::f64::consts::PI / 64.0 * diameter.powi(4);
        // GPa is 1e3 N/mm².
        let bending = wire.youngs_modulus_gpa * 1.0e3 * second_moment;
        // G J = E / (2 (1 + ν)) · 2 I.
        let torsion = bending / (1.0 + POISSON);
        let stiff = bending.is_finite() && bending > 0.0;
        stiff.then(|| Self {
            // Grams a millimetre are kilograms a metre, and newtons a metre 1e-3 newtons a millimetre.
            weight: wire.mass_g(Length::computed(1.0)) * GRAVITY * 1.0e-3,
            bends: 1.0 / bending,
            twists: 1.0 / torsion,
            end: Vector3::zeros(),
            length: 0.0,
            moment: Vector3::zeros(),
            answer: Matrix3::zeros(),
        })
    }

    /// A straight part more, at the end that is held.
    fn add(&mut self, way: Vector3<f64>) {
        let length = way.norm();
        let Some(along) = way.try_normalize(0.0) else { return };
        let twist = along * along.transpose();
        let yields = (Matrix3::identity() - twist) * self.bends + twist * self.twists;
        for (place, share) in GAUSS {
            let gone = length * f64::midpoint(1.0, place);
            let here = self.end + along * gone;
            let moment = self.moment + self.end * gone + along * (gone * gone / 2.0);
            // What lies on the free side pulls with its weight, and the free end moves as far as it is from here.
            let lever = (moment - here * (self.length + gone)) * self.weight;
            let turns = yields * lever.cross_matrix();
            self.answer += here.cross_matrix() * turns * (share * length / 2.0);
        }
        self.moment += self.end * length + along * (length * length / 2.0);
        self.end += way;
        self.length += length;
    }

    /// How far the free end moves, with gravity in a direction, both in the frame of the design.
    fn deflection(&self, down: &Vector3<f64>) -> Vector3<f64> {
        self.answer * down
    }
}

#[cfg(test)]
mod tests;
