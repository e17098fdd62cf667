//! `check`: what a machine cannot make of a design, or, where none is named, what no machine can.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_core::checks::Diagnostic;
use wirebend_core::units::Length;
use wirebend_error::ErrorRemedy;

use super::parts::Parts;
use super::{Planned, checked_design};
use crate::choices::PlanChoices;
use crate::design::{DesignInput, Opened};
use crate::report::{DiagnosticReport, NoteReport};
use crate::{Installation, PlanningError, Progress, machine};

#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct CheckRequest {
    pub design: DesignInput,
    /// On which machine, and how; without one the design itself is checked.
    pub choices: PlanChoices,
}

/// What the checks say.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct CheckResponse {
    /// The machine; null where none is named, and the design alone was checked.
    pub machine: Option<String>,
    /// The wire; null where none is named, so that its thickness is not known.
    pub material: Option<String>,
    /// Whether the machine can make it; without one, whether the design itself has no error.
    pub feasible: bool,
    /// Whether it was looked at where the wire meets the machine or itself: only on request, and not without a route.
    pub collisions_checked: bool,
    /// What the checks say, errors first; each is of one wire or of the design.
    pub diagnostics: Vec<DiagnosticReport>,
    /// What was merged, ignored or assumed while reading.
    pub notes: Vec<NoteReport>,
}

pub fn check(
    app: &Installation,
    request: &CheckRequest,
    progress: &dyn Progress,
) -> Result<CheckResponse, PlanningError> {
    let choices = &request.choices;
    let opened =
        app.designed(request.design.open_with(app, choices, progress)?, choices)?.with_wireframe()?;
    if choices.machine.is_none() && opened.document.machine.is_none() {
        return check_without_machine(app, opened, choices);
    }
    let setup = app.setup_connected(app.setup_of(&opened, choices)?)?;
    let planned = Installation::plan_with(opened, setup, choices, progress)?;
    let diagnostics = planned.all_diagnostics().into_iter().map(DiagnosticReport::from).collect();
    Ok(CheckResponse {
        collisions_checked: planned.collisions_checked(),
        machine: Some(planned.setup.machine_id().to_owned()),
        material: Some(planned.setup.material_id().to_owned()),
        feasible: planned.feasible(),
        diagnostics,
        notes: planned.opened.notes,
    })
}

/// The same where no machine is named. Without a wire, too, nothing is said of edges that are too close together.
fn check_without_machine(
    app: &Installation,
    opened: Opened,
    choices: &PlanChoices,
) -> Result<CheckResponse, PlanningError> {
    if needs_machine(choices) {
        return Err(PlanningError::NoMachine { known: app.machine_ids() });
    }
    let of_document = opened.document.material.as_ref().map(|material| material.id.clone());
    let material = choices.material.clone().or(of_document);
    let diameter = match &material {
        Some(material) => machine::mm(app.library.material(material)?.figures()?.diameter_mm)?,
        None => Length::ZERO,
    };
    let components = opened.document.wireframe.components();
    let parts = Parts::of(&opened, &components, choices)?;
    let (of_walks, replaced) = parts.check();
    let mut diagnostics = checked_design(&opened, &components, diameter);
    diagnostics.extend(of_walks);
    diagnostics.sort_by_key(|diagnostic| diagnostic.severity);
    let message = if material.is_some() {
        "no machine is named: only the design itself was checked"
    } else {
        "neither a machine nor a wire is named: only the design itself was checked, and not whether edges are too close together"
    };
    let not_checked = NoteReport {
        code: "machine-not-named".into(),
        count: 1,
        message: message.to_owned(),
        remedies: vec![ErrorRemedy::ChooseMachine { known: app.machine_ids() }],
    };
    Ok(CheckResponse {
        machine: None,
        material,
        feasible: !diagnostics.iter().any(Diagnostic::is_error),
        collisions_checked: false,
        diagnostics: diagnostics.iter().map(DiagnosticReport::from).collect(),
        notes: opened.notes.into_iter().chain(replaced.notes()).chain([not_checked]).collect(),
    })
}

/// Whether something is asked for that only a machine can tell. What the design itself says of sag waits for one.
const fn needs_machine(choices: &PlanChoices) -> bool {
    choices.collisions
        || choices.avoid_collisions
        || choices.sag
        || choices.detours
        || choices.collision_margin_mm.is_some()
}

impl Planned {
    /// What the checks say of all wires and of the design, errors first.
    #[must_use]
    pub fn all_diagnostics(&self) -> Vec<&Diagnostic> {
        let of_wires = self.wires.iter().flat_map(|wire| &wire.diagnostics);
        let mut all: Vec<&Diagnostic> = self.design.iter().chain(of_wires).collect();
        all.sort_by_key(|diagnostic| diagnostic.severity);
        all
    }
}
