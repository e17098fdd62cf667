//! Figures of findings, and the limits that they are held against.

use std::fmt;

use crate::units::{Angle, Length};

/// A figure of a machine with where it comes from.
#[derive(Debug, Clone, PartialEq)]
pub struct Sourced<T> {
    /// The figure.
    pub value: T,
    /// Where it comes from.
    pub source: Source,
}

/// Where a figure of a machine comes from: what a profile or a driver says, passed on as it is.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Source {
    /// Why the figure is what it is, where that is stated.
    pub reason: Option<String>,
    /// What the figure stands in, and under which key.
    pub entry: String,
}

impl fmt::Display for Source {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.reason {
            Some(reason) => write!(f, "{reason} [{}]", self.entry),
            None => f.write_str(&self.entry),
        }
    }
}

/// A figure of a finding, in the unit of its type.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Quantity {
    /// A length.
    Length(Length),
    /// An angle.
    Angle(Angle),
    /// A number of vertices, wires or passes.
    Count(usize),
    /// A stress, in MPa.
    Stress(f64),
    /// A share of something.
    Ratio(f64),
}

impl fmt::Display for Quantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Length(length) => length.fmt(f),
            Self::Angle(angle) => angle.fmt(f),
            Self::Count(count) => count.fmt(f),
            Self::Stress(stress) => write!(f, "{stress:.1} MPa"),
            Self::Ratio(ratio) => write!(f, "{ratio:.2}"),
        }
    }
}

/// What ends the reach of a bend.
#[derive(Debug, Clone, PartialEq)]
pub enum ReachLimit {
    /// The end of the bend axis.
    Axis {
        /// Where the axis would have to go, signed as the bend.
        needed: Angle,
        /// How far it goes to either side.
        travel: Sourced<Angle>,
    },
    /// The peg slips off the wire before the bend is pressed with its springback.
    Peg,
}

/// A limit that a measured value is held against.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limit<'a> {
    /// Its value, of the same kind as the measured one.
    pub value: Quantity,
    /// Where it comes from.
    pub source: LimitSource<'a>,
}

/// Where a limit comes from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum LimitSource<'a> {
    /// From a machine's figures.
    Stated(&'a Source),
    /// Within the weld tolerance vertices are taken to be meant as one.
    WeldTolerance,
    /// Centrelines of wires that touch are a diameter apart.
    Diameter,
    /// Euler: a walk that uses every edge once has odd vertices only at its two ends.
    EulerPath,
    /// Bends of this centreline radius take so much of an edge.
    BendRadius(Length),
    /// The reach of the bend axis or of the peg.
    Reach(&'a ReachLimit),
    /// Half of what the bend axis resolves.
    AxisResolution,
    /// A deflection for which beam theory holds.
    SmallDeflection,
    /// Half of the load at which Euler's column with pinned ends buckles.
    EulerLoad,
    /// How far a joint may be from where it is drawn, so that the head still meets it.
    JointReach,
    /// How near the head of a strut builder may come to a strut.
    HeadClearance,
    /// How far its axis may lean over its way.
    HeadApproach,
}
