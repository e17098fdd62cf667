//! What a check says.

use std::fmt;

use crate::units::{Angle, Length};
use crate::wireframe::{EdgeId, VertexId};

/// How bad it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// The machine cannot make it.
    Error,
    /// Near a limit, or worth a look.
    Warning,
    /// Good to know.
    Info,
}

macro_rules! codes {
    ($($(#[$doc:meta])* $name:ident = $text:literal,)*) => {
        /// What a diagnostic is about: a name that stays the same while its wording may change.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
        pub enum Code { $($(#[$doc])* $name,)* }

        impl Code {
            /// Every code.
            pub const ALL: &'static [Self] = &[$(Self::$name,)*];

            /// The name in files and on the command line.
            #[must_use]
            pub const fn as_str(self) -> &'static str {
                match self { $(Self::$name => $text,)* }
            }
        }
    };
}

codes! {
    /// An edge without length.
    ZeroLengthEdge = "zero_length_edge",
    /// Two edges join the same vertices.
    ParallelEdges = "parallel_edges",
    /// Vertices that lie on each other but are not one.
    CoincidentVertices = "coincident_vertices",
    /// A vertex without an edge.
    IsolatedVertex = "isolated_vertex",
    /// The wireframe is not connected: it takes several wires.
    SeveralWires = "several_wires",
    /// There is nothing to bend.
    NoEdges = "no_edges",
    /// No walk uses every edge once.
    NoEulerPath = "no_euler_path",
    /// A wanted start or doubling does not fit the wireframe.
    RouteRefused = "route_refused",
    /// A designed edge is shorter than the machine can make.
    EdgeTooShort = "edge_too_short",
    /// A designed edge is hardly longer than the shortest.
    EdgeNearLimit = "edge_near_limit",
    /// A bend is larger than the machine makes.
    BendTooSharp = "bend_too_sharp",
    /// A bend is hardly smaller than the largest.
    BendNearLimit = "bend_near_limit",
    /// The bend axis cannot reach what springback and setback ask for.
    BendOutOfReach = "bend_out_of_reach",
    /// A bend is smaller than the peg can make.
    BendTooSmall = "bend_too_small",
    /// A bend is smaller than bends scatter on the machine.
    BendInScatter = "bend_in_scatter",
    /// A corner is gentler than the bend axis resolves.
    CornerNotMade = "corner_not_made",
    /// The wire folds straight back.
    FoldBack = "fold_back",
    /// An edge is made of two wires side by side.
    DoubledEdge = "doubled_edge",
    /// After compensation a feed is shorter than the machine can make.
    FeedTooShort = "feed_too_short",
    /// After compensation a feed is hardly longer than the shortest.
    FeedNearLimit = "feed_near_limit",
    /// The arcs at both ends of an edge overlap.
    ArcsOverlap = "arcs_overlap",
    /// A single feed is longer than the machine can make.
    FeedTooLong = "feed_too_long",
    /// The head cannot turn to where a bend needs it.
    RotationOutOfRange = "rotation_out_of_range",
    /// The wire takes more stock than the machine holds.
    StockTooLong = "stock_too_long",
    /// The wire is too thick or too thin for the machine.
    WireDoesNotFit = "wire_does_not_fit",
}

impl fmt::Display for Code {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.as_str())
    }
}

/// What was measured, or may be.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Quantity {
    /// A length.
    Length(Length),
    /// An angle.
    Angle(Angle),
    /// A number of things.
    Count(usize),
}

impl fmt::Display for Quantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Length(length) => length.fmt(f),
            Self::Angle(angle) => angle.fmt(f),
            Self::Count(count) => count.fmt(f),
        }
    }
}

/// A limit that a measured value is held against.
#[derive(Debug, Clone, PartialEq)]
pub struct Limit {
    /// Its value.
    pub value: Quantity,
    /// Where it comes from.
    pub source: String,
}

/// Where it is.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Place {
    /// Vertices, the first one foremost.
    pub vertices: Vec<VertexId>,
    /// Edges, the first one foremost.
    pub edges: Vec<EdgeId>,
    /// Index of the step in the program, from 0.
    pub step: Option<usize>,
}

impl Place {
    /// At some vertices.
    #[must_use]
    pub fn at_vertices(vertices: impl IntoIterator<Item = VertexId>) -> Self {
        Self { vertices: vertices.into_iter().collect(), ..Self::default() }
    }

    /// At some edges.
    #[must_use]
    pub fn at_edges(edges: impl IntoIterator<Item = EdgeId>) -> Self {
        Self { edges: edges.into_iter().collect(), ..Self::default() }
    }
}

/// One thing to know about a design.
#[derive(Debug, Clone, PartialEq)]
pub struct Diagnostic {
    /// What it is about.
    pub code: Code,
    /// How bad it is.
    pub severity: Severity,
    /// Where it is.
    pub place: Place,
    /// What was measured.
    pub measured: Option<Quantity>,
    /// What it was held against.
    pub limit: Option<Limit>,
    /// What it is, in a sentence without full stop.
    pub message: String,
    /// What to do.
    pub help: String,
}

impl Diagnostic {
    /// Whether the wire cannot be made because of it.
    #[must_use]
    pub fn is_error(&self) -> bool {
        self.severity == Severity::Error
    }
}
