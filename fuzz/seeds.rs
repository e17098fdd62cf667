//! Every target has its program and its seeds, and takes them.

#![allow(clippy::unwrap_used)] // a test may stop at what cannot be

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use wirebend_fuzz::TARGETS;

/// The names in a folder beside this file.
fn names(folder: &str) -> BTreeSet<String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let stem = |path: &Path| path.file_stem().unwrap().to_str().unwrap().to_owned();
    fs::read_dir(folder).unwrap().map(|entry| stem(&entry.unwrap().path())).collect()
}

#[test]
fn every_target_takes_its_seeds() {
    for (name, target) in TARGETS {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("seeds").join(name);
        let seeds: Vec<_> =
            fs::read_dir(folder).unwrap().map(|entry| fs::read(entry.unwrap().path()).unwrap()).collect();
        assert!(!seeds.is_empty(), "{name} has no seeds");
        for seed in &seeds {
            target(seed);
        }
    }
}

/// The programs are compiled by the fuzzer alone: each is its target and nothing else.
#[test]
fn every_target_has_its_program() {
    let known: BTreeSet<_> = TARGETS.iter().map(|(name, _)| (*name).to_owned()).collect();
    assert_eq!(names("fuzz_targets"), known);
    assert_eq!(names("seeds"), known);
    let manifest = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("Cargo.toml")).unwrap();
    for name in known {
        let path = format!("fuzz_targets/{name}.rs");
        let program = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(&path)).unwrap();
        let call = format!("libfuzzer_sys::fuzz_target!(|bytes: &[u8]| wirebend_fuzz::{name}(bytes));");
        assert_eq!(program, format!("#![no_main]\n\n{call}\n"));
        assert!(
            manifest.contains(&format!("name = \"{name}\"\npath = \"{path}\"")),
            "{name} is not in the manifest"
        );
    }
}
