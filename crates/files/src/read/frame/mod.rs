//! What files of frames say beside their struts: how supports hold, sections, materials, loads, and the order of building.
//!
//! Everything in mm, N, `MPa`, kg/m³; a member is an edge of the wireframe that the same file gives.

mod conmech;
mod conmech_loads;
mod match_struts;
mod sequence;
mod unit;

use std::collections::BTreeMap;

use wirebend_core::wireframe::{EdgeId, VertexId};

pub(super) use conmech::{merged, read as read_conmech, with_unit};
pub use conmech_loads::read_loads;
pub use match_struts::{MatchedStep, StrutMatchError};
pub use sequence::{SequenceFile, SequenceStep, StrutKind, direction, read_sequence};
pub(super) use unit::Quantity;
use unit::quantity;

/// How a support holds: translations along x, y and z, then rotations about them.
pub type Fixities = [bool; 6];

/// What a file of a frame says of it beside its struts.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct FrameFile {
    /// Vertices by the numbers that the file gives its nodes, by which loads name them.
    pub nodes: BTreeMap<i64, VertexId>,
    /// How each support holds.
    pub supports: BTreeMap<VertexId, Fixities>,
    pub sections: Vec<FrameSection>,
    pub materials: Vec<FrameMaterial>,
    /// Of each strut, what the file says of it.
    pub members: BTreeMap<EdgeId, FrameMember>,
}

/// A strut.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct FrameMember {
    /// Its place in the list of sections.
    pub section: Option<usize>,
    /// Its place in the list of materials.
    pub material: Option<usize>,
    /// The name by which loads, sections and materials name it; empty for none.
    pub tag: String,
    /// The layer that it is built in.
    pub layer: Option<i64>,
}

/// A cross section.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrameSection {
    pub area_mm2: f64,
    /// Torsion constant.
    pub j_mm4: f64,
    /// Second moment of area about the member's local y.
    pub iy_mm4: f64,
    /// Second moment of area about the member's local z.
    pub iz_mm4: f64,
}

impl FrameSection {
    /// The radius, where the figures are those of a solid round section to one part in a thousand.
    #[must_use]
    pub fn round_radius_mm(&self) -> Option<f64> {
        let radius = (self.area_mm2 / std::f64::consts::PI).sqrt();
        let bending = self.area_mm2 * radius * radius / 4.0;
        let is = |found: f64, expected: f64| (found - expected).abs() <= 1e-3 * expected;
        let round = is(self.iy_mm4, bending) && is(self.iz_mm4, bending) && is(self.j_mm4, 2.0 * bending);
        round.then_some(radius)
    }
}

/// A material. Both moduli are as the file states them: a Poisson's ratio beside them is not used.
#[derive(Debug, Clone, PartialEq)]
pub struct FrameMaterial {
    pub name: String,
    pub youngs_modulus_mpa: f64,
    pub shear_modulus_mpa: f64,
    /// Of a weight per volume, under standard gravity.
    pub density_kg_per_m3: f64,
    pub yield_strength_mpa: Option<f64>,
}

/// A load case.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct LoadCase {
    pub name: String,
    pub nodal: Vec<NodalLoad>,
    pub line: Vec<LineLoad>,
    /// Gravity as a multiple of standard gravity, in the frame of the design; none: it does not act.
    pub gravity: Option<[f64; 3]>,
}

/// A force and a moment at a vertex.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NodalLoad {
    pub vertex: VertexId,
    pub force_n: [f64; 3],
    pub moment_n_mm: [f64; 3],
}

/// A uniform load along a member, in the frame of the design.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LineLoad {
    pub edge: EdgeId,
    pub n_per_mm: [f64; 3],
}
