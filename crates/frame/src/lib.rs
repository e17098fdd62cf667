//! Linear beam frames: struts rigidly joined at nodes, under loads, their own weight and misfits, and how they vibrate.
//!
//! A [`Model`] says where nodes are, which [`Member`]s join them and what holds them. An [`Assembly`] is what can be worked out
//! once for it; [`Assembly::factor`] takes any [`MemberSet`] of it, so that a frame can be followed while it is built. A
//! [`Factor`] solves as many [`Load`]s as there are. [`Flexibility`] answers what one strut more or less does to the sag,
//! without factoring anything.
//!
//! Euler-Bernoulli beams of constant section, no shear deformation, small displacements: where a strut is near buckling, or
//! turns visibly, the answer no longer holds.
//!
//! Lengths in mm, angles in radian, forces in N, stresses in MPa, masses in tonne, so that densities are in `t/mm³`,
//! accelerations in `mm/s²` and frequencies in Hz. The axes are the model's own, right-handed. The six degrees of freedom of a
//! node are three displacements and three rotations about x, y and z.

mod arc;
mod assembly;
mod checks;
mod element;
mod equations;
mod error;
mod factor;
mod flexibility;
mod load;
mod loads;
mod lower;
mod member_set;
mod model;
mod modes;
mod parts;
mod pieces;
mod response;
mod section;
mod stress;
mod substitute;

pub use arc::{Arc, EndStiffness};
pub use assembly::Assembly;
pub use error::{LoadError, ModelError, ModesError, SolveError, Unstable};
pub use factor::Factor;
pub use flexibility::{Flexibility, Sag};
pub use load::{EndMotion, LineLoad, Load, Misfit, NodalLoad, NodeMass, STANDARD_GRAVITY};
pub use member_set::MemberSet;
pub use model::{Member, MemberId, Model, NodeId, SectionId, Support};
pub use modes::{Mode, ModeKind, ModeSearch};
pub use pieces::Pieces;
pub use response::{MemberForces, Reaction, Response};
pub use section::{Material, Section};
pub use stress::{SectionForces, Stress};
