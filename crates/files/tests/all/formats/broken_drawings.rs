//! Broken and hostile drawings: each is refused by name, with its place, and none takes the program down.

use std::fmt::Write as _;

use expect_test::{Expect, expect};
use wirebend_files::read::{LengthUnit, ReadOptions, read};

use super::dxf::{drawing, section};
use super::models::{QUAD, TRIANGLE, buffer, glb, model, of_model, package, scene};
use super::svg::page;
use super::{import, mm};

/// One line for each input: the code of its error, and the error.
pub fn check(name: &str, inputs: &[impl AsRef<[u8]>], expected: &Expect) {
    let mut list = String::new();
    for input in inputs {
        let error = import(name, input).map(|imported| imported.notes).unwrap_err();
        writeln!(list, "{}: {error} {:?}", error.code(), error.remedies()).unwrap();
    }
    expected.assert_eq(&list);
}

#[test]
fn dxf() {
    let loops = "0 BLOCK 2 a 10 0 20 0 0 INSERT 2 b 10 0 20 0 0 ENDBLK 0 BLOCK 2 b 10 0 20 0 0 INSERT 2 A 10 0 20 0 0 ENDBLK";
    let with = |blocks: &str, entities: &str| section("BLOCKS", blocks) + &drawing(entities);
    let deep: String = (0..70)
        .map(|k| format!("0 BLOCK 2 d{k} 10 0 20 0 0 INSERT 2 d{} 10 0 20 0 0 ENDBLK ", k + 1))
        .collect();
    let files = [
        drawing("0 LINE 10 0 20 0 11 1"),
        drawing("0 LINE 10 0 20 0 11 1 21 nan"),
        drawing("0 LINE 10 0 20 0 11 1 21 1e400"),
        drawing("0 LINE 10 0 20 0 11 1 21 1e9"),
        drawing("0 CIRCLE 10 0 20 0 40 1e300"),
        drawing("0 ARC 10 0 20 0 40 1 50 0 51 90 210 0 220 0 230 0"),
        drawing("0 LWPOLYLINE 10 0 10 1 20 1"),
        drawing("0 LWPOLYLINE 90 3"),
        drawing("0 SPLINE 71 3 40 0 40 1 10 0 20 0 10 1 20 1"),
        drawing("0 SPLINE 71 1 40 0 40 0 40 1 10 0 20 0 10 1 20 1"),
        drawing("0 SPLINE 71 1 40 0 40 1 40 0 40 1 10 0 20 0 10 1 20 1"),
        drawing("0 TEXT 10 0 20 0 1 only"),
        drawing("0 INSERT 2 gone 10 0 20 0"),
        drawing("0 LINE ten 0"),
        with(loops, "0 INSERT 2 a 10 0 20 0"),
        with(&deep, "0 INSERT 2 d0 10 0 20 0"),
        section("HEADER", "9 $INSUNITS 70 99"),
        "0\nSECTION\n2\nENTITIES\n0\nLINE\n10\n0\n20\n0\n11\n1\n21\n0\n".to_owned(),
        "0\nSECTION\n2\nENTITIES\n0\nLINE\n10".to_owned(),
        "AC1032\0\0\0binary".to_owned(),
        "8\n0\n0\nSECTION\n".to_owned(),
        String::new(),
    ];
    check(
        "a.dxf",
        &files,
        &expect![[r#"
            read-syntax: a.dxf, line 16: found "LINE without group 21", expected a value of group 21 [ExportAgain]
            read-number: a.dxf, line 24: "nan" is not a finite number [CorrectFile]
            read-number: a.dxf, line 24: "1e400" is not a finite number [CorrectFile]
            read-wireframe: a.dxf, line 16: (1, 1000000000, 0) is not a position: each coordinate must be a number within ±1 000 000 mm [CheckScale]
            read-wireframe: a.dxf, line 16: (6.123233995736766e283, 1e300, 0) is not a position: each coordinate must be a number within ±1 000 000 mm [CheckScale]
            read-syntax: a.dxf, line 16: found "0, 0, 0", expected an extrusion with a length [ExportAgain]
            read-syntax: a.dxf, line 16: found "LWPOLYLINE without group 20", expected a value of group 20 [ExportAgain]
            read-syntax: a.dxf, line 16: found "LWPOLYLINE without group 10", expected a value of group 10 [ExportAgain]
            read-syntax: a.dxf, line 16: found a degree of 3 with 2 control points; it is 1 to 25, and less than the points, expected degree, knots and control points that fit together [ExportAgain]
            read-syntax: a.dxf, line 16: found 3 knots; degree and control points ask for 4, expected degree, knots and control points that fit together [ExportAgain]
            read-syntax: a.dxf, line 16: found knot 2 is out of order or repeated too often, expected degree, knots and control points that fit together [ExportAgain]
            read-empty: a.dxf: no edges and no faces in it (1 text ignored) [CheckRightFile]
            read-index: a.dxf, line 16: "gone" names no block: the file has 0 [CorrectFile]
            read-syntax: a.dxf, line 17: found "ten", expected a group code, which is a whole number from -5 to 1071 [CorrectFile]
            read-loop: a.dxf, line 32: block "a" holds itself [ExportResolved]
            read-too-deep: a.dxf, line 1148: blocks in blocks are more than 64 deep [ExportResolved]
            read-syntax: a.dxf, line 8: found "99", expected a unit from 1 to 16, 21 or 0 for none [ChooseUnit]
            read-truncated: a.dxf, line 2: section ENTITIES begins, but it has no ENDSEC: the file is cut off or damaged [ExportAgain]
            read-truncated: a.dxf, line 7: a value of group 10 has to follow, but the file ends: the file is cut off or damaged [ExportAgain]
            read-syntax: a.dxf, line 1: found "AC1032···binary", expected a group code, which is a whole number from -5 to 1071 [CorrectFile]
            read-syntax: a.dxf, line 2: found "8 0", expected 0 SECTION [ExportAs { form: "DXF" }]
            read-empty: a.dxf: the file is empty [CheckRightFile]
        "#]],
    );
    let mut bytes = b"AutoCAD Binary DXF\r\n\x1a\0".to_vec();
    bytes.extend(b"\0\0SECTION\0\x02\0ENTITIES\0\0\0LINE\0\x0a\0\0\0");
    let huge = [&bytes[..22], b"\0\0SECTION\0\xff\x7f"].concat();
    check(
        "a.dxf",
        &[bytes, huge],
        &expect![[r#"
            read-truncated: a.dxf, byte 52: 8 bytes of a group have to follow, but there are 2: the file is cut off or damaged [ExportAgain]
            read-syntax: a.dxf, byte 32: found "32767", expected a group code, which is a whole number from -5 to 1071 [ExportAgain]
        "#]],
    );
}

#[test]
fn blocks_in_blocks_do_not_grow_without_end() {
    // 30 levels of ten each: 10^30 lines.
    let mut blocks = "0 BLOCK 2 b0 10 0 20 0 0 LINE 10 0 20 0 11 1 21 0 0 ENDBLK ".to_owned();
    for k in 1..=30 {
        let inserts = format!("0 INSERT 2 b{} 10 0 20 0 ", k - 1).repeat(10);
        write!(blocks, "0 BLOCK 2 b{k} 10 0 20 0 {inserts} 0 ENDBLK ").unwrap();
    }
    let empty = "0 BLOCK 2 e 10 0 20 0 0 ENDBLK";
    let files = [
        section("BLOCKS", &blocks) + &drawing("0 INSERT 2 b30 10 0 20 0"),
        section("BLOCKS", empty) + &drawing("0 INSERT 2 e 10 0 20 0 70 32767 71 32767"),
    ];
    check(
        "a.dxf",
        &files,
        &expect![[r#"
            read-too-many: a.dxf, line 180: more than 250000 blocks and entities of blocks [SimplifyModel]
            read-too-many: a.dxf, line 32: more than 250000 blocks and entities of blocks [SimplifyModel]
        "#]],
    );
}

#[test]
fn layers_that_are_not_there() {
    let of = |name: &str, text: &str| {
        let options = ReadOptions { layers: vec!["wire".into()], ..ReadOptions::default() };
        read(text.as_bytes(), name, None, &options).map(|imported| imported.notes).unwrap_err()
    };
    let error = of("a.dxf", &drawing("0 LINE 8 Walls 10 0 20 0 11 1 21 0 0 LINE 10 0 20 0 11 1 21 0"));
    expect![[r#"read-no-such-layer: a.dxf: there is no layer "wire": its layers are "0", "walls" [CorrectInput { input: Layers }]"#]]
        .assert_eq(&format!("{}: {error} {:?}", error.code(), error.remedies()));
    let layer = "<g inkscape:groupmode=\"layer\" inkscape:label=\"Walls\"><path d=\"M0 0 1 1\"/></g>";
    let error = of("a.svg", &page(layer));
    expect![[r#"read-no-such-layer: a.svg: there is no layer "wire": its layers are "Walls" [CorrectInput { input: Layers }]"#]]
        .assert_eq(&format!("{}: {error} {:?}", error.code(), error.remedies()));
    let error = of("a.obj", "v 0 0 0");
    expect!["read-no-layers: a.obj: a file of format obj has no layers [LeaveOutLayers]"]
        .assert_eq(&format!("{}: {error} {:?}", error.code(), error.remedies()));
    let options = ReadOptions { tolerance: mm(0.0), ..ReadOptions::default() };
    let error = read(b"", "a.dxf", None, &options).map(|imported| imported.notes).unwrap_err();
    expect!["read-tolerance: the tolerance is 0 mm: it must be 0.0001 mm or more [CorrectInput { input: Tolerance }]"].assert_eq(&format!(
        "{}: {error} {:?}",
        error.code(),
        error.remedies()
    ));
}

#[test]
fn svg() {
    let nested = format!("{}<path d=\"M0 0 1 1\"/>{}", "<g>".repeat(300), "</g>".repeat(300));
    let files = [
        page("<path d=\"M0 0 L 1\"/>"),
        page("<path d=\"L 1 1\"/>"),
        page("<path d=\"M0 0 L1e400 1\"/>"),
        page("<path d=\"M0 0 Lnan 1\"/>"),
        page("<path d=\"M0 0 L1e9 1\"/>"),
        page("<circle r=\"1e300\"/>"),
        page("<polyline points=\"0 0 1\"/>"),
        page("<polyline points=\"0 0 1 x\"/>"),
        page("<line x2=\"2em\"/>"),
        page("<path transform=\"turn(4)\" d=\"M0 0 1 1\"/>"),
        page("<path style=\"transform: rotate(45deg)\" d=\"M0 0 1 1\"/>"),
        page("<g id=\"a\"><use href=\"#a\"/></g>"),
        page("<g id=\"a\"><use href=\"#b\"/></g><g id=\"b\"><use href=\"#a\"/></g>"),
        page(&nested),
        page("<path d=\"M0 0 1 1\">"),
        page("<text>only</text>"),
        "<svg width=\"10%\"><line x2=\"5%\"/></svg>".to_owned(),
        "<svg viewBox=\"0 0 0 1\"><line x2=\"5\"/></svg>".to_owned(),
        "<html/>".to_owned(),
        "<!DOCTYPE svg [<!ENTITY a SYSTEM \"file:///etc/passwd\">]><svg><desc>&a;</desc></svg>".to_owned(),
        "not at all".to_owned(),
    ];
    check(
        "a.svg",
        &files,
        &expect![[r##"
            read-syntax: a.svg, line 2: found "M0 0 L 1", expected another value of d (unexpected end of stream) [ExportAs { form: "plain SVG" }]
            read-syntax: a.svg, line 2: found "L 1 1", expected another value of d (unexpected data at position 1) [ExportAs { form: "plain SVG" }]
            read-syntax: a.svg, line 2: found "M0 0 L1e400 1", expected another value of d (invalid number at position 7) [ExportAs { form: "plain SVG" }]
            read-syntax: a.svg, line 2: found "M0 0 Lnan 1", expected another value of d (invalid number at position 7) [ExportAs { form: "plain SVG" }]
            read-wireframe: a.svg, line 2: (1000000000, -1, 0) is not a position: each coordinate must be a number within ±1 000 000 mm [CheckScale]
            read-wireframe: a.svg, line 2: (6.123233995736766e283, -1e300, 0) is not a position: each coordinate must be a number within ±1 000 000 mm [CheckScale]
            read-syntax: a.svg, line 2: found "0 0 1", expected another value of points (a number without its y) [ExportAs { form: "plain SVG" }]
            read-syntax: a.svg, line 2: found "0 0 1 x", expected another value of points (invalid number at position 7) [ExportAs { form: "plain SVG" }]
            read-syntax: a.svg, line 2: found "2em", expected another value of x2 (not a length without the size of page or font) [ExportAs { form: "plain SVG" }]
            read-syntax: a.svg, line 2: found "turn(4)", expected another value of transform (unexpected data at position 1) [ExportAs { form: "plain SVG" }]
            read-unsupported: a.svg, line 2: a transform of a style, or with an origin, is not read [ExportAs { form: "plain SVG" }]
            read-loop: a.svg, line 2: element "#a" holds itself [ExportResolved]
            read-loop: a.svg, line 2: element "#b" holds itself [ExportResolved]
            read-too-deep: a.svg, line 2: elements in elements are more than 256 deep [ExportResolved]
            read-syntax: a.svg, line 3: found expected 'path' tag, not 'svg' at 3:1, expected an XML text with an svg element [ExportAs { form: "plain SVG" }]
            read-empty: a.svg: no edges and no faces in it (1 text ignored) [CheckRightFile]
            read-syntax: a.svg, line 1: found "5%", expected another value of x2 (not a length without the size of page or font) [ExportAs { form: "plain SVG" }]
            read-syntax: a.svg, line 1: found "0 0 0 1", expected another value of viewBox (viewBox has a negative or zero size) [ExportAs { form: "plain SVG" }]
            read-syntax: a.svg, line 1: found "html", expected an svg element around all others [CheckRightFile]
            read-syntax: a.svg, line 1: found unknown entity reference 'a' at 1:68, expected an XML text with an svg element [ExportAs { form: "plain SVG" }]
            read-syntax: a.svg, line 1: found unknown token at 1:1, expected an XML text with an svg element [ExportAs { form: "plain SVG" }]
        "##]],
    );
}

#[test]
fn entities_and_uses_do_not_grow_without_end() {
    let mut laughs = "<!DOCTYPE svg [<!ENTITY a0 \"lol\">".to_owned();
    let mut uses = "<path id=\"u0\" d=\"M0 0 1 1\"/>".to_owned();
    for k in 1..=30 {
        write!(laughs, "<!ENTITY a{k} \"{}\">", format!("&a{};", k - 1).repeat(10)).unwrap();
        let ten = format!("<use href=\"#u{}\"/>", k - 1).repeat(10);
        write!(uses, "<g id=\"u{k}\">{ten}</g>").unwrap();
    }
    let laughs = laughs + "]><svg><desc>&a30;</desc><line x2=\"1\"/></svg>";
    // Long and often.
    let long = format!(
        "<!DOCTYPE svg [<!ENTITY a \"{}\">]><svg><desc>{}</desc></svg>",
        "a".repeat(1 << 16),
        "&a;".repeat(1 << 16)
    );
    // A fuzzer's: the end of a declaration before its beginning.
    let turned = "]><!DOCTYPE svg [<!ENTITY".to_owned();
    check(
        "a.svg",
        &[laughs, long, "<!ENTITY".repeat(300), turned, page(&uses)],
        &expect![[r#"
            read-syntax: a.svg, line 1: found a possible entity reference loop is detected at 1:1264, expected an XML text with an svg element [ExportAs { form: "plain SVG" }]
            read-unsupported: a.svg: a text that entities make so long is not read [ExportAs { form: "plain SVG" }]
            read-unsupported: a.svg: a text that entities make so long is not read [ExportAs { form: "plain SVG" }]
            read-syntax: a.svg, line 1: found unknown token at 1:1, expected an XML text with an svg element [ExportAs { form: "plain SVG" }]
            read-too-many: a.svg, line 2: more than 250000 elements that are used [SimplifyModel]
        "#]],
    );
    // As deep as bytes allow, where a parser that calls itself would run out of stack.
    for element in ["<g>", "<a b='", "<!--", "<![CDATA[", "<?a ", "<!DOCTYPE a [", "&lt;"] {
        assert!(import("a.svg", format!("<svg>{}", element.repeat(200_000))).is_err());
    }
    assert!(
        import("a.svg", format!("<svg>{}{}</svg>", "<g>".repeat(200_000), "</g>".repeat(200_000))).is_err()
    );
}

/// Small files of every kind.
pub fn small_files() -> Vec<(&'static str, Vec<u8>)> {
    let entities = "0 LWPOLYLINE 90 2 70 1 10 0 20 0 42 1 10 5 20 0 0 ARC 10 0 20 0 40 5 50 0 51 90 0 INSERT 2 b 10 1 20 1 50 9";
    let blocks = "0 BLOCK 2 b 10 0 20 0 0 SPLINE 71 2 40 0 40 0 40 0 40 1 40 1 40 1 10 0 20 0 10 1 20 1 10 2 20 0 0 ENDBLK";
    let shapes = "<defs><rect id=\"r\" width=\"4\" height=\"3\" rx=\"1\"/></defs><use href=\"#r\" transform=\"rotate(9)\"/>\
        <path d=\"M0 0C1 2 3 4 5 6A1 2 3 0 1 9 9z\"/>";
    let object = format!("<object id=\"1\">{TRIANGLE}</object>");
    vec![
        ("a.dxf", (section("BLOCKS", blocks) + &drawing(entities)).into_bytes()),
        ("a.svg", page(shapes).into_bytes()),
        ("a.3mf", of_model(&model("", &object, "<item objectid=\"1\"/>"))),
        ("a.3mf", package(&[("3D/3dmodel.model", &model("", &object, "<item objectid=\"1\"/>"))], false)),
        ("a.glb", glb(&scene("[{\"mesh\": 0}]", QUAD, "{}"), &buffer())),
        ("a.dxf", include_bytes!("../../../../../fuzz/seeds/dxf/faces.dxf").to_vec()),
        ("a.svg", include_bytes!("../../../../../fuzz/seeds/svg/styles.svg").to_vec()),
    ]
}

#[test]
fn a_file_that_is_cut_off_anywhere_is_refused() {
    for (name, bytes) in small_files() {
        let whole = import(name, &bytes).unwrap_or_else(|error| panic!("{error}"));
        for end in 0..bytes.len() {
            match import(name, &bytes[..end]) {
                Err(error) => assert!(!error.remedies().is_empty() && error.to_string().contains(name)),
                // Of a text, white space and the mark of its end may be missing.
                Ok(cut) => {
                    let rest = &bytes[end..];
                    assert!(rest.len() < 8 && matches!(name, "a.dxf" | "a.svg"), "{name} cut at {end}");
                    assert_eq!(cut.wireframe.edge_count(), whole.wireframe.edge_count());
                }
            }
        }
    }
    // A unit that the person gives needs none of the file.
    let options = ReadOptions { units: Some(LengthUnit::Inch), ..ReadOptions::default() };
    let text = section("HEADER", "9 $INSUNITS 70 99") + &section("ENTITIES", "0 LINE 10 0 20 0 11 1 21 0");
    assert!(read(text.as_bytes(), "a.dxf", None, &options).is_ok());
}

/// A few lines can ask for any amount of work: what is asked for is counted before it is done.
#[test]
fn small_files_do_not_ask_for_much_work() {
    let attributes: String = (0..20_000).map(|k| format!(" a{k}=\"\"")).collect();
    let error = import("a.svg", page(&format!("<g{attributes}/>"))).map(|i| i.notes).unwrap_err();
    assert!(error.to_string().contains("attributes of one element"), "{error}");

    let (rules, lines) = (".a{display:none}".repeat(2000), "<line class=\"a\"/>".repeat(2000));
    let error =
        import("a.svg", page(&format!("<style>{rules}</style>{lines}"))).map(|i| i.notes).unwrap_err();
    assert!(error.to_string().contains("a style sheet of so many rules"), "{error}");

    let moves = "M0 0".repeat(100_000);
    let uses = "<use href=\"#p\"/>".repeat(10_000);
    let text = page(&format!("<defs><path id=\"p\" d=\"{moves}\"/></defs>{uses}"));
    let error = import("a.svg", &text).map(|imported| imported.notes).unwrap_err();
    assert_eq!(error.code(), "read-too-many", "{error}");
}
