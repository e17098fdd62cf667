//! What all targets have in common.

use wirebend_files::read::{Format, Imported, LengthUnit, ReadOptions, read};

/// Reads bytes as one format, with options that the first byte chooses, and checks what every
/// import promises: positions are finite and the traversal of a program stays in the wireframe.
pub fn import(format: Format, bytes: &[u8]) {
    let face_edges = bytes.first().is_some_and(|byte| byte % 2 == 1);
    let units = bytes.first().filter(|byte| **byte > 200).map(|_| LengthUnit::Metre);
    let options = ReadOptions { face_edges, units, ..ReadOptions::default() };
    if let Ok(imported) = read(bytes, "fuzz", Some(format), &options) {
        check(&imported);
    }
}

fn check(imported: &Imported) {
    for (_, vertex) in imported.wireframe.vertices() {
        assert!(vertex.position.coords.iter().all(|c| c.is_finite()));
    }
    if let Some(program) = &imported.program {
        for pair in program.traversal.windows(2) {
            let edges = imported.wireframe.incident(pair[0]);
            let joined = |id| imported.wireframe.edge(id).is_some_and(|edge| edge.other(pair[0]) == pair[1]);
            assert!(edges.into_iter().any(joined));
        }
    }
}
