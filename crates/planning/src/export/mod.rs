//! `export`: what a machine, another program or a person reads.

mod by_driver;
mod content;
mod driver;
mod format;
mod joints;
mod not_carried;
mod print;
mod sheet;
mod template;

use std::path::{Path, PathBuf};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};
use wirebend_core::units::Length;
use wirebend_error::ErrorRemedy;
use wirebend_files::write;

use crate::choices::PlanChoices;
use crate::design::DesignInput;
use crate::machine::Setup;
use crate::misnamed::FileKind;
use crate::output::Output;
use crate::picture::{self, Caption};
use crate::report::{NoteReport, SHOWN_AS_ZERO};
use crate::{Installation, PlanningError, Progress};
use content::{Content, Wire};
use format::Chosen;
pub use format::ExportFormat;
use print::Print;
pub(crate) use print::paper;

#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct ExportRequest {
    /// The design, or a job.
    pub design: DesignInput,
    /// On which machine, and how; a job brings its own.
    pub choices: PlanChoices,
    /// The format; absent, the machine's default.
    pub format: Option<String>,
    /// Settings of the driver that writes the format, over those of the machine's profile; or of what is printed: its
    /// `paper` (`a4` or `letter`), the `units` of its lengths (`mm` or `in`), and the `date` on a job sheet instead of today's.
    #[serde(default)]
    pub settings: Map<String, Value>,
    /// Where it goes; absent, it is returned. Several wires go to files with numbers.
    pub output: Option<Output>,
    /// Whether to write a program although a check says that it cannot be made.
    #[serde(default)]
    pub despite_errors: bool,
}

/// What was written.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct ExportResponse {
    pub machine: String,
    pub format: String,
    /// The driver that wrote it; null for what the program writes itself.
    pub driver: Option<String>,
    /// How many wires.
    pub wires: usize,
    /// Whether the machine can make them.
    pub feasible: bool,
    /// What was assumed or left out.
    pub notes: Vec<NoteReport>,
    pub files: Vec<PathBuf>,
    /// The contents, one for each file, where they were not written.
    #[serde(skip)]
    pub contents: Vec<Vec<u8>>,
}

/// Whether a machine runs what is written in a format: then it is not written for a design that cannot be made.
pub fn is_program(app: &Installation, format: &str, setup: &Setup) -> Result<bool, PlanningError> {
    Ok(Chosen::new(app, Some(format), setup)?.is_program())
}

pub fn export(
    app: &Installation,
    request: &ExportRequest,
    progress: &dyn Progress,
) -> Result<ExportResponse, PlanningError> {
    let mut content = Content::open(app, request, progress)?;
    progress.stage("looking for the format");
    let chosen = Chosen::new(app, request.format.as_deref(), &content.setup)?;
    chosen.require_for(&content.setup)?;
    if chosen.is_program() {
        content.require_feasible(request.despite_errors, chosen.is_own())?;
    }
    progress.stage("writing");
    if chosen.is_own() {
        content.notes.extend(head_left_turned(&content));
    }
    let not_carried = not_carried::note(app, &content, &chosen);
    content.notes.extend(not_carried);
    if chosen.is_program() || chosen.is_of_design() {
        content.notes.extend(pauses_not_carried(&content, chosen.id()));
    }
    // It is of the file, and not of what is in it.
    let misnamed = misnamed(request.output.as_ref(), &chosen);
    let (format, driver) = (chosen.id().to_owned(), chosen.driver_id().map(str::to_owned));
    let contents = match chosen {
        Chosen::BuiltIn(format) => {
            let print = Print::asked(format, &request.settings)?;
            vec![encode(&mut content, format, &print)?]
        }
        Chosen::Driver(driver, format) => by_driver::encode(&mut content, *driver, &format, request)?,
    };
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
        driver,
        wires: content.wires.len(),
        feasible: content.feasible,
        notes: content.notes.into_iter().chain(misnamed).collect(),
        contents: if files.is_empty() { contents } else { Vec::new() },
        files,
    })
}

fn misnamed(output: Option<&Output>, chosen: &Chosen) -> Option<NoteReport> {
    let (called, endings) = (format!("'{}'", chosen.id()), chosen.extensions());
    let kind = FileKind { called: &called, endings: &endings };
    if chosen.is_program() { kind.misnamed_program(output) } else { kind.misnamed(output) }
}

/// Programs count the head's turns from where it stands, and its cables have an end.
fn head_left_turned(content: &Content) -> Option<NoteReport> {
    // Where it ends: what turns are off by, and what they lose, is in what it is told.
    let steps = content.wires.iter().filter_map(|wire| wire.kept.as_ref());
    let ends: Vec<f64> = steps.map(|wire| wire.scheduled.iter().map(|step| step.rotate_deg).sum()).collect();
    let left: Vec<String> =
        ends.iter().filter(|end: &&f64| end.abs() > SHOWN_AS_ZERO).map(|end| format!("{end:.1}°")).collect();
    (!left.is_empty()).then(|| NoteReport {
        code: "head-left-turned".into(),
        count: left.len(),
        message: format!(
            "the head ends {} from its start: turn it back before the next wire",
            left.join(", ")
        ),
        remedies: Vec::new(),
    })
}

/// A file of a machine's program has no place for pause points: they are kept by who sends the steps.
fn pauses_not_carried(content: &Content, format: &str) -> Option<NoteReport> {
    let kept = content.wires.iter().filter_map(|wire| wire.kept.as_ref());
    let count: usize = kept.map(|wire| wire.pauses.len()).sum();
    (count > 0).then(|| NoteReport {
        code: "pauses-not-carried".into(),
        count,
        message: format!(
            "{} left out: {format} cannot say where the machine waits for a person; it does where the job is run",
            if count == 1 { "1 pause point is".to_owned() } else { format!("{count} pause points are") }
        ),
        remedies: Vec::new(),
    })
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

fn encode(content: &mut Content, format: ExportFormat, print: &Print) -> Result<Vec<u8>, PlanningError> {
    match format {
        ExportFormat::Obj | ExportFormat::ObjTube | ExportFormat::Gltf => Ok(model(content, format)),
        ExportFormat::TemplateSvg | ExportFormat::TemplateDxf | ExportFormat::TemplatePdf => {
            template::encode(content, format, print)
        }
        ExportFormat::JobSheet => Ok(sheet::encode(content, print)),
        ExportFormat::Svg | ExportFormat::Png => picture(content, format == ExportFormat::Png),
    }
}

/// The bent wire in space, as lines or with its surface.
fn model(content: &mut Content, format: ExportFormat) -> Vec<u8> {
    let setup = &content.setup;
    let diameter = setup.model.wire.diameter;
    let chord = chord(diameter);
    let lines: Vec<_> = content
        .wires
        .iter()
        .map(|wire| write::centreline(&wire.path, setup.model.bend_radius, chord))
        .collect();
    let tightened: usize = lines.iter().map(|line| line.tightened.len()).sum();
    content.notes.extend(bends_tightened(tightened));
    let radius = Length::from_mm(diameter.mm() / 2.0).unwrap_or_default();
    let tube = write::Tube { radius, sides: 12 };
    match format {
        ExportFormat::Gltf => write::glb(&lines, tube),
        ExportFormat::ObjTube => write::obj(&lines, Some(tube)).into_bytes(),
        _ => write::obj(&lines, None).into_bytes(),
    }
}

/// How far a chord may leave an arc: a hundredth of the wire's diameter cannot be seen.
fn chord(diameter: Length) -> Length {
    Length::from_mm(diameter.mm() / 100.0).unwrap_or_default()
}

fn bends_tightened(count: usize) -> Option<NoteReport> {
    (count > 0).then(|| NoteReport {
        code: "bends-tightened".into(),
        count,
        message: if count == 1 {
            "1 bend is drawn tighter than the machine bends it: its edges are too short".to_owned()
        } else {
            format!("{count} bends are drawn tighter than the machine bends them: their edges are too short")
        },
        remedies: Vec::new(),
    })
}

fn picture(content: &mut Content, png: bool) -> Result<Vec<u8>, PlanningError> {
    let setup = &content.setup;
    let caption = Caption {
        title: content.title.clone(),
        machine: setup.machine_name().to_owned(),
        material: setup.material_name().to_owned(),
        length: content.wires.iter().flat_map(|wire| &wire.nominal).map(|step| step.feed).sum(),
        bends: content.wires.iter().map(Wire::bend_count).sum(),
    };
    let wires = content.wires.iter().map(Wire::picture).collect();
    let drawing = picture::draw(caption, wires, Vec::new(), std::mem::take(&mut content.marks));
    if !png {
        return Ok(drawing.into_bytes());
    }
    let (pixels, has_fonts) = picture::png(&drawing)?;
    if !has_fonts {
        content.notes.push(no_fonts());
    }
    Ok(pixels)
}

pub fn no_fonts() -> NoteReport {
    NoteReport {
        code: "no-fonts".into(),
        count: 1,
        message: "no font is installed: the picture has no labels".to_owned(),
        remedies: vec![ErrorRemedy::InstallFont],
    }
}
