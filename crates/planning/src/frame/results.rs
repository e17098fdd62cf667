//! Files of what a frame does, for programs that show it.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use nalgebra::{Point3, Vector3};
use schemars::JsonSchema;
use serde::Deserialize;
use wirebend_core::units::Length;
use wirebend_core::wireframe::EdgeId;
use wirebend_files::write::frame::{
    DeformedStrut, FrameResult, ResultMember, ResultNode, deformed_glb, members_csv, nodes_csv, vtk,
};
use wirebend_frame::{Load, MemberId, Response};

use super::FrameSupports;
use super::conmech::{frame_text, joints_as_forces, loads_text, without_yield};
use super::loads::loads;
use super::material::FrameMaterial;
use super::notes::about_edges;
use super::report::StaticReport;
use super::structure::Structure;
use crate::PlanningError;
use crate::design::Opened;
use crate::misnamed::FileKind;
use crate::output::{Output, file_name};
use crate::report::NoteReport;

/// What is written of a loaded frame for other programs.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct FrameFiles {
    /// Displacements and forces for a program that shows them, as a VTK file.
    pub vtk: Option<Output>,
    /// The same as tables: `NAME-nodes.csv` and `NAME-members.csv` for `NAME.csv`.
    pub csv: Option<Output>,
    /// The frame as it is computed, for conmech, and what acts on it: `NAME.json` and `NAME-loads.json`.
    pub conmech: Option<Output>,
    /// The deformed shape as a model, binary glTF.
    pub glb: Option<Output>,
    /// How far displacements are enlarged in the model; 1 is true scale.
    #[serde(default = "true_scale")]
    pub displacement_scale: f64,
}

const fn true_scale() -> f64 {
    1.0
}

impl Default for FrameFiles {
    fn default() -> Self {
        Self { vtk: None, csv: None, conmech: None, glb: None, displacement_scale: true_scale() }
    }
}

const VTK: FileKind<'static> = FileKind { called: "a VTK file", endings: &["vtk"] };
const CONMECH: FileKind<'static> = FileKind { called: "a frame for conmech", endings: &["json"] };
const GLB: FileKind<'static> = FileKind { called: "a binary glTF model", endings: &["glb"] };

/// The files that were asked for.
pub(super) struct Wanted<'a> {
    vtk: Option<&'a Output>,
    /// Of nodes and of members.
    csv: Option<[Output; 2]>,
    /// Of the frame and of its loads.
    conmech: Option<[Output; 2]>,
    glb: Option<&'a Output>,
    /// How far the model is enlarged.
    scale: f64,
}

/// A frame with what acts on it.
#[derive(Clone, Copy)]
pub(super) struct Loaded<'a> {
    pub opened: &'a Opened,
    pub structure: &'a Structure,
    pub material: &'a FrameMaterial,
    pub load: &'a Load,
}

impl<'a> Wanted<'a> {
    /// # Errors
    /// [`PlanningError::Exists`] when a file is there and may not be replaced; a scale that is no number.
    pub fn of(asked: &'a FrameFiles) -> Result<Self, PlanningError> {
        let scale = asked.displacement_scale;
        if !scale.is_finite() {
            return Err(PlanningError::Value {
                input: None,
                name: "scale of the displacements",
                value: scale.to_string(),
                expected: "a number; 1 is true scale",
            });
        }
        let csv =
            asked.csv.as_ref().map(|output| ["nodes", "members"].map(|what| beside(output, what, ".csv")));
        let conmech = asked.conmech.as_ref().map(|output| [output.clone(), beside(output, "loads", ".json")]);
        let wanted = Self { vtk: asked.vtk.as_ref(), csv, conmech, glb: asked.glb.as_ref(), scale };
        let several = wanted.csv.iter().chain(&wanted.conmech).flatten();
        for output in wanted.vtk.into_iter().chain(wanted.glb).chain(several) {
            output.check()?;
        }
        Ok(wanted)
    }

    fn is_none(&self) -> bool {
        self.vtk.is_none() && self.csv.is_none() && self.conmech.is_none() && self.glb.is_none()
    }

    /// Writes them, where there is something to write.
    pub fn write(
        &self,
        loaded: Loaded<'_>,
        solved: Option<&(StaticReport, Response)>,
        notes: &mut Vec<NoteReport>,
    ) -> Result<Vec<PathBuf>, PlanningError> {
        let Loaded { opened, structure, material, load } = loaded;
        let Some((report, response)) = solved else {
            notes.extend((!self.is_none()).then(nothing_to_write));
            return Ok(Vec::new());
        };
        let title = file_name(Path::new(&opened.name));
        let result = result(structure, report, response, &title);
        let mut files = Vec::new();
        if let Some(output) = self.vtk {
            files.push(output.save(vtk(&result).as_bytes())?);
            notes.extend(VTK.misnamed(Some(output)));
        }
        if let Some([nodes, members]) = &self.csv {
            files.push(nodes.save(nodes_csv(&result).as_bytes())?);
            files.push(members.save(members_csv(&result).as_bytes())?);
        }
        if let Some([frame, loads]) = &self.conmech {
            files.push(frame.save(frame_text(opened, structure, material, &title).as_bytes())?);
            files.push(loads.save(loads_text(opened, structure, load).as_bytes())?);
            notes.extend(CONMECH.misnamed(Some(frame)));
            notes.extend(joints_as_forces(structure));
            notes.extend(without_yield(structure));
        }
        if let Some(output) = self.glb {
            files.push(output.save(&deformed_glb(&deformed(structure, load, response), self.scale))?);
            notes.extend(drawn_round(structure, material));
            notes.extend(GLB.misnamed(Some(output)));
        }
        Ok(files)
    }
}

/// Struts as a view draws them, each as thick as it is.
fn deformed(structure: &Structure, load: &Load, response: &Response) -> Vec<DeformedStrut> {
    let struts = structure.lines().into_iter().zip(structure.loaded(load, response)).enumerate();
    let struts = struts.map(|(k, (line, moved))| DeformedStrut {
        edge: EdgeId(line.edge),
        radius: Length::from_mm(structure.assembly.section(MemberId(k)).radius).unwrap_or_default(),
        at: line.at_mm.into_iter().map(Point3::from).collect(),
        moved: moved.into_iter().map(Vector3::from).collect(),
    });
    struts.collect()
}

/// A model has round struts only.
fn drawn_round(structure: &Structure, material: &FrameMaterial) -> Option<NoteReport> {
    about_edges("drawn-round", structure.of_other_sections(material), |of| {
        format!("the section of {of} is no solid round: drawn as a round one of the same area")
    })
}

/// `frame.csv` becomes `frame-nodes.csv`.
fn beside(output: &Output, what: &str, ending: &str) -> Output {
    let name = file_name(&output.path);
    let stem = name.strip_suffix(ending).unwrap_or(&name);
    Output { path: output.path.with_file_name(format!("{stem}-{what}{ending}")), force: output.force }
}

fn nothing_to_write() -> NoteReport {
    NoteReport {
        code: "not-written".into(),
        count: 1,
        message: "no file of the loaded frame is written: it floats, or does not stand".to_owned(),
        remedies: Vec::new(),
    }
}

/// A design under its own weight, each strut with the step in which it is built; none where it does not stand.
pub(crate) fn built_result(
    opened: &Opened,
    material: &FrameMaterial,
    steps: &BTreeMap<EdgeId, usize>,
) -> Result<Option<FrameResult>, PlanningError> {
    let supports = FrameSupports::Design;
    let structure = Structure::new(opened, material, &supports, &mut Vec::new())?;
    let load = loads(opened, &structure, None, None, &[])?;
    let solved = structure.statics(opened, material, &supports, &load, &mut Vec::new())?;
    Ok(solved.map(|(report, response)| {
        let mut result = result(&structure, &report, &response, &file_name(Path::new(&opened.name)));
        for member in &mut result.members {
            member.step = steps.get(&member.edge).copied();
        }
        result
    }))
}

fn result(structure: &Structure, report: &StaticReport, response: &Response, title: &str) -> FrameResult {
    let model = structure.assembly.model();
    let nodes = structure.vertices.iter().zip(&model.nodes).zip(&response.displacements).enumerate();
    let nodes = nodes.map(|(k, ((&vertex, &position), u))| ResultNode {
        vertex,
        position,
        displacement: Vector3::new(u[0], u[1], u[2]),
        rotation: Vector3::new(u[3], u[4], u[5]),
        support: model.supports.iter().any(|support| support.node.0 == k),
    });
    let members = structure.edges.iter().zip(&model.members).zip(&report.members);
    let members = members.map(|((&edge, member), carried)| ResultMember {
        edge,
        ends: [member.a.0, member.b.0],
        axial_n: carried.axial_n,
        moment_n_mm: carried.moment_n_mm,
        torque_n_mm: carried.torque_n_mm,
        von_mises_mpa: carried.von_mises_mpa,
        utilisation: carried.utilisation,
        buckling_ratio: carried.buckling_ratio,
        step: None,
    });
    FrameResult { title: title.to_owned(), nodes: nodes.collect(), members: members.collect() }
}
