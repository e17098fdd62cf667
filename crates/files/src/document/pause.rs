//! Pause points: where a person does something to the wire while it is bent.

use std::num::NonZeroU32;

use schemars::JsonSchema;
use serde::{Deserialize, Deserializer, Serialize, de::Error as _};
use wirebend_core::wireframe::VertexId;

/// A vertex at which the machine waits for a person.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PausePoint {
    pub vertex: VertexId,
    /// Which time the wires come to the vertex, from 1, over all wires in their order.
    pub pass: NonZeroU32,
    /// What the person has to do.
    pub note: String,
}

/// A vertex at which the machine waits for a person.
#[derive(Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "PausePoint")]
pub(crate) struct PausePointFile {
    /// The vertex, by id.
    vertex: u32,
    /// Which time the wires come to the vertex, from 1, over all wires in their order.
    #[serde(default = "first", skip_serializing_if = "is_first")]
    pass: NonZeroU32,
    /// What the person has to do.
    #[serde(deserialize_with = "note")]
    #[schemars(with = "String", length(min = 1))]
    note: String,
}

/// A step of a job after which the machine waits for a person.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct JobPause {
    /// The step, from 1. It is never the last of the wire.
    #[schemars(range(min = 1))]
    pub after: u32,
    /// What the person has to do.
    #[serde(deserialize_with = "note")]
    #[schemars(with = "String", length(min = 1))]
    pub note: String,
}

/// What is said at a pause point, on one line; `None` where that is nothing.
#[must_use]
pub fn pause_note(text: &str) -> Option<String> {
    let words: Vec<&str> = text.split_whitespace().collect();
    (!words.is_empty()).then(|| words.join(" "))
}

impl From<&PausePoint> for PausePointFile {
    fn from(pause: &PausePoint) -> Self {
        Self { vertex: pause.vertex.0, pass: pause.pass, note: pause.note.clone() }
    }
}

impl From<PausePointFile> for PausePoint {
    fn from(PausePointFile { vertex, pass, note }: PausePointFile) -> Self {
        Self { vertex: VertexId(vertex), pass, note }
    }
}

fn note<'de, D: Deserializer<'de>>(deserializer: D) -> Result<String, D::Error> {
    let text = String::deserialize(deserializer)?;
    // As it was written: the hash of a job is of that.
    if pause_note(&text).is_some() {
        Ok(text)
    } else {
        Err(D::Error::custom("a pause point says what to do: its note is empty"))
    }
}

const fn first() -> NonZeroU32 {
    NonZeroU32::MIN
}

#[allow(clippy::trivially_copy_pass_by_ref)] // as serde asks
const fn is_first(pass: &NonZeroU32) -> bool {
    pass.get() == 1
}
