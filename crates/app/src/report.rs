//! What commands answer: plain values with units in their names, made for JSON.

use schemars::JsonSchema;
use serde::Serialize;
use std::borrow::Cow;
use std::collections::BTreeMap;
use wirebend_core::bend::Step;
use wirebend_core::checks::{Diagnostic, Quantity, Severity};
use wirebend_core::plan::WirePlan;
use wirebend_core::units::Length;
use wirebend_core::wireframe::{EdgeId, Wireframe};
use wirebend_files::read::Note;

use crate::machine::Setup;

/// Something that a reader merged, ignored or assumed.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
pub struct NoteReport {
    /// What it is about.
    pub code: Cow<'static, str>,
    /// How many there were.
    pub count: usize,
    /// A sentence.
    pub message: String,
}

impl From<&Note> for NoteReport {
    fn from(note: &Note) -> Self {
        Self { code: note.kind.code().into(), count: note.count, message: note.to_string() }
    }
}

/// An angle as people read it: what is shown as zero has no sign.
#[must_use]
pub fn shown_deg(deg: f64) -> f64 {
    if deg.abs() < 0.05 { 0.0 } else { deg }
}

/// Feed, then rotate, then bend.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct StepReport {
    /// Feed, in mm.
    pub feed_mm: f64,
    /// Turn about the wire, in degrees, right-handed about the direction of travel.
    pub rotate_deg: f64,
    /// Bend, in degrees.
    pub bend_deg: f64,
}

impl From<&Step> for StepReport {
    fn from(step: &Step) -> Self {
        Self { feed_mm: step.feed.mm(), rotate_deg: step.rotate.deg(), bend_deg: step.bend.deg() }
    }
}

/// How bad it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum SeverityName {
    /// The machine cannot make it.
    Error,
    /// Near a limit, or worth a look.
    Warning,
    /// Good to know.
    Info,
}

/// One thing to know.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct DiagnosticReport {
    /// What it is about: a name that stays the same.
    pub code: &'static str,
    /// How bad it is.
    pub severity: SeverityName,
    /// The vertex that it is about foremost.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub vertex: Option<u32>,
    /// The edge that it is about foremost.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub edge: Option<u32>,
    /// The step of the program, counted from 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub step: Option<usize>,
    /// All its vertices, where there are several.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub vertices: Vec<u32>,
    /// All its edges, where there are several.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub edges: Vec<u32>,
    /// What was measured, in `unit`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub value: Option<f64>,
    /// The limit, in `unit`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub limit: Option<f64>,
    /// The unit of value and limit: `mm`, `deg`, or none for a count.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub unit: Option<&'static str>,
    /// Where the limit comes from.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub limit_source: Option<String>,
    /// What it is.
    pub message: String,
    /// What to do.
    pub help: String,
}

impl From<&Diagnostic> for DiagnosticReport {
    fn from(diagnostic: &Diagnostic) -> Self {
        let several = |ids: Vec<u32>| if ids.len() > 1 { ids } else { Vec::new() };
        let vertices: Vec<u32> = diagnostic.place.vertices.iter().map(|id| id.0).collect();
        let edges: Vec<u32> = diagnostic.place.edges.iter().map(|id| id.0).collect();
        let limit = diagnostic.limit.as_ref();
        Self {
            code: diagnostic.code.as_str(),
            severity: match diagnostic.severity {
                Severity::Error => SeverityName::Error,
                Severity::Warning => SeverityName::Warning,
                Severity::Info => SeverityName::Info,
            },
            vertex: vertices.first().copied(),
            edge: edges.first().copied(),
            step: diagnostic.place.step,
            vertices: several(vertices),
            edges: several(edges),
            value: diagnostic.measured.map(|measured| number(measured).0),
            limit: limit.map(|limit| number(limit.value).0),
            unit: diagnostic.measured.or(limit.map(|limit| limit.value)).and_then(|q| number(q).1),
            limit_source: limit.map(|limit| limit.source.clone()),
            message: diagnostic.message.clone(),
            help: diagnostic.help.clone(),
        }
    }
}

#[allow(clippy::cast_precision_loss)] // counts are far below 2^52
fn number(quantity: Quantity) -> (f64, Option<&'static str>) {
    match quantity {
        Quantity::Length(length) => (length.mm(), Some("mm")),
        Quantity::Angle(angle) => (angle.deg(), Some("deg")),
        Quantity::Count(count) => (count as f64, None),
    }
}

/// How large the part of the wireframe is that a wire covers.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
pub struct WireframeReport {
    /// Vertices of this wire.
    pub vertices: usize,
    /// Edges of this wire.
    pub edges: usize,
    /// Components of the whole wireframe.
    pub components: usize,
    /// Vertices of this wire with an odd number of edges, before any is doubled.
    pub odd_vertices: usize,
}

/// The walk along every edge.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct RouteReport {
    /// How many edges are travelled, each time counted.
    pub feeds: usize,
    /// Designed length of the wire, in mm: from vertex to vertex, before bends shorten it.
    pub length_mm: f64,
    /// How many edges are travelled twice.
    pub doubled_edges: usize,
    /// What they add, in mm.
    pub doubled_mm: f64,
    /// Whether no other choice of edges adds less.
    pub optimal: bool,
    /// The edges that are travelled twice.
    pub doubled: Vec<u32>,
    /// The vertices in the order of the walk.
    pub vertices: Vec<u32>,
    /// The edges in the order of the walk.
    pub edges: Vec<u32>,
}

/// The program of the design itself.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct ProgramReport {
    /// How many steps bend the wire.
    pub bends: usize,
    /// The steps.
    pub steps: Vec<StepReport>,
}

/// What the machine is told.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct CompensatedReport {
    /// The steps, in canonical signs.
    pub steps: Vec<StepReport>,
    /// All feeds together, in mm.
    pub feed_mm: f64,
    /// Stock to load, in mm: all feeds and the tail that cannot be fed.
    pub stock_mm: f64,
}

/// One wire through all stages. A stage that was not reached is null; the diagnostics say why.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct WireReport {
    /// What it covers.
    pub wireframe: WireframeReport,
    /// Its route.
    pub route: Option<RouteReport>,
    /// Its nominal program.
    pub program: Option<ProgramReport>,
    /// Its compensated program.
    pub compensated: Option<CompensatedReport>,
    /// What the checks say.
    pub diagnostics: Vec<DiagnosticReport>,
    /// Whether the machine can make it.
    pub feasible: bool,
    /// Time on the machine, in s.
    pub time_s: Option<f64>,
    /// Price of the wire that is fed, in `currency`; null where the price is not known, and where nothing can be fed.
    pub cost: Option<f64>,
    /// The same of the stock, which has the tail that cannot be fed.
    pub stock_cost: Option<f64>,
    /// Of the cost.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub currency: Option<String>,
    /// Mass of the wire that is fed, in g.
    pub mass_g: Option<f64>,
    /// Mass of the stock, in g.
    pub stock_mass_g: Option<f64>,
    /// What each stage took, in ms.
    pub timings_ms: BTreeMap<&'static str, f64>,
}

/// A planned design: its wire, or several.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum PlanReport {
    /// A design of one wire.
    One(Box<WireReport>),
    /// A design that is not connected, or has nothing to bend.
    Several {
        /// The wires.
        wires: Vec<WireReport>,
        /// What the checks say of the design as a whole.
        diagnostics: Vec<DiagnosticReport>,
        /// Whether the machine can make all of them.
        feasible: bool,
    },
}

impl PlanReport {
    /// The wires.
    #[must_use]
    pub fn wires(&self) -> &[WireReport] {
        match self {
            Self::One(wire) => std::slice::from_ref(wire),
            Self::Several { wires, .. } => wires,
        }
    }

    /// What the checks say of the design as a whole, where it is not said of its only wire.
    #[must_use]
    pub fn diagnostics(&self) -> &[DiagnosticReport] {
        match self {
            Self::One(_) => &[],
            Self::Several { diagnostics, .. } => diagnostics,
        }
    }

    /// Whether the machine can make it.
    #[must_use]
    pub fn feasible(&self) -> bool {
        match self {
            Self::One(wire) => wire.feasible,
            Self::Several { feasible, .. } => *feasible,
        }
    }
}

impl WireReport {
    /// The report of a planned wire.
    pub(crate) fn new(
        wireframe: &Wireframe,
        components: usize,
        plan: &WirePlan,
        setup: &Setup,
        timings_ms: BTreeMap<&'static str, f64>,
    ) -> Self {
        let fed = plan.compensated.as_ref().map(wirebend_core::compensate::CompensatedProgram::feed_total);
        let wire = &setup.model.wire;
        let ids = |edges: &[EdgeId]| edges.iter().map(|id| id.0).collect();
        let length_of = |edges: &mut dyn Iterator<Item = EdgeId>| -> Length {
            edges.map(|edge| wireframe.edge_length(edge)).sum()
        };
        let doubled_mm = plan.doubled_length(wireframe).mm();
        Self {
            wireframe: WireframeReport {
                vertices: plan.component.vertices.len(),
                edges: plan.component.edges.len(),
                components,
                odd_vertices: wireframe.odd_vertices(&plan.component, &[]).len(),
            },
            route: plan.route.as_ref().map(|route| RouteReport {
                feeds: route.traversals.len(),
                length_mm: length_of(&mut route.traversals.iter().map(|t| t.edge)).mm(),
                doubled_edges: plan.doubled.len(),
                doubled_mm,
                optimal: doubled_mm <= plan.proposal.added.mm() + 1e-6,
                doubled: ids(&plan.doubled),
                vertices: route.vertices().iter().map(|id| id.0).collect(),
                edges: route.traversals.iter().map(|t| t.edge.0).collect(),
            }),
            program: plan.nominal.as_ref().map(|program| ProgramReport {
                bends: program.bend_count(),
                steps: program.steps.iter().map(StepReport::from).collect(),
            }),
            compensated: plan.compensated.as_ref().zip(plan.stock).map(|(program, stock)| {
                CompensatedReport {
                    steps: program.steps().iter().map(StepReport::from).collect(),
                    feed_mm: program.feed_total().mm(),
                    stock_mm: stock.mm(),
                }
            }),
            diagnostics: plan.diagnostics.iter().map(DiagnosticReport::from).collect(),
            feasible: plan.is_feasible(),
            time_s: plan.seconds,
            cost: fed.and_then(|fed| wire.cost(fed)),
            stock_cost: plan.stock.and_then(|stock| wire.cost(stock)),
            currency: setup.currency.clone(),
            mass_g: fed.map(|fed| wire.mass_g(fed)),
            stock_mass_g: plan.stock.map(|stock| wire.mass_g(stock)),
            timings_ms,
        }
    }
}
