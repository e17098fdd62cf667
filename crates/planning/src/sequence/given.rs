//! A sequence from a file: what this command wrote, or what `FrameFab` did.

use std::fmt::Display;

use nalgebra::Vector3;
use serde::Deserialize;
use wirebend_core::checks::sequence::StepKind;
use wirebend_core::units::Length;
use wirebend_core::wireframe::{EdgeId, VertexId};
use wirebend_files::read::frame::{StrutKind, direction, read_sequence};
use wirebend_sequence::{Checked, GivenJoint, GivenStep};

use super::report::StepTypeName;
use crate::PlanningError;
use crate::design::{Input, Opened};

/// Files of positions have three decimals.
const POSITIONS_MM: f64 = 0.01;

/// How far directions of length 1 may be apart that a person typed twice.
const SAME_DIRECTION: f64 = 1e-6;

/// What is read of the answer of this command.
#[derive(Deserialize)]
struct OwnFile {
    steps: Vec<Given>,
}

#[derive(Deserialize)]
struct OwnStep {
    edge: u32,
    from_vertex: Option<u32>,
    #[serde(rename = "type")]
    kind: Option<StepTypeName>,
    direction: Option<Axis>,
    /// Of a wire or rod.
    #[serde(default)]
    edges: Vec<u32>,
    #[serde(default)]
    joints: Vec<OwnJoint>,
}

#[derive(Deserialize)]
struct OwnJoint {
    vertex: u32,
    direction: Axis,
}

#[derive(Deserialize)]
#[serde(try_from = "OwnStep")]
struct Given(GivenStep);

/// The direction of the head's axis.
#[derive(Clone, Copy, Deserialize)]
#[serde(try_from = "[f64; 3]")]
struct Axis(Vector3<f64>);

impl TryFrom<[f64; 3]> for Axis {
    type Error = String;

    fn try_from(parts: [f64; 3]) -> Result<Self, String> {
        let wrong = || format!("the direction {parts:?}: expected a direction of length 1");
        direction(parts).map(Self).ok_or_else(wrong)
    }
}

pub(super) fn read(input: &Input, opened: &Opened) -> Result<Vec<GivenStep>, PlanningError> {
    let (name, bytes) = input.load()?;
    if !is_own(&bytes) {
        return framefab(&bytes, &name, opened);
    }
    let file: OwnFile = serde_json::from_slice(&bytes).map_err(|error| PlanningError::SequenceFile {
        name: name.clone(),
        line: error.line(),
        reason: wrong_step(&bytes).unwrap_or_else(|| error.to_string()),
    })?;
    Ok(file.steps.into_iter().map(|step| step.0).collect())
}

/// Whether it has steps, or would have if it were whole; everything else is told by the reader of `FrameFab`'s files.
fn is_own(bytes: &[u8]) -> bool {
    #[derive(Deserialize)]
    struct Shape {
        #[serde(rename = "steps")]
        _steps: serde::de::IgnoredAny,
    }
    let named = || String::from_utf8_lossy(bytes).contains("\"steps\"");
    match serde_json::from_slice::<Shape>(bytes) {
        Ok(_) => true,
        Err(error) => !error.is_data() && named(),
    }
}

/// The first step that is none, and why, in a file that is JSON.
fn wrong_step(bytes: &[u8]) -> Option<String> {
    let file: serde_json::Value = serde_json::from_slice(bytes).ok()?;
    let wrong = |(k, step): (usize, &serde_json::Value)| {
        let error = Given::deserialize(step).err()?;
        Some(format!("step {}: {error}", k + 1))
    };
    file.get("steps")?.as_array()?.iter().enumerate().find_map(wrong)
}

impl TryFrom<OwnStep> for Given {
    type Error = String;

    fn try_from(own: OwnStep) -> Result<Self, String> {
        own.is_consistent()?;
        let joints = if own.joints.is_empty() {
            let of = |(vertex, direction): (u32, Axis)| OwnJoint { vertex, direction };
            own.from_vertex.zip(own.direction).map(of).into_iter().collect()
        } else {
            own.joints
        };
        let edges = if own.edges.is_empty() { vec![own.edge] } else { own.edges };
        Ok(Self(GivenStep {
            edges: edges.into_iter().map(EdgeId).collect(),
            kind: own.kind.map(StepKind::from),
            joints: joints
                .into_iter()
                .map(|joint| GivenJoint {
                    vertex: VertexId(joint.vertex),
                    directions: vec![joint.direction.0],
                })
                .collect(),
        }))
    }
}

impl OwnStep {
    /// Of a wire or rod some things are said twice, and a person may have changed only one.
    fn is_consistent(&self) -> Result<(), String> {
        if let Some(first) = self.edges.first().filter(|&&first| first != self.edge) {
            return Err(differ("edge", &self.edge, "'edges' begins with", first));
        }
        let Some(first) = self.joints.first() else { return Ok(()) };
        if let Some(from) = self.from_vertex.filter(|&from| from != first.vertex) {
            return Err(differ("from_vertex", &from, "the first of 'joints' is at", &first.vertex));
        }
        match self.direction {
            Some(Axis(direction)) if (direction - first.direction.0).norm() > SAME_DIRECTION => {
                let of = |axis: Vector3<f64>| format!("[{}, {}, {}]", axis.x, axis.y, axis.z);
                let [direction, joint] = [of(direction), of(first.direction.0)];
                Err(differ("direction", &direction, "the first of 'joints' has", &joint))
            }
            _ => Ok(()),
        }
    }
}

fn differ(key: &str, value: &dyn Display, other: &str, there: &dyn Display) -> String {
    format!("'{key}' is {value}, and {other} {there}: expected the same of both")
}

fn framefab(bytes: &[u8], name: &str, opened: &Opened) -> Result<Vec<GivenStep>, PlanningError> {
    let file = read_sequence(bytes, name)?;
    let tolerance = Length::from_mm(POSITIONS_MM).unwrap_or_default();
    let matched = file.match_edges(&opened.document.wireframe, tolerance);
    let matched = matched.map_err(|error| PlanningError::OtherDesign { name: name.to_owned(), error })?;
    let steps = matched.into_iter().zip(file.steps).map(|(matched, step)| GivenStep {
        edges: vec![matched.edge],
        kind: Some(match step.kind {
            StrutKind::Ground => StepKind::Ground,
            StrutKind::Create => StepKind::Create,
            StrutKind::Connect => StepKind::Connect,
        }),
        joints: vec![GivenJoint { vertex: matched.from, directions: step.directions }],
    });
    Ok(steps.collect())
}

/// The first direction that is free, where there is one, foremost: it is the one that is shown.
pub(super) fn with_free_foremost(mut given: Vec<GivenStep>, checked: &Checked) -> Vec<GivenStep> {
    for (step, first_free) in given.iter_mut().zip(&checked.first_free) {
        for (joint, first) in step.joints.iter_mut().zip(first_free) {
            if let Some(first) = *first {
                joint.directions.swap(0, first);
            }
        }
    }
    given
}
