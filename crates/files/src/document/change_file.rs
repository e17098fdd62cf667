//! A change of a document as one line of JSON.

use std::collections::BTreeMap;

use nalgebra::Point3;
use serde::{Deserialize, Serialize};
use wirebend_core::mesh::PlacementError;
use wirebend_core::wireframe::{Change, Delta, Edge, EdgeId, NextIds, Vertex, VertexId};

use super::change::{DocumentChange, Replaced};
use super::collision::CollisionSettings;
use super::construction::{ConstructionLine, ConstructionLineFile};
use super::ids::{Pin, PinFile, StencilId};
use super::joint::JointFile;
use super::look::Look;
use super::part::{PartFile, PartLook};
use super::pause::{PausePoint, PausePointFile};
use super::project::WireCount;
use super::snapshot::ProfileSnapshot;
use super::stencil::{PlacedStencil, PlacementFile, StencilFile, StencilSource, SurfaceFile};
use super::walk::{Walk, WalkFile};
use crate::length_unit::LengthUnit;

/// Before and after.
type Pair<T> = [Option<T>; 2];
/// x, y and z in mm, and whether it is a support; then its joint, if it has one; then the motions that it leaves free, if there are some.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
#[serde(untagged)]
enum VertexPart {
    Plain(f64, f64, f64, bool),
    Jointed(f64, f64, f64, bool, JointFile),
    PartlyHeld(f64, f64, f64, bool, Option<JointFile>, [bool; 6]),
}
/// Its two vertices; then whether it is part of the ceiling, if it is.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
#[serde(untagged)]
enum EdgePart {
    Plain(u32, u32),
    Marked(u32, u32, bool),
}

/// A stencil without its surface.
type LieFile = (StencilId, Look, PlacementFile);

#[derive(Debug, Default, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
struct ChangeFile {
    #[serde(skip_serializing_if = "Vec::is_empty")]
    vertices: Vec<(u32, Pair<VertexPart>)>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    edges: Vec<(u32, Pair<EdgePart>)>,
    /// Of the next vertex and the next edge, before and after.
    next: [(u32, u32); 2],
    #[serde(skip_serializing_if = "Option::is_none")]
    stencils: Option<[Vec<LieFile>; 2]>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    surfaces: Vec<(StencilId, Pair<SurfaceFile>)>,
    /// The only stencil, as journals have it that know of no others.
    #[serde(skip_serializing)]
    stencil: Option<Pair<SurfaceFile>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    parts: Option<[Vec<PartFile>; 2]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    construction: Option<[Vec<ConstructionLineFile>; 2]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    machine: Option<Pair<ProfileSnapshot>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    material: Option<Pair<ProfileSnapshot>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    doublings: Option<[Vec<u32>; 2]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    start: Option<Pair<u32>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    wires: Option<[WireCount; 2]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    closed: Option<[bool; 2]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    reversed: Option<[bool; 2]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    walks: Option<[Vec<WalkFile>; 2]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    collisions: Option<[CollisionSettings; 2]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pins: Option<[Vec<PinFile>; 2]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pauses: Option<[Vec<PausePointFile>; 2]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    notes: Option<[String; 2]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    units: Option<[LengthUnit; 2]>,
}

impl DocumentChange {
    /// The change as JSON without an end of line. [`DocumentChange::of_json`] gives the same change, bit for bit.
    ///
    /// # Errors
    /// When a stencil cannot be packed.
    pub fn to_json(&self) -> Result<String, String> {
        let pack = |surface: &Option<StencilSource>| {
            surface.as_ref().map(SurfaceFile::pack).transpose().map_err(|error| error.to_string())
        };
        let surfaces = self
            .surfaces
            .iter()
            .map(|(id, swap)| Ok::<_, String>((*id, [pack(&swap.before)?, pack(&swap.after)?])));
        let file = ChangeFile {
            vertices: parts(&self.wireframe.vertices, |id| id.0, vertex_part),
            edges: parts(&self.wireframe.edges, |id| id.0, edge_part),
            next: [self.wireframe.next.0, self.wireframe.next.1].map(|next| (next.vertex, next.edge)),
            stencils: pair(self.stencils.as_deref(), |stencils| stencils.iter().map(lie).collect()),
            surfaces: surfaces.collect::<Result<_, _>>()?,
            stencil: None,
            parts: pair(self.parts.as_deref(), |parts| parts.iter().map(PartFile::from).collect()),
            construction: pair(self.construction.as_deref(), |lines| {
                lines.iter().map(ConstructionLineFile::from).collect()
            }),
            machine: pair(self.machine.as_deref(), Clone::clone),
            material: pair(self.material.as_deref(), Clone::clone),
            doublings: pair(self.doublings.as_deref(), |edges| edges.iter().map(|id| id.0).collect()),
            start: pair(self.start.as_deref(), |start| start.map(|id| id.0)),
            wires: pair(self.wires.as_deref(), |wires| *wires),
            closed: pair(self.closed.as_deref(), |closed| *closed),
            reversed: pair(self.reversed.as_deref(), |reversed| *reversed),
            walks: pair(self.walks.as_deref(), |walks| walks.iter().map(WalkFile::from).collect()),
            collisions: pair(self.collisions.as_deref(), |collisions| *collisions),
            pins: pair(self.pins.as_deref(), |pins| pins.iter().map(PinFile::from).collect()),
            pauses: pair(self.pauses.as_deref(), |pauses| pauses.iter().map(PausePointFile::from).collect()),
            notes: pair(self.notes.as_deref(), Clone::clone),
            units: pair(self.units.as_deref(), |units| *units),
        };
        serde_json::to_string(&file).map_err(|error| error.to_string())
    }

    /// Reads a change.
    ///
    /// # Errors
    /// What is wrong with it.
    pub fn of_json(text: &str) -> Result<Self, String> {
        let file: ChangeFile = serde_json::from_str(text).map_err(|error| error.to_string())?;
        let next = file.next.map(|(vertex, edge)| NextIds { vertex, edge });
        let wireframe = Delta {
            vertices: changes(file.vertices, VertexId, vertex_of),
            edges: changes(file.edges, EdgeId, edge_of),
            next: (next[0], next[1]),
        };
        let unpack = |surface: Option<SurfaceFile>| {
            surface.map(|file| file.unpack("this change")).transpose().map_err(|error| error.to_string())
        };
        let (mut stencils, mut surfaces) = (file.stencils, file.surfaces);
        if let Some(only) = file.stencil {
            let lies = only.each_ref().map(|surface| surface.as_ref().map(StencilFile::lie_of_only));
            stencils = Some(lies.map(|lie| lie.into_iter().collect()));
            surfaces.push((StencilFile::ONLY, only));
        }
        let surfaces = surfaces.into_iter().map(|(id, [before, after])| {
            Ok::<_, String>((id, Change { before: unpack(before)?, after: unpack(after)? }))
        });
        let stencils = stencils.map(|[before, after]| {
            let all = |list: Vec<LieFile>| list.into_iter().map(stencil_of).collect::<Result<Vec<_>, _>>();
            Ok::<_, String>(Box::new(Replaced { before: all(before)?, after: all(after)? }))
        });
        Ok(Self {
            wireframe,
            stencils: stencils.transpose()?,
            surfaces: surfaces.collect::<Result<_, _>>()?,
            parts: swap(file.parts, |parts: Vec<PartFile>| parts.into_iter().map(PartLook::from).collect()),
            construction: swap(file.construction, |lines: Vec<ConstructionLineFile>| {
                lines.into_iter().map(ConstructionLine::from).collect()
            }),
            machine: swap(file.machine, |machine| machine),
            material: swap(file.material, |material| material),
            doublings: swap(file.doublings, |edges: Vec<u32>| edges.into_iter().map(EdgeId).collect()),
            start: swap(file.start, |start| start.map(VertexId)),
            wires: swap(file.wires, |wires| wires),
            closed: swap(file.closed, |closed| closed),
            reversed: swap(file.reversed, |reversed| reversed),
            walks: swap(file.walks, |walks: Vec<WalkFile>| walks.into_iter().map(Walk::from).collect()),
            collisions: swap(file.collisions, |collisions| collisions),
            pins: swap(file.pins, |pins: Vec<PinFile>| pins.into_iter().map(Pin::from).collect()),
            pauses: swap(file.pauses, |pauses: Vec<PausePointFile>| {
                pauses.into_iter().map(PausePoint::from).collect()
            }),
            notes: swap(file.notes, |notes| notes),
            units: swap(file.units, |units| units),
        })
    }
}

fn vertex_part(vertex: &Vertex) -> VertexPart {
    let Vertex { position: at, support, free, joint } = *vertex;
    let joint = joint.map(JointFile::from);
    match joint {
        _ if free != [false; 6] => VertexPart::PartlyHeld(at.x, at.y, at.z, support, joint, free),
        None => VertexPart::Plain(at.x, at.y, at.z, support),
        Some(joint) => VertexPart::Jointed(at.x, at.y, at.z, support, joint),
    }
}

fn vertex_of(part: VertexPart) -> Vertex {
    let (x, y, z, support, joint, free) = match part {
        VertexPart::Plain(x, y, z, support) => (x, y, z, support, None, [false; 6]),
        VertexPart::Jointed(x, y, z, support, joint) => (x, y, z, support, Some(joint), [false; 6]),
        VertexPart::PartlyHeld(x, y, z, support, joint, free) => (x, y, z, support, joint, free),
    };
    Vertex { position: Point3::new(x, y, z), support, free, joint: joint.map(Into::into) }
}

fn edge_part(edge: &Edge) -> EdgePart {
    let (a, b) = (edge.a.0, edge.b.0);
    if edge.ceiling { EdgePart::Marked(a, b, true) } else { EdgePart::Plain(a, b) }
}

fn edge_of(part: EdgePart) -> Edge {
    let (a, b, ceiling) = match part {
        EdgePart::Plain(a, b) => (a, b, false),
        EdgePart::Marked(a, b, ceiling) => (a, b, ceiling),
    };
    Edge { a: VertexId(a), b: VertexId(b), ceiling }
}

fn lie(stencil: &PlacedStencil) -> LieFile {
    (stencil.id, stencil.look.clone(), (&stencil.placement).into())
}

fn stencil_of((id, look, placement): LieFile) -> Result<PlacedStencil, String> {
    let placement = placement.try_into().map_err(|error: PlacementError| error.to_string())?;
    Ok(PlacedStencil { id, look, placement })
}

fn parts<K: Copy, T, U>(
    changes: &BTreeMap<K, Change<T>>,
    id: impl Fn(K) -> u32,
    part: impl Fn(&T) -> U,
) -> Vec<(u32, Pair<U>)> {
    let both = |change: &Change<T>| [change.before.as_ref().map(&part), change.after.as_ref().map(&part)];
    changes.iter().map(|(&key, change)| (id(key), both(change))).collect()
}

fn changes<K: Ord, T, U>(
    parts: Vec<(u32, Pair<U>)>,
    id: impl Fn(u32) -> K,
    of: impl Fn(U) -> T,
) -> BTreeMap<K, Change<T>> {
    let change = |[before, after]: Pair<U>| Change { before: before.map(&of), after: after.map(&of) };
    parts.into_iter().map(|(key, pair)| (id(key), change(pair))).collect()
}

fn pair<T, U>(swap: Option<&Replaced<T>>, part: impl Fn(&T) -> U) -> Option<[U; 2]> {
    swap.map(|swap| [part(&swap.before), part(&swap.after)])
}

fn swap<T, U>(pair: Option<[U; 2]>, of: impl Fn(U) -> T) -> Option<Box<Replaced<T>>> {
    pair.map(|[before, after]| Box::new(Replaced { before: of(before), after: of(after) }))
}
