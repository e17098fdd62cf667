//! The order in which the struts of a frame are built, so that the head can always stand, nothing hangs on nothing, and what stands
//! never sags too far.
//!
//! Found backwards, by taking struts off the finished frame: a strut may go when the rest hangs on the ground, the head could have
//! stood while it was placed among the rest, and the rest sags little enough. After Huang et al., `FrameFab`, ACM Transactions on
//! Graphics 35 (6), 2016, which searches forwards through layers. Axes are the design's, right-handed, z up; lengths in mm.
//!
//! The paper and its authors' code (`yijiangh/FrameFab`, 0cecf5e) differ, and what is here follows neither blindly:
//!
//! - Eq. 9 as printed favours the wrong order; the code (`ADMMCut.cpp`) has the right one, and so has `layers`.
//! - The cost of stability is not Eq. 4 in the code but height times exp of the angle (`FFAnalyzer.cpp`); `paper` has it so.
//! - The cone of the head is 45° in the paper and 30° in the code (`ExtruderCone.cpp`), with which the published directions agree.
//! - A node may sag by 0.65 mm in the paper; the code takes 2.0 for sequences and 1.0 for layers (`FiberPrintPARM.h`). Here it is what the
//!   strut builder allows: 0.65 mm for struts of 0.75 mm in radius and a tolerance of 0.1 mm.
//! - The code looks at the head at both ends of a strut and at eight triangles between them (`QuadricCollision.cpp`), and so 376 of the
//!   6,928 directions that are published for the bunny hit a strut in mid-motion. No published step is left without a direction. Here
//!   the head is followed all along its way.

#![deny(missing_docs)]

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
pub use check::{Checked, GivenJoint, GivenStep, check};
pub use cost::{SequenceCost, cost};
pub use groups::{Group, GroupError, Groups};
pub use layers::{LayerOptions, layers};
pub use outcome::{Joint, Obstacle, ObstacleRule, Outcome, Partial, Progress, Step, Strategy};
pub use paper::search_by_paper;
pub use search::{SearchOptions, Task, search, stiffest_order, whole_frame};
pub use stability::{Sag, Weight};
pub use structure::{Node, Structure, StructureError, Strut};
pub use wirebend_collide::{DirectionSet, Head, HeadError};
