//! The wires of a job as they are: played, and held against the limits of its machine. Nothing is planned anew.

use std::time::{Duration, Instant};

use nalgebra::Point3;
use wirebend_core::bend::{NominalProgram, program_of_path};
use wirebend_core::checks::Diagnostic;
use wirebend_core::compensate::CompensatedProgram;
use wirebend_core::plan::{WirePlan, check_given, clearance, keep_contacts};
use wirebend_core::route::{Doubling, Route};
use wirebend_core::schedule::ScheduledProgram;
use wirebend_core::units::{Angle, Length};
use wirebend_core::wireframe::{Component, Vertex, VertexId, Wireframe};
use wirebend_files::document::{Job, JobPause, JobWire};

use crate::PlanningError;
use crate::contacts::{PATIENCE, first_contacts, not_searched};
use crate::job::contact_options;
use crate::machine::{Setup, kept_steps, told_steps};
use crate::pauses;
use crate::playback::{PlayedWire, played};
use crate::report::{DiagnosticReport, NoteReport, PlanReport, WireReport};

/// The wires of a job, each with the stages that the job has kept.
pub struct GivenWires {
    wires: Vec<(Wireframe, WirePlan)>,
    pauses: Vec<Vec<JobPause>>,
}

impl GivenWires {
    /// `name`: of the job, for errors; `setup`: its machine and material.
    pub fn of(name: &str, job: &Job, setup: &Setup) -> Result<Self, PlanningError> {
        let kept = &job.contents().wires;
        let wires = kept.iter().map(|wire| given(name, wire, setup)).collect::<Result<_, _>>()?;
        Ok(Self { wires, pauses: kept.iter().map(|wire| wire.pauses.clone()).collect() })
    }

    /// The wires as they are played. Their vertices and edges are those of no open design.
    #[must_use]
    pub fn played(&self, setup: &Setup) -> Vec<PlayedWire> {
        let mut wires: Vec<PlayedWire> =
            self.wires.iter().filter_map(|(_, plan)| played(plan, &setup.model.time)).collect();
        for step in wires.iter_mut().flat_map(|wire| &mut wire.steps) {
            (step.vertex, step.edges) = (None, Vec::new());
        }
        for (wire, pauses) in wires.iter_mut().zip(&self.pauses) {
            pauses::show(pauses, wire);
        }
        wires
    }

    /// Looks where the wires meet the machine or themselves, for as long as a person waits for it, and adds what the checks say of
    /// it. A note says so where that was not enough.
    pub fn find_collisions(&mut self, setup: &Setup) -> Option<NoteReport> {
        self.find_collisions_within(PATIENCE, setup)
    }

    fn find_collisions_within(&mut self, patience: Duration, setup: &Setup) -> Option<NoteReport> {
        let until = Instant::now() + patience;
        let steps = |plan: &WirePlan| plan.scheduled.as_ref().map_or(0, |program| program.steps.len());
        let of = self.wires.iter().map(|(_, plan)| steps(plan)).sum();
        let mut done = 0;
        for (wireframe, plan) in &mut self.wires {
            let Some(clearance) = clearance(wireframe, &setup.model, plan) else { continue };
            let mut reached = done;
            let searched = first_contacts(&clearance, |step| {
                reached = done + step;
                Instant::now() < until
            });
            let contacts = Some(searched.contacts);
            let findings = keep_contacts(wireframe, &setup.model, plan, contacts);
            plan.diagnostics.extend(findings.into_iter().map(as_it_is));
            plan.diagnostics.sort_by_key(|diagnostic| diagnostic.severity);
            if !searched.whole {
                plan.contacts = None;
                return Some(not_searched(reached, of));
            }
            done += steps(plan);
        }
        // A wire that could not be looked at is not clear.
        (done < of).then(|| not_searched(done, of))
    }

    /// What the checks say of all wires, errors first.
    pub fn findings(&self) -> impl Iterator<Item = &Diagnostic> {
        self.wires.iter().flat_map(|(_, plan)| &plan.diagnostics)
    }

    /// Whether the machine can make all of them.
    #[must_use]
    pub fn feasible(&self) -> bool {
        self.wires.iter().all(|(_, plan)| plan.is_feasible())
    }

    /// The same as a report.
    #[must_use]
    pub fn report(&self, setup: &Setup) -> PlanReport {
        let report = |((wireframe, plan), pauses): (&(Wireframe, WirePlan), &Vec<JobPause>)| {
            WireReport::new(
                wireframe,
                self.wires.len(),
                plan,
                pauses,
                setup,
                std::collections::BTreeMap::new(),
            )
        };
        let mut wires: Vec<WireReport> = self.wires.iter().zip(&self.pauses).map(report).collect();
        if wires.len() == 1 {
            return PlanReport::One(Box::new(wires.remove(0)));
        }
        let diagnostics: Vec<DiagnosticReport> = Vec::new();
        PlanReport::Several { wires, diagnostics, feasible: self.feasible() }
    }
}

fn given(name: &str, wire: &JobWire, setup: &Setup) -> Result<(Wireframe, WirePlan), PlanningError> {
    let damaged = |reason: String| PlanningError::DamagedJob { name: name.to_owned(), reason };
    let path: Vec<Point3<f64>> = wire.path_mm.iter().copied().map(Point3::from).collect();
    let order: Vec<VertexId> = wire.vertices.iter().copied().map(VertexId).collect();
    let wireframe = wireframe(&path, &order).map_err(|error| damaged(error.to_string()))?;
    let route =
        Route::through(&wireframe, &order).ok_or_else(|| damaged("its wire stays at a vertex".to_owned()))?;
    let (start, _) =
        program_of_path(&path, setup.model.straight).map_err(|error| damaged(error.to_string()))?;
    let steps = kept_steps(&wire.scheduled)?;
    let mut head = Angle::ZERO;
    let turned = steps.iter().map(|step| {
        head += step.rotate;
        head
    });
    let head = turned.collect();
    let mut plan = WirePlan {
        component: Component {
            vertices: wireframe.vertices().map(|(id, _)| id).collect(),
            edges: wireframe.edges().map(|(id, _)| id).collect(),
        },
        doubled: route.traversals.iter().filter(|along| along.again).map(|along| along.edge).collect(),
        proposal: Doubling::default(),
        is_cheapest: true,
        beside: Vec::new(),
        route: Some(route),
        path,
        start,
        nominal: Some(NominalProgram {
            steps: kept_steps(&wire.nominal)?,
            spans: wire.spans.iter().map(|&[from, to]| from..to).collect(),
        }),
        scheduled: Some(ScheduledProgram { steps, head }),
        compensated: Some(CompensatedProgram::from_job_steps(
            told_steps(&wire.compensated)?,
            &setup.model.compensation,
        )),
        searched: None,
        sag: None,
        contact_options: contact_options(wire)?,
        contacts: None,
        diagnostics: Vec::new(),
        seconds: Some(wire.time_s),
        stock: Some(Length::from_mm(wire.stock_mm).unwrap_or_default()),
    };
    plan.diagnostics = check_given(&wireframe, &setup.model, &plan).into_iter().map(as_it_is).collect();
    Ok((wireframe, plan))
}

/// Without the remedies that plan the wire anew: here it is run as it is.
fn as_it_is(mut finding: Diagnostic) -> Diagnostic {
    finding.remedies.retain(|remedy| !remedy.plans_anew());
    finding
}

/// The struts of a wire: a vertex for each id, an edge for each two that follow one another.
fn wireframe(
    path: &[Point3<f64>],
    order: &[VertexId],
) -> Result<Wireframe, wirebend_core::wireframe::WireframeError> {
    let mut wireframe = Wireframe::new();
    for (&point, &id) in path.iter().zip(order) {
        if wireframe.vertex(id).is_none() {
            wireframe.insert_vertex(id, Vertex::at(point))?;
        }
    }
    for pair in order.windows(2) {
        let joined = wireframe
            .incident(pair[0])
            .iter()
            .any(|&edge| wireframe.edge(edge).is_some_and(|ends| ends.other(pair[0]) == pair[1]));
        if pair[0] != pair[1] && !joined {
            wireframe.add_edge(pair[0], pair[1])?;
        }
    }
    Ok(wireframe)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::as_given::{ProgramMachine, job_of_file};
    use crate::design::DesignInput;
    use crate::{Installation, NoProgress, PlanChoices};

    /// A person would be sent to options that running a program does not have.
    #[test]
    fn nothing_is_advised_for_a_program_that_would_plan_it_anew() {
        let app = Installation::new(&[]).unwrap();
        let setup = app.setup("wirebend-kit", None).unwrap();
        let of = ProgramMachine { machine: Some("wirebend-kit"), material: None };
        for (text, advised) in [
            ("F 50\nB 200\nF 50\n", &["open the angle between the two edges"][..]),
            ("F 50\nB 90\nB 20\nF 50\n", &["move the edges apart"]),
        ] {
            let job = job_of_file(&app, "bends.txt", text.as_bytes(), of).unwrap();
            let mut given = GivenWires::of("bends.txt", &job, &setup).unwrap();
            assert_eq!(given.find_collisions(&setup), None);
            let helps: Vec<String> = given.findings().map(crate::text::help).collect();
            for advice in advised {
                assert!(helps.iter().any(|help| help == advice), "{helps:?}");
            }
            for advice in ["start the wire", "search for a program", "several wires"] {
                assert!(!helps.iter().any(|help| help.contains(advice)), "{helps:?}");
            }
        }
    }

    /// As it stands its axes go there: what a design would need of them is another matter.
    #[test]
    fn a_program_is_held_against_what_the_axes_can_do() {
        let app = Installation::new(&[]).unwrap();
        let mut setup = app.setup("wirebend-kit", None).unwrap();
        setup.model.compensation.bend.axis_limit = Angle::from_deg(110.0).ok();
        let of = ProgramMachine { machine: Some("wirebend-kit"), material: None };
        let turns = |by: &str| format!("F 60\nB 60\n{}F 60\n", format!("F 60\nR {by}\nB 60\n").repeat(2));
        for (text, found) in [
            (turns("180"), None),
            (turns("180.1"), Some(("rotation_out_of_range", "the head is sent to 360.20°"))),
            (turns("-180.1"), Some(("rotation_out_of_range", "the head is sent to -360.20°"))),
            ("F 60\nB 110\nF 60\n".to_owned(), None),
            ("F 60\nB -110.4\nF 60\n".to_owned(), Some(("bend_out_of_reach", "is -90.00°, out of reach"))),
        ] {
            let job = job_of_file(&app, "axes.txt", text.as_bytes(), of).unwrap();
            let given = GivenWires::of("axes.txt", &job, &setup).unwrap();
            let codes = ["rotation_out_of_range", "bend_out_of_reach"];
            let named = given.findings().find(|finding| codes.contains(&finding.code().as_str()));
            match (named, found) {
                (None, None) => {}
                (Some(named), Some((code, words))) => {
                    assert_eq!(named.code().as_str(), code, "{text}");
                    let message = crate::text::message(named);
                    assert!(named.is_error() && message.contains(words), "{message}");
                }
                (named, _) => panic!("{text}: {named:?}"),
            }
        }
    }

    /// The second wire counts as not looked at, too: it may collide as well as the first.
    #[test]
    fn a_search_of_given_wires_that_takes_too_long_is_said_to_have_no_end() {
        let app = Installation::new(&[]).unwrap();
        let example = format!("{}/../../examples/two-parts.obj", env!("CARGO_MANIFEST_DIR"));
        let opened = DesignInput::file(example.into()).open(&NoProgress).unwrap();
        let choices = PlanChoices { machine: Some("wirebend-kit".into()), ..PlanChoices::default() };
        let planned = app.plan_design(opened, &choices, &NoProgress).unwrap();
        let job = planned.job().unwrap().unwrap();
        let steps: usize = job.contents().wires.iter().map(|wire| wire.scheduled.len()).sum();
        let mut given = GivenWires::of("two parts", &job, &planned.setup).unwrap();
        let note = given.find_collisions_within(Duration::ZERO, &planned.setup).unwrap();
        assert_eq!(note.message, format!("collisions not fully searched: 0 of {steps} steps in 10 s"));
        assert!(given.wires.iter().all(|(_, plan)| plan.contacts.is_none()));
        assert_eq!(given.find_collisions_within(Duration::from_mins(1), &planned.setup), None);
        assert!(given.wires.iter().all(|(_, plan)| plan.contacts.is_some()));
    }
}
