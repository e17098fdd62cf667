//! What is broken is refused, with its place and what to do.

use std::fmt::Write as _;

use expect_test::{Expect, expect};
use wirebend_error::ErrorRemedy;
use wirebend_files::read::{Format, ReadOptions, detect, read, read_file};

use super::{import, mm};

/// One line for each input: the code of its error, the error, and what can be done about it.
fn check(name: &str, inputs: &[impl AsRef<[u8]>], expected: &Expect) {
    let mut list = String::new();
    for input in inputs {
        let error = import(name, input).unwrap_err();
        writeln!(list, "{}: {error} {:?}", error.code(), error.remedies()).unwrap();
    }
    expected.assert_eq(&list);
}

#[test]
fn obj() {
    let rest = [
        "f 1 2 4\n",
        "f 1 2 0",
        "l 1 -4",
        "f 1 2 x/1",
        "f 1 2",
        "l 2",
        "v 1 2",
        "v 1 2 nan",
        "v 1 2 3 0",
        "v 1 2 3e400",
        "v 1 2 2e9\nl 1 4",
        "",
    ];
    check(
        "a.obj",
        &rest.map(|rest| format!("v 0 0 0\nv 1 0 0\nv 1 1 0\n{rest}")),
        &expect![[r#"
            read-index: a.obj, line 4: "4" names no vertex: they go from 1 to 3 [CorrectFile]
            read-index: a.obj, line 4: "0" names no vertex: they go from 1 to 3 [CorrectFile]
            read-index: a.obj, line 4: "-4" names no vertex: they go from 1 to 3 [CorrectFile]
            read-number: a.obj, line 4: "x" is not a whole number [CorrectFile]
            read-syntax: a.obj, line 4: found "f 1 2", expected three or more indices after f [CorrectFile]
            read-syntax: a.obj, line 4: found "l 2", expected two or more indices after l [CorrectFile]
            read-syntax: a.obj, line 4: found "v 1 2", expected three numbers after v [CorrectFile]
            read-number: a.obj, line 4: "nan" is not a finite number [CorrectFile]
            read-syntax: a.obj, line 4: found "v 1 2 3 0", expected a weight, the fourth number, that leaves a finite position [CorrectFile]
            read-number: a.obj, line 4: "3e400" is not a finite number [CorrectFile]
            read-wireframe: a.obj, line 4: (1, 2, 2000000000) is not a position: each coordinate must be a number within ±1 000 000 mm [CheckScale]
            read-empty: a.obj: no edges and no faces in it (3 unused vertices dropped) [CheckRightFile]
        "#]],
    );
    assert_eq!(import("a.obj", "\n# x\nv 1").unwrap_err().line(), Some(3));
}

#[test]
fn stl() {
    let text = [
        "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0\n",
        "solid x\n facet normal 0 0 1\n outer loop\n vertex 0 0 0\n vertex 1 0 0\n",
        "\n\nsolid x\nendsolid x\nsolid y\nface\n",
        "solid x\nendsolid x\n",
        "sh\0rt",
        "",
        "  # a picture\nP3 1 1 255\n",
        "\n\n# of a later line\n",
        "\u{feff}solid x\nendsolid x\n",
        "A letter that is longer than the head of a binary file: from its 81st byte on, what would be the number of triangles is text.",
    ];
    check(
        "a.stl",
        &text,
        &expect![[r##"
            read-syntax: a.stl, line 5: found "vertex 1 0", expected solid, facet normal, outer loop, three vertices, endloop, endfacet, endsolid [CorrectFile]
            read-truncated: a.stl, line 5: a solid begins, but EOF while expecting vertex: the file is cut off or damaged [ExportAgain]
            read-syntax: a.stl, line 6: found "face", expected solid, facet normal, outer loop, three vertices, endloop, endfacet, endsolid [CorrectFile]
            read-empty: a.stl: no triangles in it [CheckRightFile]
            read-truncated: a.stl: a binary STL starts with 84 bytes, but there are 5: the file is cut off or damaged [ExportAgain]
            read-empty: a.stl: the file is empty [CheckRightFile]
            read-syntax: a.stl, line 1: found "# a picture", expected solid, with which an STL in text begins [OpenModel]
            read-syntax: a.stl, line 3: found "# of a later line", expected solid, with which an STL in text begins [OpenModel]
            read-empty: a.stl: no triangles in it [CheckRightFile]
            read-syntax: a.stl, line 1: found "A letter that is longer than the head of…", expected solid, with which an STL in text begins [OpenModel]
        "##]],
    );
    let mut many = vec![0_u8; 84];
    many[80..84].fill(0xff);
    let mut nan = vec![0_u8; 84 + 50];
    nan[80] = 1;
    nan[84 + 12..84 + 16].copy_from_slice(&f32::NAN.to_le_bytes());
    check(
        "a.stl",
        &[many, nan],
        &expect![[r#"
            read-truncated: a.stl, byte 80: 4294967295 triangles are announced, but there is room for 0: the file is cut off or damaged [ExportAgain]
            read-number: a.stl, byte 84: NaN is not a finite number [CorrectFile]
        "#]],
    );
}

#[test]
fn ply() {
    let vertex = "element vertex 1\nproperty float x\nproperty float y\nproperty float z";
    let faces = format!("ascii 1.0\n{vertex}\nelement face 1\nproperty list uchar int vertex_indices");
    let files = [
        ("ascii 1.0\nelement vertex 4000000000\nproperty float x", "1\n"),
        ("binary_little_endian 1.0\nelement vertex 4000000000\nproperty float x", "1234"),
        ("binary_little_endian 1.0\nelement nothing 4000000000", ""),
        ("ascii 1.0\nelement vertex 1\nproperty float x", "1\n"),
        (&format!("ascii 1.0\n{vertex}"), "1 2 x\n"),
        (&format!("binary_little_endian 1.0\n{vertex}"), "\0\0\0\0\0\0\0\0\0"),
        (&faces, "1 2 3\n3 0 0 1\n"),
        (&faces, "1 2 3\n3 0 0 -1\n"),
        (&faces, "1 2 3\n2 0 0\n"),
        (&faces, "1 2 3\n200 0 0\n"),
        (&format!("ascii 1.0\n{vertex}\nelement edge 1\nproperty int a"), "1 2 3\n0\n"),
        ("ascii 1.0", ""),
        ("weird 1.0", ""),
    ];
    let files = files.map(|(head, body)| format!("ply\nformat {head}\nend_header\n{body}"));
    check(
        "a.ply",
        &files,
        &expect![[r#"
            read-truncated: a.ply: 4000000000 entries of vertex are announced, but only 2 bytes are left: the file is cut off or damaged [ExportAgain]
            read-truncated: a.ply: 4000000000 entries of vertex are announced, but only 4 bytes are left: the file is cut off or damaged [ExportAgain]
            read-syntax: a.ply: found "element nothing 4000000000 without prope…", expected an element with properties [ExportWithout { part: "this element" }]
            read-syntax: a.ply, vertex 0: found "a vertex without position", expected the properties x, y and z [ExportAgain]
            read-syntax: a.ply, line 8: found "1 2 x", expected a PLY header, then numbers as it says [CorrectFile]
            read-truncated: a.ply: 1 entries of vertex are announced, but only 9 bytes are left: the file is cut off or damaged [ExportAgain]
            read-index: a.ply, face 0: 1 names no vertex: they count from 0 and there are 1 [CorrectFile]
            read-index: a.ply, face 0: -1 names no vertex: they count from 0 and there are 1 [CorrectFile]
            read-stencil: a.ply: face 0 has 2 vertices; a face has at least 3 [RepairMesh]
            read-syntax: a.ply, line 11: found "200 0 0", expected a PLY header, then numbers as it says [CorrectFile]
            read-syntax: a.ply, edge 0: found "other properties", expected two whole numbers [ExportAgain]
            read-empty: a.ply: no edges and no faces in it [CheckRightFile]
            read-syntax: a.ply, line 2: found "format weird 1.0", expected a PLY header, then numbers as it says [CorrectFile]
        "#]],
    );
}

#[test]
fn tables() {
    check(
        "a.xyz",
        &["1 2 3\n4 5\n", "1 2 3 4\n", "1 2 3\n1 2 inf\n", "# only this\n"],
        &expect![[r#"
            read-syntax: a.xyz, line 2: found "4 5", expected three numbers [CorrectFile]
            read-syntax: a.xyz, line 1: found "1 2 3 4", expected three numbers [NameColumns { columns: "x, y and z" }]
            read-number: a.xyz, line 2: "inf" is not a finite number [CorrectFile]
            read-empty: a.xyz: no points in it (1 comment ignored) [CheckRightFile]
        "#]],
    );
    check(
        "a.csv",
        &["a,b,c,d\n1,2,3,4\n"],
        &expect![[r#"
            read-syntax: a.csv: found "a, b, c, d", expected a header with x, y and z [NameColumns { columns: "x, y and z" }]
        "#]],
    );
    let tables = [
        "1 2 3 4 5\n",
        "10 0 180 5\n10\n",
        "10 0 90 -5\n10\n",
        "-10 0 90 5\n10\n",
        "angle,twist\n10,20\n",
        "D,Rabs,A\n10,20,30\n",
        "1e308,0,90,1e308\n",
        "D_mm,Rabs,A\n10,0,0\n9.99,0,0\n",
        "D_mm,Rabs,A,CLR\n40.0,0,90,9\n52.5,0,90,9\n",
        "C,F,E,G\n,9,0,90\n",
        "D_mm,A,CLR\n10,180,9\n",
        "50,0,200\n40\n",
    ];
    check(
        "a.lra",
        &tables,
        &expect![[r#"
            read-syntax: a.lra, line 1: found "1 2 3 4 5", expected L, R, A and perhaps CLR [NameColumns { columns: "L, R, A and CLR" }]
            read-no-corner: a.lra, line 1: a bend of 180.000° has no corner, its straight parts are parallel [SplitBend]
            read-syntax: a.lra, line 1: found "-5", expected a radius of 0 or more [CorrectFile]
            read-syntax: a.lra, line 1: found "-10", expected a length of 0 or more [CorrectFile]
            read-syntax: a.lra: found "angle, twist", expected a header with L, R and A [NameColumns { columns: "L, R, A and CLR, or D_mm for distances from the start" }]
            read-syntax: a.lra: found "d, rabs, a", expected a header with L, R and A [NameColumns { columns: "L, R, A and CLR, or D_mm for distances from the start" }]
            read-syntax: a.lra, line 1: found "1000000000000000000000000000000000000000…", expected a length within a kilometre [CorrectFile]
            read-syntax: a.lra, line 3: found "9.99", expected a distance of 10.000 mm or more, where the row before ends [CorrectFile]
            read-syntax: a.lra, line 3: found "52.5", expected a distance of 54.137 mm or more, where the row before ends [CorrectFile]
            read-syntax: a.lra, line 2: found "9 0 90", expected a distance from the start in every row [CorrectFile]
            read-no-corner: a.lra, line 2: a bend of 180.000° has no corner, its straight parts are parallel [SplitBend]
            read-no-corner: a.lra, line 1: a bend of 200.000° has no corner, it goes beyond half a turn [SplitBend]
        "#]],
    );
}

#[test]
fn programs() {
    let scripts = [
        "FEED 10\nFEED -3\n",
        "FEED 10 20\n",
        "FEED 10 (never closed\n",
        "(nothing but words)\n",
        "FEED 1\nFEED 2e6\n",
        "PINZ\n",
    ];
    check(
        "a.dsw",
        &scripts,
        &expect![[r#"
            read-syntax: a.dsw, line 2: found "-3", expected a feed of 0 or more [CorrectFile]
            read-syntax: a.dsw, line 1: found "FEED 10 20", expected a command: FEED, ROTATE, BEND or PINZ and one number [CorrectFile]
            read-syntax: a.dsw, line 1: found "FEED 10 (never closed", expected a comment that ends with ) [CorrectFile]
            read-empty: a.dsw: no feed of more than 0 in it (1 comment ignored) [CheckRightFile]
            read-wireframe: a.dsw, line 2: (2000001, 0, 0) is not a position: each coordinate must be a number within ±1 000 000 mm [CheckScale]
            read-syntax: a.dsw, line 1: found "PINZ", expected a command: FEED, ROTATE, BEND or PINZ and one number [CorrectFile]
        "#]],
    );
    check(
        "a.txt",
        &["F 10\nG 20\n", "F 10\nB x\n", "F 60\nB 90\nF 60\nR 90\nB 190\nF 60\n"],
        &expect![[r#"
            read-syntax: a.txt, line 2: found "G 20", expected F, R or B and one number [CorrectFile]
            read-number: a.txt, line 2: "x" is not a finite number [CorrectFile]
            read-no-corner: a.txt, line 5: a bend of 190.000° has no corner, it goes beyond half a turn [SplitBend]
        "#]],
    );
}

#[test]
fn frames() {
    check(
        "a.pwf",
        &["v 0 0 0\nl 1 2\n", "v 0 0 0\nv 1 0 0\ng 1 2 top\n", "v 0 0 0\nhello\n", "v 0 0\n"],
        &expect![[r#"
            read-index: a.pwf, line 2: "2" names no vertex: they go from 1 to 1 [CorrectFile]
            read-number: a.pwf, line 3: "top" is not a whole number [CorrectFile]
            read-syntax: a.pwf, line 2: found "hello", expected v x y z, l a b, p base foot, c a b or g a b layer [CorrectFile]
            read-syntax: a.pwf, line 1: found "v 0 0", expected v and three numbers [CorrectFile]
        "#]],
    );
    let node = r#"{"node_id": 0, "point": {"X": 0, "Y": 0, "Z": 0}}"#;
    let texts = [
        r#"{"node_list": ["#,
        r#"{"node_list": [], "element_list": [{"end_node_ids": [1, 2]}]}"#,
        r#"{"node_list": [], "element_list": [{"end_node_ids": [1]}]}"#,
        r#"{"unit": "cubit", "node_list": [], "element_list": []}"#,
        &format!(r#"{{"node_list": [{node}, {node}], "element_list": []}}"#),
        &format!(r#"{{"node_list": [{node}], "element_list": []}}"#),
    ];
    check(
        "a.json",
        &texts,
        &expect![[r#"
            read-syntax: a.json, line 1, node_list: found EOF while parsing a list, expected an object with node_list and element_list [CorrectFile]
            read-index: a.json, element 0: 1 names no node: there are 0 [CorrectFile]
            read-syntax: a.json, element 0: found "1 ends", expected two end_node_ids [CorrectFile]
            read-syntax: a.json: found "cubit", expected a unit: millimeter, centimeter, meter or inch [ChooseUnit]
            read-syntax: a.json, node 1: found "node_id 0 again", expected another node_id [CorrectFile]
            read-empty: a.json: no edges and no faces in it (1 unused vertex dropped) [CheckRightFile]
        "#]],
    );
}

#[test]
fn counts_have_a_limit() {
    let head = "ply\nformat binary_little_endian 1.0\nelement vertex 5000001\nproperty uchar x\nend_header\n";
    let mut bytes = head.as_bytes().to_vec();
    bytes.resize(bytes.len() + 5_000_001, 0);
    check(
        "a.ply",
        &[bytes],
        &expect![[r#"
            read-too-many: a.ply: more than 5000000 entries of an element [SimplifyModel]
        "#]],
    );
}

#[test]
fn formats_are_told_by_name_and_by_content() {
    let told = |name: &str, text: &str| detect(name, text.as_bytes()).ok();
    assert_eq!(told("a.OBJ", ""), Some(Format::Obj));
    assert_eq!(told("a.csv", "1,2,3\n4,5,6\n"), Some(Format::Xyz));
    assert_eq!(told("a.csv", "10,0,90\n20\n"), Some(Format::Lra));
    assert_eq!(told("a.csv", "x,y,z\n1,2,3\n"), Some(Format::Xyz));
    assert_eq!(told("a.csv", "L,R,A\n1,2,3\n"), Some(Format::Lra));
    assert_eq!(told("a.csv", "D_mm,Rabs_deg,A_deg\n1,2,3\n"), Some(Format::Lra));
    assert_eq!(told("a.csv", "C,F,E,G,Y\n1,2,3,4,5\n"), Some(Format::Lra));
    assert_eq!(told("a.txt", "F 10\n"), Some(Format::Kit));
    assert_eq!(told("a.txt", "Feed 10\n"), Some(Format::Pensa));
    assert_eq!(told("a.json", "{\"node_list\": []}"), Some(Format::Assembly));
    assert_eq!(told("a.json", "{\"elements\": [{\"end_node_inds\": [0, 1]}]}"), Some(Format::Conmech));
    assert_eq!(told("a.json", "{\"format\": \"wirebend\"}"), Some(Format::Wirebend));
    assert_eq!(told("-", "{\"format\": \"wirebend\"}"), Some(Format::Wirebend));
    assert_eq!(told("-", "v 1 2 3\nl 1 1\n"), Some(Format::Obj));
    assert_eq!(told("-", "v 1 2 3\nl 1 1\np 1 1\n"), Some(Format::Obj));
    assert_eq!(told("-", "v 1 2 3\np 1 1\n"), Some(Format::Pwf));
    assert_eq!(told("-", "ply\nformat ascii 1.0\n"), Some(Format::Ply));
    assert_eq!(told("a.GLB", ""), Some(Format::Gltf));
    assert_eq!(told("a.3mf", ""), Some(Format::ThreeMf));
    assert_eq!(told("-", "PK\u{3}\u{4}"), Some(Format::ThreeMf));
    assert_eq!(told("-", "glTF"), Some(Format::Gltf));
    assert_eq!(told("a.json", "{\"asset\": {}}"), Some(Format::Assembly));
    assert_eq!(told("-", "{\"asset\": {}}"), Some(Format::Gltf));
    assert_eq!(told("-", "999\nby hand\n  0\r\nSECTION\r\n"), Some(Format::Dxf));
    assert_eq!(told("a.txt", "<?xml version=\"1.0\"?>\n<svg/>"), Some(Format::Svg));
    assert_eq!(told("-", "<html/>"), None);
    assert_eq!(told("-", "solid x\nendsolid\n"), Some(Format::Stl));
    assert_eq!(import("notes.txt", "Dear diary").unwrap_err().code(), "read-unknown-format");
    let error = import("notes.doc", "Dear diary").unwrap_err();
    expect!["read-unknown-format: notes.doc: this is none of the known formats (obj, stl, ply, 3mf, gltf, dxf, svg, xyz, assembly, conmech, pwf, wirebend-kit, pensa, lra, moves, wirebend) [ChooseFileFormat]"].assert_eq(&format!("{}: {error} {:?}", error.code(), error.remedies()));
    assert_eq!(told("a.txt", "L,R,A\n1,2,3\n"), Some(Format::Lra));
    expect![[r#""step" is no format that can be read; they are obj, stl, ply, 3mf, gltf, dxf, svg, xyz, assembly, conmech, pwf, wirebend-kit, pensa, lra, moves, wirebend"#]].assert_eq(&"step".parse::<Format>().unwrap_err().to_string());
    assert_eq!("Pensa".parse(), Ok(Format::Pensa));
}

/// What became of a download that broke off, or of a file that was saved before anything was drawn.
#[test]
fn an_empty_file_is_called_empty_in_every_format() {
    for format in Format::ALL.into_iter().filter(|format| *format != Format::Wirebend) {
        for (extension, bytes) in format.extensions().iter().flat_map(|end| {
            [b"".as_slice(), b" \r\n\t\n", b"\xef\xbb\xbf", b"\xff\xfe \0\n\0"].map(|bytes| (*end, bytes))
        }) {
            let name = format!("a.{extension}");
            let options = ReadOptions::default();
            for error in [read(bytes, &name, None, &options), read(bytes, &name, Some(format), &options)] {
                let error = error.unwrap_err();
                let said = format!("{}: {error} {:?}", error.code(), error.remedies());
                assert_eq!(
                    said,
                    format!("read-empty: {name}: the file is empty [CheckRightFile]"),
                    "{format}"
                );
            }
        }
    }
    let error = import("a.wirebend", " \n").unwrap_err();
    assert_eq!(error.to_string(), "a.wirebend: the file is empty, expected a WireBend project");
}

#[test]
fn an_explicit_format_wins_and_options_are_checked() {
    let options = ReadOptions { weld: mm(1e-3), ..ReadOptions::default() };
    assert!(read(b"F 10\n", "program.obj", Some(Format::Kit), &options).is_ok());
    for scale in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let error =
            read(b"F 10\n", "a.txt", None, &ReadOptions { scale, ..ReadOptions::default() }).unwrap_err();
        assert_eq!(error.code(), "read-scale");
    }
    // A scale that leaves the finite numbers is an error, too, not a panic.
    let options = ReadOptions { scale: 1e308, ..ReadOptions::default() };
    assert!(read(b"v 0 0 0\nv 9 0 0\nv 9 9 0\nf 1 2 3\n", "a.obj", None, &options).is_err());
    assert!(read(b"F 100\n", "a.txt", None, &options).is_err());
}

#[test]
fn what_is_not_there_or_a_folder_or_too_large() {
    let folder = tempfile::tempdir().unwrap();
    let error = read_file(&folder.path().join("none.obj")).unwrap_err();
    assert_eq!(error.code(), "read-io");
    let error = read_file(folder.path()).unwrap_err();
    assert_eq!(error.code(), "read-io");
    assert_eq!(error.to_string(), format!("{} is a folder, not a file", folder.path().display()));
    assert_eq!(error.remedies(), [ErrorRemedy::ChooseOtherFile]);
    let path = folder.path().join("large.obj");
    std::fs::File::create(&path).unwrap().set_len((64 << 20) + 1).unwrap();
    assert_eq!(read_file(&path).unwrap_err().code(), "read-too-large");
    let path = folder.path().join("large.stl");
    std::fs::File::create(&path).unwrap().set_len((64 << 20) + 1).unwrap();
    assert_eq!(read_file(&path).unwrap().len(), (64 << 20) + 1);
}

/// A reader would say what is damaged of them.
#[test]
fn what_is_no_model_is_called_what_it_is() {
    for (bytes, found) in [
        (b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR".as_slice(), "a PNG picture"),
        (b"ID3\x04\0\0\0\0\x1f\x76", "an MP3 recording"),
        (b"%PDF-1.7\n", "a PDF document"),
    ] {
        for name in ["a.stl", "a.obj", "a.ply", "a.3mf", "a.glb", "a.dxf", "a.wirebend"] {
            let refused = read(bytes, name, None, &ReadOptions::default()).unwrap_err().to_string();
            assert!(refused.starts_with(&format!("{name}: found {found}, expected ")), "{refused}");
        }
    }
}
