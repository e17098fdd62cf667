//! What a frame does under a load.

use nalgebra::Vector3;

use crate::assembly::Assembly;
use crate::element::Vector12;
use crate::equations::NONE;
use crate::loads::{self, Acting};
use crate::member_set::MemberSet;
use crate::model::{MemberId, NodeId};
use crate::section::Section;
use crate::stress::{SectionForces, Stress};

/// What a support does to the frame, in the model's axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reaction {
    /// The node that is held.
    pub node: NodeId,
    /// N.
    pub force: Vector3<f64>,
    /// N mm.
    pub moment: Vector3<f64>,
}

/// What the joints do to the ends of a member.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MemberForces {
    /// Which member.
    pub member: MemberId,
    /// mm.
    pub length: f64,
    /// Force and moment at `a`, then at `b`, in its local axes, N and N mm.
    pub local: [f64; 12],
    /// What acts along it, its weight too, in its local axes, N/mm.
    pub line: [f64; 3],
}

/// What a frame does under a load.
#[derive(Debug, Clone, PartialEq)]
pub struct Response {
    /// Of each node of the model, in its axes, mm and radian; zero where no member is.
    pub displacements: Vec<[f64; 6]>,
    /// At each support that a member reaches.
    pub reactions: Vec<Reaction>,
    /// Of each member that is there, in order.
    pub member_forces: Vec<MemberForces>,
    /// How far the forces of the members are from balancing the load at a node, as a share of the largest of them.
    pub residual: f64,
    /// What the loads have done on their way: half the sum of force by displacement, N mm.
    pub work: f64,
}

impl Response {
    /// The node that moves farthest, and how far, mm. Ties go to the first.
    #[must_use]
    pub fn max_displacement(&self) -> (NodeId, f64) {
        let mut most = (NodeId(0), 0.0);
        for (k, u) in self.displacements.iter().enumerate() {
            let moved = Vector3::new(u[0], u[1], u[2]).norm();
            if moved > most.1 {
                most = (NodeId(k), moved);
            }
        }
        most
    }

    /// The forces of one member; `None` when it is not there.
    #[must_use]
    pub fn forces(&self, member: MemberId) -> Option<&MemberForces> {
        let place = self.member_forces.binary_search_by_key(&member, |forces| forces.member).ok()?;
        self.member_forces.get(place)
    }
}

impl MemberForces {
    /// The tension in its middle, N; negative is compression.
    #[must_use]
    pub fn axial(&self) -> f64 {
        (self.local[6] - self.local[0]) / 2.0
    }

    /// The forces in a cut at a share of its length, from 0 at `a` to 1 at `b`.
    #[must_use]
    pub fn at(&self, share: f64) -> SectionForces {
        let s = share * self.length;
        let [fx, fy, fz, mx, my, mz, ..] = self.local;
        let [qx, qy, qz] = self.line;
        SectionForces {
            axial: -fx - qx * s,
            shear_y: -fy - qy * s,
            shear_z: -fz - qz * s,
            torque: -mx,
            moment_y: -my - fz * s - qz * s * s / 2.0,
            moment_z: -mz + fy * s + qy * s * s / 2.0,
        }
    }

    /// The stresses at `a` and at `b`.
    #[must_use]
    pub fn end_stresses(&self, section: &Section) -> [Stress; 2] {
        [self.at(0.0).stress(section), self.at(1.0).stress(section)]
    }

    /// The largest bending moment along it, N mm: at its ends, at its quarters, and where the load along it makes it largest between
    /// them. Exact where ends and load bend it in one plane.
    #[must_use]
    pub fn peak_moment(&self) -> f64 {
        let places = [0.0, 0.25, 0.5, 0.75, 1.0, self.turning(1), self.turning(2)];
        places.into_iter().map(|share| self.at(share).moment()).fold(0.0, f64::max)
    }

    /// The largest von Mises stress along it, MPa: at its ends, and where a moment is largest between them.
    #[must_use]
    pub fn peak_von_mises(&self, section: &Section) -> f64 {
        let mut peak = 0.0_f64;
        for share in [0.0, 1.0, self.turning(1), self.turning(2)] {
            peak = peak.max(self.at(share).stress(section).von_mises);
        }
        peak
    }

    /// The share of the length at which the shear along an axis is zero and the moment that it makes largest; 0 if none.
    fn turning(&self, axis: usize) -> f64 {
        let share = -self.local[axis] / (self.line[axis] * self.length);
        if share > 0.0 && share < 1.0 { share } else { 0.0 }
    }

    /// The peak stress as a share of what the material yields at.
    #[must_use]
    pub fn utilisation(&self, section: &Section) -> f64 {
        self.peak_von_mises(section) / section.yield_strength
    }

    /// The largest compression as a share of the Euler load of the member with pinned ends, `-N L² / (π² E I)`; below zero under
    /// tension. From about one half on, a linear answer no longer holds.
    #[must_use]
    pub fn buckling_ratio(&self, section: &Section) -> f64 {
        let compression = -self.at(0.0).axial.min(self.at(1.0).axial);
        let euler = std::f64::consts::PI.powi(2) * section.e * section.iy.min(section.iz);
        compression * self.length * self.length / euler
    }
}

/// What there is to tell of displacements: forces of members and supports, and how well all balances.
pub(crate) fn of(
    assembly: &Assembly,
    members: &MemberSet,
    acting: &Acting,
    forces: &[[f64; 6]],
    displacements: Vec<[f64; 6]>,
) -> Response {
    // What members do to nodes, and what acts there from outside.
    let mut at_nodes = vec![[0.0; 6]; displacements.len()];
    let mut member_forces = Vec::with_capacity(members.len());
    for member in members.iter() {
        let element = &assembly.elements[member.0];
        let line = acting.line[member.0];
        let ends = assembly.ends(member, &displacements) + acting.misfit(member);
        let by_joints = element.forces(&ends) - element.spread(&line);
        loads::add(assembly, &mut at_nodes, member, &by_joints);
        let local = local(&element.axes, &by_joints);
        let line = (element.axes * line).into();
        member_forces.push(MemberForces { member, length: element.length, local, line });
    }
    let work =
        forces.iter().flatten().zip(displacements.iter().flatten()).map(|(f, u)| f * u).sum::<f64>() / 2.0;
    for (sum, outside) in at_nodes.iter_mut().flatten().zip(acting.nodal.iter().flatten()) {
        *sum -= outside;
    }
    let residual = residual(assembly, acting, &at_nodes, &member_forces);
    Response {
        reactions: reactions(assembly, members, &at_nodes),
        displacements,
        member_forces,
        residual,
        work,
    }
}

fn local(axes: &nalgebra::Matrix3<f64>, ends: &Vector12) -> [f64; 12] {
    let mut local = [0.0; 12];
    for (k, turned) in local.chunks_mut(3).enumerate() {
        turned.copy_from_slice((axes * ends.fixed_rows::<3>(3 * k)).as_slice());
    }
    local
}

/// What is left over at nodes that are free, against the largest force there is. Moments count by the mean length.
fn residual(assembly: &Assembly, acting: &Acting, rest: &[[f64; 6]], forces: &[MemberForces]) -> f64 {
    let unit = |axis: usize| if axis % 6 < 3 { 1.0 } else { assembly.rotation_unit };
    let size = |values: &[f64]| {
        values.iter().enumerate().map(|(axis, value)| value.abs() / unit(axis)).fold(0.0, f64::max)
    };
    let most = forces.iter().map(|forces| size(&forces.local)).fold(0.0, f64::max);
    let most = acting.nodal.iter().map(|nodal| size(nodal)).fold(most, f64::max);
    let mut left = 0.0_f64;
    for (rest, equations) in rest.iter().zip(&assembly.equations.of_node) {
        for axis in (0..6).filter(|&axis| equations[axis] != NONE) {
            left = left.max(rest[axis].abs() / unit(axis));
        }
    }
    if most > 0.0 { left / most } else { 0.0 }
}

fn reactions(assembly: &Assembly, members: &MemberSet, at_nodes: &[[f64; 6]]) -> Vec<Reaction> {
    let touched = assembly.touched(members);
    let held = assembly.equations.of_node.iter().zip(at_nodes).enumerate();
    let held = held.filter(|(node, (equations, _))| touched[*node] && equations.contains(&NONE));
    let reaction = held.map(|(node, (equations, sum))| {
        let at = |axis: usize| if equations[axis] == NONE { sum[axis] } else { 0.0 };
        Reaction {
            node: NodeId(node),
            force: Vector3::new(at(0), at(1), at(2)),
            moment: Vector3::new(at(3), at(4), at(5)),
        }
    });
    reaction.collect()
}
