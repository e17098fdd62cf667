//! A line of straight pieces, with a tree of balls around its runs.

use nalgebra::{Point3, center};

/// A part of a chain, by the lengths along it at which it begins and ends, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Interval {
    /// Where it begins.
    pub from: f64,
    /// Where it ends.
    pub to: f64,
}

/// A line of straight pieces in order. Any run from its start is a chain of its own, so that it serves while it grows.
#[derive(Debug, Clone, Default)]
pub struct Chain {
    points: Vec<Point3<f64>>,
    /// The length along the chain at each point.
    along: Vec<f64>,
    /// Around each run of pieces of the tree, in the order in which [`Run`] counts.
    balls: Vec<Ball>,
}

/// A ball around a run of pieces.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Ball {
    pub centre: Point3<f64>,
    pub radius: f64,
    /// The piece with which the second half of the run begins; of a single piece itself.
    middle: usize,
}

/// A run of pieces with a ball around it. The first half of a run comes right after it, the second half after all of that.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Run {
    pub first: usize,
    pub end: usize,
    node: usize,
}

impl Run {
    fn parted(self, middle: usize) -> [Self; 2] {
        let one = Self { end: middle, node: self.node + 1, ..self };
        // A run of n pieces has 2 n - 1 balls.
        let other = Self { first: middle, node: self.node + 2 * (middle - self.first), ..self };
        [one, other]
    }
}

impl Chain {
    /// A chain through points, mm.
    #[must_use]
    pub fn new(points: Vec<Point3<f64>>) -> Self {
        let mut along = Vec::with_capacity(points.len());
        let mut length = 0.0;
        for (k, point) in points.iter().enumerate() {
            length += k.checked_sub(1).map_or(0.0, |before| (point - points[before]).norm());
            along.push(length);
        }
        Self::with(points, along)
    }

    /// The same chain, or its begin, with its points elsewhere. Lengths along it are still those of this one.
    ///
    /// ```
    /// use nalgebra::Point3;
    /// use wirebend_collide::Chain;
    /// let straight = Chain::new((0..4).map(|k| Point3::new(f64::from(k), 0.0, 0.0)).collect());
    /// let lifted = straight.moved(vec![Point3::new(0.0, 0.0, 0.5), Point3::new(1.0, 0.0, 0.0)]);
    /// assert_eq!((lifted.pieces(), lifted.along()), (1, &[0.0, 1.0][..]));
    /// ```
    #[must_use]
    pub fn moved(&self, mut points: Vec<Point3<f64>>) -> Self {
        points.truncate(self.points.len());
        let along = self.along[..points.len()].to_vec();
        Self::with(points, along)
    }

    fn with(points: Vec<Point3<f64>>, along: Vec<f64>) -> Self {
        let mut chain = Self { points, along, balls: Vec::new() };
        if let Some(all) = chain.all() {
            chain.balls.reserve(2 * chain.pieces());
            chain.grow(all);
        }
        chain
    }

    /// How many pieces it has.
    #[must_use]
    pub fn pieces(&self) -> usize {
        self.points.len().saturating_sub(1)
    }

    /// The ends of a piece, by its index from 0.
    ///
    /// # Panics
    /// When there is no such piece.
    #[must_use]
    pub fn piece(&self, index: usize) -> [&Point3<f64>; 2] {
        [&self.points[index], &self.points[index + 1]]
    }

    /// The part of the chain that a piece is.
    ///
    /// # Panics
    /// When there is no such piece.
    #[must_use]
    pub fn interval(&self, index: usize) -> Interval {
        Interval { from: self.along[index], to: self.along[index + 1] }
    }

    /// The point of a piece at a length along the chain.
    pub(crate) fn point(&self, index: usize, along: f64) -> Point3<f64> {
        let ([from, to], whole) = (self.piece(index), self.interval(index));
        let length = whole.to - whole.from;
        let share = if length > 0.0 { (along - whole.from) / length } else { 0.0 };
        from + (to - from) * share
    }

    /// Its points.
    #[must_use]
    pub fn points(&self) -> &[Point3<f64>] {
        &self.points
    }

    /// The length along the chain at each of its points, mm.
    #[must_use]
    pub fn along(&self) -> &[f64] {
        &self.along
    }

    pub(crate) fn all(&self) -> Option<Run> {
        (self.pieces() > 0).then(|| Run { first: 0, end: self.pieces(), node: 0 })
    }

    pub(crate) fn ball(&self, run: Run) -> &Ball {
        &self.balls[run.node]
    }

    /// The halves of a run, about as long as each other; `None` for a single piece.
    pub(crate) fn halves(&self, run: Run) -> Option<[Run; 2]> {
        (run.end - run.first > 1).then(|| run.parted(self.ball(run).middle))
    }

    pub(crate) fn extent(&self, run: Run) -> Interval {
        Interval { from: self.along[run.first], to: self.along[run.end] }
    }

    /// Adds the balls of a run and of all runs in it.
    fn grow(&mut self, run: Run) -> Ball {
        let [from, to] = self.piece(run.first);
        let mut ball = Ball { centre: center(from, to), radius: (to - from).norm() / 2.0, middle: run.first };
        self.balls.push(ball);
        if run.end - run.first > 1 {
            let half = f64::midpoint(self.along[run.first], self.along[run.end]);
            let before = self.along[run.first..run.end].partition_point(|&along| along < half);
            let middle = (run.first + before).clamp(run.first + 1, run.end - 1);
            let [one, other] = run.parted(middle).map(|half| self.grow(half));
            ball = Ball { middle, ..around(&one, &other) };
            self.balls[run.node] = ball;
        }
        ball
    }
}

/// The smallest ball around two.
fn around(one: &Ball, other: &Ball) -> Ball {
    let between = other.centre - one.centre;
    let apart = between.norm();
    if apart + other.radius <= one.radius {
        return *one;
    }
    if apart + one.radius <= other.radius {
        return *other;
    }
    let radius = (apart + one.radius + other.radius) / 2.0;
    Ball { centre: one.centre + between * ((radius - one.radius) / apart), radius, middle: one.middle }
}
