//! The deformed shape of a frame as a model.

use nalgebra::{Point3, Vector3};
use wirebend_core::units::Length;
use wirebend_core::wireframe::EdgeId;

use super::super::glb::{Line, of_lines};
use super::super::tube::Tube;

/// A round strut has as many sides as a bent wire has in its model.
const SIDES: usize = 12;

/// A strut, and how far it moves.
#[derive(Debug, Clone, PartialEq)]
pub struct DeformedStrut {
    pub edge: EdgeId,
    pub radius: Length,
    /// Points along it where it is drawn, mm.
    pub at: Vec<Point3<f64>>,
    /// How far each of them moves, mm.
    pub moved: Vec<Vector3<f64>>,
}

/// Writes struts with their displacements times `scale`, each as a tube of its own that is named by its edge.
#[must_use]
pub fn deformed_glb(struts: &[DeformedStrut], scale: f64) -> Vec<u8> {
    let moved = struts.iter().map(|strut| {
        let points = strut.at.iter().zip(&strut.moved);
        points.map(|(at, moved)| at + moved * scale).collect()
    });
    let moved: Vec<Vec<Point3<f64>>> = moved.collect();
    of_lines(struts.iter().zip(&moved).map(|(strut, points)| Line {
        name: format!("edge {}", strut.edge),
        points,
        tube: Tube { radius: strut.radius, sides: SIDES },
    }))
}
