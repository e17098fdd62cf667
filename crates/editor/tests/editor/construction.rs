//! Construction lines: made of edges and made edges of, and nothing to the wire.

use serde_json::{Value, json};
use wirebend_editor::{EditRequest, ViewChange};

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
