//! `import`: any file that can be read becomes a `.wirebend` document, or an OBJ of its wireframe.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_core::wireframe::Wireframe;
use wirebend_error::{ErrorRemedy, InputName};
use wirebend_files::document::{Document, StencilSource};

use crate::choices::PlanChoices;
use crate::design::{DesignInput, Opened};
use crate::error::{edges_of_faces, input_words};
use crate::misnamed;
use crate::output::Output;
use crate::program::Known;
use crate::report::NoteReport;
use crate::{Installation, PlanningError, Progress};

#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct ImportRequest {
    pub design: DesignInput,
    /// The machine that a compensated program was written for.
    #[serde(default)]
    pub machine: Option<String>,
    /// The wire that it was written for; absent, the one that the machine's profile names.
    #[serde(default)]
    pub material: Option<String>,
    /// Where the document goes; absent, it is returned. A file whose name ends with `.obj` gets the wireframe alone.
    pub output: Option<Output>,
}

#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct ImportResponse {
    /// The format that was read.
    pub format: String,
    /// Vertices of the wireframe.
    pub vertices: usize,
    /// Edges of the wireframe.
    pub edges: usize,
    /// Components of the wireframe, isolated vertices included.
    pub components: usize,
    /// Length of all edges, in mm.
    pub length_mm: f64,
    /// Size of the wireframe along x, y and z, in mm.
    pub size_mm: [f64; 3],
    /// Vertices and faces of the stencil; null without one.
    pub stencil: Option<StencilReport>,
    /// What was merged, ignored or assumed.
    pub notes: Vec<NoteReport>,
    /// The file that was written.
    pub output: Option<PathBuf>,
    /// The document, where it was not written to a file.
    #[serde(skip)]
    pub contents: Vec<u8>,
}

/// How large a stencil is.
#[derive(Debug, Clone, Copy, Serialize, JsonSchema)]
pub struct StencilReport {
    pub vertices: usize,
    pub faces: usize,
}

impl StencilReport {
    /// Of all that are in a document.
    fn of(document: &Document) -> Option<Self> {
        let surfaces = || document.surfaces.values().filter_map(StencilSource::embedded);
        surfaces().next()?;
        Some(Self {
            vertices: surfaces().map(|surface| surface.vertices().len()).sum(),
            faces: surfaces().map(|surface| surface.faces().len()).sum(),
        })
    }
}

pub fn import(
    app: &Installation,
    request: &ImportRequest,
    progress: &dyn Progress,
) -> Result<ImportResponse, PlanningError> {
    request.output.as_ref().map_or(Ok(()), Output::check)?;
    let ImportRequest { machine, material, .. } = request;
    let choices =
        PlanChoices { machine: machine.clone(), material: material.clone(), ..PlanChoices::default() };
    let opened = request.design.open_with(app, &choices, progress)?;
    let without_effect = without_effect(app, request, &opened)?;
    let opened = app.designed(opened, &choices)?;
    progress.stage("writing");
    let as_obj = request.output.as_ref().is_some_and(Output::is_obj);
    let contents = if as_obj { wireframe_obj(&opened.document)? } else { opened.document.to_bytes()? };
    let wireframe = &opened.document.wireframe;
    let mut notes = opened.notes;
    notes.extend(without_effect);
    if wireframe.edge_count() == 0 && !opened.document.stencils.is_empty() {
        notes.push(NoteReport {
            code: "only-stencil".into(),
            count: 1,
            message: "there is a surface and no lines".to_owned(),
            remedies: vec![edges_of_faces(opened.format)],
        });
    }
    notes.extend(document_misnamed(request.output.as_ref()));
    let output = request.output.as_ref().map(|output| output.save(&contents)).transpose()?;
    Ok(ImportResponse {
        format: opened.format.title().to_owned(),
        vertices: wireframe.vertex_count(),
        edges: wireframe.edge_count(),
        components: wireframe.components().len(),
        length_mm: wireframe.total_length().mm(),
        size_mm: size_mm(wireframe),
        stencil: StencilReport::of(&opened.document),
        notes,
        contents: if output.is_some() { Vec::new() } else { contents },
        output,
    })
}

/// A machine and a material of which nothing is taken: only a compensated program is turned back, and only edges that are as short as
/// a machine makes them are read for one.
fn without_effect(
    app: &Installation,
    request: &ImportRequest,
    opened: &Opened,
) -> Result<Option<NoteReport>, PlanningError> {
    let is_told = opened.program.as_ref().is_some_and(|program| program.known == Known::Told);
    if is_told || request.design.shortest_edge.is_some() {
        return Ok(None);
    }
    let (machine, material) = (request.machine.as_deref(), request.material.as_deref());
    machine.map(|id| app.library.machine(id)).transpose()?;
    material.map(|id| app.library.material(id)).transpose()?;
    let given = [machine.map(|_| InputName::Machine), material.map(|_| InputName::Material)];
    let inputs: Vec<InputName> = given.into_iter().flatten().collect();
    Ok((!inputs.is_empty()).then(|| NoteReport {
        code: "without-effect".into(),
        count: inputs.len(),
        message: format!("what is read is the design itself: {} had no effect", input_words(&inputs)),
        remedies: vec![ErrorRemedy::LeaveOut { inputs }],
    }))
}

/// What goes to the file of a design is a wireframe alone where its name says so, and else the document.
pub(crate) fn document_misnamed(output: Option<&Output>) -> Option<NoteReport> {
    misnamed::PROJECT.misnamed(output.filter(|output| !output.is_obj()))
}

/// How large a wireframe is along x, y and z; nothing of an empty one.
pub(crate) fn size_mm(wireframe: &Wireframe) -> [f64; 3] {
    let mut corners = [[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]];
    for (_, vertex) in wireframe.vertices() {
        for (axis, &at) in vertex.position.iter().enumerate() {
            corners[0][axis] = corners[0][axis].min(at);
            corners[1][axis] = corners[1][axis].max(at);
        }
    }
    let [low, high] = corners;
    std::array::from_fn(|axis| (high[axis] - low[axis]).max(0.0))
}

/// The wireframe alone, for another program.
pub fn wireframe_obj(document: &Document) -> Result<Vec<u8>, PlanningError> {
    if document.wireframe.vertex_count() == 0 {
        let expected = "a vertex or more: an OBJ of no wireframe cannot be opened";
        return Err(PlanningError::Value {
            input: None,
            name: "the wireframe",
            value: "empty".to_owned(),
            expected,
        });
    }
    Ok(wirebend_files::write::wireframe_obj(&document.wireframe).into_bytes())
}
