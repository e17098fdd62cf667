//! Curves of drawings whose edges have a least length, against the equations of the curves.

use nalgebra::Point3;
use proptest::prelude::*;
use wirebend_core::units::Length;
use wirebend_files::read::{CurveFacts, Imported, NoteKind, ReadOptions, read};

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

/// An arc from (30, 50) to (55, 50) of so large a radius that its chord is 3 mm off.
const SHALLOW: &str = "A27.5 27.5 0 0 1";

/// The area inside of a ring in the order of its vertices.
fn area(imported: &Imported) -> f64 {
    let ring = points(imported);
    let next = |k: usize| ring[(k + 1) % ring.len()];
    ring.iter().enumerate().map(|(k, a)| a.x * next(k).y - a.y * next(k).x).sum::<f64>().abs() / 2.0
}

#[test]
fn a_closed_outline_keeps_all_its_wire() {
    // Each of the curves alone would become the chord between its ends, and one of the two edges would be lost.
    let lens = format!(r#"<path d="M30 50 {SHALLOW} 55 50 {SHALLOW} 30 50 Z"/>"#);
    let shape_d = format!(r#"<path d="M30 50 {SHALLOW} 55 50 Z"/>"#);
    for text in [lens, shape_d] {
        let ring = svg(&text, 20.0);
        assert_eq!(ring.wireframe.edge_count(), ring.wireframe.vertex_count(), "{:?}", points(&ring));
        assert!(ring.wireframe.components().len() == 1 && area(&ring) > 25.0, "{:?}", points(&ring));
        assert!(facts(&ring).too_short > 0, "{:?}", facts(&ring));
        assert!(facts(&ring).deviation_mm < 3.2, "{:?}", facts(&ring));
    }
}

#[test]
fn curves_between_the_same_two_joints_stay_apart() {
    // Stems at both ends, so that the curves are no ring.
    let text = format!(
        r#"<path d="M5 50 H30 {SHALLOW} 55 50 H80"/><path d="M55 50 {SHALLOW} 30 50"/><path d="M30 50 V90"/>"#
    );
    let ring = svg(&text, 20.0);
    assert_eq!(ring.wireframe.edge_count(), 3 + 1 + 2, "{:?}", points(&ring));
    // One stem: the ring begins and ends at it.
    let pan = svg(&format!(r#"<path d="M5 50 H30 {SHALLOW} 55 50 {SHALLOW} 30 50"/>"#), 20.0);
    assert_eq!(pan.wireframe.edge_count(), 1 + 3, "{:?}", points(&pan));
}

#[test]
fn a_curve_that_is_drawn_twice_is_one_edge() {
    let arc = format!(r#"<path d="M30 50 {SHALLOW} 55 50"/>"#);
    let twice = svg(&format!("{arc}{arc}"), 20.0);
    assert_eq!((twice.wireframe.edge_count(), facts(&twice).too_short), (1, 0));
    let stems = svg(&format!(r#"{arc}{arc}<path d="M5 50 H30 M55 50 H80"/>"#), 20.0);
    assert_eq!((stems.wireframe.edge_count(), facts(&stems).too_short), (3, 0));
}

#[test]
fn a_tapered_slot_does_not_become_a_spike() {
    // Two lines of 80 mm, two degrees apart, and an arc of 5 mm that leads from one to the other.
    let turn = 178_f64.to_radians();
    let (x, y) = (50.0 + 5.0 * turn.cos(), 50.0 - 5.0 * turn.sin());
    let (far_x, far_y) = (x - 40.0 * turn.sin(), y + 40.0 * -turn.cos());
    let slot = svg(&format!(r#"<path d="M55 90 V50 A5 5 0 0 0 {x} {y} L{far_x} {far_y}"/>"#), 20.0);
    let [low, high] = bounds(&slot);
    assert!(low[1] >= -90.0 - 1e-6 && high[1] <= -45.0 + 20.0, "{:?}", points(&slot));
    assert!(facts(&slot).too_short > 0, "{:?}", facts(&slot));
}

#[test]
fn pieces_of_no_length_do_not_part_a_stroke() {
    let elbow =
        |piece: &str| svg(&format!(r#"<path d="M10 90 H50 {piece} A10 10 0 0 0 60 80 {piece} V20"/>"#), 20.0);
    assert_eq!(elbow("").wireframe.edge_count(), 2);
    for piece in ["l0 0", "l0.0004 0", "c0 0 0 0 0 0"] {
        assert_eq!(points(&elbow(piece)).len(), 3, "{piece}: {:?}", points(&elbow(piece)));
        assert!(elbow(piece).notes.iter().any(|note| note.kind == NoteKind::EdgesCollapsed), "{piece}");
    }
    // Many of them are a line.
    let steps = "l0.0008 0 ".repeat(40_000);
    let line = svg(&format!(r#"<path d="M10 50 {steps}"/>"#), 20.0);
    let [low, high] = bounds(&line);
    assert!((high[0] - low[0] - 32.0).abs() < 2e-3, "{low:?} {high:?}");
}

#[test]
fn more_points_than_there_is_room_for_are_refused() {
    // Half a million points each at this tolerance.
    let circles = r#"<circle cx="50" cy="50" r="90000"/>"#.repeat(12);
    let options =
        ReadOptions { tolerance: mm(1e-4), shortest_edge: Some(mm(20.0)), ..ReadOptions::default() };
    let error = read(page(&circles).as_bytes(), "a.svg", None, &options).unwrap_err().to_string();
    assert!(error.contains("more than 5000000 points"), "{error}");
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

    #[test]
    fn closed_chains_with_corners_are_rings(
        corners in prop::collection::vec((0.6..1.0_f64, 0.7..3.0_f64, any::<bool>()), 2..6),
        shortest in 5.0..40.0_f64,
    ) {
        // Corners about the middle of the page, each side a line or an arc that bulges outwards.
        let count = corners.len();
        #[allow(clippy::cast_precision_loss)] // below six
        let at = |k: usize| {
            let (sin, cos) = (std::f64::consts::TAU * (k % count) as f64 / count as f64).sin_cos();
            (50.0 + 40.0 * corners[k % count].0 * cos, 50.0 + 40.0 * corners[k % count].0 * sin)
        };
        let mut path = vec![format!("M{} {}", at(0).0, at(0).1)];
        // In which directions each side begins and ends.
        let mut ways = Vec::new();
        for (k, &(_, bulge, is_line)) in corners.iter().enumerate() {
            let ((from_x, from_y), (x, y)) = (at(k), at(k + 1));
            let along = (y - from_y).atan2(x - from_x);
            // Of two corners one side at least is an arc.
            if is_line && (count > 2 || k > 0) {
                path.push(format!("L{x} {y}"));
                ways.push([along; 2]);
            } else {
                let radius = 0.5 * (x - from_x).hypot(y - from_y) * (1.0 + bulge);
                path.push(format!("A{radius} {radius} 0 0 1 {x} {y}"));
                let half = (1.0 / (1.0 + bulge)).asin();
                ways.push([along - half, along + half]);
            }
        }
        let ring = cut("a.svg", &page(&format!(r#"<path d="{} Z"/>"#, path.join(" "))), shortest, 3.0);
        prop_assert!(ring.wireframe.edge_count() >= 3);
        prop_assert_eq!(ring.wireframe.edge_count(), ring.wireframe.vertex_count());
        prop_assert!(ring.wireframe.vertices().all(|(id, _)| ring.wireframe.incident(id).len() == 2));
        for k in 0..count {
            // A turn of no more than 3 degrees is the rounding of a file.
            let turn = ways[k][0] - ways[(k + count - 1) % count][1];
            if turn.sin().hypot(turn.cos() - 1.0) <= 3.0_f64.to_radians() {
                continue;
            }
            let (x, y) = at(k);
            prop_assert!(has_vertex(&ring, x, -y), "{:?}", points(&ring));
        }
    }
}
