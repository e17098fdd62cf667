//! What a frame does under its own weight and other loads.

use wirebend_core::checks::Diagnostic;
use wirebend_frame::{Load, MemberForces, Response, SolveError};

use super::findings;
use super::loads::elsewhere;
use super::material::{FrameMaterial, UNKNOWN_YIELD};
use super::report::{MemberReport, ReactionReport, StaticReport};
use super::structure::Structure;
use super::supports::FrameSupports;
use crate::PlanningError;
use crate::design::Opened;

impl Structure {
    /// The frame under what acts on it; `None`, with what is wrong, where it does not stand.
    pub fn statics(
        &self,
        opened: &Opened,
        material: &FrameMaterial,
        supports: &FrameSupports,
        load: &Load,
        found: &mut Vec<Diagnostic>,
    ) -> Result<Option<(StaticReport, Response)>, PlanningError> {
        if self.edges.is_empty() || *supports == FrameSupports::Free {
            return Ok(None);
        }
        match self.solve(load) {
            Ok(response) => {
                let report = self.report(&response, material);
                found.extend(findings::strong_enough(self, material, &report));
                Ok(Some((report, response)))
            }
            Err(SolveError::Unstable(unstable)) => {
                found.push(findings::unstable(self, &unstable));
                Ok(None)
            }
            Err(SolveError::Load(error)) => Err(elsewhere(opened, self, &error)),
        }
    }

    fn solve(&self, load: &Load) -> Result<Response, SolveError> {
        self.assembly.factor(&self.assembly.all())?.solve(load)
    }

    fn report(&self, response: &Response, material: &FrameMaterial) -> StaticReport {
        let (node, max_displacement_mm) = response.max_displacement();
        let vertex = |node: wirebend_frame::NodeId| self.vertices.get(node.0).map_or(0, |id| id.0);
        let reactions = response.reactions.iter().map(|reaction| ReactionReport {
            vertex: vertex(reaction.node),
            force_n: reaction.force.into(),
            moment_n_mm: reaction.moment.into(),
        });
        let members = response.member_forces.iter().map(|forces| self.member(forces, material));
        StaticReport {
            max_displacement_mm,
            at_vertex: vertex(node),
            work_n_mm: response.work,
            reactions: reactions.collect(),
            members: members.collect(),
            residual: response.residual,
        }
    }

    fn member(&self, forces: &MemberForces, material: &FrameMaterial) -> MemberReport {
        let section = self.assembly.section(forces.member);
        let stressed = material.knows_stress(self.assembly.model().members[forces.member.0].section);
        let yields = stressed && section.yield_strength < UNKNOWN_YIELD;
        MemberReport {
            edge: self.edges.get(forces.member.0).map_or(0, |id| id.0),
            axial_n: forces.axial(),
            moment_n_mm: forces.peak_moment(),
            torque_n_mm: forces.at(0.0).torque,
            von_mises_mpa: stressed.then(|| forces.peak_von_mises(section)),
            utilisation: yields.then(|| forces.utilisation(section)),
            buckling_ratio: forces.buckling_ratio(section),
        }
    }
}
