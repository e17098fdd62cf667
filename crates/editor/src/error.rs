//! Why something cannot be done to the open design.

use std::io;
use std::path::PathBuf;

use wirebend_core::mesh::PlacementError;
use wirebend_core::units::Mm;
use wirebend_core::wireframe::EditError;
use wirebend_error::{ErrorCode, ErrorRemedy};
use wirebend_files::document::{DocumentError, StaleChange};
use wirebend_files::read::ReadError;
use wirebend_journal::LogError;
use wirebend_planning::{ErrorKind, PlanningError, StencilFileError, text};
use wirebend_profile::ProfileError;

/// Why something cannot be done to the open design, which is as it was.
#[derive(Debug, thiserror::Error)]
pub enum EditorError {
    /// The edit makes no sense here.
    #[error("{}", text::error::edit(.0))]
    Edit(#[from] EditError),
    /// A mirror without a direction.
    #[error("the normal of the plane is 0 0 0, which has no direction")]
    Normal,
    /// A tolerance that is none.
    #[error("{} is no tolerance: it has to be 0 or more", Mm(*.0))]
    Tolerance(f64),
    /// A shortest edge that is none.
    #[error("{} is no shortest edge: it has to be 0 or more", Mm(*.0))]
    LeastEdge(f64),
    /// A step that is no angle.
    #[error("{0}° is no step along an arc: it has to be more than 0° and at most 180°")]
    ArcStep(f64),
    /// A turn that is no angle.
    #[error("{0}° is no angle to turn by")]
    Turn(f64),
    /// A matrix that is no transform.
    #[error("this matrix is no transform: its numbers have to be finite, and its last row 0 0 0 1")]
    Matrix,
    /// An edge that is to be laid twice is not there.
    #[error("there is no edge {0} to lay twice")]
    NoEdge(u32),
    /// The wire is to begin where nothing is.
    #[error("there is no vertex {0} for the wire to begin at")]
    NoVertex(u32),
    /// An edge that is to become a construction line is not there.
    #[error("there is no edge {0} to make a construction line of")]
    NoConstructionEdge(u32),
    /// A construction line is not there.
    #[error("there is no construction line {line} in this design, counted from 0: it has {count}")]
    NoConstructionLine { line: u32, count: usize },
    /// A construction line without a second place to go to.
    #[error("a construction line goes through {0} places; it has to be 2 or more")]
    ConstructionPlaces(usize),
    /// A construction line that goes nowhere, counted from 1 in its strand.
    #[error("construction line {0} of this strand has no length: its ends have to be apart")]
    ConstructionLength(usize),
    /// A stencil that is to be changed is not there.
    #[error("there is no stencil {0} in this design")]
    NoStencil(u32),
    /// A part that is to be named is not there.
    #[error("there is no edge {0}, and so no part that it belongs to")]
    NoPart(u32),
    /// A stencil that would lie nowhere.
    #[error(transparent)]
    Placement(#[from] PlacementError),
    /// The machine is to wait where nothing is.
    #[error("there is no vertex {0} for the machine to wait at")]
    NoPauseVertex(u32),
    /// A pause point at no pass.
    #[error("the wires come to a vertex for the first time at pass 1: there is no pass 0 to wait at")]
    PausePass,
    /// A pause point says nothing.
    #[error("a pause point needs a note: it says what to do there, such as \"turn the part\"")]
    PauseNote,
    /// No wire to bend.
    #[error("a design is bent from one wire at least, not from none")]
    NoWires,
    /// A change does not fit the design any more.
    #[error("the design has changed meanwhile: {0}")]
    Stale(#[from] StaleChange),
    /// The design in a journal cannot be opened or written.
    #[error(transparent)]
    Document(DocumentError),
    /// A design that was never saved is to be saved without a name.
    #[error("the design has no file yet")]
    NoFile,
    /// It cannot be read, or not be planned.
    #[error(transparent)]
    Planning(#[from] PlanningError),
    /// The journal that keeps unsaved changes.
    #[error("unsaved changes cannot be kept safe: {0}")]
    Log(#[from] LogError),
    /// A folder or a file of such journals.
    #[error("unsaved changes cannot be kept safe: {}: {cause}", folder.display())]
    Folder { folder: PathBuf, cause: io::Error },
    /// A journal makes no sense.
    #[error("line {line} of {} cannot be understood: {what}; the design cannot be restored from it", path.display())]
    Damaged {
        /// The journal.
        path: PathBuf,
        /// Which line, from 1.
        line: usize,
        what: String,
    },
    /// A journal of a later program.
    #[error("{} is of version {version}, this program knows {known}: the design cannot be restored from it", path.display())]
    Newer {
        /// The journal.
        path: PathBuf,
        version: u32,
        /// The latest that is known.
        known: u32,
    },
    /// A change cannot be written down.
    #[error("the change cannot be written down: {0}")]
    Unwritten(String),
}

/// What is no matter of the editor itself.
macro_rules! of_planning {
    ($($error:ty),*) => {$(
        impl From<$error> for EditorError {
            fn from(error: $error) -> Self {
                Self::Planning(error.into())
            }
        }
    )*};
}

of_planning!(DocumentError, ReadError, ProfileError, StencilFileError, serde_json::Error);

impl EditorError {
    /// The kind of error, which gives the exit status.
    #[must_use]
    pub fn kind(&self) -> ErrorKind {
        match self {
            Self::Planning(error) => error.kind(),
            _ => ErrorKind::Usage,
        }
    }

    /// A name that stays the same while the wording may change.
    #[must_use]
    pub fn code(&self) -> ErrorCode {
        match self {
            Self::Edit(_)
            | Self::Normal
            | Self::Tolerance(_)
            | Self::LeastEdge(_)
            | Self::ArcStep(_)
            | Self::Turn(_)
            | Self::NoWires
            | Self::PausePass
            | Self::PauseNote
            | Self::Placement(_)
            | Self::NoConstructionLine { .. }
            | Self::ConstructionPlaces(_)
            | Self::ConstructionLength(_)
            | Self::Matrix => ErrorCode::Edit,
            Self::NoStencil(_) => ErrorCode::NoStencil,
            Self::NoEdge(_) | Self::NoConstructionEdge(_) | Self::NoPart(_) => ErrorCode::NoEdge,
            Self::NoVertex(_) | Self::NoPauseVertex(_) => ErrorCode::NoVertex,
            Self::Stale(_) => ErrorCode::Stale,
            Self::Document(_) => ErrorCode::Document,
            Self::NoFile => ErrorCode::NoFile,
            Self::Planning(error) => error.code(),
            Self::Log(_) | Self::Folder { .. } | Self::Unwritten(_) => ErrorCode::NotKept,
            Self::Damaged { .. } => ErrorCode::JournalDamaged,
            Self::Newer { .. } => ErrorCode::JournalNewer,
        }
    }

    /// What can be done about it.
    #[must_use]
    pub fn remedies(&self) -> Vec<ErrorRemedy> {
        match self {
            Self::Planning(error) => error.remedies(),
            Self::Document(error) => error.remedies(),
            Self::NoFile | Self::Log(_) => vec![ErrorRemedy::SaveDesign],
            Self::Folder { .. } => vec![ErrorRemedy::CheckDisk, ErrorRemedy::SaveDesign],
            Self::Newer { .. } => vec![ErrorRemedy::UpdateProgram],
            Self::Edit(error) => of_edit(error),
            Self::Normal
            | Self::Tolerance(_)
            | Self::LeastEdge(_)
            | Self::ArcStep(_)
            | Self::Turn(_)
            | Self::Matrix
            | Self::NoEdge(_)
            | Self::NoConstructionEdge(_)
            | Self::NoConstructionLine { .. }
            | Self::ConstructionPlaces(_)
            | Self::ConstructionLength(_)
            | Self::NoStencil(_)
            | Self::NoPart(_)
            | Self::Placement(_)
            | Self::NoVertex(_)
            | Self::NoPauseVertex(_)
            | Self::PausePass
            | Self::PauseNote
            | Self::NoWires
            | Self::Stale(_)
            | Self::Damaged { .. }
            | Self::Unwritten(_) => Vec::new(),
        }
    }
}

/// What makes an edit possible.
fn of_edit(error: &EditError) -> Vec<ErrorRemedy> {
    match error {
        EditError::EdgeLength(_) | EditError::FilletRadius(_) | EditError::ShapeSize(_) => {
            vec![ErrorRemedy::EnterLength]
        }
        EditError::CornerAngle(_) => vec![ErrorRemedy::EnterAngle],
        EditError::NoCorner { .. } => vec![ErrorRemedy::SelectTwoEdges],
        EditError::NoDirection(_) => vec![ErrorRemedy::MoveEndsApart],
        EditError::HeldCorner(_) => vec![ErrorRemedy::FreeVertex],
        EditError::Fillet { nearest: Some(radius), .. } => {
            vec![ErrorRemedy::UseRadius { radius: text::shown(|| format!("{radius:.1}")) }]
        }
        EditError::Fillet { nearest: None, .. } => vec![ErrorRemedy::LengthenEdges],
        EditError::InLine(_) => vec![ErrorRemedy::MoveOutOfLine],
        EditError::InLoop(_) => vec![ErrorRemedy::MoveEndAlone],
        _ => Vec::new(),
    }
}

wirebend_error::reported!(wirebend_planning::text::shown => EditorError);
