#![no_main]

use wirebend_files::read::frame::read_loads;
use wirebend_files::read::{Format, ReadOptions, read};

/// A frame of two elements with tags.
const FRAME: &[u8] = include_bytes!("../seeds/conmech/uniform.json");

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    let options = ReadOptions::default();
    let Ok(imported) = read(FRAME, "fuzz", Some(Format::Conmech), &options) else { return };
    if let Ok(cases) = read_loads(bytes, "fuzz", &imported.wireframe, imported.frame.as_deref()) {
        for load in cases.iter().flat_map(|case| &case.line) {
            assert!(imported.wireframe.edge(load.edge).is_some());
        }
    }
});
