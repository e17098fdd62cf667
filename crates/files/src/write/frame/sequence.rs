//! An order of building, as `FrameFab`'s own program writes it.

use serde_json::{Value, json};

use crate::read::frame::{SequenceFile, StrutKind};

/// Writes a sequence; reading it gives the same.
#[must_use]
pub fn framefab_sequence(sequence: &SequenceFile) -> String {
    let ground = sequence.steps.iter().filter(|step| step.kind == StrutKind::Ground).count();
    let elements = sequence.steps.iter().map(|step| {
        let kind = match step.kind {
            StrutKind::Ground => "support",
            StrutKind::Create => "create",
            StrutKind::Connect => "connect",
        };
        let [start, end] = [step.start, step.end].map(|point| <[f64; 3]>::from(point.coords));
        let directions: Vec<[f64; 3]> = step.directions.iter().map(|direction| (*direction).into()).collect();
        json!({
            "start_pt": start,
            "end_pt": end,
            "type": kind,
            "feasible_orientation": directions,
        })
    });
    let mut file = json!({
        "element_number": sequence.steps.len(),
        "support_number": ground,
        "sequenced_elements": elements.collect::<Vec<Value>>(),
    });
    if let Some(centre) = sequence.base_centre {
        file["base_center_pt"] = json!(<[f64; 3]>::from(centre.coords));
    }
    format!("{file:#}\n")
}
