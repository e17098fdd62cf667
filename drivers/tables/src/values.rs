//! What the settings can be.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A column of a table of bends.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub enum Column {
    /// Number of the row, from 1.
    #[serde(rename = "N")]
    Number,
    /// Length of the straight part before the bend.
    #[serde(rename = "L")]
    Length,
    /// Distance from the start of the wire to the bend.
    #[serde(rename = "D")]
    Distance,
    /// Rotation before the bend, degrees.
    #[serde(rename = "R")]
    Rotation,
    /// Bend angle, degrees.
    #[serde(rename = "A")]
    Angle,
    /// Centreline radius of the bend.
    #[serde(rename = "CLR")]
    Radius,
}

/// A column of a table of points.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub enum PointColumn {
    /// Number of the row, from 1.
    #[serde(rename = "N")]
    Number,
    /// First coordinate.
    X,
    /// Second coordinate.
    Y,
    /// Third coordinate.
    Z,
    /// Centreline radius of the bend; empty at both ends.
    #[serde(rename = "CLR")]
    Radius,
}

/// What lengths are measured between.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Lengths {
    /// The ends of the arcs.
    Tangent,
    /// The corners of the design, where the straight parts intersect.
    Intersection,
}

/// Which way a positive rotation turns.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Handedness {
    /// By the right-hand rule about the direction in which the wire runs.
    Right,
    /// The other way.
    Left,
}

/// What a rotation counts from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum RotationCount {
    /// The plane of the bend before.
    Relative,
    /// The start of the wire.
    Absolute,
}

/// What stands between two cells.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Separator {
    /// ,
    Comma,
    /// ;
    Semicolon,
    /// A tab.
    Tab,
}

/// What stands before the decimals.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum DecimalMark {
    /// .
    Point,
    /// ,
    Comma,
}

/// The end of a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum LineEnd {
    /// Line feed.
    Lf,
    /// Carriage return and line feed.
    Crlf,
}

/// A unit of length.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum LengthUnit {
    /// Millimetre.
    Mm,
    /// Inch of 25.4 mm.
    Inch,
}

/// How a comment is marked.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Comments {
    /// No comments.
    None,
    /// A line that starts with #.
    NumberSign,
}

impl LengthUnit {
    pub(crate) const fn mm(self) -> f64 {
        match self {
            Self::Mm => 1.0,
            Self::Inch => 25.4,
        }
    }

    pub(crate) const fn word(self) -> &'static str {
        match self {
            Self::Mm => "mm",
            Self::Inch => "inch",
        }
    }
}

impl Separator {
    pub(crate) const fn mark(self) -> char {
        match self {
            Self::Comma => ',',
            Self::Semicolon => ';',
            Self::Tab => '\t',
        }
    }
}
