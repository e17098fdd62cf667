//! For tests and benchmarks: libraries and programs of this workspace that are loaded or started, not
//! linked, so that Cargo does not know that a test needs them. `make built` builds them; a test that misses one, or finds one that
//! is older than its sources, says so.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)] // a test may stop at what cannot be

use std::env::consts::{DLL_PREFIX, DLL_SUFFIX, EXE_SUFFIX};
use std::path::{Path, PathBuf};
use std::time::SystemTime;

/// The library of a driver by its folder in `drivers/`.
///
/// # Panics
/// When it is missing, or older than its sources.
#[must_use]
pub fn driver(folder: &str) -> PathBuf {
    let library = match folder {
        "hostile" | "template" => format!("{folder}_driver"),
        _ => format!("wirebend_driver_{}", folder.replace('-', "_")),
    };
    built(&format!("{DLL_PREFIX}{library}{DLL_SUFFIX}"))
}

/// Puts the misbehaving driver where its name says how it misbehaves. A link: copies for each case would keep the disk so busy that
/// other tests miss their limits.
///
/// # Panics
/// When the folder cannot be written to.
pub fn place_hostile(at: &Path) {
    if !at.exists() {
        let hostile = driver("hostile");
        std::fs::hard_link(&hostile, at).or_else(|_| std::fs::copy(&hostile, at).map(drop)).unwrap();
    }
}

/// The folder of the drivers that ship with the program, all of which are there.
///
/// # Panics
/// When one is not.
#[must_use]
pub fn shipped_drivers() -> PathBuf {
    let built = ["pensa", "tables", "grbl", "howtomechatronics", "wirebend-kit"].map(driver);
    built[0].parent().unwrap().to_owned()
}

/// The smallest program that can be the process of a driver.
///
/// # Panics
/// When it is missing, or older than its sources.
#[must_use]
pub fn driver_child() -> PathBuf {
    built(&format!("wirebend-driver-child{EXE_SUFFIX}"))
}

/// The program of the command line. Libraries of [`driver`] lie beside it, where it looks for them.
///
/// # Panics
/// When it is missing, or older than its sources.
#[must_use]
pub fn wirebend() -> PathBuf {
    built(&format!("wirebend{EXE_SUFFIX}"))
}

/// The program with a driver that is a real one until it is let loose, and misbehaves at its next poll then.
#[derive(Debug)]
pub struct Loose {
    pub program: PathBuf,
    leash: PathBuf,
}

impl Loose {
    /// In a folder for it alone: the driver `real`, by its folder in `drivers/`, and what it does, a word of the hostile driver.
    ///
    /// # Panics
    /// When the folder cannot be written to.
    #[must_use]
    pub fn new(folder: &Path, real: &str, how: &str) -> Self {
        let drivers = folder.join("drivers");
        std::fs::create_dir_all(&drivers).unwrap();
        let loose = Self {
            program: folder.join(format!("wirebend{EXE_SUFFIX}")),
            leash: drivers.join(format!("poll-{how}.leash")),
        };
        // Links: a copy cannot be started as long as a process that is just beginning has it open.
        let placed = |from: PathBuf, to: &Path| std::fs::hard_link(from, to).unwrap();
        placed(wirebend(), &loose.program);
        placed(driver("hostile"), &loose.leash.with_extension("so"));
        placed(driver(real), &loose.leash.with_extension("real"));
        std::fs::write(&loose.leash, "").unwrap();
        loose
    }

    /// From now on it misbehaves.
    ///
    /// # Panics
    /// When it was let loose before.
    pub fn let_loose(&self) {
        std::fs::remove_file(&self.leash).unwrap();
    }
}

/// A file of what is built. It is as new as its sources, or the test ends here: one that is older tests something else.
fn built(name: &str) -> PathBuf {
    let file = folder().join(name);
    assert!(file.is_file(), "{} is missing: run `make built`, or cargo build --workspace", file.display());
    if let Some(source) = newer_source(&file) {
        panic!("{} is older than {source}: run `make built`, or cargo build --workspace", file.display());
    }
    file
}

/// That of the running test, or the one that `WIREBEND_BUILT` names.
fn folder() -> PathBuf {
    if let Some(named) = std::env::var_os("WIREBEND_BUILT") {
        return named.into();
    }
    let own = std::env::current_exe().unwrap();
    own.ancestors().skip(1).find(|folder| !folder.ends_with("deps")).unwrap().to_owned()
}

/// A source that was changed since a file was built of it, by the list that Cargo writes beside what it builds.
fn newer_source(file: &Path) -> Option<String> {
    let built = changed(file)?;
    let list = std::fs::read_to_string(file.with_extension("d")).ok()?;
    let (_, sources) = list.split_once(": ")?;
    // A space within a name is escaped.
    let sources = sources.trim_end().replace("\\ ", "\0");
    let newer = |source: &&str| changed(Path::new(&source.replace('\0', " "))).is_some_and(|at| at > built);
    sources.split(' ').find(newer).map(|source| source.replace('\0', " "))
}

fn changed(file: &Path) -> Option<SystemTime> {
    file.metadata().ok()?.modified().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A driver that is loaded as it was before a change passes or fails for what is not there any more.
    #[test]
    fn a_file_that_is_older_than_its_source_is_found() {
        let folder = tempfile::tempdir().unwrap();
        let [built, source] = ["libone.so", "a source.rs"].map(|name| folder.path().join(name));
        let list = format!("{}: {}\n", built.display(), source.display().to_string().replace(' ', "\\ "));
        std::fs::write(built.with_extension("d"), list).unwrap();
        std::fs::write(&source, "").unwrap();
        std::fs::write(&built, "").unwrap();
        let file = std::fs::File::options().write(true).open(&source).unwrap();
        let at = changed(&built).unwrap();
        file.set_modified(at).unwrap();
        assert_eq!(newer_source(&built), None);
        file.set_modified(at + std::time::Duration::from_secs(1)).unwrap();
        assert_eq!(newer_source(&built), Some(source.display().to_string()));
    }
}
