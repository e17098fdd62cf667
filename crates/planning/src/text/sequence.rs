//! The order in which struts are built. Steps count from 1, as a person builds them.

use wirebend_core::checks::Location;
use wirebend_core::sequence::{StepKind, Violation};
use wirebend_core::units::Length;
use wirebend_core::wireframe::EdgeId;

use super::number::count;

pub(super) fn too_soft(at: &Location, sag: Length, max: Length, without: Option<EdgeId>) -> String {
    let vertex = at.vertices.first().map(|vertex| format!(" at vertex {vertex}")).unwrap_or_default();
    let limits = format!("{sag:.3}{vertex}, and a joint may be {max:.3} off");
    match without {
        None => format!("the finished frame sags by {limits}"),
        Some(edge) => format!("without edge {edge} what stands sags by {limits}"),
    }
}

pub(super) fn floating(edge: Option<EdgeId>) -> String {
    format!("without {} something would hang on nothing", strut(edge))
}

pub(super) fn no_direction(edge: Option<EdgeId>, blocking: usize) -> String {
    let blocking = count(blocking, "strut is", "struts are");
    format!("the head cannot stand in any direction while it places {}: {blocking} in its way", strut(edge))
}

pub(super) fn out_of_reach(at: &Location) -> String {
    match at.vertices.first() {
        Some(vertex) => format!("vertex {vertex} is outside the machine's workspace"),
        None => "the frame is outside the machine's workspace".to_owned(),
    }
}

pub(super) fn not_found(step: Option<usize>, of: usize, proved: bool) -> String {
    let parts = count(of, "part", "parts");
    match (step, proved) {
        (Some(step), true) => {
            format!(
                "the {parts} can be built in no order: none of the last {step} that stand can have come last"
            )
        }
        (None, true) => format!("the {parts} can be built in no order"),
        (Some(step), false) => {
            format!(
                "no sequence of the {parts} was found: the search came to {step} of which none can have come last"
            )
        }
        (None, false) => format!("no sequence of the {parts} was found in time"),
    }
}

fn strut(edge: Option<EdgeId>) -> String {
    edge.map_or_else(|| "a strut".to_owned(), |edge| format!("edge {edge}"))
}

const fn kind(kind: StepKind) -> &'static str {
    match kind {
        StepKind::Ground => "on the ground",
        StepKind::Create => "into the open",
        StepKind::Connect => "between built vertices",
    }
}

/// A step that cannot be made. Which one it is stands beside the sentence.
pub(super) fn violation(violation: &Violation) -> String {
    match violation {
        Violation::UnknownEdge { edge, .. } => format!("edge {edge} is built, which the design has not"),
        Violation::Twice { edge, first, .. } => format!("edge {edge} is built, which step {first} has built"),
        Violation::Missing { edges } => {
            let first = edges.first().map(|edge| format!(", edge {edge} for one")).unwrap_or_default();
            format!("{} never built{first}", count(edges.len(), "edge is", "edges are"))
        }
        Violation::Empty { .. } => "nothing is built".to_owned(),
        Violation::NotAnEnd { vertex, .. } => {
            format!("the head starts at vertex {vertex}, where its edge does not end")
        }
        Violation::Floating { edge, vertex: Some(vertex), .. } => {
            format!("edge {edge} is built from vertex {vertex}, where nothing stands yet")
        }
        Violation::Floating { edge, vertex: None, .. } => {
            format!("edge {edge} is built and hangs on nothing")
        }
        Violation::JointMissing { vertex, .. } => {
            format!("it is not said how the head stands at vertex {vertex}")
        }
        Violation::WrongKind { said, is, .. } => {
            format!("the strut is said to be {}, and it is {}", kind(*said), kind(*is))
        }
        Violation::GroundLate { edge, .. } => {
            format!("edge {edge} is built on the ground after struts that are not")
        }
        Violation::NoDirection { vertex, .. } => {
            format!("there is no direction for the head at vertex {vertex}")
        }
        Violation::Approach { angle, max, .. } => {
            format!("the head leans {angle:.1} from its way, which has to stay below {max:.1}")
        }
        Violation::HeadMeets { edge, distance, .. } if *distance < Length::ZERO => {
            format!("edge {edge} is {:.2} deep in the head", -*distance)
        }
        Violation::HeadMeets { edge, distance, least, .. } => {
            format!(
                "the head comes within {distance:.2} of the middle of edge {edge}, and {least:.2} are kept"
            )
        }
        Violation::Sags { vertex, sag: Some(sag), max, .. } => {
            format!("vertex {vertex} then sags by {sag:.3}, and a joint may be {max:.3} off")
        }
        Violation::Sags { vertex, sag: None, .. } => {
            format!("what is built then does not stand: vertex {vertex} can move freely")
        }
        Violation::OutOfReach { vertex, .. } => {
            format!("vertex {vertex} is outside the machine's workspace")
        }
    }
}
