//! Readers: bytes in, wireframe, stencil or program out.
//!
//! One file a format. No reader opens a file, panics on any bytes or believes a count that a file
//! announces. Errors name the file, the line, what was found and what to do.

mod assembly;
mod beside;
mod curves;
mod detect;
mod drawing;
mod dxf;
mod error;
mod format;
pub mod frame;
mod gcode;
mod gltf;
mod json;
mod note;
mod obj;
mod options;
mod outline;
mod ply;
mod program;
mod pwf;
mod stl;
mod stroke;
mod svg;
mod table;
mod text;
mod threemf;

use std::borrow::Cow;
use std::io::Read;
use std::path::Path;

use wirebend_core::mesh::Stencil;
use wirebend_core::wireframe::Wireframe;

pub use curves::{CurveFacts, CurveRadius};
pub use detect::detect;
pub use error::{Location, ReadError};
pub use format::{Format, UnknownName};
pub use note::{Note, NoteKind};
pub use options::{DEFAULT_TOLERANCE_MM, Handedness, LengthUnit, ReadOptions};
pub use program::{ImportedProgram, PathWireframe, wireframe_of_path};
pub use table::pin_table::{PinPair, pin_table};
pub(crate) use table::sheet::{COLUMNS as SHEET_COLUMNS, EXPLANATIONS as SHEET_EXPLANATIONS};
pub use table::sheet::{MeasuringSheet, SheetQuantity, SheetRow};

use crate::document::Document;
pub use crate::encoding::decode;
use crate::encoding::utf8;
use text::Source;

/// What a file held. Positions are millimetres in the frame of the file.
#[derive(Debug, Clone)]
pub struct Imported {
    /// What it was read as.
    pub format: Format,
    /// The struts. Vertex k of the file is `VertexId(k)`; empty for a file of faces only.
    pub wireframe: Wireframe,
    /// The surface, if the file has faces.
    pub stencil: Option<Stencil>,
    /// The program, if the file is one.
    pub program: Option<ImportedProgram>,
    /// What a file of a frame says beside its struts.
    pub frame: Option<Box<frame::FrameFile>>,
    /// The rest of a project document, if the file is one.
    pub document: Option<Box<Document>>,
    /// The layers of a drawing, hidden ones included, as [`ReadOptions::layers`] takes them.
    pub layers: Vec<String>,
    /// What became of the curves of a drawing; none without [`ReadOptions::shortest_edge`].
    pub curves: Option<CurveFacts>,
    /// What was merged, ignored or assumed.
    pub notes: Vec<Note>,
}

/// Reads a file's bytes; `name` is for errors and, without `format`, for [`detect`].
///
/// # Errors
/// [`ReadError`] says where and why.
pub fn read(
    bytes: &[u8],
    name: &str,
    format: Option<Format>,
    options: &ReadOptions,
) -> Result<Imported, ReadError> {
    if !(options.scale > 0.0 && options.scale.is_finite()) {
        return Err(ReadError::Scale { scale: options.scale });
    }
    if options.tolerance.mm() < options::MIN_TOLERANCE_MM {
        return Err(ReadError::Tolerance { tolerance_mm: options.tolerance.mm() });
    }
    let source = Source { name };
    let format = format.map_or_else(|| detect(name, bytes), Ok)?;
    // Of a project its own reader says what should be in it.
    if format != Format::Wirebend && detect::is_blank(bytes) {
        return Err(ReadError::EmptyFile { file: name.to_owned() });
    }
    if detect::is_gcode(bytes) {
        return Err(ReadError::GCode { file: name.to_owned() });
    }
    if let Some((found, remedy)) = detect::foreign(bytes) {
        let (file, found, expected) = (name.to_owned(), found.to_owned(), format.title().into());
        return Err(ReadError::Syntax {
            file,
            place: Location::File,
            found,
            expected,
            remedy: Box::new(remedy),
        });
    }
    if !options.layers.is_empty() && !matches!(format, Format::Dxf | Format::Svg) {
        return Err(ReadError::NoLayers { file: name.to_owned(), format });
    }
    // Any bytes may stand in the head of a binary STL.
    let text = if stl::is_binary(bytes) { Cow::Borrowed(bytes) } else { utf8(bytes) };
    let bytes = &*text;
    read_as(bytes, source, format, options)
}

fn read_as(
    bytes: &[u8],
    source: Source<'_>,
    format: Format,
    options: &ReadOptions,
) -> Result<Imported, ReadError> {
    let name = source.name;
    match format {
        Format::Obj => obj::read(bytes, source, options),
        Format::Stl => stl::read(bytes, source, options),
        Format::Ply => ply::read(bytes, source, options),
        Format::ThreeMf => threemf::read(bytes, source, options),
        Format::Gltf => gltf::read(bytes, source, options),
        Format::Dxf => dxf::read(bytes, source, options),
        Format::Svg => svg::read(bytes, source, options),
        Format::Xyz => table::xyz::read(bytes, source, options),
        Format::Assembly => assembly::read(bytes, source, options),
        Format::Conmech => frame::read_conmech(bytes, source, options),
        Format::Pwf => pwf::read(bytes, source, options),
        Format::Kit => program::kit::read(bytes, source, options),
        Format::Pensa => program::pensa::read(bytes, source, options),
        Format::Lra => program::lra::read(bytes, source, options),
        Format::Moves => program::moves::read(bytes, source, options),
        Format::Wirebend => {
            let document = Document::open(bytes, name)?;
            let stencil: Stencil = document.surfaces_in_place().collect();
            let stencil = Some(stencil).filter(|stencil| !stencil.faces().is_empty());
            let wireframe = document.wireframe.clone();
            Ok(Imported {
                format: Format::Wirebend,
                wireframe,
                stencil,
                program: None,
                frame: None,
                document: Some(Box::new(document)),
                layers: Vec::new(),
                curves: None,
                notes: Vec::new(),
            })
        }
    }
}

/// The bytes of a file, up to 64 MiB; up to 512 MiB for the mesh formats STL, PLY, 3MF and glTF.
///
/// # Errors
/// [`ReadError::Io`], [`ReadError::Folder`] and [`ReadError::TooLarge`].
pub fn read_file(path: &Path) -> Result<Vec<u8>, ReadError> {
    const MIB: u64 = 1 << 20;
    let extension = path.extension().and_then(|extension| extension.to_str()).unwrap_or_default();
    let mesh = ["stl", "ply", "3mf", "glb", "gltf"].iter().any(|mesh| extension.eq_ignore_ascii_case(mesh));
    read_up_to(path, if mesh { 512 * MIB } else { 64 * MIB })
}

/// The bytes of a file, up to a limit.
fn read_up_to(path: &Path, limit: u64) -> Result<Vec<u8>, ReadError> {
    let name = path.display().to_string();
    let io = |error| ReadError::Io { file: name.clone(), error };
    let file = std::fs::File::open(path).map_err(io)?;
    let metadata = file.metadata().map_err(io)?;
    if metadata.is_dir() {
        return Err(ReadError::Folder { file: name });
    }
    let bytes = metadata.len();
    if bytes > limit {
        return Err(ReadError::TooLarge { file: name, bytes, limit });
    }
    let mut content = Vec::new();
    // A file may grow while it is read, and a pipe has no size.
    file.take(limit + 1).read_to_end(&mut content).map_err(io)?;
    if content.len() as u64 > limit {
        return Err(ReadError::TooLarge { file: name, bytes: content.len() as u64, limit });
    }
    Ok(content)
}
