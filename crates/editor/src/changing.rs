//! From a request to the exact difference that it makes to a document.

use std::num::NonZeroU32;

use wirebend_core::mesh::Placement;
use wirebend_core::units::{Angle, Length};
use wirebend_core::wireframe::{ChordLimits, Delta, EdgeId, VertexId};
use wirebend_files::document::{
    CollisionSettings, Document, DocumentChange, PausePoint, PlacedStencil, ProfileSnapshot, StencilId, Walk,
    WireCount, pause_note,
};

use super::{ChosenWalk, EditRequest, construction};
use crate::EditorError;
use wirebend_planning::design::default_weld_mm;
use wirebend_planning::machine::Setup;
use wirebend_planning::{Installation, collision_margin};

/// The difference that a request makes; none where it is so already.
pub(super) fn change(
    document: &Document,
    app: &Installation,
    request: &EditRequest,
) -> Result<Option<DocumentChange>, EditorError> {
    let lines = construction::beside(document, request, weld())?;
    if let Some(edits) = request.of_wireframe(weld(), || chord_limits(document, app))? {
        let mut scratch = document.wireframe.clone();
        let mut delta = Delta::none(&document.wireframe);
        for edit in &edits {
            delta = delta.then(&scratch.apply(edit).map_err(EditorError::from)?);
        }
        let change = DocumentChange::of_edit(document, delta);
        return Ok(both(Some(change), lines));
    }
    // Walks that were chosen are for the wires as they were.
    let anew = |change: Option<DocumentChange>| {
        change.and_then(|change| both(Some(change), document.set_walks(Vec::new())))
    };
    Ok(match request {
        EditRequest::Doublings { edges } => {
            let missing = edges.iter().find(|&&edge| document.wireframe.edge(EdgeId(edge)).is_none());
            if let Some(&edge) = missing {
                return Err(EditorError::NoEdge(edge));
            }
            anew(document.set_doublings(edges.iter().copied().map(EdgeId).collect()))
        }
        EditRequest::Start { vertex } => {
            let start = vertex.map(VertexId);
            if let Some(missing) = start.filter(|&id| document.wireframe.vertex(id).is_none()) {
                return Err(EditorError::NoVertex(missing.0));
            }
            anew(document.set_start(start))
        }
        EditRequest::Wires { wires } => {
            let wires = WireCount::new(*wires).ok_or(EditorError::NoWires)?;
            let closed = document.set_closed(false).filter(|_| wires != WireCount::default());
            anew(both(document.set_wires(wires), closed))
        }
        EditRequest::Closed { closed } => {
            let wires = document.set_wires(WireCount::default()).filter(|_| *closed);
            anew(both(document.set_closed(*closed), wires))
        }
        EditRequest::Reversed { reversed } => anew(document.set_reversed(*reversed)),
        EditRequest::Walks { walks } => document.set_walks(walks_of(document, walks)?),
        EditRequest::Collisions { clearance_mm, sag } => {
            let clearance_mm = collision_margin(*clearance_mm)?;
            document.set_collisions(CollisionSettings { clearance_mm, sag: *sag })
        }
        EditRequest::Pause { vertex, pass, note } => {
            document.set_pauses(pauses_with(document, *vertex, *pass, note.as_deref())?)
        }
        EditRequest::Machine { machine, material } => {
            let (machine, material) = snapshots(&app.setup(machine, material.as_deref())?)?;
            both(document.set_machine(machine), document.set_material(material))
        }
        EditRequest::Notes { text } => document.set_notes(text.clone()),
        EditRequest::Units { units } => document.set_units(*units),
        EditRequest::Construction { change } => construction::changed(document, change, weld())?,
        EditRequest::RemoveStencil { stencil } => {
            let gone = document.without_stencil(StencilId(*stencil));
            Some(gone.ok_or(EditorError::NoStencil(*stencil))?)
        }
        EditRequest::PlaceStencil { stencil, placement } => {
            let placement = Placement::try_from(*placement)?;
            document.set_stencils(stencils_with(document, *stencil, |stencil| stencil.placement = placement)?)
        }
        EditRequest::TurnStencil { stencil, axis, angle_deg } => {
            let by = Angle::from_deg(*angle_deg).map_err(|_| EditorError::Turn(*angle_deg))?;
            let turned = |stencil: &mut PlacedStencil| {
                stencil.placement = stencil.placement.turned(axis.direction(), by);
            };
            document.set_stencils(stencils_with(document, *stencil, turned)?)
        }
        EditRequest::StencilLook { stencil, look } => {
            let look = look.clone().with_tidy_name();
            document.set_stencils(stencils_with(document, *stencil, |stencil| stencil.look = look)?)
        }
        EditRequest::PartLook { edge, look } => {
            if document.wireframe.edge(EdgeId(*edge)).is_none() {
                return Err(EditorError::NoPart(*edge));
            }
            document.set_part_look(EdgeId(*edge), look.clone().with_tidy_name())
        }
        EditRequest::Several { edits, .. } => Some(several(document, app, edits)?),
        _ => None,
    })
}

/// How close vertices are that an edit makes one of.
fn weld() -> Length {
    Length::from_mm(default_weld_mm()).unwrap_or_default()
}

/// What the machine of a design can make of chords and of the edges of shapes; everything without a machine.
pub(super) fn chord_limits(document: &Document, app: &Installation) -> Result<ChordLimits, EditorError> {
    let Some(machine) = &document.machine else { return Ok(ChordLimits::default()) };
    let material = document.material.as_ref().map(|material| material.id.as_str());
    Ok(wirebend_planning::curves::chord_limits(&app.setup(&machine.id, material)?.model))
}

/// Walks whose vertices and edges are all there.
fn walks_of(document: &Document, walks: &[ChosenWalk]) -> Result<Vec<Walk>, EditorError> {
    let wireframe = &document.wireframe;
    let walk = |ChosenWalk { start, edges }: &ChosenWalk| {
        if wireframe.vertex(VertexId(*start)).is_none() {
            return Err(EditorError::NoVertex(*start));
        }
        if let Some(&missing) = edges.iter().find(|&&edge| wireframe.edge(EdgeId(edge)).is_none()) {
            return Err(EditorError::NoEdge(missing));
        }
        Ok(Walk { start: VertexId(*start), edges: edges.iter().copied().map(EdgeId).collect() })
    };
    walks.iter().map(walk).collect()
}

/// The pause points with another note at a place, or without one there.
fn pauses_with(
    document: &Document,
    vertex: u32,
    pass: u32,
    note: Option<&str>,
) -> Result<Vec<PausePoint>, EditorError> {
    let (vertex, pass) = (VertexId(vertex), NonZeroU32::new(pass).ok_or(EditorError::PausePass)?);
    if document.wireframe.vertex(vertex).is_none() {
        return Err(EditorError::NoPauseVertex(vertex.0));
    }
    let note = note.map(|text| pause_note(text).ok_or(EditorError::PauseNote)).transpose()?;
    let mut pauses = document.pauses.clone();
    pauses.retain(|pause| (pause.vertex, pause.pass) != (vertex, pass));
    pauses.extend(note.map(|note| PausePoint { vertex, pass, note }));
    pauses.sort_by_key(|pause| (pause.vertex, pause.pass));
    Ok(pauses)
}

/// The stencils with one of them changed.
fn stencils_with(
    document: &Document,
    stencil: u32,
    change: impl FnOnce(&mut PlacedStencil),
) -> Result<Vec<PlacedStencil>, EditorError> {
    let mut stencils = document.stencils.clone();
    let found = stencils.iter_mut().find(|known| known.id == StencilId(stencil));
    change(found.ok_or(EditorError::NoStencil(stencil))?);
    Ok(stencils)
}

fn both(one: Option<DocumentChange>, other: Option<DocumentChange>) -> Option<DocumentChange> {
    one.into_iter().chain(other).reduce(DocumentChange::and)
}

/// The difference that changes nothing.
pub(super) fn unchanged(document: &Document) -> DocumentChange {
    DocumentChange::of_wireframe(Delta::none(&document.wireframe))
}

/// Changes one after the other as one.
fn several(
    document: &Document,
    app: &Installation,
    requests: &[EditRequest],
) -> Result<DocumentChange, EditorError> {
    let mut last = document.clone();
    let mut delta = Delta::none(&document.wireframe);
    for request in requests {
        if let Some(change) = change(&last, app, request)? {
            last.commit(&change).map_err(EditorError::from)?;
            delta = delta.then(&change.wireframe);
        }
    }
    let parts = [
        document.set_stencils(last.stencils),
        document.set_surfaces(&last.surfaces),
        document.set_parts(last.parts),
        document.set_construction(last.construction),
        document.set_machine(last.machine),
        document.set_material(last.material),
        document.set_doublings(last.doublings),
        document.set_start(last.start),
        document.set_wires(last.wires),
        document.set_closed(last.closed),
        document.set_reversed(last.reversed),
        document.set_walks(last.walks),
        document.set_collisions(last.collisions),
        document.set_pins(last.pins),
        document.set_pauses(last.pauses),
        document.set_notes(last.notes),
        document.set_units(last.units),
    ];
    Ok(parts.into_iter().flatten().fold(DocumentChange::of_wireframe(delta), DocumentChange::and))
}

/// A machine and its wire as a document keeps them.
pub(super) fn snapshots(
    setup: &Setup,
) -> Result<(Option<ProfileSnapshot>, Option<ProfileSnapshot>), EditorError> {
    let snapshot = |id: &str, snapshot| Some(ProfileSnapshot { id: id.to_owned(), snapshot });
    Ok((
        snapshot(setup.machine_id(), serde_json::to_value(&setup.machine)?),
        snapshot(setup.material_id(), serde_json::to_value(&setup.material)?),
    ))
}
