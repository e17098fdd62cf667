//! Sag: how far the part already bent hangs down under its own weight while the machine holds it at the bend point.
//!
//! Linear beam theory of slender round wire, clamped at the bend point: it bends (Euler and Bernoulli) and twists. The part
//! is taken as straight from corner to corner, and as undeformed where its weight acts, so that what sags by more than a
//! tenth of its reach is only indicated. Gravity is along -z of the machine ([`crate::motion`]).

use nalgebra::{Matrix3, Point3, UnitQuaternion, Vector3};

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
    /// How far the part reaches from the bend point then.
    pub reach: Length,
}

impl Sag {
    /// What sags by more no longer lies where its weight was taken to act: a tenth of the reach.
    #[must_use]
    pub fn small(&self) -> Length {
        Length::computed(self.reach.mm() * SMALL)
    }

    /// Whether it is too large to be more than indicated.
    #[must_use]
    pub fn is_indicated(&self) -> bool {
        self.deflection > self.small()
    }
}

/// So much of the reach is a small deflection, for which beam theory is linear.
const SMALL: f64 = 0.1;

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
    let mut frame = start;
    let mut points = vec![frame.position];
    for made in steps {
        frame.feed(made.feed);
        points.push(frame.position);
        frame.rotate(made.rotate);
        frame.bend(made.bend);
    }
    let hanging = HangingWire::new(points, wire)?;
    let mut largest: Option<Sag> = None;
    for (step, pose) in poses(start, steps).iter().enumerate() {
        let held = hanging.held_at(step + 1);
        let slices = slices(pose.bend);
        for slice in 0..=slices {
            let turn = pose.turned(f64::from(slice) / f64::from(slices));
            let deflection = Length::computed(hanging.displacement(0, &held, &down(&turn)).norm());
            if largest.is_none_or(|largest| deflection > largest.deflection) {
                largest = Some(Sag { step, deflection, reach: Length::ZERO });
            }
        }
    }
    largest.map(|sag| Sag { reach: hanging.reach(sag.step + 1), ..sag })
}

/// The direction of gravity in the frame of the design. `turn`: from there to the machine.
pub(crate) fn down(turn: &UnitQuaternion<f64>) -> Vector3<f64> {
    turn.inverse() * -Vector3::z()
}

#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // whole, positive and at most 360 / 2.5
fn slices(bend: Angle) -> u32 {
    (bend.abs().deg() / SLICE_DEG).ceil().clamp(1.0, 360.0) as u32
}

/// A line of wire from its free end on, of which any part may be out of the machine that holds it.
///
/// A piece of the wire is bent and twisted by the moment of what lies on its free side, which does not depend on where the
/// wire is held. So each piece adds its turn, a matrix times the direction of gravity, to all that lies on its free side: sums over the
/// line say how any point of it moves, wherever it is held.
#[derive(Debug, Clone)]
pub(crate) struct HangingWire {
    points: Vec<Point3<f64>>,
    stiffness: Stiffness,
    /// Up to each point.
    sums: Vec<Sums>,
}

/// What a wire weighs and how it gives way.
#[derive(Debug, Clone, Copy)]
struct Stiffness {
    /// Weight of a length, N/mm.
    weight: f64,
    /// 1/(E I) and 1/(G J), 1/(N mm²).
    bends: f64,
    twists: f64,
}

/// What lies on the free side of a place.
#[derive(Debug, Clone, Copy)]
struct Sums {
    length: f64,
    /// The integral of places along the wire, mm².
    moment: Vector3<f64>,
    /// From the direction of gravity to the turns of its pieces, and to how far these move what is at the origin.
    turns: Matrix3<f64>,
    shifts: Matrix3<f64>,
}

/// Where a wire is held.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Held(Sums);

/// Places and weights of Gauss and Legendre from -1 to 1, exact to the fifth power; what is summed up has the third.
const GAUSS: [(f64, f64); 3] =
    [(-0.774_596_669_241_483_4, 5.0 / 9.0), (0.0, 8.0 / 9.0), (0.774_596_669_241_483_4, 5.0 / 9.0)];

impl Stiffness {
    /// None where the wire has no stiffness.
    fn of(wire: &WireModel) -> Option<Self> {
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
        })
    }
}

impl Sums {
    fn none() -> Self {
        Self { length: 0.0, moment: Vector3::zeros(), turns: Matrix3::zeros(), shifts: Matrix3::zeros() }
    }

    /// With a straight part more, which goes on from `end`.
    fn with(&self, end: &Point3<f64>, way: Vector3<f64>, wire: &Stiffness) -> Self {
        let length = way.norm();
        let Some(along) = way.try_normalize(0.0) else { return *self };
        let end = end.coords;
        let twist = along * along.transpose();
        let yields = (Matrix3::identity() - twist) * wire.bends + twist * wire.twists;
        let mut sums = *self;
        for (place, share) in GAUSS {
            let gone = length * f64::midpoint(1.0, place);
            let here = end + along * gone;
            let moment = self.moment + end * gone + along * (gone * gone / 2.0);
            // What lies on the free side pulls with its weight.
            let lever = (moment - here * (self.length + gone)) * wire.weight;
            let turns = yields * lever.cross_matrix() * (share * length / 2.0);
            sums.turns += turns;
            sums.shifts -= here.cross_matrix() * turns;
        }
        sums.moment += end * length + along * (length * length / 2.0);
        sums.length += length;
        sums
    }
}

impl HangingWire {
    /// A wire through points, mm, from its free end on. None where it has no stiffness, or no length at all.
    pub fn new(points: Vec<Point3<f64>>, wire: &WireModel) -> Option<Self> {
        let stiffness = Stiffness::of(wire)?;
        let mut sums = vec![Sums::none()];
        for ends in points.windows(2) {
            let next = sums.last()?.with(&ends[0], ends[1] - ends[0], &stiffness);
            sums.push(next);
        }
        (points.len() > 1).then_some(Self { points, stiffness, sums })
    }

    /// It is held at one of its points.
    pub fn held_at(&self, point: usize) -> Held {
        Held(self.sums[point])
    }

    /// It is held farther on than one of its points, where that part is straight.
    pub fn held_beyond(&self, point: usize, way: Vector3<f64>) -> Held {
        Held(self.sums[point].with(&self.points[point], way, &self.stiffness))
    }

    /// How far a point on the free side is moved by the weight of the wire. `down`: the direction of gravity.
    pub fn displacement(&self, point: usize, Held(held): &Held, down: &Vector3<f64>) -> Vector3<f64> {
        let before = &self.sums[point];
        let turned = (held.turns - before.turns) * down;
        turned.cross(&self.points[point].coords) - (held.shifts - before.shifts) * down
    }

    /// How far what is out reaches from the point where it is held.
    fn reach(&self, held: usize) -> Length {
        let from = self.points[held];
        let out = self.points[..held].iter().map(|point| (point - from).norm());
        Length::computed(out.fold(0.0, f64::max))
    }
}

#[cfg(test)]
mod tests;
