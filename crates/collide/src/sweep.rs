//! The first contact and the least distance of a motion.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use nalgebra::IsometryMatrix3;

use crate::chain::{Interval, Run};
use crate::piece::nearer_than;
use crate::{Motion, Parts, Solid};

/// What is asked about a chain and a solid that moves past it.
#[derive(Clone, Copy)]
pub struct Task<'a> {
    /// What counts of the chain.
    pub parts: &'a Parts<'a>,
    /// The solid.
    pub solid: &'a Solid,
    /// How it moves past the chain.
    pub motion: &'a dyn Motion,
    /// They meet where the centreline of the chain is this near to the solid: radius of the wire, and margin.
    pub reach: f64,
    /// How exact distances are, mm; above 0.
    pub tolerance: f64,
}

impl Task<'_> {
    /// Whether what counts of a piece may come as near as `reach`.
    fn piece_may_meet(&self, piece: usize, reach: f64) -> bool {
        self.parts.within(self.parts.chain().interval(piece)).any(|part| {
            let [from, to] = [part.from, part.to].map(|along| self.parts.chain().point(piece, along));
            self.motion.min_distance_of_piece([&from, &to]) <= reach
        })
    }

    /// Whether a run of pieces may come as near as `reach` for all that is known without moving it.
    fn may_meet(&self, run: Run, reach: f64) -> bool {
        let ball = self.parts.chain().ball(run);
        self.motion.min_distance(&ball.centre) - ball.radius <= reach
            && (self.parts.chain().halves(run).is_some() || self.piece_may_meet(run.first, reach))
    }
}

/// When and where a moving chain and a solid meet, or come nearest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Proximity {
    /// When, from 0 to 1.
    pub time: f64,
    /// Which piece of the chain.
    pub piece: usize,
    /// Where on the chain, as the length along it.
    pub along: f64,
    /// How far the centreline of the chain is from the solid; negative inside.
    pub distance: f64,
}

/// The first time at which the chain is within `reach` of the solid; `None` where it never is.
///
/// A contact that is deeper than `tolerance` is never missed, and none is reported that is farther than `reach` and `tolerance`.
/// It is reported no later than it is, and no earlier than at a distance of `tolerance` more than `reach`.
#[must_use]
pub fn first_contact(task: &Task) -> Option<Proximity> {
    let reach = task.reach + task.tolerance;
    let now = task.parts.runs().iter().rev().copied().filter(|run| task.may_meet(*run, reach)).collect();
    let mut search = First { task, now, later: BinaryHeap::new() };
    let mut time = 0.0;
    loop {
        let pose = task.motion.pose(time);
        while let Some(run) = search.now.pop() {
            if let Some(near) = search.advance(run, time, &pose) {
                return Some(near);
            }
        }
        let next = search.later.pop()?;
        time = next.time;
        search.now.push(next.run);
    }
}

/// A run of pieces that meets nothing before a time.
#[derive(Clone, Copy)]
struct Later {
    time: f64,
    run: Run,
}

/// The one whose time is least comes first out of a heap; of several the one that is first in the chain.
impl Ord for Later {
    fn cmp(&self, other: &Self) -> Ordering {
        other.time.total_cmp(&self.time).then(other.run.first.cmp(&self.run.first))
    }
}

impl PartialOrd for Later {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Later {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Later {}

/// Conservative advancement of all runs of the chain together: always of those that are behind.
struct First<'a> {
    task: &'a Task<'a>,
    /// Runs that meet nothing before now.
    now: Vec<Run>,
    later: BinaryHeap<Later>,
}

/// A run whose ball is nearer than this share of its radius is divided; from farther it is moved on as a whole.
const NEAR: f64 = 0.5;

impl First<'_> {
    /// Moves a run on by what its distance allows, divides it where that is little, or finds that it meets the solid now.
    fn advance(&mut self, run: Run, time: f64, pose: &IsometryMatrix3<f64>) -> Option<Proximity> {
        let task = self.task;
        let ball = task.parts.chain().ball(run);
        let mut free = task.solid.distance(&(pose * ball.centre)) - ball.radius - task.reach;
        // The ball moves as far as its centre, however it turns about it.
        let mut turning = 0.0;
        if free <= task.tolerance.max(ball.radius * NEAR) {
            if let Some(halves) = task.parts.chain().halves(run) {
                let may_meet = |half: &Run| task.may_meet(*half, task.reach + task.tolerance);
                self.now.extend(halves.into_iter().rev().filter(may_meet));
                return None;
            }
            let near = task
                .parts
                .within(task.parts.chain().interval(run.first))
                .map(|part| nearest(task, run.first, part, pose, f64::INFINITY))
                .min_by(|one, other| one.distance.total_cmp(&other.distance))?;
            if near.distance - task.reach <= task.tolerance {
                return Some(Proximity { time, ..near });
            }
            // What the narrowing of the distance may be off by is taken away.
            free = near.distance - task.reach - task.tolerance / 4.0;
            turning = ball.radius;
        }
        let time = time + free / task.motion.max_travel(&ball.centre, turning);
        if time <= 1.0 {
            self.later.push(Later { time, run });
        }
        None
    }
}

/// The least distance between chain and solid over the motion, as far as it is below `reach`; `None` where they do not come
/// within it. It is above the exact one by twice `tolerance` at most, or by this share of how far it is below `surface`.
#[must_use]
pub fn closest(task: &Task, surface: f64, share: f64) -> Option<Proximity> {
    let mut search = Closest { task, surface, share, best: None };
    let pose = task.motion.pose(Span::WHOLE.middle());
    for &run in task.parts.runs() {
        search.look(run, Span::WHOLE, &pose);
    }
    search.best
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

struct Closest<'a> {
    task: &'a Task<'a>,
    surface: f64,
    share: f64,
    best: Option<Proximity>,
}

impl Closest<'_> {
    /// Looks in a run of pieces, in a part of the motion. `pose`: in the middle of it.
    fn look(&mut self, run: Run, span: Span, pose: &IsometryMatrix3<f64>) {
        let task = self.task;
        if !task.may_meet(run, self.wanted()) {
            return;
        }
        let ball = task.parts.chain().ball(run);
        let moves = task.motion.max_travel(&ball.centre, ball.radius) * span.half_length();
        let centre = task.solid.distance(&(pose * ball.centre));
        if centre - ball.radius - moves >= self.wanted() {
            return;
        }
        let mut in_time = moves > ball.radius;
        if let Some(halves) = task.parts.chain().halves(run).filter(|_| !in_time) {
            for half in halves {
                self.look(half, span, pose);
            }
            return;
        }
        if task.parts.chain().halves(run).is_none() {
            in_time = false;
            for part in task.parts.within(task.parts.chain().interval(run.first)) {
                let near = nearest(task, run.first, part, pose, self.wanted() + moves);
                if near.distance < self.wanted() {
                    self.best = Some(Proximity { time: span.middle(), ..near });
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
        let below = self.best.map_or(0.0, |best| self.surface - best.distance);
        self.task.tolerance.max(self.share * below)
    }
}

/// How near a part of a piece comes; the time is left open.
fn nearest(task: &Task, piece: usize, part: Interval, pose: &IsometryMatrix3<f64>, enough: f64) -> Proximity {
    let at = |along: f64| pose * task.parts.chain().point(piece, along);
    let near = nearer_than([&at(part.from), &at(part.to)], task.solid, task.tolerance / 4.0, enough);
    let along = part.from + (part.to - part.from) * near.part;
    Proximity { time: 0.0, piece, along, distance: near.distance }
}
