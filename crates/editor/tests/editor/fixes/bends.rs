//! Fixes of bends, and of turns of the head.

use serde_json::json;
use wirebend_editor::EditRequest;

use super::{codes, machine_with, mend, on_kit, promised, strand, titles};
use crate::{app, edit};

/// A bend of 160° where 155° can be bent: the legs are 80 mm, so that the chord spans 20°.
fn sharp() -> [[f64; 3]; 3] {
    let turn = f64::to_radians(20.0);
    [[0., 0., 0.], [80., 0., 0.], [80. - 80. * turn.cos(), 80. * turn.sin(), 0.]]
}

#[test]
fn a_bend_that_is_too_sharp_is_opened_or_left_to_two_wires() {
    let mut editor = on_kit(&sharp());
    let fixes = promised(&mut editor, &app());
    let offered = titles(&fixes, "bend_too_sharp");
    assert_eq!(offered.len(), 2, "{offered:?}");
    assert!(offered.contains(&"Split at vertex 1 into two wires".to_owned()), "{offered:?}");
    // Half the chord is 80·sin 10° = 13.892 mm; under 154.95° it is seen from 13.892 / tan 12.525° = 62.533 mm, and the
    // vertex is 80·cos 10° = 78.785 mm away: it comes nearer by 16.25 mm.
    let moved = "Move vertex 1 by 16.3 mm";
    let moved_by = fixes.iter().find_map(|fix| match &fix.edit {
        EditRequest::Move { by_mm, .. } => Some(nalgebra::Vector3::from(*by_mm).norm()),
        _ => None,
    });
    assert!((moved_by.unwrap() - 16.25).abs() < 0.01, "{moved_by:?}");
    assert!(offered.contains(&moved.to_owned()), "{offered:?}");
    let check = mend(&mut editor, &app(), moved);
    assert!(check.feasible && codes(&check) == ["bend_near_limit"], "{check:?}");
    // And from near the limit away from it, to 0.95 · 155°.
    let fixes = promised(&mut editor, &app());
    assert_eq!(titles(&fixes, "bend_near_limit").len(), 1);
    editor.edit(&app(), &fixes[0].edit).unwrap();
    assert_eq!(editor.check(&app(), &[]).unwrap().diagnostics, []);
}

#[test]
fn two_wires_touch_where_the_bend_was() {
    let mut editor = on_kit(&sharp());
    let check = mend(&mut editor, &app(), "Split at vertex 1 into two wires");
    assert!(check.feasible);
    assert_eq!(check.wires.iter().map(|wire| wire.route.clone()).collect::<Vec<_>>(), [[0, 1], [2, 3]]);
    let view = editor.view();
    let [one, other] = [1, 3].map(|k| nalgebra::Point3::from(view.vertices[k].at_mm));
    assert_eq!(one, other);
}

/// A needle: at its point the wire has to begin.
#[test]
fn a_ring_begins_where_its_bend_cannot_be_made() {
    let mut editor = on_kit(&[[0., 0., 0.], [200., 20., 0.], [200., -20., 0.]]);
    edit(&mut editor, &json!({"edit": "draw", "from": 2, "to": 0}));
    assert!(editor.check(&app(), &[]).unwrap().feasible, "left alone, it begins there");
    edit(&mut editor, &json!({"edit": "start", "vertex": 1}));
    let fixes = promised(&mut editor, &app());
    assert!(titles(&fixes, "bend_too_sharp").contains(&"Start at vertex 0".to_owned()), "{fixes:?}");
    assert!(mend(&mut editor, &app(), "Start at vertex 0").feasible);
}

/// An axis that stops at 100°: with springback and setback it bends less than a right angle.
#[test]
fn a_bend_beyond_the_axis_is_opened_to_what_it_reaches() {
    let axis = r#""bend": {"axis_limit_deg": {"value": 100, "source": "a test", "measured": false}}"#;
    let (_folder, app) = machine_with(axis);
    let mut editor = strand(&app, "other", &[[0., 0., 0.], [80., 0., 0.], [80., 80., 0.]]);
    let fixes = promised(&mut editor, &app);
    let moved =
        titles(&fixes, "bend_out_of_reach").into_iter().find(|title| title.starts_with("Move vertex 1"));
    assert!(mend(&mut editor, &app, &moved.unwrap()).feasible);
}

/// Without springback the peg would have to stop on the far side for a bend of a degree: made straight, it is none, and
/// made larger, it is one. The least bend is where 12·sin θ - 4.675 - 3·(1 - cos θ) = -20.4·sin θ: at 8.36°.
#[test]
fn a_bend_that_is_too_small_is_made_none_or_larger() {
    let untold = r#""compensation": {"feed": true, "setback": true, "springback": false}, "bend": {"before_zero": false}"#;
    let (_folder, app) = machine_with(untold);
    let points = [[0., 0., 0.], [80., 0., 0.], [160., 2., 0.]];
    let mut editor = strand(&app, "other", &points);
    let fixes = promised(&mut editor, &app);
    let offered = titles(&fixes, "bend_too_small");
    assert!(offered.contains(&"Put vertex 1 onto the line of its edges".to_owned()), "{offered:?}");
    let larger = fixes.iter().find(|fix| fix.title.starts_with("Move vertex 1")).unwrap();
    let [moved] = larger.preview.moved[..] else { panic!("{larger:?}") };
    let [before, at, after] = [points[0], moved.at_mm, points[2]].map(nalgebra::Point3::from);
    let bend = (at - before).angle(&(after - at)).to_degrees();
    let sine = |deg: f64| deg.to_radians().sin();
    let setback = 12.0 * sine(bend - 0.05) - 4.675 - 3.0 * (1.0 - (bend - 0.05).to_radians().cos());
    assert!((setback + 20.4 * sine(bend - 0.05)).abs() < 1e-3, "{bend}");
    let check = mend(&mut editor, &app, "Put vertex 1 onto the line of its edges");
    assert!(check.feasible && check.wires[0].bends == Some(0));
}

/// 0.0065° are less than half of what the axis resolves (0.0168°) and more than the rounding of a file.
#[test]
fn a_corner_that_is_not_made_is_put_in_line() {
    let mut editor = on_kit(&[[0., 0., 0.], [100., 0., 0.], [200., 0.01134, 0.], [200., 50., 0.]]);
    let check = mend(&mut editor, &app(), "Put vertex 1 onto the line of its edges");
    assert_eq!(check.diagnostics, []);
}

#[test]
fn a_head_that_cannot_turn_bends_two_wires() {
    let still = r#""limits": {"min_rotation_deg": {"value": 0, "source": "a test", "measured": false},
        "max_rotation_deg": {"value": 1, "source": "a test", "measured": false}}"#;
    let (_folder, app) = machine_with(still);
    let twisted = [[0., 0., 0.], [60., 0., 0.], [60., 60., 0.], [60., 60., 60.], [0., 60., 60.]];
    let mut editor = strand(&app, "other", &twisted);
    let fixes = promised(&mut editor, &app);
    assert_eq!(titles(&fixes, "rotation_out_of_range"), ["Split at vertex 2 into two wires"]);
    let check = mend(&mut editor, &app, "Split at vertex 2 into two wires");
    assert!(check.feasible, "{check:?}");
}
