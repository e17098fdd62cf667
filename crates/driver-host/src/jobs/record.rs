//! What was bent of a wire, as a record for later: written beside the journal.

use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_driver_api::DoneBy;

use super::entry::{Entry, EntryKind, Heading, ToldBy};

/// What was bent of a wire.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Record {
    /// What was to be bent, of what, on which machine.
    pub job: Heading,
    /// When it was begun.
    pub started: String,
    /// When it was over; absent while it is not.
    pub ended: Option<String>,
    /// What became of it.
    pub outcome: Outcome,
    /// The last step that is done, or, where the machine does not report that, that has had its time.
    pub made: u32,
    /// Stops and failures, in order.
    pub interruptions: Vec<Interruption>,
    /// What was said of steps that were in doubt, in order.
    pub decisions: Vec<Decision>,
    /// Pause points at which a person has said that the wire goes on, in order.
    #[serde(default)]
    pub pauses: Vec<ConfirmedPause>,
    /// Corners of the wire, where a simulated machine bent it, mm.
    pub corners_mm: Vec<[f64; 3]>,
    /// How far each corner is from the design, mm; absent where that was not measured.
    pub deviations_mm: Option<Vec<f64>>,
}

/// A pause point past which a person has let the wire go on.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct ConfirmedPause {
    pub at: String,
    /// The step after which the machine has waited.
    pub after: u32,
    /// What they had to do there.
    pub note: String,
}

/// What became of a wire.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Outcome {
    Finished,
    /// All of its steps were sent, to a machine that does not report whether it has run them.
    Sent,
    /// A person has given it up.
    Abandoned,
    /// It is not over.
    Unfinished,
}

/// A stop or a failure.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Interruption {
    pub at: String,
    /// The last step that was known to be done.
    pub after: u32,
    /// What happened, for a person.
    pub what: String,
}

/// What was said of a step in doubt: by a person, or by the machine where it had counted how far it was.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Decision {
    pub at: String,
    pub step: u32,
    /// Whether it was done.
    pub made: bool,
    /// How much of it was in the wire, where it was done in part; its rest was done then.
    pub part: Option<PartInWire>,
}

/// How much of a step was in the wire, in the machine's signs.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct PartInWire {
    /// Fed, mm.
    pub feed_mm: f64,
    /// Turned, degrees.
    pub rotate_deg: f64,
    /// Whether the machine or a person has said so.
    pub by: ToldBy,
}

impl Record {
    /// From a journal's entries; `None` when they do not begin with a job.
    #[must_use]
    pub fn of(entries: &[Entry]) -> Option<Self> {
        let (first, rest) = entries.split_first()?;
        let EntryKind::Job(job) = &first.what else { return None };
        let mut record = Self {
            job: job.clone(),
            started: first.at.clone(),
            ended: None,
            outcome: Outcome::Unfinished,
            made: 0,
            interruptions: Vec::new(),
            decisions: Vec::new(),
            pauses: Vec::new(),
            corners_mm: Vec::new(),
            deviations_mm: None,
        };
        let mut before = &first.what;
        for entry in rest {
            record.count(entry, before);
            before = &entry.what;
        }
        Some(record)
    }

    fn count(&mut self, Entry { at, what }: &Entry, before: &EntryKind) {
        match what {
            EntryKind::Done { n } => self.made = *n,
            EntryKind::Decided { n, made } => {
                self.made = if *made { *n } else { self.made };
                self.decisions.push(Decision { at: at.clone(), step: *n, made: *made, part: None });
            }
            EntryKind::Part { n, feed_mm, rotate_deg, by } => {
                let part = PartInWire { feed_mm: *feed_mm, rotate_deg: *rotate_deg, by: *by };
                let part = Some(part);
                self.decisions.push(Decision { at: at.clone(), step: *n, made: false, part });
            }
            EntryKind::TakenBack { n } => {
                if let Some(at) = self.decisions.iter().rposition(|decision| decision.step == *n) {
                    self.made = *n - 1;
                    self.decisions.truncate(at);
                }
            }
            EntryKind::PauseConfirmed { after, note } => {
                self.pauses.push(ConfirmedPause { at: at.clone(), after: *after, note: note.clone() });
            }
            EntryKind::Stopped { .. } => self.interrupted(at, "stopped".to_owned()),
            EntryKind::Fault { error, .. } => self.interrupted(at, error.to_string()),
            EntryKind::Standstill { confirmed: false } => {
                if let Some(last) = self.interruptions.last_mut() {
                    last.what.push_str("; the machine has not confirmed that it stands");
                }
            }
            // What ended without a word: the program itself, or the computer. A program that only asked has begun nothing.
            EntryKind::Connected { .. }
                if !matches!(
                    before,
                    EntryKind::Job(_)
                        | EntryKind::Connected { .. }
                        | EntryKind::Decided { .. }
                        | EntryKind::Part { .. }
                        | EntryKind::TakenBack { .. }
                        | EntryKind::PartMade { .. }
                        | EntryKind::Stopped { .. }
                        | EntryKind::Standstill { .. }
                        | EntryKind::Fault { .. }
                ) =>
            {
                self.interrupted(at, "the program was ended".to_owned());
            }
            EntryKind::Made { corners_mm, deviations_mm } => {
                if !corners_mm.is_empty() {
                    self.corners_mm.clone_from(corners_mm);
                }
                if deviations_mm.is_some() {
                    self.deviations_mm.clone_from(deviations_mm);
                }
            }
            EntryKind::Finished => {
                let outcome = match self.job.done_by {
                    DoneBy::Machine => Outcome::Finished,
                    DoneBy::Clock => Outcome::Sent,
                };
                self.over(at, outcome);
            }
            EntryKind::Abandoned => self.over(at, Outcome::Abandoned),
            _ => {}
        }
    }

    fn interrupted(&mut self, at: &str, what: String) {
        self.interruptions.push(Interruption { at: at.to_owned(), after: self.made, what });
    }

    fn over(&mut self, at: &str, outcome: Outcome) {
        (self.ended, self.outcome) = (Some(at.to_owned()), outcome);
    }

    /// Where the record of a journal is: beside it, with `.record.json` instead of its extension.
    #[must_use]
    pub fn path_beside(journal: &Path) -> PathBuf {
        journal.with_extension("record.json")
    }

    /// Writes it as JSON, over an earlier one of the same wire, in one piece.
    ///
    /// # Errors
    /// When the file cannot be written; an earlier one is as it was.
    pub fn write(&self, path: &Path) -> io::Result<()> {
        let text = serde_json::to_string_pretty(self)? + "\n";
        let new = path.with_extension("new");
        let mut file = File::create(&new)?;
        file.write_all(text.as_bytes())?;
        file.sync_all()?;
        fs::rename(&new, path)
    }

    #[must_use]
    pub fn schema() -> serde_json::Value {
        schemars::schema_for!(Self).to_value()
    }
}
