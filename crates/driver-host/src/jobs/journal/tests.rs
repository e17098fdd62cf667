//! The journal of a wire. What can happen to its file, `wirebend-journal` tries.

use std::fs;
use std::path::PathBuf;

use tempfile::TempDir;
use wirebend_driver_api::Step;
use wirebend_error::ErrorRemedy;

use super::super::entry::{ToldBy, VERSION};
use super::*;
use crate::jobs::JobState;

fn heading() -> Heading {
    Heading { job_hash: "5a".repeat(32), name: "cube \"é\"\n".into(), steps: 4, ..Heading::default() }
}

fn entry(what: EntryKind) -> Entry {
    Entry { at: "2026-05-01T09:30:00Z".into(), what }
}

/// All of a wire, with everything that can happen to one.
fn story() -> Vec<EntryKind> {
    let error = wirebend_driver_api::DriverError::new("unplugged", "the port is gone", "plug it in");
    vec![
        EntryKind::Connected { identity: "kit 1.0".into(), resume: None },
        EntryKind::Armed { token: Some("17".into()), after: 0, resumed: false },
        EntryKind::Intent { from: 1, to: 3 },
        EntryKind::Accepted { n: 3 },
        EntryKind::Done { n: 1 },
        EntryKind::Paused,
        EntryKind::Resumed,
        EntryKind::Fault { error: error.clone(), in_doubt: None },
        EntryKind::Stopped { by: None },
        EntryKind::Standstill { confirmed: false },
        EntryKind::Connected { identity: "kit 1.0".into(), resume: None },
        EntryKind::Decided { n: 2, made: true },
        EntryKind::Decided { n: 3, made: true },
        EntryKind::TakenBack { n: 3 },
        EntryKind::Decided { n: 3, made: false },
        EntryKind::Armed { token: None, after: 2, resumed: false },
        EntryKind::Intent { from: 3, to: 4 },
        EntryKind::PartMade { n: 3, made: Some(Step { feed_mm: 4.25, ..Step::default() }), exact: false },
        EntryKind::Stopped { by: None },
        EntryKind::Part { n: 3, feed_mm: 4.25, rotate_deg: 0.0, by: ToldBy::Person },
        EntryKind::Armed { token: None, after: 2, resumed: false },
        EntryKind::Intent { from: 3, to: 4 },
        // Those after the one that it names were not begun.
        EntryKind::Fault { error, in_doubt: Some(3) },
        EntryKind::Decided { n: 3, made: false },
        EntryKind::Armed { token: None, after: 2, resumed: false },
        EntryKind::Intent { from: 3, to: 4 },
        EntryKind::Done { n: 3 },
        EntryKind::Done { n: 4 },
        EntryKind::Made { corners_mm: vec![[0.1, -2.5, 1e-9]], deviations_mm: Some(vec![0.25]) },
        EntryKind::Finished,
    ]
}

fn written(count: usize) -> (TempDir, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("wire-0.journal");
    let mut journal = Journal::create(&path, heading(), entry(EntryKind::Finished).at).unwrap();
    for what in story().into_iter().take(count) {
        journal.add(entry(what)).unwrap();
    }
    (folder, path)
}

#[test]
fn what_is_written_is_read() {
    let (_folder, path) = written(usize::MAX);
    let read = Journal::read(&path).unwrap();
    let whats: Vec<_> = read.entries.iter().skip(1).map(|entry| entry.what.clone()).collect();
    assert_eq!(whats, story());
    assert!(!read.torn);
    assert_eq!((read.state.done, read.state.standing), (4, JobState::Finished));
    assert_eq!(read.state.heading, Heading { version: VERSION, ..heading() });
    // Other programs can read it, too: every line is JSON.
    for line in String::from_utf8(fs::read(path).unwrap()).unwrap().lines() {
        let line: serde_json::Value = serde_json::from_str(line).unwrap();
        assert!(line["entry"]["record"].is_string(), "{line}");
    }
}

#[test]
fn two_processes_do_not_make_the_same_wire() {
    let (_folder, path) = written(2);
    let first = Journal::open(&path).unwrap();
    assert!(matches!(Journal::open(&path), Err(JournalError::InUse { .. })));
    assert!(matches!(Journal::create(&path, heading(), String::new()), Err(JournalError::Exists { .. })));
    assert_eq!(Journal::read(&path).unwrap().entries.len(), 3, "reading alone is allowed");
    drop(first);
    Journal::open(&path).unwrap();
}

#[test]
fn what_contradicts_the_journal_is_not_written() {
    let (_folder, path) = written(2);
    let mut journal = Journal::open(&path).unwrap();
    let before = fs::read(&path).unwrap();
    let error = journal.add(entry(EntryKind::Done { n: 1 })).unwrap_err();
    assert!(matches!(error, JournalError::Impossible { .. }), "{error}");
    assert_eq!(fs::read(&path).unwrap(), before);
}

#[test]
fn a_journal_of_a_later_program_is_left_alone() {
    let (_folder, path) = written(0);
    let later = entry(EntryKind::Job(Heading { version: VERSION + 1, ..heading() }));
    fs::remove_file(&path).unwrap();
    Log::create(&path, &body(&later).unwrap()).unwrap();
    let error = Journal::open(&path).unwrap_err();
    assert!(error.to_string().contains(&format!("version {}", VERSION + 1)), "{error}");
    assert_eq!(error.remedies(), [ErrorRemedy::UpdateProgram]);
}

/// A line whose hash fits and whose entry makes no sense is named as well.
#[test]
fn an_entry_that_is_none_is_named_with_its_line() {
    let (_folder, path) = written(1);
    let (mut log, _) = Log::open(&path).unwrap();
    log.add(r#"{"record":"of-another-program"}"#).unwrap();
    drop(log);
    let error = Journal::read(&path).unwrap_err();
    assert!(matches!(error, JournalError::Damaged { line: 3, .. }), "{error}");
}
