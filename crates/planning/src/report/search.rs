//! What came of a search, and by what its programs are compared.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_core::checks::Fact;
use wirebend_core::clearance::Obstacle;
use wirebend_core::plan::Searched;
use wirebend_core::route::Route;
use wirebend_core::search::{Change, ChangeKind, Help, Helps, MovedVertex, Objective, Weights};

/// What came of a search for wires that hit nothing.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
pub struct SearchReport {
    /// Whether it has found some.
    pub found: bool,
    /// How many steps it has checked.
    pub steps_checked: u64,
    /// Whether a person has ended it before it was done: this is the best until then.
    pub ended: bool,
    /// By which weights the best was chosen; null: fewest wires, then the least doubled length, then the least time.
    pub weights: Option<SearchWeights>,
}

/// What each part of a program costs a search, in a unit of the person's own: the program with the least sum is the best.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SearchWeights {
    /// A wire.
    #[serde(default)]
    pub wire: u32,
    /// A millimetre that is doubled.
    #[serde(default)]
    pub doubled_mm: u32,
    /// A second of turns of the head and of bends.
    #[serde(default)]
    pub second: u32,
}

impl From<&Searched> for SearchReport {
    fn from(searched: &Searched) -> Self {
        let weights = match searched.objective {
            Objective::InOrder => None,
            Objective::Weighed(Weights { wire, doubled_mm, second }) => {
                Some(SearchWeights { wire, doubled_mm, second })
            }
        };
        Self { found: searched.found, steps_checked: searched.checks, ended: searched.ended, weights }
    }
}

impl From<SearchWeights> for Objective {
    fn from(weights: SearchWeights) -> Self {
        let SearchWeights { wire, doubled_mm, second } = weights;
        Self::Weighed(Weights { wire, doubled_mm, second })
    }
}

/// Why a search has found nothing, and what was tried after it.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct UnfoundReport {
    /// How many steps it has checked; 0 where it did not begin.
    pub steps_checked: u64,
    /// Whether every walk of one wire was tried.
    pub exhausted: bool,
    /// How many edges were passed where it came farthest, counted as often as they are to be passed; null where it did not begin.
    pub passed: Option<usize>,
    /// How many there are.
    pub of: Option<usize>,
    /// What was in the way there; null where it did not begin.
    pub obstacle: Option<ObstacleName>,
    /// How far the wire had to stay from it, mm.
    pub clearance_mm: f64,
    /// The changes that were tried and help, one of a kind at most.
    pub helps: Vec<HelpReport>,
    /// The kinds of changes that were tried until one helped, or to the end.
    pub tried: Vec<ChangeName>,
    /// Whether a person has ended the search or these trials: there may be changes that were not tried.
    pub ended: bool,
}

/// What is in the way of a search.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum ObstacleName {
    /// A body of the machine, which the finding names.
    Body,
    /// The wire that is still to be bent.
    Stock,
    /// The head cannot turn so far.
    HeadLimit,
}

/// A kind of change that may help a search.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum ChangeName {
    /// More wires than were allowed.
    MoreWires,
    /// An edge that is run along twice.
    DoubleEdges,
    /// A vertex that lies elsewhere.
    MoveVertex,
}

/// A change with which a search finds a program that hits nothing: it was tried.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[serde(tag = "help", rename_all = "kebab-case")]
pub enum HelpReport {
    /// As many wires as there are walks, more than were allowed.
    MoreWires {
        /// One a wire.
        walks: Vec<WalkReport>,
    },
    /// Edges are run along twice.
    DoubleEdges {
        /// Which.
        edges: Vec<u32>,
        /// What they add to the wire, in mm.
        added_mm: f64,
        /// One a wire.
        walks: Vec<WalkReport>,
    },
    /// A vertex lies elsewhere.
    MoveVertex {
        /// Which.
        vertex: u32,
        /// Where it goes, in mm.
        to_mm: [f64; 3],
        /// How far that is, in mm.
        by_mm: f64,
        /// One a wire.
        walks: Vec<WalkReport>,
    },
}

/// The way of a wire along the edges: it is cut at its first and its last vertex.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
pub struct WalkReport {
    /// The vertex where it begins.
    pub from: u32,
    /// The vertex where it ends.
    pub to: u32,
    /// In their order.
    pub edges: Vec<u32>,
}

impl UnfoundReport {
    /// What a finding says of a search; none where it is of something else.
    pub(super) fn of(fact: &Fact) -> Option<Self> {
        let Fact::NoClearProgram { checks, exhausted, obstacle, passed, clearance, helps, .. } = fact else {
            return None;
        };
        let Helps { found, tried, ended } = helps;
        let obstacle = || match obstacle {
            Some(Obstacle::Body(_)) => ObstacleName::Body,
            Some(_) => ObstacleName::Stock,
            None => ObstacleName::HeadLimit,
        };
        Some(Self {
            steps_checked: *checks,
            exhausted: *exhausted,
            passed: passed.map(|(passed, _)| passed),
            of: passed.map(|(_, of)| of),
            obstacle: passed.map(|_| obstacle()),
            clearance_mm: clearance.mm(),
            helps: found.iter().map(HelpReport::from).collect(),
            tried: tried.iter().map(|kind| ChangeName::from(*kind)).collect(),
            ended: *ended,
        })
    }
}

impl From<ChangeKind> for ChangeName {
    fn from(kind: ChangeKind) -> Self {
        match kind {
            ChangeKind::MoreWires => Self::MoreWires,
            ChangeKind::Doubled => Self::DoubleEdges,
            ChangeKind::Moved => Self::MoveVertex,
        }
    }
}

impl From<&Help> for HelpReport {
    fn from(Help { change, routes }: &Help) -> Self {
        let walks = routes.iter().filter_map(WalkReport::of).collect();
        match change {
            Change::MoreWires => Self::MoreWires { walks },
            Change::Doubled { edges, added } => Self::DoubleEdges {
                edges: edges.iter().map(|id| id.0).collect(),
                added_mm: added.mm(),
                walks,
            },
            Change::Moved(MovedVertex { vertex, to, by }) => {
                Self::MoveVertex { vertex: vertex.0, to_mm: to.coords.into(), by_mm: by.mm(), walks }
            }
        }
    }
}

impl WalkReport {
    fn of(route: &Route) -> Option<Self> {
        let (first, last) = (route.traversals.first()?, route.traversals.last()?);
        let edges = route.traversals.iter().map(|one| one.edge.0).collect();
        Some(Self { from: first.from.0, to: last.to.0, edges })
    }
}
