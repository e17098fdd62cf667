//! Corners moved off a curve, so that it runs between them and the edges.

use nalgebra::{Point3, Vector3};

use super::super::distance_to_segment;
use super::march::Samples;
use super::{CurveCut, CurveEnds, EdgeLimit};
use crate::units::Length;

/// Corners go out by up to so many times what a chord is off: 4/3 is right for a triangle in a circle, more makes edges
/// longer where there is no room.
const FARTHEST: f64 = 3.0;
/// Ends slide by up to so much of the first edge.
const SLIDE: f64 = 1.5;
/// How many values are tried over the whole range, and how often the range about the best is narrowed.
const VALUES: u32 = 8;
const NARROWED: u32 = 3;
/// How often both are sought again, since each depends on the other.
const ROUNDS: usize = 2;
/// How much longer than the limit edges are sought, mm: more than their rounding.
const MARGIN_MM: f64 = 1e-4;
/// What a missing millimetre of an edge counts beside one of deviation.
const MISSING: f64 = 1e3;
/// How much farther than said a point between two samples may be, mm.
const BETWEEN_MM: f64 = 0.01;
/// The sharpest turn that becomes a single corner, as its cosine: 120°. Lines that fold back more meet far outside of their
/// curve.
const COS_SHARPEST: f64 = -0.5;

pub(super) struct Fit<'a> {
    samples: &'a Samples<'a>,
    ends: CurveEnds,
    limit: &'a EdgeLimit,
}

/// How good corners are.
struct Measured {
    deviation: f64,
    at: Point3<f64>,
    /// What all edges lack of the limit, mm, and how many lack anything.
    missing: f64,
    too_short: usize,
}

impl<'a> Fit<'a> {
    pub(super) fn new(samples: &'a Samples<'a>, ends: CurveEnds, limit: &'a EdgeLimit) -> Self {
        Self { samples, ends, limit }
    }

    /// The best corners for a division.
    pub(super) fn of(&self, places: &[f64]) -> CurveCut {
        let on_curve: Vec<Point3<f64>> = places.iter().map(|&place| self.samples.at(place)).collect();
        let out = self.ways_out(places);
        let cost = |penalty: f64| {
            let (on_curve, out) = (&on_curve, &out);
            move |far: f64, slide: f64| {
                let measured = self.measured(places, &self.corners(on_curve, out, far, slide));
                measured.deviation + penalty * measured.missing
            }
        };
        let (far, slide) = self.sought(cost(MISSING));
        let mut corners = self.corners(&on_curve, &out, far, slide);
        let mut measured = self.measured(places, &corners);
        if measured.too_short > 0 {
            // Where there is no room it is in vain to leave the curve for it.
            let (far, slide) = self.sought(cost(0.0));
            corners = self.corners(&on_curve, &out, far, slide);
            measured = self.measured(places, &corners);
        }
        self.made(places, corners, measured)
    }

    /// The lines before and behind the curve, up to where they meet, in place of it.
    pub(super) fn corner(&self) -> Option<CurveCut> {
        let CurveEnds::Open([Some(before), Some(behind)]) = self.ends else { return None };
        let (first, last) = (*self.samples.points.first()?, *self.samples.points.last()?);
        let (before, behind) = (before.try_normalize(0.0)?, behind.try_normalize(0.0)?);
        let (gap, cos) = (last - first, before.dot(&behind));
        let sin2 = 1.0 - cos * cos;
        if cos < COS_SHARPEST || sin2 < 1e-6 {
            return None;
        }
        // The nearest points of both lines, which are one where they meet.
        let on = (gap.dot(&before) - cos * gap.dot(&behind)) / sin2;
        let back = (cos * gap.dot(&before) - gap.dot(&behind)) / sin2;
        let (one, other) = (first + before * on, last + behind * back);
        if on <= 0.0 || back >= 0.0 || (one - other).norm() > 1e-3 * gap.norm() {
            return None;
        }
        let corners = vec![nalgebra::center(&one, &other)];
        let places = [0.0, self.samples.length()];
        let measured = self.measured(&places, &corners);
        // A corner has no edge that could be too short: without an end it would replace a curve of any size.
        (measured.deviation <= self.limit.shortest.mm()).then(|| self.made(&places, corners, measured))
    }

    fn made(&self, places: &[f64], mut points: Vec<Point3<f64>>, mut measured: Measured) -> CurveCut {
        self.look_between_samples(places, &points, &mut measured);
        if self.ends == CurveEnds::Ring {
            points.pop();
        }
        CurveCut {
            points,
            deviation: Length::computed(measured.deviation),
            at: measured.at,
            too_short: measured.too_short,
        }
    }

    /// For each corner the mean of what the curve is off the chords at both sides of it: nothing where it changes its
    /// side there, and nothing at ends that stay.
    fn ways_out(&self, places: &[f64]) -> Vec<Vector3<f64>> {
        let off: Vec<Vector3<f64>> =
            places.windows(2).map(|pair| self.samples.sagitta(pair[0], pair[1])).collect();
        let mut out = vec![Vector3::zeros()];
        out.extend(off.windows(2).map(|pair| (pair[0] + pair[1]) * 0.5));
        out.push(Vector3::zeros());
        if let (CurveEnds::Ring, Some(first), Some(last)) = (self.ends, off.first(), off.last()) {
            let end = out.len() - 1;
            out[0] = (first + last) * 0.5;
            out[end] = out[0];
        }
        out
    }

    fn corners(
        &self,
        on_curve: &[Point3<f64>],
        out: &[Vector3<f64>],
        far: f64,
        slide: f64,
    ) -> Vec<Point3<f64>> {
        let mut corners: Vec<Point3<f64>> =
            on_curve.iter().zip(out).map(|(at, out)| at + out * far).collect();
        let last = corners.len() - 1;
        if let CurveEnds::Open([before, behind]) = self.ends {
            let unit =
                |way: Option<Vector3<f64>>| way.and_then(|way| way.try_normalize(0.0)).unwrap_or_default();
            let edge = |k: usize| (on_curve[k] - on_curve[k - 1]).norm() * slide;
            corners[0] += unit(before) * edge(1);
            corners[last] -= unit(behind) * edge(last);
        }
        corners
    }

    /// The values that cost least, each sought by itself while the other stays.
    fn sought(&self, cost: impl Fn(f64, f64) -> f64) -> (f64, f64) {
        let slides = matches!(self.ends, CurveEnds::Open([one, other]) if one.is_some() || other.is_some());
        let (mut far, mut slide) = (0.0, 0.0);
        // Alone it is found at once.
        for _ in 0..if slides { ROUNDS } else { 1 } {
            if slides {
                slide = least(SLIDE, |slide| cost(far, slide));
            }
            far = least(FARTHEST, |far| cost(far, slide));
        }
        (far, slide)
    }

    /// How far corners are from the curve, each edge beside the part that it stands for.
    fn measured(&self, places: &[f64], corners: &[Point3<f64>]) -> Measured {
        let is_ring = self.ends == CurveEnds::Ring;
        let line = self.line(corners);
        let (mut deviation, mut at) = (0.0_f64, self.samples.points[0]);
        let mut count = |distance: f64, place: Point3<f64>| {
            if distance > deviation {
                (deviation, at) = (distance, place);
            }
        };
        for (k, pair) in places.windows(2).enumerate() {
            let ends = [self.samples.at(pair[0]), self.samples.at(pair[1])];
            let inner = self.samples.between(pair[0], pair[1]);
            for point in ends.iter().chain(inner) {
                count(distance_to_part(point, &line, k), *point);
            }
        }
        // A corner may be farther out than any point of the curve is from its edges.
        for (k, corner) in corners.iter().enumerate() {
            let (from, to) = (places[k.saturating_sub(1)], places[(k + 1).min(places.len() - 1)]);
            let both = is_ring && (k == 0 || k + 1 == places.len());
            count(self.distance_to_curve(corner, from, to, both.then_some(places)), *corner);
        }
        let lacking = self.limit.lacking(corners, self.ends);
        Measured {
            deviation,
            at,
            missing: lacking.iter().map(|lack| (lack + MARGIN_MM).max(0.0)).sum(),
            too_short: lacking.iter().filter(|&&lack| lack > MARGIN_MM / 100.0).count(),
        }
    }

    /// The edges, with one more at both ends: where an end has slid, the line before it goes on up to there.
    fn line(&self, corners: &[Point3<f64>]) -> Vec<Point3<f64>> {
        let (first, last) = (self.samples.points[0], self.samples.points[self.samples.points.len() - 1]);
        let is_ring = self.ends == CurveEnds::Ring;
        let mut line = Vec::with_capacity(corners.len() + 2);
        line.push(if is_ring { corners[corners.len().saturating_sub(2)] } else { first });
        line.extend_from_slice(corners);
        line.push(if is_ring { corners[1.min(corners.len() - 1)] } else { last });
        line
    }

    /// Between two samples another edge may become the nearest one, and both be farther there than at the samples. A distance
    /// grows no faster than one goes: only where that leaves room for more is looked closer.
    fn look_between_samples(&self, places: &[f64], corners: &[Point3<f64>], measured: &mut Measured) {
        let line = self.line(corners);
        for (k, pair) in places.windows(2).enumerate() {
            let far = |point: Point3<f64>| (point, distance_to_part(&point, &line, k));
            let mut before = far(self.samples.at(pair[0]));
            let end = self.samples.at(pair[1]);
            for next in self.samples.between(pair[0], pair[1]).iter().chain([&end]) {
                let next = far(*next);
                let mut steps = vec![(before, next)];
                while let Some((one, other)) = steps.pop() {
                    let most = f64::midpoint(one.1, other.1) + (other.0 - one.0).norm() / 2.0;
                    if most <= measured.deviation + BETWEEN_MM {
                        continue;
                    }
                    let middle = far(nalgebra::center(&one.0, &other.0));
                    if middle.1 > measured.deviation {
                        (measured.at, measured.deviation) = middle;
                    }
                    steps.extend([(one, middle), (middle, other)]);
                }
                before = next;
            }
        }
    }

    /// The distance of a corner to the curve between two places; at the beginning of a ring, to the parts at both ends.
    fn distance_to_curve(&self, point: &Point3<f64>, from: f64, to: f64, ring: Option<&[f64]>) -> f64 {
        let part = |from: f64, to: f64| {
            let (mut before, end) = (self.samples.at(from), self.samples.at(to));
            let mut near = f64::INFINITY;
            for next in self.samples.between(from, to).iter().chain([&end]) {
                near = near.min(distance_to_segment(point, &before, next));
                before = *next;
            }
            near
        };
        match ring {
            Some([first, second, .., last_but_one, last]) => {
                part(*first, *second).min(part(*last_but_one, *last))
            }
            _ => part(from, to),
        }
    }
}

/// The distance of a point of a part of the curve to its edge and those beside it.
fn distance_to_part(point: &Point3<f64>, line: &[Point3<f64>], part: usize) -> f64 {
    let sides = line[part..(part + 4).min(line.len())].windows(2);
    sides.map(|side| distance_to_segment(point, &side[0], &side[1])).fold(f64::INFINITY, f64::min)
}

/// The value from 0 to `most` that costs least, as far as values close together cost about the same.
fn least(most: f64, cost: impl Fn(f64) -> f64) -> f64 {
    let (mut low, mut step) = (0.0, most / f64::from(VALUES));
    let mut best = (cost(0.0), 0.0);
    for _ in 0..=NARROWED {
        for k in 0..=VALUES {
            let value = (low + step * f64::from(k)).clamp(0.0, most);
            let costs = cost(value);
            if costs < best.0 {
                best = (costs, value);
            }
        }
        low = best.1 - step;
        step *= 2.0 / f64::from(VALUES);
    }
    best.1
}
