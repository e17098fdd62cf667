//! What commands answer: plain values with units in their names, made for JSON.

mod diagnostic;
mod remedy;
mod search;

use std::borrow::Cow;
use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_core::clearance::JointSag;
use wirebend_core::plan::PartSag;
use wirebend_error::ErrorRemedy;
use wirebend_files::document::JobPause;
use wirebend_files::read::Note;

pub use diagnostic::{DiagnosticReport, SeverityName};
pub use remedy::RemedyReport;
pub use search::{
    ChangeName, HelpReport, ObstacleName, SearchReport, SearchWeights, UnfoundReport, WalkReport,
};
pub use wirebend_core::checks::Code as DiagnosticCode;
pub use wirebend_files::document::JobStep;

/// Something that a reader merged, ignored or assumed.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
pub struct NoteReport {
    /// What it is about.
    pub code: Cow<'static, str>,
    /// How many there were.
    pub count: usize,
    /// A sentence.
    pub message: String,
    /// What can be done about it.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub remedies: Vec<ErrorRemedy>,
}

impl From<&Note> for NoteReport {
    fn from(note: &Note) -> Self {
        Self {
            code: note.kind.code().into(),
            count: note.count,
            message: note.to_string(),
            remedies: note.kind.remedies(),
        }
    }
}

/// Less than this is shown as nothing, mm or degrees: figures for people have a digit behind the point.
pub const SHOWN_AS_ZERO: f64 = 0.05;

/// An angle as people read it: what is shown as zero has no sign.
#[must_use]
pub fn shown_deg(deg: f64) -> f64 {
    if deg.abs() < SHOWN_AS_ZERO { 0.0 } else { deg }
}

/// How much of a step is in the wire, in canonical signs; a driver and its journal have the same in the machine's signs. What it bends counts for nothing: a bend starts from its beginning.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PartOfStep {
    /// Fed, mm of wire.
    pub feed_mm: f64,
    /// Turned, degrees.
    pub rotate_deg: f64,
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
    /// How many edges it travels twice.
    pub doubled_edges: usize,
    /// What they add, in mm.
    pub doubled_mm: f64,
    /// Whether no other choice of edges adds less; of several wires, whether none adds less to all of them together.
    pub optimal: bool,
    /// The edges that are travelled twice.
    pub doubled: Vec<u32>,
    /// The edges that it makes once more beside a wire before it.
    pub beside: Vec<u32>,
    /// What these add, in mm.
    pub beside_mm: f64,
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
    pub steps: Vec<JobStep>,
}

/// What is sent to the machine.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct CompensatedReport {
    /// The steps, in canonical signs.
    pub steps: Vec<JobStep>,
    /// All feeds together, in mm.
    pub feed_mm: f64,
    /// Stock to load, in mm: all feeds and the tail that cannot be fed.
    pub stock_mm: f64,
}

/// How far the part already bent sags at most under its own weight while it is bent.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct SagReport {
    /// How far its free end is from where it would be without weight, mm.
    pub deflection_mm: f64,
    /// The step of the program in which that is, counted from 0: at the end of its feed, or while it bends.
    pub step: usize,
    /// How far the part reaches from the bend point then, mm. A sag of more than a tenth of it is only indicated.
    pub reach_mm: f64,
    /// Where the wire misses itself the most; null where it never comes back to a vertex.
    pub joint: Option<JointSagReport>,
}

/// Where the wire comes back to a vertex that it has passed before, and how far the part has sagged there.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct JointSagReport {
    /// How far apart the two places of the wire are, that should be one, mm.
    pub off_mm: f64,
    /// The step of the program whose feed brings it there, counted from 0.
    pub step: usize,
    /// The vertex.
    pub vertex: u32,
}

impl From<PartSag> for SagReport {
    fn from(PartSag { largest, joint }: PartSag) -> Self {
        let joint = joint.map(|JointSag { step, vertex, off }| JointSagReport {
            off_mm: off.mm(),
            step,
            vertex: vertex.0,
        });
        Self {
            deflection_mm: largest.deflection.mm(),
            step: largest.step,
            reach_mm: largest.reach.mm(),
            joint,
        }
    }
}

/// One wire through all stages. A stage that was not reached is null; the diagnostics say why.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct WireReport {
    /// What it covers.
    pub wireframe: WireframeReport,
    pub route: Option<RouteReport>,
    /// Its nominal program.
    pub program: Option<ProgramReport>,
    /// Its compensated program.
    pub compensated: Option<CompensatedReport>,
    /// What the checks say.
    pub diagnostics: Vec<DiagnosticReport>,
    /// Whether the machine can make it.
    pub feasible: bool,
    /// Whether it was looked at where the wire meets the machine or itself: only on request, and not without a route.
    pub collisions_checked: bool,
    /// What came of the search for wires that hit nothing, of all wires of a part of the design together: the first of them has it.
    /// Absent where nobody searched.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub search: Option<SearchReport>,
    /// How far it sags while it is bent: only on request, and not without a program.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sag: Option<SagReport>,
    /// After which steps the machine waits for a person, and for what. Absent where it never does.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub pauses: Vec<JobPause>,
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
    /// Energy that forming the fed wire takes as its material's profile has it, kJ: Bend-Forming's figure. Absent where it has none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub process_energy_kj: Option<f64>,
    /// That energy at the authors' 25 W, min: not the time of the machine, which is `time_s`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub process_time_min: Option<f64>,
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
        wires: Vec<WireReport>,
        /// What the checks say of the design as a whole.
        diagnostics: Vec<DiagnosticReport>,
        /// Whether the machine can make all of them.
        feasible: bool,
    },
}

impl PlanReport {
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
