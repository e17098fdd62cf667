//! A frame whose joints are closed: how accurate it is, what its struts carry then, and what it takes.

use std::path::{Path, PathBuf};

use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_accuracy::{Closed, Closing, Draw, Prepared, Resources};
use wirebend_core::simulate::ErrorModel;
use wirebend_error::InputName;
use wirebend_files::write::frame::{ClosedResult, ClosedStrut, ResultNode, closed_vtk};

use super::faces::FacesChoice;
use super::figures::ClosingFigures;
use super::runs::{Figures, Runs};
use super::shapes::{ClosedShapes, made_lines};
use super::structure::Structure;
use super::wires::Wires;
use super::within;
use crate::choices::PlanChoices;
use crate::design::Opened;
use crate::output::{Output, file_name};
use crate::report::NoteReport;
use crate::simulate::noise_model;
use crate::{Installation, PlanningError, Progress};

/// How joints are closed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum ClosingName {
    /// Each pass of the wire is pulled to its vertex and turns freely; then joints are locked, and all is let go.
    #[default]
    Aligned,
    /// Joints are rigid from the start.
    Coupled,
}

impl From<ClosingName> for Closing {
    fn from(name: ClosingName) -> Self {
        match name {
            ClosingName::Aligned => Self::Aligned,
            ClosingName::Coupled => Self::Coupled,
        }
    }
}

/// How joints are closed, and what is off.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
pub struct ClosingChoice {
    /// The errors: the id of a noise profile.
    pub errors: String,
    #[serde(default)]
    pub closing: ClosingName,
    /// How many wires are drawn; 0: none, the exact expectation over all of them, which there is for straight struts alone.
    pub runs: u32,
    /// Where the random numbers start.
    pub seed: u64,
    /// The faces that are to be flat. Absent, all vertices count, after the motion of the whole that fits them best.
    pub faces: Option<FacesChoice>,
    /// Where the first drawn wire goes once its joints are closed, as a VTK file.
    pub vtk: Option<Output>,
}

/// A closed frame: over drawn wires roots of mean squares, or those that are expected of all.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct ClosingReport {
    /// How joints were closed.
    pub model: ClosingName,
    /// Of how many faces the surface is; null where all vertices count.
    pub faces: Option<usize>,
    #[serde(flatten)]
    pub figures: ClosingFigures,
}

/// Over all runs.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct ClosingRuns {
    pub mean: ClosingFigures,
    /// Standard deviations, with one wire less than there are in the denominator; null of a single wire.
    pub sd: Option<ClosingFigures>,
}

/// What the wires take, as Table 1 of Bend-Forming has it. Time is energy at the authors' 25 W, and not the time of the machine.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct ResourcesReport {
    /// Of all wires as designed, mm.
    pub length_mm: f64,
    /// Of all wires.
    pub bends: usize,
    pub wire_g: f64,
    /// What joins the wires at vertices, g.
    pub joints_g: f64,
    /// Wire and joints, g.
    pub mass_g: f64,
    /// Null where the material's profile does not say what forming takes.
    pub energy_kj: Option<f64>,
    pub time_min: Option<f64>,
}

/// What closing joints came to.
#[derive(Default)]
pub(super) struct JointsClosed {
    pub report: Option<ClosingReport>,
    pub runs: Option<u32>,
    pub of_runs: Option<ClosingRuns>,
    pub resources: Option<ResourcesReport>,
    /// Of the first drawn wire, where it is to be drawn.
    pub shapes: Option<ClosedShapes>,
    /// Those that were written.
    pub files: Vec<PathBuf>,
    /// What the wires are of.
    pub material: String,
    pub notes: Vec<NoteReport>,
}

impl Installation {
    /// Closes the joints of the wires that a design is planned as, of the wire that they are planned with. The nodes of the structure are
    /// the vertices of the design. `drawn`: whether the first drawn wire is shown.
    pub(super) fn close_joints(
        &self,
        opened: Opened,
        choices: &PlanChoices,
        choice: &ClosingChoice,
        structure: &Structure,
        drawn: bool,
        progress: &dyn Progress,
    ) -> Result<JointsClosed, PlanningError> {
        Runs::check(choice.runs)?;
        if let Some(output) = &choice.vtk {
            output.check()?;
            within(
                InputName::Runs,
                choice.runs.into(),
                1,
                u64::from(u32::MAX),
                "at least 1: the file shows the first wire that is drawn",
            )?;
        }
        let title = file_name(Path::new(&opened.name));
        let errors = noise_model(self, &choice.errors)?;
        let wires = self.wires_to_close(opened, choices, choice.faces.as_ref(), progress)?;
        progress.stage("closing joints");
        let closing = Closing::from(choice.closing);
        let (figures, of_runs) = if choice.runs == 0 {
            let prepared = wires.model.straight().map_err(|error| wires.failed(error))?;
            let expected = prepared.expected(closing, &errors, &wires.surface);
            (ClosingFigures::from(expected.map_err(|error| wires.failed(error))?), None)
        } else {
            let runs =
                Runs { wires: &wires, errors: &errors, closing, count: choice.runs, seed: choice.seed };
            let figures = runs.all(progress).map_err(|error| wires.failed(error))?;
            let figures = figures.ok_or(PlanningError::Stopped)?;
            let of_runs = ClosingRuns {
                mean: Figures::mean(&figures).into(),
                sd: Figures::deviation(&figures).map(ClosingFigures::from),
            };
            (Figures::root_mean_square(&figures).into(), Some(of_runs))
        };
        let first = FirstWire { structure, wires: &wires, errors: &errors, closing, seed: choice.seed };
        let shapes = if drawn && choice.runs > 0 { Some(first.shapes()?) } else { None };
        let vtk = choice.vtk.as_ref().map(|output| output.save(closed_vtk(&first.result(title)?).as_bytes()));
        let files = vtk.transpose()?.into_iter().collect();
        let faces = choice.faces.is_some().then(|| wires.surface.face_count());
        let material = &wires.material;
        let used = Resources { wire_g: material.wire.mass_g(wires.length), joints_g: wires.joints_g };
        let energy_kj = material.energy_kj_per_g.map(|energy| used.energy_kj(energy));
        Ok(JointsClosed {
            report: Some(ClosingReport { model: choice.closing, faces, figures }),
            runs: (choice.runs > 0).then_some(choice.runs),
            of_runs,
            resources: Some(ResourcesReport {
                length_mm: wires.length.mm(),
                bends: wires.bends,
                wire_g: used.wire_g,
                joints_g: used.joints_g,
                mass_g: used.mass_g(),
                energy_kj,
                time_min: energy_kj.map(Resources::time_min),
            }),
            shapes,
            files,
            material: material.id.clone(),
            notes: wires.notes,
        })
    }
}

/// The first drawn wire. The nodes of the structure are the vertices of the closing model.
struct FirstWire<'a> {
    structure: &'a Structure,
    wires: &'a Wires,
    errors: &'a ErrorModel,
    closing: Closing,
    seed: u64,
}

impl FirstWire<'_> {
    fn draw(&self) -> Result<Draw, PlanningError> {
        self.wires.model.draw(self.errors, self.seed, 0).map_err(|error| self.wires.failed(error))
    }

    fn prepared(&self, draw: &Draw) -> Result<Prepared<'_>, PlanningError> {
        self.wires.model.bowed(draw).map_err(|error| self.wires.failed(error))
    }

    /// How far vertices are off, after the motion of the whole that fits the drawing best.
    fn moved(&self, closed: &Closed) -> Vec<Vector3<f64>> {
        self.wires.whole.remainder(&closed.displacements)
    }

    /// Before and after its joints are closed.
    fn shapes(&self) -> Result<ClosedShapes, PlanningError> {
        let draw = self.draw()?;
        let prepared = self.prepared(&draw)?;
        let moved = self.moved(&prepared.close(self.closing, &draw));
        let structure = self.structure;
        let vertex = |node: usize| structure.vertices.get(node).map_or(0, |id| id.0);
        let (at, max_closed_mm) = moved
            .iter()
            .map(Vector3::norm)
            .enumerate()
            .fold((0, 0.0), |most, one| if one.1 > most.1 { one } else { most });
        let points = &structure.assembly.model().nodes;
        let (made, (made_at, max_made_mm)) = made_lines(points, &prepared.made(&draw));
        Ok(ClosedShapes {
            made,
            closed: structure.straight(&moved),
            max_closed_mm,
            at_vertex: vertex(at),
            max_made_mm,
            made_at_vertex: vertex(made_at),
        })
    }

    /// Closed, for programs that show it.
    fn result(&self, title: String) -> Result<ClosedResult, PlanningError> {
        let draw = self.draw()?;
        let closed = self.prepared(&draw)?.close(self.closing, &draw);
        let structure = self.structure;
        let nodes = structure.vertices.iter().zip(&structure.assembly.model().nodes).zip(self.moved(&closed));
        let nodes = nodes.map(|((&vertex, &position), displacement)| ResultNode {
            vertex,
            position,
            displacement,
            rotation: Vector3::zeros(),
            support: false,
        });
        let carried = closed.axial.iter().zip(&closed.von_mises_squares);
        let struts = self.wires.struts.iter().zip(carried).map(|(strut, (&axial_n, square))| ClosedStrut {
            axial_n,
            von_mises_rms_mpa: square.sqrt(),
            ..*strut
        });
        Ok(ClosedResult { title, nodes: nodes.collect(), struts: struts.collect() })
    }
}
