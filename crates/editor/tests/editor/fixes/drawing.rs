//! Fixes of flaws of the drawing, and of a start that does not fit.

use serde_json::json;

use super::{codes, mend, on_kit, promised, titles};
use crate::{app, edit};

#[test]
fn vertices_that_lie_on_each_other_are_merged() {
    let mut editor = on_kit(&[[0., 0., 0.], [60., 0., 0.], [60., 60., 0.]]);
    edit(&mut editor, &json!({"edit": "draw", "through_mm": [[60, 60, 0], [0, 60, 0]]}));
    let fixes = promised(&mut editor, &app());
    assert_eq!(titles(&fixes, "coincident_vertices"), ["Merge vertices 2 and 3"]);
    edit(&mut editor, &json!({"edit": "draw", "through_mm": [[0, 60, 0], [0, 120, 0]]}));
    let fixes = promised(&mut editor, &app());
    assert!(titles(&fixes, "coincident_vertices").len() == 3, "{fixes:?}");
    let check = mend(&mut editor, &app(), "Merge all 2 pairs of vertices that lie on each other");
    assert_eq!((check.wires.len(), check.diagnostics.len()), (1, 0));
}

#[test]
fn what_is_too_much_is_deleted() {
    let mut editor = on_kit(&[[0., 0., 0.], [60., 0., 0.], [60., 60., 0.]]);
    edit(&mut editor, &json!({"edit": "draw", "through_mm": [[5, 5, 5]]}));
    let check = mend(&mut editor, &app(), "Delete vertex 3");
    assert_eq!(check.diagnostics, []);
    // An edge without length, and one that is there twice.
    edit(&mut editor, &json!({"edit": "draw", "from": 2, "through_mm": [[60, 60, 0], [0, 60, 0]]}));
    let check = mend(&mut editor, &app(), "Merge vertices 2 and 4");
    assert!(check.feasible && !codes(&check).contains(&"zero_length_edge"), "{check:?}");
    let mut editor = on_kit(&[[0., 0., 0.], [60., 0., 0.]]);
    edit(
        &mut editor,
        &json!({"edit": "paste", "vertices": [{"at_mm": [0, 0, 90]}, {"at_mm": [60, 0, 90]}], "edges": [[0, 1], [0, 1]]}),
    );
    let fixes = promised(&mut editor, &app());
    assert_eq!(titles(&fixes, "parallel_edges").len(), 2);
}

/// A wire drawn through itself is joined where it crosses, or one of its edges makes room.
#[test]
fn edges_through_each_other_are_joined_or_moved_apart() {
    let crossing = [[0., 0., 0.], [100., 0., 0.], [100., 60., 0.], [50., 60., 0.], [50., -40., 0.]];
    let mut editor = on_kit(&crossing);
    let fixes = promised(&mut editor, &app());
    assert!(titles(&fixes, "edges_meet").len() >= 2, "{:?}", titles(&fixes, "edges_meet"));
    let check = mend(&mut editor, &app(), "Join edges 0 and 3 with a vertex");
    assert!(check.feasible && !codes(&check).contains(&"edges_meet"), "{check:?}");
    let joint: Vec<_> = editor.document().wireframe.vertices().filter(|(id, _)| id.0 > 4).collect();
    assert_eq!(joint.len(), 1);
    assert!((joint[0].1.position - nalgebra::Point3::new(50.0, 0.0, 0.0)).norm() < 1e-9);
    // 3.05 mm away: the diameter, and a little for rounding; a button says it with one digit.
    let mut editor = on_kit(&crossing);
    let check = mend(&mut editor, &app(), "Move edge 3 by 3.0 mm");
    assert!(!codes(&check).contains(&"edges_meet"), "{check:?}");
}

#[test]
fn edges_that_end_on_others_are_joined_to_them() {
    let mut editor = on_kit(&[[0., 0., 0.], [100., 0., 0.]]);
    // A corner 0.5 mm beside the middle of the first edge.
    edit(&mut editor, &json!({"edit": "draw", "through_mm": [[20, 60, 0], [50, 0.5, 0], [80, 60, 0]]}));
    let check = mend(&mut editor, &app(), "Join edge 0 to vertex 3");
    assert!(!codes(&check).contains(&"edges_meet"), "{check:?}");
    // Two ends that nearly meet.
    let mut editor = on_kit(&[[0., 0., 0.], [60., 0., 0.]]);
    edit(&mut editor, &json!({"edit": "draw", "through_mm": [[60, 0.8, 0], [60, 60, 0]]}));
    let check = mend(&mut editor, &app(), "Merge vertices 1 and 2");
    assert_eq!((check.wires.len(), codes(&check).contains(&"edges_meet")), (1, false));
}

#[test]
fn a_start_that_does_not_fit_is_given_up() {
    let mut editor = on_kit(&[[0., 0., 0.], [60., 0., 0.], [60., 60., 0.]]);
    edit(&mut editor, &json!({"edit": "start", "vertex": 1}));
    let check = mend(&mut editor, &app(), "Start point: automatic");
    assert!(check.feasible);
    assert_eq!(editor.state().start, None);
}

#[test]
fn a_sound_design_needs_nothing_and_an_empty_one_offers_nothing() {
    let mut editor = on_kit(&[[0., 0., 0.], [60., 0., 0.], [60., 60., 0.]]);
    assert_eq!(promised(&mut editor, &app()), []);
    let mut empty = wirebend_editor::Editor::new(&app(), Some("wirebend-kit"), None).unwrap();
    assert_eq!(promised(&mut empty, &app()), []);
    let mut bare = wirebend_editor::Editor::new(&app(), None, None).unwrap();
    assert!(bare.fixes(&app()).is_err(), "no machine, no limits");
}
