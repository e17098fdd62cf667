//! Why a file cannot be read: which file, where in it, what is there, what should be.

use std::fmt;

use wirebend_core::mesh::StencilError;
use wirebend_core::units::Mm;
use wirebend_core::wireframe::WireframeError;

use wirebend_error::{ErrorCode, ErrorRemedy, InputName};

use crate::document::DocumentError;

/// Half a turn, but for what numbers are rounded by: a bend beyond it loops round.
pub(super) const MOST_BEND_DEG: f64 = 180.0 + 1e-6;

#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Location {
    /// A line of text, from 1.
    Line(usize),
    /// A line of JSON, from 1, and the way to what is there by names and indices from 0: `nodes[3].point`.
    Entry { line: usize, path: String },
    /// An offset in bytes, from 0.
    Byte(usize),
    /// An entry of a list, as its name and its index from 0: "node 3".
    Item(&'static str, usize),
    /// The same in a part of the file that has a name: "load case wind, node load 3".
    ItemOf { part: &'static str, name: String, what: &'static str, index: usize },
    /// The file as a whole.
    File,
}

impl fmt::Display for Location {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Line(line) => write!(f, ", line {line}"),
            Self::Entry { line, path } => write!(f, ", line {line}, {path}"),
            Self::Byte(offset) => write!(f, ", byte {offset}"),
            Self::Item(what, index) => write!(f, ", {what} {index}"),
            Self::ItemOf { part, name, what, index } => write!(f, ", {part} {name}, {what} {index}"),
            Self::File => Ok(()),
        }
    }
}

/// Why a file cannot be read.
#[derive(Debug, thiserror::Error)]
pub enum ReadError {
    /// The operating system refused.
    #[error("{file}: {error}")]
    Io {
        file: String,
        /// What the system says.
        error: std::io::Error,
    },
    /// It is a folder.
    #[error("{file} is a folder, not a file")]
    Folder { file: String },
    /// The file is larger than any sensible one of its format.
    #[error("{file} has {bytes} bytes, the limit is {limit}")]
    TooLarge {
        file: String,
        bytes: u64,
        /// The largest that is read.
        limit: u64,
    },
    /// Neither name nor content tells the format.
    #[error("{file}: this is none of the known formats ({known})", known = super::format::known())]
    UnknownFormat { file: String },
    /// Nothing is in it.
    #[error("{file}: the file is empty")]
    EmptyFile { file: String },
    /// A program for the axes of one machine, from which no wire can be read back.
    #[error("{file}: G-code can't be opened; these formats can: {known}", known = super::format::known())]
    GCode { file: String },
    /// An order in which the struts of a frame are built, and no frame.
    #[error("{file} is an order in which struts are built, and no frame: open the frame that it is of")]
    Order { file: String },
    /// Something else than what the format has there.
    #[error("{file}{place}: found {found}, expected {expected}")]
    Syntax {
        file: String,
        place: Location,
        /// What is there, shortened.
        found: String,
        /// What should be there.
        expected: Box<str>,
        remedy: Box<ErrorRemedy>,
    },
    /// A number that is not one, or not finite.
    #[error("{file}{place}: {found} is not a {expected}")]
    Number {
        file: String,
        place: Location,
        /// What is there, shortened.
        found: String,
        /// The kind of number.
        expected: &'static str,
    },
    /// An index that names nothing.
    #[error("{file}{place}: {found} names no {what}: {have}")]
    Index {
        file: String,
        place: Location,
        /// The index as written.
        found: String,
        /// What it should name.
        what: &'static str,
        /// Which indices there are.
        have: String,
    },
    /// More vertices, faces or edges than any bender could use.
    #[error("{file}{place}: more than {limit} {what}")]
    TooMany {
        file: String,
        place: Location,
        what: &'static str,
        /// How many are read at most.
        limit: usize,
    },
    /// The file announces more than it holds.
    #[error("{file}{place}: {announced}, but {available}: the file is cut off or damaged")]
    Truncated { file: String, place: Location, announced: String, available: String },
    /// The file is well formed and holds nothing of use.
    #[error("{file}: no {expected} in it{but}")]
    Empty {
        file: String,
        /// What was looked for.
        expected: &'static str,
        /// What was found instead, in brackets.
        but: String,
    },
    /// A position or an edge that no wireframe can have.
    #[error("{file}{place}: {error}")]
    Wireframe { file: String, place: Location, error: WireframeError },
    /// A mesh that no stencil can have.
    #[error("{file}: {error}")]
    Stencil { file: String, error: StencilError },
    /// A bend whose straight parts do not meet, in a table of tangent lengths; or one beyond half a turn, in any program.
    #[error("{file}{place}: a bend of {bend_deg:.3}° has no corner, {}", if bend_deg.abs() > MOST_BEND_DEG { "it goes beyond half a turn" } else { "its straight parts are parallel" })]
    NoCorner { file: String, place: Location, bend_deg: f64 },
    /// A scale that is not a positive number.
    #[error("the scale is {scale}: it must be a number greater than 0")]
    Scale { scale: f64 },
    /// A tolerance that no curve can be followed to.
    #[error("the tolerance is {}: it must be {} or more", Mm(*tolerance_mm), Mm(super::options::MIN_TOLERANCE_MM))]
    Tolerance { tolerance_mm: f64 },
    /// Layers are asked of a format that has none.
    #[error("{file}: a file of format {format} has no layers")]
    NoLayers { file: String, format: super::Format },
    /// A layer is asked for that the file does not have.
    #[error("{file}: there is no layer {name}: its layers are {have}")]
    NoSuchLayer {
        file: String,
        /// What was asked for, shortened.
        name: String,
        /// The layers that there are, shortened.
        have: String,
    },
    /// A block, an object or an element that holds itself.
    #[error("{file}{place}: {what} {name} holds itself")]
    Loop {
        file: String,
        place: Location,
        /// Of which kind it is.
        what: &'static str,
        /// Its name, shortened.
        name: String,
    },
    /// Parts within parts, deeper than any program nests them.
    #[error("{file}{place}: {what} more than {limit} deep")]
    TooDeep {
        file: String,
        place: Location,
        /// What is nested.
        what: &'static str,
        /// How deep it is read at most.
        limit: usize,
    },
    /// Geometry in other files that cannot be read.
    #[error("{file}: the geometry is in other files that cannot be read: {missing}")]
    Elsewhere {
        file: String,
        /// The other files, shortened, and why not.
        missing: String,
        /// The file was opened from its folder, so that others can lie beside it.
        from_folder: bool,
    },
    /// Geometry in a way that is not read.
    #[error("{file}{place}: {what} is not read")]
    Unsupported { file: String, place: Location, what: String, remedy: Box<ErrorRemedy> },
    /// A project document that cannot be opened.
    #[error(transparent)]
    Document(#[from] DocumentError),
    /// A parser refused what passed all checks before it.
    #[error("{file}: {library} cannot read it: {message}")]
    Library {
        file: String,
        /// The parser.
        library: &'static str,
        message: String,
    },
}

impl ReadError {
    /// A name for the kind of error that does not change with its wording.
    #[must_use]
    pub fn code(&self) -> ErrorCode {
        match self {
            Self::Io { .. } | Self::Folder { .. } => ErrorCode::ReadIo,
            Self::TooLarge { .. } => ErrorCode::ReadTooLarge,
            Self::UnknownFormat { .. } | Self::GCode { .. } | Self::Order { .. } => {
                ErrorCode::ReadUnknownFormat
            }
            Self::Syntax { .. } => ErrorCode::ReadSyntax,
            Self::Number { .. } => ErrorCode::ReadNumber,
            Self::Index { .. } => ErrorCode::ReadIndex,
            Self::TooMany { .. } => ErrorCode::ReadTooMany,
            Self::Truncated { .. } => ErrorCode::ReadTruncated,
            Self::Empty { .. } | Self::EmptyFile { .. } => ErrorCode::ReadEmpty,
            Self::Wireframe { .. } => ErrorCode::ReadWireframe,
            Self::Stencil { .. } => ErrorCode::ReadStencil,
            Self::NoCorner { .. } => ErrorCode::ReadNoCorner,
            Self::Scale { .. } => ErrorCode::ReadScale,
            Self::Tolerance { .. } => ErrorCode::ReadTolerance,
            Self::NoLayers { .. } => ErrorCode::ReadNoLayers,
            Self::NoSuchLayer { .. } => ErrorCode::ReadNoSuchLayer,
            Self::Loop { .. } => ErrorCode::ReadLoop,
            Self::TooDeep { .. } => ErrorCode::ReadTooDeep,
            Self::Elsewhere { .. } => ErrorCode::ReadElsewhere,
            Self::Unsupported { .. } => ErrorCode::ReadUnsupported,
            Self::Document(error) => error.code(),
            Self::Library { .. } => ErrorCode::ReadLibrary,
        }
    }

    /// What can be done about it.
    #[must_use]
    pub fn remedies(&self) -> Vec<ErrorRemedy> {
        vec![match self {
            Self::Io { .. } => ErrorRemedy::CheckReadable,
            Self::Folder { .. } => ErrorRemedy::ChooseOtherFile,
            Self::TooLarge { .. } | Self::TooMany { .. } => ErrorRemedy::SimplifyModel,
            Self::UnknownFormat { .. } => ErrorRemedy::ChooseFileFormat,
            Self::Syntax { remedy, .. } | Self::Unsupported { remedy, .. } => (**remedy).clone(),
            Self::Number { .. } | Self::Index { .. } => ErrorRemedy::CorrectFile,
            Self::Truncated { .. } | Self::Library { .. } => ErrorRemedy::ExportAgain,
            Self::Empty { .. } | Self::EmptyFile { .. } => ErrorRemedy::CheckRightFile,
            Self::GCode { .. } | Self::Order { .. } => ErrorRemedy::OpenModel,
            Self::Wireframe { .. } => ErrorRemedy::CheckScale,
            Self::Stencil { .. } => ErrorRemedy::RepairMesh,
            Self::NoCorner { .. } => ErrorRemedy::SplitBend,
            Self::Scale { .. } => ErrorRemedy::CorrectInput { input: InputName::Scale },
            Self::Tolerance { .. } => ErrorRemedy::CorrectInput { input: InputName::Tolerance },
            Self::NoLayers { .. } => ErrorRemedy::LeaveOutLayers,
            Self::NoSuchLayer { .. } => ErrorRemedy::CorrectInput { input: InputName::Layers },
            Self::Loop { .. } | Self::TooDeep { .. } => ErrorRemedy::ExportResolved,
            Self::Elsewhere { from_folder, .. } => {
                let beside =
                    if *from_folder { ErrorRemedy::PutFilesBeside } else { ErrorRemedy::OpenFromFolder };
                return vec![beside, ErrorRemedy::ExportAs { form: ".glb".to_owned() }];
            }
            Self::Document(error) => return error.remedies(),
        }]
    }

    /// The line of the file that is wrong, from 1, where there is one.
    #[must_use]
    pub fn line(&self) -> Option<usize> {
        let place = match self {
            Self::Syntax { place, .. }
            | Self::Number { place, .. }
            | Self::Index { place, .. }
            | Self::TooMany { place, .. }
            | Self::Truncated { place, .. }
            | Self::Wireframe { place, .. }
            | Self::NoCorner { place, .. }
            | Self::Loop { place, .. }
            | Self::TooDeep { place, .. }
            | Self::Unsupported { place, .. } => place,
            Self::Document(error) => return error.line(),
            _ => return None,
        };
        if let Location::Line(line) = place { Some(*line) } else { None }
    }
}
