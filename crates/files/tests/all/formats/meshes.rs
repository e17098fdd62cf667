//! Models as programs write them: what becomes of each line, and that nothing is dropped unsaid.

use nalgebra::Point3;
use wirebend_core::wireframe::VertexId;
use wirebend_files::read::{Imported, ReadOptions, read};

use super::{import, notes};

fn with_face_edges(name: &str, bytes: impl AsRef<[u8]>) -> Imported {
    let options = ReadOptions { face_edges: true, ..ReadOptions::default() };
    read(bytes.as_ref(), name, None, &options).unwrap()
}

fn ends(imported: &Imported) -> Vec<(u32, u32)> {
    imported.wireframe.edges().map(|(_, edge)| (edge.a.0, edge.b.0)).collect()
}

/// Lines, a quad whose corners are used in another order than they are written, and one of all else.
const OBJ: &str = "# model\nmtllib a.mtl\no part\nv 9 9 9\nv 0 0 0\nv 10 0 0 1 0 0\nv 20 20 0 2\nv 0 10 0\nvt 0 0\nvn 0 0 1\n\
    f 4/1/1 5//1 2 \\\n -3\nl 2 3 4\nl 3 2\nl 2 2\np 1\ncurv 1 2\n";

#[test]
fn an_obj_keeps_its_order_and_tells_all() {
    let imported = import("a.obj", OBJ).unwrap();
    assert_eq!(
        imported.stencil.as_ref().unwrap().faces(),
        [[3, 4, 1, 2]],
        "by place in the file, not by first use"
    );
    assert_eq!(ends(&imported), [(1, 2), (2, 3)]);
    assert_eq!(imported.wireframe.vertex(VertexId(3)).unwrap().position, Point3::new(10.0, 10.0, 0.0));
    expect_test::expect![[r#"
        1 comment ignored
        2 object, group or material names ignored
        1 colour or other attribute ignored
        1 texture coordinate ignored
        1 normal ignored
        1 loose point ignored
        1 unknown statement ignored
        units not given: taken as mm
        1 unused vertex dropped (line 4)
        1 face kept as stencil, not as edges
        1 duplicate edge merged
        1 edge without length dropped"#]]
    .assert_eq(&notes(&imported.notes).join("\n"));
}

#[test]
fn a_quad_becomes_four_edges_and_meets_the_lines() {
    let imported = with_face_edges("a.obj", OBJ);
    let mut edges: Vec<_> = ends(&imported).into_iter().map(|(a, b)| (a.min(b), a.max(b))).collect();
    edges.sort_unstable();
    assert_eq!(edges, [(1, 2), (1, 4), (2, 3), (3, 4)]);
}

#[test]
fn loose_triangles_are_welded_into_one_net() {
    let corner = |x: f64, y: f64| format!("vertex {x} {y} 0\n");
    let facet = |corners: [(f64, f64); 3]| {
        format!(
            "facet normal 0 0 1\nouter loop\n{}endloop\nendfacet\n",
            corners.map(|(x, y)| corner(x, y)).concat()
        )
    };
    let first = facet([(0., 0.), (10., 0.), (10., 10.)]);
    let second = facet([(0., 0.), (10.000_4, 10.), (0., 10.)]);
    // Two solids, the second in capitals and without a name, as some programs write them.
    let text =
        format!("solid a b\n{first}endsolid a b\n\n{}", format!("solid\n{second}endsolid").to_uppercase());
    let imported = with_face_edges("a.stl", &text);
    assert_eq!(imported.stencil.as_ref().unwrap().vertices().len(), 5, "a stencil is left as it is");
    assert_eq!((imported.wireframe.vertex_count(), imported.wireframe.edge_count()), (4, 5));
    expect_test::expect![[r#"
        2 normals ignored
        units not given: taken as mm
        1 vertex merged into another
        1 duplicate edge merged"#]]
    .assert_eq(&notes(&imported.notes).join("\n"));
    let error = import("a.stl", format!("{text}\nrest\n")).unwrap_err();
    assert_eq!((error.code().as_str(), error.line()), ("read-syntax", Some(20)), "{error}");
}

#[test]
fn a_binary_stl_may_call_itself_solid() {
    let mut bytes = b"solid but binary".to_vec();
    bytes.resize(80, b' ');
    bytes.extend(1_u32.to_le_bytes());
    for value in [0., 0., 1., 0., 0., 0., 10., 0., 0., 10., 10., -0.] {
        bytes.extend(f32::to_le_bytes(value));
    }
    bytes.extend([0, 0]);
    let imported = with_face_edges("a.stl", &bytes);
    assert_eq!((imported.wireframe.vertex_count(), imported.wireframe.edge_count()), (3, 3));
    // Behind a head that is no text, more bytes than announced are counted, not read.
    bytes[..5].fill(0);
    bytes.extend([1, 2, 3]);
    let imported = with_face_edges("a.stl", &bytes);
    assert!(notes(&imported.notes).contains(&"3 bytes behind the end ignored".to_owned()));
}

#[test]
fn a_ply_with_edges_is_a_wireframe() {
    let head = "ply\nformat ascii 1.0\ncomment x\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n\
        property uchar red\nelement edge 2\nproperty int vertex1\nproperty int vertex2\nelement user 1\nproperty int a\nend_header\n";
    let imported =
        import("a.ply", format!("{head}0 0 0 255\n1.5 0 0 0\n0 2 0 9\n0 1\n1 2\n7\n\nmore\n")).unwrap();
    assert_eq!(ends(&imported), [(0, 1), (1, 2)]);
    expect_test::expect![[r#"
        1 comment ignored
        4 colours or other attributes ignored
        1 unknown statement ignored
        4 bytes behind the end ignored
        units not given: taken as mm"#]]
    .assert_eq(&notes(&imported.notes).join("\n"));
}

#[test]
fn a_comment_that_ends_in_a_backslash_swallows_no_line() {
    let text = b"# saved by C:\\models\\\nv 0 0 0\nv 100 0 0\nv 0 9 0\nl 1 \\\n2\nl 2 3\n";
    let found =
        wirebend_files::read::read(text, "bs.obj", None, &wirebend_files::read::ReadOptions::default())
            .unwrap();
    assert_eq!((found.wireframe.vertex_count(), found.wireframe.edge_count()), (3, 2));
    let (_, last) = found.wireframe.vertices().nth(1).unwrap();
    assert!((last.position.x - 100.0).abs() < 1e-12);
}
