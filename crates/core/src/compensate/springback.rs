//! Springback: how much of a bend the wire takes back, as a model with an exact inverse.

use crate::units::Angle;

/// How a material springs back.
#[derive(Debug, Clone, PartialEq)]
pub enum Springback {
    /// Every bend loses the same angle.
    Constant(Angle),
    /// What a bend loses depends on how far and which way it is bent.
    Table {
        /// For bends to the positive side.
        positive: SpringbackCurve,
        /// For bends to the negative side.
        negative: SpringbackCurve,
    },
}

/// One measured pair: a bend that stayed, and what it had lost.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpringbackPoint {
    /// The bend that stayed, not negative.
    pub formed: Angle,
    /// What it lost, not negative.
    pub loss: Angle,
}

/// Why measured pairs are not a springback curve.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum SpringbackError {
    /// No pair at all.
    #[error("a springback table without a pair")]
    Empty,
    /// A loss or a bend below zero.
    #[error("pair {0} of the springback table, from 0: formed angle or loss is negative")]
    Range(usize),
    /// Pairs out of order, or a larger command that would leave a smaller bend.
    #[error(
        "pair {0} of the springback table, from 0: formed angle or formed angle plus loss does not increase"
    )]
    NotIncreasing(usize),
}

/// A curve through measured pairs, straight from each to the next in the angle that has to be bent; outside of what was
/// measured the loss stays that of the nearest pair. What lies between two pairs is between their losses: no measurement
/// says that it could be more.
#[derive(Debug, Clone, PartialEq)]
pub struct SpringbackCurve {
    /// Formed angle and angle to bend to, both ascending; radians.
    knots: Vec<[f64; 2]>,
}

impl SpringbackCurve {
    /// A curve through measured pairs in ascending order.
    ///
    /// # Errors
    /// [`SpringbackError`] names the first pair that does not fit.
    pub fn new(points: &[SpringbackPoint]) -> Result<Self, SpringbackError> {
        if points.is_empty() {
            return Err(SpringbackError::Empty);
        }
        let mut knots: Vec<[f64; 2]> = Vec::with_capacity(points.len());
        for (k, point) in points.iter().enumerate() {
            if point.formed < Angle::ZERO || point.loss < Angle::ZERO {
                return Err(SpringbackError::Range(k));
            }
            let knot = [point.formed.rad(), (point.formed + point.loss).rad()];
            if knots.last().is_some_and(|last| knot[0] <= last[0] || knot[1] <= last[1]) {
                return Err(SpringbackError::NotIncreasing(k));
            }
            knots.push(knot);
        }
        Ok(Self { knots })
    }

    /// Its pairs, in ascending order.
    #[must_use]
    pub fn points(&self) -> Vec<SpringbackPoint> {
        let point = |&[formed, bent]: &[f64; 2]| SpringbackPoint {
            formed: Angle::computed(formed),
            loss: Angle::computed(bent - formed),
        };
        self.knots.iter().map(point).collect()
    }

    /// The angle to bend to for an angle to be left; both not negative, radians.
    fn bend_to(&self, formed: f64) -> f64 {
        self.along(formed, |[formed, bent]| [formed, bent])
    }

    /// The angle that is left; zero where the wire springs back all the way.
    fn formed(&self, bent: f64) -> f64 {
        self.along(bent, |[formed, bent]| [bent, formed]).max(0.0)
    }

    /// The curve over one of its two angles. Beyond the first and the last pair the two angles differ as there.
    fn along(&self, x: f64, axes: impl Fn([f64; 2]) -> [f64; 2]) -> f64 {
        let next = self.knots.partition_point(|&knot| axes(knot)[0] < x);
        let [x1, y1] = axes(self.knots[next.min(self.knots.len() - 1)]);
        let Some(before) = next.checked_sub(1).filter(|_| next < self.knots.len()) else {
            return x + y1 - x1;
        };
        let [x0, y0] = axes(self.knots[before]);
        y0 + (y1 - y0) * (x - x0) / (x1 - x0)
    }
}

impl Springback {
    /// The angle to bend to so that `formed` is left: θ* = θ + sgn(θ)·S(|θ|); no bend needs none.
    #[must_use]
    pub fn bend_to(&self, formed: Angle) -> Angle {
        if formed == Angle::ZERO {
            return formed;
        }
        let magnitude = match self {
            Self::Constant(loss) => formed.abs().rad() + loss.rad(),
            Self::Table { .. } => self.curve(formed).map_or(0.0, |curve| curve.bend_to(formed.abs().rad())),
        };
        Angle::computed(formed.signum() * magnitude)
    }

    /// The angle that is left of a bend: the inverse of [`Springback::bend_to`]. A bend that is no
    /// larger than what the wire springs back leaves none.
    #[must_use]
    pub fn formed(&self, bent: Angle) -> Angle {
        let magnitude = match self {
            Self::Constant(loss) => (bent.abs().rad() - loss.rad()).max(0.0),
            Self::Table { .. } => self.curve(bent).map_or(0.0, |curve| curve.formed(bent.abs().rad())),
        };
        Angle::computed(bent.signum() * magnitude)
    }

    fn curve(&self, side: Angle) -> Option<&SpringbackCurve> {
        match self {
            Self::Constant(_) => None,
            Self::Table { negative, .. } if side < Angle::ZERO => Some(negative),
            Self::Table { positive, .. } => Some(positive),
        }
    }
}
