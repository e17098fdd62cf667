//! Whether a mode is that of a single strut.

use std::collections::BTreeMap;

use super::ModeKind;
use crate::assembly::Assembly;
use crate::member_set::MemberSet;
use crate::model::{MemberId, Model};

/// Which nodes lie between the ends of a strut.
pub(super) struct Interiors {
    /// Of each member.
    strut_of: Vec<usize>,
    /// Of each node, whether it has but one strut.
    inside: Vec<bool>,
    struts: usize,
}

impl Interiors {
    /// `struts` as [`ModeSearch::struts`](super::ModeSearch::struts).
    pub fn new(assembly: &Assembly, members: &MemberSet, struts: &[usize]) -> Self {
        let model = assembly.model();
        let strut_of: Vec<usize> =
            if struts.is_empty() { (0..model.members.len()).collect() } else { struts.to_vec() };
        let mut pieces = vec![0; model.nodes.len()];
        let mut strut_at = vec![None; model.nodes.len()];
        let mut inside = vec![true; model.nodes.len()];
        for member in members.iter() {
            let strut = strut_of[member.0];
            for node in ends(model, member) {
                pieces[node] += 1;
                inside[node] &= *strut_at[node].get_or_insert(strut) == strut;
            }
        }
        // A node with one piece is an end of the strut.
        inside.iter_mut().zip(pieces).for_each(|(inside, pieces)| *inside &= pieces > 1);
        let mut different: Vec<usize> = members.iter().map(|member| strut_of[member.0]).collect();
        different.sort_unstable();
        different.dedup();
        Self { strut_of, inside, struts: different.len() }
    }

    /// What a mode of modal mass 1 is. A frame of a single strut has no local modes.
    pub fn kind(&self, assembly: &Assembly, members: &MemberSet, shape: &[[f64; 6]]) -> ModeKind {
        if self.struts < 2 {
            return ModeKind::Global;
        }
        let mut energies = BTreeMap::<usize, f64>::new();
        for member in members.iter() {
            let mut moved = assembly.ends(member, shape);
            for (end, node) in ends(assembly.model(), member).into_iter().enumerate() {
                if !self.inside[node] {
                    moved.fixed_rows_mut::<6>(6 * end).fill(0.0);
                }
            }
            let mass = assembly.elements[member.0].mass(assembly.section(member), 1.0);
            *energies.entry(self.strut_of[member.0]).or_default() += moved.dot(&(mass * moved));
        }
        let most = energies.into_iter().max_by(|one, other| one.1.total_cmp(&other.1));
        most.filter(|&(_, energy)| energy > 0.5)
            .map_or(ModeKind::Global, |(strut, _)| ModeKind::Local { strut })
    }
}

fn ends(model: &Model, member: MemberId) -> [usize; 2] {
    let member = &model.members[member.0];
    [member.a.0, member.b.0]
}
