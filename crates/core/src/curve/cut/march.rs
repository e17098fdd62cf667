//! Places along a curve, from one corner to the next.

use nalgebra::{Point3, Vector3};

use super::super::distance_to_segment;

/// How often an interval is halved: what is left of it is far below what a machine does.
const HALVINGS: usize = 30;

/// A curve as points, with how far along each is.
pub(super) struct Samples<'a> {
    pub(super) points: &'a [Point3<f64>],
    along: Vec<f64>,
}

impl<'a> Samples<'a> {
    pub(super) fn new(points: &'a [Point3<f64>]) -> Self {
        let mut along = Vec::with_capacity(points.len());
        let mut sum = 0.0;
        for (k, point) in points.iter().enumerate() {
            sum += k.checked_sub(1).map_or(0.0, |before| (point - points[before]).norm());
            along.push(sum);
        }
        Self { points, along }
    }

    pub(super) fn length(&self) -> f64 {
        self.along.last().copied().unwrap_or_default()
    }

    /// Whether it ends where it begins.
    pub(super) fn returns(&self) -> bool {
        let gap = self.points.first().zip(self.points.last()).map_or(0.0, |(a, b)| (b - a).norm());
        gap <= 1e-9 * self.length()
    }

    /// The index of the last point that is not farther along than a place.
    fn before(&self, place: f64) -> usize {
        self.along.partition_point(|&along| along <= place).saturating_sub(1)
    }

    pub(super) fn at(&self, place: f64) -> Point3<f64> {
        let k = self.before(place);
        let Some(next) = self.points.get(k + 1) else { return self.points[k] };
        let span = self.along[k + 1] - self.along[k];
        let part = if span > 0.0 { (place - self.along[k]) / span } else { 0.0 };
        self.points[k] + (next - self.points[k]) * part
    }

    /// The points strictly between two places.
    pub(super) fn between(&self, from: f64, to: f64) -> &'a [Point3<f64>] {
        let first = self.along.partition_point(|&along| along <= from);
        let last = self.along.partition_point(|&along| along < to);
        self.points.get(first..last).unwrap_or_default()
    }

    /// From the chord between two places to the point of the curve that is farthest from it.
    pub(super) fn sagitta(&self, from: f64, to: f64) -> Vector3<f64> {
        let (a, b) = (self.at(from), self.at(to));
        let along = b - a;
        let length2 = along.norm_squared();
        let off = |point: &Point3<f64>| {
            let part = if length2 > 0.0 { ((point - a).dot(&along) / length2).clamp(0.0, 1.0) } else { 0.0 };
            point - (a + along * part)
        };
        let offs = self.between(from, to).iter().map(off);
        offs.max_by(|one, other| one.norm_squared().total_cmp(&other.norm_squared())).unwrap_or_default()
    }

    /// How far the curve is from the chord between two places at most.
    fn off(&self, from: f64, to: f64) -> f64 {
        let (a, b) = (self.at(from), self.at(to));
        let off = self.between(from, to).iter().map(|point| distance_to_segment(point, &a, &b));
        off.fold(0.0, f64::max)
    }

    /// The next corner: as far as the chord stays within `sagitta` of the curve, and not nearer than `chord`. The end
    /// where there is none before it.
    fn next(&self, from: f64, chord: f64, sagitta: f64) -> f64 {
        let (start, end) = (self.at(from), self.length());
        let first = self.before(from) + 1;
        let far = |k: &usize| (self.points[*k] - start).norm() >= chord;
        let Some(k) = (first..self.points.len()).find(far) else { return end };
        let before = self.along[k - 1].max(from);
        let least =
            before + (self.along[k] - before) * part_at(&self.at(before), &self.points[k], &start, chord);
        if sagitta <= 0.0 || self.off(from, least) > sagitta {
            return least;
        }
        // The first point that is too far: sought in growing steps, then between the last two.
        let is_off = |k: usize| self.off(from, self.along[k]) > sagitta;
        let last = self.points.len() - 1;
        let (mut low, mut high) = (k, k);
        while !is_off(high) {
            if high == last {
                return end;
            }
            low = high;
            high = (high + (high - first + 1)).min(last);
        }
        while high > low + 1 {
            let middle = usize::midpoint(low, high);
            if is_off(middle) { high = middle } else { low = middle }
        }
        let within = if low == high { least } else { self.along[low].max(least) };
        let (one, other) = (self.off(from, within), self.off(from, self.along[high]));
        let part = if other > one { ((sagitta - one) / (other - one)).clamp(0.0, 1.0) } else { 0.0 };
        within + (self.along[high] - within) * part
    }

    /// Places from the beginning to the end, at most `count` steps; the end is missing where these do not reach it.
    pub(super) fn march(&self, chord: f64, sagitta: f64, count: usize) -> Vec<f64> {
        let mut places = vec![0.0];
        let mut place = 0.0;
        while place < self.length() && places.len() <= count {
            place = self.next(place, chord, sagitta);
            places.push(place);
        }
        places
    }

    fn reaches(&self, count: usize, chord: f64, sagitta: f64) -> bool {
        self.march(chord, sagitta, count).last().is_some_and(|&place| place >= self.length())
    }

    /// A number of edges that are equally far from the curve, none shorter than `chord` where there is room for as many;
    /// else of one length.
    pub(super) fn divided(&self, count: usize, chord: f64) -> Vec<f64> {
        if self.reaches(count, chord, 0.0) {
            return self.divided_evenly(count);
        }
        let sagitta = halved(0.0, self.length(), |sagitta| self.reaches(count, chord, sagitta));
        self.whole(self.march(chord, sagitta, count))
    }

    /// A number of edges of one length.
    pub(super) fn divided_evenly(&self, count: usize) -> Vec<f64> {
        let chord = halved(0.0, self.length(), |chord| self.reaches(count, chord, 0.0));
        self.whole(self.march(chord, 0.0, count))
    }

    /// Places of which the last is the end.
    fn whole(&self, mut places: Vec<f64>) -> Vec<f64> {
        let end = self.length();
        // The last step ends a rounding short of the end, or with a rest of that size behind it.
        if places.len() > 2 && end - places[places.len() - 2] < 1e-6 * end {
            places.pop();
        }
        if let Some(last) = places.last_mut() {
            *last = end;
        }
        places
    }
}

/// Where something begins to hold between two numbers, of which it holds for the second.
fn halved(mut no: f64, mut yes: f64, holds: impl Fn(f64) -> bool) -> f64 {
    for _ in 0..HALVINGS {
        let middle = f64::midpoint(no, yes);
        if holds(middle) { yes = middle } else { no = middle }
    }
    yes
}

/// The part of a segment at which it is so far from a point that it comes away from.
fn part_at(a: &Point3<f64>, b: &Point3<f64>, from: &Point3<f64>, distance: f64) -> f64 {
    let (along, off) = (b - a, a - from);
    let (square, half) = (along.norm_squared(), along.dot(&off));
    let root = (half * half - square * (off.norm_squared() - distance * distance)).max(0.0).sqrt();
    if square > 0.0 { ((root - half) / square).clamp(0.0, 1.0) } else { 1.0 }
}
