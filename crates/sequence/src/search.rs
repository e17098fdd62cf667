//! The search for an order in which a frame can be built.
//!
//! 1. Farthest from the ground is taken off first.
//! 2. Where that gets stuck, the reverse of the order that keeps the frame stiffest.
//! 3. Then anew, with what was in the way taken off sooner.
//! 4. Then with going back. When that has tried every order, there is none.

use std::collections::HashSet;
use std::ops::ControlFlow;

use wirebend_core::checks::sequence::StepKind;
use wirebend_core::units::Length;
use wirebend_frame::ModelError;

use super::builder::StrutBuilder;
use super::candidates::{Blocked, Candidates, upright};
use super::descent::{Descent, Stuck, take_apart};
use super::free_directions::FreeDirections;
use super::group_set::GroupSet;
use super::groups::Groups;
use super::keys;
use super::outcome::{Joint, Obstacle, ObstacleRule, Outcome, Partial, Progress, Step, Strategy};
use super::stability::{Stability, Weight, unsteady};
use super::structure::Structure;

/// What is built.
#[derive(Debug, Clone, Copy)]
pub struct Task<'a> {
    /// The frame.
    pub structure: &'a Structure,
    /// What is placed at once.
    pub groups: &'a Groups,
    /// The machine.
    pub builder: &'a StrutBuilder,
    /// Section and gravity.
    pub weight: &'a Weight,
}

/// How long is searched.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SearchOptions {
    /// How often it begins anew with what was in the way taken off sooner.
    pub restarts: u32,
    /// How often it goes back from a dead end after that.
    pub backtracks: u64,
    /// Where chance begins: the same seed gives the same sequence.
    pub seed: u64,
}

impl Default for SearchOptions {
    fn default() -> Self {
        Self { restarts: 30, backtracks: 3000, seed: 1 }
    }
}

/// Searches for an order. `should_continue` is told how far it is before each trial, and ends the search by breaking: then the
/// outcome has what was in the way so far.
///
/// # Errors
/// A frame that cannot be computed with, such as a section without stiffness.
pub fn search(
    task: &Task<'_>,
    options: &SearchOptions,
    should_continue: &mut dyn FnMut(&Progress) -> ControlFlow<()>,
) -> Result<Outcome, ModelError> {
    let stability = Stability::new(task.structure, task.weight)?;
    let candidates = candidates(task, &stability);
    let of = task.groups.all().len();
    if let Some(obstacle) = of_the_whole(task, &candidates) {
        return Ok(Outcome::impossible(obstacle));
    }
    let mut dead = HashSet::new();
    let mut rounds = Rounds { of, should_continue, farthest: None, stopped: Vec::new() };
    let first = keys::from_ground(&candidates);
    let mut stuck = match rounds.descend(&candidates, &first, Strategy::FromGround, 0, &mut dead) {
        Ok(outcome) => return Ok(outcome),
        Err(stuck) => stuck,
    };
    if let Some(stuck) = &stuck
        && !can_begin(&candidates)
    {
        return Ok(Outcome::impossible(obstacle(&candidates, stuck)));
    }
    let plan = keys::stiffness_plan(&candidates, &mut |taken| rounds.tell(Strategy::StiffnessPlan, taken));
    let mut bases = vec![first];
    if let Some(plan) = plan {
        let planned = keys::of_order(&plan);
        stuck = match rounds.descend(&candidates, &planned, Strategy::StiffnessPlan, 0, &mut dead) {
            Ok(outcome) => return Ok(outcome),
            Err(stuck) => stuck,
        };
        bases.push(planned);
    }
    let mut tried = bases.pop().unwrap_or_default();
    for round in 0..options.restarts {
        let Some(found) = &stuck else { break };
        keys::raise(&mut tried, &candidates, found);
        let mut moved = tried.clone();
        keys::jitter(&mut moved, options.seed, round);
        stuck = match rounds.descend(&candidates, &moved, Strategy::Restart(round + 1), 0, &mut dead) {
            Ok(outcome) => return Ok(outcome),
            Err(stuck) => stuck,
        };
    }
    if stuck.is_some() {
        let last = rounds.descend(&candidates, &tried, Strategy::Backtracking, options.backtracks, &mut dead);
        if let Ok(outcome) = last {
            return Ok(outcome);
        }
    }
    let farthest = rounds.farthest.as_ref();
    let order = farthest.map_or(&[][..], |stuck| &stuck.order);
    let order = if rounds.stopped.len() > order.len() { &rounds.stopped } else { order };
    let last = order.iter().rev().map(|&group| task.groups.all()[group].struts.clone()).collect();
    let partial = Partial { last, ..Partial::default() };
    Ok(Outcome::not_found(farthest.map(|stuck| obstacle(&candidates, stuck)), partial))
}

/// What keeps the whole frame from being built, whatever the order: a node out of reach, or that it sags too far once it is finished.
///
/// # Errors
/// A frame that cannot be computed with.
pub fn whole_frame(task: &Task<'_>) -> Result<Option<Obstacle>, ModelError> {
    let stability = Stability::new(task.structure, task.weight)?;
    Ok(of_the_whole(task, &candidates(task, &stability)))
}

/// The same where it is known what decides about each group.
pub(super) fn of_the_whole(task: &Task<'_>, candidates: &Candidates<'_>) -> Option<Obstacle> {
    out_of_reach(task).or_else(|| too_soft(candidates))
}

/// Whether a group on the ground stands alone, as the first one must. On a support that lets it turn or slide no strut does.
fn can_begin(candidates: &Candidates<'_>) -> bool {
    let count = candidates.groups.all().len();
    (0..count).filter(|&group| candidates.groups.all()[group].grounded).any(|group| {
        let mut first = GroupSet::none(count);
        first.insert(group);
        candidates.sag(&first).is_ok_and(|sag| sag.mm <= candidates.max_sag_mm)
    })
}

/// The groups in the order that keeps the largest sag least while only stability counts, and that sag of its worst step, mm.
///
/// # Errors
/// A frame that cannot be computed with.
pub fn stiffest_order(task: &Task<'_>) -> Result<(Vec<usize>, f64), ModelError> {
    let stability = Stability::new(task.structure, task.weight)?;
    let candidates = candidates(task, &stability);
    let order = keys::stiffness_plan(&candidates, &mut |_| ControlFlow::Continue(())).unwrap_or_default();
    let mut standing = GroupSet::none(task.groups.all().len());
    let worst = order.iter().map(|&group| {
        standing.insert(group);
        candidates.sag(&standing).map_or(f64::INFINITY, |sag| sag.mm)
    });
    let worst = worst.fold(0.0, f64::max);
    Ok((order, worst))
}

/// What decides about each group of a task.
pub(super) fn candidates<'a>(task: &Task<'a>, stability: &'a Stability) -> Candidates<'a> {
    let radius = Length::computed(task.weight.section.radius);
    Candidates {
        structure: task.structure,
        groups: task.groups,
        free: FreeDirections::new(task.structure, task.builder, radius),
        stability,
        ground_first: task.builder.ground_first,
        max_sag_mm: task.builder.max_sag.mm(),
    }
}

/// What the rounds of a search share.
struct Rounds<'a> {
    of: usize,
    should_continue: &'a mut dyn FnMut(&Progress) -> ControlFlow<()>,
    farthest: Option<Stuck>,
    /// What was taken off when the search was stopped.
    stopped: Vec<usize>,
}

impl Rounds<'_> {
    fn tell(&mut self, strategy: Strategy, taken: usize) -> ControlFlow<()> {
        (self.should_continue)(&Progress { strategy, taken, of: self.of })
    }

    /// One round. Otherwise where it got stuck, or nothing where it was stopped.
    fn descend(
        &mut self,
        candidates: &Candidates<'_>,
        keys: &[f64],
        strategy: Strategy,
        backtracks: u64,
        dead: &mut HashSet<GroupSet>,
    ) -> Result<Outcome, Option<Stuck>> {
        let descent = take_apart(candidates, keys, backtracks, dead, &mut |taken| self.tell(strategy, taken));
        match descent {
            Descent::Done(order) => {
                let built: Vec<usize> = order.into_iter().rev().collect();
                Ok(found(candidates, &built, strategy))
            }
            Descent::Impossible(stuck) => {
                // An earlier round may have come farther before it knew what is dead.
                self.keep(&stuck);
                let farthest = self.farthest.take().unwrap_or(stuck);
                Ok(Outcome::impossible(obstacle(candidates, &farthest)))
            }
            Descent::Stuck(stuck) => {
                self.keep(&stuck);
                Err(Some(stuck))
            }
            Descent::Stopped(stuck, order) => {
                if let Some(stuck) = &stuck {
                    self.keep(stuck);
                }
                self.stopped = order;
                Err(None)
            }
        }
    }

    fn keep(&mut self, stuck: &Stuck) {
        if self.farthest.as_ref().is_none_or(|kept| stuck.standing.len() < kept.standing.len()) {
            self.farthest = Some(stuck.clone());
        }
    }
}

/// The sequence that builds groups in this order, in which each can be placed.
pub(super) fn found(candidates: &Candidates<'_>, order: &[usize], strategy: Strategy) -> Outcome {
    let mut standing = GroupSet::none(candidates.groups.all().len());
    let mut steps = Vec::new();
    for &group in order {
        let there = &candidates.groups.all()[group];
        let built = candidates.built(&standing);
        let free = candidates.free_on(&standing, group);
        let joints = free.iter().filter_map(|free| {
            let direction = upright(free.directions)?;
            Some(Joint { node: free.node, direction, free: free.directions })
        });
        let kind = if there.grounded {
            StepKind::Ground
        } else if there.nodes.iter().all(|&node| built[node]) {
            StepKind::Connect
        } else {
            StepKind::Create
        };
        let joints = joints.collect();
        standing.insert(group);
        // Each of these sets was found to stand on the way down.
        let max_sag_mm = candidates.sag(&standing).map_or(f64::INFINITY, |sag| sag.mm);
        steps.push(Step { struts: there.struts.clone(), kind, joints, max_sag_mm });
    }
    Outcome { steps, strategy: Some(strategy), proved: true, obstacle: None, partial: Partial::default() }
}

/// A node to which the tip does not get, whatever the order.
fn out_of_reach(task: &Task<'_>) -> Option<Obstacle> {
    let nodes = task.structure.nodes();
    let node = nodes.iter().position(|node| !task.builder.reaches(&node.at))?;
    let struts = task.structure.around(node).to_vec();
    Some(Obstacle { step: 0, rule: ObstacleRule::OutOfReach { node }, strut: None, struts })
}

/// The whole frame, where it sags too far: whatever the order, it ends with that.
fn too_soft(candidates: &Candidates<'_>) -> Option<Obstacle> {
    let (node, sag_mm) = match candidates.sag(&GroupSet::all(candidates.groups.all().len())) {
        Ok(sag) if sag.mm <= candidates.max_sag_mm => return None,
        Ok(sag) => (sag.node, Some(sag.mm)),
        Err(unstable) => unsteady(&unstable, candidates.max_sag_mm),
    };
    let struts = candidates.structure.around(node).to_vec();
    let step = candidates.groups.all().len();
    Some(Obstacle { step, rule: ObstacleRule::WholeFrame { node, sag_mm }, strut: None, struts })
}

fn obstacle(candidates: &Candidates<'_>, stuck: &Stuck) -> Obstacle {
    told(candidates, stuck.standing.len(), &stuck.blocked)
}

/// What is to be said about a dead end: the group that fails by the rule which more than order decides, that of sag, else directions.
pub(super) fn told(candidates: &Candidates<'_>, step: usize, blocked: &[(usize, Blocked)]) -> Obstacle {
    let groups = candidates.groups.all();
    let of = |rule: fn(&Blocked) -> bool| blocked.iter().find(|(_, blocked)| rule(blocked));
    let told = of(|blocked| matches!(blocked, Blocked::Sags(_) | Blocked::Unsteady(..)))
        .or_else(|| of(|blocked| matches!(blocked, Blocked::NoDirection(_))))
        .or_else(|| blocked.first());
    let Some((group, blocked)) = told else {
        return Obstacle { step, rule: ObstacleRule::Floating, strut: None, struts: Vec::new() };
    };
    let (rule, struts) = match blocked {
        Blocked::Sags(sag) => (
            ObstacleRule::Sags { node: sag.node, sag_mm: Some(sag.mm) },
            candidates.structure.around(sag.node).to_vec(),
        ),
        Blocked::Unsteady(node, sag_mm) => {
            let rule = ObstacleRule::Sags { node: *node, sag_mm: *sag_mm };
            (rule, candidates.structure.around(*node).to_vec())
        }
        Blocked::NoDirection(by) => (ObstacleRule::NoDirection, by.iter().map(|&(strut, _)| strut).collect()),
        Blocked::Floating | Blocked::GroundFirst => (ObstacleRule::Floating, Vec::new()),
    };
    Obstacle { step, rule, strut: groups[*group].struts.first().copied(), struts }
}
