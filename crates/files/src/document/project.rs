//! `.wirebend`: the design that a person works on.

use std::collections::BTreeMap;
use std::num::NonZeroU32;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_core::mesh::Stencil;
use wirebend_core::wireframe::{EdgeId, Vertex, VertexId, Wireframe};

use super::collision::CollisionSettings;
use super::construction::{ConstructionLine, ConstructionLineFile};
use super::error::DocumentError;
use super::hash::canonical_sha256;
use super::ids::{Pin, PinFile, PinTarget, StencilId};
use super::layout;
use super::part::{PartFile, PartLook};
use super::pause::{PausePoint, PausePointFile};
use super::snapshot::ProfileSnapshot;
use super::stencil::{PlacedStencil, StencilFile, StencilSource, SurfaceFile, unpacked};
use super::version::History;
use super::walk::{Walk, WalkFile};
use super::wireframe::{EdgeFile, VertexFile, WireframeFile};
use crate::length_unit::LengthUnit;

const HISTORY: History = History { format: "wirebend", title: "a WireBend project", migrations: &[] };

/// A project: the wireframe and all that belongs to it. Positions are millimetres.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Document {
    /// The struts, with ids that stay.
    pub wireframe: Wireframe,
    /// The surfaces that are traced, in the order of their list.
    pub stencils: Vec<PlacedStencil>,
    /// Of each stencil where its surface is.
    pub surfaces: BTreeMap<StencilId, StencilSource>,
    /// How parts look that were named, coloured or hidden.
    pub parts: Vec<PartLook>,
    /// Lines to measure and to snap to that are never bent, in the order in which they were drawn.
    pub construction: Vec<ConstructionLine>,
    /// The machine that it is bent on.
    pub machine: Option<ProfileSnapshot>,
    /// The wire that it is bent from.
    pub material: Option<ProfileSnapshot>,
    /// Edges that the person allowed to be laid twice.
    pub doublings: Vec<EdgeId>,
    /// Where the wire has to start.
    pub start: Option<VertexId>,
    /// How many wires there may be.
    pub wires: WireCount,
    /// Whether the wire has to end where it starts.
    pub closed: bool,
    /// Whether the wire runs the other way: it ends where it would start.
    pub reversed: bool,
    /// The walks of the wires, where they were chosen; empty: they are found anew.
    pub walks: Vec<Walk>,
    /// How collisions are looked for.
    pub collisions: CollisionSettings,
    /// Remarks pinned to vertices and edges.
    pub pins: Vec<Pin>,
    /// Vertices at which the machine waits for a person.
    pub pauses: Vec<PausePoint>,
    /// Remarks on the whole.
    pub notes: String,
    /// The unit that lengths are shown in; the file itself is in millimetres.
    pub units: LengthUnit,
    /// The file that the wireframe was imported from.
    pub source: Option<SourceFile>,
}

/// The file that a wireframe was imported from.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SourceFile {
    pub file: String,
    /// Its SHA-256 in hexadecimal.
    #[schemars(regex(pattern = "^[0-9a-f]{64}$"))]
    pub sha256: String,
}

/// A WireBend project.
#[derive(Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "WireBend project")]
pub(crate) struct ProjectFile {
    /// Which kind of file this is.
    #[schemars(extend("const" = "wirebend"))]
    format: String,
    /// The version of this format.
    #[schemars(extend("const" = 1))]
    version: u64,
    wireframe: WireframeFile,
    /// The surfaces that are traced.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    stencils: Vec<StencilFile>,
    /// The only surface that is traced, as documents have it that know of no others.
    #[serde(default, skip_serializing)]
    stencil: Option<SurfaceFile>,
    /// How parts look that were named, coloured or hidden.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    parts: Vec<PartFile>,
    /// Lines to measure and to snap to that are never bent.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    construction: Vec<ConstructionLineFile>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    machine: Option<ProfileSnapshot>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    material: Option<ProfileSnapshot>,
    /// Edges that may be laid twice, by id.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    doublings: Vec<u32>,
    /// The vertex that the wire starts at, by id.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    start: Option<u32>,
    /// How many wires there may be. Fewer are used where more would not save doubled edges.
    #[serde(default, skip_serializing_if = "WireCount::is_one")]
    wires: WireCount,
    /// Whether the wire has to end where it starts.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    closed: bool,
    /// Whether the wire runs the other way: it ends where it would start.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    reversed: bool,
    /// The walks of the wires, where they were chosen. They are not used while they do not pass all edges of their part.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    walks: Vec<WalkFile>,
    /// How collisions are looked for.
    #[serde(default, skip_serializing_if = "CollisionSettings::is_default")]
    collisions: CollisionSettings,
    /// Remarks on vertices and edges.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pins: Vec<PinFile>,
    /// Vertices at which the machine waits for a person.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pauses: Vec<PausePointFile>,
    /// Remarks on the whole.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    notes: String,
    /// The unit that lengths are shown in.
    #[serde(default)]
    units: LengthUnit,
    /// The file that the wireframe was imported from.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    source: Option<SourceFile>,
}

/// What makes a design the same design: see [`Document::design_hash`].
#[derive(Serialize)]
struct DesignPart<'a> {
    vertices: &'a [VertexFile],
    edges: &'a [EdgeFile],
    doublings: &'a [u32],
    start: Option<u32>,
    #[serde(skip_serializing_if = "WireCount::is_one")]
    wires: WireCount,
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    closed: bool,
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    reversed: bool,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    walks: Vec<WalkFile>,
}

/// How many wires there may be, at least one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(transparent)]
pub struct WireCount(NonZeroU32);

impl Default for WireCount {
    fn default() -> Self {
        Self(NonZeroU32::MIN)
    }
}

impl WireCount {
    /// So many; none for no wire.
    #[must_use]
    pub fn new(wires: u32) -> Option<Self> {
        NonZeroU32::new(wires).map(Self)
    }

    #[must_use]
    pub const fn get(self) -> usize {
        self.0.get() as usize
    }

    #[allow(clippy::trivially_copy_pass_by_ref)] // as serde asks
    const fn is_one(&self) -> bool {
        self.0.get() == 1
    }
}

impl Document {
    /// A project around a wireframe, with nothing else yet.
    #[must_use]
    pub fn new(wireframe: Wireframe) -> Self {
        Self { wireframe, ..Self::default() }
    }

    /// Opens the bytes of a `.wirebend` file; older versions are migrated.
    ///
    /// # Errors
    /// [`DocumentError`] for anything that is not such a document in one piece.
    pub fn open(bytes: &[u8], file: &str) -> Result<Self, DocumentError> {
        let content: ProjectFile = HISTORY.open(bytes, file)?;
        let (stencils, surfaces) = unpacked(content.stencils, content.stencil, file)?;
        let document = Self {
            wireframe: content.wireframe.build(file)?,
            stencils,
            surfaces,
            parts: content.parts.into_iter().map(PartLook::from).collect(),
            construction: content.construction.into_iter().map(ConstructionLine::from).collect(),
            machine: content.machine,
            material: content.material,
            doublings: content.doublings.into_iter().map(EdgeId).collect(),
            start: content.start.map(VertexId),
            wires: content.wires,
            closed: content.closed,
            reversed: content.reversed,
            walks: content.walks.into_iter().map(Walk::from).collect(),
            collisions: content.collisions,
            pins: content.pins.into_iter().map(Pin::from).collect(),
            pauses: content.pauses.into_iter().map(PausePoint::from).collect(),
            notes: content.notes,
            units: content.units,
            source: content.source,
        };
        document.check_references(file)?;
        if document.closed && document.wires != WireCount::default() {
            return Err(DocumentError::ClosedWires { file: file.to_owned(), wires: document.wires.get() });
        }
        Ok(document)
    }

    /// The bytes of the `.wirebend` file: the same document gives the same bytes, and opening them
    /// gives the same document, bit for bit.
    ///
    /// # Errors
    /// [`DocumentError::Write`].
    pub fn to_bytes(&self) -> Result<Vec<u8>, DocumentError> {
        layout::to_bytes(&self.file()?)
    }

    /// The stencils with their surfaces.
    pub fn placed_stencils(&self) -> impl Iterator<Item = (&PlacedStencil, &StencilSource)> {
        self.stencils.iter().filter_map(|stencil| Some((stencil, self.surfaces.get(&stencil.id)?)))
    }

    /// The surfaces that are in the document itself, where they lie in the design.
    pub fn surfaces_in_place(&self) -> impl Iterator<Item = Stencil> {
        self.placed_stencils()
            .filter_map(|(stencil, surface)| Some(surface.embedded()?.placed(&stencil.placement)))
    }

    /// Puts a surface into the document, as a stencil that lies as in its file.
    pub fn add_stencil(&mut self, name: String, surface: StencilSource) {
        let id = self.next_stencil();
        self.stencils.push(PlacedStencil::new(id, name));
        self.surfaces.insert(id, surface);
    }

    pub(super) fn next_stencil(&self) -> StencilId {
        StencilId((0..=u32::MAX).find(|id| !self.surfaces.contains_key(&StencilId(*id))).unwrap_or(u32::MAX))
    }

    /// The SHA-256 of the canonical form of what the wire is planned from: vertices, edges,
    /// doublings and how the wires run. Remarks, pause points, stencils, construction lines, looks of parts, machine and material do not change it.
    ///
    /// # Errors
    /// [`DocumentError::Write`].
    pub fn design_hash(&self) -> Result<String, DocumentError> {
        let wireframe = WireframeFile::of(&self.wireframe);
        let mut doublings: Vec<u32> = self.doublings.iter().map(|id| id.0).collect();
        doublings.sort_unstable();
        canonical_sha256(&DesignPart {
            vertices: &wireframe.vertices,
            edges: &wireframe.edges,
            doublings: &doublings,
            start: self.start.map(|id| id.0),
            wires: self.wires,
            closed: self.closed,
            reversed: self.reversed,
            walks: self.walks.iter().map(WalkFile::from).collect(),
        })
    }

    fn file(&self) -> Result<ProjectFile, DocumentError> {
        Ok(ProjectFile {
            format: HISTORY.format.to_owned(),
            version: HISTORY.current(),
            wireframe: WireframeFile::of(&self.wireframe),
            stencils: self
                .placed_stencils()
                .map(|(stencil, surface)| StencilFile::pack(stencil, surface))
                .collect::<Result<_, _>>()?,
            stencil: None,
            parts: self.parts.iter().map(PartFile::from).collect(),
            construction: self.construction.iter().map(ConstructionLineFile::from).collect(),
            machine: self.machine.clone(),
            material: self.material.clone(),
            doublings: self.doublings.iter().map(|id| id.0).collect(),
            start: self.start.map(|id| id.0),
            wires: self.wires,
            closed: self.closed,
            reversed: self.reversed,
            walks: self.walks.iter().map(WalkFile::from).collect(),
            collisions: self.collisions,
            pins: self.pins.iter().map(PinFile::from).collect(),
            pauses: self.pauses.iter().map(PausePointFile::from).collect(),
            notes: self.notes.clone(),
            units: self.units,
            source: self.source.clone(),
        })
    }

    /// Whether all that points at a vertex or an edge finds it.
    fn check_references(&self, file: &str) -> Result<(), DocumentError> {
        let dangling = |key, target| Err(DocumentError::Dangling { file: file.to_owned(), key, target });
        if let Some(id) = self.doublings.iter().find(|id| self.wireframe.edge(**id).is_none()) {
            return dangling("doublings", format!("edge {id}"));
        }
        if let Some(id) = self.start.filter(|id| self.wireframe.vertex(*id).is_none()) {
            return dangling("start", format!("vertex {id}"));
        }
        for walk in &self.walks {
            if self.wireframe.vertex(walk.start).is_none() {
                return dangling("walks", format!("vertex {}", walk.start));
            }
            if let Some(id) = walk.edges.iter().find(|id| self.wireframe.edge(**id).is_none()) {
                return dangling("walks", format!("edge {id}"));
            }
        }
        let mut places = Wireframe::new();
        for end in self.construction.iter().flat_map(|line| line.ends) {
            let wrong = |error| DocumentError::Wireframe { file: file.to_owned(), error };
            places.add_vertex(Vertex::at(end)).map_err(wrong)?;
        }
        if let Some(part) = self.parts.iter().find(|part| self.wireframe.edge(part.edge).is_none()) {
            return dangling("parts", format!("edge {}", part.edge));
        }
        if let Some(pause) = self.pauses.iter().find(|pause| self.wireframe.vertex(pause.vertex).is_none()) {
            return dangling("pauses", format!("vertex {}", pause.vertex));
        }
        for pin in &self.pins {
            match pin.on {
                PinTarget::Vertex(id) if self.wireframe.vertex(id).is_none() => {
                    return dangling("pins", format!("vertex {id}"));
                }
                PinTarget::Edge(id) if self.wireframe.edge(id).is_none() => {
                    return dangling("pins", format!("edge {id}"));
                }
                _ => {}
            }
        }
        Ok(())
    }
}
