//! What a reader merged, ignored or assumed. Nothing is dropped in silence.

use std::fmt;

use wirebend_core::units::{Length, Mm};
use wirebend_error::{ErrorRemedy, InputName};

use super::error::Location;

#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum NoteKind {
    /// Nothing says what the numbers measure.
    UnitsAssumed,
    /// The caller's unit was used and not the file's.
    UnitsOverridden,
    /// Vertices that lay on another one.
    VerticesMerged,
    /// Edges between the same two vertices as another one.
    EdgesMerged,
    /// Edges without length.
    EdgesCollapsed,
    /// Vertices that no edge or face uses.
    VerticesUnused,
    /// The same where something would hold them.
    SupportsUnused,
    NormalsIgnored,
    TextureIgnored,
    /// Colours and other values of a vertex, a face or a triangle.
    AttributesIgnored,
    /// Names of objects, groups and materials.
    NamesIgnored,
    /// Bytes behind the last entry that a file announces.
    TrailingIgnored,
    /// Points that belong to no line or face.
    PointsIgnored,
    /// Lines or entries of a kind that is not read.
    StatementsIgnored,
    CommentsIgnored,
    /// Pin commands of a script.
    PinsIgnored,
    /// Layer numbers of a frame: kept for the files that have them.
    LayersIgnored,
    /// Loads, sections and materials of a frame.
    MaterialIgnored,
    /// Faces that only became a stencil while the file also has lines.
    FacesToStencil,
    /// A header line of a table.
    HeaderSkipped,
    /// Columns of a table that are not read.
    ColumnsIgnored,
    /// The last point repeats the first: the polyline is closed.
    PolylineClosed,
    /// A bend radius of zero.
    RadiusAssumed,
    /// The caller's bend radius, of a table that needs none.
    RadiusUnused,
    /// Bends of a table that have a radius: a wireframe keeps their corners.
    RadiiLost,
    /// No column of a table has the rotations.
    RotationMissing,
    /// Nothing says which way the rotations of a table turn.
    HandednessAssumed,
    /// A table says that its rotations turn the other way.
    LeftHanded,
    /// A program that ends on a bend, which no feed follows.
    EndsOnBend,
    /// Bends of a table that are negative although its angles should have no sign.
    NegativeAngles,
    /// Rotations that no bend follows.
    RotationsUnused,
    /// Recorded moves before the machine was homed, where a wire begins anew.
    MovesBeforeHoming,
    /// Wire that was drawn back behind the bend before.
    DrawnBack,
    /// Faces with a corner twice.
    FacesCollapsed,
    /// The size of the page gives the scale of a drawing.
    PageScale,
    /// A drawing is measured in pixels.
    PixelScale,
    /// The y axis of the file points down.
    AxisDown,
    /// The y axis of the file points up in space.
    AxisUp,
    /// Arcs, circles, ellipses and splines.
    CurvesFlattened,
    /// Splines that are given by points on them alone.
    FitPointsJoined,
    /// Insertions of blocks, uses of elements, components of objects.
    BlocksExploded,
    /// Elements that are invisible, or on layers that are off or frozen.
    HiddenIgnored,
    /// Elements on layers that were not asked for.
    OtherLayersIgnored,
    /// Elements of the paper space, around the drawing.
    PaperIgnored,
    TextsIgnored,
    HatchesIgnored,
    DimensionsIgnored,
    /// Faces, surfaces and solids of a drawing.
    SurfacesIgnored,
    ImagesIgnored,
    /// Filters, masks, clip paths and markers: what they hide is read, what they add is not.
    FiltersIgnored,
    /// Rules of style sheets that hide something, and what it is they do not say in a way that is understood.
    StylesIgnored,
    /// References to other files or to what is not there.
    ReferencesIgnored,
    /// Elements of a drawing of a kind that is not read.
    ElementsIgnored,
}

/// One thing that a reader did, and how many times.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Note {
    pub kind: NoteKind,
    /// How many times; 1 for what can happen once only.
    pub count: usize,
    /// Where the first of them is in the file, as far as the reader knows.
    pub first: Option<Location>,
    /// The least and the greatest of what has a size.
    pub sizes: Option<[Length; 2]>,
}

const ENDS_ON_BEND: &str = "the program ends on a bend that no feed follows: it makes no edge, so that a plan leaves it out; the program \
    itself, when it is run, makes it";

const HANDEDNESS_ASSUMED: &str = "nothing says which way rotations turn: taken by the right-hand rule along the wire; the table of a left-handed machine gives the mirror image";

impl NoteKind {
    /// A name that does not change with the wording.
    #[must_use]
    pub const fn code(self) -> &'static str {
        match self {
            Self::UnitsAssumed => "units-assumed",
            Self::UnitsOverridden => "units-overridden",
            Self::VerticesMerged => "vertices-merged",
            Self::EdgesMerged => "edges-merged",
            Self::EdgesCollapsed => "edges-collapsed",
            Self::VerticesUnused => "vertices-unused",
            Self::SupportsUnused => "supports-unused",
            Self::NormalsIgnored => "normals-ignored",
            Self::TextureIgnored => "texture-ignored",
            Self::AttributesIgnored => "attributes-ignored",
            Self::NamesIgnored => "names-ignored",
            Self::TrailingIgnored => "trailing-ignored",
            Self::PointsIgnored => "points-ignored",
            Self::StatementsIgnored => "statements-ignored",
            Self::CommentsIgnored => "comments-ignored",
            Self::PinsIgnored => "pins-ignored",
            Self::LayersIgnored => "layers-ignored",
            Self::MaterialIgnored => "material-ignored",
            Self::FacesToStencil => "faces-to-stencil",
            Self::HeaderSkipped => "header-skipped",
            Self::ColumnsIgnored => "columns-ignored",
            Self::PolylineClosed => "polyline-closed",
            Self::RadiusAssumed => "radius-assumed",
            Self::RadiusUnused => "radius-unused",
            Self::RadiiLost => "radii-lost",
            Self::RotationMissing => "rotation-missing",
            Self::HandednessAssumed => "handedness-assumed",
            Self::LeftHanded => "left-handed",
            Self::EndsOnBend => "ends-on-bend",
            Self::NegativeAngles => "negative-angles",
            Self::RotationsUnused => "rotations-unused",
            Self::MovesBeforeHoming => "moves-before-homing",
            Self::DrawnBack => "drawn-back",
            Self::FacesCollapsed => "faces-collapsed",
            Self::PageScale => "page-scale",
            Self::PixelScale => "pixel-scale",
            Self::AxisDown => "axis-down",
            Self::AxisUp => "axis-up",
            Self::CurvesFlattened => "curves-flattened",
            Self::FitPointsJoined => "fit-points-joined",
            Self::BlocksExploded => "blocks-exploded",
            Self::HiddenIgnored => "hidden-ignored",
            Self::OtherLayersIgnored => "other-layers-ignored",
            Self::PaperIgnored => "paper-ignored",
            Self::TextsIgnored => "texts-ignored",
            Self::HatchesIgnored => "hatches-ignored",
            Self::DimensionsIgnored => "dimensions-ignored",
            Self::SurfacesIgnored => "surfaces-ignored",
            Self::ImagesIgnored => "images-ignored",
            Self::FiltersIgnored => "filters-ignored",
            Self::StylesIgnored => "styles-ignored",
            Self::ReferencesIgnored => "references-ignored",
            Self::ElementsIgnored => "elements-ignored",
        }
    }

    /// What can be done about it.
    #[must_use]
    pub fn remedies(self) -> Vec<ErrorRemedy> {
        match self {
            Self::RadiusUnused => vec![ErrorRemedy::LeaveOut { inputs: vec![InputName::CentrelineRadius] }],
            Self::RadiusAssumed => vec![ErrorRemedy::CorrectInput { input: InputName::CentrelineRadius }],
            Self::RotationMissing => vec![ErrorRemedy::NameColumns { columns: "L, R, A and CLR".to_owned() }],
            Self::HandednessAssumed => vec![ErrorRemedy::CorrectInput { input: InputName::Handedness }],
            _ => Vec::new(),
        }
    }

    /// Singular and plural of what is counted, or the whole sentence where nothing is.
    const fn words(self) -> (&'static str, &'static str) {
        match self {
            Self::UnitsAssumed => ("units not given: taken as mm", ""),
            Self::UnitsOverridden => ("the file names another unit; yours was used", ""),
            Self::VerticesMerged => ("vertex merged into another", "vertices merged into others"),
            Self::EdgesMerged => ("duplicate edge merged", "duplicate edges merged"),
            Self::EdgesCollapsed => ("edge without length dropped", "edges without length dropped"),
            Self::VerticesUnused => ("unused vertex dropped", "unused vertices dropped"),
            Self::SupportsUnused => {
                ("support that no strut ends at dropped", "supports that no strut ends at dropped")
            }
            Self::NormalsIgnored => ("normal ignored", "normals ignored"),
            Self::TextureIgnored => ("texture coordinate ignored", "texture coordinates ignored"),
            Self::AttributesIgnored => {
                ("colour or other attribute ignored", "colours or other attributes ignored")
            }
            Self::NamesIgnored => {
                ("object, group or material name ignored", "object, group or material names ignored")
            }
            Self::TrailingIgnored => ("byte behind the end ignored", "bytes behind the end ignored"),
            Self::PointsIgnored => ("loose point ignored", "loose points ignored"),
            Self::StatementsIgnored => ("unknown statement ignored", "unknown statements ignored"),
            Self::CommentsIgnored => ("comment ignored", "comments ignored"),
            Self::PinsIgnored => ("pin command ignored", "pin commands ignored"),
            Self::LayersIgnored => {
                ("layer number kept, not used for sequences", "layer numbers kept, not used for sequences")
            }
            Self::MaterialIgnored => {
                ("material or section of the frame ignored", "materials or sections of the frame ignored")
            }
            Self::FacesToStencil => {
                ("face kept as stencil, not as edges", "faces kept as stencil, not as edges")
            }
            Self::HeaderSkipped => ("the first row is a header", ""),
            Self::ColumnsIgnored => ("column ignored", "columns ignored"),
            Self::PolylineClosed => ("the last point repeats the first: the polyline is closed", ""),
            Self::RadiusUnused => ("your bend radius was not used: the table has what it would be for", ""),
            Self::RadiusAssumed => ("no bend radius given: lengths are taken from corner to corner", ""),
            Self::RadiiLost => ("bend has a radius", "bends have radii"),
            Self::RotationMissing => ("no column has the rotations: all bends are taken in one plane", ""),
            Self::HandednessAssumed => (HANDEDNESS_ASSUMED, ""),
            Self::LeftHanded => ("the table is left-handed: its rotations are turned the other way", ""),
            Self::EndsOnBend => (ENDS_ON_BEND, ""),
            Self::NegativeAngles => (
                "bend with a minus sign, taken as a bend to the other side",
                "bends with a minus sign, taken as bends to the other side",
            ),
            Self::RotationsUnused => {
                ("rotation at the end without effect ignored", "rotations at the end without effect ignored")
            }
            Self::MovesBeforeHoming => (
                "move before the machine was homed left out: a wire begins anew there",
                "moves before the machine was homed left out: a wire begins anew there",
            ),
            Self::DrawnBack => (
                "feed back behind a bend left out: no wire follows it",
                "feeds back behind a bend left out: no wire follows them",
            ),
            Self::FacesCollapsed => ("face without area dropped", "faces without area dropped"),
            Self::PageScale => ("the size of the page, in mm or the like, gives the scale", ""),
            Self::PixelScale => ("no size in mm or the like: 96 px are taken as an inch", ""),
            Self::AxisDown => {
                ("y points down in the file: the drawing is mirrored so that it looks the same with y up", "")
            }
            Self::AxisUp => ("y is up in the file: the model is turned about x so that z is up", ""),
            Self::CurvesFlattened => (
                "curve made straight edges within the tolerance",
                "curves made straight edges within the tolerance",
            ),
            Self::FitPointsJoined => (
                "spline without control points: a cubic one is laid through its fit points",
                "splines without control points: cubic ones are laid through their fit points",
            ),
            Self::BlocksExploded => {
                ("block or part inserted where it is used", "blocks or parts inserted where they are used")
            }
            Self::HiddenIgnored => ("hidden element left out", "hidden elements left out"),
            Self::OtherLayersIgnored => {
                ("element on another layer left out", "elements on other layers left out")
            }
            Self::PaperIgnored => {
                ("element of the paper layout left out", "elements of the paper layout left out")
            }
            Self::TextsIgnored => ("text ignored", "texts ignored"),
            Self::HatchesIgnored => ("hatch ignored", "hatches ignored"),
            Self::DimensionsIgnored => ("dimension or leader ignored", "dimensions or leaders ignored"),
            Self::SurfacesIgnored => ("face, surface or solid ignored", "faces, surfaces or solids ignored"),
            Self::ImagesIgnored => ("picture ignored", "pictures ignored"),
            Self::FiltersIgnored => {
                ("filter, mask, clip path or marker ignored", "filters, masks, clip paths or markers ignored")
            }
            Self::StylesIgnored => (
                "rule of a style sheet not understood: what it hides is read",
                "rules of style sheets not understood: what they hide is read",
            ),
            Self::ReferencesIgnored => (
                "reference to another file or a missing element ignored",
                "references to other files or missing elements ignored",
            ),
            Self::ElementsIgnored => ("other element ignored", "other elements ignored"),
        }
    }
}

impl Note {
    fn counted(&self) -> String {
        let counted = match (self.kind.words(), self.count) {
            ((sentence, ""), _) => sentence.to_owned(),
            ((one, _), 1) => format!("1 {one}"),
            ((_, many), count) => format!("{count} {many}"),
        };
        let Some([least, most]) = self.sizes.map(|sizes| sizes.map(shown)) else { return counted };
        let range = if least == most { least } else { format!("{least} to {most}") };
        format!("{counted} of {range}, of which a wireframe keeps the corners alone")
    }
}

impl fmt::Display for Note {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.counted())?;
        let first = self.first.as_ref().map(Location::to_string).unwrap_or_default();
        match (first.strip_prefix(", "), self.count) {
            (None, _) => Ok(()),
            (Some(first), 1) => write!(f, " ({first})"),
            (Some(first), _) => write!(f, " (the first: {first})"),
        }
    }
}

/// A length to a thousandth of a millimetre, with as many digits as that needs.
fn shown(length: Length) -> String {
    Mm((length.mm() * 1000.0).round() / 1000.0).to_string()
}

/// Collects notes; each kind once, in the order in which they first came up.
#[derive(Debug, Clone, Default)]
pub(crate) struct Notes(Vec<Note>);

impl Notes {
    /// Counts; zero is no note.
    pub(crate) fn add(&mut self, kind: NoteKind, count: usize) {
        self.count(kind, count, None);
    }

    /// Counts one more, and keeps where the first of its kind is, if that is known.
    pub(crate) fn add_at(&mut self, kind: NoteKind, place: Option<Location>) {
        self.count(kind, 1, place);
    }

    /// Counts one more, and keeps the least and the greatest size.
    pub(crate) fn add_sized(&mut self, kind: NoteKind, size: Length) {
        self.count(kind, 1, None);
        if let Some(note) = self.0.iter_mut().find(|note| note.kind == kind) {
            let [least, most] = note.sizes.unwrap_or([size; 2]);
            note.sizes = Some([least.min(size), most.max(size)]);
        }
    }

    fn count(&mut self, kind: NoteKind, count: usize, first: Option<Location>) {
        if count == 0 {
            return;
        }
        match self.0.iter_mut().find(|note| note.kind == kind) {
            Some(note) => note.count += count,
            None => self.0.push(Note { kind, count, first, sizes: None }),
        }
    }

    /// What was counted, for the error that nothing else was there; without what was assumed.
    pub(crate) fn but(&self) -> String {
        let counted = self.0.iter().filter(|note| !note.kind.words().1.is_empty());
        let counted: Vec<String> = counted.map(Note::counted).collect();
        if counted.is_empty() { String::new() } else { format!(" ({})", counted.join(", ")) }
    }

    pub(crate) fn into_vec(self) -> Vec<Note> {
        self.0
    }
}
