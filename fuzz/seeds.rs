//! Every target has its program and its seeds, and takes them.

#![allow(clippy::unwrap_used)] // a test may stop at what cannot be

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use wirebend_fuzz::TARGETS;

/// A path from this folder on.
fn here(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(path)
}

/// What a folder has in it.
fn paths(folder: &str) -> Vec<PathBuf> {
    fs::read_dir(here(folder)).unwrap().map(|entry| entry.unwrap().path()).collect()
}

/// The names of what a folder has in it.
fn names(folder: &str) -> BTreeSet<String> {
    paths(folder).iter().map(|path| path.file_stem().unwrap().to_str().unwrap().to_owned()).collect()
}

#[test]
fn every_target_takes_its_seeds() {
    for (name, target) in TARGETS {
        let seeds = paths(&format!("seeds/{name}"));
        assert!(!seeds.is_empty(), "{name} has no seeds");
        for seed in seeds {
            target(&fs::read(seed).unwrap());
        }
    }
}

/// The programs are compiled by the fuzzer alone: each is its target and nothing else.
#[test]
fn every_target_has_its_program() {
    let known: BTreeSet<_> = TARGETS.iter().map(|(name, _)| (*name).to_owned()).collect();
    assert_eq!(names("fuzz_targets"), known);
    assert_eq!(names("seeds"), known);
    let manifest = fs::read_to_string(here("Cargo.toml")).unwrap();
    for name in known {
        let path = format!("fuzz_targets/{name}.rs");
        let program = fs::read_to_string(here(&path)).unwrap();
        let call = format!("libfuzzer_sys::fuzz_target!(|bytes: &[u8]| wirebend_fuzz::{name}(bytes));");
        assert_eq!(program, format!("#![no_main]\n\n{call}\n"));
        assert!(
            manifest.contains(&format!("name = \"{name}\"\npath = \"{path}\"")),
            "{name} is not in the manifest"
        );
    }
}
