//! DXF drawings, with coordinates computed by hand.

use nalgebra::Point3;
use proptest::prelude::*;
use wirebend_files::read::{Imported, LengthUnit, ReadOptions, read};

use super::drawn::{assert_on, bounds, chain, edges, length, points, rounded, with_layers, with_tolerance};
use super::{import, notes};

/// A drawing in millimetres of entities, each a kind and then pairs of a group code and a value.
pub fn drawing(entities: &str) -> String {
    format!("{}{}", section("HEADER", "9 $INSUNITS 70 4"), section("ENTITIES", entities)) + "0\nEOF\n"
}

/// Words are taken as codes and values in turn.
pub fn section(name: &str, pairs: &str) -> String {
    let words: Vec<&str> = pairs.split_whitespace().collect();
    format!("0\nSECTION\n2\n{name}\n{}\n0\nENDSEC\n", words.join("\n")).replace("\n\n", "\n")
}

pub fn of(entities: &str) -> Imported {
    import("a.dxf", drawing(entities)).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn a_line_is_an_edge_in_the_unit_of_the_file() {
    let line = section("ENTITIES", "0 LINE 8 0 10 0 20 0 30 0 11 1 21 2 31 3");
    // 4 is mm, 1 inches, 2 feet of 304.8 mm, 13 µm.
    for (code, unit) in [(4, 1.0), (1, 25.4), (2, 304.8), (5, 10.0), (6, 1000.0), (13, 0.001)] {
        let header = section("HEADER", &format!("9 $ACADVER 1 AC1015 9 $INSUNITS 70 {code}"));
        let imported = import("a.dxf", format!("{header}{line}")).unwrap();
        assert_eq!(
            edges(&imported),
            chain(&[[0.0; 3], rounded(&Point3::new(unit, 2.0 * unit, 3.0 * unit))]),
            "unit {code}"
        );
        assert_eq!(notes(&imported.notes), [""; 0]);
    }
    for header in ["", &section("HEADER", "9 $INSUNITS 70 0"), &section("HEADER", "9 $LTSCALE 40 1")] {
        let imported = import("a.dxf", format!("{header}{line}")).unwrap();
        assert_eq!(edges(&imported), chain(&[[0.0; 3], [1.0, 2.0, 3.0]]));
        assert_eq!(notes(&imported.notes), ["units not given: taken as mm"]);
    }
    let options = ReadOptions { units: Some(LengthUnit::Centimetre), scale: 2.0, ..ReadOptions::default() };
    let imported = read(drawing("0 LINE 10 1 20 0 11 2 21 0").as_bytes(), "a.dxf", None, &options).unwrap();
    assert_eq!(edges(&imported), chain(&[[20.0, 0.0, 0.0], [40.0, 0.0, 0.0]]));
    assert_eq!(notes(&imported.notes), ["the file names another unit; yours was used"]);
}

#[test]
fn a_bulge_of_one_is_half_a_circle_to_the_right() {
    // tan(180°/4) = 1; against the clock from (0, 0) to (10, 0) the half circle passes (5, -5).
    let half = of("0 LWPOLYLINE 90 2 70 0 10 0 20 0 42 1 10 10 20 0");
    assert_on(&half, 0.1, |point| (point - Point3::new(5.0, 0.0, 0.0)).norm() - 5.0);
    let [low, high] = bounds(&half);
    assert!((low[1] + 5.0).abs() < 0.1 && high[1] < 1e-9, "{low:?} {high:?}");
    // Half a circle of 15.708 mm; chords are at most the share of 0.1/5 shorter.
    assert!((length(&half) - 15.708).abs() < 0.3);
    assert_eq!(notes(&half.notes), ["1 curve made straight edges within the tolerance"]);
}

#[test]
fn a_negative_bulge_goes_with_the_clock() {
    // Sagitta 0.5·10/2 = 2.5 to the left, above; radius (5² + 2.5²)/(2·2.5) = 6.25, centre 2.5 - 6.25 = -3.75.
    for text in [
        "0 LWPOLYLINE 90 2 10 10 20 0 42 -0.5 10 20 20 0",
        "0 POLYLINE 66 1 10 0 20 0 30 0 0 VERTEX 10 10 20 0 42 -0.5 0 VERTEX 10 20 20 0 0 SEQEND",
    ] {
        let arc = of(text);
        assert_on(&arc, 0.1, |point| (point - Point3::new(15.0, -3.75, 0.0)).norm() - 6.25);
        assert!((bounds(&arc)[1][1] - 2.5).abs() < 0.1);
    }
}

#[test]
fn a_closed_polyline_bulges_back_to_its_start() {
    // Two half circles: the circle about (5, 0). As many vertices as edges: no edge of its own closes it.
    let circle = of("0 LWPOLYLINE 90 2 70 1 10 0 20 0 42 1 10 10 20 0 42 1");
    assert_on(&circle, 0.1, |point| (point - Point3::new(5.0, 0.0, 0.0)).norm() - 5.0);
    assert_eq!(circle.wireframe.vertex_count(), circle.wireframe.edge_count());
    let square = of("0 LWPOLYLINE 90 3 70 1 38 7 10 0 20 0 10 4 20 0 10 4 20 3");
    let corners = [[0.0, 0.0, 7.0], [4.0, 0.0, 7.0], [4.0, 3.0, 7.0], [0.0, 0.0, 7.0]];
    assert_eq!(edges(&square), chain(&corners));
}

#[test]
fn an_extrusion_down_mirrors_x() {
    // Axes for (0, 0, -1): x = (0,1,0) × (0,0,-1) = (-1,0,0), y = (0,0,-1) × (-1,0,0) = (0,1,0).
    let arc = of("0 ARC 10 10 20 0 30 2 40 5 50 0 51 90 210 0 220 0 230 -1");
    assert_on(&arc, 0.1, |point| (point - Point3::new(-10.0, 0.0, -2.0)).norm() - 5.0);
    let points = points(&arc);
    // From (15, 0) and (10, 5) of its own.
    assert!((points[0] - Point3::new(-15.0, 0.0, -2.0)).norm() < 1e-9, "{}", points[0]);
    assert!((points[points.len() - 1] - Point3::new(-10.0, 5.0, -2.0)).norm() < 1e-9);
    // A bulge to the right is one to the left in the mirror.
    let half = of("0 LWPOLYLINE 90 2 10 0 20 0 42 1 10 -10 20 0 210 0 220 0 230 -1");
    assert!((bounds(&half)[1][1] - 5.0).abs() < 0.1, "from (0, 0) to (10, 0) over (5, 5)");
    // Lines, and polylines in space, have no axes of their own.
    let line = of("0 LINE 10 1 20 0 11 2 21 0 210 0 220 0 230 -1");
    assert_eq!(edges(&line), chain(&[[1.0, 0.0, 0.0], [2.0, 0.0, 0.0]]));
}

#[test]
fn an_extrusion_along_x_stands_upright() {
    // Axes for (1, 0, 0): x = (0,0,1) × (1,0,0) = (0,1,0), y = (1,0,0) × (0,1,0) = (0,0,1): (a, b, c) is (c, a, b).
    let upright = of("0 LWPOLYLINE 90 2 38 3 10 1 20 2 10 4 20 2 210 1 220 0 230 0");
    assert_eq!(edges(&upright), chain(&[[3.0, 1.0, 2.0], [3.0, 4.0, 2.0]]));
}

#[test]
fn a_polyline_in_space_keeps_its_heights() {
    let text = "0 POLYLINE 66 1 70 9 10 0 20 0 30 5 0 VERTEX 70 32 10 0 20 0 30 1 0 VERTEX 70 32 10 3 20 0 30 2 \
        0 VERTEX 70 32 10 3 20 3 30 4 0 SEQEND";
    let corners = [[0.0, 0.0, 1.0], [3.0, 0.0, 2.0], [3.0, 3.0, 4.0], [0.0, 0.0, 1.0]];
    assert_eq!(edges(&of(text)), chain(&corners));
    // What steers a fitted curve is not on it, and a mesh is none.
    let fitted = "0 POLYLINE 66 1 70 4 10 0 20 0 30 0 0 VERTEX 70 16 10 5 20 9 0 VERTEX 70 8 10 0 20 0 \
        0 VERTEX 70 8 10 1 20 0 0 SEQEND 0 POLYLINE 66 1 70 64 10 0 20 0 30 0 0 VERTEX 70 192 10 7 20 7 0 SEQEND";
    let imported = of(fitted);
    assert_eq!(edges(&imported), chain(&[[0.0; 3], [1.0, 0.0, 0.0]]));
    assert_eq!(notes(&imported.notes), ["1 face, surface or solid ignored"]);
}

#[test]
fn circles_and_ellipses_close_and_arcs_do_not() {
    let circle = of("0 CIRCLE 10 1 20 2 30 3 40 5");
    assert_on(&circle, 0.1, |point| (point - Point3::new(1.0, 2.0, 3.0)).norm() - 5.0);
    assert_eq!(circle.wireframe.vertex_count(), circle.wireframe.edge_count());
    // Over 0°: 20° in all, so two ends.
    let arc = of("0 ARC 10 0 20 0 40 50 50 350 51 10");
    assert_eq!(arc.wireframe.vertex_count(), arc.wireframe.edge_count() + 1);
    assert!(bounds(&arc)[0][0] > 50.0 * 10_f64.to_radians().cos() - 1e-9, "on the side of x");
    // Half of x²/12² + y²/6² = 1; what is left of the equation, times the gradient's least length, is the distance.
    let half = of("0 ELLIPSE 10 0 20 0 11 12 21 0 40 0.5 41 0 42 3.141592653589793");
    for point in points(&half) {
        assert!(((point.x / 12.0).powi(2) + (point.y / 6.0).powi(2) - 1.0).abs() < 1e-9 && point.y > -1e-9);
    }
    assert!((bounds(&half)[1][1] - 6.0).abs() < 0.1);
    // The whole of it, with 2π as files have it: rounded down, rounded up, and from -π to π.
    for parameters in ["41 0 42 6.283185", "41 0 42 6.28318531", "41 -3.14159265359 42 3.14159265359"] {
        let whole = of(&format!("0 ELLIPSE 10 0 20 0 11 12 21 0 40 0.5 {parameters}"));
        let [low, high] = bounds(&whole).map(|corner| corner[0]);
        assert!((low + 12.0).abs() < 0.1 && (high - 12.0).abs() < 0.1, "{parameters}: {low} to {high}");
        assert_eq!(whole.wireframe.vertex_count(), whole.wireframe.edge_count(), "{parameters}: it closes");
    }
}

const LEG: &str = "0 BLOCK 2 Leg 10 1 20 0 30 0 0 LINE 8 0 10 1 20 0 11 1 21 9 0 ENDBLK";

fn with_blocks(blocks: &str, entities: &str) -> String {
    format!("{}{}", section("BLOCKS", blocks), drawing(entities))
}

#[test]
fn a_block_is_scaled_turned_and_put_in() {
    // (1, 0)-(1, 9) from the base (1, 0) on is (0, 0)-(0, 9); y by -1: (0, -9); by 90°: (9, 0); at (100, 0).
    let text = with_blocks(LEG, "0 INSERT 2 LEG 10 100 20 0 41 2 42 -1 50 90");
    let imported = import("a.dxf", &text).unwrap();
    assert_eq!(edges(&imported), chain(&[[100.0, 0.0, 0.0], [109.0, 0.0, 0.0]]));
    assert_eq!(notes(&imported.notes), ["1 block or part inserted where it is used"]);
    // Two columns 20 apart, turned with the block but not scaled.
    let text = with_blocks(LEG, "0 INSERT 2 leg 10 0 20 0 41 3 50 90 70 2 71 1 44 20 45 5");
    let imported = import("a.dxf", &text).unwrap();
    let expected =
        [chain(&[[0.0; 3], [-9.0, 0.0, 0.0]]), chain(&[[0.0, 20.0, 0.0], [-9.0, 20.0, 0.0]])].concat();
    assert_eq!(edges(&imported), expected);
    // In the mirror of (0, 0, -1), at -x: (0, 9) stays (0, 9).
    let text = with_blocks(LEG, "0 INSERT 2 leg 10 5 20 0 210 0 220 0 230 -1");
    assert_eq!(edges(&import("a.dxf", &text).unwrap()), chain(&[[-5.0, 0.0, 0.0], [-5.0, 9.0, 0.0]]));
}

#[test]
fn a_circle_in_a_stretched_block_is_an_ellipse() {
    let blocks = "0 BLOCK 2 o 10 0 20 0 0 CIRCLE 10 0 20 0 40 10 0 ENDBLK \
        0 BLOCK 2 p 10 0 20 0 0 INSERT 2 o 10 0 20 0 41 3 0 ENDBLK";
    let text = with_blocks(blocks, "0 INSERT 2 p 10 7 20 0 50 90");
    let imported = with_tolerance("a.dxf", &text, 0.01);
    // 3·10 along x, turned by 90°: along y.
    for point in points(&imported) {
        let left = ((point.x - 7.0) / 10.0).powi(2) + (point.y / 30.0).powi(2) - 1.0;
        assert!(left.abs() < 1e-9, "{point}");
    }
    // Ramanujan: π·(3(30 + 10) - √((90 + 10)(30 + 30))) = 133.65 mm around.
    assert!((length(&imported) - 133.65).abs() < 0.2, "{}", length(&imported));
}

const LAYERS: &str =
    "0 TABLE 2 LAYER 0 LAYER 2 wire 70 0 62 7 0 LAYER 2 Off 70 0 62 -1 0 LAYER 2 frozen 70 1 62 1 0 ENDTAB";

#[test]
fn hidden_layers_are_left_out_unless_they_are_asked_for() {
    let line = |layer: &str, x: u8| format!("0 LINE 8 {layer} 10 {x} 20 0 11 {x} 21 5 ");
    let entities = [line("wire", 1), line("OFF", 2), line("frozen", 3), line("other", 4)].concat()
        + "0 LINE 8 wire 60 1 10 5 20 0 11 5 21 5 0 LINE 8 wire 67 1 10 6 20 0 11 6 21 5 \
           0 INSERT 8 off 2 leg 10 7 20 0 0 INSERT 8 wire 2 leg 10 8 20 0";
    let text = format!("{}{}", section("TABLES", LAYERS), with_blocks(LEG, &entities));
    let along = |imported: &Imported| {
        let mut x: Vec<f64> = points(imported).iter().map(|point| point.x).collect();
        x.dedup();
        x
    };
    let all = import("a.dxf", &text).unwrap();
    assert_eq!(all.layers, ["0", "frozen", "off", "other", "wire"], "to choose of, hidden ones too");
    // What is in the block is on layer 0, so on the layer of the block.
    assert_eq!(along(&all), [1.0, 4.0, 8.0]);
    expect_test::expect![[r#"
        4 hidden elements left out
        1 element of the paper layout left out
        1 block or part inserted where it is used"#]]
    .assert_eq(&notes(&all.notes).join("\n"));
    let off = with_layers("a.dxf", &text, &["off"]);
    assert_eq!(along(&off), [2.0, 7.0]);
    expect_test::expect![[r#"
        4 elements on other layers left out
        1 hidden element left out
        1 element of the paper layout left out
        2 blocks or parts inserted where they are used"#]]
    .assert_eq(&notes(&off.notes).join("\n"));
    assert_eq!(along(&with_layers("a.dxf", &text, &["WIRE", "Frozen"])), [1.0, 3.0, 8.0]);
}

#[test]
fn all_that_is_not_read_is_counted() {
    let kinds = [
        "TEXT",
        "MTEXT",
        "HATCH",
        "DIMENSION",
        "LEADER",
        "3DSOLID",
        "SOLID",
        "IMAGE",
        "POINT",
        "XLINE",
        "RAY",
        "HELIX",
    ];
    let mut entities: String = kinds.map(|kind| format!("0 {kind} 10 1 20 1 ")).concat();
    entities = entities.replace("HELIX 10 1 20 1", "HELIX 100 AcDbHelix 10 1 20 1");
    let imported = of(&(entities + "0 LINE 10 0 20 0 11 1 21 0"));
    expect_test::expect![[r#"
        2 texts ignored
        1 hatch ignored
        2 dimensions or leaders ignored
        2 faces, surfaces or solids ignored
        1 picture ignored
        1 loose point ignored
        3 other elements ignored"#]]
    .assert_eq(&notes(&imported.notes).join("\n"));
    let blocks = "0 BLOCK 2 far 70 4 10 0 20 0 1 other.dxf 0 ENDBLK";
    let text = with_blocks(blocks, "0 INSERT 2 far 10 0 20 0 0 LINE 10 0 20 0 11 1 21 0");
    let expected = ["1 reference to another file or a missing element ignored"];
    assert_eq!(notes(&import("a.dxf", &text).unwrap().notes), expected);
}

/// The same drawing as a binary file.
fn binary(text: &str, wide: bool) -> Vec<u8> {
    let mut bytes = b"AutoCAD Binary DXF\r\n\x1a\0".to_vec();
    let lines: Vec<&str> = text.lines().collect();
    for pair in lines.chunks_exact(2) {
        let code: u16 = pair[0].parse().unwrap();
        if wide {
            bytes.extend(code.to_le_bytes());
        } else {
            bytes.push(u8::try_from(code).unwrap());
        }
        match code {
            10..=59 | 210..=239 => bytes.extend(pair[1].parse::<f64>().unwrap().to_le_bytes()),
            60..=79 => bytes.extend(pair[1].parse::<i16>().unwrap().to_le_bytes()),
            90..=99 => bytes.extend(pair[1].parse::<i32>().unwrap().to_le_bytes()),
            _ => bytes.extend([pair[1].as_bytes(), b"\0"].concat()),
        }
    }
    bytes
}

#[test]
fn a_binary_file_is_the_same_drawing() {
    let text =
        with_blocks(LEG, "0 INSERT 2 leg 10 5 20 0 0 LWPOLYLINE 90 2 70 1 10 0 20 0 42 -0.25 10 -8 20 0.5");
    let expected = edges(&import("a.dxf", &text).unwrap());
    for wide in [true, false] {
        let bytes = binary(&text, wide);
        assert_eq!(edges(&import("a.dxf", &bytes).unwrap()), expected);
        // Without an extension, too.
        assert_eq!(edges(&import("standard input", &bytes).unwrap()), expected);
    }
    assert_eq!(edges(&import("standard input", format!("999\na comment\n{text}")).unwrap()), expected);
    assert_eq!(edges(&import("a.dxf", text.replace('\n', "\r\n")).unwrap()), expected);
}

#[test]
fn the_hook_is_a_leg_and_three_quarters_of_a_circle() {
    let hook = super::drawn::example("hook.dxf");
    assert!(super::drawn::is_one_wire(&hook));
    // 60 and 60·3π/2 = 282.74; a chord of 0.1 mm is shorter by a share of 2/3·0.1/60.
    assert!((length(&hook) - 342.74).abs() < 0.4, "{}", length(&hook));
    for point in points(&hook).iter().filter(|point| (point.y - 60.0).abs() > 1e-9) {
        assert!((point.coords.norm() - 60.0).abs() < 1e-9, "{point}");
    }
    assert_eq!(
        notes(&hook.notes),
        [
            "1 curve made straight edges within the tolerance",
            "1 hidden element left out",
            "1 vertex merged into another (line 74)"
        ]
    );
}

proptest! {
    /// Whatever entity a polyline is written as, it is read back as it was.
    #[test]
    fn polylines_are_read_as_they_are_written(
        points in prop::collection::vec(prop::array::uniform3(-1e4..1e4_f64), 2..20),
        kind in 0..3_u8,
        closed: bool,
    ) {
        // A plane polyline has one height.
        let at = |k: usize| if kind == 1 { [points[k][0], points[k][1], points[0][2]] } else { points[k] };
        let mut corners: Vec<[f64; 3]> = (0..points.len()).map(at).collect();
        let vertex = |[x, y, z]: &[f64; 3]| format!("10 {x} 20 {y} 30 {z}");
        if closed && corners.len() > 2 {
            corners.push(corners[0]);
        }
        let lines = |pair: &[[f64; 3]]| {
            format!("0 LINE {} 11 {} 21 {} 31 {} ", vertex(&pair[0]), pair[1][0], pair[1][1], pair[1][2])
        };
        let ends = &corners[..points.len()];
        let flag = u8::from(corners.len() > points.len());
        let text = match kind {
            0 => corners.windows(2).map(lines).collect::<String>(),
            1 => {
                let vertices: String = ends.iter().map(|[x, y, _]| format!("10 {x} 20 {y} ")).collect();
                format!("0 LWPOLYLINE 70 {flag} 38 {} {vertices}", points[0][2])
            }
            _ => {
                let vertices: String = ends.iter().map(|c| format!("0 VERTEX 70 32 {} ", vertex(c))).collect();
                format!("0 POLYLINE 70 {} 10 0 20 0 30 0 {vertices} 0 SEQEND", 8 + flag)
            }
        };
        let imported = of(&text);
        prop_assert_eq!(imported.wireframe.edge_count(), corners.len() - 1);
        for ((_, edge), pair) in imported.wireframe.edges().zip(corners.windows(2)) {
            for (id, corner) in [edge.a, edge.b].into_iter().zip(pair) {
                let off = (imported.wireframe.vertex(id).unwrap().position - Point3::from(*corner)).norm();
                prop_assert!(off < 1e-9, "{} mm off", off);
            }
        }
    }
}
