//! What acts on a frame: its own weight, that of its joints, and loads from a file.

use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_core::wireframe::VertexId;
use wirebend_error::InputName;
use wirebend_files::read::frame::{LoadCase, read_loads};
use wirebend_frame::{LineLoad, Load, LoadError, MemberId, NodalLoad, STANDARD_GRAVITY};

use super::structure::Structure;
use crate::choices::PlanChoices;
use crate::design::{DesignInput, Input, Opened};
use crate::{Installation, PlanningError, Progress};

/// Standard gravity downwards, as a multiple of itself.
const DOWN: [f64; 3] = [0.0, 0.0, -1.0];

/// The most gravity along an axis, as a multiple of standard gravity.
const MOST_GRAVITY: f64 = 1e6;

/// Loads from a file.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize, JsonSchema)]
pub struct LoadsChoice {
    /// Load cases as conmech writes them.
    pub file: Input,
    /// Which of them; absent, the only one.
    pub case: Option<String>,
}

/// A force at a vertex.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct VertexForce {
    pub vertex: u32,
    /// Along x, y and z.
    pub force_n: [f64; 3],
}

/// The load cases of a file.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct LoadCases {
    /// The file.
    pub name: String,
    /// By name.
    pub cases: Vec<LoadCaseEntry>,
}

/// A load case, to choose.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct LoadCaseEntry {
    pub name: String,
    /// Forces at vertices.
    pub forces: Vec<VertexForce>,
    /// How many vertices bear a moment.
    pub moments: usize,
    /// How many edges bear a load along them.
    pub along_edges: usize,
    /// As multiples of standard gravity; null where the case says nothing of it.
    pub gravity: Option<[f64; 3]>,
}

/// The load cases of a file, as they act on a design.
///
/// # Errors
/// [`PlanningError::Read`] for what is no such file, or names what the design does not have.
pub fn load_cases(
    app: &Installation,
    design: &DesignInput,
    file: &Input,
    progress: &dyn Progress,
) -> Result<LoadCases, PlanningError> {
    let choices = PlanChoices::default();
    let opened = app.designed(design.open_with(app, &choices, progress)?, &choices)?.with_wireframe()?;
    let (name, cases) = read_cases(&opened, file)?;
    let entry = |case: LoadCase| LoadCaseEntry {
        forces: case
            .nodal
            .iter()
            .map(|load| VertexForce { vertex: load.vertex.0, force_n: load.force_n })
            .filter(|load| load.force_n.iter().any(|part| *part != 0.0))
            .collect(),
        moments: case.nodal.iter().filter(|load| load.moment_n_mm.iter().any(|part| *part != 0.0)).count(),
        along_edges: case.line.len(),
        gravity: case.gravity,
        name: case.name,
    };
    Ok(LoadCases { name, cases: cases.into_iter().map(entry).collect() })
}

/// All that acts at once.
pub(super) fn loads(
    opened: &Opened,
    structure: &Structure,
    gravity: Option<[f64; 3]>,
    chosen: Option<&LoadsChoice>,
    forces: &[VertexForce],
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
    let forces = forces.iter().map(|force| at_vertex(opened, structure, force));
    let forces: Vec<NodalLoad> = forces.collect::<Result<_, _>>()?;
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
        nodal: at_vertices.chain(forces).chain(of_joints).collect(),
        line: along_struts.collect(),
        gravity,
        ..Load::default()
    })
}

/// A force that a person puts on a vertex.
fn at_vertex(
    opened: &Opened,
    structure: &Structure,
    force: &VertexForce,
) -> Result<NodalLoad, PlanningError> {
    let VertexForce { vertex, force_n } = *force;
    if opened.document.wireframe.vertex(VertexId(vertex)).is_none() {
        return Err(opened.no_vertex(vertex, InputName::Loads));
    }
    if !force_n.iter().all(|part| part.is_finite()) {
        return Err(PlanningError::Value {
            input: Some(InputName::Loads),
            name: InputName::Loads.words(),
            value: format!("{} at vertex {vertex}", force_n.map(|part| part.to_string()).join(",")),
            expected: "three numbers, N along x, y and z",
        });
    }
    let node = structure.node(VertexId(vertex)).ok_or_else(|| on_nothing(opened, vertex))?;
    Ok(NodalLoad { node, force: force_n.into(), moment: Vector3::zeros() })
}

fn read_cases(opened: &Opened, file: &Input) -> Result<(String, Vec<LoadCase>), PlanningError> {
    let (name, bytes) = file.load()?;
    let cases = read_loads(&bytes, &name, &opened.document.wireframe, opened.frame.as_deref())?;
    Ok((name, cases))
}

/// The load case that was chosen.
fn case(opened: &Opened, chosen: &LoadsChoice) -> Result<LoadCase, PlanningError> {
    let (name, cases) = read_cases(opened, &chosen.file)?;
    let known: Vec<String> = cases.iter().map(|case| case.name.clone()).collect();
    let mut fitting =
        cases.into_iter().filter(|case| chosen.case.as_ref().is_none_or(|wanted| *wanted == case.name));
    match (fitting.next(), fitting.next()) {
        (Some(case), None) => Ok(case),
        _ => Err(PlanningError::LoadCase { name, wanted: chosen.case.clone(), known }),
    }
}

fn checked(gravity: [f64; 3]) -> Result<[f64; 3], PlanningError> {
    if gravity.iter().all(|part| part.abs() <= MOST_GRAVITY) {
        return Ok(gravity);
    }
    Err(PlanningError::Value {
        input: Some(InputName::Gravity),
        name: InputName::Gravity.words(),
        value: gravity.map(|part| part.to_string()).join(","),
        expected: "three numbers, multiples of standard gravity along x, y and z, up to a million either way",
    })
}

/// A load that acts on nothing.
pub(super) fn elsewhere(opened: &Opened, structure: &Structure, error: &LoadError) -> PlanningError {
    match error {
        LoadError::AbsentNode { node } => {
            on_nothing(opened, structure.vertices.get(node.0).map_or(0, |id| id.0))
        }
        error => PlanningError::NoFrame { name: opened.name.clone(), reason: error.to_string() },
    }
}

fn on_nothing(opened: &Opened, vertex: u32) -> PlanningError {
    let reason = format!("a load acts on vertex {vertex}, at which no strut ends");
    PlanningError::NoFrame { name: opened.name.clone(), reason }
}
