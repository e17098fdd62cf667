//! For tests and benchmarks: libraries and programs of this workspace that are loaded or started, not
//! linked, so that Cargo does not know that a test needs them. Each is built when it is asked for.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)] // a test may stop at what cannot be

use std::collections::BTreeMap;
use std::env::consts::{DLL_PREFIX, DLL_SUFFIX, EXE_SUFFIX};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::{Mutex, PoisonError};

/// What was built before in this process, and where.
static BUILT: Mutex<BTreeMap<String, PathBuf>> = Mutex::new(BTreeMap::new());

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
    let package = format!("wirebend-driver-{folder}");
    build(&package, "--lib", &format!("{DLL_PREFIX}{library}{DLL_SUFFIX}"))
}

/// The smallest program that can be the process of a driver.
///
/// # Panics
/// When it cannot be built.
#[must_use]
pub fn driver_child() -> PathBuf {
    build("wirebend-driver-host", "--bins", &format!("wirebend-driver-child{EXE_SUFFIX}"))
}

/// The program of the command line. Libraries of [`driver`] lie beside it, where it looks for them.
///
/// # Panics
/// When it cannot be built.
#[must_use]
pub fn wirebend() -> PathBuf {
    build("wirebend-cli", "--bins", &format!("wirebend{EXE_SUFFIX}"))
}

/// The workspace of the running test; a target folder may hold this crate as built in another checkout.
fn workspace() -> PathBuf {
    let package = std::env::var_os("CARGO_MANIFEST_DIR").unwrap_or_else(|| env!("CARGO_MANIFEST_DIR").into());
    let found = Path::new(&package).ancestors().find(|folder| folder.join("Cargo.lock").is_file());
    found.unwrap_or_else(|| panic!("{} is in no workspace", package.display())).to_owned()
}

/// Builds into a folder of its own within that of the running test. In the same folder it would write over
/// libraries that the run of the tests still links: those of the drivers have no hash in their names, and a
/// package that is built alone has other features than in the workspace.
fn build(package: &str, what: &str, file: &str) -> PathBuf {
    let mut built = BUILT.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(file) = built.get(package) {
        return file.clone();
    }
    let own = std::env::current_exe().unwrap();
    let profile = own.ancestors().skip(1).find(|folder| !folder.ends_with("deps")).unwrap();
    let target = profile.parent().unwrap().join("built");
    let mut cargo = Command::new(env!("CARGO"));
    cargo.current_dir(workspace());
    cargo.args(["build", "--quiet", "--offline", "--package", package, what, "--target-dir"]).arg(&target);
    if profile.ends_with("release") {
        cargo.arg("--release");
    }
    let done = cargo.output().unwrap();
    assert!(done.status.success(), "{cargo:?}: {}", String::from_utf8_lossy(&done.stderr));
    let file = target.join(profile.file_name().unwrap()).join(file);
    assert!(file.is_file(), "{cargo:?} did not make {}", file.display());
    built.insert(package.to_owned(), file.clone());
    file
}
