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
    // Where the whole is scaled, all of it goes with it.
    let most = |fix: &Fix| if matches!(fix.edit, EditRequest::Transform { .. }) { 1000.0 } else { 100.0 };
    let fixes = promised(&mut editor, &app());
    assert!(!fixes.is_empty(), "nothing is offered that could be looked at");
    for fix in fixes {
        for moved in &fix.preview.moved {
            let at = points[moved.vertex as usize];
            let by = (0..3).map(|k| (moved.at_mm[k] - at[k]).powi(2)).sum::<f64>().sqrt();
            assert!(by < most(&fix), "{}: {by} mm", fix.title);
        }
    }
}
