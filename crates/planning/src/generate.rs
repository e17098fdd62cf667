//! `generate`: designs from a few figures.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_core::units::Length;
use wirebend_core::wireframe::{TrussError, regular_depth, regular_strut, tetrahedral_truss};
use wirebend_files::document::Document;

use crate::import::{document_misnamed, size_mm, wireframe_obj};
use crate::output::Output;
use crate::report::NoteReport;
use crate::{Installation, PlanningError, Progress};

#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct GenerateRequest {
    pub shape: GeneratedShape,
    /// Where the document goes; absent, it is returned. A file whose name ends with `.obj` gets the wireframe alone.
    pub output: Option<Output>,
}

/// What is generated.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(tag = "shape", rename_all = "kebab-case")]
pub enum GeneratedShape {
    /// A tetrahedral truss: two hexagonal layers of triangles, joined by diagonals.
    Truss {
        /// Rings around the middle triangle, 0 to 100: 2N + 1 struts across.
        rings: u32,
        /// Length of the struts of both layers, mm; absent, that at which all struts are of one length.
        #[serde(default)]
        strut_mm: Option<f64>,
        /// Distance of the layers, mm; absent, that at which all struts are of one length. It takes one of the two.
        #[serde(default)]
        depth_mm: Option<f64>,
    },
}

#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct GenerateResponse {
    /// Vertices of the wireframe.
    pub vertices: usize,
    /// Edges of the wireframe.
    pub edges: usize,
    /// Length of all edges, in mm.
    pub length_mm: f64,
    /// Size of the wireframe along x, y and z, in mm.
    pub size_mm: [f64; 3],
    /// Length of the shortest and of the longest edge, in mm.
    pub strut_mm: [f64; 2],
    /// What a person should know.
    pub notes: Vec<NoteReport>,
    /// The file that was written.
    pub output: Option<PathBuf>,
    /// The document, where it was not written to a file.
    #[serde(skip)]
    pub contents: Vec<u8>,
}

pub fn generate(
    _app: &Installation,
    request: &GenerateRequest,
    progress: &dyn Progress,
) -> Result<GenerateResponse, PlanningError> {
    request.output.as_ref().map_or(Ok(()), Output::check)?;
    let GeneratedShape::Truss { rings, strut_mm, depth_mm } = request.shape;
    progress.stage("generating");
    let strut = strut_mm.map(|mm| length("the length of a strut", mm)).transpose()?;
    let depth = depth_mm.map(|mm| length("the depth", mm)).transpose()?;
    let (strut, depth) = match (strut, depth) {
        (Some(strut), Some(depth)) => (strut, depth),
        (Some(strut), None) => (strut, regular_depth(strut)),
        (None, Some(depth)) => (regular_strut(depth), depth),
        (None, None) => {
            return Err(value(
                "the size of the truss",
                "nothing".to_owned(),
                "the length of a strut, the depth, or both",
            ));
        }
    };
    let document = Document::new(tetrahedral_truss(rings, strut, depth).map_err(refusal)?);
    progress.stage("writing");
    let as_obj = request.output.as_ref().is_some_and(Output::is_obj);
    let contents = if as_obj { wireframe_obj(&document)? } else { document.to_bytes()? };
    let output = request.output.as_ref().map(|output| output.save(&contents)).transpose()?;
    let wireframe = &document.wireframe;
    let lengths = wireframe.edges().map(|(id, _)| wireframe.edge_length(id).mm());
    let strut_mm = lengths.fold([f64::INFINITY, 0.0], |[least, most], mm| [mm.min(least), mm.max(most)]);
    Ok(GenerateResponse {
        vertices: wireframe.vertex_count(),
        edges: wireframe.edge_count(),
        length_mm: wireframe.total_length().mm(),
        size_mm: size_mm(wireframe),
        strut_mm,
        notes: document_misnamed(request.output.as_ref()).into_iter().collect(),
        contents: if output.is_some() { Vec::new() } else { contents },
        output,
    })
}

/// As `core` has it.
const RINGS: &str = "0 to 100";

fn length(name: &'static str, mm: f64) -> Result<Length, PlanningError> {
    let length = Length::from_mm(mm).ok().filter(|length| *length > Length::ZERO);
    length.ok_or_else(|| value(name, mm.to_string(), "a length in mm above 0"))
}

fn refusal(error: TrussError) -> PlanningError {
    match error {
        TrussError::Rings(rings) => value("the number of rings", rings.to_string(), RINGS),
        TrussError::Strut(length) => value("the length of a strut", length.to_string(), "more than 0"),
        TrussError::Depth(length) => value("the depth", length.to_string(), "more than 0"),
        TrussError::Wireframe(error) => {
            value("the truss", error.to_string(), "a truss that fits within ±1 000 000 mm")
        }
    }
}

fn value(name: &'static str, value: String, expected: &'static str) -> PlanningError {
    PlanningError::Value { input: None, name, value, expected }
}
