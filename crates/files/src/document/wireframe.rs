//! The wireframe of a document, with ids that stay.

use nalgebra::Point3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_core::wireframe::{Edge, EdgeId, Joint, NextIds, Vertex, VertexId, Wireframe};

use super::error::DocumentError;
use super::joint::JointFile;

/// Vertices and edges with ids that are never used again.
#[derive(Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "Wireframe")]
pub(crate) struct WireframeFile {
    /// The id that the next vertex will get.
    next_vertex: u32,
    /// The id that the next edge will get.
    next_edge: u32,
    pub(crate) vertices: Vec<VertexFile>,
    pub(crate) edges: Vec<EdgeFile>,
}

/// A point where struts meet.
#[derive(Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "Vertex")]
pub(crate) struct VertexFile {
    id: u32,
    /// x, y and z in mm, right-handed.
    at_mm: [f64; 3],
    /// Whether the design holds it fixed.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    support: bool,
    /// The motions that a support leaves free: along x, y and z, then turns about them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    free: Option<[bool; 6]>,
    /// What holds the struts together there.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    joint: Option<JointFile>,
}

/// A strut.
#[derive(Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "Edge")]
pub(crate) struct EdgeFile {
    id: u32,
    /// The vertex where it starts, by id.
    a: u32,
    /// The vertex where it ends, by id.
    b: u32,
    /// Whether it is part of the ceiling, the last layer that is built.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    ceiling: bool,
}

impl WireframeFile {
    pub(crate) fn of(wireframe: &Wireframe) -> Self {
        let NextIds { vertex, edge } = wireframe.next_ids();
        let vertices = wireframe.vertices().map(|(id, vertex)| VertexFile {
            id: id.0,
            at_mm: vertex.position.coords.into(),
            support: vertex.support,
            free: Some(vertex.free).filter(|free| free.contains(&true)),
            joint: vertex.joint.map(JointFile::from),
        });
        let edges = wireframe.edges().map(|(id, edge)| EdgeFile {
            id: id.0,
            a: edge.a.0,
            b: edge.b.0,
            ceiling: edge.ceiling,
        });
        Self { next_vertex: vertex, next_edge: edge, vertices: vertices.collect(), edges: edges.collect() }
    }

    pub(crate) fn build(self, file: &str) -> Result<Wireframe, DocumentError> {
        let refuse = |error| DocumentError::Wireframe { file: file.to_owned(), error };
        let mut wireframe = Wireframe::new();
        for VertexFile { id, at_mm, support, free, joint } in self.vertices {
            let (position, free) = (Point3::from(at_mm), free.unwrap_or_default());
            let vertex = Vertex { position, support, free, joint: joint.map(Joint::from) };
            wireframe.insert_vertex(VertexId(id), vertex).map_err(refuse)?;
        }
        for EdgeFile { id, a, b, ceiling } in self.edges {
            let edge = Edge { a: VertexId(a), b: VertexId(b), ceiling };
            wireframe.insert_edge(EdgeId(id), edge).map_err(refuse)?;
        }
        wireframe.reserve_ids(NextIds { vertex: self.next_vertex, edge: self.next_edge });
        Ok(wireframe)
    }
}
