//! Lists of stencils in a document, and documents that know of only one.

use serde_json::{Value, json};
use wirebend_core::mesh::{Placement, Stencil};
use wirebend_files::document::{Document, StencilSource, sha256_hex};

use super::refusals;

/// A document with a triangle and a file as its stencils, as JSON.
fn two() -> Value {
    let corners = [[0.0, 0.0, 0.0], [3.0, 0.0, 0.0], [0.0, 4.0, 0.0]].map(Into::into).to_vec();
    let mut document = Document::default();
    let triangle = Stencil::new(corners, vec![vec![0, 1, 2]]).unwrap();
    document.add_stencil("triangle".to_owned(), StencilSource::Embedded(triangle.into()));
    let file = StencilSource::File { path: "bunny.obj".into(), sha256: sha256_hex(b"bunny") };
    document.add_stencil(String::new(), file);
    serde_json::from_slice(&document.to_bytes().unwrap()).unwrap()
}

fn opened(value: &Value) -> Document {
    Document::open(value.to_string().as_bytes(), "a.wirebend").unwrap()
}

#[test]
fn a_document_that_knows_of_one_stencil_has_a_list_of_one() {
    let mut old = two();
    let mut surface = old["stencils"][0]["surface"].take();
    surface["embedded"]["name"] = json!("triangle");
    old.as_object_mut().unwrap().remove("stencils");
    for (surface, name) in [(surface, "triangle"), (two()["stencils"][1]["surface"].take(), "bunny.obj")] {
        old["stencil"] = surface;
        let document = opened(&old);
        let found: Vec<_> =
            document.placed_stencils().map(|(stencil, surface)| stencil.name(surface)).collect();
        assert_eq!(found, [name]);
        let written: Value = serde_json::from_slice(&document.to_bytes().unwrap()).unwrap();
        assert!(written.get("stencil").is_none() && written["stencils"][0].get("placement").is_none());
        assert_eq!(opened(&written), document);
    }
}

#[test]
fn a_surface_lies_where_the_document_has_it() {
    let mut value = two();
    value["stencils"][0]["placement"] = json!({"shift_mm": [10, 0, 0], "turn_deg": [0, 0, 180], "scale": 2});
    let document = opened(&value);
    assert_eq!(
        document.stencils[0].placement,
        Placement::new([10.0, 0.0, 0.0], [0.0, 0.0, 180.0], 2.0).unwrap()
    );
    let lies: Vec<Stencil> = document.surfaces_in_place().collect();
    // The middle, (1.5, 2), is at (11.5, 2): the corner at the origin is twice as far on the other side of it.
    let corner = lies[0].vertices()[0];
    assert!((corner.x - 14.5).abs() < 1e-12 && (corner.y - 6.0).abs() < 1e-12, "{corner}");
    assert_eq!(lies.len(), 1, "that of the file is not here");
}

#[test]
fn stencils_that_make_no_sense_are_refused_by_name() {
    let with = |path: &str, to: Value| {
        let mut value = two();
        *value.pointer_mut(path).unwrap() = to;
        value
    };
    let placed = |placement: Value| {
        let mut value = two();
        value["stencils"][1]["placement"] = placement;
        value
    };
    let mut both = two();
    both["stencil"] = both["stencils"][1]["surface"].clone();
    let texts = [
        with("/stencils/1/id", json!(0)),
        both,
        placed(json!({"scale": 0})),
        placed(json!({"shift_mm": [0, 1e6, 0]})),
        placed(json!({"turn": 3})),
        with("/stencils/0/look", json!({"name": "triangle", "colour": "red"})),
    ];
    expect_test::expect![[r#"
        document-stencils: a.wirebend: two stencils have the id 0 [UseLastCopy]
        document-stencils: a.wirebend: it has "stencil" and "stencils"; a document has one of these keys [UseLastCopy]
        document-stencils: a.wirebend: stencil 1: a stencil can be scaled by 0.001 to 1000, not by 0 [UseLastCopy]
        document-stencils: a.wirebend: stencil 1: a stencil can be moved by no more than 100000 mm, not by 1000000 mm [UseLastCopy]
        document-json: a.wirebend, line 1, column 232: unknown field `turn`, expected one of `shift_mm`, `turn_deg`, `scale` [UseLastCopy]
        document-json: a.wirebend, line 1, column 63: "red" is no colour: one is written as # and six hexadecimal digits, such as #7f93ab [UseLastCopy]
    "#]]
    .assert_eq(&refusals(&texts.map(|value| value.to_string())));
}
