//! What is not read is counted, also where nothing else is there, and does no harm.

use std::fmt::Write as _;

use expect_test::expect;

use super::drawn::{chain, edges};
use super::dxf::drawing;
use super::models::{buffer, glb, scene};
use super::svg::page;
use super::{import, notes};

/// A person who exported the wrong thing sees what it was.
#[test]
fn where_nothing_remains_what_was_ignored_is_told() {
    let solids = "0 3DSOLID 8 0 ".repeat(288) + "0 TEXT 10 0 20 0 1 x";
    let off = "0\nSECTION\n2\nTABLES\n0\nLAYER\n2\nwire\n62\n-7\n70\n0\n0\nENDSEC\n".to_owned()
        + &drawing(&"0 LINE 8 wire 10 0 20 0 11 9 21 0 ".repeat(3));
    let points = glb(
        &scene(
            "[{\"mesh\": 0}]",
            "[{\"primitives\": [{\"attributes\": {\"POSITION\": 0}, \"mode\": 0}]}]",
            "{}",
        ),
        &buffer(),
    );
    let model = "<model><resources><object id=\"1\"><mesh/></object></resources><build/></model>";
    let files: [(&str, Vec<u8>); 10] = [
        ("a.dxf", drawing(&solids).into()),
        ("a.dxf", off.into()),
        ("a.svg", page("<text>a</text><image/><g display=\"none\"><path d=\"M0 0 1 1\"/></g>").into()),
        ("a.obj", "# by hand\nv 0 0 0\nv 1 0 0\np 1 2\nvn 0 0 1\n".into()),
        ("a.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nend_header\n0 0 0\n".into()),
        ("a.glb", points),
        ("a.3mf", super::models::of_model(model)),
        ("a.xyz", "# nothing\n# more\n".into()),
        ("a.dsw", "PINZ 0 (up)\nROTATE 90\nBEND 90\n".into()),
        ("a.lra", "L,R,A,part\n0,0,90,7\n".into()),
    ];
    let mut list = String::new();
    for (name, bytes) in files {
        writeln!(list, "{}", import(name, bytes).unwrap_err()).unwrap();
    }
    expect![[r#"
        a.dxf: no edges and no faces in it (288 faces, surfaces or solids ignored, 1 text ignored)
        a.dxf: no edges and no faces in it (3 hidden elements left out)
        a.svg: no edges and no faces in it (1 text ignored, 1 picture ignored, 1 hidden element left out)
        a.obj: no edges and no faces in it (1 comment ignored, 1 loose point ignored, 1 normal ignored, 2 unused vertices dropped)
        a.ply: no edges and no faces in it (1 unused vertex dropped)
        a.glb: no edges and no faces in it (4 loose points ignored, 4 unused vertices dropped)
        a.3mf: no objects to build in it
        a.xyz: no points in it (2 comments ignored)
        a.dsw: no feed of more than 0 in it (1 comment ignored, 1 pin command ignored)
        a.lra: no feed of more than 0 in it (1 column ignored)
    "#]]
    .assert_eq(&list);
}

/// Programs write NaN where a normal or a colour cannot be computed, in the spelling of their language.
#[test]
fn no_number_in_what_is_ignored_refuses_a_file() {
    let hidden = |flags: &str| format!("0 LINE {flags} 10 nan 20 0 11 1 21 0 0 LINE 10 0 20 0 11 1 21 0");
    let off = "0\nSECTION\n2\nTABLES\n0\nLAYER\n2\noff\n62\n-7\n70\n0\n0\nENDSEC\n".to_owned()
        + &drawing(&hidden("8 off"));
    let ply = |word: &str| {
        format!(
            "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\n\
             property float nx\nproperty list uchar float weights\nelement edge 1\nproperty int vertex1\n\
             property int vertex2\nproperty double length\nend_header\n0 0 0 {word} 1 {word}\n1 0 0 0 0\n0 1 {word}\n"
        )
    };
    let stl = |word: &str| {
        format!(
            "solid a\nfacet normal {word} {word} {word}\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\n\
             endloop\nendfacet\nendsolid a\n"
        )
    };
    let mut files: Vec<(&str, String)> = vec![
        ("a.obj", "v 0 0 0 nan nan nan\nv 1 0 0 -nan(ind) x 0\nvn nan 0 0\nvt nan\nl 1/nan 2//nan\n".into()),
        ("a.dsw", "PINZ nan\nFEED 1\n".into()),
        ("a.csv", "x,y,z,mass\n0,0,0,nan\n1,0,0,-\n".into()),
        ("a.dxf", drawing("0 POINT 10 nan 20 0 0 3DSOLID 40 nan 0 LINE 39 nan 10 0 20 0 11 1 21 0")),
        ("a.dxf", drawing(&hidden("67 1"))),
        ("a.dxf", drawing(&hidden("60 1"))),
        ("a.dxf", off),
        (
            "a.svg",
            page(
                "<path style=\"display:none\" d=\"Mnan 0\"/><text x=\"nan\"/><path stroke-width=\"nan\" d=\"M0 0 1 0\"/>",
            ),
        ),
    ];
    for word in ["nan", "NaN", "-nan", "nan(0x8000)", "-nan(ind)", "1.#QNAN", "-1.#IND00", "1.#INF"] {
        files.push(("a.ply", ply(word)));
        files.push(("a.stl", stl(word)));
    }
    for (name, text) in files {
        let imported = import(name, &text).unwrap_or_else(|error| panic!("{error}\n{text}"));
        if name == "a.stl" {
            assert_eq!(imported.stencil.unwrap().faces().len(), 1);
        } else {
            assert_eq!(edges(&imported), chain(&[[0.0; 3], [1.0, 0.0, 0.0]]), "{text}");
        }
    }
}

/// But a vertex is no vertex without its place.
#[test]
fn no_number_in_what_is_read_is_refused_where_it_stands() {
    let ply = "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nend_header\n0 -nan(ind) 0\n";
    assert_eq!(
        import("a.ply", ply).unwrap_err().to_string(),
        "a.ply, line 8: found \"0 -nan(ind) 0\", expected a PLY header, then numbers as it says"
    );
    let stl = "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 nan 0\nvertex 1 1 0\nendloop\nendfacet\nendsolid\n";
    assert_eq!(import("a.stl", stl).unwrap_err().line(), Some(5));
    assert_eq!(import("a.obj", "v 0 0 nan 1 1 1\n").unwrap_err().line(), Some(1));
    // Hidden where it is drawn, shown where it is asked for.
    let text = drawing("0 LINE 8 other 10 nan 20 0 11 1 21 0 0 LINE 8 wire 10 0 20 0 11 1 21 0");
    assert_eq!(import("a.dxf", &text).unwrap_err().code(), "read-number");
    assert_eq!(
        edges(&super::drawn::with_layers("a.dxf", &text, &["wire"])),
        chain(&[[0.0; 3], [1.0, 0.0, 0.0]])
    );
    assert!(
        notes(&super::drawn::with_layers("a.dxf", &text, &["wire"]).notes)
            .contains(&"1 element on another layer left out".to_owned())
    );
}
