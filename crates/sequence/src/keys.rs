//! In which order groups are tried: the higher the key, the sooner one is taken off, and the later it is built.

use std::ops::ControlFlow;

use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use wirebend_frame::MemberId;

use super::candidates::{Blocked, Candidates};
use super::descent::Stuck;
use super::group_set::GroupSet;

/// By how much a key is raised for what was in the way, as a share of the whole range.
const RAISE: f64 = 0.25;
/// By how much chance moves a key at most when a search begins anew.
const JITTER: f64 = 0.02;

/// How far each group is from the ground along struts, from 0 to 1.
#[allow(clippy::cast_precision_loss)] // a handful of nodes
pub(super) fn from_ground(candidates: &Candidates<'_>) -> Vec<f64> {
    let far = candidates.structure.distances_from_ground();
    let mean = |nodes: &[usize]| nodes.iter().map(|&node| far[node]).sum::<f64>() / nodes.len() as f64;
    let keys: Vec<f64> = candidates.groups.all().iter().map(|group| mean(&group.nodes)).collect();
    let most = keys.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
    keys.into_iter().map(|key| key / most).collect()
}

/// The frame built up by stiffness alone: always the group that keeps the largest sag least. `None` where it was stopped.
pub(super) fn stiffness_plan(
    candidates: &Candidates<'_>,
    step: &mut dyn FnMut(usize) -> ControlFlow<()>,
) -> Option<Vec<usize>> {
    let groups = candidates.groups.all();
    let mut flexibility = candidates.stability.flexibility();
    let mut left: Vec<usize> = (0..groups.len()).collect();
    let mut built: Vec<bool> = candidates.structure.nodes().iter().map(|node| node.support).collect();
    let mut order = Vec::new();
    let mut standing = GroupSet::none(groups.len());
    while !left.is_empty() {
        if step(order.len()).is_break() {
            return None;
        }
        let ground = candidates.ground_first && left.iter().any(|&group| groups[group].grounded);
        let open = left.iter().enumerate().filter(|&(_, &group)| {
            groups[group].nodes.iter().any(|&node| built[node]) && (!ground || groups[group].grounded)
        });
        let sags = open.map(|(place, &group)| {
            let sag = if let [strut] = groups[group].struts[..] {
                flexibility.try_add(MemberId(strut)).map(|sag| sag.max_displacement)
            } else {
                let mut with = standing.clone();
                with.insert(group);
                candidates.sag(&with).map(|sag| sag.mm)
            };
            (place, sag.unwrap_or(f64::INFINITY))
        });
        let (place, _) = sags.min_by(|one, other| one.1.total_cmp(&other.1))?;
        let group = left.remove(place);
        add(candidates, &mut flexibility, group);
        for &node in &groups[group].nodes {
            built[node] = true;
        }
        standing.insert(group);
        order.push(group);
    }
    Some(order)
}

/// Adds the struts of a group, each where one of its ends stands.
fn add(candidates: &Candidates<'_>, flexibility: &mut wirebend_frame::Flexibility<'_>, group: usize) {
    let mut left = candidates.groups.all()[group].struts.clone();
    while let Some(place) = left.iter().position(|&strut| flexibility.add(MemberId(strut)).is_ok()) {
        left.remove(place);
    }
}

/// Keys from an order in which groups are built.
#[allow(clippy::cast_precision_loss)] // thousands
pub(super) fn of_order(order: &[usize]) -> Vec<f64> {
    let mut keys = vec![0.0; order.len()];
    for (step, &group) in order.iter().enumerate() {
        keys[group] = (step + 1) as f64 / order.len() as f64;
    }
    keys
}

/// Raises the keys of what kept a search from going on: the struts at nodes that sag, and those in a head's way.
#[allow(clippy::cast_precision_loss)] // a direction is one of less than two hundred
pub(super) fn raise(keys: &mut [f64], candidates: &Candidates<'_>, stuck: &Stuck) {
    let mut blame = vec![0.0_f64; keys.len()];
    for (_, blocked) in &stuck.blocked {
        match blocked {
            Blocked::Sags(sag) => sagging(&mut blame, candidates, &stuck.standing, sag.node),
            Blocked::Unsteady(node, _) => sagging(&mut blame, candidates, &stuck.standing, *node),
            Blocked::NoDirection(by) => {
                let most = by.iter().map(|&(_, directions)| directions).max().unwrap_or(1) as f64;
                for &(strut, directions) in by {
                    blame[candidates.groups.of_strut(strut)] += directions as f64 / most;
                }
            }
            Blocked::GroundFirst | Blocked::Floating => {}
        }
    }
    let most = blame.iter().copied().fold(0.0, f64::max);
    if most > 0.0 {
        keys.iter_mut().zip(&blame).for_each(|(key, blame)| *key += RAISE * blame / most);
    }
}

fn sagging(blame: &mut [f64], candidates: &Candidates<'_>, standing: &GroupSet, node: usize) {
    for &strut in candidates.structure.around(node) {
        let group = candidates.groups.of_strut(strut);
        if standing.contains(group) {
            blame[group] += 1.0;
        }
    }
}

/// Moves each key a little, as a seed says, so that the next search does not end where the last one did.
pub(super) fn jitter(keys: &mut [f64], seed: u64, round: u32) {
    let mut chance = ChaCha8Rng::seed_from_u64(seed);
    chance.set_stream(u64::from(round));
    for key in keys {
        *key += chance.random_range(0.0..JITTER);
    }
}
