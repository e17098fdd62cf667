//! What a person may choose of a plan.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::report::SearchWeights;

/// What a person may choose of a plan; what is not chosen is taken from the document.
#[derive(Debug, Clone, Default, PartialEq, Deserialize, JsonSchema)]
#[allow(clippy::struct_excessive_bools)] // each is an option of its own
pub struct PlanChoices {
    pub machine: Option<String>,
    /// The wire in it; absent, the one that the machine's profile names.
    pub material: Option<String>,
    /// Whether to travel the cheapest edges twice where there is no route otherwise, and where several wires that are
    /// chosen here need less than was accepted.
    #[serde(default)]
    pub double: bool,
    /// Whether to travel edges once more, too, where only such a detour avoids a bend that the machine cannot make.
    #[serde(default)]
    pub detours: bool,
    /// How many wires there may be: one at least for each part of the design, and fewer where more would not save doubled
    /// edges.
    #[schemars(range(min = 1))]
    pub wires: Option<u32>,
    /// Whether the wire must end where it starts; not with several wires.
    #[serde(default)]
    pub closed: bool,
    /// The vertex where the wire starts.
    pub start: Option<u32>,
    /// Whether the wire runs the other way than the document says.
    #[serde(default)]
    pub reverse: bool,
    /// Whether the wire runs as the program runs from which the design was read.
    #[serde(default)]
    pub keep_order: bool,
    /// Whether to look where the wire meets the machine or itself while it is bent.
    #[serde(default)]
    pub collisions: bool,
    /// Whether to search for wires that hit neither the machine nor themselves: another walk, other sides and windings of bends, and
    /// where that is not enough, more wires. With `keep_order` sides and windings alone are searched.
    #[serde(default)]
    pub avoid_collisions: bool,
    /// How many steps the search may check for each number of wires; absent, 20,000.
    #[schemars(range(min = 1))]
    pub search_effort: Option<u32>,
    /// Where the chance of the search begins; absent, 1. The same seed finds the same.
    pub search_seed: Option<u64>,
    /// What makes one program of the search better than another; absent: fewest wires, then the least doubled length, then the least time.
    pub search_weights: Option<SearchWeights>,
    /// Whether to work out how far the part already bent sags under its own weight, and to look for collisions as it hangs, also where the
    /// document does not say so.
    #[serde(default)]
    pub sag: bool,
    /// How far the wire has to stay from what it could hit, besides, mm; with `collisions` or `avoid_collisions`. Absent: as the document says.
    #[schemars(range(min = 0.0))]
    pub collision_margin_mm: Option<f64>,
}
