//! A sequence as a file: for this command, for `FrameFab`, for programs that read assembly instances.

use std::collections::BTreeMap;
use wirebend_core::checks::sequence::StepKind;
use wirebend_core::wireframe::EdgeId;

use schemars::JsonSchema;
use serde::Deserialize;
use wirebend_error::InputName;
use wirebend_files::read::frame::{SequenceFile, SequenceStep, StrutKind};
use wirebend_files::write::frame::{BuiltMember, assembly_instances, framefab_sequence, vtk};
use wirebend_sequence::{Outcome, Step, Task};

use super::report::{SequenceResponse, SequenceStepReport};
use crate::PlanningError;
use crate::design::Opened;
use crate::frame::{FrameMaterial, built_result};
use crate::misnamed::FileKind;

/// What a sequence is written as.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum SequenceFormat {
    /// The answer as JSON, which can be checked again.
    #[default]
    Wirebend,
    /// The JSON of `FrameFab`, with all free directions.
    Framefab,
    /// Assembly instances, elements in the order of building; `layer_id` is the layer, or without layers the step.
    AssemblyInstances,
    /// The frame under its own weight with the step of each strut, for programs that show VTK files.
    Vtk,
}

impl SequenceFormat {
    pub(super) const fn kind(self) -> FileKind<'static> {
        match self {
            Self::Wirebend => FileKind { called: "a sequence", endings: &["json"] },
            Self::Framefab => FileKind { called: "a sequence of FrameFab", endings: &["json"] },
            Self::AssemblyInstances => FileKind { called: "assembly instances", endings: &["json"] },
            Self::Vtk => FileKind { called: "a VTK file", endings: &["vtk"] },
        }
    }
}

/// Refuses before any work is done what would be refused in the end. `checked`: the order is given.
pub(super) fn check(format: SequenceFormat, checked: bool) -> Result<(), PlanningError> {
    if checked && format == SequenceFormat::Framefab { Err(without_directions()) } else { Ok(()) }
}

fn without_directions() -> PlanningError {
    PlanningError::Value {
        input: None,
        name: "format",
        value: "framefab".to_owned(),
        expected: "another one: files of FrameFab have all free directions, which an order that is checked does not tell",
    }
}

/// The text of a sequence that can be built. `found`: how it was found, with all free directions; none of an order that was checked.
pub(super) fn text(
    format: SequenceFormat,
    response: &SequenceResponse,
    found: Option<(&Task<'_>, &Outcome)>,
    opened: &Opened,
    material: &FrameMaterial,
) -> Result<String, PlanningError> {
    Ok(match format {
        SequenceFormat::Wirebend => {
            let mut text = serde_json::to_string_pretty(response)?;
            text.push('\n');
            text
        }
        SequenceFormat::Framefab => {
            let (task, outcome) = found.ok_or_else(without_directions)?;
            let steps: Result<Vec<SequenceStep>, _> =
                outcome.steps.iter().map(|step| framefab_step(task, step)).collect();
            framefab_sequence(&SequenceFile { base_centre: None, steps: steps? })
        }
        SequenceFormat::AssemblyInstances => {
            let built = built(response);
            assembly_instances(&opened.document.wireframe, &built, &BTreeMap::new(), None, None)
        }
        SequenceFormat::Vtk => {
            let steps = (1..).zip(&response.steps);
            let steps = steps.flat_map(|(number, step)| edges(step).map(move |edge| (edge, number)));
            vtk(&built_result(opened, material, &steps.collect())?.unwrap_or_default())
        }
    })
}

fn framefab_step(task: &Task<'_>, step: &Step) -> Result<SequenceStep, PlanningError> {
    let ([strut], [joint]) = (&step.struts[..], &step.joints[..]) else {
        return Err(PlanningError::Value {
            input: Some(InputName::GroupBy),
            name: InputName::GroupBy.words(),
            value: "wire".to_owned(),
            expected: "edge: files of FrameFab have one strut for each step",
        });
    };
    let nodes = task.structure.nodes();
    let [a, b] = task.structure.struts()[*strut].ends;
    let to = if joint.node == a { b } else { a };
    let directions = task.builder.directions.all();
    Ok(SequenceStep {
        start: nodes[joint.node].at,
        end: nodes[to].at,
        kind: match step.kind {
            StepKind::Ground => StrutKind::Ground,
            StepKind::Create => StrutKind::Create,
            StepKind::Connect => StrutKind::Connect,
        },
        directions: joint.free.iter().map(|index| directions[index].into_inner()).collect(),
    })
}

fn built(response: &SequenceResponse) -> Vec<BuiltMember> {
    let mut layer_of = BTreeMap::new();
    for (layer, edges) in (0_i64..).zip(response.layers.iter().flatten()) {
        layer_of.extend(edges.iter().map(|&edge| (edge, layer)));
    }
    let steps = (0_i64..).zip(&response.steps);
    let members = steps.flat_map(|(number, step)| edges(step).map(move |edge| (number, edge)));
    let member = |(number, edge): (i64, EdgeId)| BuiltMember {
        edge,
        layer: layer_of.get(&edge.0).copied().unwrap_or(number),
    };
    members.map(member).collect()
}

/// The edges that a step builds.
fn edges(step: &SequenceStepReport) -> impl Iterator<Item = EdgeId> {
    let edges = if step.edges.is_empty() { vec![step.edge] } else { step.edges.clone() };
    edges.into_iter().map(EdgeId)
}
