//! The build: silent, and the same bytes wherever it is built.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

const MACHINES: [&str; 2] = ["wirebend-kit", "howtomechatronics"];

fn sources() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../firmware")
}

fn build(sources: &Path, machine: &str, out: &Path) -> Output {
    let mut make = Command::new("make");
    make.arg("--no-print-directory").arg("-C").arg(sources).arg(format!("MACHINE={machine}"));
    make.arg(format!("OUT={}", out.display())).env_remove("MAKEFLAGS").env_remove("MAKELEVEL");
    make.output().unwrap()
}

#[test]
fn the_build_has_no_warning() {
    for machine in MACHINES {
        let out = tempfile::tempdir().unwrap();
        let made = build(&sources(), machine, out.path());
        assert!(made.status.success(), "{}", String::from_utf8_lossy(&made.stderr));
        assert_eq!(String::from_utf8_lossy(&made.stderr), "", "{machine}");
        let makefile = std::fs::read_to_string(sources().join("Makefile")).unwrap();
        for flag in ["-Wall", "-Wextra", "-Wconversion", "-Werror"] {
            assert!(makefile.contains(flag), "built without {flag}");
        }
    }
}

fn copy(from: &Path, to: &Path) {
    std::fs::create_dir_all(to).unwrap();
    for entry in std::fs::read_dir(from).unwrap() {
        let entry = entry.unwrap();
        let target = to.join(entry.file_name());
        if entry.file_type().unwrap().is_dir() {
            copy(&entry.path(), &target);
        } else {
            std::fs::copy(entry.path(), target).unwrap();
        }
    }
}

/// What is in the sections that get into the chip. Among what is for debuggers the compiler puts the names of its
/// temporary files.
fn sections(elf: &Path) -> String {
    let dump =
        Command::new("avr-objdump").args(["-s", "-j", ".text", "-j", ".data"]).arg(elf).output().unwrap();
    let text = String::from_utf8(dump.stdout).unwrap();
    assert!(text.contains(".text"));
    text.lines().skip(2).collect::<Vec<_>>().join("\n") // the first has the file's name
}

#[test]
fn two_folders_give_the_same_bytes() {
    for machine in MACHINES {
        let folder = tempfile::tempdir().unwrap();
        let made = ["one", "another-folder-with-a-longer-name"].map(|name| {
            let place = folder.path().join(name);
            copy(&sources(), &place.join("firmware"));
            let out = place.join("out");
            let done = build(&place.join("firmware"), machine, &out);
            assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
            let hex = std::fs::read_to_string(out.join("firmware.hex")).unwrap();
            (hex, sections(&out.join("firmware.elf")))
        });
        assert!(made[0].0 == made[1].0, "{machine}: the hex files differ");
        assert!(made[0].1 == made[1].1, "{machine}: the programs in the ELF files differ");
        println!("{machine}: firmware.hex of {} bytes is the same from two folders", made[0].0.len());
    }
}
