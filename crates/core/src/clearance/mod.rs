//! Clearance: where the wire that is already bent meets the machine, or the wire that is still to come, while a program runs.
//!
//! Frame of the machine as in [`crate::motion`]: mm, right-handed, the origin is where a bend begins, +x the way the wire
//! leaves, z the bend axis of the head at its reference. Unlike there, a bend is an arc: the wire rolls around the pin. The
//! part bent so far is rigid and moves as one; the machine is the solids of its profile, each moving with the frame, the head
//! or the peg. The stock is one more obstacle: a capsule along -x.
//!
//! The wire at a bend touches pin, nozzle and peg by its nature: [`Body::contact_zone`] says how much of it may. Other struts
//! that meet the one that is fed at a vertex come near them, too, where a frame closes and the wire goes beside:
//! [`Body::vertex_zone`]. A strut that runs along the same edge as the one that is fed lies beside it, and beside such bodies.
//!
//! A wire that hangs ([`StockWire::hangs`]) is looked at in the shapes that its weight gives it, one for each part of a motion in which it
//! hardly changes.

mod asked;
mod body;
mod centreline;
mod contact;
mod contacts;
mod hang;
mod joint;
mod moment;
mod rooms;
mod run;
mod seen;
mod stroke;
mod wire;
mod zone;

pub use wirebend_collide::Solid;

pub use body::{Bodies, Body, MovesWith};
pub use contact::{Contact, FirstContact, MeetsAs, Obstacle};
pub use joint::{JointSag, max_joint_sag};
pub use run::StepPart;
pub use stroke::{Phase, StepRun};
pub use wire::{Clearance, StockWire};
pub use zone::{Passage, passages};
#[cfg(test)]
mod bender;
#[cfg(test)]
mod tests;
