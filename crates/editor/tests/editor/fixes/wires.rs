//! Fixes that bend a design from several wires.

use serde_json::json;
use wirebend_editor::Editor;

use super::{mend, on_kit, promised, titles};
use crate::{app, edit};

/// A strut of 60 mm to each side of a vertex in the origin.
fn crossed(editor: &mut Editor, center: u32) {
    for y in [-60, 60] {
        edit(editor, &json!({"edit": "draw", "from": center, "through_mm": [[0, y, 0]]}));
    }
}

/// The star has room for a second wire; the line beside it is one.
#[test]
fn one_of_two_parts_is_bent_from_two_wires() {
    let mut editor = on_kit(&[[0., 200., 0.], [80., 200., 0.]]);
    edit(&mut editor, &json!({"edit": "draw", "through_mm": [[-60, 0, 0], [0, 0, 0], [60, 0, 0]]}));
    crossed(&mut editor, 3);
    let title = "Bend 3 wires, no edge doubled";
    let fixes = promised(&mut editor, &app());
    let fix = fixes.iter().find(|fix| fix.title == title);
    let fix = fix.unwrap_or_else(|| panic!("{:?}", titles(&fixes, "no_euler_path")));
    let [further] = fix.preview.detached.as_slice() else { panic!("{:?}", fix.preview) };
    assert!(further.len() == 2 && !further.contains(&0), "half of the star, not the line: {further:?}");
    let check = mend(&mut editor, &app(), title);
    assert!(check.feasible && check.wires.len() == 3, "{check:?}");
}
