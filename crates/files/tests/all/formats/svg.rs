//! SVG drawings, with coordinates computed by hand. In the files y points down.

use nalgebra::{Point3, Rotation3, Vector3};
use proptest::prelude::*;
use wirebend_files::read::{Imported, LengthUnit, ReadOptions, read};

use super::drawn::{assert_on, bounds, chain, edges, length, points, rounded, with_layers, with_tolerance};
use super::{import, notes};

/// A page of 100 mm by 100 mm whose numbers are millimetres.
pub fn page(elements: &str) -> String {
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" \
         xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" \
         width=\"100mm\" height=\"100mm\" viewBox=\"0 0 100 100\">\n{elements}\n</svg>\n"
    )
}

fn of(elements: &str) -> Imported {
    import("a.svg", page(elements)).unwrap_or_else(|error| panic!("{error}"))
}

/// Points of the page as points of the wireframe.
fn drawn(points: &[[f64; 2]]) -> Vec<[[f64; 3]; 2]> {
    chain(&points.iter().map(|[x, y]| [*x, 0.0 - y, 0.0]).collect::<Vec<_>>())
}

fn path(data: &str) -> Imported {
    of(&format!("<path d=\"{data}\"/>"))
}

#[test]
fn the_page_gives_the_scale_and_else_pixels_do() {
    let sheet = |head: &str| format!("<svg {head}><line x2=\"96\" y2=\"48\"/></svg>");
    let ends = |head: &str| edges(&import("a.svg", sheet(head)).unwrap())[0][1].to_vec();
    // 96 px are an inch.
    assert_eq!(ends(""), [25.4, -12.7, 0.0]);
    assert_eq!(ends("width=\"10px\" height=\"10\""), [25.4, -12.7, 0.0]);
    // A page of half the size of its view box.
    assert_eq!(ends("width=\"100mm\" height=\"50mm\" viewBox=\"0 0 200 100\""), [48.0, -24.0, 0.0]);
    assert_eq!(ends("width=\"10cm\" viewBox=\"0 0 200 100\""), [48.0, -24.0, 0.0]);
    assert_eq!(ends("height=\"2in\" viewBox=\"0 0 200 100\""), [48.768, -24.384, 0.0], "50.8/100 = 0.508");
    // 72 pt and 6 pc are an inch.
    assert_eq!(ends("width=\"72pt\" height=\"6pc\" viewBox=\"0 0 96 96\""), [25.4, -12.7, 0.0]);
    // Half the width in the middle, at the beginning, at the end, and stretched: 100 by 50 for 100 by 100.
    let wide = |aspect: &str| {
        ends(&format!(
            "width=\"100mm\" height=\"50mm\" viewBox=\"0 0 100 100\" preserveAspectRatio=\"{aspect}\""
        ))
    };
    assert_eq!(wide("xMidYMid"), [25.0 + 48.0, -24.0, 0.0]);
    assert_eq!(wide("xMinYMid"), [48.0, -24.0, 0.0]);
    assert_eq!(wide("xMaxYMid meet"), [50.0 + 48.0, -24.0, 0.0]);
    assert_eq!(wide("none"), [96.0, -24.0, 0.0]);
    // As large as covers the page: 100 high where there is room for 50, so 25 above it.
    assert_eq!(wide("xMidYMid slice"), [96.0, 25.0 - 48.0, 0.0]);
    // The view box begins elsewhere.
    assert_eq!(ends("width=\"10mm\" height=\"10mm\" viewBox=\"90 40 10 10\""), [6.0, -8.0, 0.0]);

    let said = |head: &str| notes(&import("a.svg", sheet(head)).unwrap().notes);
    let down = "y points down in the file: the drawing is mirrored so that it looks the same with y up";
    assert_eq!(said(""), ["no size in mm or the like: 96 px are taken as an inch", down]);
    let physical = "width=\"1in\" height=\"1in\" viewBox=\"0 0 1 1\"";
    assert_eq!(said(physical), ["the size of the page, in mm or the like, gives the scale", down]);
    // A unit of the person's is one of the numbers as they stand.
    let options = ReadOptions { units: Some(LengthUnit::Centimetre), ..ReadOptions::default() };
    let imported = read(sheet(physical).as_bytes(), "a.svg", None, &options).unwrap();
    assert_eq!(edges(&imported)[0][1].to_vec(), [960.0, -480.0, 0.0]);
    assert_eq!(notes(&imported.notes), [down, "the file names another unit; yours was used"]);
}

#[test]
fn every_straight_command_of_a_path() {
    let expected = drawn(&[[1., 2.], [5., 2.], [5., 9.], [8., 9.], [8., 7.], [6., 6.], [1., 2.]]);
    assert_eq!(edges(&path("M1 2H5V9h3v-2L6 6z")), expected);
    // A move is one to the next point, further points are lines, and after a close it is from the start.
    let expected = [drawn(&[[1., 1.], [2., 1.], [2., 3.], [1., 1.]]), drawn(&[[1., 1.], [0., 1.]])].concat();
    assert_eq!(edges(&path("m1,1 1,0 0,2 z l-1,0")), expected);
    let expected = [drawn(&[[0., 0.], [1., 0.]]), drawn(&[[0., 5.], [3., 5.]])].concat();
    assert_eq!(edges(&path("M0 0 1 0M0 5 3 5")), expected);
    assert_eq!(edges(&of("<polyline points=\"0,0 1,0 1 2\"/>")), drawn(&[[0., 0.], [1., 0.], [1., 2.]]));
    let triangle = drawn(&[[0., 0.], [1., 0.], [1., 2.], [0., 0.]]);
    assert_eq!(edges(&of("<polygon points=\"0,0 1,0 1 2\"/>")), triangle);
    // A last point on the first is the first.
    assert_eq!(edges(&path("M0 0L1 0L1 2L0 0Z")), triangle);
    let rect = drawn(&[[10., 20.], [30., 20.], [30., 25.], [10., 25.], [10., 20.]]);
    assert_eq!(edges(&of("<rect x=\"10\" y=\"20%\" width=\"20%\" height=\"5\"/>")), rect);
    // An inch on the page is 96 of its numbers, whatever those are.
    assert_eq!(edges(&of("<line x2=\"1in\"/>")), drawn(&[[0., 0.], [96., 0.]]));
}

#[test]
fn an_arc_lies_on_its_circle() {
    // With the clock on the page, over (5, -5): that is above, (5, 5), with y up. Radii that are too short are as
    // long as they need to be.
    for data in ["M0 0A5 5 0 0 1 10 0", "M0 0a1 1 0 1 1 10 0"] {
        let arc = path(data);
        assert_on(&arc, 0.1, |point| (point - Point3::new(5.0, 0.0, 0.0)).norm() - 5.0);
        assert!((bounds(&arc)[1][1] - 5.0).abs() < 0.1 && bounds(&arc)[0][1] > -1e-9);
    }
    // The long way against the clock from (0, 0) to (5, 5), over (-5, 5) and (0, 10): about (0, 5).
    let long = path("M0 0A5 5 0 1 0 5 5");
    assert_on(&long, 0.1, |point| (point - Point3::new(0.0, -5.0, 0.0)).norm() - 5.0);
    assert!((length(&long) - 5.0 * 270_f64.to_radians()).abs() < 0.5);
    // The short way with the same turn is about (5, 0), the other two ways are those with the other turn.
    for (flags, centre) in [("0 0", [5.0, 0.0]), ("0 1", [0.0, -5.0]), ("1 1", [5.0, 0.0])] {
        let arc = path(&format!("M0 0A5 5 0 {flags} 5 5"));
        assert_on(&arc, 0.1, |point| (point - Point3::new(centre[0], centre[1], 0.0)).norm() - 5.0);
        let degrees = if flags.starts_with('1') { 270_f64 } else { 90.0 };
        assert!((length(&arc) - 5.0 * degrees.to_radians()).abs() < 0.5, "{flags}");
    }
    // Radii 20 and 10, turned by 30° with the clock, so by -30° with y up: half of it, about the middle of the chord.
    let turned =
        with_tolerance("a.svg", &page("<path d=\"M10 40 A20 10 30 0 1 44.641016151377546 60\"/>"), 0.01);
    let centre = Point3::new(10.0 + 20.0 * 30_f64.to_radians().cos(), -50.0, 0.0);
    let back = Rotation3::from_axis_angle(&Vector3::z_axis(), 30_f64.to_radians());
    for point in points(&turned) {
        let own = back * (point - centre);
        let left = (own.x / 20.0).powi(2) + (own.y / 10.0).powi(2) - 1.0;
        assert!(left.abs() < 1e-7, "{point}: {left}");
    }
    // No radius is a straight line; no way is none.
    assert_eq!(edges(&path("M0 0A0 5 0 0 1 10 0")), drawn(&[[0., 0.], [10., 0.]]));
}

#[test]
fn curves_go_where_bezier_says() {
    // At half the way (P0 + 3 P1 + 3 P2 + P3)/8 = (15, 0), and the slope there is that of P2 + P3 - P0 - P1.
    let cubic = |data: &str| with_tolerance("a.svg", &page(&format!("<path d=\"{data}\"/>")), 0.001);
    let passes = |imported: &Imported, x: f64, y: f64| {
        let path = points(imported);
        let near = path.windows(2).map(|pair| {
            let along = pair[1] - pair[0];
            let from = Point3::new(x, -y, 0.0) - pair[0];
            let share = (from.dot(&along) / along.norm_squared()).clamp(0.0, 1.0);
            (from - along * share).norm()
        });
        let near = near.fold(f64::INFINITY, f64::min);
        assert!(near < 0.002, "{near} mm from ({x}, {y})");
    };
    let s = cubic("M0 0C10 20 20-20 30 0");
    passes(&s, 15.0, 0.0);
    // At a quarter (27·P0 + 27·P1 + 9·P2 + P3)/64 = (270 + 180 + 30)/64, (540 - 180)/64.
    passes(&s, 7.5, 5.625);
    // Smooth: the control point mirrored at (30, 0) is (40, 20); at half (30 + 3·40 + 3·60 + 60)/8, (60 + 3·20)/8.
    let smooth = cubic("M0 0C10 20 20-20 30 0S60 20 60 0");
    passes(&smooth, 48.75, 15.0);
    let smooth = cubic("m0 0c10 20 20-20 30 0s30 20 30 0");
    passes(&smooth, 48.75, 15.0);
    // Quadratic: (P0 + 2 P1 + P2)/4; mirrored (20, -10) and then half of (10, 0), (20, -10), (30, 0).
    let quadratic = cubic("M0 0Q0 10 10 0T30 0");
    passes(&quadratic, 2.5, 5.0);
    passes(&quadratic, 20.0, -5.0);
    // After another command a smooth curve starts without a direction: S is then C with the point itself.
    let plain = cubic("M0 0L10 0S20 10 30 0");
    passes(&plain, (10.0 + 30.0 + 60.0 + 30.0) / 8.0, 30.0 / 8.0);
}

#[test]
fn circles_ellipses_and_round_corners() {
    let circle = of("<circle cx=\"10\" cy=\"20\" r=\"5\"/>");
    assert_on(&circle, 0.1, |point| (point - Point3::new(10.0, -20.0, 0.0)).norm() - 5.0);
    assert_eq!(circle.wireframe.vertex_count(), circle.wireframe.edge_count());
    // 5 % of √(100² + 100²)/√2.
    let share = of("<circle cx=\"10\" cy=\"20\" r=\"5%\"/>");
    assert_eq!(edges(&share), edges(&circle));
    let ellipse = of("<ellipse cx=\"10%\" cy=\"20\" rx=\"8\" ry=\"4\"/>");
    for point in points(&ellipse) {
        let left = ((point.x - 10.0) / 8.0).powi(2) + ((point.y + 20.0) / 4.0).powi(2) - 1.0;
        assert!(left.abs() < 1e-9);
    }
    // Sides of 30 - 2·4 and 20 - 2·4, and a whole circle of radius 4: 2·22 + 2·12 + 25.13.
    let round =
        with_tolerance("a.svg", &page("<rect x=\"1\" y=\"2\" width=\"30\" height=\"20\" ry=\"4\"/>"), 0.001);
    assert!((length(&round) - 93.13).abs() < 0.02, "{}", length(&round));
    assert_eq!(bounds(&round).map(|c| rounded(&Point3::from(c))), [[1.0, -22.0, 0.0], [31.0, -2.0, 0.0]]);
    assert_eq!(round.wireframe.vertex_count(), round.wireframe.edge_count());
    // Radii of half the sides leave an ellipse and no sides.
    let full = of("<rect width=\"30\" height=\"20\" rx=\"99\" ry=\"99\"/>");
    for point in points(&full) {
        assert!((((point.x - 15.0) / 15.0).powi(2) + ((point.y + 10.0) / 10.0).powi(2) - 1.0).abs() < 1e-9);
    }
}

#[test]
fn transforms_work_from_the_inside_out() {
    // (1, 0) by 2: (2, 0); by 90°: (0, 2); moved: (10, 22).
    let text = "<g transform=\"translate(10,20)\"><g transform=\"rotate(90) scale(2)\"><path d=\"M0 0 1 0\"/></g></g>";
    assert_eq!(edges(&of(text)), drawn(&[[10., 20.], [10., 22.]]));
    // About (5, 5), (5, 0) goes by 90° to (10, 5). A skew by 45° adds y to x.
    assert_eq!(
        edges(&of("<path transform=\"rotate(90 5 5)\" d=\"M5 5V0\"/>")),
        drawn(&[[5., 5.], [10., 5.]])
    );
    assert_eq!(edges(&of("<path transform=\"skewX(45)\" d=\"M0 0 1 3\"/>")), drawn(&[[0., 0.], [4., 3.]]));
    let matrix = "<path transform=\"matrix(1 2 3 4 5 6)\" d=\"M1 0 0 1\"/>";
    assert_eq!(edges(&of(matrix)), drawn(&[[6., 8.], [8., 10.]]));
    // A circle of 5 stretched threefold.
    let wide = of("<circle r=\"5\" transform=\"scale(3 1)\"/>");
    assert!((bounds(&wide)[1][0] - 15.0).abs() < 1e-9);
}

#[test]
fn uses_symbols_and_pages_within() {
    let text = "<defs><path id=\"p\" d=\"M0 0 1 0\" transform=\"scale(2)\"/></defs>\
        <use href=\"#p\" x=\"5\" y=\"6\" transform=\"scale(3)\"/><use xlink:href=\"#p\"/>";
    let imported = of(text);
    // By 2 within, moved by (5, 6), by 3 without.
    assert_eq!(edges(&imported), [drawn(&[[15., 18.], [21., 18.]]), drawn(&[[0., 0.], [2., 0.]])].concat());
    assert!(notes(&imported.notes).contains(&"2 blocks or parts inserted where they are used".to_owned()));
    // A symbol of 10 by 10 on 20 by 20 at (30, 0).
    let text = "<symbol id=\"s\" viewBox=\"0 0 10 10\"><path d=\"M0 0 10 5\"/></symbol>\
        <use href=\"#s\" x=\"30\" width=\"20\" height=\"20\"/>";
    assert_eq!(edges(&of(text)), drawn(&[[30., 0.], [50., 10.]]));
    // A page within: 4 by 4 numbers on 40 by 40 at (10, 20); a half of its width is 2 of its numbers.
    let text = "<svg x=\"10\" y=\"20\" width=\"40\" height=\"40\" viewBox=\"0 0 4 4\"><line x2=\"50%\" y2=\"1\"/></svg>";
    assert_eq!(edges(&of(text)), drawn(&[[10., 20.], [30., 30.]]));
}

#[test]
fn what_is_hidden_or_not_read_is_counted() {
    let text = "<style>.a{display:none}</style><title>x</title><metadata/><text>a</text><image href=\"http://a/b.png\"/>\
        <g display=\"none\"><path d=\"M0 0 1 1\"/></g><path style=\"stroke: red; display: none\" d=\"M0 0 1 1\"/>\
        <g visibility=\"hidden\"><path d=\"M0 0 1 1\"/><path visibility=\"visible\" d=\"M0 0 9 0\" fill=\"none\"/></g>\
        <path d=\"M0 5 1 5\" clip-path=\"url(#c)\" style=\"filter:url(#f)\" mask=\"none\"/><use href=\"b.svg#x\"/>\
        <foreignObject/><rect width=\"0\" height=\"1\"/><clipPath id=\"c\"><circle r=\"1\"/></clipPath><path d=\"\"/>";
    let imported = of(text);
    assert_eq!(edges(&imported), [drawn(&[[0., 0.], [9., 0.]]), drawn(&[[0., 5.], [1., 5.]])].concat());
    expect_test::expect![[r#"
        the size of the page, in mm or the like, gives the scale
        y points down in the file: the drawing is mirrored so that it looks the same with y up
        1 text ignored
        1 picture ignored
        3 hidden elements left out
        2 filters, masks, clip paths or markers ignored
        1 reference to another file or a missing element ignored
        1 other element ignored
        2 edges without length dropped"#]]
    .assert_eq(&notes(&imported.notes).join("\n"));
}

/// A drawing with its labels in several languages has each strut once.
#[test]
fn of_a_switch_one_is_drawn() {
    let (one, other) = ("<line x2=\"5\"/>", "<line x2=\"7\"/>");
    let german = "<line systemLanguage=\"de\" x2=\"9\"/>";
    let foreign = "<foreignObject requiredExtensions=\"x\"/>";
    for (children, x, others) in [
        (format!("{german}{one}{other}"), 5.0, 2),
        (format!("{foreign}{other}"), 7.0, 1),
        (format!("{german}<!-- alone -->"), 9.0, 0),
    ] {
        let imported = of(&format!("<switch>{children}</switch>"));
        assert_eq!(edges(&imported), [[[0.0; 3], [x, 0.0, 0.0]]], "{children}");
        let hidden =
            imported.notes.iter().filter(|note| note.kind.code().contains("hidden")).map(|note| note.count);
        assert_eq!(hidden.sum::<usize>(), others, "{children}");
    }
    assert!(
        import("a.svg", page(&format!("{}{}", "<switch>".repeat(400), "</switch>".repeat(400)))).is_err()
    );
}

#[test]
fn layers_are_groups_by_label_or_id() {
    let text = page(
        "<g inkscape:groupmode=\"layer\" inkscape:label=\"Wire\" id=\"l1\"><g><path d=\"M0 0 1 0\"/></g></g>\
         <g inkscape:groupmode=\"layer\" inkscape:label=\"Notes\" id=\"l2\"><path d=\"M0 0 2 0\"/></g><path d=\"M0 0 3 0\"/>",
    );
    let lengths = |layers: &[&str]| {
        let imported = with_layers("a.svg", &text, layers);
        edges(&imported).iter().map(|ends| ends[1][0]).collect::<Vec<f64>>()
    };
    assert_eq!(lengths(&[]), [1.0, 2.0, 3.0]);
    assert_eq!(lengths(&["wire"]), [1.0]);
    assert_eq!(lengths(&["L2", "WIRE"]), [1.0, 2.0]);
    let imported = with_layers("a.svg", &text, &["notes"]);
    assert_eq!(imported.layers, ["Wire", "Notes"]);
    assert!(notes(&imported.notes).contains(&"2 elements on other layers left out".to_owned()));
}

#[test]
fn the_bracket_has_the_size_that_it_says() {
    let bracket = super::drawn::example("bracket.svg");
    assert!(super::drawn::is_one_wire(&bracket));
    // 50 + 80 + 60 + 50 + 40 and a quarter of a circle of radius 60, 94.25.
    assert!((length(&bracket) - 374.25).abs() < 0.2, "{}", length(&bracket));
    assert_eq!(
        bounds(&bracket).map(|c| rounded(&Point3::from(c))),
        [[10.0, -130.0, 0.0], [150.0, -10.0, 0.0]]
    );
}

proptest! {
    /// Whatever element a polyline is written as, it is read back as it was.
    #[test]
    fn polylines_are_read_as_they_are_written(
        corners in prop::collection::vec(prop::array::uniform2(-1e3..1e3_f64), 2..20),
        kind in 0..4_u8,
        by in 0.1..10.0_f64,
    ) {
        let list = |corners: &[[f64; 2]]| corners.iter().map(|[x, y]| format!("{x} {y} ")).collect::<String>();
        let element = match kind {
            0 => format!("<polyline points=\"{}\"/>", list(&corners)),
            1 => format!("<path d=\"M{}\"/>", list(&corners)),
            2 => corners
                .windows(2)
                .map(|p| format!("<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\"/>", p[0][0], p[0][1], p[1][0], p[1][1]))
                .collect(),
            _ => {
                let small: Vec<[f64; 2]> = corners.iter().map(|corner| corner.map(|c| c / by)).collect();
                format!("<g transform=\"scale({by})\"><polyline points=\"{}\"/></g>", list(&small))
            }
        };
        let imported = of(&element);
        prop_assert_eq!(imported.wireframe.edge_count(), corners.len() - 1);
        for ((_, edge), pair) in imported.wireframe.edges().zip(corners.windows(2)) {
            for (id, [x, y]) in [edge.a, edge.b].into_iter().zip(pair) {
                let off = (imported.wireframe.vertex(id).unwrap().position - Point3::new(*x, -y, 0.0)).norm();
                prop_assert!(off < 1e-9, "{} mm off", off);
            }
        }
    }
}
