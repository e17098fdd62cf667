//! What a fillet or a shape would make, told while a person types its figures.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_core::units::Length;
use wirebend_core::wireframe::{EditError, FilletFault, FilletOutcome, Outcome, ShapeOutcome};

use super::{EditRequest, Editor, EditorError, changing};
use wirebend_planning::Installation;

/// What an edit would make, and what the machine of the design needs of it; 0 where everything can be made. Lengths in mm.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[serde(tag = "outcome", rename_all = "kebab-case")]
pub enum EditOutcome {
    /// A fillet.
    Fillet {
        /// How many chords, of each corner in the order in which they are listed.
        chords: Vec<u32>,
        /// The shortest chord.
        shortest_mm: f64,
        /// What it has to be at least.
        needed_mm: f64,
        /// The nearest radius of which no check warns: the one that was asked for where that is so; null where there is none.
        clear_mm: Option<f64>,
    },
    /// A fillet that cannot be made.
    NoFillet {
        /// The first corner at which it cannot.
        vertex: u32,
        /// What would be too short there.
        part: FilletPart,
        /// How long that would be.
        length_mm: f64,
        /// What it has to be at least.
        needed_mm: f64,
        /// The nearest radius that can be made at all corners, and where there is one such, of which no check warns; null where there
        /// is none.
        nearest_mm: Option<f64>,
    },
    /// A shape, which can be drawn whether its edges can be made or not.
    Shape {
        /// How many edges, all alike.
        edges: u32,
        /// How long each is.
        length_mm: f64,
        /// What it has to be at least.
        needed_mm: f64,
        /// Whether they can be made.
        fits: bool,
        /// The most edges of a turn, up to as many as are asked for, that can be made; null where no number of them can.
        fitting: Option<u32>,
    },
}

/// What of a fillet is too short.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum FilletPart {
    /// The chords: the radius is too small.
    Chords,
    /// What is left of an edge: the radius is too large.
    Edges,
}

impl Editor {
    /// What an edit would make, without making it; none of one that is neither a fillet of corners nor a shape.
    ///
    /// # Errors
    /// [`EditorError`] when the edit would be refused, but for a fillet that does not fit: that is an outcome.
    pub fn outcome(
        &self,
        app: &Installation,
        request: &EditRequest,
    ) -> Result<Option<EditOutcome>, EditorError> {
        let limits = changing::chord_limits(&self.document, app)?;
        let Some(edit) = request.of_figures(|| Ok(limits))? else { return Ok(None) };
        Ok(match edit.outcome(&self.document.wireframe, &limits) {
            Ok(outcome) => outcome.map(EditOutcome::from),
            Err(EditError::Fillet { vertex, length, min_edge, fault, nearest, radius: _ }) => {
                Some(EditOutcome::NoFillet {
                    vertex: vertex.0,
                    part: fault.into(),
                    length_mm: length.mm(),
                    needed_mm: min_edge.mm(),
                    nearest_mm: nearest.map(Length::mm),
                })
            }
            Err(error) => return Err(error.into()),
        })
    }
}

impl From<Outcome> for EditOutcome {
    fn from(outcome: Outcome) -> Self {
        match outcome {
            Outcome::Fillet(FilletOutcome { chords, shortest, needed, clear }) => Self::Fillet {
                chords,
                shortest_mm: shortest.mm(),
                needed_mm: needed.mm(),
                clear_mm: clear.map(Length::mm),
            },
            Outcome::Shape(ShapeOutcome { edges, length, needed, fits, fitting }) => {
                Self::Shape { edges, length_mm: length.mm(), needed_mm: needed.mm(), fits, fitting }
            }
        }
    }
}

impl From<FilletFault> for FilletPart {
    fn from(fault: FilletFault) -> Self {
        match fault {
            FilletFault::Chords => Self::Chords,
            FilletFault::Edges => Self::Edges,
        }
    }
}
