//! Edits as values: what a person asks for, resolved against a wireframe into a [`Delta`].

mod chain;
mod chord_limits;
mod copies;
mod detach;
mod drawing;
mod error;
mod exact;
mod fillet;
mod outcome;
mod placement;
mod shapes;
mod smoothing;
mod topology;

use nalgebra::{Affine3, Point3, Unit, Vector3};

use super::delta::{Delta, Draft};
use super::graph::{EdgeId, VertexId, Wireframe};
use crate::units::{Angle, Length};

pub use chord_limits::{ChordLimits, NEAR_LIMIT};
pub use copies::reflection;
pub use error::{EditError, FilletFault};
pub use fillet::FilletOutcome;
pub use outcome::Outcome;
use shapes::Shape;
pub use shapes::{PolygonSize, ShapeOutcome, ShapePlane};

/// Where the vertex goes that others are merged into.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum MergeAt {
    /// Where the first of the list is.
    First,
    /// Where the last of the list is.
    Last,
    /// The mean of all of them.
    Centre,
}

/// What a vertex that goes elsewhere leaves behind.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Rest {
    /// The vertex alone goes; the other edges at it change.
    Stays,
    /// What is connected beyond the vertex goes along, as it is.
    Follows,
}

/// Whether a mirror moves what is there or adds its image.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MirrorMode {
    /// The vertices themselves are moved.
    InPlace,
    /// Their image is added; vertices on the plane are shared by both halves.
    Copy,
}

/// A change that a person asks for. Lengths in mm; vertices may be listed in any order, each once.
#[derive(Debug, Clone, PartialEq)]
pub enum Edit {
    /// Adds a vertex.
    AddVertex {
        /// Where.
        position: Point3<f64>,
    },
    /// Draws a strand: edges from a vertex that is there through new vertices to one that is there. Without new
    /// ones it joins the two; without ends and with one new vertex it adds that alone.
    Draw {
        /// The vertex that it begins at; none: at the first new one.
        from: Option<VertexId>,
        /// New vertices in order.
        through: Vec<Point3<f64>>,
        /// The vertex that it ends at; none: at the last new one.
        to: Option<VertexId>,
    },
    /// Adds a piece: vertices, and edges between them.
    Paste {
        /// The vertices.
        vertices: Vec<super::Vertex>,
        /// Edges by the places of their vertices in the list, from 0.
        edges: Vec<(usize, usize)>,
    },
    /// Joins two vertices by an edge.
    Connect {
        /// From.
        a: VertexId,
        /// To.
        b: VertexId,
    },
    /// Deletes edges, and vertices with all edges at them.
    Delete {
        /// Vertices to delete.
        vertices: Vec<VertexId>,
        /// Edges to delete.
        edges: Vec<EdgeId>,
    },
    /// Moves vertices.
    Move {
        /// Which.
        vertices: Vec<VertexId>,
        /// How far.
        by: Vector3<f64>,
    },
    /// Puts a vertex at an exact position.
    Place {
        /// Which.
        vertex: VertexId,
        /// Where.
        position: Point3<f64>,
    },
    /// Makes an edge as long as is asked for: one end goes along the edge, the other stays exactly where it is.
    SetLength {
        /// Which.
        edge: EdgeId,
        /// More than 0.
        length: Length,
        /// The end that stays.
        stays: VertexId,
        /// Whether what is connected beyond the other end goes along; not where the edge is part of a closed loop.
        rest: Rest,
    },
    /// Makes the angle at a vertex between two edges what is asked for: one stays exactly where it is, the other turns about the
    /// vertex, in the plane of both, and keeps its length.
    SetAngle {
        /// Which.
        vertex: VertexId,
        /// The edge that stays and the one that turns; none: the only two at the vertex, of which the first drawn stays.
        between: Option<(EdgeId, EdgeId)>,
        /// More than 0° (on each other), up to 180° (in line).
        angle: Angle,
        /// The normal of the plane to turn in where the two edges are in line and have none of their own: right-handed from the edge
        /// that stays to the other.
        normal: Option<Unit<Vector3<f64>>>,
        /// Whether what is connected beyond the edge that turns goes along; not where both edges are part of a closed loop.
        rest: Rest,
    },
    /// Puts a vertex on an edge. The edge keeps its id up to there; the rest is a new edge.
    SplitEdge {
        /// Which.
        edge: EdgeId,
        /// Where: more than 0 (its first vertex), less than 1 (its second).
        at: f64,
    },
    /// Makes one vertex of several: the first of the list survives. Edges that become points or
    /// repeat another one go.
    Merge {
        /// Which.
        vertices: Vec<VertexId>,
        /// Where the survivor goes.
        at: MergeAt,
    },
    /// Turns, scales, shears or moves vertices.
    Transform {
        /// Which.
        vertices: Vec<VertexId>,
        /// How; positions in mm.
        transform: Affine3<f64>,
    },
    /// Mirrors vertices, and with [`MirrorMode::Copy`] the edges between them.
    Mirror {
        /// Which.
        vertices: Vec<VertexId>,
        /// A point of the plane.
        point: Point3<f64>,
        /// The normal of the plane.
        normal: Unit<Vector3<f64>>,
        /// Move or add.
        mode: MirrorMode,
        /// A copy that is this close to its original shares its vertex.
        weld: Length,
    },
    /// Adds copies of vertices and of the edges between them.
    Array {
        /// Which.
        vertices: Vec<VertexId>,
        /// From each copy to the next.
        step: Affine3<f64>,
        /// How many copies are added.
        count: u32,
        /// A copied vertex that is this close to one of the copy before shares it.
        weld: Length,
    },
    /// Fixes vertices altogether as supports of the structure, or frees them.
    SetSupport {
        /// Which.
        vertices: Vec<VertexId>,
        /// Fixed or free.
        support: bool,
    },
    /// Puts a joint at vertices, or takes theirs away.
    SetJoint {
        /// Which.
        vertices: Vec<VertexId>,
        /// What holds the struts together there.
        joint: Option<super::Joint>,
    },
    /// Marks edges as part of the ceiling, the last layer that is built, or takes the mark away.
    SetCeiling {
        /// Which.
        edges: Vec<EdgeId>,
        /// With or without the mark.
        ceiling: bool,
    },
    /// Merges vertices that lie on each other.
    Weld {
        /// How close.
        tolerance: Length,
    },
    /// Gives edges vertices of their own wherever others stay, at the same places: what was one wire becomes two that
    /// touch. Where nothing stays, nothing changes.
    Detach {
        /// Which.
        edges: Vec<EdgeId>,
    },
    /// Draws a closed polygon of equal sides: with many, a circle.
    AddPolygon {
        /// Where; its first corner is on the first axis, before it is turned.
        plane: ShapePlane,
        /// How many, 3 or more.
        sides: u32,
        /// More than 0.
        size: PolygonSize,
        /// By how much it is turned in its plane.
        turn: Angle,
    },
    /// Draws a helix of straight edges about the normal of a plane.
    AddHelix {
        /// Where it begins: on the first axis.
        plane: ShapePlane,
        /// Of the circle that its vertices are over; more than 0.
        radius: Length,
        /// How far a turn rises along the normal, u × v; less than 0 goes down.
        pitch: Length,
        /// More than 0; whole turns or not.
        turns: f64,
        /// Edges of a whole turn, 3 or more.
        sides: u32,
        /// Against the right hand about the normal.
        left: bool,
    },
    /// Rounds corners: each is replaced by chords of the arc of a radius that touches both of its edges, from where it touches the one
    /// to where it touches the other.
    Fillet {
        /// Which: with two edges that are neither in line nor on each other, and neither support nor joint.
        vertices: Vec<VertexId>,
        /// Of the arcs; more than 0.
        radius: Length,
        /// How far a chord goes round at most, more than 0 and up to 180°: what the wire is bent at the vertices between two. An arc
        /// has two chords or more.
        step: Angle,
        /// No chord, and nothing that is left of an edge, is shorter than can be made; there are fewer chords then.
        limits: ChordLimits,
    },
    /// Takes those vertices out of a chain that are within a tolerance of a straight line. Its ends stay; inner
    /// vertices with other edges go onto the line, supports and joints stay where they are.
    Straighten {
        /// The chain, in any order.
        edges: Vec<EdgeId>,
        /// How far a vertex may be from the line.
        tolerance: Length,
    },
    /// Draws a chain anew as lines and arcs, with the vertices of an arc on it. Its ends, inner vertices with other
    /// edges, supports and joints stay where they are and divide it.
    Round {
        /// The chain, in any order.
        edges: Vec<EdgeId>,
        /// How far the chain may be from its lines and arcs.
        tolerance: Length,
        /// How far an edge goes round at most, more than 0 and up to 180°: what the wire is bent at each vertex. An arc
        /// has two edges or more.
        step: Angle,
        /// No edge of an arc is shorter; there are fewer then.
        min_edge: Length,
    },
}

impl Edit {
    /// The exact difference that this edit makes to a wireframe.
    ///
    /// # Errors
    /// [`EditError`] when it cannot be made; see the variants.
    pub fn resolve(&self, wireframe: &Wireframe) -> Result<Delta, EditError> {
        let mut draft = Draft::new(wireframe);
        match self {
            Self::AddVertex { position } => {
                draft.add_vertex(super::Vertex::at(*position))?;
            }
            Self::Draw { from, through, to } => drawing::strand(&mut draft, *from, through, *to)?,
            Self::Paste { vertices, edges } => drawing::piece(&mut draft, vertices, edges)?,
            Self::Connect { a, b } => topology::connect(&mut draft, *a, *b)?,
            Self::Delete { vertices, edges } => topology::delete(&mut draft, vertices, edges)?,
            Self::Move { vertices, by } => placement::shift(&mut draft, vertices, by)?,
            Self::Place { vertex, position } => draft.move_vertex(*vertex, *position)?,
            Self::SetLength { edge, length, stays, rest } => {
                exact::set_length(&mut draft, *edge, *length, *stays, *rest)?;
            }
            Self::SetAngle { vertex, between, angle, normal, rest } => {
                exact::set_angle(&mut draft, *vertex, *between, *angle, *normal, *rest)?;
            }
            Self::SplitEdge { edge, at } => topology::split(&mut draft, *edge, *at)?,
            Self::Merge { vertices, at } => topology::merge(&mut draft, vertices, *at)?,
            Self::Transform { vertices, transform } => placement::transform(&mut draft, vertices, transform)?,
            Self::Mirror { vertices, point, normal, mode, weld } => {
                let image = copies::reflection(*point, *normal);
                match mode {
                    MirrorMode::InPlace => placement::transform(&mut draft, vertices, &image)?,
                    MirrorMode::Copy => {
                        copies::copy(&mut draft, vertices, &image, *weld)?;
                    }
                }
            }
            Self::Array { vertices, step, count, weld } => {
                copies::array(&mut draft, vertices, step, *count, *weld)?;
            }
            Self::SetSupport { vertices, support } => placement::set_support(&mut draft, vertices, *support)?,
            Self::SetJoint { vertices, joint } => placement::set_joint(&mut draft, vertices, *joint)?,
            Self::SetCeiling { edges, ceiling } => placement::set_ceiling(&mut draft, edges, *ceiling)?,
            Self::Detach { edges } => detach::detach(&mut draft, edges)?,
            Self::AddPolygon { plane, sides, size, turn } => {
                Shape::polygon(plane, *sides, *size, *turn)?.draw(&mut draft)?;
            }
            Self::AddHelix { plane, radius, pitch, turns, sides, left } => {
                Shape::helix(plane, *radius, *pitch, *turns, *sides, *left)?.draw(&mut draft)?;
            }
            Self::Fillet { vertices, radius, step, limits } => {
                fillet::fillet(&mut draft, vertices, *radius, *step, limits)?;
            }
            Self::Straighten { edges, tolerance } => smoothing::straighten(&mut draft, edges, *tolerance)?,
            Self::Round { edges, tolerance, step, min_edge } => {
                smoothing::round(&mut draft, edges, *tolerance, *step, *min_edge)?;
            }
            Self::Weld { tolerance } => return Ok(wireframe.weld(*tolerance).0),
        }
        Ok(draft.finish())
    }
}

impl Wireframe {
    /// Makes an edit and returns the difference, whose inverse undoes it.
    ///
    /// ```
    /// use nalgebra::Point3;
    /// use wirebend_core::wireframe::{Edit, Wireframe};
    /// let mut wireframe = Wireframe::new();
    /// let before = wireframe.clone();
    /// let delta = wireframe.apply(&Edit::AddVertex { position: Point3::new(1.0, 2.0, 3.0) })?;
    /// wireframe.commit(&delta.inverse())?;
    /// assert_eq!(wireframe, before);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`EditError`] when it cannot be made; the wireframe is then untouched.
    pub fn apply(&mut self, edit: &Edit) -> Result<Delta, EditError> {
        let delta = edit.resolve(self)?;
        // A difference that was made for this very state is never stale.
        let committed = self.commit(&delta);
        debug_assert_eq!(committed, Ok(()));
        Ok(delta)
    }
}

/// Each vertex must exist and be listed once.
fn check_listed(draft: &Draft, vertices: &[VertexId]) -> Result<(), EditError> {
    let mut seen = std::collections::BTreeSet::new();
    for &vertex in vertices {
        draft.position(vertex)?;
        if !seen.insert(vertex) {
            return Err(EditError::Repeated(vertex));
        }
    }
    Ok(())
}

/// Each edge must exist and be listed once.
fn check_edges(draft: &Draft, edges: &[EdgeId]) -> Result<(), EditError> {
    let mut seen = std::collections::BTreeSet::new();
    for &edge in edges {
        if draft.edge(edge).is_none() {
            return Err(EditError::NoEdge(edge));
        }
        if !seen.insert(edge) {
            return Err(EditError::RepeatedEdge(edge));
        }
    }
    Ok(())
}
