//! What a load does to each member and node of those that are there.

use nalgebra::Vector3;

use crate::assembly::Assembly;
use crate::element::Vector12;
use crate::error::LoadError;
use crate::load::{EndMotion, Load, Misfit};
use crate::member_set::MemberSet;
use crate::model::MemberId;

/// A load, sorted by members and nodes.
pub(crate) struct Acting {
    /// Of each node of the model.
    pub nodal: Vec<[f64; 6]>,
    /// Of each member of the model, what acts along it, its weight too, N/mm.
    pub line: Vec<Vector3<f64>>,
    /// Of members that do not fit, how their ends are moved, by rising member.
    pub misfits: Vec<(MemberId, Vector12)>,
}

impl Acting {
    pub fn new(assembly: &Assembly, members: &MemberSet, load: &Load) -> Result<Self, LoadError> {
        let model = assembly.model();
        let mut acting = Self {
            nodal: vec![[0.0; 6]; model.nodes.len()],
            line: vec![Vector3::zeros(); model.members.len()],
            misfits: Vec::new(),
        };
        let touched = assembly.touched(members);
        for nodal in &load.nodal {
            if !touched.get(nodal.node.0).copied().unwrap_or(false) {
                return Err(LoadError::AbsentNode { node: nodal.node });
            }
            let sum = &mut acting.nodal[nodal.node.0];
            for (sum, value) in sum.iter_mut().zip(nodal.force.iter().chain(nodal.moment.iter())) {
                *sum += value;
            }
        }
        for mass in load.masses.iter().filter(|mass| touched.get(mass.node.0) == Some(&true)) {
            let weight = load.gravity * mass.mass;
            acting.nodal[mass.node.0].iter_mut().zip(weight.iter()).for_each(|(sum, value)| *sum += value);
        }
        for member in members.iter() {
            acting.line[member.0] = load.gravity * assembly.weight(member);
        }
        for line in &load.line {
            present(members, line.member)?;
            acting.line[line.member.0] += line.force;
        }
        for misfit in &load.misfits {
            present(members, misfit.member)?;
            acting.misfits.push((misfit.member, ends(assembly, misfit)));
        }
        for EndMotion { member, ends } in &load.end_motions {
            present(members, *member)?;
            acting.misfits.push((*member, Vector12::from(*ends)));
        }
        acting.misfits.sort_by_key(|&(member, _)| member);
        acting.misfits.dedup_by(|next, sum| {
            let same = next.0 == sum.0;
            if same {
                sum.1 += next.1;
            }
            same
        });
        acting.is_finite().then_some(acting).ok_or(LoadError::NotFinite)
    }

    fn is_finite(&self) -> bool {
        self.nodal.iter().flatten().all(|value| value.is_finite())
            && self.line.iter().flat_map(Vector3::iter).all(|value| value.is_finite())
            && self.misfits.iter().flat_map(|(_, ends)| ends.iter()).all(|value| value.is_finite())
    }

    /// How the ends of a member are moved beside their nodes.
    pub fn misfit(&self, member: MemberId) -> Vector12 {
        self.misfits
            .binary_search_by_key(&member, |&(member, _)| member)
            .map_or_else(|_| Vector12::zeros(), |found| self.misfits[found].1)
    }

    /// The forces and moments at nodes that stand for all of it.
    pub fn nodal_forces(&self, assembly: &Assembly, members: &MemberSet) -> Vec<[f64; 6]> {
        let mut forces = self.nodal.clone();
        for member in members.iter() {
            let line = self.line[member.0];
            if line != Vector3::zeros() {
                add(assembly, &mut forces, member, &assembly.elements[member.0].spread(&line));
            }
        }
        for (member, ends) in &self.misfits {
            add(assembly, &mut forces, *member, &-assembly.elements[member.0].forces(ends));
        }
        forces
    }
}

impl Assembly {
    /// The forces and moments at nodes that stand for a load on some of the members: those at nodes, those that stand for what
    /// acts along members, and `-K_e q0` of members that do not fit.
    ///
    /// # Errors
    /// A load on a member or node that is not there.
    pub fn nodal_forces(&self, members: &MemberSet, load: &Load) -> Result<Vec<[f64; 6]>, LoadError> {
        Ok(Acting::new(self, members, load)?.nodal_forces(self, members))
    }
}

fn present(members: &MemberSet, member: MemberId) -> Result<(), LoadError> {
    members.contains(member).then_some(()).ok_or(LoadError::AbsentMember { member })
}

fn ends(assembly: &Assembly, misfit: &Misfit) -> Vector12 {
    let shorter = assembly.elements[misfit.member.0].x() * -misfit.extra_length;
    let mut ends = Vector12::zeros();
    ends.fixed_rows_mut::<3>(3).copy_from(&misfit.rotation_a);
    ends.fixed_rows_mut::<3>(6).copy_from(&shorter);
    ends.fixed_rows_mut::<3>(9).copy_from(&misfit.rotation_b);
    ends
}

/// Adds forces at the ends of a member to those of its nodes.
pub(crate) fn add(assembly: &Assembly, forces: &mut [[f64; 6]], member: MemberId, ends: &Vector12) {
    let member = &assembly.model().members[member.0];
    for (node, part) in [(member.a, 0), (member.b, 6)] {
        for (sum, value) in forces[node.0].iter_mut().zip(&ends.as_slice()[part..part + 6]) {
            *sum += value;
        }
    }
}
