//! What is computed of frames, for other programs: plain figures in, text out.

mod assembly;
mod conmech;
mod csv;
mod glb;
mod sequence;
mod vtk;

use nalgebra::{Point3, Vector3};
use wirebend_core::wireframe::{EdgeId, VertexId};

pub use assembly::{BuiltMember, assembly_instances};
pub use conmech::{conmech_frame, conmech_loads};
pub use csv::{members_csv, nodes_csv};
pub use glb::{DeformedStrut, deformed_glb};
pub use sequence::framefab_sequence;
pub use vtk::{closed_vtk, vtk};

/// A frame under load: mm, N, `MPa`, radian.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct FrameResult {
    /// What it is called; one line.
    pub title: String,
    pub nodes: Vec<ResultNode>,
    pub members: Vec<ResultMember>,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ResultNode {
    pub vertex: VertexId,
    pub position: Point3<f64>,
    pub displacement: Vector3<f64>,
    /// About x, y and z; small angles.
    pub rotation: Vector3<f64>,
    pub support: bool,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ResultMember {
    pub edge: EdgeId,
    /// Its nodes, as their places in the list.
    pub ends: [usize; 2],
    /// Tension is positive.
    pub axial_n: f64,
    /// The largest bending moment along it.
    pub moment_n_mm: f64,
    pub torque_n_mm: f64,
    /// None where the shape of its section is not known.
    pub von_mises_mpa: Option<f64>,
    /// Von Mises stress over yield strength; none where that is not known.
    pub utilisation: Option<f64>,
    /// Compression over Euler's critical load.
    pub buckling_ratio: f64,
    /// The step in which it is built, from 1; none where there is no order.
    pub step: Option<usize>,
}

/// Wires whose joints are closed: mm, N, `MPa`.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ClosedResult {
    /// What it is called; one line.
    pub title: String,
    /// Where they are drawn, and how far they are off once joints are closed.
    pub nodes: Vec<ResultNode>,
    /// Of all wires, in the order in which each runs.
    pub struts: Vec<ClosedStrut>,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ClosedStrut {
    pub edge: EdgeId,
    /// Which wire, from 1.
    pub wire: usize,
    /// Its nodes, as their places in the list.
    pub ends: [usize; 2],
    /// Along its chord; tension is positive.
    pub axial_n: f64,
    /// Root of the mean square over its surface.
    pub von_mises_rms_mpa: f64,
}
