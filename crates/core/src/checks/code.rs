//! The names of findings.

use std::fmt;

macro_rules! codes {
    ($($(#[$doc:meta])* $name:ident = $text:literal,)*) => {
        /// The name of a kind of finding. It stays the same while figures and wording change, so that files, scripts
        /// and front ends can rely on it.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
        pub enum Code { $($(#[$doc])* $name,)* }

        impl Code {
            /// Every code, those of the drawing first.
            pub const ALL: &'static [Self] = &[$(Self::$name,)*];

            /// The code as files and the command line spell it: lower case with underscores.
            #[must_use]
            pub const fn as_str(self) -> &'static str {
                match self { $(Self::$name => $text,)* }
            }
        }
    };
}

codes! {
    /// An edge has no length, so that the wire has no direction along it.
    ZeroLengthEdge = "zero_length_edge",
    /// Two edges join the same two vertices.
    ParallelEdges = "parallel_edges",
    /// Two vertices lie within the weld tolerance of each other but are not merged.
    CoincidentVertices = "coincident_vertices",
    /// Two edges come closer than the wire is thick where nothing joins them.
    EdgesMeet = "edges_meet",
    /// A vertex has no edge, so that no wire passes through it.
    IsolatedVertex = "isolated_vertex",
    /// The wireframe is not connected: it takes several wires.
    SeveralWires = "several_wires",
    /// The wireframe has no edge to bend.
    NoEdges = "no_edges",
    /// No wire, or not so many wires as there may be, run through every edge once.
    NoEulerPath = "no_euler_path",
    /// The wanted start or the accepted doubled edges do not fit the wireframe, or it is too large to route.
    RouteRefused = "route_refused",
    /// A designed edge is shorter than the machine's shortest.
    EdgeTooShort = "edge_too_short",
    /// A designed edge is less than 5 % longer than the machine's shortest.
    EdgeNearLimit = "edge_near_limit",
    /// A bend is beyond the machine's largest.
    BendTooSharp = "bend_too_sharp",
    /// A bend is less than 5 % below the machine's largest.
    BendNearLimit = "bend_near_limit",
    /// With springback and setback added, the bend axis or the peg cannot reach a bend.
    BendOutOfReach = "bend_out_of_reach",
    /// A bend is so small that the peg would stop before it crosses the wire's axis.
    BendTooSmall = "bend_too_small",
    /// The wire ends so near before its first bend that the peg passes it.
    LeadTooShort = "lead_too_short",
    /// A corner is so near before a bend that the peg cannot press it.
    CornerTooNear = "corner_too_near",
    /// The peg meets wire that was bent before, and the bend is compensated for it.
    CornerWithinReach = "corner_within_reach",
    /// Where the peg meets bent wire depends on a bend head that was not measured.
    HeadNotMeasured = "head_not_measured",
    /// A bend is smaller than the scatter of the machine's bends.
    BendInScatter = "bend_in_scatter",
    /// A corner is smaller than the bend axis resolves, so that the wire goes straight on.
    CornerNotMade = "corner_not_made",
    /// The wire folds back on itself.
    FoldBack = "fold_back",
    /// The wire runs along an edge more than once.
    DoubledEdge = "doubled_edge",
    /// A feed is shorter than the machine's shortest once arcs are compensated.
    FeedTooShort = "feed_too_short",
    /// A compensated feed is less than 5 % longer than the machine's shortest.
    FeedNearLimit = "feed_near_limit",
    /// The arcs of the bends at both ends of an edge overlap.
    ArcsOverlap = "arcs_overlap",
    /// A single feed is longer than the machine can feed at once, or than its stock.
    FeedTooLong = "feed_too_long",
    /// The head cannot turn to where a bend needs it.
    RotationOutOfRange = "rotation_out_of_range",
    /// The wire and its unusable tail need more stock than the machine holds.
    StockTooLong = "stock_too_long",
    /// The wire is too thick or too thin for the machine.
    WireDoesNotFit = "wire_does_not_fit",
    /// The bend axis is hardly strong enough for the wire.
    BendTorqueLow = "bend_torque_low",
    /// The wire is bent round a smaller radius than it takes.
    BendRadiusSmall = "bend_radius_small",
    /// The part already bent sags so far that it no longer lies where the machine is to bend it.
    PartSags = "part_sags",
    /// The wire already bent meets a body of the machine.
    MeetsMachine = "meets_machine",
    /// The wire already bent meets the wire that is still to be bent.
    MeetsStock = "meets_stock",
    /// No program was found whose wire meets nothing.
    NoClearProgram = "no_clear_program",
    /// Nothing holds the frame, or a part of it.
    FrameUnsupported = "frame_unsupported",
    /// The frame, or a part of it, can move without bending anything.
    FrameMechanism = "frame_mechanism",
    /// A strut is stressed beyond where its material yields.
    StrutOverstressed = "strut_overstressed",
    /// A strut carries so much of its Euler load that a linear computation no longer holds.
    StrutNearBuckling = "strut_near_buckling",
    /// The frame, or what stands of it while it is built, sags too far under its own weight.
    FrameTooSoft = "frame_too_soft",
    /// A strut is to be built where nothing is that it could hang on.
    StrutFloating = "strut_floating",
    /// The head of the strut builder cannot stand in any direction while it places a strut.
    NoHeadDirection = "no_head_direction",
    /// The tip of the strut builder does not get to a vertex.
    OutOfWorkspace = "out_of_workspace",
    /// No order was found in which the struts can be built.
    SequenceNotFound = "sequence_not_found",
    /// A sequence is none of this design.
    SequenceWrong = "sequence_wrong",
}

impl fmt::Display for Code {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.as_str())
    }
}
