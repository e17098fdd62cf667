//! Edits, undo and redo, and what a front end draws of them.

use std::collections::BTreeMap;

use proptest::prelude::*;
use proptest::strategy::ValueTree;
use serde_json::{Value, json};
use wirebend_editor::{DesignView, EditRequest, Editor, RestPlace, ViewChange};
use wirebend_error::{ErrorCode, ErrorRemedy};

use crate::{app, edit, open};

/// What a front end has that draws only what changes.
#[derive(Debug, Default, PartialEq)]
struct Drawn {
    vertices: BTreeMap<u32, ([f64; 3], bool)>,
    edges: BTreeMap<u32, [u32; 2]>,
}

impl Drawn {
    fn of(view: &DesignView) -> Self {
        Self {
            vertices: view.vertices.iter().map(|v| (v.id, (v.at_mm, v.support))).collect(),
            edges: view.edges.iter().map(|e| (e.id, [e.a, e.b])).collect(),
        }
    }

    fn draw(&mut self, change: &ViewChange) {
        self.edges.retain(|id, _| !change.gone_edges.contains(id));
        self.vertices.retain(|id, _| !change.gone_vertices.contains(id));
        self.vertices.extend(change.vertices.iter().map(|v| (v.id, (v.at_mm, v.support))));
        self.edges.extend(change.edges.iter().map(|e| (e.id, [e.a, e.b])));
    }
}

/// Everything that a person can ask for, once, on a cube, and what a menu calls it.
pub fn every_edit() -> Vec<(Value, &'static str)> {
    let turn = json!([[0, -1, 0, 0], [1, 0, 0, 0], [0, 0, 1, 5], [0, 0, 0, 1]]);
    vec![
        (json!({"edit": "draw", "from": 0, "through_mm": [[1, 2, 3], [4, 5, 6]], "to": 7}), "draw"),
        (json!({"edit": "draw", "from": 0, "to": 7}), "connect vertices"),
        (
            json!({"edit": "paste", "vertices": [{"at_mm": [1, 1, 1]}, {"at_mm": [2, 2, 2], "support": true}],
            "edges": [[0, 1]]}),
            "paste",
        ),
        (json!({"edit": "delete", "vertices": [1, 2]}), "delete 2 vertices"),
        (json!({"edit": "delete", "edges": [3]}), "delete edge"),
        (json!({"edit": "move", "vertices": [4], "by_mm": [0.5, 0, -1]}), "move vertex"),
        (
            json!({"edit": "place", "positions": [{"vertex": 0, "at_mm": [9, 9, 9]}, {"vertex": 1, "at_mm": [8, 8, 8]}]}),
            "place 2 vertices",
        ),
        (json!({"edit": "length", "edge": 2, "length_mm": 12.5, "stays": 0, "rest": "stays"}), "set length"),
        (
            json!({"edit": "angle", "vertex": 0, "between": [0, 1], "angle_deg": 60, "rest": "stays"}),
            "set angle",
        ),
        (json!({"edit": "split", "edge": 2, "at": 0.5}), "split edge"),
        (json!({"edit": "merge", "vertices": [0, 1, 2], "at": "centre"}), "merge 3 vertices"),
        (json!({"edit": "transform", "vertices": [0, 1], "matrix": turn}), "transform 2 vertices"),
        (
            json!({"edit": "rotate", "vertices": [0, 1], "axis": "y", "through_mm": [5, 0, 0], "angle_deg": 30}),
            "rotate 2 vertices",
        ),
        (
            json!({"edit": "circle", "centre_mm": [0, 0, 60], "plane": "xy", "radius_mm": 40, "edges": 12}),
            "circle",
        ),
        (
            json!({"edit": "polygon", "centre_mm": [0, 0, 60], "plane": "xz", "sides": 6, "measure": "flats",
            "size_mm": 40, "turn_deg": 30}),
            "polygon",
        ),
        (
            json!({"edit": "helix", "centre_mm": [0, 0, 60], "plane": "yz", "radius_mm": 40, "pitch_mm": 20,
            "turns": 2.5, "edges_per_turn": 8, "left": true}),
            "helix",
        ),
        (
            json!({"edit": "mirror", "vertices": [0, 1, 2], "point_mm": [0, 0, 50], "normal": [0, 0, 2], "copy": true}),
            "mirror",
        ),
        (json!({"edit": "array", "vertices": [0, 1], "step": turn, "count": 3}), "array"),
        (json!({"edit": "support", "vertices": [5], "support": true}), "fix support"),
        (json!({"edit": "joint", "vertices": [5], "joint": {"kind": "zip-tie", "mass_g": 0.3}}), "set joint"),
        (
            json!({"edit": "joint", "vertices": [5, 4], "joint": {"kind": "solder", "mass_g": 0}}),
            "set joints",
        ),
        (json!({"edit": "ceiling", "edges": [0, 1], "ceiling": true}), "mark as ceiling"),
        (json!({"edit": "weld", "tolerance_mm": 31}), "weld"),
        (json!({"edit": "detach", "edges": [0, 1]}), "detach 2 edges"),
        (json!({"edit": "straighten", "edges": [0, 1], "tolerance_mm": 40}), "straighten"),
        (json!({"edit": "doublings", "edges": [0, 4]}), "doubled edges"),
        (json!({"edit": "start", "vertex": 6}), "start of the wire"),
        (json!({"edit": "collisions", "clearance_mm": 0.5, "sag": true}), "collision settings"),
        (json!({"edit": "pause", "vertex": 6, "pass": 2, "note": "turn the part"}), "pause point"),
        (json!({"edit": "machine", "machine": "pensa-diwire-pro", "material": "steel-3mm"}), "machine"),
        (json!({"edit": "notes", "text": "for the window"}), "notes"),
        (json!({"edit": "units", "units": "inch"}), "units"),
        (
            json!({"edit": "several", "label": "split at vertex 2", "edits": [{"edit": "doublings", "edges": [1]},
            {"edit": "detach", "edges": [0, 2]}, {"edit": "start", "vertex": 8}, {"edit": "delete", "edges": [1]}]}),
            "split at vertex 2",
        ),
        (
            json!({"edit": "several", "label": "round a side", "edits": [{"edit": "delete", "edges": [4, 7]},
            {"edit": "round", "edges": [0, 3, 5], "tolerance_mm": 16, "step_deg": 20, "least_edge_mm": 5}]}),
            "round a side",
        ),
    ]
}

/// A joint that is taken away was there; it is shown until then.
#[test]
fn a_joint_is_shown_and_taken_away() {
    let mut editor = open("cube.obj");
    let joint = json!({"kind": "snap-fit", "mass_g": 1.5});
    let change = edit(&mut editor, &json!({"edit": "joint", "vertices": [5], "joint": joint}));
    assert_eq!(serde_json::to_value(change.vertices[0]).unwrap()["joint"], joint);
    let change = edit(&mut editor, &json!({"edit": "joint", "vertices": [5], "joint": null}));
    assert_eq!(change.state.undo.as_deref(), Some("remove joint"));
    assert!(serde_json::to_value(change.vertices[0]).unwrap().get("joint").is_none());
}

#[test]
fn every_edit_is_one_thing_to_undo() {
    for (request, label) in every_edit() {
        let mut editor = open("cube.obj");
        let (before, view) = (editor.document().clone(), editor.view());
        let mut drawn = Drawn::of(&view);
        let change = edit(&mut editor, &request);
        assert_eq!(change.state.undo.as_deref(), Some(label), "{request}");
        assert!(change.state.changed && change.state.redo.is_none());
        assert_ne!(editor.document(), &before, "{request}");
        let after = editor.document().clone();
        drawn.draw(&change);
        assert_eq!(drawn, Drawn::of(&editor.view()), "{request}");
        drawn.draw(&editor.undo().unwrap().unwrap());
        assert_eq!((editor.document(), &drawn), (&before, &Drawn::of(&view)), "{request}");
        let again = editor.redo().unwrap().unwrap();
        assert_eq!((editor.document(), again.state.redo), (&after, None), "{request}");
        // As it was sent, it can be sent again.
        let parsed: EditRequest = serde_json::from_value(request.clone()).unwrap();
        assert_eq!(
            serde_json::from_value::<EditRequest>(serde_json::to_value(&parsed).unwrap()).unwrap(),
            parsed
        );
    }
}

/// Three sides of a face are most of a square, whose corners lie on a circle of radius 21.2 mm.
#[test]
fn a_chain_is_rounded_to_the_step_and_the_shortest_edge() {
    let mut editor = open("cube.obj");
    edit(&mut editor, &json!({"edit": "delete", "edges": [4, 7]}));
    let round = json!({"edit": "round", "edges": [0, 3, 5], "tolerance_mm": 16, "step_deg": 20});
    let change = edit(&mut editor, &round);
    assert_eq!(change.state.undo.as_deref(), Some("round"));
    assert_eq!(editor.view().edges.len(), 7 + 14, "270 degrees in steps of 20");
    editor.undo().unwrap();
    let mut shorter = round.clone();
    shorter["least_edge_mm"] = json!(12);
    edit(&mut editor, &shorter);
    // 2 · 21.21 · sin(135°/8) = 12.3 mm, and of a ninth of it 11.0 mm.
    assert_eq!(editor.view().edges.len(), 7 + 8);
}

#[test]
fn what_changes_nothing_is_nothing_to_undo() {
    let mut editor = open("cube.obj");
    let before = editor.state();
    for request in [
        json!({"edit": "units", "units": "mm"}),
        json!({"edit": "move", "vertices": [1], "by_mm": [0, 0, 0]}),
        json!({"edit": "start", "vertex": null}),
        json!({"edit": "part-look", "edge": 1, "look": {"name": " "}}),
        json!({"edit": "machine", "machine": "wirebend-kit", "material": null}),
        json!({"edit": "detach", "edges": (0..12).collect::<Vec<_>>()}),
        json!({"edit": "several", "label": "there and back", "edits": [{"edit": "start", "vertex": 1},
            {"edit": "start", "vertex": null}]}),
    ] {
        let change = edit(&mut editor, &request);
        assert_eq!(change.state, before, "{request}");
        assert!(change.vertices.is_empty() && change.edges.is_empty());
    }
}

#[test]
fn what_cannot_be_done_is_said_and_changes_nothing() {
    let mut editor = open("cube.obj");
    let before = editor.document().clone();
    let flat = json!([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 0, 0], [0, 0, 0, 1]]);
    let projective = json!([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 1, 1]]);
    for (request, code, said) in [
        (json!({"edit": "draw", "from": 99, "to": 1}), "edit", "no vertex 99"),
        (json!({"edit": "draw"}), "edit", "strand"),
        (json!({"edit": "delete", "edges": [77]}), "edit", "no edge 77"),
        (json!({"edit": "split", "edge": 0, "at": 1.5}), "edit", "1.5"),
        (json!({"edit": "transform", "vertices": [0], "matrix": flat}), "edit", "not invertible"),
        (json!({"edit": "transform", "vertices": [0], "matrix": projective}), "edit", "0 0 0 1"),
        (
            json!({"edit": "mirror", "vertices": [0], "point_mm": [0, 0, 0], "normal": [0, 0, 0], "copy": false}),
            "edit",
            "no direction",
        ),
        (json!({"edit": "weld", "tolerance_mm": -1}), "edit", "-1 mm"),
        (json!({"edit": "detach", "edges": [0, 77]}), "edit", "no edge 77"),
        (json!({"edit": "straighten", "edges": [0], "tolerance_mm": 1}), "edit", "at least 2 edges"),
        (json!({"edit": "straighten", "edges": [0, 1], "tolerance_mm": -3}), "edit", "-3 mm"),
        (
            json!({"edit": "round", "edges": [0, 1], "tolerance_mm": 1, "step_deg": 10, "least_edge_mm": -2}),
            "edit",
            "-2 mm",
        ),
        (json!({"edit": "round", "edges": [0, 1], "tolerance_mm": 1, "step_deg": 0}), "edit", "0°"),
        (
            json!({"edit": "several", "label": "both", "edits": [{"edit": "start", "vertex": 1},
                {"edit": "delete", "edges": [77]}]}),
            "edit",
            "no edge 77",
        ),
        (json!({"edit": "doublings", "edges": [0, 99]}), "no-edge", "99"),
        (json!({"edit": "start", "vertex": 50}), "no-vertex", "50"),
        (json!({"edit": "machine", "machine": "no-such", "material": null}), "profile-unknown", "no-such"),
        (
            json!({"edit": "place", "positions": [{"vertex": 0, "at_mm": [1, 2, 3]}, {"vertex": 99, "at_mm": [0, 0, 0]}]}),
            "edit",
            "no vertex 99",
        ),
    ] {
        let parsed: EditRequest = serde_json::from_value(request.clone()).unwrap();
        let error = editor.edit(&app(), &parsed).unwrap_err();
        assert!(error.to_string().contains(said), "{request}: {error}");
        assert_eq!(error.code(), code, "{request}");
        assert_eq!(editor.document(), &before, "{request}");
    }
    for unknown in [json!({"edit": "paint"}), json!({"edit": "draw", "colour": 1}), json!({"edit": "move"})] {
        assert!(serde_json::from_value::<EditRequest>(unknown.clone()).is_err(), "{unknown}");
    }
}

/// Each says what to do instead.
#[test]
fn lengths_and_angles_that_cannot_be_have_a_remedy() {
    let mut editor = open("cube.obj");
    let before = editor.document().clone();
    let length = |mm: f64, rest| EditRequest::Length { edge: 2, length_mm: mm, stays: 0, rest };
    let angle = |deg: f64, between, rest| EditRequest::Angle {
        vertex: 0,
        between,
        angle_deg: deg,
        normal: None,
        rest,
    };
    let (alone, all) = (RestPlace::Stays, RestPlace::Follows);
    for (request, remedy, said) in [
        (length(0.0, alone), ErrorRemedy::EnterLength, "0 mm is no length"),
        (length(-4.0, alone), ErrorRemedy::EnterLength, "-4 mm is no length"),
        (length(f64::NAN, alone), ErrorRemedy::EnterLength, "NaN mm is no length"),
        (length(30.0, all), ErrorRemedy::MoveEndAlone, "closed loop"),
        (angle(f64::INFINITY, Some([0, 1]), alone), ErrorRemedy::EnterAngle, "inf° is no angle"),
        (angle(181.0, Some([0, 1]), alone), ErrorRemedy::EnterAngle, "at most 180°"),
        (angle(90.0, None, alone), ErrorRemedy::SelectTwoEdges, "vertex 0 has 3 edges"),
    ] {
        let error = editor.edit(&app(), &request).unwrap_err();
        assert!(error.to_string().contains(said), "{error}");
        assert_eq!((error.code(), error.remedies()), (ErrorCode::Edit, vec![remedy]), "{error}");
        assert_eq!(editor.document(), &before);
    }
}

/// The wirebend-kit feeds no less than 25 mm: a quarter of 36 mm radius has two chords of 27.6 mm there, and six without a machine.
/// What is said to be the nearest radius is one that its checks let pass.
#[test]
fn a_fillet_keeps_to_the_machine_of_the_design() {
    let app = app();
    let hook = json!({"edit": "draw", "through_mm": [[0, 0, 0], [0, 0, 120], [120, 0, 120], [120, 0, 0]]});
    let fillet =
        |radius: f64| json!({"edit": "fillet", "vertices": [1, 2], "radius_mm": radius, "step_deg": 15});
    for (machine, chords) in [(None, 6), (Some("wirebend-kit"), 2)] {
        let mut editor = Editor::new(&app, machine, None).unwrap();
        edit(&mut editor, &hook);
        let change = edit(&mut editor, &fillet(36.0));
        assert_eq!(change.state.undo.as_deref(), Some("round 2 corners"));
        assert_eq!(editor.view().edges.len(), 3 + 2 * chords, "{machine:?}");
    }
    let mut editor = Editor::new(&app, Some("wirebend-kit"), None).unwrap();
    edit(&mut editor, &hook);
    for radius in [10.0, 55.0] {
        let request = serde_json::from_value(fillet(radius)).unwrap();
        let error = editor.edit(&app, &request).unwrap_err();
        let remedies = error.remedies();
        let [ErrorRemedy::UseRadius { radius: nearest }] = remedies.as_slice() else { panic!("{error}") };
        let nearest: f64 = nearest.trim_end_matches(" mm").parse().unwrap();
        assert!((25.0..55.0).contains(&nearest), "{nearest}");
        edit(&mut editor, &fillet(nearest));
        let check = editor.check(&app, &[]).unwrap();
        assert!(check.feasible, "{nearest}: {:?}", check.diagnostics);
        editor.undo().unwrap();
    }
}

/// A quarter turn leaves whole numbers whole.
#[test]
fn a_turn_is_about_the_axis_through_its_point() {
    let mut editor = open("cube.obj");
    for (axis, expected) in [("x", [30.0, 30.0, 0.0]), ("y", [0.0, 30.0, 30.0]), ("z", [30.0, 0.0, 30.0])] {
        let turn = json!({"edit": "rotate", "vertices": [7], "axis": axis, "through_mm": [15, 15, 15], "angle_deg": -90});
        let turned = edit(&mut editor, &turn).vertices[0].at_mm;
        assert_eq!(json!(turned), json!(expected), "{axis}");
        editor.undo().unwrap();
    }
    let turn =
        json!({"edit": "rotate", "vertices": [7], "axis": "z", "through_mm": [0, 0, 0], "angle_deg": 45});
    let [x, y, z] = edit(&mut editor, &turn).vertices[0].at_mm;
    assert!(x.abs() < 1e-9 && (y - 30.0 * 2.0_f64.sqrt()).abs() < 1e-9 && (z - 30.0).abs() < 1e-9);
}

/// A step of a user who tries everything.
fn any_step() -> impl Strategy<Value = Option<Value>> {
    let id = || 0..40_u32;
    let point = || prop::array::uniform3(-200.0..200.0_f64);
    let edits = prop_oneof![
        4 => (prop::option::of(id()), prop::collection::vec(point(), 1..3), prop::option::of(id()))
            .prop_map(|(from, through, to)| json!({"edit": "draw", "from": from, "through_mm": through, "to": to})),
        3 => (prop::collection::btree_set(id(), 1..4), point())
            .prop_map(|(some, by)| json!({"edit": "move", "vertices": some, "by_mm": by})),
        1 => prop::collection::btree_set(id(), 1..3).prop_map(|some| json!({"edit": "delete", "vertices": some})),
        1 => prop::collection::btree_set(id(), 2..4)
            .prop_map(|some| json!({"edit": "merge", "vertices": some, "at": "first"})),
        1 => (id(), 0.1..0.9_f64).prop_map(|(edge, at)| json!({"edit": "split", "edge": edge, "at": at})),
        1 => prop::collection::btree_set(id(), 1..4).prop_map(|some| json!({"edit": "detach", "edges": some})),
        1 => (prop::collection::btree_set(id(), 2..4), 0.0..200.0_f64).prop_map(|(some, tolerance)| {
            let straighten = json!({"edit": "straighten", "edges": some, "tolerance_mm": tolerance});
            json!({"edit": "several", "label": "both", "edits": [straighten, {"edit": "start", "vertex": null}]})
        }),
        1 => prop::collection::btree_set(id(), 0..3).prop_map(|some| json!({"edit": "doublings", "edges": some})),
        1 => prop::option::of(id()).prop_map(|vertex| json!({"edit": "start", "vertex": vertex})),
        1 => "[a-z]{0,8}".prop_map(|text| json!({"edit": "notes", "text": text})),
    ];
    // Undo is pressed as often as anything is done.
    prop_oneof![3 => edits.prop_map(Some), 2 => Just(None)]
}

/// Does all of it; how many steps changed something. Whatever was done, the design can be walked back to the first
/// and forth to the last, and a view that draws only what changes has drawn it.
fn walk(steps: &[Option<Value>], seed: u64) -> usize {
    let app = app();
    let mut editor = Editor::new(&app, Some("wirebend-kit"), None).unwrap();
    let first = editor.document().clone();
    let (mut drawn, mut seed, mut changes) = (Drawn::default(), seed, 0);
    for step in steps {
        let change = if let Some(request) = step {
            let request: EditRequest = serde_json::from_value(request.clone()).unwrap();
            editor.edit(&app, &request).ok()
        } else {
            seed = seed.rotate_left(7) ^ 0x9E37_79B9;
            if seed.is_multiple_of(3) { editor.redo().unwrap() } else { editor.undo().unwrap() }
        };
        changes += usize::from(change.is_some());
        if let Some(change) = &change {
            drawn.draw(change);
        }
    }
    assert_eq!(drawn, Drawn::of(&editor.view()));
    while editor.redo().unwrap().is_some() {}
    let last = editor.document().clone();
    let mut count = 0;
    while editor.undo().unwrap().is_some() {
        count += 1;
    }
    assert_eq!(editor.document(), &first);
    assert!(!editor.is_changed());
    while editor.redo().unwrap().is_some() {
        count -= 1;
    }
    assert_eq!((editor.document(), count), (&last, 0));
    changes
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, ..ProptestConfig::default() })]
    #[test]
    fn edits_and_undos_return_the_same_design(
        steps in prop::collection::vec(any_step(), 0..200), seed in any::<u64>()
    ) {
        walk(&steps, seed);
    }
}

#[test]
fn ten_thousand_edits_and_undos_return_the_same_design() {
    let mut runner = proptest::test_runner::TestRunner::deterministic();
    let steps: Vec<Option<Value>> =
        (0..10_000).map(|_| any_step().new_tree(&mut runner).unwrap().current()).collect();
    let changes = walk(&steps, 1);
    assert!(changes > 3000, "only {changes} of them changed anything");
}
