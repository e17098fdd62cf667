//! `compare`: the design that is open for one machine, planned for others, and what changes.

use std::collections::BTreeSet;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_core::checks::{Code, Fact, Meeting};
use wirebend_profile::Kind;

use crate::choices::PlanChoices;
use crate::design::DesignInput;
use crate::plan::Planned;
use crate::report::{DiagnosticReport, NoteReport, PlanReport, SeverityName, WireReport};
use crate::{Installation, PlanningError, Progress};

#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct CompareRequest {
    pub design: DesignInput,
    /// The machine that it is open for, and how it is planned on all of them.
    pub choices: PlanChoices,
    /// The other machines, at least one.
    #[schemars(length(min = 1))]
    pub against: Vec<String>,
}

/// The design on several machines.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct CompareResponse {
    /// On the machine that it is open for.
    pub from: MachineSide,
    /// On the others, in the order asked for.
    pub to: Vec<OtherSide>,
    /// What was merged, ignored or assumed while reading, and what to know of the wires; each once.
    pub notes: Vec<NoteReport>,
}

/// A design on one machine. Sums are over all wires, and null where some wire did not get that far.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct MachineSide {
    pub machine: String,
    pub name: String,
    /// The wire in it: the one that was asked for, else the document's, else the machine's own.
    pub material: String,
    /// Whether the machine can make it.
    pub feasible: bool,
    /// How many errors the checks found.
    pub errors: usize,
    /// How many warnings.
    pub warnings: usize,
    /// Where the wires hit the machine or themselves; null where nobody asked, or not every wire has a program.
    pub collisions: Option<CollisionCount>,
    /// How many edges are travelled, each time counted.
    pub feeds: Option<usize>,
    /// How many steps bend the wire.
    pub bends: Option<usize>,
    /// Time on the machine, in s.
    pub time_s: Option<f64>,
    /// Stock to load, in mm.
    pub stock_mm: Option<f64>,
    /// Price of the wire that is fed, in `currency`; null also where the price is not known.
    pub cost: Option<f64>,
    /// Price of the stock to load, in `currency`; null also where the price is not known.
    pub stock_cost: Option<f64>,
    /// Of the costs.
    pub currency: Option<String>,
    /// Mass of the wire that is fed, in g.
    pub mass_g: Option<f64>,
}

/// How many things wires hit while they are bent.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
pub struct CollisionCount {
    /// How many: each body of the machine, and the wire itself, once for each wire.
    pub hits: usize,
    /// How many of them are bodies whose dimensions are estimates.
    pub estimated: usize,
}

impl CollisionCount {
    /// Of a design that was looked at.
    fn of(planned: &Planned) -> Option<Self> {
        let all = planned.wires.iter().flat_map(|wire| &wire.diagnostics);
        let mut count = Self { hits: 0, estimated: 0 };
        for finding in all {
            if finding.fact.meeting().is_some_and(Meeting::hits) {
                count.hits += 1;
                count.estimated +=
                    usize::from(matches!(finding.fact, Fact::MeetsMachine { measured: false, .. }));
            }
        }
        planned.collisions_checked().then_some(count)
    }
}

/// The design on another machine, and what is different there.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct OtherSide {
    /// The design there.
    #[serde(flatten)]
    pub side: MachineSide,
    /// What is more there, or less where negative.
    pub change: Change,
    /// Errors that this machine has and the first one has not.
    pub newly_infeasible: Findings,
    /// Errors of the first machine that this one has not.
    pub newly_feasible: Findings,
    /// Warnings that this machine has and the first one has not.
    pub newly_warned: Findings,
    /// Whether the wire fits the machine.
    pub fits: bool,
    /// The same with the machine's own wire, where that of the design does not fit it, and where its own is based on that of the design, as
    /// a calibrated one is; null where the machine has no other wire, and in the comparison with its own wire.
    pub own_wire: Option<Box<OtherSide>>,
}

/// Differences of sums; null where one of the two is not known.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct Change {
    pub time_s: Option<f64>,
    pub stock_mm: Option<f64>,
    /// Of the cost; null also where the currencies differ.
    pub cost: Option<f64>,
    /// Of the cost of the stock, likewise.
    pub stock_cost: Option<f64>,
    pub mass_g: Option<f64>,
    pub bends: Option<i64>,
}

/// What is found and where it is; ids ascend, each once.
#[derive(Debug, Clone, Default, PartialEq, Serialize, JsonSchema)]
pub struct Findings {
    pub vertices: BTreeSet<u32>,
    pub edges: BTreeSet<u32>,
    pub steps: BTreeSet<WireStep>,
    /// What it is.
    pub diagnostics: Vec<WireDiagnostic>,
}

/// A step of one of the wires.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, JsonSchema)]
pub struct WireStep {
    /// Index of the wire, from 0.
    pub wire: usize,
    /// Index of its step, from 0.
    pub step: usize,
}

/// One thing to know of a wire, or of the design.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct WireDiagnostic {
    /// Index of the wire, from 0; null for the design as a whole.
    pub wire: Option<usize>,
    #[serde(flatten)]
    pub diagnostic: DiagnosticReport,
}

pub fn compare(
    app: &Installation,
    request: &CompareRequest,
    progress: &dyn Progress,
) -> Result<CompareResponse, PlanningError> {
    if request.against.is_empty() {
        let expected = "at least one machine to compare with";
        return Err(PlanningError::Value {
            input: None,
            name: "the list of machines",
            value: "empty".to_owned(),
            expected,
        });
    }
    // A misspelt id is reported before any work is done.
    let others = request.against.iter().map(|machine| app.library.machine(machine));
    let others = others.collect::<Result<Vec<_>, _>>()?;
    let opened = app
        .designed(request.design.open_with(app, &request.choices, progress)?, &request.choices)?
        .with_wireframe()?;
    let from = app.plan_design(opened.copy(), &request.choices, progress)?;
    let mut notes = from.opened.notes.clone();
    let (from, before) = (MachineSide::new(&from), from.report());
    let mut beside = |choices: &PlanChoices| -> Result<OtherSide, PlanningError> {
        let other = app.plan_design(opened.copy(), choices, progress)?;
        let (side, after) = (MachineSide::new(&other), other.report());
        notes.extend(other.opened.notes.into_iter().filter(|note| !notes.contains(note)).collect::<Vec<_>>());
        let fits =
            of_severity(&after, SeverityName::Error).all(|(_, error)| error.code != Code::WireDoesNotFit);
        let other = OtherSide {
            change: Change::between(&from, &side),
            newly_infeasible: Findings::only_in(&after, &before, SeverityName::Error),
            newly_feasible: Findings::only_in(&before, &after, SeverityName::Error),
            newly_warned: Findings::only_in(&after, &before, SeverityName::Warning),
            fits,
            own_wire: None,
            side,
        };
        Ok(other)
    };
    let mut to = Vec::with_capacity(others.len());
    for (id, machine) in request.against.iter().zip(others) {
        let choices = PlanChoices { machine: Some(id.clone()), ..request.choices.clone() };
        let mut other = beside(&choices)?;
        let own = machine.profile.default_material.map(|own| own.value);
        let own = own.filter(|own| {
            *own != other.side.material && (!other.fits || is_version(app, own, &other.side.material))
        });
        if own.is_some() {
            other.own_wire = Some(Box::new(beside(&PlanChoices { material: own, ..choices })?));
        }
        to.push(other);
    }
    Ok(CompareResponse { from, to, notes })
}

impl MachineSide {
    pub(crate) fn new(planned: &Planned) -> Self {
        let report = planned.report();
        let wires = report.wires();
        let number =
            |severity| all_said(&report).filter(|(_, diagnostic)| diagnostic.severity == severity).count();
        let cost = sum(wires, |wire| wire.cost);
        Self {
            machine: planned.setup.machine_id().to_owned(),
            name: planned.setup.machine_name().to_owned(),
            material: planned.setup.material_id().to_owned(),
            feasible: planned.feasible(),
            errors: number(SeverityName::Error),
            warnings: number(SeverityName::Warning),
            collisions: CollisionCount::of(planned),
            feeds: sum(wires, |wire| wire.route.as_ref().map(|route| route.feeds)),
            bends: sum(wires, |wire| wire.program.as_ref().map(|program| program.bends)),
            time_s: sum(wires, |wire| wire.time_s),
            stock_mm: sum(wires, |wire| wire.compensated.as_ref().map(|program| program.stock_mm)),
            currency: planned.setup.currency.clone(),
            cost,
            stock_cost: sum(wires, |wire| wire.stock_cost),
            mass_g: sum(wires, |wire| wire.mass_g),
        }
    }
}

/// The sum over all wires, where there are some and each has the value.
fn sum<T: std::iter::Sum>(wires: &[WireReport], of: impl Fn(&WireReport) -> Option<T>) -> Option<T> {
    if wires.is_empty() { None } else { wires.iter().map(of).sum() }
}

impl Change {
    fn between(from: &MachineSide, to: &MachineSide) -> Self {
        let more = |from: Option<f64>, to: Option<f64>| Some(to? - from?);
        let count = |bends: Option<usize>| i64::try_from(bends?).ok();
        let one_currency = from.currency.is_some() && from.currency == to.currency;
        Self {
            time_s: more(from.time_s, to.time_s),
            stock_mm: more(from.stock_mm, to.stock_mm),
            cost: more(from.cost, to.cost).filter(|_| one_currency),
            stock_cost: more(from.stock_cost, to.stock_cost).filter(|_| one_currency),
            mass_g: more(from.mass_g, to.mass_g),
            bends: count(to.bends).zip(count(from.bends)).map(|(to, from)| to - from),
        }
    }
}

/// Everything that the checks say, with the wire that they say it of.
fn all_said(report: &PlanReport) -> impl Iterator<Item = (Option<usize>, &DiagnosticReport)> {
    let of_wires = report.wires().iter().enumerate();
    let of_wires = of_wires.flat_map(|(index, wire)| wire.diagnostics.iter().map(move |d| (Some(index), d)));
    report.diagnostics().iter().map(|diagnostic| (None, diagnostic)).chain(of_wires)
}

fn of_severity(
    report: &PlanReport,
    severity: SeverityName,
) -> impl Iterator<Item = (Option<usize>, &DiagnosticReport)> {
    all_said(report).filter(move |(_, diagnostic)| diagnostic.severity == severity)
}

impl Findings {
    /// What a plan has of a severity that another plan of the design has not at the same place.
    fn only_in(plan: &PlanReport, other: &PlanReport, severity: SeverityName) -> Self {
        let mut only = Self::default();
        for (wire, diagnostic) in of_severity(plan, severity) {
            if of_severity(other, severity)
                .any(|(other_wire, other)| other_wire == wire && is_same(diagnostic, other))
            {
                continue;
            }
            only.vertices.extend(diagnostic.vertex.iter().chain(&diagnostic.vertices));
            only.edges.extend(diagnostic.edge.iter().chain(&diagnostic.edges));
            only.steps.extend(wire.zip(diagnostic.step).map(|(wire, step)| WireStep { wire, step }));
            only.diagnostics.push(WireDiagnostic { wire, diagnostic: diagnostic.clone() });
        }
        only
    }
}

/// Whether two machines say the same of the same place, whatever they measured there.
fn is_same(a: &DiagnosticReport, b: &DiagnosticReport) -> bool {
    let place = |d: &DiagnosticReport| (d.vertex, d.edge, d.step, d.vertices.clone(), d.edges.clone());
    a.code == b.code && place(a) == place(b)
}

/// Whether a wire inherits from another, as a calibrated one does from the wire that it was before.
fn is_version(app: &Installation, own: &str, of: &str) -> bool {
    let explained = app.library.explain(Kind::Material, own);
    explained.is_ok_and(|explained| explained.chain.iter().skip(1).any(|parent| parent.id == of))
}
