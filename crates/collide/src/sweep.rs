//! The first contact and the least distance of a motion.

use nalgebra::{Isometry3, Point3};

use crate::chain::{Chain, Interval, Run};
use crate::piece::nearer_than;
use crate::{Motion, Solid};

/// What is asked about a chain and a solid that moves past it.
#[derive(Clone, Copy)]
pub struct Task<'a> {
    /// The chain.
    pub chain: &'a Chain,
    /// Which parts of it count, in order and apart from each other. None: nothing.
    pub parts: &'a [Interval],
    /// The solid.
    pub solid: &'a Solid,
    /// How it moves past the chain.
    pub motion: &'a dyn Motion,
    /// They meet where the centreline of the chain is this near to the solid: radius of the wire, and margin.
    pub reach: f64,
    /// How exact distances are, mm; above 0.
    pub tolerance: f64,
}

/// Where a chain and a solid meet, or come nearest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Meeting {
    /// When, from 0 to 1.
    pub time: f64,
    /// Which piece of the chain.
    pub piece: usize,
    /// Where on the chain, as the length along it.
    pub along: f64,
    /// How far the centreline of the chain is from the solid; negative inside.
    pub distance: f64,
}

/// A part of the motion, in time.
#[derive(Clone, Copy)]
struct Span {
    from: f64,
    to: f64,
}

impl Span {
    const WHOLE: Self = Self { from: 0.0, to: 1.0 };

    fn middle(self) -> f64 {
        f64::midpoint(self.from, self.to)
    }

    fn halves(self) -> [Self; 2] {
        let middle = self.middle();
        [Self { to: middle, ..self }, Self { from: middle, ..self }]
    }

    fn half_length(self) -> f64 {
        (self.to - self.from) / 2.0
    }
}

/// The first time at which the chain is within `reach` of the solid; `None` where it never is.
///
/// A contact that is deeper than `tolerance` is never missed, and none is reported that is farther than `reach` and `tolerance`.
/// It is reported no later than it is, and no earlier than at a distance of `tolerance` more than `reach`.
#[must_use]
pub fn first_contact(task: &Task) -> Option<Meeting> {
    let all = task.chain.all()?;
    let mut search = First { task, best: None };
    // Most of what meets in a motion has met before it.
    search.look(all, Span { from: 0.0, to: 0.0 }, &task.motion.pose(0.0));
    if search.best.is_none() {
        search.look(all, Span::WHOLE, &task.motion.pose(Span::WHOLE.middle()));
    }
    search.best
}

struct First<'a> {
    task: &'a Task<'a>,
    best: Option<Meeting>,
}

impl First<'_> {
    /// Looks in a run of pieces, in a part of the motion; the earlier half of it first. `pose`: in the middle of it.
    fn look(&mut self, run: Run, span: Span, pose: &Isometry3<f64>) {
        let task = self.task;
        let best = self.best.map_or(f64::INFINITY, |meeting| meeting.time);
        if span.from >= best || !counts(task.parts, task.chain.extent(run)) {
            return;
        }
        let ball = task.chain.ball(run);
        let distance = task.solid.distance(&(pose * ball.centre)) - ball.radius - task.reach;
        let most = task.motion.most(&ball.centre, ball.radius);
        let moves = most * span.half_length();
        if distance > moves + task.tolerance {
            return;
        }
        let Some(halves) = run.halves() else {
            self.advance(run.first, span, most);
            return;
        };
        if moves > ball.radius {
            for half in span.halves() {
                self.look(run, half, &task.motion.pose(half.middle()));
            }
        } else {
            for half in halves {
                self.look(half, span, pose);
            }
        }
    }

    /// Moves on by what the distance of a piece allows, until it is used up or the time is over.
    fn advance(&mut self, piece: usize, span: Span, most: f64) {
        let task = self.task;
        let end = self.best.map_or(span.to, |best| best.time.min(span.to));
        for part in clipped(task.parts, task.chain.interval(piece)) {
            let mut time = span.from;
            while time <= end {
                let pose = task.motion.pose(time);
                let near = nearest(task, piece, part, &pose, f64::INFINITY);
                let left = near.distance - task.reach;
                if left <= task.tolerance {
                    if self.best.is_none_or(|best| time < best.time) {
                        self.best = Some(Meeting { time, ..near });
                    }
                    break;
                }
                if most <= 0.0 {
                    break;
                }
                // What the narrowing of the distance may be off by is taken away.
                time += (left - task.tolerance / 4.0) / most;
            }
        }
    }
}

/// The least distance between chain and solid over the motion, as far as it is below `reach`; `None` where they do not come
/// within it. It is above the exact one by twice `tolerance` at most, or by this share of how far it is below `reach`.
#[must_use]
pub fn closest(task: &Task, share: f64) -> Option<Meeting> {
    let mut search = Closest { task, share, best: None };
    search.look(task.chain.all()?, Span::WHOLE, &task.motion.pose(Span::WHOLE.middle()));
    search.best
}

struct Closest<'a> {
    task: &'a Task<'a>,
    share: f64,
    best: Option<Meeting>,
}

impl Closest<'_> {
    /// Looks in a run of pieces, in a part of the motion. `pose`: in the middle of it.
    fn look(&mut self, run: Run, span: Span, pose: &Isometry3<f64>) {
        let task = self.task;
        if !counts(task.parts, task.chain.extent(run)) {
            return;
        }
        let ball = task.chain.ball(run);
        let moves = task.motion.most(&ball.centre, ball.radius) * span.half_length();
        let centre = task.solid.distance(&(pose * ball.centre));
        if centre - ball.radius - moves >= self.wanted() {
            return;
        }
        let mut in_time = moves > ball.radius;
        if let Some(halves) = run.halves().filter(|_| !in_time) {
            for half in halves {
                self.look(half, span, pose);
            }
            return;
        }
        if run.halves().is_none() {
            in_time = false;
            for part in clipped(task.parts, task.chain.interval(run.first)) {
                let near = nearest(task, run.first, part, pose, self.wanted() + moves);
                if near.distance < self.wanted() {
                    self.best = Some(Meeting { time: span.middle(), ..near });
                }
                let may_be_nearer = near.distance - task.tolerance / 4.0 - moves < self.wanted();
                in_time |= may_be_nearer && moves > self.tolerance();
            }
        }
        if in_time {
            for half in span.halves() {
                self.look(run, half, &task.motion.pose(half.middle()));
            }
        }
    }

    /// Only what is nearer than this is of interest.
    fn wanted(&self) -> f64 {
        self.best.map_or(self.task.reach, |best| best.distance - self.tolerance())
    }

    fn tolerance(&self) -> f64 {
        let below = self.best.map_or(0.0, |best| self.task.reach - best.distance);
        self.task.tolerance.max(self.share * below)
    }
}

/// How near a part of a piece comes; the time is left open.
fn nearest(task: &Task, piece: usize, part: Interval, pose: &Isometry3<f64>, enough: f64) -> Meeting {
    let [from, to] = task.chain.piece(piece).map(|end| pose * end);
    let whole = task.chain.interval(piece);
    let length = whole.to - whole.from;
    let at = |along: f64| -> Point3<f64> {
        let share = if length > 0.0 { (along - whole.from) / length } else { 0.0 };
        from + (to - from) * share
    };
    let near = nearer_than([&at(part.from), &at(part.to)], task.solid, task.tolerance / 4.0, enough);
    let along = part.from + (part.to - part.from) * near.part;
    Meeting { time: 0.0, piece, along, distance: near.distance }
}

/// Whether any of the parts that count is in an interval.
fn counts(parts: &[Interval], interval: Interval) -> bool {
    let after = parts.partition_point(|part| part.to < interval.from);
    parts.get(after).is_some_and(|part| part.from <= interval.to)
}

/// The parts of an interval that count.
fn clipped(parts: &[Interval], interval: Interval) -> impl Iterator<Item = Interval> {
    let after = parts.partition_point(|part| part.to < interval.from);
    let within = parts[after..].iter().take_while(move |part| part.from <= interval.to);
    within.map(move |part| Interval { from: part.from.max(interval.from), to: part.to.min(interval.to) })
}
