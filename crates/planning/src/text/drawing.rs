//! Flaws of the drawing itself.

use wirebend_core::bend::PathError;
use wirebend_core::checks::{ClosingBend, Location};
use wirebend_core::units::Length;
use wirebend_core::wireframe::{EdgeId, VertexId};

use super::number::{count, digits_beside};

pub(super) fn zero_length(edge: EdgeId, [a, b]: [VertexId; 2]) -> String {
    format!("edge {edge} from vertex {a} to vertex {b} has no length")
}

pub(super) fn no_path(error: &PathError, at: &Location) -> String {
    match (error, at.edges.first()) {
        (PathError::NoDirection(_), Some(edge)) => {
            format!("edge {edge} has no length: the wire has no direction there")
        }
        (PathError::NoDirection(segment), None) => {
            format!("segment {} of the wire has no length: the wire has no direction there", segment + 1)
        }
        (PathError::TooShort(points), _) => {
            format!("the route has {}: a wire takes at least 2", count(*points, "point", "points"))
        }
    }
}

pub(super) fn parallel([first, second]: [EdgeId; 2], [a, b]: [VertexId; 2]) -> String {
    format!("edges {first} and {second} both join vertices {a} and {b}")
}

pub(super) fn coincident([first, second]: [VertexId; 2], distance: Length) -> String {
    format!("vertices {first} and {second} are {distance:.4} apart but not merged")
}

/// What meets where: "edges 3 and 9 meet 35.0 mm from vertex 1".
pub(super) fn meeting(
    edges: [EdgeId; 2],
    near: [Option<VertexId>; 2],
    from: [VertexId; 2],
    along: [Length; 2],
) -> String {
    let [one, other] = edges;
    let on_edge = |side: usize, vertex: VertexId| {
        format!("edge {} meets vertex {vertex}, {:.1} from vertex {}", edges[side], along[side], from[side])
    };
    match near {
        [Some(vertex), Some(second)] => format!("vertices {vertex} and {second} meet but are not merged"),
        [Some(vertex), None] => on_edge(1, vertex),
        [None, Some(vertex)] => on_edge(0, vertex),
        [None, None] => {
            format!("edges {one} and {other} meet {:.1} from vertex {}", along[0], from[0])
        }
    }
}

pub(super) fn edges_meet(
    meeting: &str,
    distance: Length,
    diameter: Length,
    through: bool,
    closing: Option<ClosingBend>,
) -> String {
    let digits = digits_beside(distance.mm(), diameter.mm());
    let what = match closing {
        _ if through => "they run through each other".to_owned(),
        None => "they press on each other there, or snap past each other while they are bent".to_owned(),
        Some(bend) => {
            let step = bend.step.map_or_else(String::new, |step| format!(" of step {}", step + 1));
            let bend_at = format!("the bend{step} at vertex {}", bend.vertex);
            if bend.snaps_past {
                format!("in {bend_at} one snaps past the other, and they press on each other from then on")
            } else {
                format!("they press on each other from {bend_at} on")
            }
        }
    };
    format!(
        "{meeting}: {distance:.digits$} from centre to centre, and the wire is {diameter:.digits$} thick; {what}"
    )
}

pub(super) fn isolated(vertex: VertexId) -> String {
    format!("vertex {vertex} has no edge: no wire passes through it")
}

pub(super) fn several_wires(wires: usize) -> String {
    format!("the wireframe is not connected: it takes {}", count(wires, "wire", "wires"))
}

pub(super) fn no_edges() -> String {
    "the wireframe has no edges: there is nothing to bend".to_owned()
}
