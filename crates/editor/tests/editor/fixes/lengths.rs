//! Fixes of what is too short.

use super::{codes, mend, on_kit, promised, titles};
use crate::{app, edit};
use serde_json::json;

/// Between two right angles an edge of 27 mm is fed 27 - 6 + 2.4·π/2 = 24.770 mm; 25 are needed, and 0.05 more are added.
#[test]
fn a_feed_that_is_too_short_is_made_long_enough_at_either_end() {
    let mut editor = on_kit(&[[0., 0., 0.], [40., 0., 0.], [40., 27., 0.], [0., 27., 0.]]);
    let fixes = promised(&mut editor, &app());
    // Moved out, either end makes its other edge longer too: by 0.28² / 80 mm.
    let mut offered = titles(&fixes, "feed_too_short");
    offered.sort();
    assert_eq!(
        offered,
        ["Move vertex 1 by 0.28 mm", "Move vertex 2 by 0.28 mm", "Move vertices 1 and 2 apart by 0.28 mm"]
    );
    let check = mend(&mut editor, &app(), "Move vertex 2 by 0.28 mm");
    assert!(
        check.feasible && check.diagnostics.iter().all(|d| d.code.as_str() == "feed_near_limit"),
        "{check:?}"
    );
    assert!((editor.view().vertices[2].at_mm[1] - 27.28).abs() < 1e-3);
    // What is only near the limit can be brought away from it: 1.05 times 25 mm.
    let fixes = promised(&mut editor, &app());
    assert!(!titles(&fixes, "feed_near_limit").is_empty(), "{fixes:?}");
}

#[test]
fn what_the_design_holds_fixed_is_not_moved() {
    let mut editor = on_kit(&[[0., 0., 0.], [40., 0., 0.], [40., 27., 0.], [0., 27., 0.]]);
    edit(&mut editor, &json!({"edit": "support", "vertices": [1], "support": true}));
    assert_eq!(titles(&promised(&mut editor, &app()), "feed_too_short"), ["Move vertex 2 by 0.28 mm"]);
}

/// Edges of 15 mm with a right angle between: the last is fed 15 - 3 mm and has to be 28 mm long, 28/15 = 1.867.
#[test]
fn where_several_edges_are_too_short_the_whole_design_is_scaled() {
    let mut editor = on_kit(&[[0., 0., 0.], [15., 0., 0.], [15., 15., 0.]]);
    let line = json!({"make": "draw", "through_mm": [[7.5, 7.5, 0], [17.5, 7.5, 0]]});
    edit(&mut editor, &json!({"edit": "construction", "change": line}));
    let check = mend(&mut editor, &app(), "Scale the design by 1.87");
    assert!(check.feasible, "{check:?}");
    // What the wire was drawn along goes with it.
    let [from, to] = editor.view().state.construction_mm[0];
    assert!((from[0] - 7.5).abs() < 1e-9 && (to[0] - from[0] - 18.7).abs() < 1e-9, "{from:?} {to:?}");
    // About its middle.
    let middle =
        editor.view().vertices.iter().fold([0.0; 2], |sum, v| [sum[0] + v.at_mm[0], sum[1] + v.at_mm[1]]);
    assert!(
        (middle[0] - (7.5 * 3.0 + 1.87 * 7.5)).abs() < 1e-9
            && (middle[1] - (7.5 * 3.0 - 1.87 * 7.5)).abs() < 1e-9
    );
}

/// Two edges in line are one straight part of 18 mm; what is moved are its ends, not the joint.
#[test]
fn a_straight_of_several_edges_is_made_longer_at_its_ends() {
    let points = [[0., 0., 0.], [0., 40., 0.], [9., 40., 0.], [18., 40., 0.], [18., 80., 0.]];
    let mut editor = on_kit(&points);
    let fixes = promised(&mut editor, &app());
    let fix = fixes.iter().find(|fix| fix.mends.code.as_str() == "edge_too_short").unwrap();
    assert_eq!(fix.mends.edges, [1, 2]);
    assert!(fix.preview.moved.iter().all(|moved| [1, 3].contains(&moved.vertex)), "{fix:?}");
    editor.edit(&app(), &fix.edit).unwrap();
    let check = editor.check(&app(), &[]).unwrap();
    assert!(!codes(&check).contains(&"edge_too_short") && !codes(&check).contains(&"feed_too_short"));
}

/// Without a route every edge is judged alone.
#[test]
fn edges_are_made_longer_before_there_is_a_route() {
    let mut editor = on_kit(&[[0., 50., 0.], [0., 0., 0.], [0., 0., 60.]]);
    edit(&mut editor, &json!({"edit": "draw", "from": 1, "through_mm": [[19, 0, 0]]}));
    let fixes = promised(&mut editor, &app());
    let offered = titles(&fixes, "edge_too_short");
    assert!(offered.contains(&"Move vertex 3 by 1.4 mm".to_owned()), "{offered:?}");
}

/// More is too short than can be tried, and what needs most comes last: an edge of 15 mm, when 16 mm are the rule.
#[test]
fn what_mends_all_of_it_is_not_left_out_for_want_of_trials() {
    let mut points: Vec<[f64; 3]> =
        (0..=90_u32).map(|k| [16.0 * f64::from(k.div_ceil(2)), 16.0 * f64::from(k / 2), 0.0]).collect();
    let last = points.last_mut().unwrap();
    last[1] -= 1.0;
    let mut editor = on_kit(&points);
    let errors = editor.check(&app(), &[]).unwrap().diagnostics.len();
    assert!(errors > 100, "{errors}");
    let fixes = editor.fixes(&app()).unwrap();
    let scaled: Vec<_> = fixes.iter().filter(|fix| fix.title.starts_with("Scale")).collect();
    assert_eq!(scaled.len(), 1);
    // The last edge is fed 3 mm less than it is long: 28/15.
    assert_eq!((scaled[0].title.as_str(), scaled[0].errors_after), ("Scale the design by 1.87", 0));
    assert!(fixes.len() > 10);
}
