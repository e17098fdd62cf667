//! `profile check`: whether profile files can be used, before they are put where they count.

use std::path::{Path, PathBuf};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_profile::{Checked, Place, ProfileError, check_file};

use crate::{App, AppError, ExportFormat, Progress};

/// What to check.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct ProfileCheckRequest {
    /// The files.
    pub files: Vec<PathBuf>,
}

/// What a file is, or why it is refused.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct FileVerdict {
    /// The file.
    pub file: PathBuf,
    /// Whether it can be used.
    pub ok: bool,
    /// `machine`, `material` or `noise`.
    pub kind: Option<&'static str>,
    /// Its id.
    pub id: Option<String>,
    /// Whom it inherits from, nearest first; itself not included.
    pub inherits: Vec<String>,
    /// Why it is refused: each with file, line, what was expected and what to do.
    pub errors: Vec<String>,
}

/// What became of the files.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct ProfileCheckResponse {
    /// Whether all can be used.
    pub ok: bool,
    /// In the order asked for.
    pub files: Vec<FileVerdict>,
}

/// Refuses a machine whose formats nobody can write.
pub(crate) fn formats_known(file: &str, text: &str) -> Result<(), ProfileError> {
    let value: serde_json::Value = serde_json::from_str(text).unwrap_or_default();
    let formats = value.pointer("/export/formats").and_then(serde_json::Value::as_array);
    let unknown = formats
        .into_iter()
        .flatten()
        .filter_map(serde_json::Value::as_str)
        .find(|id| !ExportFormat::ALL.into_iter().any(|format| format.id() == *id));
    match unknown {
        None => Ok(()),
        Some(id) => Err(ProfileError::Rule {
            place: Place { file: file.to_owned(), line: line_of(text, id) },
            key: "export.formats".into(),
            found: format!("\"{id}\""),
            expected: format!(
                "formats that can be written: {}",
                ExportFormat::ALL.map(ExportFormat::id).join(", ")
            ),
        }),
    }
}

/// Everything that is asked of a profile's file.
fn examined(file: &Path) -> Result<Checked, Vec<ProfileError>> {
    let checked = check_file(file)?;
    let text = std::fs::read_to_string(file).unwrap_or_default();
    formats_known(&file.display().to_string(), &text).map_err(|error| vec![error])?;
    Ok(checked)
}

/// The line on which a quoted word stands, from 1.
fn line_of(text: &str, word: &str) -> Option<usize> {
    let quoted = format!("\"{word}\"");
    text.lines().position(|line| line.contains(&quoted)).map(|line| line + 1)
}

#[allow(clippy::unnecessary_wraps)] // every command has the same shape
pub(crate) fn check(
    _app: &App,
    request: &ProfileCheckRequest,
    progress: &dyn Progress,
) -> Result<ProfileCheckResponse, AppError> {
    progress.stage("checking profiles");
    let verdict = |file: &PathBuf| match examined(file) {
        Ok(checked) => FileVerdict {
            ok: true,
            kind: Some(checked.kind.word()),
            inherits: checked.chain.into_iter().filter(|id| *id != checked.id).collect(),
            id: Some(checked.id),
            errors: Vec::new(),
            file: file.clone(),
        },
        Err(errors) => FileVerdict {
            ok: false,
            kind: None,
            id: None,
            inherits: Vec::new(),
            errors: errors.iter().map(ToString::to_string).collect(),
            file: file.clone(),
        },
    };
    let files: Vec<FileVerdict> = request.files.iter().map(verdict).collect();
    Ok(ProfileCheckResponse { ok: files.iter().all(|file| file.ok), files })
}
