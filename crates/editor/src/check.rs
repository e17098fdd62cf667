//! What the checks say of the open design, as it is or as it would be while a person drags.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_core::wireframe::{Edit, VertexId};
use wirebend_files::document::Document;

use super::{Editor, Names};
use crate::EditorError;
use wirebend_planning::PlanChoices;
use wirebend_planning::PlanningError;
use wirebend_planning::design::Opened;
use wirebend_planning::machine::Setup;
use wirebend_planning::plan::Planned;
use wirebend_planning::report::{DiagnosticReport, SagReport, WireReport};
use wirebend_planning::{Installation, NoProgress};

/// A vertex that is being dragged, and where it is.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Moved {
    pub vertex: u32,
    pub at_mm: [f64; 3],
}

/// What the status bar shows of a wire.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct WireFigures {
    /// Designed length, mm; null where there is no route.
    pub length_mm: Option<f64>,
    /// Stock to load, mm.
    pub stock_mm: Option<f64>,
    /// How many steps bend the wire.
    pub bends: Option<usize>,
    /// Time on the machine, s.
    pub time_s: Option<f64>,
    /// Price of the wire that is fed.
    pub cost: Option<f64>,
    /// Price of the stock, which has the tail that cannot be fed.
    pub stock_cost: Option<f64>,
    /// Of the cost.
    pub currency: Option<String>,
    /// Mass of the wire that is fed, g.
    pub mass_g: Option<f64>,
    /// How far the part already bent sags while it is bent; null where the design does not ask for it, or nothing is bent.
    pub sag: Option<SagReport>,
    /// The vertices in the order of the walk.
    pub route: Vec<u32>,
}

/// What the checks say.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct LiveCheck {
    /// Whether the machine can make it.
    pub feasible: bool,
    /// Errors first.
    pub diagnostics: Vec<DiagnosticReport>,
    /// One for each wire: the wires of a part that is not joined to others follow one another.
    pub wires: Vec<WireFigures>,
    /// Why limits of the machine are not known, where they are not.
    pub limits_unknown: Option<String>,
}

impl Editor {
    /// Checks the design on its machine, with some vertices elsewhere than they are. Nothing is changed.
    ///
    /// # Errors
    /// [`EditorError::Planning`] where none is chosen; [`EditorError`] when a vertex is not there or goes nowhere.
    pub fn check(&mut self, app: &Installation, moved: &[Moved]) -> Result<LiveCheck, EditorError> {
        let document = self.moved_part(moved)?;
        let (names, setup) = self.take_setup(app)?;
        let opened = Opened::of(self.name.clone(), document);
        let planned = Installation::plan_with(opened, setup, &PlanChoices::default(), &NoProgress)?;
        let check = LiveCheck::of(&planned);
        self.setup = Some((names, planned.setup));
        Ok(check)
    }

    /// Machine and material of the design, which are to be put back.
    pub(super) fn take_setup(&mut self, app: &Installation) -> Result<(Names, Setup), EditorError> {
        let machine = self.document.machine.as_ref().map(|machine| machine.id.clone());
        let machine = machine.ok_or_else(|| PlanningError::NoMachine { known: app.machine_ids() })?;
        let material = self.document.material.as_ref().map(|material| material.id.clone());
        let names = (machine, material);
        let board = app.boards.of(&names.0);
        let known = self.setup.take().filter(|(asked, setup)| *asked == names && setup.driver.board == board);
        let setup = match known {
            Some((_, setup)) => setup,
            None => app.setup_connected(app.setup(&names.0, names.1.as_deref())?)?,
        };
        Ok((names, setup))
    }

    /// The design without its stencils, which are no part of what is bent.
    pub fn without_stencils(&self) -> Document {
        Document { stencils: Vec::new(), surfaces: BTreeMap::new(), ..self.document.clone() }
    }

    /// What is planned of the design, with some vertices elsewhere than they are.
    pub(super) fn moved_part(&self, moved: &[Moved]) -> Result<Document, EditorError> {
        let mut document = self.planned_part();
        for &Moved { vertex, at_mm } in moved {
            let edit = Edit::Place { vertex: VertexId(vertex), position: at_mm.into() };
            document.wireframe.apply(&edit).map_err(EditorError::from)?;
        }
        Ok(document)
    }

    /// What is planned of the design: stencils are no part of what is bent.
    pub(super) fn planned_part(&self) -> Document {
        Document {
            doublings: self.document.doublings.clone(),
            start: self.document.start,
            wires: self.document.wires,
            closed: self.document.closed,
            reversed: self.document.reversed,
            walks: self.document.walks.clone(),
            collisions: self.document.collisions,
            ..Document::new(self.document.wireframe.clone())
        }
    }
}

impl LiveCheck {
    pub(super) fn of(planned: &Planned) -> Self {
        Self {
            feasible: planned.feasible(),
            diagnostics: planned.all_diagnostics().into_iter().map(DiagnosticReport::from).collect(),
            wires: planned.report().wires().iter().map(WireFigures::of).collect(),
            limits_unknown: planned.setup.driver.note.as_ref().map(|note| note.message.clone()),
        }
    }
}

impl WireFigures {
    fn of(wire: &WireReport) -> Self {
        Self {
            length_mm: wire.route.as_ref().map(|route| route.length_mm),
            stock_mm: wire.compensated.as_ref().map(|program| program.stock_mm),
            bends: wire.program.as_ref().map(|program| program.bends),
            time_s: wire.time_s,
            cost: wire.cost,
            stock_cost: wire.stock_cost,
            currency: wire.currency.clone(),
            mass_g: wire.mass_g,
            sag: wire.sag,
            route: wire.route.as_ref().map(|route| route.vertices.clone()).unwrap_or_default(),
        }
    }
}
