//! What a driver writes.

use serde_json::Value;
use wirebend_driver_host::api::{self, Files, FormatDescription, Limits};
use wirebend_driver_host::{Driver, HostError};

use super::ExportRequest;
use super::content::{Content, Wire};
use crate::job::job;
use crate::report::NoteReport;
use crate::{DriverProblem, PlanningError};

/// The files of a format. Settings are those of the machine's profile when the driver is the machine's,
/// and over them those that were asked for.
pub(super) fn encode(
    content: &mut Content,
    driver: Driver,
    format: &FormatDescription,
    request: &ExportRequest,
) -> Result<Vec<Vec<u8>>, PlanningError> {
    let profile = &content.setup.machine.profile.driver;
    let id = driver.description().id.clone();
    let mut settings =
        profile.settings.clone().filter(|_| profile.id.as_ref() == Some(&id)).unwrap_or_default();
    settings.extend(request.settings.clone());
    let open = driver.open(&Value::Object(settings)).map_err(|error| match error {
        HostError::Refused { driver, error } => DriverProblem::Settings { driver, error },
        other => DriverProblem::Host(other),
    })?;
    // A design was checked within them; a job was planned before.
    if content.job_hash.is_some() && !request.despite_errors {
        require_within(content, &open.limits()?)?;
    }
    let format_id = format.id.clone();
    let encoded = open.encode(&format.id, of(content)).map_err(|error| match error {
        HostError::Refused { driver, error } => DriverProblem::Unwritten { driver, format: format_id, error },
        other => DriverProblem::Host(other),
    })?;
    // What was written is here; a driver that cannot close is ended anyway.
    if let Err(error) = open.close() {
        tracing::warn!("{error}");
    }
    let expected = if format.files == Files::One { 1 } else { content.wires.len() };
    if encoded.files.len() != expected {
        let reason =
            format!("{} files of {} wires, not {expected}", encoded.files.len(), content.wires.len());
        return Err(HostError::Broken { driver: id, during: "the job", reason }.into());
    }
    let note = |note: api::Note| NoteReport {
        code: note.code.into(),
        count: note.count,
        message: note.message,
        remedies: Vec::new(),
    };
    content.notes.extend(encoded.notes.into_iter().map(note));
    Ok(encoded.files.into_iter().map(|file| file.text.into_bytes()).collect())
}

/// Refuses a wire that is beyond what the driver takes.
fn require_within(content: &Content, limits: &Limits) -> Result<(), PlanningError> {
    for (index, wire) in content.wires.iter().enumerate() {
        let signs = content.setup.signs;
        let steps: Vec<_> = wire.compensated.iter().flatten().map(|told| signs.machine(told.step)).collect();
        DriverProblem::require_within(limits, "its driver", index, &steps, 1)?;
    }
    Ok(())
}

fn of(content: &Content) -> api::Job {
    let Content { setup, title, design_hash, job_hash, wires, .. } = content;
    job(setup, title, job_hash.clone(), design_hash, wires.iter().map(Wire::stages))
}
