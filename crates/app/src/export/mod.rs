//! `export`: what a machine, another program or a person reads.

mod content;

use std::path::{Path, PathBuf};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_core::bend::Step;
use wirebend_core::units::Length;
use wirebend_files::document::Job;
use wirebend_files::write::{self, KitLayout, LraLayout, PensaLayout, PictureWire, TableStyle};

use crate::design::DesignInput;
use crate::machine::Setup;
use crate::output::Output;
use crate::picture::{self, Caption};
use crate::plan::PlanChoices;
use crate::report::NoteReport;
use crate::{App, AppError, Progress};
use content::{Content, Wire};

/// A format that can be written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum ExportFormat {
    /// `F`, `R` and `B` lines of the WireBend-kit.
    WirebendKitText,
    /// `FEED`, `ROTATE` and `BEND` lines of the Pensa D.I.Wire.
    PensaScript,
    /// Table of lengths, rotations and angles.
    LraCsv,
    /// The same with the columns of the YBC convention.
    YbcCsv,
    /// Table of points.
    XyzCsv,
    /// Picture.
    Svg,
    /// Picture in pixels.
    Png,
    /// Centreline of the bent wire.
    Obj,
    /// The bent wire as a surface.
    ObjTube,
}

impl ExportFormat {
    /// Every format.
    pub const ALL: [Self; 9] = [
        Self::WirebendKitText,
        Self::PensaScript,
        Self::LraCsv,
        Self::YbcCsv,
        Self::XyzCsv,
        Self::Svg,
        Self::Png,
        Self::Obj,
        Self::ObjTube,
    ];

    /// The name in profiles and on the command line.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::WirebendKitText => "wirebend-kit-text",
            Self::PensaScript => "pensa-script",
            Self::LraCsv => "lra-csv",
            Self::YbcCsv => "ybc-csv",
            Self::XyzCsv => "xyz-csv",
            Self::Svg => "svg",
            Self::Png => "png",
            Self::Obj => "obj",
            Self::ObjTube => "obj-tube",
        }
    }

    fn from_id(id: &str) -> Result<Self, AppError> {
        Self::ALL.into_iter().find(|format| format.id() == id).ok_or_else(|| AppError::UnknownFormat {
            name: id.to_owned(),
            known: Self::ALL.map(Self::id).join(", "),
        })
    }

    /// Whether a machine runs it: then it is not written of what cannot be made.
    const fn is_program(self) -> bool {
        matches!(self, Self::WirebendKitText | Self::PensaScript | Self::LraCsv | Self::YbcCsv)
    }

    /// Whether it is compensated, and so for one machine alone. Tables are of the design itself, in
    /// canonical signs: machines that read them compensate on their own.
    const fn is_own(self) -> bool {
        matches!(self, Self::WirebendKitText | Self::PensaScript)
    }

    /// Whether one file holds all wires.
    const fn holds_all_wires(self) -> bool {
        matches!(self, Self::Svg | Self::Png | Self::Obj | Self::ObjTube)
    }
}

/// What to export.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct ExportRequest {
    /// The design, or a job.
    pub design: DesignInput,
    /// On which machine, and how; a job brings its own.
    pub choices: PlanChoices,
    /// The format; absent, the machine's default.
    pub format: Option<String>,
    /// Where it goes; absent, it is returned. Several wires go to files with numbers.
    pub output: Option<Output>,
    /// Whether to write a program although a check says that it cannot be made.
    #[serde(default)]
    pub despite_errors: bool,
}

/// What was written.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct ExportResponse {
    /// The machine.
    pub machine: String,
    /// The format.
    pub format: ExportFormat,
    /// How many wires.
    pub wires: usize,
    /// Whether the machine can make them.
    pub feasible: bool,
    /// What was assumed or left out.
    pub notes: Vec<NoteReport>,
    /// The files.
    pub files: Vec<PathBuf>,
    /// The contents, one for each file, where they were not written.
    #[serde(skip)]
    pub contents: Vec<Vec<u8>>,
}

pub(crate) fn export(
    app: &App,
    request: &ExportRequest,
    progress: &dyn Progress,
) -> Result<ExportResponse, AppError> {
    let wanted = request.format.as_deref().map(ExportFormat::from_id).transpose()?;
    let mut content = Content::open(app, request, progress)?;
    let format = match wanted {
        Some(format) => format,
        None => default_format(&content.setup)?,
    };
    require_format_of(&content.setup, format)?;
    if format.is_program() {
        content.require_feasible(request.despite_errors, format.is_own())?;
    }
    progress.stage("writing");
    let contents = encode(&mut content, format)?;
    let mut files = Vec::new();
    if let Some(output) = &request.output {
        let outputs: Vec<Output> = (0..contents.len())
            .map(|index| Output { path: numbered(&output.path, index, contents.len()), force: output.force })
            .collect();
        // All or nothing: refuse before the first file is written.
        for output in &outputs {
            output.check()?;
        }
        for (output, bytes) in outputs.iter().zip(&contents) {
            files.push(output.save(bytes)?);
        }
    }
    Ok(ExportResponse {
        machine: content.setup.machine_id().to_owned(),
        format,
        wires: content.wires.len(),
        feasible: content.feasible,
        notes: content.notes,
        contents: if files.is_empty() { contents } else { Vec::new() },
        files,
    })
}

/// The first format of the machine's profile, unless its own one comes with a driver.
fn default_format(setup: &Setup) -> Result<ExportFormat, AppError> {
    let export = &setup.machine.profile.export;
    let formats = export.formats.clone().unwrap_or_default();
    if let Some(native) = &export.native {
        return Err(AppError::NativeFormat {
            machine: setup.machine_id().to_owned(),
            native: native.clone(),
            driver: setup.machine.profile.driver.id.clone().unwrap_or_default(),
            known: formats.join(", "),
        });
    }
    ExportFormat::from_id(formats.first().map_or("", String::as_str))
}

/// Refuses the program of another machine: it would be in that machine's format with this one's angles.
fn require_format_of(setup: &Setup, format: ExportFormat) -> Result<(), AppError> {
    let formats = setup.machine.profile.export.formats.clone().unwrap_or_default();
    if format.is_own() && !formats.iter().any(|id| id == format.id()) {
        return Err(AppError::FormatOfAnother {
            format: format.id(),
            machine: setup.machine_id().to_owned(),
            known: formats.join(", "),
        });
    }
    Ok(())
}

/// The file of one of several wires: `NAME-1.EXT`, `NAME-2.EXT`.
fn numbered(path: &Path, index: usize, count: usize) -> PathBuf {
    if count < 2 {
        return path.to_owned();
    }
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    let name = match path.extension() {
        Some(extension) => format!("{stem}-{}.{}", index + 1, extension.to_string_lossy()),
        None => format!("{stem}-{}", index + 1),
    };
    path.with_file_name(name)
}

fn encode(content: &mut Content, format: ExportFormat) -> Result<Vec<Vec<u8>>, AppError> {
    if format.holds_all_wires() {
        return Ok(vec![encode_all(content, format)?]);
    }
    let encoded = content.wires.iter().enumerate().map(|(index, wire)| {
        let text = match format {
            ExportFormat::XyzCsv => write::xyz(&wire.path, &TableStyle::default()),
            ExportFormat::LraCsv | ExportFormat::YbcCsv => table(content, wire, format)
                .map_err(|reason| AppError::Unwritable { wire: index, format: format.id(), reason })?,
            _ => program(content, wire, format).ok_or_else(|| AppError::Unwritable {
                wire: index,
                format: format.id(),
                reason: "it could not be compensated; see what `check` says".to_owned(),
            })?,
        };
        Ok(text.into_bytes())
    });
    encoded.collect()
}

/// The program of a machine of its own: compensated, in the machine's signs.
fn program(content: &Content, wire: &Wire, format: ExportFormat) -> Option<String> {
    let steps: &[Step] = wire.compensated.as_deref()?;
    let convention = content.setup.convention;
    Some(if format == ExportFormat::PensaScript {
        let comments = vec![format!("design {}", content.design_hash)];
        write::pensa(steps, &PensaLayout { comments, convention, ..PensaLayout::default() })
    } else {
        let design_hash = Some(content.design_hash.clone());
        write::kit(steps, &KitLayout { design_hash, convention, ..KitLayout::default() })
    })
}

/// The table of the design itself: machines that read tables compensate on their own.
fn table(content: &Content, wire: &Wire, format: ExportFormat) -> Result<String, String> {
    let radius = content.setup.model.bend_radius;
    let layout = if format == ExportFormat::YbcCsv { LraLayout::ybc(radius) } else { LraLayout::lra(radius) };
    write::lra(&wire.nominal, &layout).map_err(|error| error.to_string())
}

fn encode_all(content: &mut Content, format: ExportFormat) -> Result<Vec<u8>, AppError> {
    let setup = &content.setup;
    if matches!(format, ExportFormat::Obj | ExportFormat::ObjTube) {
        // A hundredth of the wire's diameter cannot be seen.
        let diameter = setup.model.wire.diameter;
        let chord = Length::from_mm(diameter.mm() / 100.0).unwrap_or_default();
        let lines: Vec<_> = content
            .wires
            .iter()
            .map(|wire| write::centreline(&wire.path, setup.model.bend_radius, chord))
            .collect();
        let tightened: usize = lines.iter().map(|line| line.tightened.len()).sum();
        let radius = Length::from_mm(diameter.mm() / 2.0).unwrap_or_default();
        let tube = (format == ExportFormat::ObjTube).then_some(write::Tube { radius, sides: 12 });
        let text = write::obj(&lines, tube);
        if tightened > 0 {
            content.notes.push(NoteReport {
                code: "bends-tightened",
                count: tightened,
                message: format!("{tightened} bends are drawn tighter than the machine makes them: their edges are too short"),
            });
        }
        return Ok(text.into_bytes());
    }
    let caption = Caption {
        title: content.title.clone(),
        machine: setup.machine_name().to_owned(),
        material: setup.material_name().to_owned(),
        length: content.wires.iter().flat_map(|wire| &wire.nominal).map(|step| step.feed).sum(),
        bends: content.wires.iter().map(Wire::bend_count).sum(),
    };
    let wire = |wire: &Wire| PictureWire { points: wire.path.clone(), doubled: wire.doubled.clone() };
    let wires = content.wires.iter().map(wire).collect();
    let drawing = picture::draw(caption, wires, Vec::new(), std::mem::take(&mut content.marks));
    if format == ExportFormat::Svg {
        return Ok(drawing.into_bytes());
    }
    let (pixels, has_fonts) = picture::png(&drawing)?;
    if !has_fonts {
        content.notes.push(no_fonts());
    }
    Ok(pixels)
}

pub(crate) fn no_fonts() -> NoteReport {
    NoteReport {
        code: "no-fonts",
        count: 1,
        message: "no font is installed: the picture has no labels; write an SVG, or install one (apt-get install fonts-dejavu-core)".to_owned(),
    }
}

/// Whether bytes are a job: by name, or by the mark that every job has near its start.
pub(crate) fn is_job(name: &str, bytes: &[u8]) -> bool {
    let start = String::from_utf8_lossy(&bytes[..bytes.len().min(4096)]).into_owned();
    Path::new(name).extension().is_some_and(|extension| extension.eq_ignore_ascii_case("wbjob"))
        || (start.trim_start().starts_with('{') && start.contains("\"wbjob\""))
}

/// Opens a job; its hash has to fit.
pub(crate) fn open_job(name: &str, bytes: &[u8]) -> Result<Job, AppError> {
    if !is_job(name, bytes) {
        return Err(AppError::NotAJob { name: name.to_owned() });
    }
    Ok(Job::open(bytes, name)?)
}
