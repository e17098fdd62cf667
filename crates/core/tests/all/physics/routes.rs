//! The least length that is doubled.

use nalgebra::Point3;
use wirebend_core::route::doubling;
use wirebend_core::units::Length;
use wirebend_core::wireframe::{Vertex, VertexId, Wireframe};

use crate::physics::document::Document;

/// An example: its `l` lines, or where it has none the edges of its faces.
fn example(path: &str) -> Wireframe {
    let text = std::fs::read_to_string(format!("{}/../../{path}", env!("CARGO_MANIFEST_DIR"))).unwrap();
    let mut wireframe = Wireframe::new();
    let mut ids: Vec<VertexId> = Vec::new();
    let mut pairs = std::collections::BTreeSet::new();
    for line in text.lines() {
        let mut words = line.split_whitespace();
        match words.next() {
            Some("v") => {
                let at: Vec<f64> = words.map(|word| word.parse().unwrap()).collect();
                ids.push(wireframe.add_vertex(Vertex::at(Point3::new(at[0], at[1], at[2]))).unwrap());
            }
            Some(kind @ ("l" | "f")) => {
                let index = |word: &str| word.split('/').next().unwrap().parse::<usize>().unwrap() - 1;
                let corners: Vec<usize> = words.map(index).collect();
                let closing = (kind == "f").then(|| (corners[corners.len() - 1], corners[0]));
                let around = corners.windows(2).map(|pair| (pair[0], pair[1])).chain(closing);
                pairs.extend(around.map(|(a, b)| (a.min(b), a.max(b))));
            }
            _ => {}
        }
    }
    for (a, b) in pairs {
        wireframe.add_edge(ids[a], ids[b]).unwrap();
    }
    wireframe
}

pub fn claims(page: &mut Document) {
    let mut feeds = Vec::new();
    for (name, row) in page.table(&["Design", "wire, program", "wire, published", "doubled edges"]) {
        let wireframe = example(&name);
        let component = wireframe.components().remove(0);
        let found = doubling(&wireframe, &component, None, false).unwrap();
        let once: Length = component.edges.iter().map(|&edge| wireframe.edge_length(edge)).sum();
        let wire = (once + found.added).mm();
        row[0].unwrap().is(wire);
        assert!(
            row[1].is_none_or(|published| published.value > wire),
            "{name}: a greedy solution is not shorter"
        );
        #[allow(clippy::cast_precision_loss)] // a few edges
        row[2].unwrap().is(found.edges.len() as f64);
        feeds.push(component.edges.len() + found.edges.len());
    }
    let [_, _, _, one, two, three]: [_; 6] =
        page.sentence("The trusses with {}, {} and {} rings take {}, {} and {} feeds.");
    for (shown, computed) in [one, two, three].into_iter().zip(&feeds[2..]) {
        #[allow(clippy::cast_precision_loss)] // a few edges
        shown.is(*computed as f64);
    }
}

#[test]
fn doubled_edges_are_what_the_page_says() {
    claims(&mut Document::read());
}
