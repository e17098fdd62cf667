//! Smooth curves as points, so close together that the straight lines between them are no farther from the curve
//! than a tolerance.
//!
//! Points and tolerance are in one unit, whichever it is. All curves are mapped by mapping what they are made of.

use std::f64::consts::{FRAC_PI_2, TAU};

use nalgebra::{Affine3, Point3, Vector3, Vector4};

use super::distance_to_segment;
use crate::units::{Angle, Length};

/// No curve is cut into more pieces than this, whatever the tolerance. A circle of a kilometre needs fewer at
/// 0.1 µm.
const MAX_PIECES: f64 = 524_288.0;
/// As many times a curve is halved at most.
const MAX_HALVINGS: u32 = 19;

/// An arc of an ellipse: `centre + u·cos t + v·sin t`, with t from `start` on over `sweep`.
///
/// With `u` and `v` of one length and at right angles it is an arc of a circle. Nothing is refused: where `u` and
/// `v` are parallel it is a straight line there and back.
#[derive(Debug, Clone, PartialEq)]
pub struct EllipticArc {
    /// Middle of the ellipse.
    pub centre: Point3<f64>,
    /// From the centre to the point at t = 0.
    pub u: Vector3<f64>,
    /// From the centre to the point at t = 90°.
    pub v: Vector3<f64>,
    /// Where it starts.
    pub start: Angle,
    /// How far it continues, backwards if negative.
    pub sweep: Angle,
}

impl EllipticArc {
    /// The point at t.
    #[must_use]
    pub fn point(&self, t: Angle) -> Point3<f64> {
        let (sin, cos) = t.rad().sin_cos();
        self.centre + self.u * cos + self.v * sin
    }

    /// The same arc after a map.
    #[must_use]
    pub fn mapped(&self, map: &Affine3<f64>) -> Self {
        Self { centre: map * self.centre, u: map * self.u, v: map * self.v, ..self.clone() }
    }

    /// The ways in which it begins and ends, of any length.
    #[must_use]
    pub fn ways(&self) -> [Vector3<f64>; 2] {
        [0.0, self.sweep.rad()].map(|part| {
            let (sin, cos) = (self.start.rad() + part).sin_cos();
            (self.v * cos - self.u * sin) * self.sweep.signum()
        })
    }

    /// Points at equal steps of t, both ends among them, at least one a quarter turn.
    ///
    /// The chord of a step h of the unit circle is 1 - cos(h/2) off, and the map of the unit circle to the ellipse
    /// stretches nothing by more than the larger half axis.
    ///
    /// ```
    /// use nalgebra::{Point3, Vector3};
    /// use wirebend_core::{curve::EllipticArc, units::{Angle, Length}};
    /// let (centre, u, v) = (Point3::origin(), Vector3::x() * 10.0, Vector3::y() * 10.0);
    /// let half = EllipticArc { centre, u, v, start: Angle::ZERO, sweep: Angle::from_deg(180.0)? };
    /// // 10·(1 - cos 11.25°) = 0.19 mm, 10·(1 - cos 12.9°) = 0.25 mm.
    /// assert_eq!(half.flatten(Length::from_mm(0.2)?).len(), 8 + 1);
    /// # Ok::<(), wirebend_core::units::NotFinite>(())
    /// ```
    #[must_use]
    pub fn flatten(&self, tolerance: Length) -> Vec<Point3<f64>> {
        let (uu, uv, vv) = (self.u.norm_squared(), self.u.dot(&self.v), self.v.norm_squared());
        let longest = (f64::midpoint(uu, vv) + (0.5 * (uu - vv)).hypot(uv)).sqrt();
        let half_step = (1.0 - (tolerance.mm() / longest).clamp(0.0, 1.0)).acos();
        let step = (2.0 * half_step).clamp(TAU / MAX_PIECES, FRAC_PI_2);
        // A whole circle of a step that divides it has no piece more for the last bit.
        let pieces = (self.sweep.rad().abs() / step - 1e-9).ceil().clamp(1.0, MAX_PIECES);
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // clamped
        let count = pieces as u32;
        let at = |k: u32| self.start.rad() + self.sweep.rad() * (f64::from(k) / pieces);
        (0..=count).map(|k| self.point(Angle::computed(at(k)))).collect()
    }
}

/// Why control points and knots are no curve.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SplineError {
    /// The degree.
    #[error("a degree of {degree} with {points} control points; it is 1 to 25, and less than the points")]
    Degree {
        /// The degree.
        degree: usize,
        /// How many control points there are.
        points: usize,
    },
    /// The number of knots.
    #[error("{knots} knots; degree and control points ask for {expected}")]
    KnotCount {
        /// How many there are.
        knots: usize,
        /// How many there should be.
        expected: usize,
    },
    /// More points than the caller has room for.
    #[error("at this tolerance it has more than {max_points} points")]
    TooManyPoints {
        /// How many there may be.
        max_points: usize,
    },
    /// A knot below the one before it, or one so often that the curve falls apart.
    #[error("knot {knot} is out of order or repeated too often")]
    Knot {
        /// Its index, from 0.
        knot: usize,
    },
    /// The number or the value of the weights.
    #[error("weights that are not one positive number a control point")]
    Weights,
}

/// A rational B-spline (NURBS): Bézier curves, plain B-splines and conics are special cases.
#[derive(Debug, Clone, PartialEq)]
pub struct Spline {
    degree: usize,
    knots: Vec<f64>,
    control: Vec<Point3<f64>>,
    weights: Vec<f64>,
}

impl Spline {
    /// A spline over the knots from number `degree` to the same number before the last. Without `weights` all are 1.
    ///
    /// # Errors
    /// [`SplineError`] says what does not fit together.
    pub fn new(
        degree: usize,
        knots: Vec<f64>,
        control: Vec<Point3<f64>>,
        weights: Vec<f64>,
    ) -> Result<Self, SplineError> {
        let points = control.len();
        if !(1..=25).contains(&degree) || points <= degree {
            return Err(SplineError::Degree { degree, points });
        }
        let expected = points + degree + 1;
        if knots.len() != expected {
            return Err(SplineError::KnotCount { knots: knots.len(), expected });
        }
        let disorder =
            knots.windows(2).position(|pair| pair[0] > pair[1] || !(pair[1] - pair[0]).is_finite());
        // So many equal knots inside would let the curve jump.
        let repeated = |k: &usize| knots[*k] >= knots[*k + degree];
        let apart = (1..points).find(repeated).or((knots[degree] >= knots[points]).then_some(points));
        if let Some(knot) = disorder.map(|k| k + 1).or(apart) {
            return Err(SplineError::Knot { knot });
        }
        let positive = |weight: &f64| weight.is_finite() && *weight > 0.0;
        let weights = if weights.is_empty() { vec![1.0; points] } else { weights };
        if weights.len() != points || !weights.iter().all(positive) {
            return Err(SplineError::Weights);
        }
        Ok(Self { degree, knots, control, weights })
    }

    /// The Bézier curve of 2 to 26 control points.
    ///
    /// # Errors
    /// [`SplineError::Degree`] for another number of them.
    pub fn bezier(control: Vec<Point3<f64>>) -> Result<Self, SplineError> {
        let count = control.len();
        let knots = (0..2 * count).map(|k| if k < count { 0.0 } else { 1.0 }).collect();
        Self::new(count.saturating_sub(1), knots, control, Vec::new())
    }

    /// The same curve after a map.
    #[must_use]
    pub fn mapped(&self, map: &Affine3<f64>) -> Self {
        Self { control: self.control.iter().map(|point| map * point).collect(), ..self.clone() }
    }

    /// The control points.
    #[must_use]
    pub fn control(&self) -> &[Point3<f64>] {
        &self.control
    }

    /// Where the curve begins, which is the first control point if the knots say so.
    #[must_use]
    pub fn start(&self) -> Point3<f64> {
        let spans = self.degree..self.control.len();
        let first = spans.into_iter().find(|&span| self.knots[span] < self.knots[span + 1]);
        cartesian(&self.bezier_of(first.unwrap_or(self.degree))[0])
    }

    /// The ways in which it begins and ends, of any length; zero where all control points are one.
    #[must_use]
    pub fn ways(&self) -> [Vector3<f64>; 2] {
        let spans =
            || (self.degree..self.control.len()).filter(|&span| self.knots[span] < self.knots[span + 1]);
        let points = |span: Option<usize>| -> Vec<Point3<f64>> {
            self.bezier_of(span.unwrap_or(self.degree)).iter().map(cartesian).collect()
        };
        let (first, mut last) = (points(spans().next()), points(spans().next_back()));
        last.reverse();
        // Where control points lie on the end, the next one says where the curve goes.
        let way = |points: &[Point3<f64>]| {
            let apart = points.iter().map(|point| point - points[0]);
            let longest = apart.clone().map(|by| by.norm()).fold(0.0, f64::max);
            apart.into_iter().find(|by| by.norm() > 1e-9 * longest).unwrap_or_default()
        };
        [way(&first), -way(&last)]
    }

    /// Points of the curve, both ends among them. A curve lies within the hull of its control points, so each piece
    /// is halved until those are near the straight line between its ends.
    ///
    /// # Errors
    /// [`SplineError::TooManyPoints`] as soon as there are more than `max_points`.
    pub fn flatten(&self, tolerance: Length, max_points: usize) -> Result<Vec<Point3<f64>>, SplineError> {
        let mut points = Vec::new();
        for span in self.degree..self.control.len() {
            if self.knots[span] < self.knots[span + 1] {
                let piece = self.bezier_of(span);
                if points.is_empty() {
                    points.push(cartesian(&piece[0]));
                }
                flatten_piece(piece, tolerance.mm(), &mut points, max_points)?;
            }
        }
        Ok(points)
    }

    /// The Bézier control points, homogeneous, of the part between a knot and the next: the blossom at as many of the
    /// one and of the other.
    fn bezier_of(&self, span: usize) -> Vec<Vector4<f64>> {
        let p = self.degree;
        let (from, to) = (self.knots[span], self.knots[span + 1]);
        let of_span: Vec<Vector4<f64>> = (span - p..=span)
            .map(|k| (self.control[k].coords * self.weights[k]).push(self.weights[k]))
            .collect();
        let blossom = |ends: usize| {
            let mut d = of_span.clone();
            for round in 1..=p {
                let at = if round <= ends { to } else { from };
                for j in (round..=p).rev() {
                    let (low, high) = (self.knots[span - p + j], self.knots[span + 1 + j - round]);
                    d[j] = d[j - 1].lerp(&d[j], (at - low) / (high - low));
                }
            }
            d[p]
        };
        (0..=p).map(blossom).collect()
    }
}

fn cartesian(point: &Vector4<f64>) -> Point3<f64> {
    Point3::from(point.xyz() / point.w)
}

/// Adds the points of a piece, without its first.
fn flatten_piece(
    piece: Vec<Vector4<f64>>,
    tolerance: f64,
    points: &mut Vec<Point3<f64>>,
    max_points: usize,
) -> Result<(), SplineError> {
    let mut waiting = vec![(piece, 0)];
    while let Some((mut left, halvings)) = waiting.pop() {
        let ends = (cartesian(&left[0]), cartesian(&left[left.len() - 1]));
        let near = |point| distance_to_segment(&cartesian(point), &ends.0, &ends.1) <= tolerance;
        if halvings == MAX_HALVINGS || left[1..left.len() - 1].iter().all(near) {
            if points.len() >= max_points {
                return Err(SplineError::TooManyPoints { max_points });
            }
            points.push(ends.1);
            continue;
        }
        // De Casteljau: the last point of each round is one of the right half, from its end; the left half is left.
        let mut right = Vec::with_capacity(left.len());
        for round in 1..=left.len() {
            right.push(left[left.len() - 1]);
            for k in (round..left.len()).rev() {
                left[k] = (left[k] + left[k - 1]) * 0.5;
            }
        }
        right.reverse();
        waiting.push((right, halvings + 1));
        waiting.push((left, halvings + 1));
    }
    Ok(())
}

#[cfg(test)]
mod tests;
