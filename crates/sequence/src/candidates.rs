//! What can be taken off a standing frame, which is what can be placed last.

use wirebend_collide::DirectionSet;
use wirebend_frame::Unstable;

use super::free_directions::{Free, FreeDirections};
use super::group_set::GroupSet;
use super::groups::Groups;
use super::stability::{Sag, Stability, unsteady};
use super::structure::Structure;

/// Why a group cannot be taken off.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Blocked {
    /// It is on the ground, and others that come after it still stand.
    GroundFirst,
    /// Nothing of it would be built, or something else would hang on nothing.
    Floating,
    /// The head cannot stand: the struts in its way, with how many directions each takes.
    NoDirection(Vec<(usize, usize)>),
    /// What is left would sag too far.
    Sags(Sag),
    /// What is left would not stand at all, at this node; how far that would move, mm, where it is known.
    Unsteady(usize, Option<f64>),
}

/// A structure, how it is grouped, and what decides about each group.
pub(super) struct Candidates<'a> {
    pub structure: &'a Structure,
    pub groups: &'a Groups,
    pub free: FreeDirections<'a>,
    pub stability: &'a Stability,
    pub ground_first: bool,
    pub max_sag_mm: f64,
}

impl Candidates<'_> {
    /// Whether a group can be taken off what stands; it is one of them.
    pub fn try_remove(&self, standing: &GroupSet, group: usize) -> Result<(), Blocked> {
        let mut left = standing.clone();
        left.remove(group);
        let groups = self.groups.all();
        if self.ground_first && groups[group].grounded && left.iter().any(|other| !groups[other].grounded) {
            return Err(Blocked::GroundFirst);
        }
        let built = self.built(&left);
        if !groups[group].nodes.iter().any(|&node| built[node]) || !self.hangs_on_the_ground(&left) {
            return Err(Blocked::Floating);
        }
        if self.free(&left, &built, group).iter().any(|free| free.directions.is_empty()) {
            let stands = |strut: usize| left.contains(self.groups.of_strut(strut));
            let by = self.free.in_the_way(&groups[group], &|node| built[node], &stands);
            return Err(Blocked::NoDirection(by));
        }
        match self.sag(&left) {
            Ok(sag) if sag.mm <= self.max_sag_mm => Ok(()),
            Ok(sag) => Err(Blocked::Sags(sag)),
            Err(unstable) => Err(self.unsteady(&unstable)),
        }
    }

    /// That what is left does not stand.
    pub fn unsteady(&self, unstable: &Unstable) -> Blocked {
        let (node, sag_mm) = unsteady(unstable, self.max_sag_mm);
        Blocked::Unsteady(node, sag_mm)
    }

    /// The sag of what stands.
    pub fn sag(&self, standing: &GroupSet) -> Result<Sag, Unstable> {
        let groups = self.groups.all();
        self.stability.sag(standing.iter().flat_map(|group| groups[group].struts.iter().copied()))
    }

    /// Where the head can stand while a group is placed on what stands already.
    pub fn free_on(&self, standing: &GroupSet, group: usize) -> Vec<Free> {
        self.free(standing, &self.built(standing), group)
    }

    fn free(&self, left: &GroupSet, built: &[bool], group: usize) -> Vec<Free> {
        let stands = |strut: usize| left.contains(self.groups.of_strut(strut));
        self.free.of(&self.groups.all()[group], &|node| built[node], &stands)
    }

    /// Which nodes are built: the ground, and those of what stands.
    pub fn built(&self, standing: &GroupSet) -> Vec<bool> {
        let mut built: Vec<bool> = self.structure.nodes().iter().map(|node| node.support).collect();
        for group in standing.iter() {
            self.groups.all()[group].nodes.iter().for_each(|&node| built[node] = true);
        }
        built
    }

    /// Whether every strut that stands hangs on the ground along others that do.
    fn hangs_on_the_ground(&self, standing: &GroupSet) -> bool {
        let nodes = self.structure.nodes();
        let mut open: Vec<usize> = (0..nodes.len()).filter(|&node| nodes[node].support).collect();
        let mut reached: Vec<bool> = nodes.iter().map(|node| node.support).collect();
        let mut seen = vec![false; self.groups.all().len()];
        let mut count = 0;
        while let Some(node) = open.pop() {
            for &strut in self.structure.around(node) {
                let group = self.groups.of_strut(strut);
                if standing.contains(group) && !std::mem::replace(&mut seen[group], true) {
                    count += 1;
                    for &next in &self.groups.all()[group].nodes {
                        if !std::mem::replace(&mut reached[next], true) {
                            open.push(next);
                        }
                    }
                }
            }
        }
        count == standing.len()
    }
}

/// The direction of a set that is nearest to upwards, which come first in order.
pub(super) fn upright(directions: DirectionSet) -> Option<usize> {
    directions.iter().next()
}
