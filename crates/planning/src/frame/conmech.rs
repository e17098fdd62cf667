//! A frame and what acts on it as conmech has them: what was computed can be computed again by another program.

use std::collections::BTreeMap;

use wirebend_core::wireframe::EdgeId;
use wirebend_files::read::frame::{
    self, FrameFile, FrameMember, FrameSection, LineLoad, LoadCase, NodalLoad,
};
use wirebend_files::write::frame::{conmech_frame, conmech_loads};
use wirebend_frame::{Load, MemberId, STANDARD_GRAVITY};

use super::material::{FrameMaterial, UNKNOWN_YIELD};
use super::notes::about_edges;
use super::structure::Structure;
use crate::design::Opened;
use crate::report::NoteReport;

/// The only load case.
const CASE: &str = "0";

/// The frame as it is computed: sections and materials of its file where they are taken, else those of the wire.
pub(super) fn frame_text(
    opened: &Opened,
    structure: &Structure,
    material: &FrameMaterial,
    name: &str,
) -> String {
    let of_file = opened.frame.as_deref();
    let mut frame = match of_file {
        Some(file) if material.of_file => file.clone(),
        file => of_wire(structure, material, file),
    };
    let supports = structure.assembly.model().supports.iter();
    frame.supports =
        supports.filter_map(|held| Some((*structure.vertices.get(held.node.0)?, held.fixed))).collect();
    conmech_frame(&opened.document.wireframe, &frame, name)
}

/// Every strut of one wire, in the layers of the file.
fn of_wire(structure: &Structure, material: &FrameMaterial, file: Option<&FrameFile>) -> FrameFile {
    let section = material.section();
    let layer = |edge: EdgeId| file.and_then(|file| file.members.get(&edge)).and_then(|member| member.layer);
    let member = |edge: EdgeId| FrameMember {
        section: Some(0),
        material: Some(0),
        tag: String::new(),
        layer: layer(edge),
    };
    let members: BTreeMap<EdgeId, FrameMember> =
        structure.edges.iter().map(|&edge| (edge, member(edge))).collect();
    FrameFile {
        sections: vec![FrameSection {
            area_mm2: section.area,
            j_mm4: section.j,
            iy_mm4: section.iy,
            iz_mm4: section.iz,
        }],
        materials: vec![frame::FrameMaterial {
            name: material.id.clone(),
            youngs_modulus_mpa: section.e,
            shear_modulus_mpa: section.g,
            density_kg_per_m3: section.density * 1.0e12,
            yield_strength_mpa: Some(section.yield_strength).filter(|&yields| yields < UNKNOWN_YIELD),
        }],
        members,
        ..FrameFile::default()
    }
}

/// All that acts on the frame, as one load case.
pub(super) fn loads_text(opened: &Opened, structure: &Structure, load: &Load) -> String {
    let nodal = load.nodal.iter().filter_map(|load| {
        let vertex = *structure.vertices.get(load.node.0)?;
        Some(NodalLoad { vertex, force_n: load.force.into(), moment_n_mm: load.moment.into() })
    });
    let line = load.line.iter().filter_map(|load| {
        Some(LineLoad { edge: *structure.edges.get(load.member.0)?, n_per_mm: load.force.into() })
    });
    let gravity: [f64; 3] = (load.gravity / STANDARD_GRAVITY).into();
    let case = LoadCase {
        name: CASE.to_owned(),
        nodal: nodal.collect(),
        line: line.collect(),
        gravity: Some(gravity).filter(|parts| parts.iter().any(|part| *part != 0.0)),
    };
    conmech_loads(&opened.document.wireframe, &[case])
}

/// conmech states a yield strength for each material, and refuses one without.
pub(super) fn without_yield(structure: &Structure) -> Option<NoteReport> {
    let members = (0..structure.edges.len()).map(MemberId);
    let count = members.filter(|&id| structure.assembly.section(id).yield_strength >= UNKNOWN_YIELD).count();
    about_edges("yield-unknown", count, |of| {
        format!(
            "conmech asks for a yield strength (fy), and that of {of} is not known: its own program refuses the file"
        )
    })
}

/// A node of conmech has no mass.
pub(super) fn joints_as_forces(structure: &Structure) -> Option<NoteReport> {
    let count = structure.joints.iter().filter(|(_, mass_g)| *mass_g > 0.0).count();
    let joints = if count == 1 { "1 joint is".to_owned() } else { format!("{count} joints is") };
    (count > 0).then(|| NoteReport {
        code: "joints-as-forces".into(),
        count,
        message: format!("conmech has no mass of joints: the weight of {joints} written as forces at nodes"),
        remedies: Vec::new(),
    })
}
