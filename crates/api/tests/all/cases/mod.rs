//! The golden cases and an application with its drivers, for every test that runs them.

mod fit;

use std::path::{Path, PathBuf};

use serde::Deserialize;
use serde_json::{Map, Value};
use wirebend_api::{
    ApiError, Command, DesignInput, DriverFolders, ExportRequest, ExportResponse, Installation, NoProgress,
    PlanChoices, PlanRequest, PlanningError, Response,
};

pub use fit::proper_misfits;

/// `case.json`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Case {
    pub about: String,
    /// The design, from the root of the repository.
    design: String,
    #[serde(default)]
    face_edges: bool,
    #[serde(default)]
    double: bool,
    #[serde(default)]
    closed: bool,
    /// What others have worked out.
    pub facts: Value,
}

/// The root of the repository.
pub fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// Every case with the folder of its files, by name.
pub fn all() -> Vec<(String, PathBuf, Case)> {
    let mut cases: Vec<(String, PathBuf, Case)> = std::fs::read_dir(root().join("tests/golden"))
        .unwrap()
        .map(|entry| entry.unwrap())
        .filter(|entry| entry.path().is_dir())
        .map(|entry| (entry.file_name().into_string().unwrap(), entry.path(), Case::load(&entry.path())))
        .collect();
    cases.sort_by(|a, b| a.0.cmp(&b.0));
    assert!(cases.len() >= 15, "the cases are gone");
    cases
}

impl Case {
    pub fn load(folder: &Path) -> Self {
        let text = std::fs::read_to_string(folder.join("case.json")).unwrap();
        serde_json::from_str(&text).unwrap_or_else(|error| panic!("{}: {error}", folder.display()))
    }

    pub fn input(&self) -> DesignInput {
        DesignInput { face_edges: self.face_edges, ..DesignInput::file(root().join(&self.design)) }
    }

    pub fn choices(&self, machine: &str) -> PlanChoices {
        // The thin wire of the published Pensa programs, and the wire of the paper.
        PlanChoices {
            machine: Some(machine.to_owned()),
            double: self.double,
            closed: self.closed,
            ..PlanChoices::default()
        }
    }

    /// The job's bytes, where there is one.
    pub fn job(&self, machine: &str) -> Option<Vec<u8>> {
        let request = PlanRequest {
            design: self.input(),
            choices: self.choices(machine),
            output: None,
            make_job: true,
            pauses: Vec::new(),
            despite_errors: true,
        };
        match run(&Command::Plan(request)) {
            Ok(Response::Plan(found)) => Some(found.contents),
            Err(ApiError::Planning(PlanningError::StageNotReached { .. })) => None,
            other => panic!("{}: {other:?}", self.about),
        }
    }

    /// The texts of a format, one for each wire, or why it cannot be written.
    pub fn export(&self, machine: &str, format: &str) -> Result<Vec<String>, ApiError> {
        export(self.input(), self.choices(machine), format, &Value::Null).map(|found| texts(&found))
    }
}

/// Has a design or a job written, with settings for the format, although checks may object.
pub fn export(
    design: DesignInput,
    choices: PlanChoices,
    format: &str,
    settings: &Value,
) -> Result<ExportResponse, ApiError> {
    exported(ExportRequest { despite_errors: true, ..asked(design, choices, format, settings) })
}

/// A request for what checks do not object to.
pub fn asked(design: DesignInput, choices: PlanChoices, format: &str, settings: &Value) -> ExportRequest {
    ExportRequest {
        design,
        choices,
        format: Some(format.to_owned()),
        settings: settings.as_object().cloned().unwrap_or_else(Map::new),
        output: None,
        despite_errors: false,
    }
}

pub fn exported(request: ExportRequest) -> Result<ExportResponse, ApiError> {
    match run(&Command::Export(request))? {
        Response::Export(found) => Ok(*found),
        other => panic!("an export answered {other:?}"),
    }
}

/// What was written, a text for each wire.
pub fn texts(found: &ExportResponse) -> Vec<String> {
    found.contents.iter().map(|bytes| String::from_utf8(bytes.clone()).unwrap()).collect()
}

/// Where the drivers of this workspace lie once they are built, and the program that runs them.
pub fn drivers() -> DriverFolders {
    DriverFolders {
        own: Some(vec![wirebend_tests_built::shipped_drivers()]),
        program: Some(wirebend_tests_built::driver_child()),
        ..DriverFolders::default()
    }
}

pub fn run(command: &Command) -> Result<Response, ApiError> {
    thread_local!(static APP: Installation = Installation::new(&[]).unwrap().with_drivers(drivers()));
    APP.with(|app| command.run(app, &NoProgress))
}
