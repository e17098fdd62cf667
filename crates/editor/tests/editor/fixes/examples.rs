//! Fixes of whole designs.

use proptest::prelude::*;
use serde_json::json;
use wirebend_editor::Editor;
use wirebend_planning::{DesignInput, NoProgress};

use super::{codes, mend, promised, titles};
use crate::{app, edit, example, open};

/// The edges of a mesh's faces on the 293 dollar bender.
pub(super) fn frame(name: &str) -> Editor {
    let input = DesignInput { face_edges: true, ..DesignInput::file(example(name)) };
    let (mut editor, _) = Editor::open(&input, None, &NoProgress).unwrap();
    edit(&mut editor, &json!({"edit": "machine", "machine": "wirebend-kit", "material": null}));
    editor
}

#[test]
fn fixes_keep_what_they_promise() {
    for name in ["truss-1.obj", "house.obj", "fold-back.obj", "two-parts.obj", "collinear.obj", "cube.obj"] {
        promised(&mut open(name), &app());
    }
    for name in ["bunny.obj", "teapot.obj"] {
        let mut editor = frame(name);
        let doubled = promised(&mut editor, &app()).remove(0);
        assert!(doubled.title.starts_with("Run the wire along "), "{}", doubled.title);
        editor.edit(&app(), &doubled.edit).unwrap();
        promised(&mut editor, &app());
    }
}

/// The lengths of the best open routes: other programs have found them too.
#[test]
fn what_is_doubled_is_the_least() {
    for (name, count, length_mm) in [("bunny.obj", 11, 11821.4), ("teapot.obj", 18, 10475.1)] {
        let mut editor = frame(name);
        let once: f64 = lengths(&editor).iter().sum();
        let fixes = editor.fixes(&app()).unwrap();
        let fix = fixes.iter().find(|fix| fix.mends.code.as_str() == "no_euler_path").unwrap();
        let added = length_mm - once;
        assert!(
            fix.title.starts_with(&format!("Run the wire along {count} edges twice (+{added:.1} mm, +")),
            "{}",
            fix.title
        );
        assert_eq!(fix.preview.doubled.len(), count);
        editor.edit(&app(), &fix.edit).unwrap();
        let check = editor.check(&app(), &[]).unwrap();
        assert!((check.wires[0].length_mm.unwrap() - length_mm).abs() < 0.1, "{name}");
        assert!(!codes(&check).contains(&"no_euler_path"));
    }
}

fn lengths(editor: &Editor) -> Vec<f64> {
    let view = editor.view();
    let at = |id: u32| nalgebra::Point3::from(view.vertices.iter().find(|v| v.id == id).unwrap().at_mm);
    view.edges.iter().map(|edge| (at(edge.a) - at(edge.b)).norm()).collect()
}

/// A cube has 8 odd vertices: two for each of 4 wires, and for each wire less an edge twice.
#[test]
fn a_cube_is_four_wires_or_fewer_with_edges_twice() {
    let mut editor = open("cube.obj");
    let fixes = promised(&mut editor, &app());
    assert_eq!(
        titles(&fixes, "no_euler_path"),
        [
            "Run the wire along 3 edges twice (+90.0 mm, +$0.18)",
            "Split into 2 wires, run along 2 edges twice (+60.0 mm)",
            "Split into 3 wires, run along 1 edge twice (+30.0 mm)",
            "Split into 4 wires, no doubled edges"
        ]
    );
    let further: Vec<usize> = fixes.iter().map(|fix| fix.preview.detached.len()).collect();
    assert_eq!(further, [0, 1, 2, 3]);
    let check = mend(&mut editor, &app(), "Split into 4 wires, no doubled edges");
    assert!(check.feasible);
    assert_eq!(check.wires.len(), 4);
    let length: f64 = check.wires.iter().map(|wire| wire.length_mm.unwrap()).sum();
    assert!((length - 12.0 * 30.0).abs() < 1e-9, "every edge once");
    let state = editor.state();
    assert_eq!((state.undo.as_deref(), state.wires), (Some("split into 4 wires"), 4));
    assert_eq!(codes(&check), [""; 0]);
    assert!(editor.fixes(&app()).unwrap().is_empty());
}

/// Doublings that were chosen before would not fit the wires; the start is where the first of them begins.
#[test]
fn several_wires_replace_earlier_doublings() {
    let mut editor = open("cube.obj");
    edit(&mut editor, &json!({"edit": "doublings", "edges": [0]}));
    edit(&mut editor, &json!({"edit": "start", "vertex": 7}));
    let check = mend(&mut editor, &app(), "Split into 4 wires, no doubled edges");
    assert!(check.feasible, "{check:?}");
    assert_eq!(editor.state().doublings, [0; 0]);
    assert_eq!(check.wires[0].route[0], 7);
}

/// One wire that comes back to where it started, and several wires, exclude each other.
#[test]
fn a_closed_wire_is_the_only_one() {
    let mut editor = open("cube.obj");
    edit(&mut editor, &json!({"edit": "wires", "wires": 3}));
    edit(&mut editor, &json!({"edit": "reversed", "reversed": true}));
    edit(&mut editor, &json!({"edit": "closed", "closed": true}));
    let state = editor.state();
    assert_eq!((state.wires, state.closed, state.reversed), (1, true, true));
    let offered = titles(&promised(&mut editor, &app()), "no_euler_path");
    assert!(offered.contains(&"Split into 4 open wires, no doubled edges".to_owned()), "{offered:?}");
    let check = mend(&mut editor, &app(), "Run the wire along 4 edges twice (+120.0 mm, +$0.24)");
    assert_eq!(check.wires[0].route.first(), check.wires[0].route.last());
    edit(&mut editor, &json!({"edit": "wires", "wires": 2}));
    assert_eq!((editor.state().wires, editor.state().closed), (2, false));
    editor.undo().unwrap();
    assert_eq!((editor.state().wires, editor.state().closed), (1, true));
    let none = serde_json::from_value(json!({"edit": "wires", "wires": 0})).unwrap();
    assert!(editor.edit(&app(), &none).is_err());
}

/// The wire runs from its other end.
#[test]
fn a_reversed_wire_ends_where_it_would_start() {
    let mut editor = open("house.obj");
    let there = editor.check(&app(), &[]).unwrap().wires[0].route.clone();
    edit(&mut editor, &json!({"edit": "reversed", "reversed": true}));
    let mut back = editor.check(&app(), &[]).unwrap().wires[0].route.clone();
    back.reverse();
    assert_eq!(back, there);
}

/// A strut that ends in the air can only be doubled by folding the wire back.
#[test]
fn a_fold_back_is_not_made_where_two_wires_do() {
    let mut editor = open("fold-back.obj");
    let fixes = promised(&mut editor, &app());
    let offered = titles(&fixes, "no_euler_path");
    let two = "Split into 2 wires, no doubled edges".to_owned();
    assert!(offered.contains(&two), "{offered:?}");
    // Doubled anyway, the way out is offered again.
    let doubled = fixes.iter().find(|fix| fix.title.starts_with("Run the wire along ")).unwrap();
    editor.edit(&app(), &doubled.edit).unwrap();
    let fixes = promised(&mut editor, &app());
    assert!(titles(&fixes, "fold_back").contains(&two), "{fixes:?}");
}

/// Where one machine's limits are tight and a design is large, what can be tried is shared out.
#[test]
fn a_large_design_with_many_flaws_gets_fixes_for_many_of_them() {
    let mut editor = frame("teapot.obj");
    let doubled = editor.fixes(&app()).unwrap().remove(0);
    editor.edit(&app(), &doubled.edit).unwrap();
    let fixes = editor.fixes(&app()).unwrap();
    let mut mended: Vec<_> =
        fixes.iter().map(|fix| (fix.mends.code.as_str(), fix.mends.edge, fix.mends.vertex)).collect();
    mended.dedup();
    assert!(mended.len() > 20, "{mended:?}");
}

/// Any drawing, flaws included.
fn any_design() -> impl Strategy<Value = Vec<serde_json::Value>> {
    let points = prop::collection::vec(prop::array::uniform3(-60..60_i32), 2..10);
    let edges = prop::collection::vec((0..10_usize, 0..10_usize), 1..18);
    let start = prop::option::of(0..10_u32);
    (points, edges, start, prop::collection::btree_set(0..18_u32, 0..3)).prop_map(
        |(points, edges, start, doubled)| {
            let count = points.len();
            let edges: Vec<[usize; 2]> =
                edges.into_iter().map(|(a, b)| [a % count, b % count]).filter(|[a, b]| a != b).collect();
            let doubled: Vec<u32> =
                doubled.into_iter().filter(|&edge| (edge as usize) < edges.len()).collect();
            let vertices: Vec<_> = points.into_iter().map(|point| json!({"at_mm": point})).collect();
            let start = start.filter(|&id| edges.iter().flatten().any(|&end| end == id as usize));
            vec![
                json!({"edit": "paste", "vertices": vertices, "edges": edges}),
                json!({"edit": "doublings", "edges": doubled}),
                json!({"edit": "start", "vertex": start}),
            ]
        },
    )
}

/// Edge 3 is offered no move that takes it from the edge that it meets into another.
#[test]
fn an_edge_is_not_moved_from_one_that_it_meets_into_another() {
    let at = [
        [-49, -19, 51],
        [-41, 0, 18],
        [-34, -11, -33],
        [-32, -59, -12],
        [0, 0, 0],
        [-9, -27, 41],
        [50, -15, -10],
        [0, 0, 0],
        [1, 21, -8],
    ];
    let vertices: Vec<_> = at.iter().map(|at| json!({"at_mm": at})).collect();
    let edges = [[8, 0], [3, 1], [6, 0], [1, 5], [2, 0]];
    let mut editor = Editor::new(&app(), Some("wirebend-kit"), None).unwrap();
    edit(&mut editor, &json!({"edit": "paste", "vertices": vertices, "edges": edges}));
    edit(&mut editor, &json!({"edit": "start", "vertex": 6}));
    let fixes = promised(&mut editor, &app());
    assert!(fixes.iter().any(|fix| fix.mends.code.as_str() == "edges_meet"), "{fixes:?}");
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, ..ProptestConfig::default() })]
    #[test]
    fn whatever_is_drawn_fixes_keep_what_they_promise(edits in any_design(), machine in 0..3_usize) {
        let machine = ["wirebend-kit", "pensa-diwire-pro", "grbl-bender"][machine];
        let mut editor = Editor::new(&app(), Some(machine), None).unwrap();
        for request in &edits {
            edit(&mut editor, request);
        }
        promised(&mut editor, &app());
    }
}
