//! Pictures are well-formed and show what they were given.

use nalgebra::Point3;
use proptest::prelude::*;
use wirebend_files::read::ReadOptions;
use wirebend_files::write::{Mark, MarkAt, Picture, PictureWire, Severity, View, svg};

use super::{import_data, mm};

fn picture(wires: Vec<PictureWire>, marks: Vec<Mark>) -> Picture {
    Picture {
        title: "Truss".into(),
        machine: Some("WireBend-kit".into()),
        material: Some("Aluminium 6061, 3 mm".into()),
        length: mm(5450.1),
        bends: 79,
        wires,
        trials: Vec::new(),
        marks,
        view: View::Isometric,
        width_px: 1200,
        height_px: 800,
    }
}

fn truss() -> Picture {
    let options = ReadOptions { weld: mm(0.5), ..ReadOptions::default() };
    let program = import_data("bend-forming/AccuracyTest_TetraTruss.txt", &options).program.unwrap();
    let mut seen = std::collections::BTreeMap::new();
    for (k, pair) in program.traversal.windows(2).enumerate() {
        seen.entry((pair[0].min(pair[1]), pair[0].max(pair[1]))).or_insert_with(Vec::new).push(k);
    }
    let doubled = seen.into_values().filter(|passes| passes.len() > 1).flatten().collect();
    let at = |k: usize| program.path[k];
    let marks = vec![
        Mark {
            at: MarkAt::Edge(at(20), at(21)),
            severity: Severity::Error,
            label: "edge 17 is 14.2 mm long, at least 20.4 mm".into(),
        },
        Mark {
            at: MarkAt::Vertex(at(50)),
            severity: Severity::Error,
            label: "bend of 180.0°, at most 155.0°".into(),
        },
        Mark {
            at: MarkAt::Vertex(at(71)),
            severity: Severity::Warning,
            label: "the wire passes 1.2 mm from itself & <itself>".into(),
        },
    ];
    picture(vec![PictureWire { points: program.path.clone(), doubled }], marks)
}

/// Checks nesting and escaping as far as a drawing without content models needs it.
fn assert_well_formed(text: &str) {
    let mut open = Vec::new();
    for tag in text.split('<').skip(1) {
        let (tag, content) = tag.split_once('>').expect("a tag ends");
        assert!(!content.contains('>'), "{content}");
        for entity in content.split('&').skip(1).chain(tag.split('&').skip(1)) {
            assert!(
                ["amp;", "lt;", "gt;", "quot;", "#39;"].iter().any(|name| entity.starts_with(name)),
                "{entity}"
            );
        }
        assert_eq!(tag.matches('"').count() % 2, 0, "{tag}");
        if let Some(name) = tag.strip_prefix('/') {
            assert_eq!(open.pop(), Some(name));
        } else if !tag.ends_with('/') {
            open.push(tag.split(' ').next().unwrap());
        }
    }
    assert!(open.is_empty() && !text.contains("NaN") && !text.contains("inf"));
}

#[test]
fn a_picture_shows_every_segment_and_mark() {
    let truss = truss();
    let text = svg(&truss);
    assert_well_formed(&text);
    for expected in [
        "Truss",
        "WireBend-kit  ·  Aluminium 6061, 3 mm",
        "5\u{202f}450.1 mm",
        ">79<",
        ">start<",
        "along an axis",
        "&lt;itself&gt;",
    ] {
        assert!(text.contains(expected), "{expected}");
    }
    assert_eq!(
        text.matches("fill=\"#c81e1e\" stroke=\"#ffffff\"").count(),
        4,
        "two errors, in the drawing and in the list"
    );
    assert_eq!(text.matches("fill=\"#b45309\" stroke=\"#ffffff\"").count(), 2, "one warning");
    assert_eq!(svg(&truss), text);
}

#[test]
fn pictures_of_nothing_and_of_a_point_are_pictures() {
    let empty = svg(&picture(vec![], vec![]));
    assert_well_formed(&empty);
    assert!(empty.contains("no wire yet"));
    let point = PictureWire { points: vec![Point3::new(1., 2., 3.)], doubled: vec![7] };
    assert_well_formed(&svg(&picture(vec![point], vec![])));
    let nan = PictureWire { points: vec![Point3::new(f64::NAN, 0., 0.); 3], doubled: vec![] };
    assert_well_formed(&svg(&picture(vec![nan], vec![])));
}

proptest! {
    #[test]
    fn any_picture_is_well_formed(
        points in prop::collection::vec(prop::array::uniform3(-1e6..1e6_f64), 0..12),
        title: String,
        labels in prop::collection::vec(any::<String>(), 0..30),
        size in (0_u32..3000, 0_u32..3000),
        view in prop_oneof![Just(View::Isometric), Just(View::Top), Just(View::Front), Just(View::Right)],
    ) {
        let points: Vec<Point3<f64>> = points.into_iter().map(Point3::from).collect();
        let at = points.first().copied().unwrap_or_default();
        let marks = labels.into_iter().map(|label| Mark { at: MarkAt::Vertex(at), severity: Severity::Warning, label });
        let wire = PictureWire { points, doubled: vec![0] };
        let mut picture = picture(vec![wire], marks.collect());
        (picture.title, picture.width_px, picture.height_px, picture.view) = (title, size.0, size.1, view);
        assert_well_formed(&svg(&picture));
    }
}
