//! Edits that make a length or an angle what was typed.

use std::collections::BTreeSet;

use nalgebra::{Point3, Rotation3, Unit, Vector3};

use super::super::delta::Draft;
use super::super::graph::{Edge, EdgeId, VertexId};
use super::{EditError, Rest};
use crate::units::{Angle, Length};

/// Edges whose directions differ by less have no plane in common: the sine of the angle between them.
const IN_LINE: f64 = 1e-9;

/// Makes an edge `length` long. The end that does not stay goes along the edge, and the rest beyond it too, where it follows.
pub(super) fn set_length(
    draft: &mut Draft,
    id: EdgeId,
    length: Length,
    stays: VertexId,
    rest: Rest,
) -> Result<(), EditError> {
    let edge = draft.edge(id).ok_or(EditError::NoEdge(id))?;
    if length <= Length::ZERO {
        return Err(EditError::EdgeLength(length.mm()));
    }
    let goes = other_end(id, edge, stays)?;
    let (fixed, from) = (draft.position(stays)?, draft.position(goes)?);
    let way = direction(id, fixed, from)?;
    let to = fixed + way.into_inner() * length.mm();
    if rest == Rest::Follows {
        let beyond = beyond(draft, goes, |_, other| other == id);
        if beyond.contains(&stays) {
            return Err(EditError::InLoop(id));
        }
        for vertex in beyond {
            draft.move_vertex(vertex, draft.position(vertex)? + (to - from))?;
        }
    }
    draft.move_vertex(goes, to)?;
    Ok(())
}

/// Makes the angle at `vertex` between two edges `angle`: `stays` keeps its place, `turns` goes about the vertex in the plane of both.
pub(super) fn set_angle(
    draft: &mut Draft,
    vertex: VertexId,
    between: Option<(EdgeId, EdgeId)>,
    angle: Angle,
    normal: Option<Unit<Vector3<f64>>>,
    rest: Rest,
) -> Result<(), EditError> {
    let at = draft.position(vertex)?;
    if angle <= Angle::ZERO || angle > Angle::HALF_TURN {
        return Err(EditError::CornerAngle(angle.deg()));
    }
    let (stays, turns) = match between {
        Some(edges) => edges,
        None => only_two(draft, vertex)?,
    };
    if stays == turns {
        return Err(EditError::RepeatedEdge(stays));
    }
    let end = |draft: &Draft, id: EdgeId| {
        let edge = draft.edge(id).ok_or(EditError::NoEdge(id))?;
        other_end(id, edge, vertex)
    };
    let (fixed, goes) = (end(draft, stays)?, end(draft, turns)?);
    if fixed == goes {
        return Err(EditError::SameEnds(stays, turns));
    }
    let from = draft.position(goes)?;
    let along = direction(stays, at, draft.position(fixed)?)?;
    let now = direction(turns, at, from)?;
    let axis = across(&along, &now).or_else(|| {
        let normal = normal?;
        Unit::try_new(normal.into_inner() - along.into_inner() * normal.dot(&along), IN_LINE)
    });
    let axis = axis.ok_or(EditError::InLine(vertex))?;
    let aside = axis.cross(&along);
    let way = along.into_inner() * angle.rad().cos() + aside * angle.rad().sin();
    if rest == Rest::Follows {
        let beyond = beyond(draft, goes, |end, _| end == vertex);
        if beyond.contains(&fixed) {
            return Err(EditError::InLoop(turns));
        }
        let turn = Rotation3::from_axis_angle(&axis, angle.rad() - angle_between(&along, &now));
        for vertex in beyond {
            let place = draft.position(vertex)?;
            draft.move_vertex(vertex, at + turn * (place - at))?;
        }
    }
    draft.move_vertex(goes, at + way * (from - at).norm())?;
    Ok(())
}

/// The edges at a vertex that has two, in the order in which they were drawn.
pub(super) fn only_two(draft: &Draft, vertex: VertexId) -> Result<(EdgeId, EdgeId), EditError> {
    let edges = draft.incident(vertex);
    let mut listed = edges.iter().copied();
    match (listed.next(), listed.next(), listed.next()) {
        (Some(one), Some(other), None) => Ok((one, other)),
        _ => Err(EditError::NoCorner { vertex, edges: edges.len() }),
    }
}

/// The end of an edge that `vertex` is not.
pub(super) fn other_end(id: EdgeId, edge: Edge, vertex: VertexId) -> Result<VertexId, EditError> {
    match vertex {
        _ if vertex == edge.a => Ok(edge.b),
        _ if vertex == edge.b => Ok(edge.a),
        _ => Err(EditError::NotAnEnd { edge: id, vertex }),
    }
}

/// The way of an edge from one of its ends to the other.
pub(super) fn direction(
    id: EdgeId,
    from: Point3<f64>,
    to: Point3<f64>,
) -> Result<Unit<Vector3<f64>>, EditError> {
    // Ends that are closer together cannot be told apart.
    Unit::try_new(to - from, 1e-9).ok_or(EditError::NoDirection(id))
}

/// From 0 to half a turn; exact for small angles too.
pub(super) fn angle_between(a: &Vector3<f64>, b: &Vector3<f64>) -> f64 {
    a.cross(b).norm().atan2(a.dot(b))
}

/// The normal of the plane of two directions; none where they are in line.
fn across(a: &Vector3<f64>, b: &Vector3<f64>) -> Option<Unit<Vector3<f64>>> {
    Unit::try_new(a.cross(b), IN_LINE)
}

/// `from`, and what edges lead to from there. `barred` leaves out an edge by the end that it would lead to, and its id.
fn beyond(draft: &Draft, from: VertexId, barred: impl Fn(VertexId, EdgeId) -> bool) -> BTreeSet<VertexId> {
    let mut found = BTreeSet::from([from]);
    let mut open = vec![from];
    while let Some(vertex) = open.pop() {
        for id in draft.incident(vertex) {
            let Some(edge) = draft.edge(id) else { continue };
            let next = if edge.a == vertex { edge.b } else { edge.a };
            if !barred(next, id) && found.insert(next) {
                open.push(next);
            }
        }
    }
    found
}
