//! What a front end draws of the open design.

use schemars::JsonSchema;
use serde::Serialize;
use wirebend_core::units::Length;
use wirebend_core::wireframe::{Edge, EdgeId, Vertex, VertexId};
use wirebend_error::ProblemReport;
use wirebend_files::document::{
    CollisionSettings, DocumentChange, JointFile, Look, PartLook, PausePoint, PlacedStencil, PlacementFile,
    StencilSource,
};
use wirebend_files::read::LengthUnit;

use super::{ChosenWalk, Editor};

#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct VertexView {
    pub id: u32,
    /// Where it is, mm, right-handed.
    pub at_mm: [f64; 3],
    /// Whether the design holds it fixed.
    pub support: bool,
    /// What holds the struts together there; absent where nothing does.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub joint: Option<JointFile>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
pub struct EdgeView {
    pub id: u32,
    /// The vertex where it starts.
    pub a: u32,
    /// The vertex where it ends.
    pub b: u32,
    /// Whether it is part of the ceiling; absent where it is not.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub ceiling: bool,
}

/// Where the machine waits for a person.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
pub struct PauseView {
    pub vertex: u32,
    /// Which time the wires come there, from 1, over all wires in their order.
    pub pass: u32,
    /// What the person has to do.
    pub note: String,
}

impl From<&PausePoint> for PauseView {
    fn from(pause: &PausePoint) -> Self {
        Self { vertex: pause.vertex.0, pass: pause.pass.get(), note: pause.note.clone() }
    }
}

/// A surface to trace on.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct StencilView {
    pub id: u32,
    /// Its name, or that of its file.
    pub name: String,
    pub look: Look,
    pub placement: PlacementFile,
    /// Its surface; null where that is in a file that was not found.
    pub surface: Option<SurfaceView>,
}

/// A surface, in its own frame.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct SurfaceView {
    pub faces: usize,
    /// The middle of the box around it, mm.
    pub middle_mm: [f64; 3],
    /// How far the box reaches along x, y and z, mm.
    pub size_mm: [f64; 3],
    /// The rows of the matrix that takes a point of it, mm, to where it lies in the design.
    pub matrix: [[f64; 4]; 3],
}

/// How the part looks that an edge belongs to: all struts that hang together with it.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
pub struct PartView {
    /// One edge of it.
    pub edge: u32,
    pub look: Look,
}

impl StencilView {
    fn of((stencil, source): (&PlacedStencil, &StencilSource)) -> Self {
        Self {
            id: stencil.id.0,
            name: stencil.name(source).to_owned(),
            look: stencil.look.clone(),
            placement: (&stencil.placement).into(),
            surface: source.embedded().map(|surface| SurfaceView {
                faces: surface.faces().len(),
                middle_mm: surface.middle().into(),
                size_mm: surface.size().map(Length::mm),
                matrix: stencil.placement.matrix(surface.middle()),
            }),
        }
    }
}

/// All but vertices, edges and surfaces.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct DesignState {
    /// What it is called.
    pub name: String,
    /// Its file; null where it was never saved.
    pub file: Option<std::path::PathBuf>,
    /// Whether there is something that the file has not.
    pub changed: bool,
    /// Why changes are not kept safe: a person should save. Null where they are.
    pub unkept: Option<ProblemReport>,
    /// What would be undone.
    pub undo: Option<String>,
    /// What would be done again.
    pub redo: Option<String>,
    /// The machine's id.
    pub machine: Option<String>,
    /// The material's id.
    pub material: Option<String>,
    /// The surfaces to trace on. What has another id is another surface.
    pub stencils: Vec<StencilView>,
    /// The parts that were named, coloured or hidden.
    pub parts: Vec<PartView>,
    /// Lines that are no wire, each by its two ends, mm.
    pub construction_mm: Vec<[[f64; 3]; 2]>,
    /// Edges that may be laid twice.
    pub doublings: Vec<u32>,
    /// The vertex where the wire starts.
    pub start: Option<u32>,
    /// How many wires there may be.
    pub wires: usize,
    /// Whether the wire ends where it starts.
    pub closed: bool,
    /// Whether the wire runs the other way.
    pub reversed: bool,
    /// The walks that were chosen, one for each wire; empty where they are found anew.
    pub walks: Vec<ChosenWalk>,
    /// How collisions are looked for.
    pub collisions: CollisionSettings,
    /// Where the machine waits for a person, by vertex.
    pub pauses: Vec<PauseView>,
    /// Remarks on the whole.
    pub notes: String,
    /// The unit that lengths are shown in.
    pub units: LengthUnit,
    /// The ids that the next vertex and the next edge will get.
    pub next: [u32; 2],
}

/// The whole design.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct DesignView {
    /// By id.
    pub vertices: Vec<VertexView>,
    /// By id.
    pub edges: Vec<EdgeView>,
    /// The rest.
    pub state: DesignState,
}

/// What a change makes of the design.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct ViewChange {
    /// Vertices that were added or changed.
    pub vertices: Vec<VertexView>,
    pub gone_vertices: Vec<u32>,
    /// Edges that were added or changed.
    pub edges: Vec<EdgeView>,
    pub gone_edges: Vec<u32>,
    /// The rest, as it is now.
    pub state: DesignState,
}

impl Editor {
    /// The whole design.
    #[must_use]
    pub fn view(&self) -> DesignView {
        let wireframe = &self.document.wireframe;
        DesignView {
            vertices: wireframe.vertices().map(vertex).collect(),
            edges: wireframe.edges().map(edge).collect(),
            state: self.state(),
        }
    }

    /// All but vertices, edges and surfaces.
    #[must_use]
    pub fn state(&self) -> DesignState {
        let document = &self.document;
        let next = document.wireframe.next_ids();
        DesignState {
            name: self.name.clone(),
            file: self.file.clone(),
            changed: self.is_changed(),
            unkept: self.unkept.clone(),
            undo: self.history.undo_label().map(str::to_owned),
            redo: self.history.redo_label().map(str::to_owned),
            machine: document.machine.as_ref().map(|machine| machine.id.clone()),
            material: document.material.as_ref().map(|material| material.id.clone()),
            stencils: document.placed_stencils().map(StencilView::of).collect(),
            parts: document.parts.iter().map(PartView::from).collect(),
            construction_mm: document
                .construction
                .iter()
                .map(|line| line.ends.map(|end| end.coords.into()))
                .collect(),
            doublings: document.doublings.iter().map(|id| id.0).collect(),
            start: document.start.map(|id| id.0),
            wires: document.wires.get(),
            closed: document.closed,
            reversed: document.reversed,
            walks: document.walks.iter().map(ChosenWalk::from).collect(),
            collisions: document.collisions,
            pauses: document.pauses.iter().map(PauseView::from).collect(),
            notes: document.notes.clone(),
            units: document.units,
            next: [next.vertex, next.edge],
        }
    }

    /// What is to be drawn anew after a change that was made.
    pub(super) fn changed(&self, change: &DocumentChange) -> ViewChange {
        let (mut gone_vertices, mut vertices) = (Vec::new(), Vec::new());
        for (&id, change) in &change.wireframe.vertices {
            match change.after {
                Some(after) => vertices.push(vertex((id, after))),
                None => gone_vertices.push(id.0),
            }
        }
        let (mut gone_edges, mut edges) = (Vec::new(), Vec::new());
        for (&id, change) in &change.wireframe.edges {
            match change.after {
                Some(after) => edges.push(edge((id, after))),
                None => gone_edges.push(id.0),
            }
        }
        ViewChange { vertices, gone_vertices, edges, gone_edges, state: self.state() }
    }
}

impl From<&PartLook> for PartView {
    fn from(part: &PartLook) -> Self {
        Self { edge: part.edge.0, look: part.look.clone() }
    }
}

fn vertex((id, vertex): (VertexId, Vertex)) -> VertexView {
    VertexView {
        id: id.0,
        at_mm: vertex.position.coords.into(),
        support: vertex.support,
        joint: vertex.joint.map(JointFile::from),
    }
}

const fn edge((id, edge): (EdgeId, Edge)) -> EdgeView {
    EdgeView { id: id.0, a: edge.a.0, b: edge.b.0, ceiling: edge.ceiling }
}
