//! Shapes of the springback that a fit chooses from.

use crate::compensate::{Springback, SpringbackCurve, SpringbackPoint};
use crate::units::Angle;

/// Between knots the curve is handed on in pairs this far apart, in degrees: the line between two of them is off by a
/// hundredth of a degree at most where the loss bends by a degree in thirty.
const PAIRS_APART_DEG: f64 = 5.0;

/// How many angles a side needs for a curve: two for its ends, and two that can contradict the line between them.
pub(super) const CURVE_NEEDS: usize = 4;

/// What the loss depends on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SpringbackShape {
    /// On nothing.
    Constant,
    /// On angle and side as before, and the same everywhere besides.
    Moved,
    /// On angle and side: a monotone cubic through losses at a few angles of each side.
    Cubic,
}

/// Which shape is fitted.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ShapeChoice {
    /// The one that predicts best what it has not seen. Where the readings are too few for a curve, a curve that was known before is moved.
    #[default]
    Better,
    /// This one.
    Fixed(SpringbackShape),
}

/// A springback of which losses are parameters.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) enum Form {
    /// Of one: the same everywhere.
    #[default]
    Constant,
    /// Of one: what is lost more than by these curves, of the positive and the negative side.
    Moved([SpringbackCurve; 2]),
    /// Of one at each knot.
    Cubic(Knots),
}

impl Form {
    /// What was known before, moved by the same angle everywhere.
    pub fn moved(before: Option<&Springback>) -> Self {
        match before {
            Some(Springback::Table { positive, negative }) => {
                Self::Moved([positive, negative].map(Clone::clone))
            }
            Some(Springback::Constant(_)) | None => Self::Constant,
        }
    }

    pub const fn shape(&self) -> SpringbackShape {
        match self {
            Self::Constant => SpringbackShape::Constant,
            Self::Moved(_) => SpringbackShape::Moved,
            Self::Cubic(_) => SpringbackShape::Cubic,
        }
    }

    /// The springback with these parameters in degrees.
    pub fn springback(&self, parameters: &[f64]) -> Springback {
        let first = parameters.first().copied().unwrap_or_default();
        match self {
            Self::Cubic(knots) => knots.springback(parameters),
            Self::Constant => Springback::Constant(Angle::computed(first.clamp(0.0, 170.0).to_radians())),
            Self::Moved(curves) => {
                let [positive, negative] = curves.clone().map(|curve| {
                    let moved = points_moved(&curve, first);
                    // It goes up wherever it went up before.
                    SpringbackCurve::new(&moved).unwrap_or(curve)
                });
                Springback::Table { positive, negative }
            }
        }
    }

    /// The pairs of both sides, as a profile keeps them; none of a constant.
    pub fn pairs(&self, parameters: &[f64]) -> Option<[Vec<SpringbackPoint>; 2]> {
        match self {
            Self::Constant => None,
            Self::Moved(curves) => {
                let by = parameters.first().copied().unwrap_or_default();
                Some(curves.each_ref().map(|curve| points_moved(curve, by)))
            }
            Self::Cubic(knots) => Some(knots.pairs_of_both(parameters)),
        }
    }
}

/// The pairs of a curve with so many degrees more lost at each; nothing loses less than nothing.
fn points_moved(curve: &SpringbackCurve, by_deg: f64) -> Vec<SpringbackPoint> {
    let moved = |point: SpringbackPoint| SpringbackPoint {
        loss: Angle::computed((point.loss.deg() + by_deg).clamp(0.0, 170.0).to_radians()),
        ..point
    };
    curve.points().into_iter().map(moved).collect()
}

/// Angles (degrees, ascending) at which the loss is a parameter, for each side.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Knots {
    pub positive: Vec<f64>,
    pub negative: Vec<f64>,
}

impl Knots {
    /// Knots over the formed angles (degrees, signed) of readings, as many as they can tell apart. None where a side has
    /// bends at one angle only, or no side has any. A side without bends has no knots.
    pub fn over(formed: &[f64]) -> Option<Self> {
        let side = |sign: f64| {
            let mut angles: Vec<f64> = formed.iter().map(|angle| angle * sign).filter(|a| *a > 0.0).collect();
            angles.sort_by(f64::total_cmp);
            angles.dedup_by(|next, before| *next - *before < 2.0);
            let (first, last) = (*angles.first()?, *angles.last()?);
            let count = (angles.len() / 2).clamp(2, 4);
            let parts = super::statistics::count(count - 1);
            let knots = (0..count).map(|k| first + (last - first) * super::statistics::count(k) / parts);
            (angles.len() >= CURVE_NEEDS).then(|| knots.collect::<Vec<f64>>())
        };
        let has = |sign: f64| formed.iter().any(|angle| angle * sign > 0.0);
        let knots = |sign: f64| if has(sign) { side(sign) } else { Some(Vec::new()) };
        let found = Self { positive: knots(1.0)?, negative: knots(-1.0)? };
        (found.count() > 0).then_some(found)
    }

    fn count(&self) -> usize {
        self.positive.len() + self.negative.len()
    }

    /// The springback with these losses in degrees, the positive side first. A side without knots is as the other one.
    pub fn springback(&self, losses: &[f64]) -> Springback {
        let (positive, negative) = losses.split_at(self.positive.len().min(losses.len()));
        let positive = curve(&self.positive, positive);
        let negative = curve(&self.negative, negative);
        match (positive.clone().or_else(|| negative.clone()), negative.or(positive)) {
            (Some(positive), Some(negative)) => Springback::Table { positive, negative },
            _ => Springback::Constant(Angle::ZERO),
        }
    }

    /// The pairs of both sides.
    fn pairs_of_both(&self, losses: &[f64]) -> [Vec<SpringbackPoint>; 2] {
        let (positive, negative) = losses.split_at(self.positive.len().min(losses.len()));
        match [Self::pairs(&self.positive, positive), Self::pairs(&self.negative, negative)] {
            [positive, negative] if positive.is_empty() => [negative.clone(), negative],
            [positive, negative] if negative.is_empty() => [positive.clone(), positive],
            both => both,
        }
    }

    /// The pairs of one side, as a profile keeps them: formed angle and loss.
    fn pairs(knots: &[f64], losses: &[f64]) -> Vec<SpringbackPoint> {
        let cubic = MonotoneCubic::through(knots, losses);
        let (Some(first), Some(last)) = (knots.first(), knots.last()) else { return Vec::new() };
        let mut formed = vec![*first];
        let mut next = (first / PAIRS_APART_DEG).floor() * PAIRS_APART_DEG + PAIRS_APART_DEG;
        while next < last - 0.5 {
            if next > first + 0.5 {
                formed.push(next);
            }
            next += PAIRS_APART_DEG;
        }
        formed.push(*last);
        let pair = |formed: f64| SpringbackPoint {
            formed: Angle::computed(formed.to_radians()),
            loss: Angle::computed((cubic.at(formed) - formed).max(0.0).to_radians()),
        };
        formed.into_iter().map(pair).collect()
    }
}

fn curve(knots: &[f64], losses: &[f64]) -> Option<SpringbackCurve> {
    SpringbackCurve::new(&Knots::pairs(knots, losses)).ok()
}

/// Fritsch and Carlson's monotone cubic (SIAM J. Numer. Anal. 17, 1980) of the angle that has to be bent to over the one
/// that is left.
struct MonotoneCubic {
    x: Vec<f64>,
    y: Vec<f64>,
    slope: Vec<f64>,
}

impl MonotoneCubic {
    fn through(knots: &[f64], losses: &[f64]) -> Self {
        let x = knots.to_vec();
        let mut y: Vec<f64> = Vec::with_capacity(x.len());
        for (knot, loss) in knots.iter().zip(losses) {
            // To leave more, more has to be bent; a search may try otherwise.
            let bent = knot + loss.clamp(0.0, 170.0);
            y.push(y.last().map_or(bent, |before| bent.max(before + 0.1)));
        }
        let chord: Vec<f64> = (1..y.len()).map(|k| (y[k] - y[k - 1]) / (x[k] - x[k - 1]).max(1e-9)).collect();
        let at = |k: usize| chord.get(k).copied().unwrap_or_default();
        let mut slope: Vec<f64> = (0..y.len())
            .map(|k| match k {
                0 => at(0),
                k if k == chord.len() => at(k - 1),
                k => f64::midpoint(at(k - 1), at(k)),
            })
            .collect();
        for (k, &chord) in chord.iter().enumerate() {
            let (a, b) = (slope[k] / chord, slope[k + 1] / chord);
            let length = a.hypot(b);
            if length > 3.0 {
                slope[k] = 3.0 / length * a * chord;
                slope[k + 1] = 3.0 / length * b * chord;
            }
        }
        Self { x, y, slope }
    }

    fn at(&self, x: f64) -> f64 {
        let last = self.y.len().saturating_sub(2);
        let k = self.x.partition_point(|&knot| knot <= x).saturating_sub(1).min(last);
        let Some(&[x0, x1]) = self.x.get(k..k + 2).and_then(|pair| pair.first_chunk()) else {
            return self.y.first().map_or(x, |y| x + y - self.x[0]);
        };
        let h = x1 - x0;
        let t = (x - x0) / h;
        let (s, y) = (&self.slope, &self.y);
        let (t2, t3) = (t * t, t * t * t);
        y[k] * (2.0 * t3 - 3.0 * t2 + 1.0)
            + s[k] * h * (t3 - 2.0 * t2 + t)
            + y[k + 1] * (3.0 * t2 - 2.0 * t3)
            + s[k + 1] * h * (t3 - t2)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::deg;

    #[test]
    fn a_straight_line_of_losses_is_kept_as_one() {
        // 1/8 inch aluminium as reported: 4.9 at 10, 8.6 at 130; in between 4.9 + 3.7·(θ - 10)/120.
        let knots = Knots { positive: vec![10.0, 70.0, 130.0], negative: vec![] };
        let model = knots.springback(&[4.9, 6.75, 8.6]);
        for (formed, loss) in [(10.0, 4.9), (40.0, 5.825), (100.0, 7.675), (130.0, 8.6)] {
            for side in [1.0, -1.0] {
                let bent = model.bend_to(deg(side * formed));
                assert!((bent.deg() * side - formed - loss).abs() < 1e-9, "{formed}: {bent:.4}");
            }
        }
    }

    #[test]
    fn the_curve_goes_through_its_knots_and_never_turns_back() {
        let knots = Knots { positive: vec![10.0, 20.0, 100.0, 110.0], negative: vec![10.0, 110.0] };
        let model = knots.springback(&[2.0, 9.0, 9.5, 0.0, 3.0, 3.0]);
        assert!((model.bend_to(deg(20.0)).deg() - 29.0).abs() < 1e-9);
        assert!((model.bend_to(deg(-50.0)).deg() + 53.0).abs() < 1e-9);
        let mut before = deg(0.0);
        for tenth in 1..1300 {
            let bent = model.bend_to(deg(f64::from(tenth) / 10.0));
            assert!(bent > before, "at {tenth}");
            before = bent;
        }
    }

    #[test]
    fn few_angles_make_no_curve() {
        assert_eq!(Knots::over(&[30.0, 60.0, 90.0]), None);
        assert_eq!(Knots::over(&[]), None);
        assert_eq!(
            Knots::over(&[30.0, 60.0, 90.0, 120.0]).map(|knots| knots.positive),
            Some(vec![30.0, 120.0])
        );
    }
}
