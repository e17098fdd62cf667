//! A journal after whatever can happen to a file.

use std::path::PathBuf;
use std::sync::OnceLock;

use proptest::prelude::*;
use tempfile::TempDir;

use super::*;
use crate::jobs::Standing;

fn heading() -> Heading {
    Heading { job_hash: "5a".repeat(32), name: "cube \"é\"\n".into(), steps: 4, ..Heading::default() }
}

fn entry(what: What) -> Entry {
    Entry { at: "2026-05-01T09:30:00Z".into(), what }
}

/// All of a wire, with everything that can happen to one.
fn story() -> Vec<What> {
    let error = wirebend_driver_api::DriverError::new("unplugged", "the port is gone", "plug it in");
    vec![
        What::Connected { identity: "kit 1.0".into(), going_on: None },
        What::Armed { token: Some("17".into()), after: 0, going_on: false },
        What::Intent { from: 1, to: 3 },
        What::Accepted { n: 3 },
        What::Done { n: 1 },
        What::Paused,
        What::Resumed,
        What::Fault { error, in_doubt: Some(2) },
        What::Connected { identity: "kit 1.0".into(), going_on: None },
        What::Decided { n: 2, made: true },
        What::Decided { n: 3, made: false },
        What::Armed { token: None, after: 2, going_on: false },
        What::Intent { from: 3, to: 4 },
        What::Done { n: 3 },
        What::Done { n: 4 },
        What::Made { corners_mm: vec![[0.1, -2.5, 1e-9]], deviations_mm: Some(vec![0.25]) },
        What::Finished,
    ]
}

fn written(count: usize) -> (TempDir, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("wire-0.journal");
    let mut journal = Journal::create(&path, heading(), entry(What::Finished).at).unwrap();
    for what in story().into_iter().take(count) {
        journal.add(entry(what)).unwrap();
    }
    (folder, path)
}

/// How many lines have their end.
fn lines_in(bytes: &[u8]) -> usize {
    bytes.split(|byte| *byte == b'\n').count() - 1
}

fn whole() -> Vec<u8> {
    let (_folder, path) = written(usize::MAX);
    fs::read(path).unwrap()
}

#[test]
fn what_is_written_is_read() {
    let (_folder, path) = written(usize::MAX);
    let read = Journal::read(&path).unwrap();
    let whats: Vec<_> = read.entries.iter().skip(1).map(|entry| entry.what.clone()).collect();
    assert_eq!(whats, story());
    assert!(!read.torn);
    assert_eq!((read.account.done, read.account.standing), (4, Standing::Finished));
    assert_eq!(read.account.heading, Heading { version: 1, ..heading() });
    // Other programs can read it, too: every line is JSON.
    for line in String::from_utf8(fs::read(path).unwrap()).unwrap().lines() {
        let line: serde_json::Value = serde_json::from_str(line).unwrap();
        assert!(line["entry"]["record"].is_string(), "{line}");
    }
}

/// The power goes at any byte. What is whole counts, the rest does not, and the journal goes on.
#[test]
fn a_last_line_that_was_cut_off_counts_for_nothing() {
    let (bytes, (_folder, path)) = (whole(), written(0));
    for cut in 0..bytes.len() {
        let lines = lines_in(&bytes[..cut]);
        let count = reading::read(&bytes[..cut]).map_or(0, |read| read.entries.len());
        assert_eq!(count, lines, "{cut}");
        // The disk takes its time: around the ends of lines is enough.
        if cut > 40 && !bytes[cut - 2..(cut + 2).min(bytes.len())].contains(&b'\n') {
            continue;
        }
        fs::write(&path, &bytes[..cut]).unwrap();
        if lines == 0 {
            assert!(matches!(Journal::open(&path), Err(JournalError::Empty { .. })), "{cut}");
            continue;
        }
        let mut journal = Journal::open(&path).unwrap();
        assert_eq!(journal.entries().len(), lines, "{cut}");
        if !journal.account().is_over() {
            journal.add(entry(What::Abandoned)).unwrap();
        }
        drop(journal);
        let read = Journal::read(&path).unwrap();
        assert!(read.account.is_over() && !read.torn, "{cut}");
    }
}

/// A file that was made longer and never filled, as some file systems leave one.
#[test]
fn zeros_at_the_end_are_a_line_that_was_cut_off() {
    let (folder, path) = written(3);
    let before = fs::read(&path).unwrap();
    for tail in [&b"\0\0\0\0"[..], b"\0\0\0\n", b"{\"line\":5,\0\0\0\0\0\0\n"] {
        fs::write(&path, [&before[..], tail].concat()).unwrap();
        let read = Journal::read(&path).unwrap();
        assert_eq!((read.torn, read.entries.len()), (true, 4), "{tail:?}");
    }
    // In the middle they are damage.
    fs::write(&path, [&b"\0\0\n"[..], &before].concat()).unwrap();
    assert!(matches!(Journal::read(&path), Err(JournalError::Damaged { line: 1, .. })));
    drop(folder);
}

/// Written once: each line goes to the disk.
static WHOLE: OnceLock<Vec<u8>> = OnceLock::new();

proptest! {
    /// Whatever is changed in a whole line is seen, and the line is named.
    #[test]
    fn damage_is_seen_and_its_line_named(at in 0_usize..10_000, bit in 0_u32..8) {
        let bytes = WHOLE.get_or_init(whole);
        let at = at % (bytes.len() - 1);
        let mut damaged = bytes.clone();
        damaged[at] ^= 1 << bit;
        let line = 1 + lines_in(&bytes[..at]);
        match reading::read(&damaged) {
            Err(Some((found, _))) => prop_assert_eq!(found, line),
            // A last line whose bytes became zeros, or that lost its end, was never finished.
            Ok(read) => prop_assert!(read.torn && line == story().len() + 1, "{line}"),
            Err(None) => prop_assert!(false, "nothing is left of it"),
        }
    }

    #[test]
    fn any_bytes_are_a_journal_or_an_error(bytes: Vec<u8>) {
        let _ = reading::read(&bytes);
    }
}

#[test]
fn a_line_that_is_missing_is_seen() {
    let (bytes, (_folder, path)) = (String::from_utf8(whole()).unwrap(), written(0));
    let lines: Vec<&str> = bytes.lines().collect();
    for missing in 0..lines.len() - 1 {
        let mut left = lines.clone();
        left.remove(missing);
        fs::write(&path, left.join("\n") + "\n").unwrap();
        let error = Journal::read(&path).unwrap_err();
        assert!(matches!(error, JournalError::Damaged { line, .. } if line == missing + 1), "{error}");
    }
}

#[test]
fn two_processes_do_not_make_the_same_wire() {
    let (_folder, path) = written(2);
    let first = Journal::open(&path).unwrap();
    assert!(matches!(Journal::open(&path), Err(JournalError::InUse { .. })));
    assert!(matches!(Journal::create(&path, heading(), String::new()), Err(JournalError::Exists { .. })));
    assert_eq!(Journal::read(&path).unwrap().entries.len(), 3, "whoever only looks may");
    drop(first);
    Journal::open(&path).unwrap();
}

#[test]
fn what_contradicts_the_journal_is_not_written() {
    let (_folder, path) = written(2);
    let mut journal = Journal::open(&path).unwrap();
    let before = fs::read(&path).unwrap();
    let error = journal.add(entry(What::Done { n: 1 })).unwrap_err();
    assert!(matches!(error, JournalError::Impossible { .. }), "{error}");
    assert_eq!(fs::read(&path).unwrap(), before);
}

#[test]
fn a_journal_of_a_later_program_is_left_alone() {
    let (_folder, path) = written(0);
    let later = entry(What::Job(Heading { version: 2, ..heading() }));
    let (line, _) = line::Chain::default().line(&body(&later).unwrap());
    fs::write(&path, line).unwrap();
    let error = Journal::open(&path).unwrap_err().to_string();
    assert!(error.contains("version 2") && error.contains("update"), "{error}");
}

/// A disk that is full: what was not written is not said to be.
#[cfg(target_os = "linux")]
#[test]
fn a_journal_that_cannot_be_written_stays_so() {
    let (_folder, path) = written(2);
    let mut journal = Journal::open(&path).unwrap();
    journal.file = OpenOptions::new().write(true).open("/dev/full").unwrap();
    let intent = || entry(What::Intent { from: 1, to: 1 });
    assert!(matches!(journal.add(intent()), Err(JournalError::Io { .. })));
    assert_eq!(journal.account().sent, 0);
    assert!(matches!(journal.add(intent()), Err(JournalError::Broken { .. })));
}
