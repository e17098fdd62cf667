//! The order in which a frame is built, as `FrameFab`'s own program writes it (repository `yijiangh/choreo`).

use nalgebra::{Point3, Vector3};
use serde::Deserialize;
use wirebend_error::ErrorRemedy;

use super::super::error::{Location, ReadError};
use super::super::json;
use super::super::text::Source;
use crate::encoding::utf8;

/// An order of building, with the directions in which the tool can stand. Positions in mm.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct SequenceFile {
    /// The middle of the base, where the file states it.
    pub base_centre: Option<Point3<f64>>,
    pub steps: Vec<SequenceStep>,
}

/// A strut, from where the tool begins to where it ends.
#[derive(Debug, Clone, PartialEq)]
pub struct SequenceStep {
    pub start: Point3<f64>,
    pub end: Point3<f64>,
    pub kind: StrutKind,
    /// Directions of the tool's axis, from its tip, that are free; of length 1.
    pub directions: Vec<Vector3<f64>>,
}

/// What a strut joins.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StrutKind {
    /// The ground to a new joint.
    Ground,
    /// A built joint to a new one.
    Create,
    /// Two built joints.
    Connect,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    element_number: Option<usize>,
    support_number: Option<usize>,
    base_center_pt: Option<[f64; 3]>,
    sequenced_elements: Vec<Element>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Element {
    start_pt: [f64; 3],
    end_pt: [f64; 3],
    #[serde(rename = "type")]
    kind: String,
    feasible_orientation: Vec<[f64; 3]>,
}

/// Shortest direction that is one: the published ones have three decimals.
const MIN_DIRECTION: f64 = 0.5;

/// A direction as a file states it, of length 1; `None` for what has no length, or one that is no number.
#[must_use]
pub fn direction(parts: [f64; 3]) -> Option<Vector3<f64>> {
    let direction = Vector3::from(parts);
    let length = direction.norm();
    // Not only a length of zero: JSON has no NaN, but squares may be too large.
    (length.is_finite() && length >= MIN_DIRECTION).then(|| direction / length)
}

/// Reads a sequence.
///
/// # Errors
/// [`ReadError`] with the element, for what is no such file, an unknown type, a direction without length, and a count that is not that of
/// the list.
pub fn read_sequence(bytes: &[u8], name: &str) -> Result<SequenceFile, ReadError> {
    let source = Source { name };
    let file: File = json::parse(&utf8(bytes), source, "a FrameFab sequence with sequenced_elements")?;
    if file.sequenced_elements.is_empty() {
        return Err(ReadError::Empty {
            file: name.to_owned(),
            expected: "sequenced_elements",
            but: String::new(),
        });
    }
    let steps = file.sequenced_elements.iter().enumerate().map(|(k, element)| step(source, k, element));
    let steps: Vec<SequenceStep> = steps.collect::<Result<_, _>>()?;
    let ground = steps.iter().filter(|step| step.kind == StrutKind::Ground).count();
    for (stated, what, have) in [
        (file.element_number, "element_number", steps.len()),
        (file.support_number, "support_number", ground),
    ] {
        if let Some(stated) = stated.filter(|stated| *stated != have) {
            let available = format!("the list has {have}");
            let announced = format!("{what} says {stated}");
            return Err(ReadError::Truncated {
                file: name.to_owned(),
                place: Location::File,
                announced,
                available,
            });
        }
    }
    Ok(SequenceFile { base_centre: file.base_center_pt.map(Point3::from), steps })
}

fn step(source: Source<'_>, k: usize, element: &Element) -> Result<SequenceStep, ReadError> {
    let place = Location::Item("element", k);
    source.room(place.clone(), k, "elements")?;
    let kind = match element.kind.as_str() {
        "support" => StrutKind::Ground,
        "create" => StrutKind::Create,
        "connect" => StrutKind::Connect,
        other => {
            let expected = "type \"support\", \"create\" or \"connect\"";
            return Err(source.syntax(place, other, expected, ErrorRemedy::CorrectFile));
        }
    };
    let direction = |parts: &[f64; 3]| {
        if let Some(direction) = direction(*parts) {
            return Ok(direction);
        }
        let found = format!("the direction {parts:?}");
        Err(source.syntax(place.clone(), &found, "a direction of length 1", ErrorRemedy::CorrectFile))
    };
    Ok(SequenceStep {
        start: Point3::from(element.start_pt),
        end: Point3::from(element.end_pt),
        kind,
        directions: element.feasible_orientation.iter().map(direction).collect::<Result<_, _>>()?,
    })
}
