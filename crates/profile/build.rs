//! Rebuilds the crate when a shipped profile is added or removed; `include_dir` sees only edits.

fn main() {
    println!("cargo::rerun-if-changed=../../machine-profiles");
}
