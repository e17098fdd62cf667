//! Documents come back as they were, and what is no document is refused with advice.

mod jobs;
mod schemas;
mod stencils;

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::io::Write as _;
use std::sync::Arc;

use expect_test::expect;
use nalgebra::Point3;
use proptest::prelude::*;
use serde_json::json;
use wirebend_core::mesh::{Placement, Stencil};
use wirebend_core::wireframe::{Edge, EdgeId, Joint, JointKind, NextIds, Vertex, VertexId, Wireframe};
use wirebend_error::ErrorRemedy;
use wirebend_files::document::{
    Clearance, CollisionSettings, ConstructionLine, Document, Job, Look, PartLook, PausePoint, Pin,
    PinTarget, ProfileSnapshot, SourceFile, StencilSource, Walk, WireCount, sha256_hex,
};
use wirebend_files::read::{Format, LengthUnit, ReadOptions, read};

use super::import_data;

fn example() -> Document {
    let mut wireframe = Wireframe::new();
    let a =
        wireframe.add_vertex(Vertex { support: true, ..Vertex::at(Point3::new(0.1, -0.0, 1e-17)) }).unwrap();
    let b = wireframe.add_vertex(Vertex::at(Point3::new(30.0, 1.0 / 3.0, 999_999.999))).unwrap();
    wireframe.insert_vertex(VertexId(7), Vertex::at(Point3::new(1.0, 2.0, 3.0))).unwrap();
    let edge = wireframe.add_edge(a, b).unwrap();
    let other = wireframe.add_edge(b, VertexId(7)).unwrap();
    wireframe.reserve_ids(NextIds { vertex: 12, edge: 9 });
    Document {
        wireframe,
        stencils: Vec::new(),
        surfaces: BTreeMap::new(),
        parts: vec![PartLook { edge: other, look: Look { hidden: true, ..look("left arm") } }],
        construction: vec![ConstructionLine {
            ends: [Point3::new(0.1, -0.0, 1e-17), Point3::new(30.0, 0.0, 5.0)],
        }],
        machine: Some(ProfileSnapshot {
            id: "wirebend-kit".into(),
            snapshot: json!({"limit_mm": 20.4, "name": "<ä>"}),
        }),
        material: Some(ProfileSnapshot { id: "aluminium-3".into(), snapshot: json!(null) }),
        doublings: vec![edge],
        start: Some(b),
        wires: WireCount::new(3).unwrap(),
        closed: false,
        reversed: true,
        walks: vec![Walk { start: b, edges: vec![edge, edge, other] }],
        collisions: CollisionSettings { clearance_mm: Clearance::try_from(0.5).unwrap(), sag: true },
        pins: vec![
            Pin { on: PinTarget::Vertex(a), text: "hold here".into() },
            Pin { on: PinTarget::Edge(edge), text: String::new() },
        ],
        pauses: vec![PausePoint { vertex: b, pass: 2.try_into().unwrap(), note: "turn the part".into() }],
        notes: "two\nlines".into(),
        units: LengthUnit::Inch,
        source: Some(SourceFile { file: "frame.obj".into(), sha256: sha256_hex(b"x") }),
    }
}

#[test]
fn a_document_is_laid_out_for_people() {
    let text = String::from_utf8(example().to_bytes().unwrap()).unwrap();
    expect![[r#"
        {
          "format": "wirebend",
          "version": 1,
          "wireframe": {
            "next_vertex": 12,
            "next_edge": 9,
            "vertices": [
              {"id": 0, "at_mm": [0.1, -0.0, 1e-17], "support": true},
              {"id": 1, "at_mm": [30.0, 0.3333333333333333, 999999.999]},
              {"id": 7, "at_mm": [1.0, 2.0, 3.0]}
            ],
            "edges": [
              {"id": 0, "a": 0, "b": 1},
              {"id": 1, "a": 1, "b": 7}
            ]
          },
          "parts": [
            {
              "edge": 1,
              "look": {"name": "left arm", "hidden": true}
            }
          ],
          "construction": [
            [
              [0.1, -0.0, 1e-17],
              [30.0, 0.0, 5.0]
            ]
          ],
          "machine": {
            "id": "wirebend-kit",
            "snapshot": {
              "limit_mm": 20.4,
              "name": "<ä>"
            }
          },
          "material": {
            "id": "aluminium-3",
            "snapshot": null
          },
          "doublings": [
            0
          ],
          "start": 1,
          "wires": 3,
          "reversed": true,
          "walks": [
            {
              "start": 1,
              "edges": [0, 0, 1]
            }
          ],
          "collisions": {
            "clearance_mm": 0.5,
            "sag": true
          },
          "pins": [
            {
              "on": {"vertex": 0},
              "text": "hold here"
            },
            {
              "on": {"edge": 0},
              "text": ""
            }
          ],
          "pauses": [
            {
              "vertex": 1,
              "pass": 2,
              "note": "turn the part"
            }
          ],
          "notes": "two\nlines",
          "units": "inch",
          "source": {
            "file": "frame.obj",
            "sha256": "2d711642b726b04401627ca9fbac32f5c8530fb1903cc4db02258717921a4881"
          }
        }
    "#]]
    .assert_eq(&text);
}

fn look(name: &str) -> Look {
    Look { name: name.to_owned(), ..Look::default() }
}

fn embedded(surface: Stencil) -> StencilSource {
    StencilSource::Embedded(Arc::new(surface))
}

fn with_stencil(name: &str, surface: Stencil) -> Document {
    let mut document = Document::default();
    document.add_stencil(name.to_owned(), embedded(surface));
    document
}

#[test]
fn a_document_comes_back_as_it_was() {
    let mut document = example();
    let teapot = import_data("bend-forming/Teapot_123Faces_Final.obj", &ReadOptions::default());
    for (name, surface) in [
        ("", StencilSource::File { path: "bunny.obj".into(), sha256: sha256_hex(b"bunny") }),
        ("nothing", embedded(Stencil::default())),
        ("Teapot.obj", embedded(teapot.stencil.unwrap())),
    ] {
        document.add_stencil(name.to_owned(), surface);
        let last = document.stencils.last_mut().unwrap();
        last.placement = Placement::new([0.1, -20.0, 1.0 / 3.0], [0.0, 45.0, 1e-17], 25.4).unwrap();
        last.look.colour = Some("#c07830".parse().unwrap());
        let bytes = document.to_bytes().unwrap();
        let back = Document::open(&bytes, "a.wirebend").unwrap();
        assert_eq!(back, document);
        assert_eq!(back.to_bytes().unwrap(), bytes);
    }
    // The sign of a zero survives, too.
    let bytes = document.to_bytes().unwrap();
    let y = Document::open(&bytes, "a").unwrap().wireframe.vertex(VertexId(0)).unwrap().position.y;
    assert!(y == 0.0 && y.is_sign_negative());
    let imported = read(&bytes, "a.wirebend", None, &ReadOptions::default()).unwrap();
    assert_eq!((imported.format, imported.wireframe), (Format::Wirebend, document.wireframe.clone()));
    assert_eq!(imported.document.as_deref(), Some(&document));
}

#[test]
fn an_empty_document_is_called_empty() {
    for nothing in ["", " \n"] {
        let refused = Document::open(nothing.as_bytes(), "a.wirebend").unwrap_err();
        assert_eq!(refused.to_string(), "a.wirebend: the file is empty, expected a WireBend project");
        assert_eq!(refused.remedies(), [ErrorRemedy::UseLastCopy]);
        let refused = Job::open(nothing.as_bytes(), "a.wbjob").unwrap_err();
        let expected = "a.wbjob: the file is empty, expected a WireBend job";
        assert_eq!(refused.to_string(), expected);
    }
}

#[test]
fn a_packed_stencil_is_small() {
    let bunny =
        import_data("bend-forming/BunnyPolygonScaled_v2.obj", &ReadOptions::default()).stencil.unwrap();
    let document = with_stencil("bunny.obj", bunny);
    assert!(document.to_bytes().unwrap().len() < 4000);
}

fn refusals(texts: &[String]) -> String {
    let mut list = String::new();
    for text in texts {
        let error = Document::open(text.as_bytes(), "a.wirebend").unwrap_err();
        writeln!(list, "{}: {error} {:?}", error.code(), error.remedies()).unwrap();
    }
    list
}

#[test]
fn what_is_no_document_is_refused_with_advice() {
    let good = String::from_utf8(example().to_bytes().unwrap()).unwrap();
    let with = |old: &str, new: &str| {
        assert!(good.contains(old), "{old}");
        good.replacen(old, new, 1)
    };
    let texts = [
        "{".to_owned(),
        with("\"version\": 1", "\"version\": 2"),
        with("\"version\": 1", "\"version\": 0"),
        with("\"wirebend\"", "\"wbjob\""),
        with("\"doublings\"", "\"doubling\""),
        with("\"id\": 7", "\"id\": 1"),
        with("999999.999", "9999999"),
        with("[30.0, 0.0, 5.0]", "[30.0, 0.0, 5000000.0]"),
        with("\"a\": 0", "\"a\": 99"),
        with("\"start\": 1", "\"start\": 3"),
        with("\"vertex\": 0", "\"vertex\": 3"),
        with("\"edge\": 0", "\"edge\": 3"),
        with("\"edge\": 1", "\"edge\": 3"),
        with("\"vertex\": 1", "\"vertex\": 3"),
        with("\"pass\": 2", "\"pass\": 0"),
        with("turn the part", " "),
        with("\"clearance_mm\": 0.5", "\"clearance_mm\": -0.5"),
        with("\"doublings\": [\n    0", "\"doublings\": [\n    5"),
        with("\"wires\": 3", "\"wires\": 0"),
        with("\"wires\": 3", "\"wires\": 3,\n  \"closed\": true"),
    ];
    expect![[r#"
        document-json: a.wirebend, line 1, column 1: EOF while parsing an object [UseLastCopy]
        document-newer: a.wirebend: its version 2 is newer than 1, the newest known here [UpdateProgram]
        document-no-such-version: a.wirebend: there is no version 0 of this format: the file is damaged [UseLastCopy]
        document-wrong-format: a.wirebend: this is a "wbjob" file, expected "wirebend" [OpenAsItIs]
        document-json: a.wirebend, line 40, column 12: unknown field `doubling`, expected one of `format`, `version`, `wireframe`, `stencils`, `stencil`, `parts`, `construction`, `machine`, `material`, `doublings`, `start`, `wires`, `closed`, `reversed`, `walks`, `collisions`, `pins`, `pauses`, `notes`, `units`, `source` [UseLastCopy]
        document-wireframe: a.wirebend: vertex 1 exists already [UseLastCopy]
        document-wireframe: a.wirebend: (30, 0.3333333333333333, 9999999) is not a position: each coordinate must be a number within ±1 000 000 mm [UseLastCopy]
        document-wireframe: a.wirebend: (30, 0, 5000000) is not a position: each coordinate must be a number within ±1 000 000 mm [UseLastCopy]
        document-wireframe: a.wirebend: there is no vertex 99 [UseLastCopy]
        document-dangling: a.wirebend: "start" names vertex 3, which is not in the wireframe [UseLastCopy]
        document-dangling: a.wirebend: "pins" names vertex 3, which is not in the wireframe [UseLastCopy]
        document-dangling: a.wirebend: "pins" names edge 3, which is not in the wireframe [UseLastCopy]
        document-dangling: a.wirebend: "parts" names edge 3, which is not in the wireframe [UseLastCopy]
        document-dangling: a.wirebend: "pauses" names vertex 3, which is not in the wireframe [UseLastCopy]
        document-json: a.wirebend, line 69, column 15: invalid value: integer `0`, expected a nonzero u32 [UseLastCopy]
        document-json: a.wirebend, line 71, column 5: a pause point says what to do: its note is empty [UseLastCopy]
        document-json: a.wirebend, line 53, column 24: a clearance of -0.5 mm, expected zero or more [UseLastCopy]
        document-dangling: a.wirebend: "doublings" names edge 5, which is not in the wireframe [UseLastCopy]
        document-json: a.wirebend, line 44, column 12: invalid value: integer `0`, expected a nonzero u32 [UseLastCopy]
        document-closed-wires: a.wirebend: "closed" is for one wire, and "wires" is 3 [UseLastCopy]
    "#]].assert_eq(&refusals(&texts));
}

/// Numbers as a document packs them.
fn packed(numbers: &[u32]) -> String {
    let bytes: Vec<u8> = numbers.iter().flat_map(|number| number.to_le_bytes()).collect();
    let mut encoder = flate2::write::DeflateEncoder::new(Vec::new(), flate2::Compression::default());
    encoder.write_all(&bytes).unwrap();
    base64::Engine::encode(&base64::engine::general_purpose::STANDARD, encoder.finish().unwrap())
}

#[test]
fn a_stencil_that_was_tampered_with_is_refused() {
    let square = [(0., 0.), (1., 0.), (1., 1.)].map(|(x, y)| Point3::new(x, y, 0.)).to_vec();
    let stencil = Stencil::new(square, vec![vec![0, 1, 2]]).unwrap();
    let document = with_stencil("square", stencil);
    let good = String::from_utf8(document.to_bytes().unwrap()).unwrap();
    let part = |key: &str| {
        good.split(&format!("\"{key}\": \"")).nth(1).unwrap().split('"').next().unwrap().to_owned()
    };
    let texts = [
        good.replace("\"vertices\": 3", "\"vertices\": 2"),
        good.replace("\"vertices\": 3", "\"vertices\": 4"),
        good.replace("\"vertices\": 3", "\"vertices\": 5000001"),
        good.replace("\"corners\": 3", "\"corners\": 2"),
        good.replace(&part("positions"), "!"),
        good.replace(&part("positions"), "AAAA"),
        good.replace(&part("indices"), &part("positions")),
        good.replace(&part("indices"), &packed(&[3, 0, 1, 9])),
        good.replace(&part("indices"), &packed(&[9, 0, 1, 2])),
        good.replace(&part("indices"), &packed(&[0, 2, 1, 2])),
    ];
    expect![[r#"
        document-stencil-damaged: a.wirebend: the embedded stencil is damaged: it has more than the 48 bytes that it announces [ImportAgain]
        document-stencil-damaged: a.wirebend: the embedded stencil is damaged: it has 72 of the 96 bytes that it announces [ImportAgain]
        document-stencil-damaged: a.wirebend: the embedded stencil is damaged: it announces more than 5000000 vertices or faces [ImportAgain]
        document-stencil-damaged: a.wirebend: the embedded stencil is damaged: it has more than the 12 bytes that it announces [ImportAgain]
        document-stencil-damaged: a.wirebend: the embedded stencil is damaged: Invalid symbol 33, offset 0. [ImportAgain]
        document-stencil-damaged: a.wirebend: the embedded stencil is damaged: incomplete deflate stream [ImportAgain]
        document-stencil-damaged: a.wirebend: the embedded stencil is damaged: it has more than the 16 bytes that it announces [ImportAgain]
        document-stencil: a.wirebend: face 0 names vertex 9, but the last vertex is 2 [ImportAgain]
        document-stencil-damaged: a.wirebend: the embedded stencil is damaged: face 0 has 3 of 9 corners [ImportAgain]
        document-stencil-damaged: a.wirebend: the embedded stencil is damaged: it has 2 of 1 faces [ImportAgain]
    "#]].assert_eq(&refusals(&texts));
}

#[test]
fn the_design_hash_is_of_the_design_only() {
    let document = example();
    let hash = document.design_hash().unwrap();
    let mut other = document.clone();
    other.notes = "another".into();
    other.pins.clear();
    other.pauses.clear();
    other.machine = None;
    other.units = LengthUnit::Metre;
    assert_eq!(other.design_hash().unwrap(), hash, "a remark is no other wire");
    other.wireframe.reserve_ids(NextIds { vertex: 100, edge: 100 });
    assert_eq!(other.design_hash().unwrap(), hash, "nor is an edit that was undone");
    other.doublings.push(EdgeId(1));
    assert_ne!(other.design_hash().unwrap(), hash);
    let mut moved = document;
    let nudge = wirebend_core::wireframe::Edit::Move {
        vertices: vec![VertexId(7)],
        by: nalgebra::Vector3::new(1e-9, 0.0, 0.0),
    };
    let delta = nudge.resolve(&moved.wireframe).unwrap();
    moved.wireframe.commit(&delta).unwrap();
    assert_ne!(moved.design_hash().unwrap(), hash);
}

fn any_document() -> impl Strategy<Value = Document> {
    let coordinate = prop_oneof![-1e6..1e6_f64, -1e-3..1e-3_f64];
    let kinds = prop_oneof![Just(JointKind::SnapFit), Just(JointKind::Solder), Just(JointKind::ZipTie)];
    let joint = prop::option::of((kinds, 0.0..1e6_f64).prop_map(|(kind, mass_g)| Joint { kind, mass_g }));
    let free = prop::array::uniform6(any::<bool>());
    let vertex = (prop::array::uniform3(coordinate), any::<bool>(), free, joint);
    let vertices = prop::collection::btree_map(0_u32..500, vertex, 1..20);
    let edge = (any::<prop::sample::Index>(), any::<prop::sample::Index>(), any::<bool>());
    let edges = prop::collection::vec(edge, 0..30);
    (vertices, edges, any::<String>(), any::<String>()).prop_map(|(vertices, edges, notes, text)| {
        let mut wireframe = Wireframe::new();
        let ids: Vec<u32> = vertices.keys().copied().collect();
        for (id, (at, support, free, joint)) in vertices {
            let vertex = Vertex { position: Point3::from(at), support, free, joint };
            wireframe.insert_vertex(VertexId(id), vertex).unwrap();
        }
        for (k, (a, b, ceiling)) in (0..).zip(&edges) {
            let (a, b) = (VertexId(*a.get(&ids)), VertexId(*b.get(&ids)));
            wireframe.insert_edge(EdgeId(k), Edge { a, b, ceiling: *ceiling }).unwrap();
        }
        let doublings = wireframe.edges().map(|(id, _)| id).step_by(3).collect();
        let (start, pass) = (VertexId(ids[0]), 3.try_into().unwrap());
        let pauses = vec![PausePoint { vertex: start, pass, note: format!("- {text}") }];
        let pins = vec![Pin { on: PinTarget::Vertex(start), text }];
        Document { doublings, start: Some(start), pins, pauses, notes, ..Document::new(wireframe) }
    })
}

proptest! {
    #[test]
    fn any_document_comes_back_bit_for_bit(document in any_document()) {
        let bytes = document.to_bytes().unwrap();
        let back = Document::open(&bytes, "a").unwrap();
        prop_assert_eq!(&back, &document);
        for ((_, a), (_, b)) in back.wireframe.vertices().zip(document.wireframe.vertices()) {
            prop_assert_eq!(a.position.coords.map(f64::to_bits), b.position.coords.map(f64::to_bits));
        }
        prop_assert_eq!(back.design_hash().unwrap(), document.design_hash().unwrap());
    }
}
