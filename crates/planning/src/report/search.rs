//! What came of a search, and by what its programs are compared.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_core::plan::Searched;
use wirebend_core::search::{Objective, Weights};

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
