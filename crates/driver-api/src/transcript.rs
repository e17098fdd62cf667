//! Conversations with a machine as text files, and the runner that holds a driver to them.
//!
//! A file says what the machine sends, what the driver is asked to do, and when; and it says everything
//! that the driver sends and reports. Whatever is left out, added or different is an error that names file
//! and line. The runner owns the clock, so that a minute of waiting takes no time. The notation is in
//! `tests/drivers/README.md`.
//!
//! A driver keeps its side of the conversation as a value without a port and without a clock, implements
//! [`Conversation`] for it, and has one test:
//!
//! ```text
//! let ran = transcript::run_folder(Path::new(FOLDER), |settings| MyConversation::new(settings));
//! assert!(ran.is_ok(), "{}", transcript::told(&ran));
//! ```

mod notation;
mod runner;
#[cfg(test)]
mod tests;

use std::fs;
use std::path::{Path, PathBuf};
use std::time::Duration;

use serde_json::Value;

use crate::{ArmedReply, Call, DriverError, Event, Sent};
use notation::Script;

/// The extension of a transcript's file name.
pub const EXTENSION: &str = "transcript";

/// A driver's side of the conversation with a machine: no port, no clock, no waiting.
///
/// `now` is the time since the port was opened. It never goes back.
pub trait Conversation {
    /// Bytes have come from the machine.
    fn receive(&mut self, bytes: &[u8], now: Duration);

    /// Time has passed. Called often, at least once for each millisecond of a transcript.
    fn pass(&mut self, now: Duration);

    /// The port is gone, as when a cable is pulled.
    fn unplugged(&mut self, now: Duration);

    /// A call of the program. Opening and closing the port are not asked here, but where a transcript begins
    /// with a `connect` that has a token in `resume`.
    ///
    /// # Errors
    /// [`DriverError`] when the call is refused.
    fn call(&mut self, call: &Call, now: Duration) -> Result<Answered, DriverError>;

    /// Takes the bytes that are to be sent to the machine.
    fn take_output(&mut self) -> Vec<u8>;

    /// Takes the next event.
    fn next_event(&mut self) -> Option<Event>;
}

/// What a call is answered.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Answered {
    /// That it was taken: `{}`.
    Taken,
    /// What became of `send`.
    Sent(Sent),
    /// What became of `arm`.
    Armed(ArmedReply),
}

/// Where in a transcript.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Place {
    /// Name of the file.
    pub file: String,
    /// Line, from 1.
    pub line: usize,
}

impl std::fmt::Display for Place {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}:{}", self.file, self.line)
    }
}

/// Why a transcript is not what happened.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum TranscriptError {
    /// The folder or a file cannot be read.
    #[error("{path}: cannot be read: {reason}")]
    Unreadable {
        /// Which.
        path: String,
        /// Why.
        reason: String,
    },
    /// There is nothing to run.
    #[error("{path}: no file ends on .{EXTENSION}; write at least one")]
    NoTranscript {
        /// The folder.
        path: String,
    },
    /// A line is not in the notation.
    #[error("{place}: {what}")]
    Notation {
        /// Where.
        place: Place,
        /// What is wrong and what was expected.
        what: String,
    },
    /// A file in which the driver neither sends nor reports anything.
    #[error("{file}: expects nothing of the driver; say what it sends and reports")]
    ExpectsNothing {
        /// Which.
        file: String,
    },
    /// The driver does not take the settings of the file.
    #[error("{file}: its settings are refused: {error}")]
    Settings {
        /// Which.
        file: String,
        /// Why.
        error: DriverError,
    },
    /// The driver did not send what it should have, or something else.
    #[error("{place}: the driver should send \"{expected}\", and {}", sent_instead(.sent))]
    NotSent {
        /// Where.
        place: Place,
        /// What the transcript has, escaped.
        expected: String,
        /// What was sent, escaped; empty when nothing was.
        sent: String,
    },
    /// The driver sent something that the transcript does not have.
    #[error("{place}: before this line the driver sent \"{sent}\", which the transcript does not have")]
    SentMore {
        /// Where: the first line at which it should have been over.
        place: Place,
        /// What was sent, escaped.
        sent: String,
    },
    /// The driver did not report what it should have, or something else.
    #[error("{place}: the driver should report {expected}, and {}", reported_instead(.reported))]
    NotReported {
        /// Where.
        place: Place,
        /// What the transcript has.
        expected: String,
        /// What was reported; empty when nothing was.
        reported: String,
    },
    /// The driver reported something that the transcript does not have.
    #[error("{place}: before this line the driver reported {reported}, which the transcript does not have")]
    ReportedMore {
        /// Where: the first line at which it should have been over.
        place: Place,
        /// What was reported.
        reported: String,
    },
    /// The answer to a call is another one.
    #[error("{place}: the call should be answered with {expected}, and was with {answer}")]
    Answer {
        /// Where.
        place: Place,
        /// What the transcript has.
        expected: String,
        /// What came.
        answer: String,
    },
}

fn sent_instead(sent: &str) -> String {
    if sent.is_empty() { "sent nothing".to_owned() } else { format!("sent \"{sent}\"") }
}

fn reported_instead(reported: &str) -> String {
    if reported.is_empty() { "reported nothing".to_owned() } else { format!("reported {reported}") }
}

/// Runs a transcript whose text is at hand; `file` is what errors call it. `make` gives the driver's side,
/// at the moment at which the port has been opened, from the settings of the file (`{}` when it has none).
///
/// # Errors
/// [`TranscriptError`] for the first line that does not fit.
pub fn run_text<C: Conversation>(
    file: &str,
    text: &str,
    make: impl FnOnce(Value) -> Result<C, DriverError>,
) -> Result<(), TranscriptError> {
    let script = Script::parse(file, text)?;
    let conversation = make(script.settings.clone())
        .map_err(|error| TranscriptError::Settings { file: file.to_owned(), error })?;
    runner::run(&script, conversation)
}

/// Runs every transcript of a folder, in the order of their names, and gives the names.
///
/// # Errors
/// What is wrong with each file that does not pass; [`TranscriptError::NoTranscript`] for a folder without
/// any.
pub fn run_folder<C: Conversation>(
    folder: &Path,
    mut make: impl FnMut(Value) -> Result<C, DriverError>,
) -> Result<Vec<String>, Vec<TranscriptError>> {
    let path = folder.display().to_string();
    let files = listed(folder).map_err(|error| vec![unreadable(folder, &error)])?;
    if files.is_empty() {
        return Err(vec![TranscriptError::NoTranscript { path }]);
    }
    let (mut passed, mut failed) = (Vec::new(), Vec::new());
    for file in files {
        let name = file.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let text = fs::read_to_string(&file).map_err(|error| unreadable(&file, &error));
        match text.and_then(|text| run_text(&name, &text, &mut make)) {
            Ok(()) => passed.push(name),
            Err(error) => failed.push(error),
        }
    }
    if failed.is_empty() { Ok(passed) } else { Err(failed) }
}

/// What became of a folder, one line a file, for the message of a test.
#[must_use]
pub fn told(ran: &Result<Vec<String>, Vec<TranscriptError>>) -> String {
    let lines: Vec<String> = match ran {
        Ok(passed) => passed.iter().map(|name| format!("{name}: passed")).collect(),
        Err(failed) => failed.iter().map(ToString::to_string).collect(),
    };
    lines.join("\n")
}

fn listed(folder: &Path) -> std::io::Result<Vec<PathBuf>> {
    let entries = fs::read_dir(folder)?.map(|entry| entry.map(|entry| entry.path()));
    let mut files = entries.collect::<std::io::Result<Vec<_>>>()?;
    files.retain(|file| file.extension().is_some_and(|extension| extension == EXTENSION));
    files.sort();
    Ok(files)
}

fn unreadable(path: &Path, error: &std::io::Error) -> TranscriptError {
    TranscriptError::Unreadable { path: path.display().to_string(), reason: error.to_string() }
}
