//! Pause points of a design: after which step of which wire the machine waits for a person.

use std::num::NonZeroU32;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_core::plan::WirePlan;
use wirebend_core::route::Route;
use wirebend_core::wireframe::VertexId;
use wirebend_files::document::{JobPause, PausePoint, pause_note};

use crate::PlanningError;
use crate::playback::{PausePlace, PlayedWire};
use crate::report::NoteReport;

/// A step after which the machine is to wait for a person.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StepPause {
    /// Index of the wire, from 0.
    #[serde(default)]
    pub wire: usize,
    /// The step, from 1.
    pub after: u32,
    /// What the person has to do.
    pub note: String,
}

/// A pause point of the design after which nothing of a wire is bent.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
pub struct LeftOutPause {
    #[serde(flatten)]
    pub place: PausePlace,
    pub note: String,
    /// Why, for a person.
    pub why: String,
}

/// The pause points of planned wires.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct PlannedPauses {
    /// Of each wire, in the order of its steps.
    pub wires: Vec<Vec<JobPause>>,
    pub left_out: Vec<LeftOutPause>,
}

/// How often the wires before have come to each vertex.
#[derive(Default)]
struct Passes(std::collections::BTreeMap<VertexId, NonZeroU32>);

impl Passes {
    /// The next time that a wire comes to a vertex.
    fn next(&mut self, vertex: VertexId) -> PausePlace {
        let pass = self.0.get(&vertex).map_or(NonZeroU32::MIN, |pass| pass.saturating_add(1));
        self.0.insert(vertex, pass);
        PausePlace { vertex: vertex.0, pass }
    }
}

/// The places of each wire along its path; none of a wire without a route.
fn places(wires: &[WirePlan]) -> Vec<Vec<PausePlace>> {
    let mut passes = Passes::default();
    let along = |wire: &WirePlan| {
        let vertices = wire.route.as_ref().map(Route::vertices).unwrap_or_default();
        vertices.into_iter().map(|vertex| passes.next(vertex)).collect()
    };
    wires.iter().map(along).collect()
}

impl PlannedPauses {
    /// Where the pause points of a design come in its wires: after the step that brings the wire to the vertex or, where it runs
    /// straight on, past it.
    pub fn of(points: &[PausePoint], wires: &[WirePlan]) -> Self {
        let places = places(wires);
        let mut planned = Self { wires: vec![Vec::new(); wires.len()], left_out: Vec::new() };
        // Of a wire without a program the checks say why.
        if wires.iter().any(|wire| wire.nominal.is_none()) {
            return planned;
        }
        for PausePoint { vertex, pass, note } in points {
            let place = PausePlace { vertex: vertex.0, pass: *pass };
            let found = places
                .iter()
                .enumerate()
                .find_map(|(wire, along)| Some((wire, along.iter().position(|other| *other == place)?)));
            let after = found.map(|(wire, at)| (wire, step_to(&wires[wire], at)));
            match after {
                Some((wire, Some(after))) => planned.add(wire, after, note),
                Some((_, None)) => {
                    let begins = found.is_some_and(|(_, at)| at == 0);
                    let why = if begins { "a wire begins there" } else { "a wire ends there" };
                    planned.leave_out(place, note, why.to_owned());
                }
                None => planned.leave_out(place, note, never(place)),
            }
        }
        planned
    }

    /// Adds what was asked for with a plan.
    ///
    /// # Errors
    /// [`PlanningError::Value`] for a wire or a step that is not there, and for a note that says nothing.
    pub fn and(mut self, asked: &[StepPause], wires: &[WirePlan]) -> Result<Self, PlanningError> {
        let wrong =
            |name, value: String, expected| PlanningError::Value { input: None, name, value, expected };
        for StepPause { wire, after, note } in asked {
            let Some(plan) = wires.get(*wire) else {
                let expected = "one of the wires of the plan";
                return Err(wrong("the wire of a pause", wire.saturating_add(1).to_string(), expected));
            };
            let steps = plan.nominal.as_ref().map_or(0, |program| program.steps.len());
            if !(1..steps).contains(&(*after as usize)) {
                let expected = "a step of the wire before its last one, counted from 1";
                return Err(wrong("the step of a pause", format!("{after} of {steps}"), expected));
            }
            let Some(note) = pause_note(note) else {
                return Err(wrong("the note of a pause", "empty".to_owned(), "what the person has to do"));
            };
            self.add(*wire, *after, &note);
        }
        Ok(self)
    }

    /// Two at the same step are one, which says both.
    fn add(&mut self, wire: usize, after: u32, note: &str) {
        let pauses = &mut self.wires[wire];
        match pauses.binary_search_by_key(&after, |pause| pause.after) {
            Ok(at) => pauses[at].note = format!("{}; {note}", pauses[at].note),
            Err(at) => pauses.insert(at, JobPause { after, note: note.to_owned() }),
        }
    }

    fn leave_out(&mut self, place: PausePlace, note: &str, why: String) {
        self.left_out.push(LeftOutPause { place, note: note.to_owned(), why });
    }

    /// What was left out, as notes for a person.
    pub fn notes(&self) -> impl Iterator<Item = NoteReport> {
        self.left_out.iter().map(|LeftOutPause { place, note, why }| NoteReport {
            code: "pause-left-out".into(),
            count: 1,
            message: format!("the pause point at vertex {} (\"{note}\") is left out: {why}", place.vertex),
            remedies: Vec::new(),
        })
    }

    /// Writes them into the steps of the wires that are played; of wires of a design with where pause points can be put.
    pub fn show(&self, plans: &[WirePlan], wires: &mut [PlayedWire]) {
        let programs = plans.iter().zip(places(plans)).zip(&self.wires).filter(|((plan, _), _)| {
            // A wire without a program is not played.
            plan.nominal.is_some() && plan.scheduled.is_some()
        });
        for (((plan, along), pauses), wire) in programs.zip(wires) {
            show(pauses, wire);
            let spans = plan.nominal.iter().flat_map(|program| &program.spans);
            let last = wire.steps.len().saturating_sub(1);
            for (step, span) in wire.steps.iter_mut().take(last).zip(spans) {
                step.place = along.get(span.end).copied();
            }
        }
    }
}

/// Writes the pause points of a wire into its steps.
pub(crate) fn show(pauses: &[JobPause], wire: &mut PlayedWire) {
    for JobPause { after, note } in pauses {
        if let Some(step) = wire.steps.get_mut((*after as usize).saturating_sub(1)) {
            step.pause = Some(note.clone());
        }
    }
}

/// The step, from 1, after which the wire has come to a point of its path; none for its two ends.
fn step_to(wire: &WirePlan, at: usize) -> Option<u32> {
    let spans = &wire.nominal.as_ref()?.spans;
    let step = spans.iter().position(|span| span.end >= at).filter(|_| at > 0)?;
    (step + 1 < spans.len()).then(|| u32::try_from(step + 1).ok()).flatten()
}

fn never(PausePlace { pass, .. }: PausePlace) -> String {
    match pass.get() {
        1 => "no wire comes there".to_owned(),
        pass => format!("the wires do not come there {pass} times"),
    }
}

/// Pause points as lines for a person.
pub fn lines(pauses: &[JobPause]) -> impl Iterator<Item = String> {
    pauses.iter().map(|JobPause { after, note }| format!("it waits after step {after}: {note}"))
}

#[cfg(test)]
mod tests;
