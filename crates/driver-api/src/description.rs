//! What a driver says of itself.

use std::collections::BTreeSet;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::Value;

/// What a driver is and can do. The same in every process and for every settings.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Description {
    /// Slug of lower-case letters, digits and hyphens: what machine profiles name as `driver.id`.
    #[schemars(regex(pattern = r"^[a-z0-9]+(-[a-z0-9]+)*$"))]
    pub id: String,
    /// Name for people.
    pub name: String,
    /// Version of the driver, such as `1.2.0`.
    pub version: String,
    /// A few sentences: which machines, what was and was not tried on one.
    pub description: String,
    /// What it can do.
    pub capabilities: BTreeSet<Capability>,
    /// The formats that it writes; empty unless it can export.
    #[serde(default)]
    pub formats: Vec<FormatDescription>,
    /// JSON Schema of its settings: an object, all of whose keys have defaults.
    pub settings_schema: Value,
}

/// Something that a driver can do.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Capability {
    /// Writes files.
    Export,
    /// Moves a machine.
    Live,
    /// Moves one axis at a person's word.
    Jog,
    /// Finds the machine's reference.
    Home,
    /// Holds the machine so that it can resume.
    Pause,
    /// Resumes after a pause.
    Resume,
    /// Stops the machine at once.
    Stop,
    /// Lists the ports that a machine can be at. Since 1.1.
    Ports,
    /// Writes its settings to the machine. Since 1.1.
    Settings,
    /// Makes dry runs: see [`Motion::dry`](crate::Motion::dry). Since 1.5.
    DryRun,
    /// Changes its speed while it runs. Since 1.5.
    Speed,
    /// Takes bends whose axis stops at zero or before it: see [`Step::approach_deg`](crate::Step::approach_deg). Since 1.6.
    BeforeZero,
    /// Passes on lines that a person types: see [`Call::Console`](crate::Call::Console). Since 1.7.
    Console,
    /// Cuts off what was bent, on a machine that has a cutter: see [`Call::Cut`](crate::Call::Cut). Since 1.7.
    Cut,
    /// Something of a later minor version, which this one does not know.
    #[serde(other)]
    #[schemars(skip)]
    Unknown,
}

/// A format that a driver writes.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct FormatDescription {
    /// Slug: what `--format` and machine profiles name.
    #[schemars(regex(pattern = r"^[a-z0-9]+(-[a-z0-9]+)*$"))]
    pub id: String,
    /// Name for people.
    pub name: String,
    /// File name extensions without their dot, the usual one first.
    pub extensions: Vec<String>,
    /// What is written.
    pub content: Content,
    /// How many files come of several wires.
    #[serde(default)]
    pub files: Files,
    /// Whether a machine runs it. Then it is not written for a design that cannot be made, unless a person says so.
    #[serde(default = "yes")]
    pub program: bool,
}

const fn yes() -> bool {
    true
}

/// What a format holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Content {
    /// The wire as designed, in canonical signs: for machines that compensate on their own.
    Design,
    /// What is sent to the machine's axes: compensated, in the machine's signs. Written for the machine
    /// of the job alone.
    Machine,
}

/// How many files come of several wires.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Files {
    /// One for each wire.
    #[default]
    EachWire,
    /// One for all.
    One,
}

impl Description {
    /// Whether it can do something.
    #[must_use]
    pub fn can(&self, capability: Capability) -> bool {
        self.capabilities.contains(&capability)
    }

    /// The format with this id.
    #[must_use]
    pub fn format(&self, id: &str) -> Option<&FormatDescription> {
        self.formats.iter().find(|format| format.id == id)
    }
}
