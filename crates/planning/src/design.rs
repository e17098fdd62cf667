//! What a command works on: a file or bytes, read into a document.

mod given;

use std::path::{Path, PathBuf};
use std::sync::Arc;

use schemars::JsonSchema;
use serde::Deserialize;
use wirebend_core::mesh::Stencil;
use wirebend_core::plan::Machine;
use wirebend_core::units::Length;
use wirebend_error::{ErrorRemedy, InputName};
use wirebend_files::document::{Document, Job, SourceFile, StencilSource, sha256_hex};
use wirebend_files::read::frame::FrameFile;
use wirebend_files::read::{
    DEFAULT_TOLERANCE_MM, Format, Handedness, LengthUnit, ReadOptions, read, read_file,
};

use crate::curves::{CurvesReport, ShortestEdge};
use crate::job::is_job;
use crate::output::file_name;
use crate::program::{ProgramKind, ReadProgram};
use crate::report::NoteReport;
use crate::{Installation, PlanChoices, PlanningError, Progress};

/// Where the bytes come from.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Input {
    File(PathBuf),
    /// Bytes that the front end has, with a name for messages.
    Bytes {
        name: String,
        bytes: Vec<u8>,
    },
}

impl Input {
    /// The name for messages and the bytes.
    pub fn load(&self) -> Result<(String, Vec<u8>), PlanningError> {
        match self {
            Self::File(path) => Ok((path.display().to_string(), read_file(path)?)),
            Self::Bytes { name, bytes } => Ok((name.clone(), bytes.clone())),
        }
    }

    /// The folder in which files may be that the input names; none for bytes.
    pub fn folder(&self) -> Option<&Path> {
        match self {
            Self::File(path) => path.parent(),
            Self::Bytes { .. } => None,
        }
    }

    /// The name without its folder and extension.
    pub fn stem(&self) -> String {
        let name = match self {
            Self::File(path) => file_name(path),
            Self::Bytes { name, .. } => name.clone(),
        };
        name.rsplit_once('.').map_or(name.clone(), |(stem, _)| stem.to_owned())
    }
}

/// A design and how to read it. A `.wirebend` document is taken as it is.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
pub struct DesignInput {
    /// Where it comes from.
    pub input: Input,
    /// Its format, where name and contents do not show it.
    #[serde(default, deserialize_with = "format_by_name")]
    #[schemars(with = "Option<String>")]
    pub format: Option<Format>,
    /// Factor on all coordinates, after units.
    #[serde(default = "one")]
    pub scale: f64,
    /// The unit of the coordinates, where the file does not say.
    #[serde(default)]
    pub units: Option<LengthUnit>,
    /// Vertices closer than this become one, in mm.
    #[serde(default = "default_weld_mm")]
    pub weld_mm: f64,
    /// Whether the edges of faces are the wireframe.
    #[serde(default)]
    pub face_edges: bool,
    /// Centreline radius of the bends of a table that does not say, in mm.
    #[serde(default)]
    pub clr_mm: Option<f64>,
    /// How far straight edges may be from the curves of a drawing, in mm.
    #[serde(default = "default_tolerance_mm")]
    pub tolerance_mm: f64,
    /// How short edges of the curves of a drawing may be, although they may be farther off for that; absent: as short as
    /// the tolerance asks for.
    #[serde(default)]
    pub shortest_edge: Option<ShortestEdge>,
    /// The layers of a drawing to read; empty: all that are not hidden.
    #[serde(default)]
    pub layers: Vec<String>,
    /// Which way the rotations of a table of bends turn, where the table does not say.
    #[serde(default)]
    pub handedness: Option<Handedness>,
    /// What the steps of a program are, where the program does not say.
    #[serde(default)]
    pub program: Option<ProgramKind>,
}

fn format_by_name<'de, D: serde::Deserializer<'de>>(deserializer: D) -> Result<Option<Format>, D::Error> {
    let name = Option::<String>::deserialize(deserializer)?;
    name.map(|name| name.parse().map_err(serde::de::Error::custom)).transpose()
}

const fn one() -> f64 {
    1.0
}

/// What files written with six digits need to close.
pub const fn default_weld_mm() -> f64 {
    1e-3
}

/// The same as a length.
pub(crate) fn default_weld() -> Length {
    Length::from_mm(default_weld_mm()).unwrap_or_default()
}

const fn default_tolerance_mm() -> f64 {
    DEFAULT_TOLERANCE_MM
}

/// A surface that was found in a file.
pub struct FoundStencil {
    /// The file's name.
    pub name: String,
    pub surface: Stencil,
}

impl DesignInput {
    /// A file, read with the defaults.
    #[must_use]
    pub const fn file(path: PathBuf) -> Self {
        Self {
            input: Input::File(path),
            format: None,
            scale: 1.0,
            units: None,
            weld_mm: default_weld_mm(),
            face_edges: false,
            clr_mm: None,
            tolerance_mm: default_tolerance_mm(),
            shortest_edge: None,
            layers: Vec::new(),
            handedness: None,
            program: None,
        }
    }

    /// Reads the design.
    pub fn open(&self, progress: &dyn Progress) -> Result<Opened, PlanningError> {
        self.open_for(None, progress)
    }

    /// Reads the design for the machine of choices, if they name one.
    pub fn open_with(
        &self,
        app: &Installation,
        choices: &PlanChoices,
        progress: &dyn Progress,
    ) -> Result<Opened, PlanningError> {
        self.open_for(self.machine_of(app, choices)?.as_ref(), progress)
    }

    /// Reads the design from bytes that were loaded before, for the machine of choices, if they name one.
    pub fn open_bytes_with(
        &self,
        app: &Installation,
        choices: &PlanChoices,
        name: String,
        bytes: &[u8],
    ) -> Result<Opened, PlanningError> {
        self.open_bytes(name, bytes, self.machine_of(app, choices)?.as_ref())
    }

    /// The machine of choices, where reading depends on it; an unknown one is else refused by what plans on it.
    fn machine_of(
        &self,
        app: &Installation,
        choices: &PlanChoices,
    ) -> Result<Option<Machine>, PlanningError> {
        let setup = self.shortest_edge.map_or(Ok(None), |_| app.chosen_setup(choices))?;
        Ok(setup.map(|setup| setup.model))
    }

    /// Reads the design for a machine.
    pub fn open_for(
        &self,
        machine: Option<&Machine>,
        progress: &dyn Progress,
    ) -> Result<Opened, PlanningError> {
        progress.stage("reading");
        let (name, bytes) = self.input.load()?;
        if is_job(&name, &bytes) {
            // One that cannot be opened is no job that is planned already.
            Job::open(&bytes, &name)?;
            return Err(PlanningError::IsAJob { name });
        }
        self.open_bytes(name, &bytes, machine)
    }

    /// Reads the surface; of a design with several stencils, all of them as one.
    pub fn stencil(&self, progress: &dyn Progress) -> Result<(FoundStencil, Vec<NoteReport>), PlanningError> {
        let mut opened = self.open(progress)?;
        opened.fetch_stencils(self)?;
        let surface: Stencil = opened.document.surfaces_in_place().collect();
        if surface.faces().is_empty() {
            return Err(PlanningError::NoSurface { name: opened.name });
        }
        let name = file_name(Path::new(&opened.name));
        Ok((FoundStencil { name, surface }, opened.notes))
    }

    /// Reads the design from bytes that were loaded before, for a machine if there is one.
    pub fn open_bytes(
        &self,
        name: String,
        bytes: &[u8],
        machine: Option<&Machine>,
    ) -> Result<Opened, PlanningError> {
        let edges = self.shortest_edge.map(|shortest| shortest.chosen(machine)).transpose()?;
        let options = ReadOptions {
            scale: positive(InputName::Scale, self.scale)?,
            units: self.units,
            weld: length(InputName::Weld, self.weld_mm)?,
            face_edges: self.face_edges,
            clr: self.clr_mm.map(|clr| length(InputName::CentrelineRadius, clr)).transpose()?,
            tolerance: length(InputName::Tolerance, positive(InputName::Tolerance, self.tolerance_mm)?)?,
            shortest_edge: edges.map(|edges| edges.shortest),
            bend_radius: edges.map_or(Length::ZERO, |edges| edges.bend_radius),
            layers: self.layers.clone(),
            commanded: self.program == Some(ProgramKind::Compensated),
            handedness: self.handedness,
            folder: self.input.folder().map(Path::to_owned),
            ..ReadOptions::default()
        };
        let imported = read(bytes, &name, self.format, &options)?;
        let without_effect = self.without_effect(imported.format);
        if !without_effect.is_empty() {
            let (format, inputs) = (imported.format, without_effect);
            return Err(PlanningError::WithoutEffect { name, format, inputs });
        }
        if imported.document.is_some() && !self.reads_plainly() {
            let (inputs, instead) = (self.read_otherwise(), Box::new(ErrorRemedy::ImportOriginal));
            return Err(PlanningError::Settled { name, inputs, instead });
        }
        let mut notes: Vec<NoteReport> = imported.notes.iter().map(NoteReport::from).collect();
        let program =
            imported.program.map(|program| ReadProgram::new(program, self.program, imported.format));
        notes.extend(program.as_ref().and_then(ReadProgram::assumed));
        let curves = imported.curves.zip(edges).map(|(facts, edges)| {
            let report = CurvesReport::new(&facts, &edges);
            notes.extend(report.notes(&edges));
            report
        });
        for note in &notes {
            tracing::info!(code = %note.code, count = note.count, "{}", note.message);
        }
        let document = if let Some(document) = imported.document {
            *document
        } else {
            let source = Some(SourceFile { file: name.clone(), sha256: sha256_hex(bytes) });
            let mut document = Document { source, ..Document::new(imported.wireframe) };
            if let Some(surface) = imported.stencil {
                let name = file_name(Path::new(&name));
                document.add_stencil(name, StencilSource::Embedded(Arc::new(surface)));
            }
            document
        };
        Ok(Opened {
            name,
            format: imported.format,
            document,
            layers: imported.layers,
            curves,
            program,
            frame: imported.frame,
            notes,
        })
    }
}

/// A design that has been read.
pub struct Opened {
    pub name: String,
    pub format: Format,
    pub document: Document,
    /// Of a drawing.
    pub layers: Vec<String>,
    /// What was made of the curves of a drawing whose edges have a least length.
    pub curves: Option<CurvesReport>,
    /// Of a file that is one.
    pub program: Option<ReadProgram>,
    /// Of a file of a frame what it says beside its struts.
    pub frame: Option<Box<FrameFile>>,
    pub notes: Vec<NoteReport>,
}

impl Opened {
    /// The design once more: a plan keeps the one that it was computed from.
    pub(crate) fn copy(&self) -> Self {
        Self {
            name: self.name.clone(),
            format: self.format,
            document: self.document.clone(),
            layers: Vec::new(),
            curves: None,
            program: self.program.clone(),
            frame: self.frame.clone(),
            notes: self.notes.clone(),
        }
    }

    /// A design that is open already.
    pub const fn of(name: String, document: Document) -> Self {
        Self {
            name,
            format: Format::Wirebend,
            document,
            layers: Vec::new(),
            curves: None,
            program: None,
            frame: None,
            notes: Vec::new(),
        }
    }

    /// The error that a vertex is not there.
    pub(crate) fn no_vertex(&self, vertex: u32, input: InputName) -> PlanningError {
        let ids: Vec<u32> = self.document.wireframe.vertices().map(|(id, _)| id.0).collect();
        let range = match (ids.first(), ids.last()) {
            (Some(first), Some(last)) => format!("{first} to {last}"),
            _ => "none".to_owned(),
        };
        PlanningError::NoVertex { vertex, name: self.name.clone(), count: ids.len(), range, input }
    }

    /// The design, if it has a wireframe to work on.
    pub fn with_wireframe(self) -> Result<Self, PlanningError> {
        if self.document.wireframe.edge_count() == 0 && !self.document.stencils.is_empty() {
            return Err(PlanningError::OnlyStencil { name: self.name, format: self.format });
        }
        Ok(self)
    }
}

fn positive(input: InputName, value: f64) -> Result<f64, PlanningError> {
    if value.is_finite() && value > 0.0 {
        Ok(value)
    } else {
        Err(PlanningError::Value {
            input: Some(input),
            name: input.words(),
            value: value.to_string(),
            expected: "a number above 0",
        })
    }
}

pub fn length(input: InputName, mm: f64) -> Result<Length, PlanningError> {
    let wrong = || PlanningError::Value {
        input: Some(input),
        name: input.words(),
        value: mm.to_string(),
        expected: "a length in mm, 0 or more",
    };
    Length::from_mm(mm).ok().filter(|length| *length >= Length::ZERO).ok_or_else(wrong)
}
