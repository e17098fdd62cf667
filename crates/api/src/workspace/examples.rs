//! The examples that a newcomer opens first.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{DesignOpened, OpenExample, Workspace};
use crate::{ApiError, Editor, Input, NoProgress, Progress};
use wirebend_planning::design::DesignInput;

/// Asks for the examples.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct ExamplesRequest {}

#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct ExampleEntry {
    /// What [`OpenExample`] takes.
    pub id: String,
    pub name: String,
    /// What there is to see.
    pub description: String,
    /// Its lines for a small picture, mm.
    pub lines_mm: Vec<[[f64; 3]; 2]>,
}

#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct ExamplesResponse {
    /// Simple ones first.
    pub examples: Vec<ExampleEntry>,
}

struct Example {
    id: &'static str,
    name: &'static str,
    description: &'static str,
    file: &'static str,
    bytes: &'static [u8],
    face_edges: bool,
    stencil: bool,
}

macro_rules! examples {
    ($($id:literal, $name:literal, $file:literal, $face_edges:literal, $stencil:literal, $description:literal;)*) => {
        const EXAMPLES: &[Example] = &[$(Example {
            id: $id,
            name: $name,
            description: $description,
            file: $file,
            bytes: include_bytes!(concat!("../../../../examples/", $file)),
            face_edges: $face_edges,
            stencil: $stencil,
        },)*];
    };
}

examples! {
    "cube", "Cube", "cube-8-edges.obj", false, false, "Eight edges from one wire.";
    "house", "House", "house.obj", false, false, "A flat outline: the first thing to bend.";
    "phone-stand", "Phone stand", "phone-stand.obj", false, false, "Something to use on the same day.";
    "cup-holder", "Cup holder", "cup-holder.obj", false, false, "A ring for the cup, and a hook over the edge of a board.";
    "spring", "Spring", "spring.obj", false, false, "Many small bends, each with a turn.";
    "bunny", "Bunny", "bunny.obj", true, false, "Needs more than one wire (22 odd corners), until edges are doubled.";
    "teapot", "Teapot", "teapot.obj", true, false, "A large mesh as a wireframe.";
    "truss", "Truss", "truss-1.obj", false, false, "A structure of tetrahedra.";
    "bunny-stencil", "Bunny to trace", "bunny.obj", false, true, "A surface, on which you trace a wireframe of your own.";
}

impl Example {
    fn input(&self) -> DesignInput {
        let name = self.file.to_owned();
        let input = Input::Bytes { name, bytes: self.bytes.to_vec() };
        DesignInput { input, face_edges: self.face_edges, ..DesignInput::file(std::path::PathBuf::new()) }
    }

    fn lines_mm(&self) -> Result<Vec<[[f64; 3]; 2]>, ApiError> {
        // What is only a surface is drawn by the edges of its faces.
        let input = DesignInput { face_edges: self.face_edges || self.stencil, ..self.input() };
        let wireframe = input.open(&NoProgress)?.document.wireframe;
        let at = |id| Some(wireframe.vertex(id)?.position.coords.into());
        Ok(wireframe.edges().filter_map(|(_, edge)| Some([at(edge.a)?, at(edge.b)?])).collect())
    }
}

impl Workspace {
    pub(crate) fn examples(
        &self,
        _: &ExamplesRequest,
        _: &dyn Progress,
    ) -> Result<ExamplesResponse, ApiError> {
        let entry = |example: &Example| {
            Ok(ExampleEntry {
                id: example.id.to_owned(),
                name: example.name.to_owned(),
                description: example.description.to_owned(),
                lines_mm: example.lines_mm()?,
            })
        };
        Ok(ExamplesResponse { examples: EXAMPLES.iter().map(entry).collect::<Result<_, ApiError>>()? })
    }

    pub(crate) fn open_example(
        &self,
        asked: &OpenExample,
        progress: &dyn Progress,
    ) -> Result<DesignOpened, ApiError> {
        let known = || EXAMPLES.iter().map(|example| example.id.to_owned()).collect();
        let example = EXAMPLES
            .iter()
            .find(|example| example.id == asked.id)
            .ok_or_else(|| ApiError::NoExample { id: asked.id.clone(), known: known() })?;
        let before = self.open().state();
        let machine = before.machine.as_deref().map(|machine| (machine, before.material.as_deref()));
        let (app, input, keep_in) = (self.installation(), example.input(), self.keep_in());
        let (editor, notes) =
            Editor::open_for(&app, &input, machine, Some(example.name), keep_in.as_deref(), progress)?;
        self.replace(editor, notes)
    }
}
