//! The order by the cost of `FrameFab`: layer by layer, always the cheapest strut next, back from dead ends.
//!
//! As the authors' own code has it (`FFAnalyzer.cpp`), which differs from Eqs. 4 to 7 of the paper: the cost of stability is height
//! times exp of the angle. Only their collisions are not theirs: the head is tested all along its way.

use std::ops::ControlFlow;

use wirebend_frame::ModelError;

use super::candidates::{Blocked, Candidates};
use super::group_set::GroupSet;
use super::outcome::{Obstacle, ObstacleRule, Outcome, Progress, Strategy};
use super::search::{Task, candidates, found, out_of_reach, told, too_soft};
use super::stability::{Stability, unsteady_node};

/// Weights of stability, adjacency and freedom of the rest.
const WEIGHTS: [f64; 3] = [1.0, 1.0, 5.0];
/// How fast the cost of a strut falls with its free share of directions.
const FREEDOM: f64 = 5.0;

/// A set on the way up, and what was tried from there.
#[derive(Default)]
struct Level {
    /// Those that can come next, dearest first.
    open: Vec<usize>,
    /// Those of the same layer that cannot be placed from anywhere.
    shut: Vec<usize>,
    /// Those with which the frame would sag too far.
    sagging: Vec<(usize, Blocked)>,
}

/// Searches as the paper does, each strut alone. `backtracks` bounds how often it goes back from a dead end. Where it comes to none, the
/// obstacle is why nothing could come next where it came farthest; none where it was stopped.
///
/// # Errors
/// A frame that cannot be computed with.
pub fn search_by_paper(
    task: &Task<'_>,
    layers: &[usize],
    backtracks: u64,
    should_continue: &mut dyn FnMut(&Progress) -> ControlFlow<()>,
) -> Result<Outcome, ModelError> {
    if let Some(obstacle) = out_of_reach(task) {
        return Ok(Outcome::impossible(obstacle));
    }
    let stability = Stability::new(task.structure, task.weight)?;
    let candidates = candidates(task, &stability);
    let of = candidates.groups.all().len();
    let mut standing = GroupSet::none(of);
    let mut order: Vec<usize> = Vec::new();
    if let Some(obstacle) = too_soft(&candidates) {
        return Ok(Outcome::impossible(obstacle));
    }
    let mut levels = vec![ranked(&candidates, layers, &standing, None)];
    let mut back = 0;
    let mut farthest: Option<(usize, Vec<(usize, Blocked)>)> = None;
    while let Some(level) = levels.last_mut() {
        if order.len() == of {
            return Ok(found(&candidates, &order, Strategy::PaperCost));
        }
        let progress = Progress { strategy: Strategy::PaperCost, taken: order.len(), of };
        if should_continue(&progress).is_break() {
            return Ok(Outcome::not_found(None));
        }
        if let Some(group) = level.open.pop() {
            standing.insert(group);
            let blocked = match candidates.sag(&standing) {
                Ok(sag) if sag.mm <= candidates.max_sag_mm => {
                    order.push(group);
                    levels.push(ranked(&candidates, layers, &standing, Some(group)));
                    continue;
                }
                Ok(sag) => Blocked::Sags(sag),
                Err(unstable) => Blocked::Unsteady(unsteady_node(&unstable)),
            };
            level.sagging.push((group, blocked));
            standing.remove(group);
            continue;
        }
        let tried = levels.pop().unwrap_or_default();
        if farthest.as_ref().is_none_or(|(built, _)| order.len() > *built) {
            farthest = Some((order.len(), tried.blocked(&candidates, &standing)));
        }
        if back == backtracks {
            break;
        }
        back += 1;
        if let Some(group) = order.pop() {
            standing.remove(group);
        }
    }
    let obstacle = farthest.map(|(built, blocked)| {
        let told = told(&candidates, built + 1, &blocked);
        match told.rule {
            ObstacleRule::Sags { node, sag_mm } => {
                Obstacle { rule: ObstacleRule::SagsWith { node, sag_mm }, ..told }
            }
            _ => told,
        }
    });
    Ok(Outcome::not_found(obstacle))
}

impl Level {
    /// Why none of its groups could come next.
    fn blocked(self, candidates: &Candidates<'_>, standing: &GroupSet) -> Vec<(usize, Blocked)> {
        let built = candidates.built(standing);
        let stands = |strut: usize| standing.contains(candidates.groups.of_strut(strut));
        let shut = self.shut.into_iter().map(|group| {
            let there = &candidates.groups.all()[group];
            if there.nodes.iter().any(|&node| built[node]) {
                let by = candidates.free.in_the_way(there, &|node| built[node], &stands);
                (group, Blocked::NoDirection(by))
            } else {
                (group, Blocked::Floating)
            }
        });
        self.sagging.into_iter().chain(shut).collect()
    }
}

/// The struts that can come next in the lowest layer that is not done, dearest first.
fn ranked(candidates: &Candidates<'_>, layers: &[usize], standing: &GroupSet, last: Option<usize>) -> Level {
    let groups = candidates.groups.all();
    let mut shut = Vec::new();
    let strut = |group: usize| groups[group].struts[0];
    let left = || (0..groups.len()).filter(|&group| !standing.contains(group));
    let ground = left().any(|group| groups[group].grounded);
    let lowest = left().map(|group| layers[strut(group)]).min().unwrap_or(0);
    let mut open: Vec<(f64, usize)> = left()
        .filter(|&group| if ground { groups[group].grounded } else { layers[strut(group)] == lowest })
        .filter_map(|group| {
            let free = candidates.free_on(standing, group);
            if free.is_empty() || free.iter().any(|free| free.directions.is_empty()) {
                shut.push(group);
                return None;
            }
            let cost = if ground {
                middle(candidates, strut(group)).x
            } else {
                cost(candidates, layers, standing, last, group)?
            };
            Some((cost, group))
        })
        .collect();
    open.sort_by(|one, other| other.0.total_cmp(&one.0).then(other.1.cmp(&one.1)));
    Level { open: open.into_iter().map(|(_, group)| group).collect(), shut, sagging: Vec::new() }
}

fn middle(candidates: &Candidates<'_>, strut: usize) -> nalgebra::Point3<f64> {
    let [a, b] = candidates.structure.ends(strut);
    nalgebra::center(a, b)
}

fn cost(
    candidates: &Candidates<'_>,
    layers: &[usize],
    standing: &GroupSet,
    last: Option<usize>,
    group: usize,
) -> Option<f64> {
    let structure = candidates.structure;
    let groups = candidates.groups.all();
    let strut = groups[group].struts[0];
    let stability = {
        let of_layer = (0..layers.len()).filter(|&other| layers[other] == layers[strut]);
        let z = of_layer.map(|other| middle(candidates, other).z);
        let [low, high] =
            z.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], z| [low.min(z), high.max(z)]);
        let height = (middle(candidates, strut).z - low) / (high - low).max(f64::MIN_POSITIVE);
        let built = candidates.built(standing);
        let [a, b] = structure.struts()[strut].ends;
        match [built[a], built[b]] {
            [true, true] => height,
            [false, false] => return None,
            [from_a, _] => {
                let way = structure.nodes()[b].at - structure.nodes()[a].at;
                let way = if from_a { way } else { -way };
                height * (way.z / way.norm()).acos().exp()
            }
        }
    };
    let adjacency = match last {
        Some(last) if !structure.share_a_node(strut, groups[last].struts[0]) => 1.0,
        _ => 0.0,
    };
    let freedom = freedom_of_the_rest(candidates, standing, group);
    Some(WEIGHTS[0] * stability + WEIGHTS[1] * adjacency + WEIGHTS[2] * freedom)
}

/// How much a strut takes from those that are still to come.
#[allow(clippy::cast_precision_loss)] // thousands
fn freedom_of_the_rest(candidates: &Candidates<'_>, standing: &GroupSet, group: usize) -> f64 {
    let groups = candidates.groups.all();
    let left: Vec<usize> = (0..groups.len()).filter(|&other| !standing.contains(other)).collect();
    let stands = |strut: usize| {
        let of = candidates.groups.of_strut(strut);
        of == group || standing.contains(of)
    };
    let rest = left.iter().filter(|&&other| other != group);
    let sum: f64 = rest
        .map(|&other| {
            let share = candidates.free.share_among(groups[other].struts[0], &stands);
            (-FREEDOM * share * share).exp()
        })
        .sum();
    sum / left.len() as f64
}
