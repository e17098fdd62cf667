//! What can be written of the open design for its machine, and writing it.

use std::path::PathBuf;

use wirebend_files::document::Job;
use wirebend_planning::PlanningError;
use wirebend_planning::plan::Planned;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD as BASE64;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};

use super::Workspace;
use crate::{ApiError, ExportFormat, ExportRequest, Input, PlanChoices, ProblemReport, Progress};
use wirebend_planning::design::DesignInput;
use wirebend_planning::import::wireframe_obj;
use wirebend_planning::output::Output;
use wirebend_planning::report::NoteReport;

/// How much of a file is shown before it is written, in lines.
const PREVIEW_LINES: usize = 40;

/// Asks what can be written for the machine of the open design.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct ExportsRequest {}

/// A format to choose.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct FormatEntry {
    /// What `--format` takes.
    pub id: String,
    pub name: String,
    /// How the names of its files end, without the dot.
    pub extension: String,
    /// The driver that writes it; null for what the program writes itself.
    pub driver: Option<String>,
    /// Whether it is the machine's own or one that its profile lists.
    pub of_machine: bool,
    /// Whether a machine runs it: then it is not written for a design that cannot be made.
    pub program: bool,
    /// The JSON Schema of its settings; null where it has none.
    pub settings_schema: Option<Value>,
    /// The settings that the machine's profile has.
    pub settings: Map<String, Value>,
}

/// What can be written.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct ExportsResponse {
    /// The machine's own first, then what its profile lists, then the rest.
    pub formats: Vec<FormatEntry>,
    /// Drivers that could not be asked, and why.
    pub problems: Vec<ProblemReport>,
}

/// Writes the open design, or shows what would be written.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct ExportDesign {
    pub format: String,
    /// Its settings, over those of the machine's profile.
    #[serde(default)]
    pub settings: Map<String, Value>,
    /// Whether to write a program although a check says that it cannot be made.
    #[serde(default)]
    pub despite_errors: bool,
    /// Where it goes; absent, its beginning is returned.
    pub output: Option<Output>,
    /// Whether all of what would be written is returned too, to be looked at as it will be.
    #[serde(default)]
    pub contents: bool,
}

/// A file, or the beginning of what it would be.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct ExportPreview {
    pub format: String,
    /// Whether the machine can make it.
    pub feasible: bool,
    /// What was assumed or left out.
    pub notes: Vec<NoteReport>,
    /// The files that were written.
    pub files: Vec<PathBuf>,
    /// Of each file that would be written its first lines; null of one that is no text.
    pub beginnings: Vec<Option<String>>,
    pub bytes: Vec<usize>,
    /// All of each file that would be written, in Base64; empty where that was not asked for.
    pub contents: Vec<String>,
}

/// Plans the open design and writes the job.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct SaveJob {
    pub output: Output,
    /// Whether to write a job although a check says that it cannot be made.
    #[serde(default)]
    pub despite_errors: bool,
}

/// A job that was written.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct SavedJob {
    pub file: PathBuf,
    pub job_hash: String,
    /// What a person should know who runs it.
    pub notes: Vec<NoteReport>,
}

/// Writes the wireframe of the open design as an OBJ, which other programs edit.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct SaveWireframe {
    pub output: Output,
}

/// A wireframe that was written.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
pub struct SavedWireframe {
    pub file: PathBuf,
}

impl Workspace {
    /// The open design as a command takes it.
    pub(crate) fn as_input(&self) -> Result<DesignInput, ApiError> {
        let opened = self.copy();
        let stem = opened.name.strip_suffix(".wirebend").unwrap_or(&opened.name);
        let input = Input::Bytes { name: format!("{stem}.wirebend"), bytes: opened.document.to_bytes()? };
        Ok(DesignInput { input, ..DesignInput::file(PathBuf::new()) })
    }

    pub(crate) fn exports(
        &self,
        _: &ExportsRequest,
        progress: &dyn Progress,
    ) -> Result<ExportsResponse, ApiError> {
        let app = self.installation();
        let machine = self.open().state().machine;
        let machine = machine.ok_or_else(|| PlanningError::NoMachine { known: app.machine_ids() })?;
        let profile = app.library.machine(&machine)?.profile;
        let own = profile.driver.id.clone().unwrap_or_default();
        let listed: Vec<String> =
            profile.export.native.iter().chain(profile.export.formats.iter().flatten()).cloned().collect();
        progress.stage("asking drivers");
        let mut formats = Vec::new();
        let mut problems = Vec::new();
        if let Err(error) = app.driver(&own) {
            problems.push(ProblemReport::from(&error));
        }
        for started in app.all_drivers()? {
            let driver = match started {
                Ok(driver) => driver,
                Err(error) => {
                    let problem = ProblemReport::from(&error);
                    // The machine's own driver has failed above already.
                    if !problems.contains(&problem) {
                        problems.push(problem);
                    }
                    continue;
                }
            };
            let described = driver.description();
            let is_own = described.id == own;
            for format in &described.formats {
                // What is compensated is for the machine that its driver belongs to.
                let of_another = format.content == wirebend_driver_host::api::Content::Machine && !is_own;
                if of_another || formats.iter().any(|entry: &FormatEntry| entry.id == format.id) {
                    continue;
                }
                let settings = profile.driver.settings.clone().filter(|_| is_own).unwrap_or_default();
                formats.push(FormatEntry {
                    id: format.id.clone(),
                    name: format.name.clone(),
                    extension: format.extensions.first().cloned().unwrap_or_default(),
                    driver: Some(described.id.clone()),
                    of_machine: is_own || listed.contains(&format.id),
                    program: format.program,
                    settings_schema: Some(described.settings_schema.clone()),
                    settings,
                });
            }
        }
        formats.extend(ExportFormat::ALL.map(|format| FormatEntry {
            id: format.id().to_owned(),
            name: format.name().to_owned(),
            extension: format.extension().to_owned(),
            driver: None,
            of_machine: listed.iter().any(|id| id == format.id()),
            program: false,
            settings_schema: format.settings_schema(),
            settings: Map::new(),
        }));
        let place =
            |entry: &FormatEntry| listed.iter().position(|id| *id == entry.id).unwrap_or(listed.len());
        formats.sort_by_key(|entry| (place(entry), !entry.of_machine));
        Ok(ExportsResponse { formats, problems })
    }

    pub(crate) fn export(
        &self,
        asked: &ExportDesign,
        progress: &dyn Progress,
    ) -> Result<ExportPreview, ApiError> {
        let request = ExportRequest {
            design: self.as_input()?,
            choices: PlanChoices::default(),
            format: Some(asked.format.clone()),
            settings: asked.settings.clone(),
            output: asked.output.clone(),
            despite_errors: asked.despite_errors,
        };
        let mut not_searched = None;
        if asked.output.is_some() || asked.contents {
            not_searched = self.require_clear(&asked.format, asked.despite_errors, progress)?;
        }
        let mut written = wirebend_planning::export::export(&self.installation(), &request, progress)?;
        written.notes.extend(not_searched);
        let begins = |bytes: &Vec<u8>| {
            let text = std::str::from_utf8(bytes).ok()?;
            let lines: Vec<&str> = text.lines().take(PREVIEW_LINES).collect();
            Some(lines.join("\n"))
        };
        Ok(ExportPreview {
            format: written.format,
            feasible: written.feasible,
            notes: written.notes,
            beginnings: written.contents.iter().map(begins).collect(),
            bytes: written.contents.iter().map(Vec::len).collect(),
            contents: if asked.contents {
                written.contents.iter().map(|bytes| BASE64.encode(bytes)).collect()
            } else {
                Vec::new()
            },
            files: written.files,
        })
    }

    pub(crate) fn save_job(&self, asked: &SaveJob, progress: &dyn Progress) -> Result<SavedJob, ApiError> {
        asked.output.check()?;
        // Who takes the job along sees in it what a person has accepted, a collision too.
        let (planned, not_searched) =
            if asked.despite_errors { self.searched(progress)? } else { self.bendable(false, progress)? };
        let job = job_of(&planned)?;
        let file = asked.output.save(&job.to_bytes()?)?;
        Ok(SavedJob { file, job_hash: job.hash().to_owned(), notes: not_searched.into_iter().collect() })
    }

    pub(crate) fn save_wireframe(
        &self,
        asked: &SaveWireframe,
        _: &dyn Progress,
    ) -> Result<SavedWireframe, ApiError> {
        let text = wireframe_obj(&self.copy().document)?;
        Ok(SavedWireframe { file: asked.output.save(&text)? })
    }

    /// The open design, planned, where its machine can bend it or a person wants it all the same; with a note where the search for
    /// collisions has not ended. Whatever a machine is to run comes through here, so that none of it says otherwise than *Check*: a
    /// collision is an error here as there.
    fn bendable(
        &self,
        despite_errors: bool,
        progress: &dyn Progress,
    ) -> Result<(Planned, Option<NoteReport>), ApiError> {
        if despite_errors {
            return Ok((self.planned(progress)?.1, None));
        }
        let (planned, not_searched) = self.searched(progress)?;
        if !planned.feasible() {
            let (machine, report) = (planned.setup.machine_id().to_owned(), Box::new(planned.report()));
            return Err(PlanningError::NotFeasible { machine, report }.into());
        }
        Ok((planned, not_searched))
    }

    /// The open design, planned and searched for collisions; with a note where that has not ended.
    fn searched(&self, progress: &dyn Progress) -> Result<(Planned, Option<NoteReport>), ApiError> {
        let (_, mut planned) = self.planned(progress)?;
        progress.stage("checking for collisions");
        let not_searched = planned.find_collisions_in_time();
        Ok((planned, not_searched))
    }

    /// Refuses to write a program of what [`Workspace::bendable`] refuses; pictures and models are written of anything.
    fn require_clear(
        &self,
        format: &str,
        despite_errors: bool,
        progress: &dyn Progress,
    ) -> Result<Option<NoteReport>, ApiError> {
        if despite_errors {
            return Ok(None);
        }
        let (app, opened) = (self.installation(), self.copy());
        let setup = app.setup_of(&opened, &PlanChoices::default())?;
        if wirebend_planning::export::is_program(&app, format, &setup)? {
            return Ok(self.bendable(despite_errors, progress)?.1);
        }
        Ok(None)
    }

    /// The job of the open design, or of what is open to be run, as a run takes it. What was not searched is said in the question
    /// before it is bent.
    pub(crate) fn job(&self, despite_errors: bool, progress: &dyn Progress) -> Result<Input, ApiError> {
        if let Some(file) = self.run_file() {
            return file.job(despite_errors);
        }
        let (planned, _) = self.bendable(despite_errors, progress)?;
        let job = job_of(&planned)?;
        let name = &planned.opened.name;
        let stem = name.strip_suffix(".wirebend").unwrap_or(name);
        Ok(Input::Bytes { name: format!("{stem}.wbjob"), bytes: job.to_bytes()? })
    }
}

/// The job of a plan, where every wire was compensated.
fn job_of(planned: &Planned) -> Result<Job, PlanningError> {
    planned.job()?.ok_or_else(|| PlanningError::StageNotReached {
        stage: crate::StageName::Compensated,
        report: Box::new(planned.report()),
    })
}
