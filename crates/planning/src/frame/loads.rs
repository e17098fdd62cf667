//! What acts on a frame: its own weight, that of its joints, and loads from a file.

use nalgebra::Vector3;
use wirebend_error::InputName;
use wirebend_files::read::frame::{LoadCase, read_loads};
use wirebend_frame::{LineLoad, Load, LoadError, MemberId, NodalLoad, STANDARD_GRAVITY};

use super::structure::Structure;
use crate::PlanningError;
use crate::design::{Input, Opened};

/// Standard gravity downwards, as a multiple of itself.
const DOWN: [f64; 3] = [0.0, 0.0, -1.0];

/// Loads from a file.
#[derive(Debug, Clone, PartialEq, Eq, serde::Deserialize, schemars::JsonSchema)]
pub struct LoadsChoice {
    /// Load cases as conmech writes them.
    pub file: Input,
    /// Which of them; absent, the only one.
    pub case: Option<String>,
}

/// All that acts at once.
pub(super) fn loads(
    opened: &Opened,
    structure: &Structure,
    gravity: Option<[f64; 3]>,
    chosen: Option<&LoadsChoice>,
) -> Result<Load, PlanningError> {
    let case = chosen.map(|chosen| case(opened, chosen)).transpose()?;
    // Loads of a file act without weight unless it says so.
    let otherwise = match &case {
        Some(case) => case.gravity.unwrap_or_default(),
        None => DOWN,
    };
    let gravity = Vector3::from(checked(gravity.unwrap_or(otherwise))?) * STANDARD_GRAVITY;
    let case = case.unwrap_or_default();
    let at_vertices = case.nodal.iter().filter_map(|load| {
        let node = structure.node(load.vertex)?;
        Some(NodalLoad { node, force: load.force_n.into(), moment: load.moment_n_mm.into() })
    });
    // Grams are 1e-6 t.
    let of_joints = structure.joints.iter().map(|&(node, mass_g)| NodalLoad {
        node,
        force: gravity * (mass_g * 1.0e-6),
        moment: Vector3::zeros(),
    });
    let along_struts = case.line.iter().filter_map(|load| {
        let member = MemberId(structure.edges.binary_search(&load.edge).ok()?);
        Some(LineLoad { member, force: load.n_per_mm.into() })
    });
    Ok(Load {
        nodal: at_vertices.chain(of_joints).collect(),
        line: along_struts.collect(),
        gravity,
        ..Load::default()
    })
}

/// The load case that was chosen.
fn case(opened: &Opened, chosen: &LoadsChoice) -> Result<LoadCase, PlanningError> {
    let (name, bytes) = chosen.file.load()?;
    let cases = read_loads(&bytes, &name, &opened.document.wireframe, opened.frame.as_deref())?;
    let known: Vec<String> = cases.iter().map(|case| case.name.clone()).collect();
    let mut fitting =
        cases.into_iter().filter(|case| chosen.case.as_ref().is_none_or(|wanted| *wanted == case.name));
    match (fitting.next(), fitting.next()) {
        (Some(case), None) => Ok(case),
        _ => Err(PlanningError::LoadCase { name, wanted: chosen.case.clone(), known }),
    }
}

fn checked(gravity: [f64; 3]) -> Result<[f64; 3], PlanningError> {
    if gravity.iter().all(|part| part.is_finite()) {
        return Ok(gravity);
    }
    Err(PlanningError::Value {
        input: Some(InputName::Gravity),
        name: InputName::Gravity.words(),
        value: gravity.map(|part| part.to_string()).join(","),
        expected: "three numbers, multiples of standard gravity along x, y and z",
    })
}

/// A load that acts on nothing.
pub(super) fn elsewhere(opened: &Opened, structure: &Structure, error: &LoadError) -> PlanningError {
    let reason = match error {
        LoadError::AbsentNode { node } => {
            let vertex = structure.vertices.get(node.0).map_or(0, |id| id.0);
            format!("a load acts on vertex {vertex}, at which no strut ends")
        }
        error => error.to_string(),
    };
    PlanningError::NoFrame { name: opened.name.clone(), reason }
}
