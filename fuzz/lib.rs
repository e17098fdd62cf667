//! What each target does with the bytes that it is given: a mistake in a reader or a document is a panic.

#![allow(clippy::missing_panics_doc, clippy::expect_used)] // they are there to panic

use wirebend_files::document::{Document, Job};
use wirebend_files::read::frame::{read_loads, read_sequence};
use wirebend_files::read::{self, Format, Imported, LengthUnit, ReadOptions};
use wirebend_files::write::frame::framefab_sequence;

/// A frame of two elements with tags.
const FRAME: &[u8] = include_bytes!("seeds/conmech/uniform.json");

/// A function for each target, and the list of all of them by name.
macro_rules! targets {
    (formats { $($format:ident => $kind:ident,)* } others { $($other:ident,)* }) => {
        $(
            #[doc = concat!("Reads a file of `Format::", stringify!($kind), "`.")]
            pub fn $format(bytes: &[u8]) {
                import(Format::$kind, bytes);
            }
        )*

        /// All targets by name.
        pub const TARGETS: &[(&str, fn(&[u8]))] =
            &[$((stringify!($format), $format),)* $((stringify!($other), $other),)*];
    };
}

targets! {
    formats {
        assembly => Assembly,
        conmech => Conmech,
        dxf => Dxf,
        gltf => Gltf,
        kit => Kit,
        lra => Lra,
        moves => Moves,
        obj => Obj,
        pensa => Pensa,
        ply => Ply,
        pwf => Pwf,
        stl => Stl,
        svg => Svg,
        threemf => ThreeMf,
        xyz => Xyz,
    }
    others {
        detect,
        document,
        job,
        loads,
        sequence,
    }
}

/// Reads a file of whichever format it is.
pub fn detect(bytes: &[u8]) {
    if let Ok(format) = read::detect("fuzz.txt", bytes) {
        // Whatever it says of the file: it must come back.
        let _ = read::read(bytes, "fuzz.txt", Some(format), &ReadOptions::default());
    }
}

/// Opens a design, and writes and opens it again.
pub fn document(bytes: &[u8]) {
    if let Ok(document) = Document::open(bytes, "fuzz") {
        let again = document.to_bytes().expect("what was opened can be written");
        assert_eq!(Document::open(&again, "fuzz").expect("and opened"), document);
        document.design_hash().expect("and hashed");
    }
}

/// Opens a job, and writes and opens it again.
pub fn job(bytes: &[u8]) {
    if let Ok(job) = Job::open(bytes, "fuzz") {
        let again = job.to_bytes().expect("what was opened can be written");
        assert_eq!(Job::open(&again, "fuzz").expect("and opened"), job);
    }
}

/// Reads cases of load for a frame.
pub fn loads(bytes: &[u8]) {
    let frame = read::read(FRAME, "fuzz", Some(Format::Conmech), &ReadOptions::default())
        .expect("a seed can be read");
    if let Ok(cases) = read_loads(bytes, "fuzz", &frame.wireframe, frame.frame.as_deref()) {
        for load in cases.iter().flat_map(|case| &case.line) {
            assert!(frame.wireframe.edge(load.edge).is_some());
        }
    }
}

/// Reads a sequence of struts, and writes and reads it again.
pub fn sequence(bytes: &[u8]) {
    if let Ok(sequence) = read_sequence(bytes, "fuzz") {
        let again = read_sequence(framefab_sequence(&sequence).as_bytes(), "again")
            .expect("what was read can be written");
        assert_eq!(again.steps.len(), sequence.steps.len());
    }
}

/// Reads bytes as one format, with options that the first byte chooses, and checks what every import promises: positions are finite, and
/// the traversal of a program stays in the wireframe.
fn import(format: Format, bytes: &[u8]) {
    let face_edges = bytes.first().is_some_and(|byte| byte % 2 == 1);
    let units = bytes.first().filter(|byte| **byte > 200).map(|_| LengthUnit::Metre);
    let options = ReadOptions { face_edges, units, ..ReadOptions::default() };
    if let Ok(imported) = read::read(bytes, "fuzz", Some(format), &options) {
        check(&imported);
    }
}

fn check(imported: &Imported) {
    for (_, vertex) in imported.wireframe.vertices() {
        assert!(vertex.position.coords.iter().all(|c| c.is_finite()));
    }
    if let Some(program) = &imported.program {
        for pair in program.traversal.windows(2) {
            let [from, to] = pair else { continue };
            let edges = imported.wireframe.incident(*from);
            let joined = |id| imported.wireframe.edge(id).is_some_and(|edge| edge.other(*from) == *to);
            assert!(edges.into_iter().any(joined));
        }
    }
}
