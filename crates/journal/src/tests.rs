//! A log after whatever can happen to a file.

use std::fs::{self, OpenOptions};
use std::path::PathBuf;
use std::sync::OnceLock;

use proptest::prelude::*;
use tempfile::TempDir;

use crate::{Lines, Log, LogError};

/// Some JSON as people's names make it.
const ENTRIES: [&str; 6] =
    [r#"{"name":"cube \"é\"\n"}"#, "1", "[]", r#"{"at":0.1}"#, r#""}""#, r#"{"x":{"entry":1}}"#];

fn written(count: usize) -> (TempDir, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.journal");
    let mut log = Log::create(&path, ENTRIES[0]).unwrap();
    for entry in ENTRIES.iter().take(count).skip(1) {
        log.add(entry).unwrap();
    }
    (folder, path)
}

/// How many lines have their end.
fn lines_in(bytes: &[u8]) -> usize {
    bytes.split(|byte| *byte == b'\n').count() - 1
}

/// Written once: each line goes to the disk.
fn whole() -> &'static [u8] {
    static WHOLE: OnceLock<Vec<u8>> = OnceLock::new();
    WHOLE.get_or_init(|| {
        let (_folder, path) = written(ENTRIES.len());
        fs::read(path).unwrap()
    })
}

#[test]
fn what_is_written_is_read() {
    let (_folder, path) = written(ENTRIES.len());
    let read = Log::read(&path).unwrap();
    assert_eq!((&read.entries[..], read.torn), (&ENTRIES.map(str::to_owned)[..], false));
    let (log, again) = Log::open(&path).unwrap();
    assert_eq!((again, log.length()), (read, whole().len() as u64));
}

/// The power goes at any byte. What is whole counts, the rest does not, and the log continues.
#[test]
fn a_last_line_that_was_cut_off_counts_for_nothing() {
    let (_folder, path) = written(1);
    for cut in 0..whole().len() {
        let bytes = &whole()[..cut];
        let lines = lines_in(bytes);
        assert_eq!(Lines::of(bytes).map_or(0, |read| read.entries.len()), lines, "{cut}");
        // The disk takes its time: around the ends of lines is enough.
        if cut > 40 && !whole()[cut - 2..(cut + 2).min(whole().len())].contains(&b'\n') {
            continue;
        }
        fs::write(&path, bytes).unwrap();
        if lines == 0 {
            assert!(matches!(Log::open(&path), Err(LogError::Empty { .. })), "{cut}");
            continue;
        }
        let (mut log, _) = Log::open(&path).unwrap();
        log.add("2").unwrap();
        drop(log);
        let read = Log::read(&path).unwrap();
        assert_eq!((read.entries.len(), read.torn), (lines + 1, false), "{cut}");
    }
}

/// A file that was made longer and never filled, as some file systems leave one.
#[test]
fn zeros_at_the_end_are_a_line_that_was_cut_off() {
    for tail in [&b"\0\0\0\0"[..], b"\0\0\0\n", b"{\"line\":7,\0\0\0\0\0\0\n"] {
        let read = Lines::of(&[whole(), tail].concat()).unwrap();
        assert_eq!((read.torn, read.entries.len()), (true, ENTRIES.len()), "{tail:?}");
    }
    // In the middle they are damage.
    assert!(matches!(Lines::of(&[&b"\0\0\n"[..], whole()].concat()), Err(Some((1, _)))));
}

proptest! {
    /// Whatever is changed in a whole line is seen, and the line is named.
    #[test]
    fn damage_is_seen_and_its_line_named(at in 0_usize..10_000, bit in 0_u32..8) {
        let at = at % (whole().len() - 1);
        let mut damaged = whole().to_vec();
        damaged[at] ^= 1 << bit;
        let line = 1 + lines_in(&whole()[..at]);
        match Lines::of(&damaged) {
            Err(Some((found, _))) => prop_assert_eq!(found, line),
            // A last line whose bytes became zeros, or that lost its end, was never finished.
            Ok(read) => prop_assert!(read.torn && line == ENTRIES.len(), "{line}"),
            Err(None) => prop_assert!(false, "nothing is left of it"),
        }
    }

    #[test]
    fn any_bytes_are_a_log_or_an_error(bytes: Vec<u8>) {
        let _ = Lines::of(&bytes);
    }
}

#[test]
fn a_line_that_is_missing_is_seen() {
    let text = String::from_utf8(whole().to_vec()).unwrap();
    let lines: Vec<&str> = text.lines().collect();
    for missing in 0..lines.len() - 1 {
        let mut left = lines.clone();
        left.remove(missing);
        let (found, _) = Lines::of((left.join("\n") + "\n").as_bytes()).unwrap_err().unwrap();
        assert_eq!(found, missing + 1);
    }
}

#[test]
fn two_do_not_write_the_same_log() {
    let (_folder, path) = written(2);
    assert!(!Log::is_in_use(&path));
    let (first, _) = Log::open(&path).unwrap();
    assert!(Log::is_in_use(&path));
    assert!(matches!(Log::open(&path), Err(LogError::InUse { .. })));
    assert!(matches!(Log::create(&path, "1"), Err(LogError::Exists { .. })));
    assert_eq!(Log::read(&path).unwrap().entries.len(), 2, "reading alone is allowed");
    drop(first);
    assert!(!Log::is_in_use(&path));
    Log::open(&path).unwrap();
}

/// A disk that is full: what was not written is not said to be.
#[cfg(target_os = "linux")]
#[test]
fn a_log_that_cannot_be_written_stays_so() {
    let (_folder, path) = written(2);
    let (mut log, _) = Log::open(&path).unwrap();
    let length = log.length();
    log.file = OpenOptions::new().write(true).open("/dev/full").unwrap();
    assert!(matches!(log.add("1"), Err(LogError::Io { .. })));
    assert!(matches!(log.add("1"), Err(LogError::Broken { .. })));
    assert_eq!(log.length(), length);
}
