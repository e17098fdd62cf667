//! The record of a head: a small file for each machine at a port, beside the journals. Opening a port resets many boards, and
//! they forget where their head stands.

use std::fs;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};
use wirebend_driver_host::jobs::{Clock, SystemClock};
use wirebend_driver_host::{HeadKeeper, HeadPlace};
use wirebend_files::document::{save_atomically, sha256_hex};

use super::HeadSource;

/// What the file says that it is.
const FORMAT: &str = "wbhead";
const VERSION: u32 = 1;
const EXTENSION: &str = "wbhead";
/// How much of the hash of a port is in the name of its file.
const HASH_DIGITS: usize = 12;

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct Record {
    format: String,
    version: u32,
    machine: String,
    port: String,
    /// When it was written, as journals write it.
    at: String,
    /// Where the head stands, degrees from where its cable is unwound, in the machine's signs: the same twice where it is
    /// known.
    between_deg: [f64; 2],
}

/// What was kept of a head.
#[derive(Debug, Clone, PartialEq)]
pub struct HeadRecord {
    pub place: HeadPlace,
    pub source: Option<HeadSource>,
}

/// Keeps it.
#[derive(Debug)]
pub struct Keeper {
    path: PathBuf,
    machine: String,
    port: String,
}

fn folder(runs: &Path) -> PathBuf {
    runs.join("heads")
}

fn path(runs: &Path, machine: &str, port: &str) -> PathBuf {
    let hash = sha256_hex(port.as_bytes());
    let hash = hash.get(..HASH_DIGITS).unwrap_or(&hash);
    folder(runs).join(format!("{machine}-{hash}.{EXTENSION}"))
}

impl Keeper {
    pub fn new(runs: &Path, machine: &str, port: &str) -> Self {
        Self { path: path(runs, machine, port), machine: machine.to_owned(), port: port.to_owned() }
    }
}

impl HeadKeeper for Keeper {
    fn keep(&mut self, place: HeadPlace) -> Result<(), String> {
        let (least, most) = place.range();
        let record = Record {
            format: FORMAT.to_owned(),
            version: VERSION,
            machine: self.machine.clone(),
            port: self.port.clone(),
            at: SystemClock::default().stamp(),
            between_deg: [least, most],
        };
        if let Some(folder) = self.path.parent() {
            let failed = |cause| format!("the folder {} cannot be created: {cause}", folder.display());
            fs::create_dir_all(folder).map_err(failed)?;
        }
        let mut bytes = serde_json::to_vec_pretty(&record).map_err(|error| error.to_string())?;
        bytes.push(b'\n');
        save_atomically(&self.path, &bytes).map_err(|error| error.to_string())
    }
}

impl Record {
    /// What a file says; `None` where it says nothing that can be believed.
    fn open(path: &Path) -> Option<Self> {
        let record: Self = serde_json::from_slice(&fs::read(path).ok()?).ok()?;
        let [least, most] = record.between_deg;
        let sound = record.format == FORMAT && record.version == VERSION && least <= most;
        (sound && least.is_finite() && most.is_finite()).then_some(record)
    }

    fn place(&self) -> HeadPlace {
        let [least, most] = self.between_deg;
        // It was written as one number where it was known.
        if least.to_bits() == most.to_bits() { HeadPlace::At(least) } else { HeadPlace::Between(least, most) }
    }
}

/// What was kept of a machine at a port; `limits`: how far its cable lets the head turn, in the machine's signs. The same machine may have had another port before: `is_there` says of ports that
/// are there now, at which there is another one.
pub fn read(
    runs: &Path,
    machine: &str,
    port: &str,
    limits: [f64; 2],
    is_there: impl Fn(&str) -> bool,
) -> HeadRecord {
    let mine = path(runs, machine, port);
    let own = Record::open(&mine);
    if own.is_none() && mine.exists() {
        let [least, most] = limits;
        return HeadRecord {
            place: HeadPlace::Between(least, most),
            source: Some(HeadSource::Damaged { path: mine }),
        };
    }
    let files =
        fs::read_dir(folder(runs)).into_iter().flatten().filter_map(Result::ok).map(|entry| entry.path());
    let others = files.filter(|path| path.extension().is_some_and(|e| e == EXTENSION) && *path != mine);
    let moved = others.filter_map(|path| Record::open(&path)).filter(|other| {
        other.machine == machine
            && !other.place().is_zero()
            && own.as_ref().is_none_or(|own| own.at < other.at)
            && !is_there(&other.port)
    });
    let Some(other) = moved.max_by(|a, b| a.at.cmp(&b.at)) else {
        let place = own.as_ref().map_or(HeadPlace::Unsaid, Record::place);
        return HeadRecord { place, source: own.map(|own| HeadSource::Recorded { at: own.at }) };
    };
    // It cannot be known whether it is this one or another.
    let (here, there) = (own.as_ref().map_or((0.0, 0.0), |own| own.place().range()), other.place().range());
    let place = HeadPlace::Between(here.0.min(there.0), here.1.max(there.1));
    HeadRecord { place, source: Some(HeadSource::OtherPort { at: other.at, port: other.port }) }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LIMITS: [f64; 2] = [-360.0, 360.0];

    fn keep(runs: &Path, port: &str, place: HeadPlace) {
        Keeper::new(runs, "kit", port).keep(place).unwrap();
    }

    fn place(runs: &Path, port: &str, there: &[&str]) -> HeadPlace {
        read(runs, "kit", port, LIMITS, |port| there.contains(&port)).place
    }

    #[test]
    fn what_is_kept_is_read_again() {
        let runs = tempfile::tempdir().unwrap();
        let runs = runs.path();
        assert_eq!(place(runs, "ACM0", &[]), HeadPlace::Unsaid);
        for kept in [HeadPlace::At(90.25), HeadPlace::Between(-90.0, 12.5), HeadPlace::At(0.0)] {
            keep(runs, "ACM0", kept);
            assert_eq!(place(runs, "ACM0", &[]), kept);
        }
        // Another machine's says nothing.
        assert_eq!(read(runs, "other", "ACM0", LIMITS, |_| false).place, HeadPlace::Unsaid);
    }

    /// A board that is plugged in anew may get another name. Were it taken for one that nothing is known of, its cable would
    /// wind on.
    #[test]
    fn a_machine_whose_port_is_gone_may_be_at_another() {
        let runs = tempfile::tempdir().unwrap();
        let runs = runs.path();
        keep(runs, "ACM0", HeadPlace::At(90.0));
        assert_eq!(place(runs, "ACM1", &[]), HeadPlace::Between(0.0, 90.0));
        let source = read(runs, "kit", "ACM1", LIMITS, |_| false).source.unwrap();
        assert!(matches!(&source, HeadSource::OtherPort { port, .. } if port == "ACM0"), "{source}");
        // Two machines at the same time are two.
        assert_eq!(place(runs, "ACM1", &["ACM0", "ACM1"]), HeadPlace::Unsaid);
        // One that stands at zero is no danger, whichever it is.
        keep(runs, "ACM0", HeadPlace::At(0.0));
        assert_eq!(place(runs, "ACM1", &[]), HeadPlace::Unsaid);
    }

    #[test]
    fn of_a_damaged_record_nothing_is_believed() {
        let runs = tempfile::tempdir().unwrap();
        let runs = runs.path();
        keep(runs, "ACM0", HeadPlace::At(0.0));
        for bytes in [
            "",
            "{}",
            r#"{"format":"wbhead","version":1,"machine":"kit","port":"ACM0","at":"","between_deg":[2,1]}"#,
        ] {
            fs::write(path(runs, "kit", "ACM0"), bytes).unwrap();
            assert_eq!(place(runs, "ACM0", &[]), HeadPlace::Between(-360.0, 360.0), "{bytes}");
        }
    }
}
