//! What a person asks of the open design: JSON with units in its names.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_files::document::{JointFile, Look, PlacementFile, Walk};
use wirebend_files::read::LengthUnit;

use super::plane::{AxisName, OwnPlane, PlaneName};

/// What becomes of construction lines. They are named by their places in the list, from 0.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "make", rename_all = "kebab-case", deny_unknown_fields)]
pub enum ConstructionChange {
    /// Construction lines are drawn from place to place.
    Draw {
        /// Two places or more in order, mm: a line between each and the next.
        through_mm: Vec<[f64; 3]>,
    },
    /// Edges become construction lines.
    Lines { edges: Vec<u32> },
    /// Construction lines become edges, joined to vertices that are there.
    Edges { lines: Vec<u32> },
    /// Construction lines are deleted.
    Nothing { lines: Vec<u32> },
}

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
        vertices: Vec<PastedVertex>,
        /// Its edges by the places of their vertices in the list, from 0.
        edges: Vec<[usize; 2]>,
    },
    /// Deletes edges, and vertices with all edges at them.
    Delete {
        #[serde(default)]
        vertices: Vec<u32>,
        #[serde(default)]
        edges: Vec<u32>,
        /// Construction lines that are deleted with them, by their places in the list, from 0.
        #[serde(default, skip_serializing_if = "Vec::is_empty")]
        lines: Vec<u32>,
    },
    /// Moves vertices.
    Move {
        vertices: Vec<u32>,
        /// Construction lines that go with them, by their places in the list, from 0.
        #[serde(default, skip_serializing_if = "Vec::is_empty")]
        lines: Vec<u32>,
        /// How far, mm.
        by_mm: [f64; 3],
    },
    /// Puts vertices at exact positions, as a table of them says.
    Place {
        /// Vertices and their positions, mm.
        positions: Vec<Placed>,
    },
    /// Makes an edge as long as is asked for, along its direction.
    Length {
        edge: u32,
        /// More than 0.
        length_mm: f64,
        /// The end that stays where it is.
        stays: u32,
        /// What is connected beyond the other end.
        rest: RestPlace,
    },
    /// Makes the angle at a vertex between two edges what is asked for.
    Angle {
        vertex: u32,
        /// The edge that stays and the one that turns about the vertex; none: the only two, of which the first drawn stays.
        #[serde(default)]
        between: Option<[u32; 2]>,
        /// More than 0, up to 180.
        angle_deg: f64,
        /// The normal of the plane to turn in, of any length, where the edges are in line.
        #[serde(default)]
        normal: Option<[f64; 3]>,
        /// What is connected beyond the edge that turns.
        rest: RestPlace,
    },
    /// Puts a vertex on an edge.
    Split {
        edge: u32,
        /// Where: more than 0 (its first vertex), less than 1 (its second).
        at: f64,
    },
    /// Makes one vertex of several: the first of the list stays.
    Merge {
        vertices: Vec<u32>,
        /// Where it goes.
        at: MergePlace,
    },
    /// Turns, scales or shears vertices, with a matrix of 4 rows and 4 columns, row by row.
    Transform {
        vertices: Vec<u32>,
        /// Construction lines that go with them, by their places in the list, from 0.
        #[serde(default, skip_serializing_if = "Vec::is_empty")]
        lines: Vec<u32>,
        /// On positions in mm.
        matrix: [[f64; 4]; 4],
    },
    /// Turns vertices about an axis.
    Rotate {
        vertices: Vec<u32>,
        /// Construction lines that go with them, by their places in the list, from 0.
        #[serde(default, skip_serializing_if = "Vec::is_empty")]
        lines: Vec<u32>,
        axis: AxisName,
        /// A point of the axis, mm.
        through_mm: [f64; 3],
        /// Right-handed about the axis.
        angle_deg: f64,
    },
    /// Mirrors vertices in a plane.
    Mirror {
        vertices: Vec<u32>,
        /// Construction lines that go with them, by their places in the list, from 0.
        #[serde(default, skip_serializing_if = "Vec::is_empty")]
        lines: Vec<u32>,
        /// A point of the plane, mm.
        point_mm: [f64; 3],
        /// The normal of the plane, of any length.
        normal: [f64; 3],
        /// Whether the image is added; otherwise the vertices themselves are moved.
        copy: bool,
    },
    /// Adds copies of vertices and of the edges between them.
    Array {
        vertices: Vec<u32>,
        /// Construction lines that are copied with them, by their places in the list, from 0.
        #[serde(default, skip_serializing_if = "Vec::is_empty")]
        lines: Vec<u32>,
        /// From each copy to the next.
        step: [[f64; 4]; 4],
        /// How many copies are added.
        count: u32,
    },
    /// Fixes vertices as supports, or frees them.
    Support {
        vertices: Vec<u32>,
        /// Fixed or free.
        support: bool,
    },
    /// Puts a joint at vertices, or takes theirs away.
    Joint {
        vertices: Vec<u32>,
        /// What holds the struts together there; null takes it away.
        joint: Option<JointFile>,
    },
    /// Marks edges as part of the ceiling, the last layer that is built, or takes the mark away.
    Ceiling {
        edges: Vec<u32>,
        /// With or without the mark.
        ceiling: bool,
    },
    /// Merges vertices that lie on each other.
    Weld {
        /// How close, mm.
        tolerance_mm: f64,
    },
    /// Gives edges vertices of their own wherever others stay: what was one wire becomes two that touch.
    Detach { edges: Vec<u32> },
    /// Draws a circle as straight edges.
    Circle {
        /// Its middle.
        centre_mm: [f64; 3],
        /// The plane that it lies in, through its middle.
        plane: PlaneName,
        /// Absent for the plane of its name.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        on: Option<OwnPlane>,
        /// To its vertices.
        radius_mm: f64,
        /// How many edges.
        #[schemars(range(min = 3))]
        edges: u32,
    },
    /// Draws a regular polygon.
    Polygon {
        /// Its middle.
        centre_mm: [f64; 3],
        /// The plane that it lies in, through its middle.
        plane: PlaneName,
        /// Absent for the plane of its name.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        on: Option<OwnPlane>,
        #[schemars(range(min = 3))]
        sides: u32,
        /// What its size is.
        measure: PolygonMeasure,
        size_mm: f64,
        /// How far it is turned; at 0 a corner is on the first axis of the plane.
        #[serde(default)]
        turn_deg: f64,
    },
    /// Draws a helix as straight edges, from the first axis of a plane on, about its normal: z for xy, -y for xz, x for yz.
    Helix {
        /// The middle of its beginning.
        centre_mm: [f64; 3],
        plane: PlaneName,
        /// Absent for the plane of its name.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        on: Option<OwnPlane>,
        /// To its vertices.
        radius_mm: f64,
        /// How far a turn rises; less than 0 goes down.
        pitch_mm: f64,
        turns: f64,
        /// Edges of a whole turn.
        #[schemars(range(min = 3))]
        edges_per_turn: u32,
        /// Left-handed.
        #[serde(default)]
        left: bool,
    },
    /// Rounds corners with a radius, as chords that the machine of the design can make.
    Fillet {
        /// Corners: vertices with two edges.
        vertices: Vec<u32>,
        radius_mm: f64,
        /// What the wire is bent at most between two chords, degrees.
        step_deg: f64,
    },
    /// Takes those vertices out of a chain of edges that nearly lie on a straight line. Its ends stay; inner vertices
    /// with other edges go onto the line.
    Straighten {
        /// The chain, in any order.
        edges: Vec<u32>,
        /// How far a vertex may be from the line, mm.
        tolerance_mm: f64,
    },
    /// Draws a chain of edges anew as lines and arcs. Its ends and inner vertices with other edges stay.
    Round {
        /// The chain, in any order.
        edges: Vec<u32>,
        /// How far the chain may be from its lines and arcs, mm.
        tolerance_mm: f64,
        /// How far an edge goes round an arc at most, degrees: what the wire is bent at each of its vertices.
        step_deg: f64,
        /// No edge of an arc is shorter, mm.
        #[serde(default)]
        least_edge_mm: f64,
    },
    /// Allows edges to be laid twice, and no others.
    Doublings { edges: Vec<u32> },
    /// Begins the wire at a vertex, or wherever it is best.
    Start { vertex: Option<u32> },
    /// Bends the design from up to so many wires, fewer where more would not save doubled edges. Those that are accepted stay
    /// doubled. A closed wire is closed no more.
    Wires {
        #[schemars(range(min = 1))]
        wires: u32,
    },
    /// Ends the wire where it starts, or not. One that does is the only one of its part.
    Closed { closed: bool },
    /// Runs the wire the other way, or not.
    Reversed { reversed: bool },
    /// Takes walks for the wires, one each, instead of finding them anew; none: they are found anew. Their bends are made to the sides with
    /// which the wire hits least.
    Walks { walks: Vec<ChosenWalk> },
    /// How collisions are looked for: how far the wire has to stay from what it could hit, mm, and whether the part already bent is looked at
    /// as it hangs under its own weight.
    Collisions { clearance_mm: f64, sag: bool },
    /// Lets the machine wait for a person where the wire comes to a vertex, or no more.
    Pause {
        vertex: u32,
        /// Which time the wires come there, from 1, over all wires in their order.
        #[serde(default = "first")]
        #[schemars(range(min = 1))]
        pass: u32,
        /// What the person has to do there; null takes the pause point away.
        note: Option<String>,
    },
    /// Another machine, and the wire in it; none: the one that the machine's profile names.
    Machine {
        /// Its id.
        machine: String,
        /// The material's id.
        material: Option<String>,
    },
    /// Remarks on the whole.
    Notes { text: String },
    /// The unit that lengths are shown in.
    Units { units: LengthUnit },
    /// Makes construction lines, or takes them away. They are there to measure and to snap to, and are never bent.
    Construction { change: ConstructionChange },
    /// Takes a stencil away.
    RemoveStencil { stencil: u32 },
    /// Moves, turns and scales a stencil.
    PlaceStencil { stencil: u32, placement: PlacementFile },
    /// Turns a stencil as it lies about an axis of the design through its middle.
    TurnStencil {
        stencil: u32,
        axis: AxisName,
        /// Right-handed about the axis.
        angle_deg: f64,
    },
    /// Names, colours, hides or shows a stencil.
    StencilLook { stencil: u32, look: Look },
    /// Names, colours, hides or shows the part that an edge belongs to: all struts that hang together with it.
    PartLook { edge: u32, look: Look },
    /// Several changes, one after the other, as one thing to undo.
    Several {
        /// What a menu calls them together, after "Undo".
        label: String,
        /// The changes; each finds the design as the ones before it have left it.
        edits: Vec<EditRequest>,
    },
}

const fn first() -> u32 {
    1
}

/// The way of one wire along the edges.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ChosenWalk {
    /// The vertex where it starts.
    pub start: u32,
    /// The edges in the order in which it runs along them.
    pub edges: Vec<u32>,
}

impl From<&Walk> for ChosenWalk {
    fn from(walk: &Walk) -> Self {
        Self { start: walk.start.0, edges: walk.edges.iter().map(|id| id.0).collect() }
    }
}

/// A vertex of a piece.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PastedVertex {
    pub at_mm: [f64; 3],
    /// Whether the design holds it fixed.
    #[serde(default)]
    pub support: bool,
    /// What holds the struts together there.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub joint: Option<JointFile>,
}

/// A vertex and where it goes.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Placed {
    pub vertex: u32,
    pub at_mm: [f64; 3],
}

/// Where the vertex goes that others are merged into.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum MergePlace {
    /// Where the first of the list is.
    First,
    Last,
    /// The mean of all.
    Centre,
}

/// What happens to the rest of the wireframe beyond a vertex that goes elsewhere.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum RestPlace {
    /// It stays where it is.
    Stays,
    /// It goes along, as it is.
    Follows,
}

/// What the size of a regular polygon is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum PolygonMeasure {
    /// The radius to its corners.
    Corners,
    /// The radius to the middle of its sides.
    Flats,
    /// The length of a side.
    Side,
}
