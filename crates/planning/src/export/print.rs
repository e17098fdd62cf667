//! Settings of what the program itself prints.

use std::collections::BTreeSet;

use serde_json::{Map, Value};
use wirebend_core::units::DisplayUnit;
use wirebend_driver_host::jobs::{Clock as _, SystemClock};
use wirebend_error::InputName;
use wirebend_files::write::Paper;

use super::{ExportFormat, ExportRequest};
use crate::PlanningError;
use crate::report::NoteReport;

/// How something is printed.
#[derive(Debug, Default, PartialEq, Eq)]
pub(super) struct Print {
    pub paper: Paper,
    /// What lengths are written in.
    pub unit: DisplayUnit,
    /// Instead of today's.
    date: Option<String>,
}

/// The input that a wrong value is reported for.
const FORMAT: Option<InputName> = Some(InputName::FormatSettings);

impl Print {
    /// What was asked for; each format knows its own settings.
    pub fn asked(format: ExportFormat, settings: &Map<String, Value>) -> Result<Self, PlanningError> {
        let (name, expected) = match format {
            ExportFormat::TemplateSvg => ("a setting of template-svg", "units alone (mm or in)"),
            ExportFormat::TemplateDxf => ("a setting of template-dxf", "units alone (mm or in)"),
            ExportFormat::TemplatePdf => {
                ("a setting of template-pdf", "paper (a4 or letter) or units (mm or in)")
            }
            ExportFormat::JobSheet => (
                "a setting of job-sheet",
                "paper (a4 or letter), units (mm or in) or date (a text, today's if absent)",
            ),
            _ if settings.is_empty() => return Ok(Self::default()),
            other => return Err(PlanningError::NoSettings { format: other.id() }),
        };
        let mut print = Self::default();
        let on_pages = matches!(format, ExportFormat::TemplatePdf | ExportFormat::JobSheet);
        for (key, value) in settings {
            match key.as_str() {
                "units" => print.unit = units(value)?,
                "paper" if on_pages => print.paper = paper(FORMAT, value)?,
                "date" if format == ExportFormat::JobSheet => print.date = Some(date(value)?),
                _ => return Err(PlanningError::Value { input: FORMAT, name, value: key.clone(), expected }),
            }
        }
        Ok(print)
    }

    /// The date to print, `2026-05-01`; of today it is that of UTC.
    pub fn date(&self) -> String {
        self.date.clone().unwrap_or_else(|| SystemClock::default().stamp().chars().take(10).collect())
    }
}

/// What lengths are written in where something printed was asked for by its name; else millimetres.
pub(super) fn unit(request: &ExportRequest) -> Result<DisplayUnit, PlanningError> {
    let printed = request.format.as_deref().and_then(ExportFormat::from_id);
    match printed.and_then(|_| request.settings.get("units")) {
        Some(value) => units(value),
        None => Ok(DisplayUnit::Millimetre),
    }
}

fn units(value: &Value) -> Result<DisplayUnit, PlanningError> {
    match value.as_str() {
        Some("mm") => Ok(DisplayUnit::Millimetre),
        Some("in") => Ok(DisplayUnit::Inch),
        _ => Err(PlanningError::Value {
            input: FORMAT,
            name: "units",
            value: plain(value),
            expected: "mm or in",
        }),
    }
}

/// The paper that a value names; a wrong one is reported for the input.
pub(crate) fn paper(input: Option<InputName>, value: &Value) -> Result<Paper, PlanningError> {
    let named = |paper: &Paper| value.as_str().is_some_and(|name| name.eq_ignore_ascii_case(paper.id()));
    Paper::ALL.into_iter().find(named).ok_or_else(|| PlanningError::Value {
        input,
        name: "paper",
        value: plain(value),
        expected: "a4 or letter",
    })
}

fn date(value: &Value) -> Result<String, PlanningError> {
    let wrong = || PlanningError::Value {
        input: FORMAT,
        name: "date",
        value: plain(value),
        expected: "a text, such as 2026-05-01",
    };
    value.as_str().map(str::to_owned).ok_or_else(wrong)
}

fn plain(value: &Value) -> String {
    value.as_str().map_or_else(|| value.to_string(), str::to_owned)
}

/// Letters that stand as question marks on the pages.
pub(super) fn letters_replaced(missing: &BTreeSet<char>) -> Option<NoteReport> {
    (!missing.is_empty()).then(|| {
        let shown: String = missing.iter().take(20).collect();
        NoteReport {
            code: "letters-replaced".into(),
            count: missing.len(),
            message: format!(
                "the fonts of PDF files do not have {shown}: question marks stand in their place on the pages; the file's own title has them"
            ), remedies: Vec::new() }
    })
}
