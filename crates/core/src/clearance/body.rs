//! The bodies of a machine.

use nalgebra::Isometry3;
use wirebend_collide::Solid;

use crate::units::{Angle, Length};

/// What a body of a machine moves with.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MovesWith {
    /// It stands still.
    Frame,
    /// It turns with the head about the wire.
    Head,
    /// It goes with the bend axis, which turns with the head.
    Peg,
}

/// A body of a machine.
#[derive(Debug, Clone, PartialEq)]
pub struct Body {
    /// What it is called.
    pub name: String,
    /// What it moves with.
    pub moves_with: MovesWith,
    /// What it is; in its own frame.
    pub solid: Solid,
    /// From its own frame to that of the machine, with the head at its reference and the bend axis at 0.
    pub at: Isometry3<f64>,
    /// So far from the bend point the wire that is being bent may touch it.
    pub contact_zone: Length,
    /// So far from their vertex other struts may touch it that meet the wire there.
    pub vertex_zone: Length,
    /// Where its dimensions are entered.
    pub entry: String,
    /// Where they come from.
    pub source: String,
    /// Whether they were measured on the real machine; otherwise they are estimates.
    pub measured: bool,
}

/// The bodies of a machine, and how its peg moves.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Bodies {
    /// The bodies.
    pub all: Vec<Body>,
    /// Where the axis that the peg turns about crosses x.
    pub pivot: Length,
    /// How far the peg goes in along its axis, so that the wire can pass; zero where it stays out.
    pub peg_stroke: Length,
    /// The angle about the pivot at which the peg stands with its axis at 0, from +x.
    pub peg_rest: Angle,
    /// How far before it touches straight wire the peg comes out.
    pub approach: Angle,
}
