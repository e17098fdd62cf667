//! A design as the beams of a frame.

use std::collections::BTreeMap;

use wirebend_core::wireframe::{EdgeId, VertexId};
use wirebend_frame::{Assembly, Member, MemberId, Model, ModelError, NodeId, Support};

use super::FrameFigures;
use super::material::FrameMaterial;
use super::notes::{about_edges, doubled_struts, unused_supports};
use super::supports::FrameSupports;
use crate::PlanningError;
use crate::design::Opened;
use crate::report::NoteReport;

/// A frame whose nodes are the vertices of a design and whose members are its edges, both in order of id.
pub(super) struct Structure {
    pub assembly: Assembly,
    pub vertices: Vec<VertexId>,
    pub edges: Vec<EdgeId>,
    /// Whether something holds it.
    pub held: bool,
    /// What joins struts at vertices, and what it weighs, g.
    pub joints: Vec<(NodeId, f64)>,
}

impl Structure {
    pub fn new(
        opened: &Opened,
        material: &FrameMaterial,
        supports: &FrameSupports,
        notes: &mut Vec<NoteReport>,
    ) -> Result<Self, PlanningError> {
        let wireframe = &opened.document.wireframe;
        let vertices: Vec<VertexId> = wireframe.vertices().map(|(id, _)| id).collect();
        let node: BTreeMap<VertexId, NodeId> =
            vertices.iter().enumerate().map(|(k, &id)| (id, NodeId(k))).collect();
        let members = wireframe.edges().filter_map(|(id, edge)| {
            Some((id, Member::new(*node.get(&edge.a)?, *node.get(&edge.b)?, material.section_of(id))))
        });
        let (edges, members): (Vec<EdgeId>, Vec<Member>) = members.unzip();
        let held = supports.vertices(opened)?;
        notes.extend(unused_supports(wireframe, &held));
        notes.extend(doubled_struts(wireframe));
        let bears = |vertex: &VertexId| !wireframe.incident(*vertex).is_empty();
        let bearing: Vec<VertexId> = held.into_iter().filter(bears).collect();
        let model = Model {
            nodes: wireframe.vertices().map(|(_, vertex)| vertex.position).collect(),
            members,
            sections: material.sections.clone(),
            supports: bearing
                .iter()
                .filter_map(|id| Some(support(opened, supports, *id, *node.get(id)?)))
                .collect(),
        };
        let assembly = Assembly::new(&model).map_err(|error| no_frame(opened, &edges, &vertices, &error))?;
        let joints = wireframe.vertices().filter_map(|(id, vertex)| {
            let bears = !wireframe.incident(id).is_empty();
            Some((*node.get(&id)?, vertex.joint.filter(|_| bears)?.mass_g))
        });
        let joints = joints.collect();
        Ok(Self { assembly, held: !bearing.is_empty(), joints, vertices, edges })
    }

    /// The node of a vertex.
    pub fn node(&self, id: VertexId) -> Option<NodeId> {
        self.vertices.binary_search(&id).ok().map(NodeId)
    }

    /// How many struts have a section that is no solid round.
    pub fn of_other_sections(&self, material: &FrameMaterial) -> usize {
        let members = self.assembly.model().members.iter();
        members.filter(|member| !material.knows_stress(member.section)).count()
    }

    /// Struts whose section is no solid round have no stress, and so no yield check, which is worth knowing of.
    pub fn without_stress(&self, material: &FrameMaterial) -> Option<NoteReport> {
        about_edges("stress-unknown", self.of_other_sections(material), |of| {
            format!(
                "the section of {of} is no solid round: stresses are not known, and whether it yields is not checked"
            )
        })
    }

    pub fn figures(&self) -> FrameFigures {
        let model = self.assembly.model();
        let ends = model.members.iter().flat_map(|member| [member.a, member.b]);
        let mut nodes: Vec<NodeId> = ends.collect();
        nodes.sort_unstable();
        nodes.dedup();
        let length_mm = (0..model.members.len()).map(|k| self.assembly.length(MemberId(k))).sum();
        FrameFigures {
            nodes: nodes.len(),
            members: model.members.len(),
            supports: model.supports.len(),
            length_mm,
            // Tonnes are 1e6 g.
            mass_g: self.assembly.mass(&self.assembly.all()) * 1.0e6,
        }
    }
}

/// How a vertex is held: as the design says, or altogether where it was chosen.
fn support(opened: &Opened, supports: &FrameSupports, id: VertexId, node: NodeId) -> Support {
    let drawn = opened.document.wireframe.vertex(id).filter(|_| *supports == FrameSupports::Design);
    Support { node, fixed: drawn.map_or([true; 6], |vertex| vertex.fixed()) }
}

/// Why the edges of a design are no beams.
fn no_frame(opened: &Opened, edges: &[EdgeId], vertices: &[VertexId], error: &ModelError) -> PlanningError {
    let name = opened.name.clone();
    match error {
        ModelError::NoLength { member, a, b } => PlanningError::StrutWithoutLength {
            name,
            edge: edges.get(member.0).map_or(0, |id| id.0),
            ends: [a, b].map(|node| vertices.get(node.0).map_or(0, |id| id.0)),
        },
        error => PlanningError::NoFrame { name, reason: error.to_string() },
    }
}
