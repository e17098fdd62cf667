//! The journal of the open design: whatever happens to the program, what was done to the design is on the disk.
//!
//! Its first line is the design as it was opened, each further one a change, an undo, a redo or a saving. It is
//! deleted when the design is closed.

use std::path::{Path, PathBuf};
use std::time::{SystemTime, UNIX_EPOCH};
use std::{fs, io};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::value::RawValue;
use wirebend_error::ProblemReport;
use wirebend_files::document::{Document, DocumentChange};
use wirebend_journal::{Log, LogError};

use super::EditorError;
use super::history::{Done, History};
use wirebend_planning::output::file_name;

/// The version of the format; a journal of a later one is left alone.
const VERSION: u32 = 1;
const EXTENSION: &str = "editing";
/// A journal that has no whole line for so long is not being begun any more, s.
const BEGUN_S: u64 = 60;

/// The first line.
#[derive(Debug, Serialize, Deserialize)]
struct Heading {
    version: u32,
    /// The file that was opened; none for a new design.
    file: Option<PathBuf>,
    /// Its name for people.
    name: String,
    /// The `.wirebend` document, as a text.
    document: String,
}

/// A further line.
#[derive(Debug, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum Line {
    Done {
        label: String,
        change: Box<RawValue>,
    },
    Undone,
    Redone,
    /// All of it is in this file.
    Saved {
        file: PathBuf,
    },
}

/// The journal of a design that is open.
#[derive(Debug)]
pub(super) struct EditJournal {
    log: Log,
    /// What was done before is in it, too. Otherwise it knows nothing of what is undone.
    from_the_first: bool,
}

/// A design that was open when the program or the computer stopped.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Unsaved {
    /// The journal, to open it by.
    pub journal: PathBuf,
    /// What it is called.
    pub name: String,
    /// The file that it is of; null for a new design.
    pub file: Option<PathBuf>,
    /// Changes that no file has.
    pub changes: usize,
    /// When the last was made, in seconds since 1970.
    pub changed_s: u64,
}

/// A design out of its journal.
pub(super) struct Restored {
    pub document: Document,
    pub history: History,
    pub file: Option<PathBuf>,
    pub name: String,
    /// The state that the file has.
    pub saved: u64,
    /// Changes, undone ones included, since the file was saved.
    pub changes: usize,
}

impl EditJournal {
    /// Begins a journal in a folder, which is created where it is missing. `from_the_first`: nothing was done to the document
    /// that can be undone.
    pub fn begin(
        folder: &Path,
        document: &Document,
        file: Option<&Path>,
        name: &str,
        from_the_first: bool,
    ) -> Result<Self, EditorError> {
        fs::create_dir_all(folder)
            .map_err(|cause| EditorError::Folder { folder: folder.to_owned(), cause })?;
        let bytes = document.to_bytes().map_err(EditorError::Document)?;
        let heading = Heading {
            version: VERSION,
            file: file.map(Path::to_owned),
            name: name.to_owned(),
            document: String::from_utf8_lossy(&bytes).into_owned(),
        };
        let first = json(&heading)?;
        let mut number = 0_u32;
        loop {
            let path = folder.join(format!("{}-{number}.{EXTENSION}", std::process::id()));
            match Log::create(&path, &first) {
                Ok(log) => return Ok(Self { log, from_the_first }),
                Err(LogError::Exists { .. }) => number += 1,
                Err(error) => {
                    // Half of a first line would be found at the next start, and is of no use to anybody.
                    let _ = fs::remove_file(&path);
                    return Err(error.into());
                }
            }
        }
    }

    /// Opens a journal that was left behind.
    pub fn reopen(path: &Path) -> Result<(Self, Restored), EditorError> {
        let (log, lines) = Log::open(path)?;
        let restored = replayed(path, &lines.entries)?;
        Ok((Self { log, from_the_first: true }, restored))
    }

    pub fn done(&mut self, done: &Done) -> Result<(), EditorError> {
        let change = done.change.to_json().map_err(EditorError::Unwritten)?;
        let change =
            RawValue::from_string(change).map_err(|error| EditorError::Unwritten(error.to_string()))?;
        self.add(&Line::Done { label: done.label.clone(), change })
    }

    /// The difference that an undo has made.
    pub fn undone(&mut self, made: &Done) -> Result<(), EditorError> {
        if self.from_the_first { self.add(&Line::Undone) } else { self.done(made) }
    }

    /// The difference that was made again.
    pub fn redone(&mut self, made: &Done) -> Result<(), EditorError> {
        if self.from_the_first { self.add(&Line::Redone) } else { self.done(made) }
    }

    pub fn saved(&mut self, file: &Path) -> Result<(), EditorError> {
        self.add(&Line::Saved { file: file.to_owned() })
    }

    fn add(&mut self, line: &Line) -> Result<(), EditorError> {
        Ok(self.log.add(&json(line)?)?)
    }

    /// The folder that it is in.
    pub fn folder(&self) -> Option<&Path> {
        self.log.path().parent()
    }

    /// The design is closed: what is not saved a person has given up.
    pub fn end(self) -> Result<(), EditorError> {
        let path = self.log.path().to_owned();
        match fs::remove_file(&path) {
            Err(cause) if cause.kind() != io::ErrorKind::NotFound => {
                Err(EditorError::Folder { folder: path, cause })
            }
            _ => Ok(()),
        }
    }
}

/// The designs in a folder that were open when the program or the computer stopped, and that no file has; last
/// changed first. Journals of designs that are as their files are deleted; what cannot be read is reported.
pub(super) fn unsaved(folder: &Path) -> (Vec<Unsaved>, Vec<ProblemReport>) {
    let (mut found, mut problems) = (Vec::new(), Vec::new());
    let entries = fs::read_dir(folder).into_iter().flatten().filter_map(Result::ok).map(|entry| entry.path());
    for path in entries.filter(|path| path.extension().is_some_and(|extension| extension == EXTENSION)) {
        match EditJournal::reopen(&path) {
            Ok((keeping, restored)) if restored.history.state() == restored.saved => {
                problems.extend(keeping.end().err().as_ref().map(ProblemReport::from));
            }
            Ok((_, Restored { name, file, changes, .. })) => {
                let changed_s = changed_s(&path);
                found.push(Unsaved { journal: path, name, file, changes, changed_s });
            }
            // It is open elsewhere.
            Err(EditorError::Log(LogError::InUse { .. })) => {}
            // There is nothing in it. Another program may be beginning it.
            Err(EditorError::Log(LogError::Empty { .. }))
                if now_s().saturating_sub(changed_s(&path)) < BEGUN_S => {}
            Err(EditorError::Log(LogError::Empty { .. })) => {
                let removed = fs::remove_file(&path);
                let folder =
                    |cause| ProblemReport::from(&EditorError::Folder { folder: path.clone(), cause });
                problems.extend(removed.err().map(folder));
            }
            // It was closed meanwhile, where it was open.
            Err(_) if !path.exists() => {}
            Err(error) => problems.push(ProblemReport::from(&error)),
        }
    }
    found.sort_by_key(|unsaved| std::cmp::Reverse(unsaved.changed_s));
    (found, problems)
}

fn changed_s(path: &Path) -> u64 {
    seconds(fs::metadata(path).and_then(|about| about.modified()).unwrap_or(UNIX_EPOCH))
}

fn now_s() -> u64 {
    seconds(SystemTime::now())
}

fn seconds(time: SystemTime) -> u64 {
    time.duration_since(UNIX_EPOCH).unwrap_or_default().as_secs()
}

fn replayed(path: &Path, entries: &[String]) -> Result<Restored, EditorError> {
    let damaged =
        |index: usize, what: String| EditorError::Damaged { path: path.to_owned(), line: index + 1, what };
    let parsed = |index: usize, error: serde_json::Error| damaged(index, error.to_string());
    let first = entries.first().map_or("", String::as_str);
    let heading: Heading = serde_json::from_str(first).map_err(|error| parsed(0, error))?;
    if heading.version > VERSION {
        return Err(EditorError::Newer { path: path.to_owned(), version: heading.version, known: VERSION });
    }
    let document =
        Document::open(heading.document.as_bytes(), &heading.name).map_err(EditorError::Document)?;
    let (file, name) = (heading.file, heading.name);
    let mut restored = Restored { document, history: History::default(), file, name, saved: 0, changes: 0 };
    for (index, entry) in entries.iter().enumerate().skip(1) {
        let line: Line = serde_json::from_str(entry).map_err(|error| parsed(index, error))?;
        restored.take(line).map_err(|what| damaged(index, what))?;
    }
    Ok(restored)
}

impl Restored {
    fn take(&mut self, line: Line) -> Result<(), String> {
        let (history, document) = (&mut self.history, &mut self.document);
        self.changes += 1;
        let made = match line {
            Line::Done { label, change } => {
                let change = DocumentChange::of_json(change.get())?;
                history.make(document, Done { label, change })
            }
            Line::Undone => history.undo(document).map(drop),
            Line::Redone => history.redo(document).map(drop),
            Line::Saved { file } => {
                (self.name, self.file) = (file_name(&file), Some(file));
                (self.saved, self.changes) = (history.state(), 0);
                Ok(())
            }
        };
        made.map_err(|stale| stale.to_string())
    }
}

fn json(value: &impl Serialize) -> Result<String, EditorError> {
    serde_json::to_string(value).map_err(|error| EditorError::Unwritten(error.to_string()))
}
