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
    #[error("a springback table needs at least one measured pair")]
    Empty,
    /// A loss or a bend below zero.
    #[error("pair {0} of the springback table: the formed angle and the loss must not be negative")]
    Range(usize),
    /// Pairs out of order, or a larger command that would leave a smaller bend.
    #[error("pair {0} of the springback table: formed angle and formed angle plus loss must both increase")]
    NotIncreasing(usize),
}

/// A monotone curve through measured pairs: piecewise cubic after Fritsch and Carlson (SIAM J.
/// Numer. Anal. 17, 1980) in the angle that has to be bent; outside of what was measured the loss
/// stays that of the nearest pair.
#[derive(Debug, Clone, PartialEq)]
pub struct SpringbackCurve {
    /// Formed angle, angle to bend to, and slope of the second over the first; radians.
    knots: Vec<[f64; 3]>,
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
        let mut knots: Vec<[f64; 3]> = Vec::with_capacity(points.len());
        for (k, point) in points.iter().enumerate() {
            if point.formed < Angle::ZERO || point.loss < Angle::ZERO {
                return Err(SpringbackError::Range(k));
            }
            let knot = [point.formed.rad(), (point.formed + point.loss).rad(), 1.0];
            if knots.last().is_some_and(|last| knot[0] <= last[0] || knot[1] <= last[1]) {
                return Err(SpringbackError::NotIncreasing(k));
            }
            knots.push(knot);
        }
        let secants: Vec<f64> = knots.windows(2).map(|w| (w[1][1] - w[0][1]) / (w[1][0] - w[0][0])).collect();
        for k in 1..knots.len().saturating_sub(1) {
            // The harmonic mean lies within the region that keeps the cubic monotone.
            knots[k][2] = 2.0 * secants[k - 1] * secants[k] / (secants[k - 1] + secants[k]);
        }
        if let (Some(&first), Some(&last)) = (secants.first(), secants.last()) {
            let end = knots.len() - 1;
            knots[0][2] = 1.0_f64.min(3.0 * first);
            knots[end][2] = 1.0_f64.min(3.0 * last);
        }
        Ok(Self { knots })
    }

    /// The angle to bend to for an angle to be left; both not negative, radians.
    fn bend_to(&self, formed: f64) -> f64 {
        let (first, last) = (self.knots[0], self.knots[self.knots.len() - 1]);
        if formed <= first[0] {
            return formed + first[1] - first[0];
        }
        let k = self.knots.partition_point(|knot| knot[0] < formed);
        let Some([x1, y1, m1]) = self.knots.get(k).copied() else {
            return formed + last[1] - last[0];
        };
        let [x0, y0, m0] = self.knots[k - 1];
        let h = x1 - x0;
        let t = (formed - x0) / h;
        let (t2, t3) = (t * t, t * t * t);
        y0 * (2.0 * t3 - 3.0 * t2 + 1.0)
            + h * m0 * (t3 - 2.0 * t2 + t)
            + y1 * (3.0 * t2 - 2.0 * t3)
            + h * m1 * (t3 - t2)
    }

    /// The angle that is left; zero where the wire springs back all the way.
    fn left(&self, bent: f64) -> f64 {
        let at_rest = self.bend_to(0.0);
        if bent <= at_rest {
            return 0.0;
        }
        // The loss is not negative, so what is left is between 0 and what was bent.
        super::increasing_root(0.0, bent, |formed| self.bend_to(formed) - bent)
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
    pub fn left(&self, bent: Angle) -> Angle {
        let magnitude = match self {
            Self::Constant(loss) => (bent.abs().rad() - loss.rad()).max(0.0),
            Self::Table { .. } => self.curve(bent).map_or(0.0, |curve| curve.left(bent.abs().rad())),
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
