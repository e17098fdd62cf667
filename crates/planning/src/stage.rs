//! The names of the stages of the pipeline.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A stage of the pipeline.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum StageName {
    /// The surface that was read.
    Stencil,
    /// The graph that was read.
    Wireframe,
    /// The walk along every edge.
    Route,
    /// The nominal program.
    Program,
    /// Signs and turns of the head.
    Schedule,
    /// What is sent to the machine.
    Compensated,
    /// The sealed job.
    Job,
}

impl StageName {
    /// Every stage, in the order of the pipeline.
    pub const ALL: [Self; 7] = [
        Self::Stencil,
        Self::Wireframe,
        Self::Route,
        Self::Program,
        Self::Schedule,
        Self::Compensated,
        Self::Job,
    ];

    /// The name on the command line.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Stencil => "stencil",
            Self::Wireframe => "wireframe",
            Self::Route => "route",
            Self::Program => "program",
            Self::Schedule => "schedule",
            Self::Compensated => "compensated",
            Self::Job => "job",
        }
    }

    /// What it leaves, for a person.
    #[must_use]
    pub const fn in_words(self) -> &'static str {
        match self {
            Self::Compensated => "compensated program",
            other => other.as_str(),
        }
    }
}
