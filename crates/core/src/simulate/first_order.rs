//! What single errors do to a wire, to first order: how far each vertex scatters, which source of errors moves the wire most, and
//! which of its steps.

use nalgebra::{Matrix3, Point3, Vector3};

use super::wire::{Bow, corner_to_corner, rotations_made};
use super::{BadErrorTerm, ErrorModel, ErrorSource, ErrorTerm, SimulationInput, formed};
use crate::bend::Step;
use crate::compensate::Compensation;
use crate::units::Angle;

/// What the errors of a model do to a wire, small as they are: every vertex moves by the sum of what the single errors move it by.
#[derive(Debug, Clone, PartialEq)]
pub struct FirstOrder {
    /// Of each vertex of the route: how far it is off on average, mm.
    pub mean: Vec<Vector3<f64>>,
    /// Of each vertex: variances and covariances of its place, mm².
    pub covariance: Vec<Matrix3<f64>>,
    /// How far each source alone moves the wire, in the order of [`ErrorSource::ALL`].
    pub sources: [SourceEffect; 4],
    /// How far the errors of each step move the wire.
    pub steps: Vec<StepEffect>,
}

/// What one source of errors does, as root mean square over all vertices.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SourceEffect {
    /// The source.
    pub source: ErrorSource,
    /// Root mean square of the distance of all vertices from where they should be, mm.
    pub rms_mm: f64,
}

/// What the errors of one step do, each without the others, as root mean square over all vertices, mm.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct StepEffect {
    /// Of its feed and of the bow of its strut.
    pub feed_mm: f64,
    /// Of its rotation.
    pub rotate_mm: f64,
    /// Of its bend.
    pub bend_mm: f64,
}

/// Mean and variance of an error.
#[derive(Clone, Copy)]
struct Moments {
    mean: f64,
    variance: f64,
}

/// What a single error of size one does to the vertices: nothing before `from`, the rest as `moves` says.
struct Moved<'a> {
    from: usize,
    moves: &'a [Vector3<f64>],
}

/// Sums over the errors of one source.
struct Sum {
    mean: Vec<Vector3<f64>>,
    covariance: Vec<Matrix3<f64>>,
}

impl Sum {
    fn new(vertices: usize) -> Self {
        Self { mean: vec![Vector3::zeros(); vertices], covariance: vec![Matrix3::zeros(); vertices] }
    }

    /// Adds an error; the mean over all vertices of the square that it alone moves them by.
    fn add(&mut self, error: Moments, moved: &Moved) -> f64 {
        let mut squares = 0.0;
        let places = self.mean.iter_mut().zip(&mut self.covariance).skip(moved.from);
        for ((mean, covariance), way) in places.zip(moved.moves) {
            *mean += way * error.mean;
            *covariance += way * way.transpose() * error.variance;
            squares += way.norm_squared();
        }
        squares * error.mean.mul_add(error.mean, error.variance) / count(self.mean.len())
    }

    fn rms(&self) -> f64 {
        let squares = self.mean.iter().zip(&self.covariance).map(|(m, c)| m.norm_squared() + c.trace());
        (squares.sum::<f64>() / count(self.mean.len())).sqrt()
    }
}

#[allow(clippy::cast_precision_loss)] // vertices are far fewer than 2^52
fn count(vertices: usize) -> f64 {
    vertices.max(1) as f64
}

/// What the errors of a model do to a wire as long as they are small.
///
/// Bends, rotations and feeds move everything after them in proportion. A bow takes the same length whichever side it is to: its
/// part is the mean and the variance of what it takes. Vertices within a strut go aside with it, to every side alike.
///
/// # Errors
/// [`BadErrorTerm`] when an error is not finite or a deviation is negative.
pub fn first_order(input: &SimulationInput, errors: &ErrorModel) -> Result<FirstOrder, BadErrorTerm> {
    let moments = |of: ErrorSource| {
        let term = errors.term(of);
        term.check(of)?;
        let of_angle = matches!(of, ErrorSource::Rotation | ErrorSource::Bend);
        let unit = if of_angle { 1f64.to_radians() } else { 1.0 };
        Ok(match of {
            ErrorSource::Curvature => lost_by_bows(term),
            _ => Moments { mean: term.bias * unit, variance: (term.sigma * unit).powi(2) },
        })
    };
    let [feed, rotation, bend, bow] = [
        moments(ErrorSource::Feed)?,
        moments(ErrorSource::Rotation)?,
        moments(ErrorSource::Bend)?,
        moments(ErrorSource::Curvature)?,
    ];
    let formed = formed(input.program, input.compensation);
    let walk = Walk::new(input, &corner_to_corner(&formed, input.compensation));
    let vertices = walk.points.len();
    let mut sums = ErrorSource::ALL.map(|_| Sum::new(vertices));
    let mut steps = vec![StepEffect::default(); formed.len()];
    let mut moves = Vec::new();
    let rotations_made = rotations_made(&formed);
    for (k, effect) in steps.iter_mut().enumerate() {
        let mut by_length = Vec::new();
        let from = walk.by_length(k, &mut by_length);
        let lengths = Moved { from, moves: &by_length };
        let fed = sums[0].add(feed, &lengths);
        let length = walk.steps[k].length;
        let bowed = Moments { mean: bow.mean * length, variance: bow.variance * length * length };
        let aside = walk.aside(k, errors.curvature, &mut sums[3]);
        effect.feed_mm = (fed + sums[3].add(bowed, &lengths) + aside).sqrt();
        if formed[k].bend == Angle::ZERO {
            continue;
        }
        walk.by_turn(k, walk.steps[k].t, &mut moves);
        let after = walk.steps[k].last + 1;
        if rotations_made[k] {
            effect.rotate_mm = sums[1].add(rotation, &Moved { from: after, moves: &moves }).sqrt();
        }
        walk.by_turn(k, walk.steps[k].b, &mut moves);
        let coupled = walk.with_lengths(k, from, &by_length, &moves, longer(&formed, k, input.compensation));
        let bend = Moments { mean: bend.mean * formed[k].bend.signum(), ..bend };
        effect.bend_mm = sums[2].add(bend, &Moved { from, moves: &coupled }).sqrt();
    }
    let sources =
        std::array::from_fn(|k| SourceEffect { source: ErrorSource::ALL[k], rms_mm: sums[k].rms() });
    let [mut all, rest @ ..] = sums;
    for sum in rest {
        for (mean, more) in all.mean.iter_mut().zip(sum.mean) {
            *mean += more;
        }
        for (covariance, more) in all.covariance.iter_mut().zip(sum.covariance) {
            *covariance += more;
        }
    }
    Ok(FirstOrder { mean: all.mean, covariance: all.covariance, sources, steps })
}

/// Where the steps of a wire without errors are.
struct Walk {
    points: Vec<Point3<f64>>,
    steps: Vec<Placed>,
    fractions: Vec<Vec<f64>>,
}

struct Placed {
    /// The first of the vertices along its feed, and the last, at which it bends.
    first: usize,
    last: usize,
    length: f64,
    t: Vector3<f64>,
    /// The axis of its bend.
    b: Vector3<f64>,
}

impl Walk {
    fn new(input: &SimulationInput, steps: &[Step]) -> Self {
        let mut frame = input.start;
        let mut points = vec![frame.position];
        let placed = steps.iter().zip(input.fractions).map(|(step, fractions)| {
            let (from, t, first) = (frame.position, frame.t(), points.len());
            points.extend(fractions.iter().map(|fraction| from + t * step.feed.mm() * *fraction));
            frame.position = *points.last().unwrap_or(&from);
            frame.rotate(step.rotate);
            let b = frame.b();
            frame.bend(step.bend);
            Placed { first, last: points.len() - 1, length: step.feed.mm(), t, b }
        });
        let steps = placed.collect();
        Self { points, steps, fractions: input.fractions.to_vec() }
    }

    /// By how much the vertices from the one that is given on move where a step is longer by 1 mm.
    fn by_length(&self, step: usize, moves: &mut Vec<Vector3<f64>>) -> usize {
        let Placed { first, last, t, .. } = self.steps[step];
        moves.clear();
        moves.extend(self.fractions[step].iter().map(|&fraction| t * fraction));
        moves.resize(moves.len() + self.points.len() - (last + 1), t);
        first
    }

    /// Adds how far the vertices within the strut of a step go aside with its bow; the mean over all vertices of the square of it.
    fn aside(&self, step: usize, bow: ErrorTerm, sum: &mut Sum) -> f64 {
        let Placed { first, length, t, .. } = self.steps[step];
        let [inner @ .., _] = self.fractions[step].as_slice() else { return 0.0 };
        let mean_square = bow.bias.mul_add(bow.bias, bow.sigma * bow.sigma) * length * length;
        let mut squares = 0.0;
        for (&fraction, covariance) in inner.iter().zip(&mut sum.covariance[first..]) {
            let square = (4.0 * fraction * (1.0 - fraction)).powi(2) * mean_square;
            // Half of it each of the two ways across.
            *covariance += (Matrix3::identity() - t * t.transpose()) * (square / 2.0);
            squares += square;
        }
        squares / count(self.points.len())
    }

    /// By how much the vertices after a step move where the wire turns by one radian at its end.
    fn by_turn(&self, step: usize, axis: Vector3<f64>, moves: &mut Vec<Vector3<f64>>) {
        let Placed { last, .. } = self.steps[step];
        let at = self.points[last];
        moves.clear();
        moves.extend(self.points[last + 1..].iter().map(|point| axis.cross(&(point - at))));
    }

    /// By how much the vertices from `from` on move where a bend is one radian more: all after it turn, and the feeds before and after
    /// it reach farther by `longer`.
    fn with_lengths(
        &self,
        step: usize,
        from: usize,
        by_length: &[Vector3<f64>],
        turned: &[Vector3<f64>],
        longer: [f64; 2],
    ) -> Vec<Vector3<f64>> {
        let mut moves: Vec<Vector3<f64>> = by_length.iter().map(|way| way * longer[0]).collect();
        let after = self.steps[step].last + 1 - from;
        for (way, turned) in moves.iter_mut().skip(after).zip(turned) {
            *way += turned;
        }
        if step + 1 < self.steps.len() {
            let mut next = Vec::new();
            let begin = self.by_length(step + 1, &mut next) - from;
            for (way, next) in moves.iter_mut().skip(begin).zip(next) {
                *way += next * longer[1];
            }
        }
        moves
    }
}

/// By how much the lengths from corner to corner before and after a bend grow with it, mm per radian.
fn longer(formed: &[Step], step: usize, compensation: &Compensation) -> [f64; 2] {
    /// Radians: the arc and the corner of a bend change evenly within it.
    const SMALL: f64 = 1e-6;
    let lengths = |more: f64| {
        let mut around: Vec<Step> = formed[step.saturating_sub(1)..formed.len().min(step + 2)].to_vec();
        let here = usize::from(step > 0);
        around[here].bend += Angle::computed(more);
        let steps = corner_to_corner(&around, compensation);
        let next = steps.get(here + 1).map_or(0.0, |step| step.feed.mm());
        [steps[here].feed.mm(), next]
    };
    let (more, less) = (lengths(SMALL), lengths(-SMALL));
    [0, 1].map(|side| (more[side] - less[side]) / (2.0 * SMALL))
}

/// Mean and variance of what bows take of a strut, as a share of its length.
fn lost_by_bows(term: ErrorTerm) -> Moments {
    /// The normal distribution is summed within so many deviations, in so many parts.
    const WITHIN: f64 = 8.0;
    const PARTS: i32 = 400;
    let lost = |bow: f64| Bow(bow).chord_over_arc() - 1.0;
    if term.sigma <= 0.0 {
        return Moments { mean: lost(term.bias), variance: 0.0 };
    }
    let at = |part: i32| WITHIN * f64::from(part) / f64::from(PARTS);
    let weighed: Vec<(f64, f64)> = (-PARTS..=PARTS)
        .map(|part| ((-at(part) * at(part) / 2.0).exp(), lost(term.sigma.mul_add(at(part), term.bias))))
        .collect();
    let total: f64 = weighed.iter().map(|(weight, _)| weight).sum();
    let mean = weighed.iter().map(|(weight, lost)| weight * lost).sum::<f64>() / total;
    let variance = weighed.iter().map(|(weight, lost)| weight * (lost - mean).powi(2)).sum::<f64>() / total;
    Moments { mean, variance }
}
