//! The programs for the controller, built when a test asks for them, once a process.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may stop at what cannot be

use std::collections::BTreeMap;
use std::fs::File;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::{Mutex, OnceLock, PoisonError};

/// The firmware of this repository as avr-gcc makes it for a machine of `firmware/machines/`: its ELF file.
///
/// # Panics
/// When it cannot be built.
#[must_use]
pub fn firmware(machine: &str) -> PathBuf {
    static BUILT: Mutex<BTreeMap<String, PathBuf>> = Mutex::new(BTreeMap::new());
    let mut built = BUILT.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(elf) = built.get(machine) {
        return elf.clone();
    }
    let folder = folder().join(machine);
    let elf = folder.join("firmware.elf");
    let mut make = Command::new("make");
    make.arg("--no-print-directory").arg("-C").arg(package().join("../../firmware")).arg(&elf);
    make.arg(format!("MACHINE={machine}")).arg(format!("OUT={}", folder.display()));
    // Every test is a process of its own, and each finds out by make whether it has to be built.
    let turn = File::create(folder.with_extension("lock")).unwrap();
    turn.lock().unwrap();
    run(&mut make);
    drop(turn);
    let elf = made(elf);
    built.insert(machine.to_owned(), elf.clone());
    elf
}

/// The program in `probe/`, which uses what the firmware uses and does what a test of the bench orders.
///
/// # Panics
/// When it cannot be built.
#[must_use]
pub fn probe() -> PathBuf {
    static BUILT: OnceLock<PathBuf> = OnceLock::new();
    let build = || {
        let elf = folder().join("probe.elf");
        let own = folder().join(format!("probe-{}.elf", std::process::id())); // another test may build it too
        let mut gcc = Command::new("avr-gcc");
        gcc.args(["-mmcu=atmega328p", "-DF_CPU=16000000UL", "-Os", "-g", "-std=gnu11", "-Wall", "-Wextra"]);
        gcc.arg("-Werror").arg(package().join("probe/probe.c")).arg("-o").arg(&own);
        run(&mut gcc);
        std::fs::rename(&own, &elf).unwrap();
        made(elf)
    };
    BUILT.get_or_init(build).clone()
}

fn package() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// A folder beside what Cargo builds: nothing is written among the sources.
fn folder() -> PathBuf {
    let own = std::env::current_exe().unwrap();
    let profile = own.ancestors().skip(1).find(|folder| !folder.ends_with("deps")).unwrap();
    let folder = profile.join("avr");
    std::fs::create_dir_all(&folder).unwrap();
    folder
}

fn run(command: &mut Command) {
    let done = command.output().unwrap_or_else(|why| {
        panic!("{command:?}: {why}; apt-get install -y --no-install-recommends make gcc-avr binutils-avr avr-libc")
    });
    assert!(done.status.success(), "{command:?}: {}", String::from_utf8_lossy(&done.stderr));
}

fn made(elf: PathBuf) -> PathBuf {
    assert!(elf.is_file(), "{} was not made", elf.display());
    elf
}
