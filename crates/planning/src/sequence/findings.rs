//! What keeps a frame from being built, as findings.

use std::collections::BTreeSet;
use wirebend_core::checks::sequence::Violation;

use wirebend_core::checks::{Diagnostic, Fact, Location, Remedy, Severity};
use wirebend_core::units::Length;
use wirebend_core::wireframe::{Component, EdgeId, VertexId};
use wirebend_sequence::{Obstacle, ObstacleRule, Structure, StructureError, Task};

use crate::design::Opened;

fn error(location: Location, fact: Fact, remedies: Vec<Remedy>) -> Diagnostic {
    Diagnostic { severity: Severity::Error, location, fact, remedies }
}

/// A design that is no frame: what is wrong, of each part that nothing holds.
pub(super) fn no_structure(opened: &Opened, why: &StructureError) -> Vec<Diagnostic> {
    let wireframe = &opened.document.wireframe;
    match why {
        StructureError::NoEdges => {
            vec![error(Location::default(), Fact::NoEdges, vec![Remedy::DrawEdges])]
        }
        StructureError::NoSupport => {
            let fact = Fact::FrameUnsupported { edges: wireframe.edge_count(), whole: true };
            vec![error(Location::default(), fact, vec![Remedy::SupportVertices])]
        }
        StructureError::Floating { edges } => {
            let floats = |part: &Component| part.edges.iter().any(|edge| edges.contains(edge));
            wireframe.components().into_iter().filter(floats).map(floating_part).collect()
        }
        StructureError::ZeroLength { edge } => {
            let ends = wireframe.edge(*edge).map_or([VertexId(0); 2], |there| [there.a, there.b]);
            let fact = Fact::ZeroLengthEdge { edge: *edge, ends, length: wireframe.edge_length(*edge) };
            vec![error(Location::at_edges(vec![*edge]), fact, vec![Remedy::DeleteEdge])]
        }
    }
}

fn floating_part(part: Component) -> Diagnostic {
    let fact = Fact::FrameUnsupported { edges: part.edges.len(), whole: false };
    let vertices = part.vertices.first().copied().into_iter().collect();
    error(Location { vertices, edges: part.edges, step: None }, fact, vec![Remedy::SupportVertices])
}

/// A step of a sequence that cannot be made.
pub(super) fn violation(violation: &Violation) -> Diagnostic {
    let step = violation.step();
    let location = Location {
        vertices: violation.vertex().into_iter().collect(),
        edges: violation.edges(),
        // Steps count from 0 in findings.
        step: step.and_then(|step| step.checked_sub(1)),
    };
    let remedies = match violation {
        Violation::Sags { .. } => vec![Remedy::BuildLater, Remedy::BraceFrame],
        Violation::HeadMeets { .. } => vec![Remedy::TurnHead, Remedy::BuildLater],
        Violation::Approach { .. } | Violation::NoDirection { .. } => vec![Remedy::TurnHead],
        Violation::OutOfReach { .. } => vec![Remedy::MoveFrame],
        Violation::Floating { .. } | Violation::GroundLate { .. } => vec![Remedy::BuildLater],
        Violation::UnknownEdge { .. }
        | Violation::Twice { .. }
        | Violation::Missing { .. }
        | Violation::Empty { .. }
        | Violation::NotAnEnd { .. }
        | Violation::JointMissing { .. }
        | Violation::WrongKind { .. } => Vec::new(),
    };
    error(location, Fact::SequenceStep(violation.clone()), remedies)
}

/// Why a search came to nothing: that there is no sequence, and what was in the way.
pub(super) fn not_found(task: &Task<'_>, obstacle: Option<&Obstacle>, proved: bool) -> Vec<Diagnostic> {
    let of = task.groups.all().len();
    let structure = task.structure;
    let whole = matches!(
        obstacle.map(|obstacle| obstacle.rule),
        Some(ObstacleRule::WholeFrame { .. } | ObstacleRule::OutOfReach { .. })
    );
    let mut found = Vec::new();
    if !whole {
        let fact = Fact::SequenceNotFound { step: obstacle.map(|obstacle| obstacle.step), of, proved };
        let more = if proved { Remedy::BraceFrame } else { Remedy::SearchLonger };
        found.push(error(Location::default(), fact, vec![more, Remedy::AllowMoreSag]));
    }
    found.extend(obstacle.map(|obstacle| in_the_way(task, structure, obstacle)));
    found
}

fn in_the_way(task: &Task<'_>, structure: &Structure, obstacle: &Obstacle) -> Diagnostic {
    let edge = |strut: usize| structure.struts()[strut].edge;
    let vertex = |node: usize| structure.nodes()[node].vertex;
    let around: Vec<EdgeId> = obstacle.struts.iter().map(|&strut| edge(strut)).collect();
    let own = obstacle.strut.map(edge);
    let step = obstacle.step.checked_sub(1);
    let max = task.builder.max_sag;
    match obstacle.rule {
        ObstacleRule::WholeFrame { node, sag_mm } | ObstacleRule::Sags { node, sag_mm } => {
            let whole = matches!(obstacle.rule, ObstacleRule::WholeFrame { .. });
            let location =
                Location { vertices: vec![vertex(node)], edges: around, step: step.filter(|_| !whole) };
            let fact = match sag_mm.map(Length::from_mm) {
                Some(Ok(sag)) => Fact::FrameTooSoft { sag, max, without: own.filter(|_| !whole) },
                _ => Fact::FrameMechanism,
            };
            // What moves freely does so however far it may.
            let allow = (fact != Fact::FrameMechanism).then_some(Remedy::AllowMoreSag);
            let remedies = [Remedy::BraceFrame, Remedy::SupportVertices].into_iter().chain(allow);
            error(location, fact, remedies.collect())
        }
        ObstacleRule::SagsWith { node, sag_mm } => {
            let sag = sag_mm.and_then(|mm| Length::from_mm(mm).ok());
            violation(&Violation::Sags { step: obstacle.step, vertex: vertex(node), sag, max })
        }
        ObstacleRule::NoDirection => {
            // A wire may meet the same strut at several of its joints.
            let blocking: BTreeSet<EdgeId> = around.into_iter().filter(|edge| Some(*edge) != own).collect();
            let fact = Fact::NoHeadDirection { edge: own, blocking: blocking.len() };
            let edges = own.into_iter().chain(blocking).collect();
            error(Location { vertices: Vec::new(), edges, step }, fact, vec![Remedy::MoveApart])
        }
        ObstacleRule::Floating => {
            let fact = Fact::StrutFloating { edge: own };
            let edges = own.into_iter().chain(around).collect();
            error(Location { vertices: Vec::new(), edges, step }, fact, vec![Remedy::SupportVertices])
        }
        ObstacleRule::OutOfReach { node } => {
            let location = Location { vertices: vec![vertex(node)], edges: around, step: None };
            error(location, Fact::OutOfWorkspace, vec![Remedy::MoveFrame])
        }
    }
}
