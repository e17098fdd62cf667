//! What a person gives, in an option or in a field.

use schemars::JsonSchema;
use serde::Serialize;

/// Something that a person gives.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum InputName {
    /// The format of a file.
    Format,
    /// The factor that a model is scaled by.
    Scale,
    /// The unit of a file's numbers.
    Units,
    /// The distance below which vertices are one.
    Weld,
    /// Whether the edges of faces are taken.
    FaceEdges,
    /// The centreline radius of a table.
    CentrelineRadius,
    /// How far edges may be from a curve.
    Tolerance,
    /// How short edges of curves may be.
    ShortestEdge,
    /// The layers of a drawing.
    Layers,
    /// Which way a table's rotations turn.
    Handedness,
    /// Whether a program is nominal or compensated.
    Program,
    /// The machine.
    Machine,
    /// The material.
    Material,
    /// Whether edges may be doubled.
    Double,
    /// Whether detours are made.
    Detours,
    /// How many wires there may be.
    Wires,
    /// Whether the route ends where it starts.
    Closed,
    /// The vertex that the wire starts at.
    Start,
    /// Whether the wire runs the other way.
    Reverse,
    /// Whether the order of a program is kept.
    KeepOrder,
    /// The look for collisions.
    Collisions,
    /// The search for wires that hit nothing.
    AvoidCollisions,
    /// How far the wire has to stay from what it could hit.
    Clearance,
    /// How far the part already bent sags.
    Sag,
    /// How often a job is simulated.
    Runs,
    /// How close the vertices of a simulated wire have to be to their places.
    Within,
    /// What holds a frame.
    Supports,
    /// Gravity.
    Gravity,
    /// What acts on a frame besides.
    Loads,
    /// How many modes are looked for.
    Modes,
    /// How many pieces a strut is cut into.
    Pieces,
    /// How far struts bow.
    Bow,
    /// The faces that are to be flat.
    Faces,
    /// What is required of a closed frame.
    Requirements,
    /// Which motions are off.
    Vary,
    /// The share of what is required that is for feeds.
    FeedShare,
    /// A truss of closed formulas.
    Continuum,
    /// Whether the exact expectation is asked for.
    Expected,
    /// How far a joint of a frame may be from where it is drawn.
    Epsilon,
    /// How long is searched.
    TimeLimit,
    /// What is placed at once.
    GroupBy,
    /// The id of a new profile.
    ProfileId,
    /// The name of a new profile.
    ProfileName,
    /// The settings of a format.
    FormatSettings,
    /// The moves of a machine.
    Moves,
    /// Whether a wire is resumed.
    Resume,
    /// Whether a wire is given up.
    Abandon,
    /// The bender and the wire that a simulated machine has.
    SimulatedAs,
    /// What was read of coupons.
    Readings,
    /// The values of a profile.
    ProfileValues,
    /// The keys of a profile.
    ProfileKeys,
    /// The day of a measurement.
    Date,
}

impl InputName {
    /// The thing in plain words, without an article.
    #[must_use]
    pub const fn words(self) -> &'static str {
        match self {
            Self::Format => "format",
            Self::Scale => "scale",
            Self::Units => "unit",
            Self::Weld => "weld distance",
            Self::FaceEdges => "edges of faces",
            Self::CentrelineRadius => "centreline radius",
            Self::Tolerance => "tolerance",
            Self::ShortestEdge => "shortest edge",
            Self::Layers => "layers",
            Self::Handedness => "handedness",
            Self::Program => "kind of program",
            Self::Machine => "machine",
            Self::Material => "material",
            Self::Double => "doubled edges",
            Self::Detours => "detours",
            Self::Wires => "number of wires",
            Self::Closed => "closed route",
            Self::Start => "start",
            Self::Reverse => "direction",
            Self::KeepOrder => "order of the program",
            Self::Collisions => "check for collisions",
            Self::AvoidCollisions => "search for a program without collisions",
            Self::Clearance => "clearance",
            Self::Sag => "sag",
            Self::Runs => "number of runs",
            Self::Within => "accuracy",
            Self::Supports => "supports",
            Self::Gravity => "gravity",
            Self::Loads => "loads",
            Self::Modes => "number of modes",
            Self::Pieces => "number of pieces",
            Self::Bow => "bow of struts",
            Self::Faces => "faces",
            Self::Requirements => "requirements",
            Self::Vary => "motions that vary",
            Self::FeedShare => "share for feeds",
            Self::Continuum => "truss of closed formulas",
            Self::Expected => "exact expectation",
            Self::Epsilon => "largest sag",
            Self::TimeLimit => "time limit",
            Self::GroupBy => "groups",
            Self::ProfileId => "id",
            Self::ProfileName => "name",
            Self::FormatSettings => "settings of the format",
            Self::Moves => "moves",
            Self::Resume => "resuming",
            Self::Abandon => "giving up",
            Self::SimulatedAs => "simulated bender and wire",
            Self::Readings => "readings",
            Self::ProfileValues => "values",
            Self::ProfileKeys => "keys",
            Self::Date => "date",
        }
    }
}
