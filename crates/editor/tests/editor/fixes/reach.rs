//! How far fixes move vertices.

use wirebend_editor::{EditRequest, Fix};

use super::{codes, on_kit, promised};
use crate::app;

#[test]
fn no_fix_moves_a_vertex_by_metres() {
    // A bend of 179.9° takes 3·tan(89.95°) = 3.4 m of both its edges: longer ones would do, but be no repair.
    let points = [[0.0, 0.0, 0.0], [60.0, 0.0, 0.0], [0.0, 0.105, 0.0], [0.0, 60.0, 0.0]];
    let mut editor = on_kit(&points);
    let check = editor.check(&app(), &[]).unwrap();
    assert!(codes(&check).contains(&"arcs_overlap"), "{:?}", codes(&check));
    // To scale the whole is said with its factor.
    let moves = |fix: &Fix| !matches!(fix.edit, EditRequest::Transform { .. });
    let fixes = promised(&mut editor, &app());
    assert!(!fixes.is_empty(), "nothing is offered that could be looked at");
    for fix in fixes.into_iter().filter(moves) {
        for moved in &fix.preview.moved {
            let at = points[moved.vertex as usize];
            let by = (0..3).map(|k| (moved.at_mm[k] - at[k]).powi(2)).sum::<f64>().sqrt();
            assert!(by < 100.0, "{}: {by} mm", fix.title);
        }
    }
}
