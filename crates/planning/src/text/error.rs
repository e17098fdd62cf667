//! Errors of the pure rooms as a person reads them: what is wrong, and what would be right.

use wirebend_accuracy::ClosingError;
use wirebend_core::compensate::{PegGeometryError, PegRadius, SpringbackError};
use wirebend_core::route::RouteError;
use wirebend_core::simulate::{BadErrorTerm, ErrorSource};
use wirebend_core::units::{Length, Mm};
use wirebend_core::wireframe::{EditError, FilletFault};
use wirebend_files::number::thousands;

use super::number::count;

/// The most vertices that a list names.
const MAX_NAMED: usize = 6;

/// Why a wire has no route as it was asked for.
pub(super) fn route(error: &RouteError) -> String {
    match error {
        RouteError::NoEdges => "the wire has no edge to run along".to_owned(),
        RouteError::Odd { odd, allowed } => {
            let allowed = if *allowed == 0 { "none".to_owned() } else { allowed.to_string() };
            format!("{} odd; {allowed} may be", count(odd.len(), "vertex is", "vertices are"))
        }
        RouteError::Start { start, ends } => {
            let first: Vec<String> = ends.iter().take(MAX_NAMED).map(ToString::to_string).collect();
            let more = match ends.len().saturating_sub(MAX_NAMED) {
                0 => String::new(),
                more => format!(" and {more} more"),
            };
            let ends = first.join(", ") + &more;
            format!("the wire cannot start at vertex {start}: it has to start at an odd corner ({ends})")
        }
        RouteError::StartElsewhere(vertex) => {
            format!("vertex {vertex} has no edge of this wire to start along")
        }
        RouteError::DoubledElsewhere(edge) => {
            format!("edge {edge} is to be doubled but is not part of this wire")
        }
        RouteError::TooManyEnds { vertex, ends, max } => {
            format!(
                "{ends} edge ends meet at vertex {vertex}, doubled edges counted twice: a route can be found for up to {max}"
            )
        }
        RouteError::TooLong => {
            "the edges are more than a thousand million, or 288,000 km long or more together".to_owned()
        }
    }
}

/// Why an edit cannot be made.
#[must_use]
pub fn edit(error: &EditError) -> String {
    match error {
        EditError::Wireframe(error) => error.to_string(),
        EditError::NoEdge(edge) => format!("there is no edge {edge}"),
        EditError::Repeated(vertex) => format!("vertex {vertex} is listed twice"),
        EditError::Loop(vertex) => format!("vertex {vertex} cannot be connected to itself"),
        EditError::RepeatedEdge(edge) => format!("edge {edge} is listed twice"),
        EditError::ChainCount(edges) => format!("a chain takes at least 2 edges, {edges} given"),
        EditError::Branched { vertex, edges } => {
            format!("the edges are no chain: {edges} of them meet at vertex {vertex}, and at most 2 can")
        }
        EditError::BrokenChain(edge) => {
            format!("the edges are no chain: edge {edge} is not connected to the others")
        }
        EditError::ClosedChain => "the edges are a closed loop, and a chain has two ends".to_owned(),
        EditError::ArcStep(step) => {
            format!("the step along an arc has to be more than 0° and at most 180°: {step:.3} is not")
        }
        EditError::SmallArc { radius, min_edge } => {
            format!("an arc of radius {radius:.2} cannot be made of edges of at least {min_edge:.2}")
        }
        EditError::EdgeLength(mm) => format!("{} is no length of an edge: it has to be more than 0", Mm(*mm)),
        EditError::CornerAngle(deg) => {
            format!("{deg}° is no angle between edges: it has to be more than 0° and at most 180°")
        }
        EditError::NotAnEnd { edge, vertex } => format!("vertex {vertex} is not an end of edge {edge}"),
        EditError::NoDirection(edge) => {
            format!("the ends of edge {edge} are at the same place, so it has no direction")
        }
        EditError::NoCorner { vertex, edges } => {
            format!("vertex {vertex} has {}, and an angle is between 2", count(*edges, "edge", "edges"))
        }
        EditError::SameEnds(one, other) => format!("edges {one} and {other} join the same two vertices"),
        EditError::InLine(vertex) => {
            format!(
                "the two edges at vertex {vertex} are in line, which leaves open in which plane to turn one"
            )
        }
        EditError::InLoop(edge) => {
            format!(
                "edge {edge} is part of a closed loop: the rest is connected to both of its ends and cannot follow one"
            )
        }
        EditError::FilletRadius(mm) => {
            format!("{} is no radius of a fillet: it has to be more than 0", Mm(*mm))
        }
        EditError::StraightCorner(vertex) => {
            format!("the edges at vertex {vertex} are in line or on each other: there is no corner to round")
        }
        EditError::HeldCorner(vertex) => {
            format!("vertex {vertex} is a support or has a joint, which a fillet would move")
        }
        EditError::Fillet { vertex, radius, min_edge, fault, length: _, nearest: _ } => match fault {
            FilletFault::Chords => format!(
                "the chords of a fillet of {radius:.1} at vertex {vertex} would be shorter than {min_edge:.1}, the shortest that can be made there"
            ),
            FilletFault::Edges if *min_edge > Length::ZERO => format!(
                "what a fillet of {radius:.1} leaves of the edges at vertex {vertex} would be shorter than {min_edge:.1}, the shortest that can be made there"
            ),
            FilletFault::Edges => {
                format!("the edges at vertex {vertex} are too short for a fillet of {radius:.1}")
            }
        },
        EditError::Sides { sides, max } => {
            format!("a polygon has from 3 to {} sides, and not {sides}", thousands(&max.to_string()))
        }
        EditError::ShapeSize(mm) => format!("{} is no size: it has to be more than 0", Mm(*mm)),
        EditError::Turns(turns) => {
            format!("a helix has more than 0 and at most {} turns, and not {turns}", thousands("10000"))
        }
        EditError::Connected(a, b) => format!("vertices {a} and {b} are connected already"),
        EditError::SplitAt(at) => {
            format!("an edge is split between its ends: {at} is not more than 0 and less than 1")
        }
        EditError::MergeCount(vertices) => format!("merging takes at least 2 vertices, {vertices} given"),
        EditError::Singular => "the transform is not invertible: it would flatten the wireframe".to_owned(),
        EditError::EmptyStrand => "a strand takes a vertex to begin at or a point to go through".to_owned(),
        EditError::TooMuch { count, max } => {
            let (count, max) = (thousands(&count.to_string()), thousands(&max.to_string()));
            format!("{count} vertices or edges are too many: at most {max} can be added at once")
        }
        EditError::NotInPiece { index, count } => {
            format!("an edge of the piece ends at its vertex {index}, but it has {count}, counted from 0")
        }
        EditError::ArrayCount { copies, max } => {
            let max = thousands(&max.to_string());
            format!("an array of {copies} copies is too large: at most {max} vertices can be added at once")
        }
    }
}

/// Why the dimensions of a machine are not those of a peg bender.
#[must_use]
pub fn peg_geometry(error: &PegGeometryError) -> String {
    match error {
        PegGeometryError::NotPositive { radius, value } => {
            let name = match radius {
                PegRadius::Orbit => "orbit radius",
                PegRadius::Pin => "pin radius",
                PegRadius::Peg => "peg radius",
            };
            format!("the {name} is {value}: it must be more than 0")
        }
        PegGeometryError::NoContact { orbit_radius, peg } => format!(
            "the peg never touches the wire: its orbit of radius {orbit_radius} is smaller than its contact distance {peg}"
        ),
        PegGeometryError::Behind { offset, orbit_radius } => format!(
            "the peg never touches the wire: with an orbit offset of {offset} its orbit of radius {orbit_radius} ends before the pin"
        ),
    }
}

/// Why measured pairs are no springback table.
#[must_use]
pub fn springback(error: &SpringbackError) -> String {
    match error {
        SpringbackError::Empty => "the springback table needs at least one measured pair".to_owned(),
        SpringbackError::Range(pair) => format!(
            "pair {} of the springback table: the formed angle and the loss must not be negative",
            pair + 1
        ),
        SpringbackError::NotIncreasing(pair) => format!(
            "pair {} of the springback table: both the formed angle and the formed angle plus loss must increase",
            pair + 1
        ),
    }
}

/// Why the joints of a frame cannot be closed.
#[must_use]
pub fn closing(error: &ClosingError) -> String {
    match error {
        ClosingError::NoVertex { wire, vertex, vertices } => {
            format!("wire {} passes vertex {vertex}, and there are {vertices}", wire + 1)
        }
        ClosingError::OtherProgram { wire, struts, segments } => format!(
            "wire {} runs along {struts} edges, and its program has {segments} straight parts",
            wire + 1
        ),
        ClosingError::SeveralParts { parts } => format!(
            "the design is in {parts} parts: how far each is off from the other is not known before something joins them"
        ),
        ClosingError::Model(error) => format!("the wires are no frame: {error}"),
        ClosingError::Unstable(error) => format!("the closed frame does not hold together: {error}"),
        ClosingError::Errors(error) => noise(error),
        ClosingError::Bowed => {
            "struts that are bowed at random have no exact expectation: wires have to be drawn".to_owned()
        }
    }
}

/// Why an error model is none.
#[must_use]
pub fn noise(error: &BadErrorTerm) -> String {
    let BadErrorTerm { of, bias, sigma } = error;
    let name = match of {
        ErrorSource::Feed => "feeds",
        ErrorSource::Rotation => "rotations",
        ErrorSource::Bend => "bends",
        ErrorSource::Curvature => "curvature",
    };
    format!("the error of {name} is {bias} ± {sigma}: both must be finite and the deviation not negative")
}

#[cfg(test)]
mod tests;
