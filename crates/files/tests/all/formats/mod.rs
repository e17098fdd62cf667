//! Files that others made, files that are broken, and files that come back as they were.

// Outside of test functions, too: what a test cannot set up, it cannot test.
// As UPDATE_EXPECT=1 writes them.
#![allow(clippy::needless_raw_string_hashes)]
// Files are put together from lines; what that costs does not matter here.
#![allow(clippy::format_collect)]

mod any_bytes;
mod broken_drawings;
mod broken_models;
mod cut_curves;
mod documents;
mod drawn;
mod dxf;
mod dxf_faces;
mod dxf_splines;
mod encodings;
mod errors;
mod frames;
mod left_out;
mod meshes;
mod mistaken;
mod models;
mod models_beside;
mod pictures;
mod printed;
mod programs;
mod real_files;
mod round_trips;
mod svg;
mod svg_styles;
mod tables;
mod written_models;

use std::path::PathBuf;

use wirebend_core::bend::Step;
use wirebend_core::units::{Angle, Length};
use wirebend_files::read::{Imported, Note, ReadError, ReadOptions, read};

fn data(name: &str) -> (Vec<u8>, String) {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/data").join(name);
    let bytes = std::fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    (bytes, name.rsplit('/').next().unwrap().to_owned())
}

fn import_data(name: &str, options: &ReadOptions) -> Imported {
    let (bytes, name) = data(name);
    read(&bytes, &name, None, options).unwrap_or_else(|error| panic!("{error}"))
}

fn import(name: &str, text: impl AsRef<[u8]>) -> Result<Imported, ReadError> {
    read(text.as_ref(), name, None, &ReadOptions::default())
}

fn notes(notes: &[Note]) -> Vec<String> {
    notes.iter().map(ToString::to_string).collect()
}

fn mm(value: f64) -> Length {
    Length::from_mm(value).unwrap()
}

fn step(feed_mm: f64, rotate_deg: f64, bend_deg: f64) -> Step {
    let angle = |deg| Angle::from_deg(deg).unwrap();
    Step { feed: mm(feed_mm), rotate: angle(rotate_deg), bend: angle(bend_deg) }
}
