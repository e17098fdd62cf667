//! Curves of drawings whose edges have a least length, against the equations of the curves.

use nalgebra::Point3;
use proptest::prelude::*;
use wirebend_core::units::Length;
use wirebend_files::read::{CurveFacts, Imported, ReadOptions, read};

use super::drawn::{bounds, is_one_wire, points};
use super::svg::page;
use super::{dxf, mm};

fn cut(name: &str, text: &str, shortest: f64, bend_radius: f64) -> Imported {
    let options = ReadOptions {
        shortest_edge: Some(mm(shortest)),
        bend_radius: mm(bend_radius),
        ..ReadOptions::default()
    };
    read(text.as_bytes(), name, None, &options).unwrap_or_else(|error| panic!("{error}"))
}

fn svg(elements: &str, shortest: f64) -> Imported {
    cut("a.svg", &page(elements), shortest, 3.0)
}

fn facts(imported: &Imported) -> &CurveFacts {
    imported.curves.as_ref().unwrap()
}

fn edge_lengths(imported: &Imported) -> Vec<f64> {
    imported.wireframe.edges().map(|(id, _)| imported.wireframe.edge_length(id).mm()).collect()
}

fn shortest_edge(imported: &Imported) -> f64 {
    edge_lengths(imported).into_iter().fold(f64::INFINITY, f64::min)
}

/// How far a point is from the edges.
fn off(imported: &Imported, point: &Point3<f64>) -> f64 {
    let at = |id| imported.wireframe.vertex(id).unwrap().position;
    let distances = imported.wireframe.edges().map(|(_, edge)| {
        let (a, b) = (at(edge.a), at(edge.b));
        let part = ((point - a).dot(&(b - a)) / (b - a).norm_squared()).clamp(0.0, 1.0);
        (point - (a + (b - a) * part)).norm()
    });
    distances.fold(f64::INFINITY, f64::min)
}

fn has_vertex(imported: &Imported, x: f64, y: f64) -> bool {
    points(imported).iter().any(|point| (point - Point3::new(x, y, 0.0)).norm() < 1e-6)
}

#[test]
fn without_a_least_length_curves_are_read_as_ever() {
    let plain = read(page(r#"<circle r="10"/>"#).as_bytes(), "a.svg", None, &ReadOptions::default()).unwrap();
    assert_eq!(plain.curves, None);
    assert!(plain.wireframe.edge_count() > 20);
}

#[test]
fn a_circle_of_four_curves_is_cut_as_one() {
    // As Inkscape writes circles: a quarter of radius 15 is a chord of 21.2 mm, which alone would leave no choice.
    let k = 15.0 * 0.552_284_75;
    let (near, far) = (15.0 - k, 15.0 + k);
    let circle = format!(
        "<path d=\"M30 15 C30 {far} {far} 30 15 30 C{near} 30 0 {far} 0 15 C0 {near} {near} 0 15 0 C{far} 0 30 {near} 30 15 Z\"/>"
    );
    let ring = svg(&circle, 17.0);
    assert_eq!(ring.wireframe.edge_count(), 5, "{:?}", edge_lengths(&ring));
    assert!(shortest_edge(&ring) >= 17.0);
    // A pentagon as far outside as inside: R = 2r/(1 + cos 36°).
    let outer = 30.0 / (1.0 + 36_f64.to_radians().cos());
    let facts = facts(&ring);
    assert!((facts.deviation_mm - (outer - 15.0)).abs() < 0.05, "{facts:?}");
    assert_eq!((facts.coarser, facts.too_short, facts.radii.len()), (4, 0, 4));
}

#[test]
fn a_rounded_rectangle_keeps_its_sides_and_gets_corners() {
    let rectangle = svg(r#"<rect x="10" y="10" width="80" height="60" rx="5"/>"#, 20.0);
    assert_eq!(rectangle.wireframe.edge_count(), 4);
    for (x, y) in [(10.0, -10.0), (90.0, -10.0), (90.0, -70.0), (10.0, -70.0)] {
        assert!(has_vertex(&rectangle, x, y), "{:?}", points(&rectangle));
    }
    let facts = facts(&rectangle);
    assert!((facts.deviation_mm - 5.0 * (2_f64.sqrt() - 1.0)).abs() < 0.01, "{facts:?}");
    assert_eq!(facts.coarser, 4);
}

#[test]
fn corners_and_ends_of_a_drawing_stay() {
    // A line, a corner, half a circle, a corner, a line.
    let bow = svg(r#"<path d="M5 50 H30 V40 A20 20 0 0 1 70 40 V50 H95"/>"#, 18.0);
    for (x, y) in [(5.0, -50.0), (30.0, -50.0), (70.0, -50.0), (95.0, -50.0)] {
        assert!(has_vertex(&bow, x, y), "{:?}", points(&bow));
    }
    assert!(is_one_wire(&bow));
}

#[test]
fn lines_and_arcs_that_only_touch_are_one_stroke() {
    // LINE (0, 0) to (50, 0), ARC about (50, 10) of radius 10 from -90° to 0°, LINE (60, 10) to (60, 60).
    let drawing = dxf::drawing(
        "0 LINE 8 0 10 0 20 0 11 50 21 0 0 ARC 8 0 10 50 20 10 40 10 50 270 51 0 0 LINE 8 0 10 60 20 10 11 60 21 60",
    );
    let elbow = cut("a.dxf", &drawing, 20.0, 3.0);
    assert_eq!(elbow.wireframe.edge_count(), 2, "{:?}", points(&elbow));
    assert!(has_vertex(&elbow, 60.0, 0.0));
}

#[test]
fn where_something_else_is_joined_a_curve_is_not_moved() {
    // A stem ends where the circle begins.
    let pan = svg(r#"<circle cx="40" cy="50" r="20"/><path d="M60 50 H95"/>"#, 15.0);
    assert!(has_vertex(&pan, 60.0, -50.0));
    assert_eq!(pan.wireframe.components().len(), 1);
    assert!(shortest_edge(&pan) >= 15.0);
}

#[test]
fn how_tight_curves_are_is_said() {
    let rings = svg(r#"<circle cx="20" cy="20" r="2"/><circle cx="60" cy="60" r="30"/>"#, 20.0);
    let mut radii: Vec<f64> = facts(&rings).radii.iter().map(|radius| radius.radius_mm).collect();
    radii.sort_by(f64::total_cmp);
    assert!((radii[0] - 2.0).abs() < 1e-6 && (radii[1] - 30.0).abs() < 1e-6, "{radii:?}");
    assert_eq!(facts(&rings).too_short, 3, "a ring of 12.6 mm has no room for three edges of 20 mm");
}

#[test]
fn what_is_long_enough_is_read_as_without_a_limit() {
    let text = page(r#"<path d="M5 5 A200 200 0 0 1 95 95"/>"#);
    let plain = read(text.as_bytes(), "a.svg", None, &ReadOptions::default()).unwrap();
    let limited = cut("a.svg", &text, 5.0, 3.0);
    assert_eq!(points(&plain), points(&limited));
    assert!(facts(&limited).deviation_mm <= 0.1 + 0.01 && facts(&limited).deviation_mm > 0.0);
    assert_eq!(facts(&limited).coarser, 0);
}

#[test]
fn lengths_are_those_of_the_unit() {
    // The same page twice as large.
    let text = page(r#"<circle cx="50" cy="50" r="15"/>"#);
    let options = |scale: f64, shortest: f64| ReadOptions {
        scale,
        tolerance: Length::from_mm(0.1 * scale).unwrap(),
        shortest_edge: Some(mm(shortest)),
        ..ReadOptions::default()
    };
    let [one, two] = [options(1.0, 12.0), options(2.0, 24.0)]
        .map(|options| read(text.as_bytes(), "a.svg", None, &options).unwrap());
    let [low, high] = [bounds(&one), bounds(&two)].map(|[low, high]| high[0] - low[0]);
    assert!((high / low - 2.0).abs() < 1e-6);
    assert!((facts(&two).deviation_mm / facts(&one).deviation_mm - 2.0).abs() < 1e-6);
    assert!((facts(&two).radii[0].radius_mm - 30.0).abs() < 1e-6);
}

#[test]
fn the_bracket_is_cut_for_a_bender() {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/bracket.svg");
    let bracket = cut("bracket.svg", &std::fs::read_to_string(path).unwrap(), 27.3, 3.0);
    assert!(is_one_wire(&bracket));
    assert!(shortest_edge(&bracket) >= 27.3, "{:?}", edge_lengths(&bracket));
    // A quarter of radius 60 in three edges, ends on their lines.
    assert!(facts(&bracket).deviation_mm < 1.5, "{:?}", facts(&bracket));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(16))]
    #[test]
    fn no_curve_is_farther_off_than_said(
        (x, y, angle) in (-40.0..40.0_f64, -40.0..40.0_f64, 0.0..360.0_f64),
        (rx, ry) in (6.0..60.0_f64, 6.0..60.0_f64),
        shortest in 3.0..30.0_f64,
    ) {
        let text = page(&format!(r#"<ellipse rx="{rx}" ry="{ry}" transform="translate({x} {y}) rotate({angle})"/>"#));
        let ring = cut("a.svg", &text, shortest, 0.0);
        let (sin, cos) = angle.to_radians().sin_cos();
        for k in 0..720 {
            let t = f64::from(k).to_radians() / 2.0;
            let (u, v) = (rx * t.cos(), ry * t.sin());
            let point = Point3::new(x + u * cos - v * sin, -(y + u * sin + v * cos), 0.0);
            let distance = off(&ring, &point);
            prop_assert!(distance <= facts(&ring).deviation_mm + 1e-6, "{} off, said {:?}", distance, facts(&ring));
        }
        let short = edge_lengths(&ring).iter().filter(|&&edge| edge < shortest - 1e-6).count();
        prop_assert_eq!(short > 0, facts(&ring).too_short > 0);
        // Half the circumference there and half back: two edges are no ring.
        prop_assert!(short == 0 || rx.min(ry) * std::f64::consts::TAU < 4.5 * shortest);
    }
}
