//! The order in which struts are built. Steps count from 1, as a person builds them.

use wirebend_core::checks::Location;
use wirebend_core::checks::sequence::{StepKind, Violation};
use wirebend_core::units::Length;
use wirebend_core::wireframe::EdgeId;

use super::number::{count, digits_apart};

pub(super) fn too_soft(at: &Location, sag: Length, max: Length, without: Option<EdgeId>) -> String {
    let vertex = at.vertices.first().map(|vertex| format!(" at vertex {vertex}")).unwrap_or_default();
    let digits = digits_apart(sag.mm(), max.mm(), 3);
    let limits = format!("{sag:.digits$}{vertex}, and a joint may be {max:.digits$} off");
    match without {
        None => format!("the finished frame sags by {limits}"),
        Some(edge) => format!("without edge {edge} what stands sags by {limits}"),
    }
}

pub(super) fn floating(edge: Option<EdgeId>) -> String {
    format!("without {} something would hang on nothing", strut(edge))
}

pub(super) fn no_direction(at: &Location, edge: Option<EdgeId>, blocking: usize) -> String {
    let first = at.edges.iter().copied().find(|other| Some(*other) != edge);
    let blocking = match blocking {
        0 => String::new(),
        1 => format!(": {} is in its way", strut(first)),
        more => {
            format!(": {} and {} are in its way", strut(first), count(more - 1, "more strut", "more struts"))
        }
    };
    format!("the head cannot stand in any direction while it places {}{blocking}", strut(edge))
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
            let digits = digits_apart(sag.mm(), max.mm(), 3);
            format!("vertex {vertex} then sags by {sag:.digits$}, and a joint may be {max:.digits$} off")
        }
        Violation::Sags { vertex, sag: None, .. } => {
            format!("what is built then does not stand: vertex {vertex} can move freely")
        }
        Violation::OutOfReach { vertex, .. } => {
            format!("vertex {vertex} is outside the machine's workspace")
        }
    }
}

#[cfg(test)]
mod tests {
    use wirebend_core::wireframe::VertexId;

    use super::*;

    fn mm(mm: f64) -> Length {
        Length::from_mm(mm).unwrap()
    }

    #[test]
    fn a_sag_beyond_what_is_allowed_never_reads_the_same() {
        let at = Location::at_vertices([VertexId(4)]);
        assert_eq!(
            too_soft(&at, mm(0.427_21), mm(0.427_19), None),
            "the finished frame sags by 0.42721 mm at vertex 4, and a joint may be 0.42719 mm off"
        );
        assert_eq!(
            too_soft(&at, mm(1.5), mm(0.65), Some(EdgeId(3))),
            "without edge 3 what stands sags by 1.500 mm at vertex 4, and a joint may be 0.650 mm off"
        );
        let sags = Violation::Sags { step: 2, vertex: VertexId(4), sag: Some(mm(0.650_04)), max: mm(0.65) };
        assert_eq!(violation(&sags), "vertex 4 then sags by 0.65004 mm, and a joint may be 0.65000 mm off");
    }

    #[test]
    fn the_first_strut_in_the_way_of_the_head_is_named() {
        let at = |edges: &[u32]| Location::at_edges(edges.iter().copied().map(EdgeId));
        let none = "the head cannot stand in any direction while it places edge 7";
        let said = |edges: &[u32], blocking| no_direction(&at(edges), Some(EdgeId(7)), blocking);
        assert_eq!(said(&[7], 0), none);
        assert_eq!(said(&[7, 2], 1), format!("{none}: edge 2 is in its way"));
        assert_eq!(said(&[7, 2, 5], 2), format!("{none}: edge 2 and 1 more strut are in its way"));
        assert_eq!(said(&[7, 2, 5, 6], 3), format!("{none}: edge 2 and 2 more struts are in its way"));
    }
}
