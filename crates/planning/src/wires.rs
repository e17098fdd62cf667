//! `plan --wires 1..6`: what several wires save of what is travelled twice, and what they cost.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_core::units::Length;
use wirebend_error::InputName;

use crate::choices::PlanChoices;
use crate::compare::MachineSide;
use crate::design::DesignInput;
use crate::plan::Planned;
use crate::report::{NoteReport, SearchReport};
use crate::{Installation, PlanningError, Progress};

#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct WiresRequest {
    pub design: DesignInput,
    /// How it is planned, the number of wires aside; the cheapest edges are always travelled twice, whatever was accepted.
    pub choices: PlanChoices,
    /// The fewest wires.
    #[schemars(range(min = 1))]
    pub from: u32,
    /// The most wires.
    pub to: u32,
}

/// The design from more and more wires, as far as they save something.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct WiresResponse {
    pub rows: Vec<WiresRow>,
    /// The numbers of wires in the range that have no row, and why.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub left_out: Vec<LeftOutWires>,
    /// What was merged, ignored or assumed while reading, and what to know of the wires; each once.
    pub notes: Vec<NoteReport>,
}

/// Numbers of wires that have no row.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
pub struct LeftOutWires {
    pub from: u32,
    pub to: u32,
    #[serde(flatten)]
    pub why: LeftOutReason,
}

/// Why a number of wires has no row.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(tag = "reason", rename_all = "kebab-case")]
pub enum LeftOutReason {
    /// Each part of the design needs a wire.
    FewerThanParts { parts: usize },
    /// So many wires save as much of what is doubled.
    SavesNothing { enough: usize },
    /// A program without collisions needs so many wires only.
    NotNeeded { enough: usize },
    /// The search has found no program without collisions; without one, no more wires than these are used.
    NothingFound { used: usize },
}

/// The design from so many wires.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct WiresRow {
    pub wires: usize,
    /// How many times edges are travelled beyond the first.
    pub doubled_edges: usize,
    /// Their length together, in mm.
    pub doubled_mm: f64,
    /// The designed length of all wires, in mm.
    pub length_mm: f64,
    /// What came of the search for wires that hit nothing, of all parts together; absent where nobody searched.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub search: Option<SearchReport>,
    /// The figures on the machine.
    #[serde(flatten)]
    pub side: MachineSide,
}

pub fn wires(
    app: &Installation,
    request: &WiresRequest,
    progress: &dyn Progress,
) -> Result<WiresResponse, PlanningError> {
    if request.from == 0 || request.from > request.to {
        return Err(PlanningError::Value {
            input: Some(InputName::Wires),
            name: "the number of wires",
            value: format!("{}..{}", request.from, request.to),
            expected: "one number of wires, at least 1, or a range of such numbers, the smaller first",
        });
    }
    let mut opened = app
        .designed(request.design.open_with(app, &request.choices, progress)?, &request.choices)?
        .with_wireframe()?;
    // What was accepted for one number of wires says nothing of the others.
    opened.document.doublings.clear();
    let parts = opened.document.wireframe.components();
    let parts = parts.iter().filter(|part| !part.edges.is_empty()).count();
    let least = u32::try_from(parts).map_or(request.to, |parts| parts.clamp(request.from, request.to));
    let mut rows: Vec<WiresRow> = Vec::new();
    let mut notes: Vec<NoteReport> = Vec::new();
    let mut left_out: Vec<LeftOutWires> = Vec::new();
    if least > request.from {
        let why = LeftOutReason::FewerThanParts { parts };
        left_out.push(LeftOutWires { from: request.from, to: least - 1, why });
    }
    // Parts that do not touch need a wire each: with fewer the plan is the same.
    for wires in least..=request.to {
        let choices = PlanChoices { wires: Some(wires), double: true, ..request.choices.clone() };
        let planned = app.plan_design(opened.copy(), &choices, progress)?;
        let row = WiresRow::new(&planned);
        for note in planned.opened.notes {
            if !notes.contains(&note) {
                notes.push(note);
            }
        }
        let (used, found) = (row.wires, row.search.as_ref().map(|search| search.found));
        let is_new = rows.last().is_none_or(|last| last.wires < used);
        if is_new {
            rows.push(row);
        }
        // More wires than save something, or than a program without collisions needs, are not used.
        let is_enough = used < wires as usize && found != Some(false);
        let (from, to) = if is_new { (wires + 1, request.to) } else { (wires, request.to) };
        if is_enough {
            let enough = used;
            let why = if found.is_some() {
                LeftOutReason::NotNeeded { enough }
            } else {
                LeftOutReason::SavesNothing { enough }
            };
            left_out.extend((from <= to).then_some(LeftOutWires { from, to, why }));
            break;
        }
        if !is_new {
            let why = LeftOutReason::NothingFound { used };
            left_out.push(LeftOutWires { from: wires, to: wires, why });
        }
    }
    Ok(WiresResponse { rows, left_out, notes })
}

impl WiresRow {
    fn new(planned: &Planned) -> Self {
        let wireframe = &planned.opened.document.wireframe;
        let routes = planned.wires.iter().flat_map(|wire| &wire.route);
        let travelled: Vec<_> = routes.flat_map(|route| &route.traversals).map(|t| t.edge).collect();
        let length: Length = travelled.iter().map(|&edge| wireframe.edge_length(edge)).sum();
        let design: Length = wireframe.edges().map(|(edge, _)| wireframe.edge_length(edge)).sum();
        Self {
            wires: planned.wires.len(),
            doubled_edges: travelled.len().saturating_sub(wireframe.edge_count()),
            doubled_mm: (length.mm() - design.mm()).max(0.0),
            length_mm: length.mm(),
            search: planned.searched(),
            side: MachineSide::new(planned),
        }
    }
}
