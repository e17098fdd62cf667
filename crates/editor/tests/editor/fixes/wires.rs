//! Fixes that bend a design from several wires, and fixes of a design that is.

use serde_json::json;
use wirebend_core::checks::Code;
use wirebend_editor::{EditRequest, Editor, LiveCheck};
use wirebend_planning::Installation;
use wirebend_planning::report::RemedyReport;

use super::examples::frame;
use super::{machine_with, mend, on_kit, promised, strand, titles};
use crate::{app, edit};

/// Of 600 mm of stock 200 mm can be fed.
const SHORT_STOCK: &str =
    r#""limits": {"max_stock_mm": {"value": 600, "source": "a test", "measured": false}}"#;

/// Four struts that meet in the origin, two and two in line: one to each side along x, with what follows it.
fn star(app: &Installation, machine: &str, left: &[[f64; 3]], right: &[[f64; 3]]) -> Editor {
    let through: Vec<[f64; 3]> = left.iter().rev().chain(&[[0.0; 3]]).chain(right).copied().collect();
    let mut editor = strand(app, machine, &through);
    crossed(&mut editor, u32::try_from(left.len()).unwrap());
    editor
}

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
    let title = "Split into 3 wires, no doubled edges";
    let fixes = promised(&mut editor, &app());
    let fix = fixes.iter().find(|fix| fix.title == title);
    let fix = fix.unwrap_or_else(|| panic!("{:?}", titles(&fixes, "no_euler_path")));
    let [further] = fix.preview.detached.as_slice() else { panic!("{:?}", fix.preview) };
    assert!(further.len() == 2 && !further.contains(&0), "half of the star, not the line: {further:?}");
    let check = mend(&mut editor, &app(), title);
    assert!(check.feasible && check.wires.len() == 3, "{check:?}");
}

/// Where a wire is cut there is a part more, which takes one of the wires: the rest needs as many as before.
#[test]
fn a_part_that_is_cut_off_has_a_wire_of_its_own() {
    let (_folder, app) = machine_with(SHORT_STOCK);
    // One wire is 360 mm long, or bends by 160°, or has an edge of 260 mm; the other is 120 mm long.
    let out = |side: f64| [[60. * side, 0., 0.], [60. * side, 0., 60.], [120. * side, 0., 60.]];
    let turn = f64::to_radians(20.0);
    let sharp = [[70., 0., 0.], [70. - 70. * turn.cos(), 0., 70. * turn.sin()]];
    let long = [[30., 0., 0.], [30., 0., 260.]];
    for (left, right, code, title) in [
        (&out(-1.)[..], &out(1.)[..], "stock_too_long", "Split at vertex 3 into two wires"),
        (&[[-60., 0., 0.]], &sharp, "bend_too_sharp", "Split at vertex 2 into two wires"),
        (&[[-30., 0., 0.]], &long, "feed_too_long", "Split edge 2 in the middle, into two wires"),
    ] {
        let mut editor = star(&app, "other", left, right);
        edit(&mut editor, &json!({"edit": "wires", "wires": 2}));
        let offered = titles(&promised(&mut editor, &app), code);
        assert!(offered.contains(&title.to_owned()), "{code}: {offered:?}");
        let check = mend(&mut editor, &app, title);
        assert!(check.feasible && check.wires.len() == 3, "{check:?}");
        assert_eq!(editor.state().undo.as_deref(), Some("split into 2 wires"));
        assert_eq!(editor.state().wires, 3);
    }
}

/// An edge that two wires pass once each is doubled, too: a detour leaves it so. Two corners of the bunny need one.
#[test]
fn a_detour_keeps_what_is_doubled() {
    for wires in [2, 4] {
        let mut editor = frame("bunny.obj");
        let fixes = editor.fixes(&app()).unwrap();
        let several = format!("Split into {wires} wires, ");
        let several = fixes.iter().find(|fix| fix.title.starts_with(&several)).unwrap();
        editor.edit(&app(), &several.edit).unwrap();
        let doubled = editor.state().doublings;
        let fixes = editor.fixes(&app()).unwrap();
        let detours: Vec<_> = fixes.iter().filter(|fix| fix.title.starts_with("Take a detour")).collect();
        assert_eq!(detours.len(), 2, "{wires}: {:?}", titles(&fixes, "bend_too_sharp"));
        for fix in detours {
            let EditRequest::Doublings { edges } = &fix.edit else { panic!("{fix:?}") };
            assert!(doubled.iter().all(|edge| edges.contains(edge)), "{edges:?} without some of {doubled:?}");
        }
    }
}

/// Where a wire is not to bend too far it may begin, which is offered before any edges are doubled; with those that it takes then, the
/// bend is gone.
#[test]
fn a_start_at_a_bend_that_is_too_sharp_is_offered_before_there_is_a_route() {
    let mut editor = frame("bunny.obj");
    let fixes = editor.fixes(&app()).unwrap();
    let is_start = |title: &str| title.starts_with("Start at");
    let starts: Vec<_> =
        fixes.iter().filter(|fix| fix.mends.code == Code::BendTooSharp && is_start(&fix.title)).collect();
    assert_eq!(starts.len(), 2, "{:?}", titles(&fixes, "bend_too_sharp"));
    let EditRequest::Start { vertex: Some(start) } = starts[0].edit else { panic!("{:?}", starts[0]) };
    editor.edit(&app(), &starts[0].edit).unwrap();
    let fixes = editor.fixes(&app()).unwrap();
    let doubled = fixes.iter().find(|fix| fix.mends.code == Code::NoEulerPath).unwrap();
    editor.edit(&app(), &doubled.edit).unwrap();
    let check = editor.check(&app(), &[]).unwrap();
    let sharp = check.diagnostics.iter().filter(|one| one.code == Code::BendTooSharp);
    assert!(sharp.clone().all(|one| one.vertex != Some(start)), "{start}: {check:?}");
}

/// Once edges are doubled other ones are for a wire that begins elsewhere: start and edges are one edit, which adds as much as the finding
/// says.
#[test]
fn a_start_at_a_bend_that_is_too_sharp_brings_the_edges_that_are_doubled_for_it() {
    let mut editor = frame("bunny.obj");
    let fixes = editor.fixes(&app()).unwrap();
    let doubled = fixes.iter().find(|fix| fix.mends.code == Code::NoEulerPath).unwrap();
    editor.edit(&app(), &doubled.edit).unwrap();
    let before = editor.check(&app(), &[]).unwrap();
    let before_doubled = editor.state().doublings;
    let fixes = editor.fixes(&app()).unwrap();
    let starts: Vec<_> = fixes.iter().filter(|fix| fix.title.starts_with("Start at vertex")).collect();
    assert_eq!(starts.len(), 2, "{:?}", titles(&fixes, "bend_too_sharp"));
    for fix in starts {
        let added = fix.mends.remedies.iter().find_map(|remedy| match remedy {
            RemedyReport::StartAtVertex { added_mm } => *added_mm,
            _ => None,
        });
        assert!((fix.change.length_mm.unwrap() - added.unwrap()).abs() < 1e-6, "{fix:?}");
        assert!(fix.title.contains(&format!("twice (+{:.1} mm, ", added.unwrap())), "{}", fix.title);
        assert!(fix.title.ends_with(&format!("instead of {}", before_doubled.len())), "{}", fix.title);
        editor.edit(&app(), &fix.edit).unwrap();
        let check = editor.check(&app(), &[]).unwrap();
        let sharp = check.diagnostics.iter().filter(|one| one.code == Code::BendTooSharp);
        assert!(sharp.clone().all(|one| one.vertex != fix.mends.vertex), "{check:?}");
        let length = |check: &LiveCheck| check.wires[0].length_mm.unwrap();
        assert!((length(&check) - length(&before) - added.unwrap()).abs() < 1e-6, "{fix:?}");
        // One undo takes both back.
        assert!(editor.undo().unwrap().is_some() && editor.state().start.is_none());
        assert_eq!(editor.check(&app(), &[]).unwrap(), before);
    }
    // The start of another wire is not taken away.
    let far = json!({"edit": "draw", "from": null, "through_mm": [[900, 0, 0], [1000, 0, 0]], "to": null});
    edit(&mut editor, &far);
    let last = editor.state().next[0] - 1;
    edit(&mut editor, &json!({"edit": "start", "vertex": last}));
    let fixes = editor.fixes(&app()).unwrap();
    assert!(
        fixes.iter().all(|fix| !fix.title.starts_with("Start at vertex")),
        "{:?}",
        titles(&fixes, "bend_too_sharp")
    );
}
