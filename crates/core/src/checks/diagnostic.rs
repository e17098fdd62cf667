//! A finding: what is wrong or worth knowing, and where.

use super::code::Code;
use super::fact::Fact;
use super::limit::{Limit, Quantity};
use super::remedy::Remedy;
use crate::wireframe::{EdgeId, VertexId};

/// How bad a finding is, worst first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// The machine cannot bend the wire.
    Error,
    /// The machine can bend the wire, but a value is near a limit or the result may differ from the design.
    Warning,
    /// Worth knowing; nothing is wrong.
    Info,
}

/// Where in a design and its program a finding is. All fields are empty where it is about the whole design.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Location {
    /// The vertices that it is about, the most important one first.
    pub vertices: Vec<VertexId>,
    /// The edges that it is about, the most important one first; of a straight all, in the order of the walk.
    pub edges: Vec<EdgeId>,
    /// Index of the program's step, from 0; none where the finding is about the drawing.
    pub step: Option<usize>,
}

impl Location {
    /// A location of vertices alone.
    #[must_use]
    pub fn at_vertices(vertices: impl IntoIterator<Item = VertexId>) -> Self {
        Self { vertices: vertices.into_iter().collect(), ..Self::default() }
    }

    /// A location of edges alone.
    #[must_use]
    pub fn at_edges(edges: impl IntoIterator<Item = EdgeId>) -> Self {
        Self { edges: edges.into_iter().collect(), ..Self::default() }
    }
}

/// A finding of the checks: facts, without a word of prose. Sentences are made of it by the rooms that talk to people.
#[derive(Debug, Clone, PartialEq)]
pub struct Diagnostic {
    /// How bad it is.
    pub severity: Severity,
    /// Where it is.
    pub location: Location,
    /// What it says, with its figures.
    pub fact: Fact,
    /// What can be done about it, the most promising first.
    pub remedies: Vec<Remedy>,
}

impl Diagnostic {
    /// The name of this kind of finding.
    #[must_use]
    pub const fn code(&self) -> Code {
        self.fact.code()
    }

    /// What was measured or counted; see [`Fact::measured`].
    #[must_use]
    pub fn measured(&self) -> Option<Quantity> {
        self.fact.measured()
    }

    /// The limit that the measured value is held against; see [`Fact::limit`].
    #[must_use]
    pub fn limit(&self) -> Option<Limit<'_>> {
        self.fact.limit()
    }

    /// Whether the machine cannot bend the wire because of it.
    #[must_use]
    pub fn is_error(&self) -> bool {
        self.severity == Severity::Error
    }
}
