//! What a finding says, as figures.

mod bend_of;
mod code;
mod figures;
mod meeting;

use super::{BendRadius, ReachLimit, Source, Sourced};
use crate::bend::PathError;
use crate::checks::sequence::Violation;
use crate::clearance::Obstacle;
use crate::compensate::NearCorner;
use crate::route::RouteError;
use crate::sag::Sag;
use crate::search::Helps;
use crate::units::{Angle, Length};
use crate::wireframe::{EdgeId, VertexId};
pub use bend_of::{BendOf, ClosingBend};
pub use meeting::Meeting;

/// What a finding says, beyond how bad it is and where.
///
/// Each variant belongs to one [`Code`](super::Code). Bends are signed as scheduled, or magnitudes where no side is chosen yet.
#[derive(Debug, Clone, PartialEq)]
pub enum Fact {
    /// An edge of the drawing has no length.
    ZeroLengthEdge {
        /// The edge.
        edge: EdgeId,
        /// The vertices that it joins.
        ends: [VertexId; 2],
        /// Its length: zero but for rounding.
        length: Length,
    },
    /// The vertices of the route are no path that a wire can follow.
    NoPath(PathError),
    /// Two edges join the same two vertices.
    ParallelEdges {
        /// The edges, the one that was drawn first foremost.
        edges: [EdgeId; 2],
        /// The vertices that both join.
        ends: [VertexId; 2],
    },
    /// Two vertices lie on each other but are not merged.
    CoincidentVertices {
        /// The vertices, the one with the lower id foremost.
        vertices: [VertexId; 2],
        /// How far they are apart.
        distance: Length,
        /// Up to this distance vertices are taken to be meant as one.
        tolerance: Length,
    },
    /// Two edges come closer than the wire is thick where nothing joins them.
    EdgesMeet {
        /// The edges, the one with the lower id foremost.
        edges: [EdgeId; 2],
        /// The vertex of each of them that is within the diameter of the place.
        near: [Option<VertexId>; 2],
        /// The first vertex of each of them.
        from: [VertexId; 2],
        /// How far along each of them the place is, from its first vertex.
        along: [Length; 2],
        /// How far the centrelines are apart there.
        distance: Length,
        /// Diameter of the wire.
        diameter: Length,
        /// The bend that closes the gap, where a wire has a program along both.
        closing: Option<ClosingBend>,
    },
    /// A vertex has no edge.
    IsolatedVertex {
        /// The vertex.
        vertex: VertexId,
    },
    /// The wireframe is not connected.
    SeveralWires {
        /// How many wires it takes.
        wires: usize,
    },
    /// The wireframe has no edges.
    NoEdges,
    /// Too many vertices have an odd number of edges.
    NoEulerPath {
        /// How many vertices are odd.
        odd: usize,
        /// How many may be: the two ends of an open wire, none of a closed one.
        allowed: usize,
    },
    /// There is no route as it was asked for.
    RouteRefused(RouteError),
    /// The wire, or several wires, run along an edge more than once.
    DoubledEdge {
        /// The edge.
        edge: EdgeId,
        /// How many times all wires together run along it, two or more.
        passes: usize,
    },
    /// A designed edge, or a straight of several, is shorter than the machine's shortest.
    EdgeTooShort {
        /// Designed length.
        length: Length,
        /// The shortest that the machine can make.
        limit: Sourced<Length>,
    },
    /// A designed edge, or a straight of several, is hardly longer than the machine's shortest.
    EdgeNearLimit {
        /// Designed length.
        length: Length,
        /// The shortest that the machine can make.
        limit: Sourced<Length>,
    },
    /// A compensated feed is shorter than the machine's shortest.
    FeedTooShort {
        /// Length as designed, from vertex to vertex.
        designed: Length,
        /// Length to feed after compensation.
        feed: Length,
        /// The shortest feed of the machine.
        limit: Sourced<Length>,
        /// The bend at its end, where the peg cannot press it so near to a corner or the end of the wire.
        unpressed: Option<Angle>,
    },
    /// A compensated feed is hardly longer than the machine's shortest.
    FeedNearLimit {
        /// Length as designed, from vertex to vertex.
        designed: Length,
        /// Length to feed after compensation.
        feed: Length,
        /// The shortest feed of the machine.
        limit: Sourced<Length>,
    },
    /// A feed is longer than the machine can feed at once.
    FeedTooLong {
        /// Length as designed, from vertex to vertex.
        designed: Length,
        /// Length to feed after compensation.
        feed: Length,
        /// The longest feed of the machine.
        limit: Sourced<Length>,
    },
    /// A single feed is longer than what can be used of the machine's stock.
    FeedLongerThanStock {
        /// Length as designed, from vertex to vertex.
        designed: Length,
        /// Length to feed after compensation.
        feed: Length,
        /// The longest stock less its unusable tail; the source is that of the stock.
        limit: Sourced<Length>,
    },
    /// The arcs of the bends at both ends of an edge need more than its length.
    ArcsOverlap {
        /// Designed length of the edge.
        designed: Length,
        /// What the arcs take of it, from corner to tangent point.
        needed: Length,
        /// Centreline radius of the bends.
        bend_radius: Length,
    },
    /// The wire needs more stock than the machine holds.
    StockTooLong {
        /// All feeds and the tail.
        needed: Length,
        /// The end of the stock that cannot be fed.
        tail: Length,
        /// The longest stock of the machine.
        limit: Sourced<Length>,
    },
    /// A bend is beyond the machine's largest.
    BendTooSharp {
        /// The bend.
        bend: Angle,
        /// Which bend this is.
        of: BendOf,
        /// The largest bend to this side, with its sign.
        limit: Sourced<Angle>,
    },
    /// A bend is hardly smaller than the machine's largest.
    BendNearLimit {
        /// The bend.
        bend: Angle,
        /// The largest bend to this side, with its sign.
        limit: Sourced<Angle>,
    },
    /// The bend axis or the peg cannot reach a bend that is within the machine's limits.
    BendOutOfReach {
        /// The bend.
        bend: Angle,
        /// Which bend this is.
        of: BendOf,
        /// The largest bend that can be reached to this side, as a magnitude.
        max: Angle,
        /// What ends the reach.
        reach: ReachLimit,
    },
    /// The peg would have to stop before it crosses the wire's axis.
    BendTooSmall {
        /// The bend.
        bend: Angle,
    },
    /// The wire before its first bend ends before the peg touches it.
    LeadTooShort {
        /// The bend.
        bend: Angle,
        /// How long the wire is where the bend begins.
        lead: Length,
        /// How long it has to be.
        needed: Length,
    },
    /// A corner before a bend is so near that the peg cannot press it.
    CornerTooNear {
        /// The bend.
        bend: Angle,
    },
    /// The peg of a bend meets wire that was bent before.
    CornerWithinReach(NearCorner),
    /// The bend head was not measured, on which it depends where the peg of so many bends meets bent wire.
    HeadNotMeasured(usize),
    /// A bend is smaller than the scatter of the machine's bends, so that it may come out to either side.
    BendInScatter {
        /// The bend, as a magnitude.
        bend: Angle,
        /// How far bends scatter, as one standard deviation.
        scatter: Sourced<Angle>,
    },
    /// A corner is smaller than the bend axis resolves.
    CornerNotMade {
        /// Where it is.
        vertex: VertexId,
        /// The change of direction.
        corner: Angle,
        /// A change of direction up to this is not bent.
        straight: Angle,
    },
    /// The wire folds straight back: a bend of 180°.
    FoldBack {
        /// The largest bend to the side that is taken, with its sign.
        limit: Sourced<Angle>,
    },
    /// A bend is so close to 180° that feeds cannot be compensated for its corner.
    FoldBackNotCompensated {
        /// The bend.
        bend: Angle,
    },
    /// The head cannot turn to where a bend needs it.
    RotationOutOfRange {
        /// The angle nearest to zero at which the bend could be made; others are half a turn apart.
        wanted: Angle,
        /// Whether it is where the head is sent for that, with what it is off by.
        commanded: bool,
        /// The lowest and the highest angle of the head.
        range: [Angle; 2],
        /// Where the limit comes from that `wanted` is beyond.
        source: Source,
    },
    /// The wire is thinner or thicker than the machine takes.
    WireDoesNotFit {
        /// Diameter of the wire.
        diameter: Length,
        /// The thinnest and the thickest wire of the machine.
        range: [Length; 2],
        /// Where the limit comes from that the wire is beyond.
        source: Source,
    },
    /// The bend axis is hardly strong enough for the wire.
    BendTorqueLow {
        /// Plastic moment of the wire, N·m.
        needed_n_m: f64,
        /// What the axis has, N·m.
        available_n_m: Sourced<f64>,
        /// So many times the moment it should have.
        margin: f64,
    },
    /// The wire is bent round a smaller radius than it takes.
    BendRadiusSmall(BendRadius),
    /// The part already bent sags by more than a tenth of its reach.
    PartSags(Sag),
    /// The wire already bent meets a body of the machine.
    MeetsMachine {
        /// How.
        meeting: Meeting,
        /// What the body is called.
        body: String,
        /// Whether its dimensions were measured.
        measured: bool,
        /// None of it is allowed; the source is that of the body's dimensions.
        limit: Sourced<Length>,
    },
    /// The wire already bent meets the wire that is still to be bent.
    MeetsStock(Meeting),
    /// A search has found no program whose wire meets nothing.
    NoClearProgram {
        /// How many steps were checked.
        checks: u64,
        /// Whether every walk of one wire was tried.
        exhausted: bool,
        /// What was in the way where it came farthest; none where it came nowhere, or where the head could not turn so far.
        obstacle: Option<Obstacle>,
        /// What that is called, where it is a body of the machine.
        body: Option<String>,
        /// How many edges were passed there, and how many there are, counted as often as they are to be passed.
        passed: Option<(usize, usize)>,
        /// How far the wire had to stay from what it could hit.
        clearance: Length,
        /// Which changes were tried and help.
        helps: Helps,
    },
    /// Nothing holds the frame, or a part of it.
    FrameUnsupported {
        /// How many edges the part has.
        edges: usize,
        /// Whether nothing else is held either.
        whole: bool,
    },
    /// The frame, or a part of it, can move without bending anything.
    FrameMechanism,
    /// What loads do to the frame is far more than it is large, so that nothing computed of it means anything.
    FrameHardlyStands {
        /// How far the vertex would move that moves most.
        displacement: Length,
        /// The diagonal of the box around the frame.
        size: Length,
    },
    /// A strut is stressed beyond where its material yields.
    StrutOverstressed {
        /// The largest von Mises stress along it, in MPa.
        stress_mpa: f64,
        /// Where its material yields, in MPa.
        yield_mpa: f64,
        /// Where that comes from.
        source: Source,
    },
    /// A strut carries so much of its Euler load that a linear computation no longer holds.
    StrutNearBuckling {
        /// Its compression over that load.
        ratio: f64,
        /// From this ratio on.
        limit: f64,
    },
    /// The finished frame, or what stands before a strut is built, sags too far.
    FrameTooSoft {
        /// How far the vertex moves that moves most.
        sag: Length,
        /// How far a joint may be from where it is drawn.
        max: Length,
        /// The strut that would come next; none where the frame is finished.
        without: Option<EdgeId>,
    },
    /// Without a strut others would hang on nothing, or it would itself.
    StrutFloating {
        /// The strut.
        edge: Option<EdgeId>,
    },
    /// The head cannot stand in any direction while it places a strut.
    NoHeadDirection {
        /// The strut.
        edge: Option<EdgeId>,
        /// How many struts are in the way of some directions.
        blocking: usize,
    },
    /// The tip does not get to a vertex.
    OutOfWorkspace,
    /// No order was found in which the struts can be built.
    SequenceNotFound {
        /// How many groups stand where the search got stuck, none of which can have been the last; none where it did not.
        step: Option<usize>,
        /// How many there are.
        of: usize,
        /// Whether every order was tried.
        proved: bool,
    },
    /// A step of a sequence cannot be made.
    SequenceStep(Violation),
}
