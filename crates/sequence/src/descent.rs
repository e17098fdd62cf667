//! Taking a finished frame apart, one group after the other; the reverse of it builds the frame.
//!
//! What stands later is less, and less is in the way of a head: of collisions alone no order gets stuck. Where the rest would sag,
//! and no other order of what is left helps, the set is dead, and is not entered again.

use std::collections::HashSet;
use std::ops::ControlFlow;

use super::candidates::{Blocked, Candidates};
use super::group_set::GroupSet;

/// Among keys that are no lower than the highest by more than this, one that shares a node with the last is preferred.
const BAND: f64 = 0.1;

/// Where a search cannot go on.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Stuck {
    /// What stands there.
    pub standing: GroupSet,
    /// Why nothing of it can be taken off, or nothing be placed on it.
    pub blocked: Vec<(usize, Blocked)>,
    /// What was taken off or placed, the first foremost.
    pub order: Vec<usize>,
}

/// What came of it.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Descent {
    /// All groups in the order in which they are taken off.
    Done(Vec<usize>),
    /// It went back as often as allowed; where it came farthest.
    Stuck(Stuck),
    /// Every order was tried.
    Impossible(Stuck),
    /// It was stopped: where it had come farthest, and what was off just then.
    Stopped(Option<Stuck>, Vec<usize>),
}

/// A set on the way down, and what was tried from there.
struct Level {
    untried: GroupSet,
    taken: Option<usize>,
    blocked: Vec<(usize, Blocked)>,
}

/// Takes all off, highest keys first; goes back up to `backtracks` times. `step` is told how many are off before each trial.
pub(super) fn take_apart(
    candidates: &Candidates<'_>,
    keys: &[f64],
    backtracks: u64,
    dead: &mut HashSet<GroupSet>,
    step: &mut dyn FnMut(usize) -> ControlFlow<()>,
) -> Descent {
    let all = candidates.groups.all().len();
    let mut standing = GroupSet::all(all);
    let mut order: Vec<usize> = Vec::new();
    let mut levels = vec![Level::at(&standing)];
    let mut farthest: Option<Stuck> = None;
    let mut back = 0;
    while let Some(level) = levels.last_mut() {
        // The ground holds nothing any more when the last one is off.
        if standing.len() == 0 {
            return Descent::Done(order);
        }
        let Some(group) = level.next(candidates, keys, order.last().copied()) else {
            if farthest.as_ref().is_none_or(|stuck| standing.len() < stuck.standing.len()) {
                let blocked = std::mem::take(&mut level.blocked);
                farthest = Some(Stuck { standing: standing.clone(), blocked, order: order.clone() });
            }
            dead.insert(standing.clone());
            levels.pop();
            let Some(above) = levels.last_mut() else { break };
            if back == backtracks {
                return farthest.map_or(Descent::Stopped(None, order), Descent::Stuck);
            }
            back += 1;
            order.pop();
            if let Some(taken) = above.taken.take() {
                standing.insert(taken);
            }
            continue;
        };
        if step(order.len()).is_break() {
            return Descent::Stopped(farthest, order);
        }
        match candidates.try_remove(&standing, group) {
            Ok(()) => {
                standing.remove(group);
                if dead.contains(&standing) {
                    standing.insert(group);
                    continue;
                }
                level.taken = Some(group);
                order.push(group);
                levels.push(Level::at(&standing));
            }
            Err(blocked) => level.blocked.push((group, blocked)),
        }
    }
    farthest.map_or(Descent::Stopped(None, order), Descent::Impossible)
}

impl Level {
    fn at(standing: &GroupSet) -> Self {
        Self { untried: standing.clone(), taken: None, blocked: Vec::new() }
    }

    /// The group to try next: of those with about the highest key one beside the last, else the highest.
    fn next(&mut self, candidates: &Candidates<'_>, keys: &[f64], last: Option<usize>) -> Option<usize> {
        let highest = self.untried.iter().map(|group| keys[group]).fold(f64::NEG_INFINITY, f64::max);
        let groups = candidates.groups.all();
        let beside = |group: usize| {
            last.is_some_and(|last| {
                keys[group] >= highest - BAND
                    && groups[last].nodes.iter().any(|node| groups[group].nodes.contains(node))
            })
        };
        // The first of equals.
        let best = self.untried.iter().map(|group| (beside(group), group)).reduce(|best, next| {
            let higher = next.0.cmp(&best.0).then(keys[next.1].total_cmp(&keys[best.1])).is_gt();
            if higher { next } else { best }
        });
        let (_, group) = best?;
        self.untried.remove(group);
        Some(group)
    }
}
