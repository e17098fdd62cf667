//! Construction lines: made of edges and made edges of, and nothing to the wire.

use proptest::prelude::*;
use serde_json::{Value, json};
use wirebend_editor::{EditRequest, Editor, ViewChange};

use crate::{app, edit, open};

fn construction(make: &str, of: &str, places: &[u32]) -> Value {
    json!({"edit": "construction", "change": {"make": make, of: places}})
}

/// A cube is drawn again of its lines as it was, with its corners joined.
#[test]
fn edges_become_lines_and_lines_become_edges_that_join() {
    let mut editor = open("cube.obj");
    let before = editor.view();
    let edges: Vec<u32> = before.edges.iter().map(|edge| edge.id).collect();
    let ViewChange { gone_vertices, gone_edges, state, .. } =
        edit(&mut editor, &construction("lines", "edges", &edges[..5]));
    assert_eq!((gone_edges.len(), state.construction_mm.len()), (5, 5));
    assert!(gone_vertices.len() < 8, "corners with other edges stay: {gone_vertices:?}");
    let all = edit(&mut editor, &construction("lines", "edges", &edges[5..]));
    assert_eq!((editor.view().vertices.len(), editor.view().edges.len()), (0, 0));
    assert_eq!(all.state.construction_mm.len(), edges.len());
    let length = |[a, b]: &[[f64; 3]; 2]| a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt();
    let of = |vertex: u32| before.vertices.iter().find(|known| known.id == vertex).unwrap().at_mm;
    let drawn: f64 = before.edges.iter().map(|edge| length(&[of(edge.a), of(edge.b)])).sum();
    let lines: f64 = all.state.construction_mm.iter().map(length).sum();
    assert!((drawn - lines).abs() < 1e-9, "{lines} mm of lines for {drawn} mm of edges");

    let back: Vec<u32> = (0..u32::try_from(edges.len()).unwrap()).collect();
    edit(&mut editor, &construction("edges", "lines", &back));
    let after = editor.view();
    assert_eq!((after.vertices.len(), after.edges.len()), (before.vertices.len(), before.edges.len()));
    assert_eq!(after.state.construction_mm, [] as [[[f64; 3]; 2]; 0]);
    for _ in 0..3 {
        editor.undo().unwrap().unwrap();
    }
    assert_eq!((editor.view().vertices, editor.view().edges), (before.vertices, before.edges));
}

/// Where an edge lies already a line only goes, and a line that is deleted leaves the wire as it is.
#[test]
fn a_line_on_an_edge_makes_no_second_one() {
    let mut editor = open("cube.obj");
    let before = editor.view();
    let first = &before.edges[0];
    edit(&mut editor, &construction("lines", "edges", &[first.id]));
    edit(&mut editor, &json!({"edit": "draw", "from": first.a, "to": first.b}));
    let on_it = edit(&mut editor, &construction("edges", "lines", &[0]));
    assert_eq!((on_it.edges.len(), on_it.state.construction_mm.len()), (0, 0));
    assert_eq!(editor.view().edges.len(), before.edges.len());
    edit(&mut editor, &construction("lines", "edges", &[before.edges[1].id]));
    let gone = edit(&mut editor, &construction("nothing", "lines", &[0]));
    assert_eq!((gone.gone_edges.len(), gone.state.construction_mm.len()), (0, 0));
}

#[test]
fn what_is_not_there_is_refused() {
    let mut editor = open("cube.obj");
    for (request, said) in [
        (construction("lines", "edges", &[99]), "no edge 99 to make a construction line of"),
        (construction("edges", "lines", &[0]), "no construction line 0"),
        (
            construction("nothing", "lines", &[3]),
            "no construction line 3 in this design, counted from 0: it has 0",
        ),
        (
            json!({"edit": "move", "vertices": [0], "lines": [1], "by_mm": [1, 0, 0]}),
            "no construction line 1 in this design, counted from 0: it has 0",
        ),
        (json!({"edit": "delete", "lines": [0]}), "it has 0"),
        (draw(&[[0.0, 0.0, 0.0]]), "goes through 1 places; it has to be 2 or more"),
        (
            draw(&[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 0.0, 0.0]]),
            "construction line 2 of this strand has no length",
        ),
        (draw(&[[0.0, 0.0, 0.0], [2e6, 0.0, 0.0]]), "is not a position"),
    ] {
        let request: EditRequest = serde_json::from_value(request).unwrap();
        let error = editor.edit(&app(), &request).unwrap_err();
        assert!(error.to_string().contains(said), "{error}");
    }
    assert!(editor.undo().unwrap().is_some(), "only the machine was chosen before");
}

/// What is planned is the wire alone: its hash is that of a design that has no lines.
#[test]
fn lines_are_no_part_of_what_is_bent() {
    let mut editor = open("u-sample.obj");
    let drawn = edit(&mut editor, &json!({"edit": "draw", "through_mm": [[0, 0, 50], [90, 0, 50]]}));
    let with_lines = {
        edit(&mut editor, &construction("lines", "edges", &[drawn.edges[0].id]));
        editor.document().clone()
    };
    let mut without = with_lines.clone();
    without.construction.clear();
    assert_eq!(with_lines.design_hash().unwrap(), without.design_hash().unwrap());
    assert_ne!(with_lines, without);
}

fn draw(through_mm: &[[f64; 3]]) -> Value {
    json!({"edit": "construction", "change": {"make": "draw", "through_mm": through_mm}})
}

fn lines(editor: &Editor) -> Vec<[[f64; 3]; 2]> {
    editor.state().construction_mm
}

/// A line between each place and the next, as one thing to undo; the wire is as it was.
#[test]
fn lines_are_drawn_from_place_to_place() {
    let mut editor = open("cube.obj");
    let before = editor.document().clone();
    let drawn = edit(&mut editor, &draw(&[[0.0, 0.0, 0.0], [0.0, 0.0, 60.0], [40.0, 0.0, 60.0]]));
    assert_eq!(drawn.state.undo.as_deref(), Some("2 construction lines"));
    assert!(drawn.vertices.is_empty() && drawn.edges.is_empty());
    assert_eq!(lines(&editor), [[[0.0, 0.0, 0.0], [0.0, 0.0, 60.0]], [[0.0, 0.0, 60.0], [40.0, 0.0, 60.0]]]);
    editor.undo().unwrap().unwrap();
    assert_eq!(editor.document(), &before);
}

/// Two lines and the cube: what is done to vertices and lines together is one thing to undo, and says what it is.
#[test]
fn vertices_and_lines_change_together() {
    let quarter = json!([[0, -1, 0, 0], [1, 0, 0, 0], [0, 0, 1, 5], [0, 0, 0, 1]]);
    let (low, high) = ([[0.0, 0.0, 0.0], [10.0, 0.0, 0.0]], [[0.0, 0.0, 60.0], [40.0, 0.0, 60.0]]);
    let mirrored = [[0.0, 0.0, 40.0], [40.0, 0.0, 40.0]];
    for (request, label, after) in [
        (
            json!({"edit": "move", "vertices": [0], "lines": [1], "by_mm": [0, 5, 0]}),
            "move vertex and construction line",
            vec![low, [[0.0, 5.0, 60.0], [40.0, 5.0, 60.0]]],
        ),
        (
            json!({"edit": "move", "vertices": [], "lines": [0, 1], "by_mm": [0, 0, 1]}),
            "move 2 construction lines",
            vec![[[0.0, 0.0, 1.0], [10.0, 0.0, 1.0]], [[0.0, 0.0, 61.0], [40.0, 0.0, 61.0]]],
        ),
        (
            json!({"edit": "transform", "vertices": [0, 1], "lines": [1], "matrix": quarter}),
            "transform 2 vertices and construction line",
            vec![low, [[0.0, 0.0, 65.0], [0.0, 40.0, 65.0]]],
        ),
        (
            json!({"edit": "rotate", "vertices": [7], "lines": [0], "axis": "y", "through_mm": [0, 0, 0], "angle_deg": 90}),
            "rotate vertex and construction line",
            vec![[[0.0, 0.0, 0.0], [0.0, 0.0, -10.0]], high],
        ),
        (
            json!({"edit": "mirror", "vertices": [], "lines": [1], "point_mm": [0, 0, 50], "normal": [0, 0, 2], "copy": false}),
            "mirror",
            vec![low, mirrored],
        ),
        (
            json!({"edit": "mirror", "vertices": [0], "lines": [1], "point_mm": [0, 0, 50], "normal": [0, 0, 2], "copy": true}),
            "mirror",
            vec![low, high, mirrored],
        ),
        // A line in the plane is its own image.
        (
            json!({"edit": "mirror", "vertices": [], "lines": [0, 1], "point_mm": [0, 0, 0], "normal": [0, 0, 1], "copy": true}),
            "mirror",
            vec![low, high, [[0.0, 0.0, -60.0], [40.0, 0.0, -60.0]]],
        ),
        (
            json!({"edit": "array", "vertices": [0, 1], "lines": [0], "step": [[1, 0, 0, 0], [0, 1, 0, 7], [0, 0, 1, 0], [0, 0, 0, 1]], "count": 2}),
            "array",
            vec![low, high, [[0.0, 7.0, 0.0], [10.0, 7.0, 0.0]], [[0.0, 14.0, 0.0], [10.0, 14.0, 0.0]]],
        ),
        (json!({"edit": "delete", "edges": [3], "lines": [0]}), "delete", vec![high]),
        (json!({"edit": "delete", "lines": [1]}), "delete construction line", vec![low]),
    ] {
        let mut editor = open("cube.obj");
        edit(&mut editor, &draw(&low));
        edit(&mut editor, &draw(&high));
        let before = editor.document().clone();
        let change = edit(&mut editor, &request);
        assert_eq!(change.state.undo.as_deref(), Some(label), "{request}");
        for (line, wanted) in lines(&editor).iter().flatten().flatten().zip(after.iter().flatten().flatten())
        {
            assert!((line - wanted).abs() < 1e-9, "{request}: {:?}", lines(&editor));
        }
        assert_eq!(lines(&editor).len(), after.len(), "{request}");
        let touched = !change.vertices.is_empty() || !change.gone_edges.is_empty();
        let names_wire = request["vertices"].as_array().is_some_and(|list| !list.is_empty())
            || request["edges"].is_array();
        assert_eq!(touched, names_wire, "{request}");
        editor.undo().unwrap().unwrap();
        assert_eq!(editor.document(), &before, "{request}");
    }
}

/// What would flatten a line, or add more than anybody draws, is refused as it is of vertices.
#[test]
fn lines_alone_are_not_flattened_nor_copied_without_end() {
    let mut editor = open("cube.obj");
    edit(&mut editor, &draw(&[[0.0, 0.0, 0.0], [10.0, 0.0, 0.0]]));
    let flat = json!([[0, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]);
    let step = json!([[1, 0, 0, 1], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]);
    for (request, said) in [
        (json!({"edit": "transform", "vertices": [], "lines": [0], "matrix": flat}), "not invertible"),
        (
            json!({"edit": "array", "vertices": [], "lines": [0], "step": step, "count": 4_000_000}),
            "too large",
        ),
        (json!({"edit": "move", "vertices": [], "lines": [0], "by_mm": [0, 2e6, 0]}), "is not a position"),
    ] {
        let request: EditRequest = serde_json::from_value(request).unwrap();
        let error = editor.edit(&app(), &request).unwrap_err();
        assert!(error.to_string().contains(said), "{error}");
    }
    assert_eq!(lines(&editor), [[[0.0, 0.0, 0.0], [10.0, 0.0, 0.0]]]);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// Whatever is moved together, undo gives back the very same document, and the wire moves as without lines.
    #[test]
    fn a_move_is_undone_exactly(
        by in prop::array::uniform3(-500.0..500.0),
        places in prop::collection::vec(prop::array::uniform3(-100.0..100.0), 2..6),
        vertices in prop::collection::btree_set(0_u32..8, 0..5),
        chosen in prop::collection::btree_set(0_u32..5, 0..4),
    ) {
        let mut editor = open("cube.obj");
        edit(&mut editor, &draw(&places));
        let count = u32::try_from(places.len() - 1).unwrap();
        let chosen: Vec<u32> = chosen.into_iter().filter(|line| *line < count).collect();
        let before = editor.document().clone();
        let moved = json!({"edit": "move", "vertices": vertices, "lines": chosen, "by_mm": by});
        let alone = json!({"edit": "move", "vertices": vertices, "by_mm": by});
        edit(&mut editor, &moved);
        let together = editor.document().clone();
        if together != before {
            editor.undo().unwrap().unwrap();
        }
        prop_assert_eq!(editor.document(), &before);
        edit(&mut editor, &alone);
        prop_assert_eq!(&editor.document().wireframe, &together.wireframe);
        for (place, (line, first)) in (0..).zip(together.construction.iter().zip(&before.construction)) {
            let by = if chosen.contains(&place) { by } else { [0.0; 3] };
            for (now, then) in line.ends.iter().zip(&first.ends) {
                prop_assert!(((now - then) - nalgebra::Vector3::from(by)).norm() < 1e-9);
            }
        }
    }
}
