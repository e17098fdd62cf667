//! The order in which the struts of a frame are built, so that the head can always stand, nothing hangs on nothing, and what stands
//! never sags too far.
//!
//! Found backwards, by taking struts off the finished frame: a strut may go when the rest hangs on the ground, the head could have
//! stood while it was placed among the rest, and the rest sags little enough. After Huang et al., `FrameFab`, ACM Transactions on
//! Graphics 35 (6), 2016, which searches forwards through layers. Axes are the design's, right-handed, z up; lengths in mm.

mod builder;
mod candidates;
mod check;
mod cost;
mod descent;
mod free_directions;
mod group_set;
mod groups;
mod keys;
mod layers;
mod outcome;
mod paper;
mod search;
mod stability;
mod structure;

pub use builder::{DirectionStepError, HeadDirections, Pace, StrutBuilder};
pub use check::{Checked, GivenJoint, GivenStep, Violation, check};
pub use cost::{SequenceCost, cost};
pub use groups::{Group, GroupError, Groups};
pub use layers::{LayerOptions, layers};
pub use outcome::{Joint, Obstacle, ObstacleRule, Outcome, Progress, Step, StepKind, Strategy};
pub use paper::search_by_paper;
pub use search::{SearchOptions, Task, search, stiffest_order};
pub use stability::{Sag, Weight};
pub use structure::{Node, Structure, StructureError, Strut};
pub use wirebend_collide::{DirectionSet, Head, HeadError};
