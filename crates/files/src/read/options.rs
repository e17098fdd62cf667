//! How a file is to be read.

use std::path::PathBuf;

use wirebend_core::bend::Convention;
use wirebend_core::units::Length;

pub use crate::length_unit::LengthUnit;

/// Which way a positive rotation of a table turns the axis of the next bend.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Handedness {
    /// By the right-hand rule about the direction in which the wire runs.
    Right,
    /// The other way.
    Left,
}

impl Handedness {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Right, Self::Left];

    /// "right" or "left".
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Right => "right",
            Self::Left => "left",
        }
    }
}

/// Settings of every reader; the default reads millimetres, welds at 1 µm and follows curves to 0.1 mm.
#[derive(Debug, Clone, PartialEq)]
pub struct ReadOptions {
    /// A factor on all lengths, applied after the unit.
    pub scale: f64,
    /// What the numbers measure. None: what the file says, else millimetres (which is noted).
    pub units: Option<LengthUnit>,
    /// Vertices this close become one, after scaling.
    pub weld: Length,
    /// Whether the sides of all faces become the wireframe. Polygons get no diagonals.
    pub face_edges: bool,
    /// Centreline radius of every bend of an LRA table without a CLR column. Lengths from corner to corner
    /// need none.
    pub clr: Option<Length>,
    /// Whether the angles of a program are where the bend axis goes, and not those of the bends.
    pub commanded: bool,
    /// How the machine that a program was written for counts its axes.
    pub convention: Convention,
    /// Which way the rotations of a table of bends turn. None: what the table says, else right (which is noted).
    pub handedness: Option<Handedness>,
    /// How far the straight edges that a curve of a drawing becomes may be from it, in mm after scaling; 0.1 µm
    /// or more.
    pub tolerance: Length,
    /// No edge that is made of a curve of a drawing is shorter, where the curve has room, although it may be farther
    /// from the curve than the tolerance for that; in mm after scaling, between corners of up to 90°. None: any length.
    pub shortest_edge: Option<Length>,
    /// Centreline radius of the bends that will be made: edges of curves between sharper corners have to be longer.
    pub bend_radius: Length,
    /// The layers of a drawing to read, by name in any case. Empty: all that are not off, frozen or hidden.
    pub layers: Vec<String>,
    /// The folder of the file, in which the files that it names are looked for. None: it may name none.
    pub folder: Option<PathBuf>,
}

/// The default of [`ReadOptions::tolerance`], in mm: what benders typically miss a feed by (Bend-Forming's σ of
/// 0.1 mm), so that a finer polyline would not make a truer wire.
pub const DEFAULT_TOLERANCE_MM: f64 = 0.1;

/// No curve is followed closer than this, in mm: a kilometre would need millions of edges.
pub(super) const MIN_TOLERANCE_MM: f64 = 1e-4;

impl Default for ReadOptions {
    fn default() -> Self {
        Self {
            scale: 1.0,
            units: None,
            weld: Length::from_mm(1e-3).unwrap_or_default(),
            face_edges: false,
            clr: None,
            commanded: false,
            convention: Convention::default(),
            handedness: None,
            tolerance: Length::from_mm(DEFAULT_TOLERANCE_MM).unwrap_or_default(),
            shortest_edge: None,
            bend_radius: Length::ZERO,
            layers: Vec::new(),
            folder: None,
        }
    }
}
