//! Changes of a document: each can be undone, written down and read, and leaves nothing that points nowhere.

use nalgebra::Point3;
use proptest::prelude::*;
use wirebend_core::mesh::Stencil;
use wirebend_core::wireframe::{EdgeId, Edit, MergeAt, Vertex, VertexId, Wireframe};
use wirebend_files::document::{
    CollisionSettings, ConstructionLine, Document, DocumentChange, Look, PartLook, PausePoint, Pin,
    PinTarget, ProfileSnapshot, StaleChange, StencilId, StencilSource, sha256_hex,
};
use wirebend_files::read::LengthUnit;

/// A square with everything that points at its vertices and edges.
fn square() -> Document {
    let mut wireframe = Wireframe::new();
    for (x, y) in [(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 0.1)] {
        wireframe.add_vertex(Vertex::at(Point3::new(x, y, 1.0 / 3.0))).unwrap();
    }
    for (a, b) in [(0, 1), (1, 2), (2, 3), (3, 0)] {
        wireframe.add_edge(VertexId(a), VertexId(b)).unwrap();
    }
    let pin = |on, text: &str| Pin { on, text: text.into() };
    Document {
        doublings: vec![EdgeId(0), EdgeId(2)],
        start: Some(VertexId(2)),
        pins: vec![pin(PinTarget::Vertex(VertexId(2)), "here"), pin(PinTarget::Edge(EdgeId(3)), "zurück\n")],
        pauses: [1, 2].map(pause).to_vec(),
        parts: vec![part(0, "frame")],
        ..Document::new(wireframe)
    }
}

fn part(edge: u32, name: &str) -> PartLook {
    let colour = Some("#c07830".parse().unwrap());
    PartLook { edge: EdgeId(edge), look: Look { name: name.into(), colour, hidden: false } }
}

fn pause(vertex: u32) -> PausePoint {
    PausePoint { vertex: VertexId(vertex), pass: 1.try_into().unwrap(), note: "clip the joint".into() }
}

fn delete(document: &Document, vertices: &[u32]) -> DocumentChange {
    let vertices = vertices.iter().copied().map(VertexId).collect();
    let delta = Edit::Delete { vertices, edges: vec![] }.resolve(&document.wireframe).unwrap();
    DocumentChange::of_edit(document, delta)
}

#[test]
fn what_points_at_a_vertex_goes_with_it_and_comes_back_with_it() {
    let (before, mut document) = (square(), square());
    let change = delete(&document, &[2]);
    document.commit(&change).unwrap();
    assert_eq!((document.start, &document.doublings[..]), (None, &[EdgeId(0)][..]));
    assert_eq!(document.pins, before.pins[1..]);
    assert_eq!(document.pauses, [pause(1)]);
    // The file opens: nothing points nowhere.
    let bytes = document.to_bytes().unwrap();
    assert_eq!(Document::open(&bytes, "a.wirebend").unwrap(), document);
    document.commit(&change.inverse()).unwrap();
    assert_eq!(document, before);
}

#[test]
fn a_change_is_for_the_document_that_it_was_made_for() {
    let mut document = square();
    let start = document.set_start(Some(VertexId(0))).unwrap();
    document.commit(&start).unwrap();
    let before = document.clone();
    assert_eq!(document.commit(&start), Err(StaleChange::Part("start")));
    assert!(matches!(document.commit(&delete(&square(), &[2])), Err(StaleChange::Part("start"))));
    assert_eq!(document, before);
    assert_eq!(document.set_start(Some(VertexId(0))), None, "it is so already");
    let gone = delete(&document, &[1]);
    document.commit(&gone).unwrap();
    assert!(matches!(
        document.commit(&gone),
        Err(StaleChange::Part("parts" | "doublings") | StaleChange::Wireframe(_))
    ));
}

/// All parts at once, as JSON and back.
#[test]
fn every_part_is_written_down() {
    let document = square();
    let corner = |x: f64| Point3::new(x, 0.1, 1e-300);
    let stencil = Stencil::new(vec![corner(0.0), corner(1.0), corner(-0.0)], vec![vec![0, 1, 2]]).unwrap();
    let machine =
        ProfileSnapshot { id: "kit".into(), snapshot: serde_json::json!({"feed": 0.1, "x": [null]}) };
    let mut all = delete(&document, &[0, 2]);
    for part in [
        Some(document.with_stencil("a \"b\".stl".into(), StencilSource::Embedded(stencil.into()))),
        document.set_part_look(EdgeId(1), Look { name: "\"c\"".into(), ..Look::default() }),
        document.set_machine(Some(machine.clone())),
        document.set_material(Some(machine)),
        document.set_construction(vec![ConstructionLine { ends: [corner(0.0), corner(-0.0)] }]),
        document.set_collisions(CollisionSettings { clearance_mm: 0.1.try_into().unwrap(), sag: true }),
        document.set_notes("a\n\"b\"\u{2028}".into()),
        document.set_units(LengthUnit::Inch),
    ] {
        all = all.and(part.unwrap());
    }
    let text = all.to_json().unwrap();
    assert!(!text.contains('\n'));
    let read = DocumentChange::of_json(&text).unwrap();
    assert_eq!(read, all);
    let (mut one, mut other) = (document.clone(), document.clone());
    one.commit(&all).unwrap();
    other.commit(&read).unwrap();
    assert_eq!(one.to_bytes().unwrap(), other.to_bytes().unwrap(), "bit for bit");
    other.commit(&read.inverse()).unwrap();
    assert_eq!(other, document);
}

fn edited(document: &mut Document, edit: &Edit) {
    let change = DocumentChange::of_edit(document, edit.resolve(&document.wireframe).unwrap());
    document.commit(&change).unwrap();
}

/// A look is of all that hangs together, and is not lost while something of it is left.
#[test]
fn a_look_stays_with_its_part() {
    let mut document = square();
    edited(&mut document, &Edit::Delete { vertices: vec![], edges: vec![EdgeId(0)] });
    assert_eq!(document.parts, [part(3, "frame")], "an edge beside it");
    edited(&mut document, &Edit::Delete { vertices: vec![], edges: vec![EdgeId(1), EdgeId(2)] });
    assert_eq!(document.parts, [part(3, "frame")]);
    edited(&mut document, &Edit::SplitEdge { edge: EdgeId(3), at: 0.5 });
    let [kept] = &document.parts[..] else { panic!("{:?}", document.parts) };
    assert!(document.wireframe.edge(kept.edge).is_some());
    edited(&mut document, &Edit::Delete { vertices: vec![VertexId(3), VertexId(0)], edges: vec![] });
    assert_eq!(document.parts, [], "nothing of it is left");
}

/// What is seen does not vanish because it was joined to what is not.
#[test]
fn a_hidden_part_is_shown_when_it_is_joined_to_one_that_is_seen() {
    let mut document = square();
    let far = vec![Point3::new(50.0, 0.0, 0.0), Point3::new(60.0, 0.0, 0.0)];
    edited(&mut document, &Edit::Draw { from: None, through: far, to: None });
    let hidden = document.set_part_look(EdgeId(4), Look { hidden: true, ..Look::default() }).unwrap();
    document.commit(&hidden).unwrap();
    edited(&mut document, &Edit::SplitEdge { edge: EdgeId(0), at: 0.5 });
    assert!(document.parts.iter().any(|part| part.look.hidden), "an edit elsewhere changes nothing");
    let both = Edit::Merge { vertices: vec![VertexId(0), VertexId(4)], at: MergeAt::Centre };
    edited(&mut document, &both);
    assert!(document.parts.iter().all(|part| !part.look.hidden), "{:?}", document.parts);
}

/// Whichever edge of it is named.
#[test]
fn a_part_has_one_look() {
    let mut document = square();
    let other = Edit::Draw {
        from: None,
        through: vec![Point3::new(50.0, 0.0, 0.0), Point3::new(60.0, 0.0, 0.0)],
        to: None,
    };
    edited(&mut document, &other);
    for (edge, name) in [(3, "back"), (4, "hook"), (2, "front")] {
        let change = document.set_part_look(EdgeId(edge), part(edge, name).look).unwrap();
        document.commit(&change).unwrap();
    }
    assert_eq!(document.parts, [part(2, "front"), part(4, "hook")]);
    let plain = document.set_part_look(EdgeId(0), Look::default()).unwrap();
    document.commit(&plain).unwrap();
    assert_eq!(document.parts, [part(4, "hook")]);
}

#[test]
fn stencils_come_and_go_with_their_surfaces() {
    let mut document = Document::default();
    let surface = || StencilSource::File { path: "a.stl".into(), sha256: sha256_hex(b"a") };
    for name in ["one", "two"] {
        let change = document.with_stencil(name.into(), surface());
        document.commit(&change).unwrap();
    }
    let both = document.clone();
    let ids = |document: &Document| document.stencils.iter().map(|stencil| stencil.id).collect::<Vec<_>>();
    assert_eq!(ids(&document), document.surfaces.keys().copied().collect::<Vec<_>>());
    let gone = document.without_stencil(ids(&document)[0]).unwrap();
    let gone = DocumentChange::of_json(&gone.to_json().unwrap()).unwrap();
    document.commit(&gone).unwrap();
    assert_eq!((document.surfaces.len(), document.stencils[0].look.name.as_str()), (1, "two"));
    assert_eq!(document.commit(&gone), Err(StaleChange::Part("stencils")));
    document.commit(&gone.inverse()).unwrap();
    assert_eq!(document, both);
    assert_eq!(both.set_surfaces(&both.surfaces), None);
    assert!(both.without_stencil(StencilId(7)).is_none());
}

/// A line of a journal that knows of one stencil alone.
#[test]
fn a_change_of_the_only_stencil_is_one_of_the_first() {
    let file = |name: &str| format!(r#"{{"file":{{"path":"{name}","sha256":"{}"}}}}"#, sha256_hex(b"a"));
    let line = |before: &str, after: &str| {
        let text = format!(r#"{{"next":[[0,0],[0,0]],"stencil":[{before},{after}]}}"#);
        DocumentChange::of_json(&text).unwrap()
    };
    let mut document = Document::default();
    document.commit(&line("null", &file("a.stl"))).unwrap();
    document.commit(&line(&file("a.stl"), &file("b.stl"))).unwrap();
    let found: Vec<_> = document.placed_stencils().map(|(stencil, surface)| stencil.name(surface)).collect();
    assert_eq!(found, ["b.stl"]);
    document.commit(&line(&file("b.stl"), "null")).unwrap();
    assert_eq!(document, Document::default());
}

#[test]
fn what_is_no_change_is_refused() {
    for text in ["", "1", r#"{"next":[[1,2]]}"#, r#"{"colour":1}"#, r#"{"vertices":[[0,[null]]]}"#] {
        assert!(DocumentChange::of_json(text).is_err(), "{text}");
    }
}

fn any_edit() -> impl Strategy<Value = Edit> {
    let vertex = || (0..9_u32).prop_map(VertexId);
    let some = || prop::collection::btree_set(vertex(), 1..4).prop_map(Vec::from_iter);
    let point = || prop::array::uniform3(-1e6..1e6_f64).prop_map(Point3::from);
    prop_oneof![
        (prop::option::of(vertex()), prop::collection::vec(point(), 1..3), prop::option::of(vertex()))
            .prop_map(|(from, through, to)| Edit::Draw { from, through, to }),
        some().prop_map(|vertices| Edit::Delete { vertices, edges: vec![] }),
        (some(), point()).prop_map(|(vertices, by)| Edit::Move { vertices, by: by.coords / 1e3 }),
        some().prop_map(|vertices| Edit::Merge { vertices, at: MergeAt::Centre }),
        ((0..9_u32).prop_map(EdgeId), 0.0..1.0_f64).prop_map(|(edge, at)| Edit::SplitEdge { edge, at }),
    ]
}

proptest! {
    #[test]
    fn a_change_that_was_read_is_the_change_that_was_written(edits in prop::collection::vec(any_edit(), 1..20)) {
        let (mut document, mut copy) = (square(), square());
        let mut states = vec![document.clone()];
        let mut changes = Vec::new();
        for edit in &edits {
            let Ok(delta) = edit.resolve(&document.wireframe) else { continue };
            let change = DocumentChange::of_edit(&document, delta);
            document.commit(&change).unwrap();
            let read = DocumentChange::of_json(&change.to_json().unwrap()).unwrap();
            prop_assert_eq!(&read, &change);
            copy.commit(&read).unwrap();
            prop_assert_eq!(&copy, &document);
            prop_assert!(Document::open(&document.to_bytes().unwrap(), "a").is_ok(), "something points nowhere");
            states.push(document.clone());
            changes.push(change);
        }
        for (change, state) in changes.iter().zip(&states).rev() {
            document.commit(&change.inverse()).unwrap();
            prop_assert_eq!(&document, state);
        }
    }
}
