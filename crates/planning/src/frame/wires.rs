//! The wires that a design is planned as, ready to be closed.

use wirebend_accuracy::{ClosingModel, FrameWire, Surface};
use wirebend_core::bend::NominalProgram;
use wirebend_core::simulate::scheduled_start;
use wirebend_core::units::Length;
use wirebend_core::wireframe::VertexId;
use wirebend_files::write::frame::ClosedStrut;

use super::faces::{FacesChoice, faces, surface};
use super::material::FrameMaterial;
use crate::choices::PlanChoices;
use crate::design::Opened;
use crate::plan::Planned;
use crate::report::NoteReport;
use crate::stage::StageName;
use crate::{Installation, PlanningError, Progress};

/// The wires of a design, ready to be closed.
pub(super) struct Wires {
    /// What they are of: the wire in the machine, also where the file of the frame says what its struts are.
    pub material: FrameMaterial,
    pub model: ClosingModel,
    /// What is measured: the faces, or all vertices at which struts end.
    pub surface: Surface,
    /// All vertices at which struts end.
    pub whole: Surface,
    /// The struts of all wires in the order of the model; nothing is known of their forces.
    pub struts: Vec<ClosedStrut>,
    /// Of all wires.
    pub length: Length,
    /// Of all wires.
    pub bends: usize,
    /// What joints at vertices weigh, g.
    pub joints_g: f64,
    pub notes: Vec<NoteReport>,
    name: String,
}

impl Installation {
    /// The wires that a design is planned as, whether or not the machine can bend them.
    pub(super) fn wires_to_close(
        &self,
        opened: Opened,
        choices: &PlanChoices,
        chosen_faces: Option<&FacesChoice>,
        progress: &dyn Progress,
    ) -> Result<Wires, PlanningError> {
        let before = opened.notes.len();
        let groups = chosen_faces.map(|input| faces(input, &opened)).transpose()?;
        let planned = self.plan_design(opened, choices, progress)?;
        let material = FrameMaterial::planned(&planned.setup)?;
        let wireframe = &planned.opened.document.wireframe;
        let vertices: Vec<VertexId> = wireframe.vertices().map(|(id, _)| id).collect();
        let points: Vec<_> = wireframe.vertices().map(|(_, vertex)| vertex.position).collect();
        let mut struts = Vec::new();
        let wires = (1..).zip(&planned.wires).map(|(number, wire)| {
            let (route, nominal, scheduled) =
                (wire.route.as_ref()?, wire.nominal.as_ref()?, wire.scheduled.as_ref()?);
            let places = route.vertices().into_iter().filter_map(|id| vertices.binary_search(&id).ok());
            let vertices: Vec<usize> = places.collect();
            let ends = vertices.windows(2).zip(&route.traversals);
            struts.extend(ends.map(|(ends, traversal)| ClosedStrut {
                edge: traversal.edge,
                wire: number,
                ends: [ends[0], ends[1]],
                axial_n: 0.0,
                von_mises_rms_mpa: 0.0,
            }));
            Some(FrameWire {
                vertices,
                start: scheduled_start(wire.start, &scheduled.steps),
                program: NominalProgram { steps: scheduled.steps.clone(), spans: nominal.spans.clone() },
            })
        });
        let wires: Vec<FrameWire> = wires.collect::<Option<_>>().ok_or_else(|| unplanned(&planned))?;
        let name = planned.opened.name.clone();
        let model = ClosingModel::new(&points, &wires, material.section())
            .map_err(|error| PlanningError::Closing { name: name.clone(), error })?;
        let whole = model.whole();
        let surface = groups.map_or_else(|| whole.clone(), |groups| surface(&points, &vertices, &groups));
        let joints_g = wireframe
            .vertices()
            .filter_map(|(_, vertex)| vertex.joint)
            .fold(0.0, |sum, joint| sum + joint.mass_g);
        let notes = planned.opened.notes.into_iter().skip(before).collect();
        let length = wires.iter().map(|wire| wire.program.length()).sum();
        let bends = wires.iter().map(|wire| wire.program.bend_count()).sum();
        Ok(Wires { material, model, surface, whole, struts, length, bends, joints_g, notes, name })
    }
}

/// Not every part of the design has a route and a program.
fn unplanned(planned: &Planned) -> PlanningError {
    PlanningError::StageNotReached { stage: StageName::Schedule, report: Box::new(planned.report()) }
}

impl Wires {
    pub fn failed(&self, error: wirebend_accuracy::ClosingError) -> PlanningError {
        PlanningError::Closing { name: self.name.clone(), error }
    }
}
