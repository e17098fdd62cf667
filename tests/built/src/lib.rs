//! For tests and benchmarks: libraries and programs of this workspace that are loaded or started, not
//! linked, so that Cargo does not know that a test needs them. They are built when the first of them is asked for, but where
//! `WIREBEND_BUILT` names a folder that has them already.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)] // a test may stop at what cannot be

use std::env::consts::{DLL_PREFIX, DLL_SUFFIX, EXE_SUFFIX};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

/// All of them at once: what they share is built once, and not for each with the features that it alone needs.
const PACKAGES: [&str; 9] = [
    "wirebend-cli",
    "wirebend-driver-host",
    "wirebend-driver-grbl",
    "wirebend-driver-hostile",
    "wirebend-driver-howtomechatronics",
    "wirebend-driver-pensa",
    "wirebend-driver-tables",
    "wirebend-driver-template",
    "wirebend-driver-wirebend-kit",
];

/// The library of a driver by its folder in `drivers/`, built now if it has to be.
///
/// # Panics
/// When it cannot be built.
#[must_use]
pub fn driver(folder: &str) -> PathBuf {
    let library = match folder {
        "hostile" | "template" => format!("{folder}_driver"),
        _ => format!("wirebend_driver_{}", folder.replace('-', "_")),
    };
    built(&format!("{DLL_PREFIX}{library}{DLL_SUFFIX}"))
}

/// The smallest program that can be the process of a driver.
///
/// # Panics
/// When it cannot be built.
#[must_use]
pub fn driver_child() -> PathBuf {
    built(&format!("wirebend-driver-child{EXE_SUFFIX}"))
}

/// The program of the command line. Libraries of [`driver`] lie beside it, where it looks for them.
///
/// # Panics
/// When it cannot be built.
#[must_use]
pub fn wirebend() -> PathBuf {
    built(&format!("wirebend{EXE_SUFFIX}"))
}

/// The program with a driver that is a real one until it is let loose, and misbehaves at its next poll then.
#[derive(Debug)]
pub struct Loose {
    /// The program.
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

/// The workspace of the running test; a target folder may hold this crate as built in another checkout.
fn workspace() -> PathBuf {
    let package = std::env::var_os("CARGO_MANIFEST_DIR").unwrap_or_else(|| env!("CARGO_MANIFEST_DIR").into());
    let found = Path::new(&package).ancestors().find(|folder| folder.join("Cargo.lock").is_file());
    found.unwrap_or_else(|| panic!("{} is in no workspace", package.display())).to_owned()
}

/// A file of what is built, which is there when this returns.
fn built(name: &str) -> PathBuf {
    static FOLDER: OnceLock<PathBuf> = OnceLock::new();
    let given = std::env::var_os("WIREBEND_BUILT").map(PathBuf::from);
    let file = FOLDER.get_or_init(|| given.unwrap_or_else(build)).join(name);
    assert!(file.is_file(), "{} was not made: is its package missing in this list?", file.display());
    file
}

/// Builds into a folder of its own within that of the running test, and gives the folder. In the same folder it would write
/// over libraries that the run of the tests still links: those of the drivers have no hash in their names, and they have
/// other features than in the workspace.
fn build() -> PathBuf {
    let own = std::env::current_exe().unwrap();
    let profile = own.ancestors().skip(1).find(|folder| !folder.ends_with("deps")).unwrap();
    let target = profile.parent().unwrap().join("built");
    let mut cargo = Command::new(env!("CARGO"));
    cargo.current_dir(workspace());
    cargo.args(["build", "--quiet", "--offline", "--lib", "--bins", "--target-dir"]).arg(&target);
    cargo.args(PACKAGES.iter().flat_map(|package| ["--package", package]));
    if profile.ends_with("release") {
        cargo.arg("--release");
    }
    let done = cargo.output().unwrap();
    assert!(done.status.success(), "{cargo:?}: {}", String::from_utf8_lossy(&done.stderr));
    target.join(profile.file_name().unwrap())
}
