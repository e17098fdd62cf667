//! Motion: where the wire, the head, the bend axis and the peg are while a machine runs each step.
//!
//! Frame of the machine: mm, right-handed, the origin is the bend point, +x the way the wire leaves, z the bend axis of the
//! head at its reference. The end that was bent first leads, so the direction of travel along the path is -x there. A
//! positive bend turns the wire that is out about the head's z, right-handed; a rotation by φ turns the head about the
//! direction of travel, which is by -φ about +x, and leaves the wire as it is. The two together are the turtle of the
//! program ([`crate::bend`]), seen from its own frame.
//!
//! A [`Pose`] a step says how the wire lies; [`Moment`]s say when, and where the machine is. Between two moments everything
//! moves evenly, so that whoever draws a motion needs no rule of bending.

mod moment;
mod pose;

pub use moment::{MachineStep, Moment, moments};

pub(crate) use pose::bend_axis;
pub use pose::{Pose, poses, poses_of_points};

#[cfg(test)]
mod tests;
