//! Templates at 1:1: what is drawn is the wire, in its size and with its handedness.

use nalgebra::{Point3, Rotation3, Unit, Vector3};
use proptest::prelude::*;
use wirebend_core::bend::{Frame, Step, replay};
use wirebend_core::units::{Angle, DisplayUnit, Length};
use wirebend_files::write::{
    Drawing, Layer, Paper, Shape, Template, template, template_dxf, template_pdf, template_svg,
};

use super::super::{mm, step};

const RADIUS: f64 = 4.5;

pub(super) fn of(wires: Vec<Vec<Point3<f64>>>) -> Template {
    Template {
        title: "Hook & <eye>".into(),
        wires,
        diameter: mm(3.0),
        radius: mm(RADIUS),
        flat: mm(0.3),
        straight: Angle::from_deg(0.05).unwrap(),
        chord: mm(0.03),
        steps: Vec::new(),
        unit: DisplayUnit::Millimetre,
    }
}

fn drawn(path: &[Point3<f64>]) -> Drawing {
    template(&of(vec![path.to_vec()]))
}

/// The middle of the wire: lines by their ends, arcs by their ends, radius and sweep.
pub(super) fn centreline(drawing: &Drawing) -> Vec<&Shape> {
    drawing.shapes.iter().filter(|(layer, _)| *layer == Layer::Centreline).map(|(_, shape)| shape).collect()
}

fn ends(shape: &Shape) -> [[f64; 2]; 2] {
    match shape {
        Shape::Line(points) => *points,
        Shape::Arc { centre, radius, from, sweep } => {
            [*from, from + sweep].map(|a| [centre[0] + radius * a.cos(), centre[1] + radius * a.sin()])
        }
        other => panic!("{other:?}"),
    }
}

fn length(shape: &Shape) -> f64 {
    match shape {
        Shape::Line([a, b]) => distance(*a, *b),
        Shape::Arc { radius, sweep, .. } => radius * sweep.abs(),
        other => panic!("{other:?}"),
    }
}

fn same(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-9
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// A hook: 40 mm, a right angle to the left, 30 mm, half of one to the right, 20 mm.
fn hook() -> Vec<Point3<f64>> {
    let steps = [step(40.0, 0.0, 90.0), step(30.0, 180.0, 45.0), step(20.0, 0.0, 0.0)];
    replay(Frame::default(), &steps)
}

/// By hand: corners at (40, 0), (40, 30), (54.142, 44.142). The right angle takes 4.5 mm of both its sides, that of
/// 45° 4.5·tan 22.5° = 1.8640 mm. From the lower left corner of what is drawn the start is at (0, 0).
#[test]
fn the_hook_is_drawn_as_it_is_bent() {
    let hook = drawn(&hook());
    let shapes = centreline(&hook);
    let expected = [
        [[0.0, 0.0], [35.5, 0.0]],
        [[35.5, 0.0], [40.0, 4.5]],
        [[40.0, 4.5], [40.0, 28.136_04]],
        [[40.0, 28.136_04], [41.318_02, 31.318_02]],
        [[41.318_02, 31.318_02], [54.142_14, 44.142_14]],
    ];
    assert_eq!(shapes.len(), expected.len(), "{shapes:?}");
    let start = ends(shapes[0])[0];
    for (shape, expected) in shapes.iter().zip(expected) {
        for (found, expected) in ends(shape).into_iter().zip(expected) {
            let found = [found[0] - start[0], found[1] - start[1]];
            assert!(distance(found, expected) < 1e-4, "{found:?} for {expected:?}");
        }
    }
    // Left, then right.
    let sweeps: Vec<f64> = shapes
        .iter()
        .filter_map(
            |shape| if let Shape::Arc { sweep, .. } = shape { Some(sweep.to_degrees()) } else { None },
        )
        .collect();
    assert!((sweeps[0] - 90.0).abs() < 1e-9 && (sweeps[1] + 45.0).abs() < 1e-9, "{sweeps:?}");
    assert_eq!(hook.tightened, 0);
}

/// The edges of the wire are half a diameter from its middle: a gauge that is wider or narrower passes the wrong wire.
#[test]
fn edges_are_half_a_diameter_away() {
    let hook = drawn(&hook());
    let edges: Vec<f64> = hook
        .shapes
        .iter()
        .filter(|(layer, _)| *layer == Layer::Wire)
        .filter_map(|(_, shape)| if let Shape::Arc { radius, .. } = shape { Some(*radius) } else { None })
        .collect();
    assert_eq!(
        edges.iter().map(|radius| format!("{radius:.6}")).collect::<Vec<_>>(),
        ["6.000000", "3.000000", "6.000000", "3.000000"]
    );
    let start = ends(centreline(&hook)[0])[0];
    let is_edge = |shape: &Shape, y: f64| match shape {
        Shape::Line([a, b]) => [a, b].iter().all(|p| (p[1] - start[1] - y).abs() < 1e-9) && !same(a[0], b[0]),
        _ => false,
    };
    for side in [1.5, -1.5] {
        assert!(hook.shapes.iter().any(|(layer, shape)| *layer == Layer::Wire && is_edge(shape, side)));
    }
    // Both ends are closed by a line across the wire.
    let across =
        |shape: &Shape| matches!(shape, Shape::Line([a, b]) if (distance(*a, *b) - 3.0).abs() < 1e-9);
    assert_eq!(hook.shapes.iter().filter(|(_, shape)| across(shape)).count(), 2);
}

/// A wire that is not flat: 30 mm along x, 20 mm along y, 10 mm along z. Third-angle projection: the top stands above
/// the front and as far to the right, the right side at the height of the front.
#[test]
fn three_views_stand_where_they_belong() {
    let path = [[0., 0., 0.], [30., 0., 0.], [30., 20., 0.], [30., 20., 10.]].map(Point3::from);
    let drawing = drawn(&path);
    let at = |word: &str| {
        let found = drawing.shapes.iter().find_map(|(_, shape)| match shape {
            Shape::Text { at, text, .. } if text == word => Some(*at),
            _ => None,
        });
        found.unwrap_or_else(|| panic!("no {word}"))
    };
    assert!(at("top")[1] > at("front")[1] + 20.0);
    assert!((at("right")[0] - at("front")[0]) > 30.0);
    let lines: Vec<[[f64; 2]; 2]> = centreline(&drawing)
        .into_iter()
        .filter_map(|shape| if let Shape::Line(points) = shape { Some(*points) } else { None })
        .collect();
    // The first side, along x without its 4.5 mm of arc, is seen in front and top, one above the other.
    let along_x: Vec<_> =
        lines.iter().filter(|[a, b]| (b[0] - a[0] - 25.5).abs() < 1e-9 && same(a[1], b[1])).collect();
    assert_eq!(along_x.len(), 2);
    assert!((along_x[0][0][0] - along_x[1][0][0]).abs() < 1e-9);
    // The last one, along z, in front and right side, at the same height.
    let along_z: Vec<_> =
        lines.iter().filter(|[a, b]| (b[1] - a[1] - 5.5).abs() < 1e-9 && same(a[0], b[0])).collect();
    assert_eq!(along_z.len(), 2);
    assert!((along_z[0][1][1] - along_z[1][1][1]).abs() < 1e-9);
    // It goes up in both, and y goes up in the top: seen from above, the wire turns left.
    let along_y: Vec<_> =
        lines.iter().filter(|[a, b]| (b[1] - a[1] - 11.0).abs() < 1e-9 && same(a[0], b[0])).collect();
    assert_eq!(along_y.len(), 1, "{lines:?}");
    let said: String = texts(&drawing).join(" ");
    assert!(said.contains("third-angle projection"), "{said}");
}

pub(super) fn texts(drawing: &Drawing) -> Vec<&str> {
    let shapes = drawing.shapes.iter().map(|(_, shape)| shape);
    shapes
        .filter_map(|shape| if let Shape::Text { text, .. } = shape { Some(text.as_str()) } else { None })
        .collect()
}

#[test]
fn what_does_not_fit_is_said_on_the_template() {
    let path = [[0., 0., 0.], [20., 0., 0.], [20., 5., 0.], [0., 5., 0.]].map(Point3::from);
    let drawing = drawn(&path);
    assert_eq!(drawing.tightened, 2);
    assert!(texts(&drawing).iter().any(|text| text.contains("2 bends are drawn tighter")));
}

#[test]
fn wires_of_nothing_make_empty_templates() {
    let nowhere = vec![Point3::new(f64::NAN, 0.0, 0.0), Point3::new(f64::INFINITY, 1e300, 0.0)];
    for wires in [vec![], vec![vec![]], vec![vec![Point3::origin(); 3]], vec![nowhere]] {
        let drawing = template(&of(wires));
        assert!(centreline(&drawing).is_empty());
        assert!(!template_svg(&drawing).contains("NaN") && !template_dxf(&drawing).contains("NaN"));
        assert_eq!(template_pdf(&drawing, Paper::A4).unwrap().pages, 2, "an overview and the caption");
    }
}

/// The numbers of an attribute or of a path in SVG.
fn numbers(text: &str) -> Vec<f64> {
    let is_word = |c: char| !(c.is_ascii_digit() || matches!(c, '.' | '-'));
    text.split(is_word).filter(|word| !word.is_empty()).map(|word| word.parse().unwrap()).collect()
}

fn attribute<'a>(element: &'a str, name: &str) -> &'a str {
    let (_, rest) =
        element.split_once(&format!(" {name}=\"")).unwrap_or_else(|| panic!("{name} of {element}"));
    rest.split_once('"').unwrap().0
}

/// The centreline of an SVG template by the ends of its parts, y up from the page's lower edge, its length, and for each
/// arc whether it turns left.
fn svg_centreline(text: &str) -> (Vec<[[f64; 2]; 2]>, f64, Vec<bool>) {
    let (_, group) = text.split_once("<g id=\"CENTRELINE\"").unwrap();
    let (group, _) = group.split_once("</g>").unwrap();
    let height = numbers(attribute(text.lines().next().unwrap(), "viewBox"))[3];
    assert_eq!(
        attribute(text.lines().next().unwrap(), "height"),
        format!("{height}mm"),
        "a unit is a millimetre"
    );
    let (mut parts, mut sum, mut turns) = (Vec::new(), 0.0, Vec::new());
    for element in group.lines().skip(1) {
        let up = |x: f64, y: f64| [x, height - y];
        if element.starts_with("<line") {
            let [x1, y1, x2, y2] = ["x1", "y1", "x2", "y2"].map(|name| numbers(attribute(element, name))[0]);
            parts.push([up(x1, y1), up(x2, y2)]);
            sum += distance(up(x1, y1), up(x2, y2));
        } else {
            let n = numbers(attribute(element, "d"));
            let [x1, y1, r, _, _, large, clockwise, x2, y2] = n[..] else { panic!("{element}") };
            parts.push([up(x1, y1), up(x2, y2)]);
            // On a screen, a sweep flag of 1 is clockwise.
            turns.push(clockwise < 0.5);
            let half = (distance(up(x1, y1), up(x2, y2)) / 2.0 / r).min(1.0).asin();
            sum += 2.0 * r * if large > 0.0 { std::f64::consts::PI - half } else { half };
        }
    }
    (parts, sum, turns)
}

/// The centreline of a DXF template likewise: pairs of code and value, entities between the 0 codes.
fn dxf_centreline(text: &str) -> (Vec<[[f64; 2]; 2]>, f64) {
    let lines: Vec<&str> = text.lines().collect();
    let pairs: Vec<(i32, &str)> =
        lines.chunks(2).map(|pair| (pair[0].trim().parse().unwrap(), pair[1])).collect();
    assert_eq!(pairs.last(), Some(&(0, "EOF")));
    let units = pairs.iter().position(|pair| *pair == (9, "$INSUNITS")).unwrap();
    assert_eq!(pairs[units + 1], (70, "4"), "millimetres");
    let entities = pairs.iter().position(|pair| *pair == (2, "ENTITIES")).unwrap();
    let (mut parts, mut sum) = (Vec::new(), 0.0);
    let begins: Vec<usize> = (entities..pairs.len()).filter(|&k| pairs[k].0 == 0).collect();
    for pair in begins.windows(2) {
        let entity = &pairs[pair[0]..pair[1]];
        let value = |code: i32| entity.iter().find(|pair| pair.0 == code).map(|pair| pair.1);
        let number = |code: i32| value(code).unwrap().parse::<f64>().unwrap();
        if value(8) != Some("CENTRELINE") {
            continue;
        }
        match value(0) {
            Some("LINE") => {
                let ends = [[number(10), number(20)], [number(11), number(21)]];
                parts.push(ends);
                sum += distance(ends[0], ends[1]);
            }
            Some("ARC") => {
                let (x, y, r) = (number(10), number(20), number(40));
                let angles = [number(50), number(51)].map(f64::to_radians);
                parts.push(angles.map(|a| [x + r * a.cos(), y + r * a.sin()]));
                // From the first to the second, always counter-clockwise.
                sum += r * (angles[1] - angles[0]).rem_euclid(std::f64::consts::TAU);
            }
            other => panic!("{other:?}"),
        }
    }
    (parts, sum)
}

/// Text and drawing characters are kept within the bounds of the format.
#[test]
fn text_is_escaped() {
    let mut of = of(vec![hook()]);
    of.title = "50 %%d Ø <&> é 😀\n0\nEOF".into();
    let drawing = template(&of);
    let svg = template_svg(&drawing);
    assert!(svg.contains("&lt;&amp;&gt;") && svg.matches("<text").count() == svg.matches("</text>").count());
    let dxf = template_dxf(&drawing);
    assert!(
        dxf.is_ascii() && !dxf.contains("%%") && dxf.contains("\\U+00D8") && dxf.contains("\\U+D83D\\U+DE00")
    );
    dxf_centreline(&dxf);
}

/// A flat wire from the turtle: feeds, and bends to the left or to the right that fit between them.
fn flat_steps() -> impl Strategy<Value = Vec<Step>> {
    let one = (25.0..80.0_f64, any::<bool>(), 2.0..125.0_f64);
    prop::collection::vec(one, 1..10).prop_map(|parts| {
        let mut side = true;
        let mut steps: Vec<Step> = parts
            .into_iter()
            .enumerate()
            .map(|(k, (feed, left, bend))| {
                let turned = if left == side || k == 0 { 0.0 } else { 180.0 };
                side = if k == 0 { side } else { left };
                step(feed, turned, bend)
            })
            .collect();
        steps.push(step(30.0, 0.0, 0.0));
        steps
    })
}

fn turned(path: &[Point3<f64>], axis: [f64; 3], angle: f64) -> Vec<Point3<f64>> {
    let axis = Unit::try_new(Vector3::from(axis), 1e-3).unwrap_or(Vector3::x_axis());
    let turn = Rotation3::from_axis_angle(&axis, angle);
    path.iter().map(|point| turn * point + Vector3::new(100.0, -50.0, 7.0)).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// However a flat wire lies in space, its template is as long as the design less what its arcs save, its parts
    /// join, and it turns as the program does: left where the bend is positive.
    #[test]
    fn a_flat_wire_keeps_its_length_and_its_hand(
        steps in flat_steps(),
        axis in prop::array::uniform3(-1.0..1.0_f64),
        angle in 0.0..6.0_f64,
    ) {
        let path = turned(&replay(Frame::default(), &steps), axis, angle);
        let drawing = drawn(&path);
        prop_assert_eq!(drawing.tightened, 0);
        let design: f64 = steps.iter().map(|step| step.feed.mm()).sum();
        // An arc of θ takes r·θ where its corner takes twice r·tan(θ/2).
        let saved: f64 = steps.iter().map(|s| s.bend.rad()).map(|b| RADIUS * (2.0 * (b / 2.0).tan() - b)).sum();
        let shapes = centreline(&drawing);
        let found: f64 = shapes.iter().map(|shape| length(shape)).sum();
        prop_assert!((found - (design - saved)).abs() < 1e-6, "{found} for {design} - {saved}");
        for pair in shapes.windows(2) {
            prop_assert!(distance(ends(pair[0])[1], ends(pair[1])[0]) < 1e-6);
        }
        let mut side = 1.0;
        let signed = steps.iter().filter(|step| step.bend != Angle::ZERO).map(|step| {
            if step.rotate.deg() > 90.0 { side = -side; }
            side * step.bend.rad()
        });
        let sweeps = shapes.iter().filter_map(|s| if let Shape::Arc { sweep, .. } = s { Some(*sweep) } else { None });
        for (found, meant) in sweeps.zip(signed.collect::<Vec<_>>()) {
            prop_assert!((found - meant).abs() < 1e-6, "{found} for {meant}");
        }
        // The same in the files, which keep less digits.
        let meant: Vec<[[f64; 2]; 2]> = shapes.iter().map(|shape| ends(shape)).collect();
        let (of_svg, svg_mm, turns) = svg_centreline(&template_svg(&drawing));
        let left = shapes.iter().filter_map(|s| if let Shape::Arc { sweep, .. } = s { Some(*sweep > 0.0) } else { None });
        prop_assert_eq!(turns, left.collect::<Vec<_>>());
        let (of_dxf, dxf_mm) = dxf_centreline(&template_dxf(&drawing));
        for (parts, sum) in [(of_svg, svg_mm), (of_dxf, dxf_mm)] {
            prop_assert_eq!(parts.len(), meant.len());
            prop_assert!((sum - found).abs() < 1e-2, "{sum} for {found}");
            let shift = [parts[0][0][0] - meant[0][0][0], parts[0][0][1] - meant[0][0][1]];
            for (part, meant) in parts.iter().zip(&meant) {
                let moved = meant.map(|p| [p[0] + shift[0], p[1] + shift[1]]);
                // In DXF an arc to the right begins at its other end.
                let swapped = [part[1], part[0]];
                let off = |ends: [[f64; 2]; 2]| distance(ends[0], moved[0]).max(distance(ends[1], moved[1]));
                prop_assert!(off(*part).min(off(swapped)) < 1e-3, "{part:?} for {moved:?}");
            }
        }
    }

    /// Whatever the path, a template can be drawn and written, and its centreline is not longer than the path.
    #[test]
    fn any_path_has_a_template(
        points in prop::collection::vec(prop::array::uniform3(-100.0..100.0_f64), 0..8),
        again in any::<bool>(),
    ) {
        let mut path: Vec<Point3<f64>> = points.into_iter().map(Point3::from).collect();
        if again {
            let back: Vec<_> = path.iter().rev().copied().collect();
            path.extend(back);
        }
        let drawing = template(&of(vec![path.clone(), path]));
        let (svg, dxf) = (template_svg(&drawing), template_dxf(&drawing));
        for text in [&svg, &dxf] {
            prop_assert!(!text.contains("NaN") && !text.contains("inf"));
        }
        for paper in Paper::ALL {
            prop_assert!(template_pdf(&drawing, paper).is_ok());
        }
    }
}

#[test]
fn lengths_of_a_corner_by_hand() {
    // 90 mm less twice 4.5 mm and with a quarter of a circle of 4.5 mm: 88.0686 mm.
    let path = [[0., 0., 0.], [50., 0., 0.], [50., 40., 0.]].map(Point3::from);
    let found: f64 = centreline(&drawn(&path)).into_iter().map(length).sum();
    assert!((found - 88.0686).abs() < 1e-4, "{found}");
    let _: Length = mm(found);
}
