//! The cases as jobs for a machine, and what a driver makes of them.

use std::collections::BTreeMap;

use nalgebra::Point3;
use serde_json::Value;
use wirebend_api::{ApiError, DesignInput, DriverProblem, Input, PlanChoices, PlanningError};
use wirebend_core::bend::{Frame, Step, replay};
use wirebend_files::document::{Job, JobContents};

use crate::cases::{self, Case, export, texts};

/// A case's job for a machine.
pub struct Planned {
    pub name: String,
    /// The job's file.
    pub bytes: Vec<u8>,
    pub contents: JobContents,
}

pub struct Wire {
    /// Where it runs along, each point of the design.
    pub path: Vec<Point3<f64>>,
    /// Its ends and the corners between them, in the frame of the design.
    pub corners: Vec<Point3<f64>>,
    /// The program of the design.
    pub nominal: Vec<Step>,
    /// What is sent to the machine, in canonical signs.
    pub compensated: Vec<Step>,
}

impl Planned {
    fn new(name: &str, bytes: Vec<u8>) -> Self {
        let contents = Job::open(&bytes, name).unwrap().contents().clone();
        Self { name: name.to_owned(), bytes, contents }
    }

    pub fn input(&self) -> DesignInput {
        let bytes = Input::Bytes { name: format!("{}.wbjob", self.name), bytes: self.bytes.clone() };
        DesignInput { input: bytes, ..DesignInput::file(cases::root()) }
    }

    pub fn wires(&self) -> Vec<Wire> {
        let wire = |wire: &wirebend_files::document::JobWire| {
            let path: Vec<Point3<f64>> = wire.path_mm.iter().copied().map(Point3::from).collect();
            let ends = wire.spans.iter().map(|span| path[span[1]]);
            let corners = std::iter::once(path[0]).chain(ends).collect();
            let steps = |steps: &[wirebend_files::document::JobStep]| {
                steps.iter().map(|&step| Step::try_from(step).unwrap()).collect()
            };
            Wire { corners, nominal: steps(&wire.nominal), compensated: steps(&wire.compensated), path }
        };
        self.contents.wires.iter().map(wire).collect()
    }
}

impl Wire {
    /// The wire that steps bend in place of the design's, from the design's start.
    pub fn made_by(&self, steps: &[Step]) -> Vec<Point3<f64>> {
        let start = self.corners[0];
        let first = self.corners[1] - start;
        let directions = self.corners.windows(2).map(|pair| (pair[1] - pair[0]).normalize());
        // n looks to the side of the first bend that has one.
        let side = directions.clone().find(|next| first.normalize().cross(next).norm() > 1e-6);
        replay(Frame::looking(start, first, side.unwrap_or_default()).unwrap(), steps)
    }
}

/// What became of all cases in a format.
#[derive(Debug, Default)]
pub struct Outcomes {
    /// How many were written, and looked at.
    pub written: usize,
    /// Cases that have no job for the machine, and the stage that they do not reach.
    pub not_planned: BTreeMap<String, &'static str>,
    /// Cases that the driver refuses: code and message.
    pub refused: BTreeMap<String, (String, String)>,
}

impl Outcomes {
    /// Asserts how many were written, and which were not: with the stage that they do not reach, or the code and the
    /// place of the driver's refusal. Together these are all cases.
    #[track_caller]
    pub fn assert(&self, written: usize, not_planned: &[(&str, &str)], refused: &[(&str, &str, &str)]) {
        let found: Vec<(&str, &str)> =
            self.not_planned.iter().map(|(name, stage)| (name.as_str(), *stage)).collect();
        assert_eq!(found, not_planned);
        let names: Vec<&str> = self.refused.keys().map(String::as_str).collect();
        assert_eq!(names, refused.iter().map(|(name, ..)| *name).collect::<Vec<_>>(), "{:?}", self.refused);
        for (name, code, place) in refused {
            let (found, message) = &self.refused[*name];
            assert!(
                found == code && message.starts_with(&format!("{place}: ")),
                "{name}: {found}: {message}"
            );
        }
        assert_eq!(self.written, written);
        assert_eq!(written + not_planned.len() + refused.len(), cases::all().len());
    }
}

/// Has every case written and hands what was written to `look`.
pub fn each_case(
    machine: &str,
    format: &str,
    settings: &Value,
    mut look: impl FnMut(&Planned, &[Wire], &[String]),
) -> Outcomes {
    let mut outcomes = Outcomes::default();
    for (name, _, case) in cases::all() {
        let Some(bytes) = case.job(machine) else {
            outcomes.not_planned.insert(name, stage_not_reached(&case, machine, format));
            continue;
        };
        let planned = Planned::new(&name, bytes);
        match export(planned.input(), PlanChoices::default(), format, settings) {
            Ok(found) => {
                assert_eq!((found.format.as_str(), found.machine.as_str()), (format, machine), "{name}");
                let (wires, texts) = (planned.wires(), texts(&found));
                let known = case.facts["wires"].as_u64().unwrap_or(1);
                assert_eq!((texts.len() as u64, wires.len()), (known, texts.len()), "{name}: a file a wire");
                look(&planned, &wires, &texts);
                outcomes.written += 1;
            }
            Err(ApiError::Planning(PlanningError::Driver(DriverProblem::Unwritten {
                error,
                format: of,
                ..
            }))) if of == format => {
                outcomes.refused.insert(name, (error.code, error.message));
            }
            Err(error) => panic!("{name} as {format}: {error}"),
        }
    }
    outcomes
}

/// A design that cannot be planned for a machine is not written for it either.
fn stage_not_reached(case: &Case, machine: &str, format: &str) -> &'static str {
    match case.export(machine, format) {
        Err(ApiError::Planning(PlanningError::StageNotReached { stage, .. })) => stage.as_str(),
        other => panic!("{}: {other:?}", case.about),
    }
}
