//! What a person asks of the open design: JSON with units in its names, resolved into the edits of `core`.

use nalgebra::{Affine3, Matrix4, Point3, Unit, Vector3};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_core::units::Length;
use wirebend_core::wireframe::{EdgeId, Edit, MergeAt, MirrorMode, Vertex, VertexId};
use wirebend_files::read::LengthUnit;

use super::EditorError;

/// A change that a person asks for. Lengths in mm, vertices and edges by their ids.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "edit", rename_all = "kebab-case", deny_unknown_fields)]
pub enum EditRequest {
    /// Draws a strand from a vertex that is there through new ones to one that is there.
    Draw {
        /// The vertex that it begins at; none: at the first new one.
        #[serde(default)]
        from: Option<u32>,
        /// New vertices in order, mm.
        #[serde(default)]
        through_mm: Vec<[f64; 3]>,
        /// The vertex that it ends at; none: at the last new one.
        #[serde(default)]
        to: Option<u32>,
    },
    /// Adds a piece.
    Paste {
        /// Its vertices.
        vertices: Vec<PastedVertex>,
        /// Its edges by the places of their vertices in the list, from 0.
        edges: Vec<[usize; 2]>,
    },
    /// Deletes edges, and vertices with all edges at them.
    Delete {
        /// Vertices.
        #[serde(default)]
        vertices: Vec<u32>,
        /// Edges.
        #[serde(default)]
        edges: Vec<u32>,
    },
    /// Moves vertices.
    Move {
        /// Which.
        vertices: Vec<u32>,
        /// How far, mm.
        by_mm: [f64; 3],
    },
    /// Puts vertices at exact positions, as a table of them says.
    Place {
        /// Vertices and their positions, mm.
        positions: Vec<Placed>,
    },
    /// Puts a vertex on an edge.
    Split {
        /// Which.
        edge: u32,
        /// Where: more than 0 (its first vertex), less than 1 (its second).
        at: f64,
    },
    /// Makes one vertex of several: the first of the list stays.
    Merge {
        /// Which.
        vertices: Vec<u32>,
        /// Where it goes.
        at: MergePlace,
    },
    /// Turns, scales or shears vertices, with a matrix of 4 rows and 4 columns, row by row.
    Transform {
        /// Which.
        vertices: Vec<u32>,
        /// On positions in mm.
        matrix: [[f64; 4]; 4],
    },
    /// Mirrors vertices in a plane.
    Mirror {
        /// Which.
        vertices: Vec<u32>,
        /// A point of the plane, mm.
        point_mm: [f64; 3],
        /// The normal of the plane, of any length.
        normal: [f64; 3],
        /// Whether the image is added; otherwise the vertices themselves are moved.
        copy: bool,
    },
    /// Adds copies of vertices and of the edges between them.
    Array {
        /// Which.
        vertices: Vec<u32>,
        /// From each copy to the next.
        step: [[f64; 4]; 4],
        /// How many copies are added.
        count: u32,
    },
    /// Fixes vertices as supports, or frees them.
    Support {
        /// Which.
        vertices: Vec<u32>,
        /// Fixed or free.
        support: bool,
    },
    /// Merges vertices that lie on each other.
    Weld {
        /// How close, mm.
        tolerance_mm: f64,
    },
    /// Allows edges to be laid twice, and no others.
    Doublings {
        /// Which.
        edges: Vec<u32>,
    },
    /// Begins the wire at a vertex, or wherever it is best.
    Start {
        /// Where.
        vertex: Option<u32>,
    },
    /// Another machine, and the wire in it; none: the one that the machine's profile names.
    Machine {
        /// Its id.
        machine: String,
        /// The material's id.
        material: Option<String>,
    },
    /// Remarks on the whole.
    Notes {
        /// The text.
        text: String,
    },
    /// The unit that lengths are shown in.
    Units {
        /// The unit.
        units: LengthUnit,
    },
    /// Takes the stencil away.
    RemoveStencil {},
}

/// A vertex of a piece.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PastedVertex {
    /// Where it is, mm.
    pub at_mm: [f64; 3],
    /// Whether the design holds it fixed.
    #[serde(default)]
    pub support: bool,
}

/// A vertex and where it goes.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Placed {
    /// Which.
    pub vertex: u32,
    /// Where, mm.
    pub at_mm: [f64; 3],
}

/// Where the vertex goes that others are merged into.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum MergePlace {
    /// Where the first of the list is.
    First,
    /// Where the last is.
    Last,
    /// The mean of all.
    Centre,
}

impl EditRequest {
    /// The edits of the wireframe that it is; none where it changes something else.
    pub(super) fn of_wireframe(&self, weld: Length) -> Result<Option<Vec<Edit>>, EditorError> {
        let one = |edit| Ok(Some(vec![edit]));
        match self {
            Self::Draw { from, through_mm, to } => one(Edit::Draw {
                from: from.map(VertexId),
                through: through_mm.iter().copied().map(Point3::from).collect(),
                to: to.map(VertexId),
            }),
            Self::Paste { vertices, edges } => one(Edit::Paste {
                vertices: vertices
                    .iter()
                    .map(|vertex| Vertex { position: vertex.at_mm.into(), support: vertex.support })
                    .collect(),
                edges: edges.iter().map(|&[a, b]| (a, b)).collect(),
            }),
            Self::Delete { vertices, edges } => one(Edit::Delete {
                vertices: ids(vertices),
                edges: edges.iter().copied().map(EdgeId).collect(),
            }),
            Self::Move { vertices, by_mm } => {
                one(Edit::Move { vertices: ids(vertices), by: Vector3::from(*by_mm) })
            }
            Self::Place { positions } => Ok(Some(
                positions
                    .iter()
                    .map(|placed| Edit::Place {
                        vertex: VertexId(placed.vertex),
                        position: placed.at_mm.into(),
                    })
                    .collect(),
            )),
            Self::Split { edge, at } => one(Edit::SplitEdge { edge: EdgeId(*edge), at: *at }),
            Self::Merge { vertices, at } => {
                let at = match at {
                    MergePlace::First => MergeAt::First,
                    MergePlace::Last => MergeAt::Last,
                    MergePlace::Centre => MergeAt::Centre,
                };
                one(Edit::Merge { vertices: ids(vertices), at })
            }
            Self::Transform { vertices, matrix } => {
                one(Edit::Transform { vertices: ids(vertices), transform: affine(matrix)? })
            }
            Self::Mirror { vertices, point_mm, normal, copy } => {
                let normal = Unit::try_new(Vector3::from(*normal), 1e-12).ok_or(EditorError::Normal)?;
                let mode = if *copy { MirrorMode::Copy } else { MirrorMode::InPlace };
                let point = Point3::from(*point_mm);
                one(Edit::Mirror { vertices: ids(vertices), point, normal, mode, weld })
            }
            Self::Array { vertices, step, count } => {
                one(Edit::Array { vertices: ids(vertices), step: affine(step)?, count: *count, weld })
            }
            Self::Support { vertices, support } => {
                one(Edit::SetSupport { vertices: ids(vertices), support: *support })
            }
            Self::Weld { tolerance_mm } => {
                let tolerance = Length::from_mm(*tolerance_mm).ok().filter(|mm| *mm >= Length::ZERO);
                one(Edit::Weld { tolerance: tolerance.ok_or(EditorError::Tolerance(*tolerance_mm))? })
            }
            Self::Doublings { .. }
            | Self::Start { .. }
            | Self::Machine { .. }
            | Self::Notes { .. }
            | Self::Units { .. }
            | Self::RemoveStencil {} => Ok(None),
        }
    }

    /// What a menu calls it after "Undo".
    pub(super) fn label(&self) -> String {
        let some = |count: usize, one: &str, many: &str| match count {
            1 => one.to_owned(),
            count => format!("{count} {many}"),
        };
        let vertices = |list: &[u32]| some(list.len(), "vertex", "vertices");
        match self {
            Self::Draw { through_mm, .. } if through_mm.is_empty() => "connect vertices".to_owned(),
            Self::Draw { .. } => "draw".to_owned(),
            Self::Paste { .. } => "paste".to_owned(),
            Self::Delete { vertices: gone, edges } if edges.is_empty() => {
                format!("delete {}", vertices(gone))
            }
            Self::Delete { vertices: gone, edges } if gone.is_empty() => {
                format!("delete {}", some(edges.len(), "edge", "edges"))
            }
            Self::Delete { .. } => "delete".to_owned(),
            Self::Move { vertices: moved, .. } => format!("move {}", vertices(moved)),
            Self::Place { positions } => format!("place {}", some(positions.len(), "vertex", "vertices")),
            Self::Split { .. } => "split edge".to_owned(),
            Self::Merge { vertices: merged, .. } => format!("merge {}", vertices(merged)),
            Self::Transform { vertices: turned, .. } => format!("transform {}", vertices(turned)),
            Self::Mirror { .. } => "mirror".to_owned(),
            Self::Array { .. } => "array".to_owned(),
            Self::Support { support: true, .. } => "fix support".to_owned(),
            Self::Support { .. } => "free support".to_owned(),
            Self::Weld { .. } => "weld".to_owned(),
            Self::Doublings { .. } => "doubled edges".to_owned(),
            Self::Start { .. } => "start of the wire".to_owned(),
            Self::Machine { .. } => "machine".to_owned(),
            Self::Notes { .. } => "notes".to_owned(),
            Self::Units { .. } => "units".to_owned(),
            Self::RemoveStencil {} => "remove stencil".to_owned(),
        }
    }
}

fn ids(list: &[u32]) -> Vec<VertexId> {
    list.iter().copied().map(VertexId).collect()
}

/// A matrix whose last row is 0 0 0 1.
fn affine(rows: &[[f64; 4]; 4]) -> Result<Affine3<f64>, EditorError> {
    let matrix = Matrix4::from_fn(|row, column| rows[row][column]);
    let affine = rows[3]
        .iter()
        .zip([0.0, 0.0, 0.0, 1.0])
        .all(|(found, expected)| (found - expected).abs() < f64::EPSILON);
    if affine && matrix.iter().all(|number| number.is_finite()) {
        Ok(Affine3::from_matrix_unchecked(matrix))
    } else {
        Err(EditorError::Matrix)
    }
}
