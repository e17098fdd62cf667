//! What a record of the drawing is: an outline, a block put in, or something that is counted.

use std::cell::RefCell;

use nalgebra::{Affine3, Point3, Vector3};

use super::super::error::ReadError;
use super::super::note::NoteKind;
use super::super::outline::Outline;

/// What can be drawn or counted; outlines are in the coordinates of the drawing or of their block.
#[derive(Debug)]
pub(super) enum Shape {
    Outline(Outline),
    /// A curve through the points on a spline that has no control points.
    Fitted(Outline),
    Faces(Faces),
    Insert(Box<Insert>),
    /// The kind of note that counts it.
    Ignored(NoteKind),
    /// What cannot be read, which is an error where it is drawn.
    Broken(RefCell<Option<Box<ReadError>>>),
}

impl Shape {
    pub(super) fn broken(error: ReadError) -> Self {
        Self::Broken(RefCell::new(Some(Box::new(error))))
    }
}

/// A block put in, once or in rows and columns.
#[derive(Debug)]
pub(super) struct Insert {
    /// In lower case, as all names.
    pub(super) block: String,
    /// From the block, without its base point, to where it is put in.
    pub(super) map: Affine3<f64>,
    /// From one column and from one row to the next.
    pub(super) steps: [Vector3<f64>; 2],
    /// How many columns and rows.
    pub(super) counts: [i64; 2],
}

/// Faces over points of their own, in the coordinates of the drawing or of their block.
#[derive(Debug, Default)]
pub(super) struct Faces {
    pub(super) points: Vec<Point3<f64>>,
    pub(super) faces: Vec<Face>,
}

/// Corners, and of each whether the side that it begins is shown.
#[derive(Debug)]
pub(super) struct Face {
    pub(super) corners: Vec<(u32, bool)>,
}

impl Faces {
    pub(super) fn mapped(&self, map: &Affine3<f64>) -> Vec<Point3<f64>> {
        self.points.iter().map(|point| map * point).collect()
    }
}
