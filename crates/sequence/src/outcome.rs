//! A sequence, or why there is none.

use wirebend_collide::DirectionSet;
use wirebend_core::checks::sequence::StepKind;

/// Struts that are placed at once, and how.
#[derive(Debug, Clone, PartialEq)]
pub struct Step {
    /// The struts, by their places in the structure; one, unless a wire or rod is placed.
    pub struts: Vec<usize>,
    /// What it adds.
    pub kind: StepKind,
    /// Where the head stands: for a strut the end from which it is drawn, for a wire every joint with what is built.
    pub joints: Vec<Joint>,
    /// The largest sag once it is placed, mm.
    pub max_sag_mm: f64,
}

/// Where the head stands at a joint.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Joint {
    /// The node.
    pub node: usize,
    /// The direction of its axis, by its place in the directions of the builder.
    pub direction: usize,
    /// All directions that are free.
    pub free: DirectionSet,
}

/// How a sequence was found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Strategy {
    /// Farthest from the ground is built last.
    FromGround,
    /// What keeps the frame stiffest is built first.
    StiffnessPlan,
    /// What was in the way of earlier searches is built later; which restart, from 1.
    Restart(u32),
    /// Going back from dead ends.
    Backtracking,
    /// Layer by layer, cheapest first by the cost of the paper.
    PaperCost,
}

/// How far a search is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Progress {
    /// How it searches.
    pub strategy: Strategy,
    /// How many groups are ordered.
    pub taken: usize,
    /// How many there are.
    pub of: usize,
}

/// What was in the way where a search came farthest.
#[derive(Debug, Clone, PartialEq)]
pub struct Obstacle {
    /// The step of the sequence, from 1, that cannot be the last of what stands then.
    pub step: usize,
    /// Which rule is broken.
    pub rule: ObstacleRule,
    /// A strut that cannot be placed at that step; none where it is the frame as a whole.
    pub strut: Option<usize>,
    /// The struts that are in the way, or meet where it sags.
    pub struts: Vec<usize>,
}

/// Which rule is broken.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ObstacleRule {
    /// The finished frame sags too far; none where it does not stand at all.
    WholeFrame {
        /// The node that sags most.
        node: usize,
        /// How far, mm.
        sag_mm: Option<f64>,
    },
    /// What stands without the strut sags too far; none where it does not stand.
    Sags {
        /// The node that sags most.
        node: usize,
        /// How far, mm.
        sag_mm: Option<f64>,
    },
    /// What stands with the strut sags too far, where it is built up and not taken apart; none where it does not stand.
    SagsWith {
        /// The node that sags most.
        node: usize,
        /// How far, mm.
        sag_mm: Option<f64>,
    },
    /// The head cannot stand in any direction.
    NoDirection,
    /// A strut would hang on nothing.
    Floating,
    /// The tip does not get to a node.
    OutOfReach {
        /// The node.
        node: usize,
    },
}

/// What came of a search.
#[derive(Debug, Clone, PartialEq)]
pub struct Outcome {
    /// The steps, where there is a sequence.
    pub steps: Vec<Step>,
    /// How it was found.
    pub strategy: Option<Strategy>,
    /// Whether the answer is certain: a sequence, or that there is none.
    pub proved: bool,
    /// What was in the way, where there is none.
    pub obstacle: Option<Obstacle>,
    /// The longest part of one that was found, where all of it was not.
    pub partial: Partial,
}

/// A part of a sequence: the struts of each step, by their places in the structure.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Partial {
    /// How it begins.
    pub first: Vec<Vec<usize>>,
    /// How it ends.
    pub last: Vec<Vec<usize>>,
}

impl Outcome {
    /// That there is none, and why.
    #[must_use]
    pub fn impossible(obstacle: Obstacle) -> Self {
        Self { proved: true, ..Self::not_found(Some(obstacle), Partial::default()) }
    }

    pub(super) fn not_found(obstacle: Option<Obstacle>, partial: Partial) -> Self {
        Self { steps: Vec::new(), strategy: None, proved: false, obstacle, partial }
    }

    /// Whether there is a sequence.
    #[must_use]
    pub fn is_found(&self) -> bool {
        !self.steps.is_empty()
    }
}
