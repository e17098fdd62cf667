//! Why a file cannot be read: which file, where in it, what is there, what should be, what to do.

use std::fmt;

use wirebend_core::mesh::StencilError;
use wirebend_core::wireframe::WireframeError;

use crate::document::DocumentError;

/// Where in a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Place {
    /// A line of text, from 1.
    Line(usize),
    /// An offset in bytes, from 0.
    Byte(usize),
    /// An entry of a list, as its name and its index from 0: "node 3".
    Item(&'static str, usize),
    /// The file as a whole.
    File,
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Line(line) => write!(f, ", line {line}"),
            Self::Byte(offset) => write!(f, ", byte {offset}"),
            Self::Item(what, index) => write!(f, ", {what} {index}"),
            Self::File => Ok(()),
        }
    }
}

/// Why a file cannot be read.
#[derive(Debug, thiserror::Error)]
pub enum ReadError {
    /// The operating system refused.
    #[error("{file}: {error}; check that the file exists and may be read")]
    Io {
        /// The file.
        file: String,
        /// What the system says.
        error: std::io::Error,
    },
    /// The file is larger than any sensible one of its format.
    #[error("{file} has {bytes} bytes, the limit is {limit}; simplify the model or export less of it")]
    TooLarge {
        /// The file.
        file: String,
        /// Its size.
        bytes: u64,
        /// The largest that is read.
        limit: u64,
    },
    /// Neither name nor content tells the format.
    #[error("{file}: this is none of the known formats ({known}); name the format or export one of these", known = super::format::known())]
    UnknownFormat {
        /// The file.
        file: String,
    },
    /// Something else than what the format has there.
    #[error("{file}{place}: found {found}, expected {expected}; {help}")]
    Syntax {
        /// The file.
        file: String,
        /// Where.
        place: Place,
        /// What is there, shortened.
        found: String,
        /// What should be there.
        expected: Box<str>,
        /// What to do.
        help: &'static str,
    },
    /// A number that is not one, or not finite.
    #[error("{file}{place}: {found} is not a {expected}; correct the line or export the file again")]
    Number {
        /// The file.
        file: String,
        /// Where.
        place: Place,
        /// What is there, shortened.
        found: String,
        /// The kind of number.
        expected: &'static str,
    },
    /// An index that names nothing.
    #[error("{file}{place}: {found} names no {what}: {have}; correct the index or export the file again")]
    Index {
        /// The file.
        file: String,
        /// Where.
        place: Place,
        /// The index as written.
        found: String,
        /// What it should name.
        what: &'static str,
        /// Which indices there are.
        have: String,
    },
    /// More vertices, faces or edges than any bender could use.
    #[error("{file}{place}: more than {limit} {what}; simplify the model before importing it")]
    TooMany {
        /// The file.
        file: String,
        /// Where.
        place: Place,
        /// Of what.
        what: &'static str,
        /// How many are read at most.
        limit: usize,
    },
    /// The file announces more than it holds.
    #[error(
        "{file}{place}: {announced}, but {available}; the file is cut off or damaged: export or download it again"
    )]
    Truncated {
        /// The file.
        file: String,
        /// Where.
        place: Place,
        /// What it announces.
        announced: String,
        /// What there is.
        available: String,
    },
    /// The file is well formed and holds nothing of use.
    #[error("{file}: no {expected} in it{but}; check that the right file was exported, with its geometry")]
    Empty {
        /// The file.
        file: String,
        /// What was looked for.
        expected: &'static str,
        /// What was found instead, in brackets.
        but: String,
    },
    /// A position or an edge that no wireframe can have.
    #[error("{file}{place}: {error}; check units and scale")]
    Wireframe {
        /// The file.
        file: String,
        /// Where.
        place: Place,
        /// What is wrong.
        error: WireframeError,
    },
    /// A mesh that no stencil can have.
    #[error("{file}: {error}; repair the mesh and export it again")]
    Stencil {
        /// The file.
        file: String,
        /// What is wrong.
        error: StencilError,
    },
    /// A bend whose straight parts do not meet, in a table of tangent lengths.
    #[error(
        "{file}{place}: a bend of {bend_deg:.3}° has no corner, its straight parts are parallel; write it as two bends"
    )]
    NoCorner {
        /// The file.
        file: String,
        /// Where.
        place: Place,
        /// The bend.
        bend_deg: f64,
    },
    /// A scale that is not a positive number.
    #[error("a scale of {scale} makes no sense; it must be a number greater than 0")]
    Scale {
        /// The scale.
        scale: f64,
    },
    /// A tolerance that no curve can be followed to.
    #[error("a tolerance of {tolerance_mm} mm makes no sense; it must be {least} mm or more", least = super::options::LEAST_TOLERANCE_MM)]
    Tolerance {
        /// The tolerance.
        tolerance_mm: f64,
    },
    /// Layers are asked of a format that has none.
    #[error("{file}: a file of format {format} has no layers; leave the layers away")]
    NoLayers {
        /// The file.
        file: String,
        /// Its format.
        format: super::Format,
    },
    /// A layer is asked for that the file does not have.
    #[error("{file}: there is no layer {name}; its layers are {have}")]
    NoSuchLayer {
        /// The file.
        file: String,
        /// What was asked for, shortened.
        name: String,
        /// The layers that there are, shortened.
        have: String,
    },
    /// A block, an object or an element that holds itself.
    #[error("{file}{place}: {what} {name} holds itself; export the file again, with its parts resolved")]
    Loop {
        /// The file.
        file: String,
        /// Where.
        place: Place,
        /// Of which kind it is.
        what: &'static str,
        /// Its name, shortened.
        name: String,
    },
    /// Parts within parts, deeper than any program nests them.
    #[error("{file}{place}: {what} more than {limit} deep; export the file again, with its parts resolved")]
    TooDeep {
        /// The file.
        file: String,
        /// Where.
        place: Place,
        /// What is nested.
        what: &'static str,
        /// How deep it is read at most.
        limit: usize,
    },
    /// Geometry in other files that cannot be read.
    #[error("{file}: the geometry is in other files that cannot be read: {missing}; {help}")]
    Elsewhere {
        /// The file.
        file: String,
        /// The other files, shortened, and why not.
        missing: String,
        /// What to do.
        help: &'static str,
    },
    /// Geometry in a way that is not read.
    #[error("{file}{place}: {what} is not read; {help}")]
    Unsupported {
        /// The file.
        file: String,
        /// Where.
        place: Place,
        /// What it is.
        what: String,
        /// What to do.
        help: &'static str,
    },
    /// A project document that cannot be opened.
    #[error(transparent)]
    Document(#[from] DocumentError),
    /// A parser refused what passed all checks before it.
    #[error("{file}: {library} cannot read it ({message}); export it again, as text if there is a choice")]
    Library {
        /// The file.
        file: String,
        /// The parser.
        library: &'static str,
        /// What it says.
        message: String,
    },
}

impl ReadError {
    /// A name for the kind of error that does not change with its wording.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::Io { .. } => "read-io",
            Self::TooLarge { .. } => "read-too-large",
            Self::UnknownFormat { .. } => "read-unknown-format",
            Self::Syntax { .. } => "read-syntax",
            Self::Number { .. } => "read-number",
            Self::Index { .. } => "read-index",
            Self::TooMany { .. } => "read-too-many",
            Self::Truncated { .. } => "read-truncated",
            Self::Empty { .. } => "read-empty",
            Self::Wireframe { .. } => "read-wireframe",
            Self::Stencil { .. } => "read-stencil",
            Self::NoCorner { .. } => "read-no-corner",
            Self::Scale { .. } => "read-scale",
            Self::Tolerance { .. } => "read-tolerance",
            Self::NoLayers { .. } => "read-no-layers",
            Self::NoSuchLayer { .. } => "read-no-such-layer",
            Self::Loop { .. } => "read-loop",
            Self::TooDeep { .. } => "read-too-deep",
            Self::Elsewhere { .. } => "read-elsewhere",
            Self::Unsupported { .. } => "read-unsupported",
            Self::Document(error) => error.code(),
            Self::Library { .. } => "read-library",
        }
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
        if let Place::Line(line) = place { Some(*line) } else { None }
    }
}
