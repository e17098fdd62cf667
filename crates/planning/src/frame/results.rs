//! Files of what a frame does, for programs that show it.

use std::path::PathBuf;

use nalgebra::Vector3;
use wirebend_files::write::frame::{FrameResult, ResultMember, ResultNode, members_csv, nodes_csv, vtk};
use wirebend_frame::Response;

use super::FrameRequest;
use super::report::StaticReport;
use super::structure::Structure;
use crate::PlanningError;
use crate::output::{Output, file_name};
use crate::report::NoteReport;

/// The files that were asked for.
pub(super) struct Wanted<'a> {
    vtk: Option<&'a Output>,
    /// Of nodes and of members.
    csv: Option<[Output; 2]>,
}

impl<'a> Wanted<'a> {
    /// # Errors
    /// [`PlanningError::Exists`] when a file is there and may not be replaced.
    pub fn of(request: &'a FrameRequest) -> Result<Self, PlanningError> {
        let csv = request.csv.as_ref().map(|output| ["nodes", "members"].map(|what| beside(output, what)));
        let wanted = Self { vtk: request.vtk.as_ref(), csv };
        for output in wanted.vtk.into_iter().chain(wanted.csv.iter().flatten()) {
            output.check()?;
        }
        Ok(wanted)
    }

    fn is_none(&self) -> bool {
        self.vtk.is_none() && self.csv.is_none()
    }

    /// Writes them, where there is something to write.
    pub fn write(
        &self,
        structure: &Structure,
        solved: Option<&(StaticReport, Response)>,
        title: &str,
        notes: &mut Vec<NoteReport>,
    ) -> Result<Vec<PathBuf>, PlanningError> {
        let Some((report, response)) = solved else {
            notes.extend((!self.is_none()).then(nothing_to_write));
            return Ok(Vec::new());
        };
        let result = result(structure, report, response, title);
        let mut files = Vec::new();
        if let Some(output) = self.vtk {
            files.push(output.save(vtk(&result).as_bytes())?);
        }
        if let Some([nodes, members]) = &self.csv {
            files.push(nodes.save(nodes_csv(&result).as_bytes())?);
            files.push(members.save(members_csv(&result).as_bytes())?);
        }
        Ok(files)
    }
}

/// `frame.csv` becomes `frame-nodes.csv`.
fn beside(output: &Output, what: &str) -> Output {
    let name = file_name(&output.path);
    let stem = name.strip_suffix(".csv").unwrap_or(&name);
    Output { path: output.path.with_file_name(format!("{stem}-{what}.csv")), force: output.force }
}

fn nothing_to_write() -> NoteReport {
    NoteReport {
        code: "not-written".into(),
        count: 1,
        message: "no file of displacements is written: the frame floats, or does not stand".to_owned(),
        remedies: Vec::new(),
    }
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
