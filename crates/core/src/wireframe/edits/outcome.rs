//! What a fillet or a shape would make, by the functions that make it.

use super::super::delta::Draft;
use super::super::graph::Wireframe;
use super::chord_limits::ChordLimits;
use super::fillet::{self, FilletOutcome};
use super::shapes::{Shape, ShapeOutcome};
use super::{Edit, EditError};

/// What an edit would make, without making it.
#[derive(Debug, Clone, PartialEq)]
pub enum Outcome {
    /// Of [`Edit::Fillet`].
    Fillet(FilletOutcome),
    /// Of [`Edit::AddPolygon`] and [`Edit::AddHelix`].
    Shape(ShapeOutcome),
}

impl Edit {
    /// What this edit would make of a wireframe; none of an edit that makes neither chords nor a shape, and of a fillet without
    /// corners. `limits` hold for a shape; a fillet has its own.
    ///
    /// # Errors
    /// [`EditError`] when it cannot be made, as of [`Edit::resolve`].
    pub fn outcome(&self, wireframe: &Wireframe, limits: &ChordLimits) -> Result<Option<Outcome>, EditError> {
        Ok(match self {
            Self::Fillet { vertices, radius, step, limits } => {
                let draft = Draft::new(wireframe);
                fillet::outcome(&draft, vertices, *radius, *step, limits)?.map(Outcome::Fillet)
            }
            Self::AddPolygon { plane, sides, size, turn } => {
                let shape = |sides| Shape::polygon(plane, sides, *size, *turn);
                Some(Outcome::Shape(ShapeOutcome::of(shape, *sides, limits)?))
            }
            Self::AddHelix { plane, radius, pitch, turns, sides, left } => {
                let shape = |sides| Shape::helix(plane, *radius, *pitch, *turns, sides, *left);
                Some(Outcome::Shape(ShapeOutcome::of(shape, *sides, limits)?))
            }
            _ => None,
        })
    }
}
