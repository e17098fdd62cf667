//! Faces of DXF drawings, which become a stencil.

use wirebend_files::read::{Imported, ReadOptions, read};

use super::drawn::{chain, edges, rounded, with_layers};
use super::dxf::{drawing, of, section};
use super::{import, notes};

fn corners(imported: &Imported) -> Vec<[f64; 3]> {
    imported.stencil.as_ref().unwrap().vertices().iter().map(rounded).collect()
}

fn faces(imported: &Imported) -> Vec<Vec<u32>> {
    imported.stencil.as_ref().unwrap().faces().to_vec()
}

/// Of each face its corners, in order.
fn placed(imported: &Imported) -> Vec<Vec<[f64; 3]>> {
    let corners = corners(imported);
    faces(imported).iter().map(|face| face.iter().map(|&k| corners[k as usize]).collect()).collect()
}

fn with_face_edges(text: &str) -> Imported {
    let options = ReadOptions { face_edges: true, ..ReadOptions::default() };
    read(text.as_bytes(), "a.dxf", None, &options).unwrap_or_else(|error| panic!("{error}"))
}

fn face(corners: [[f64; 3]; 4], more: &str) -> String {
    let corner =
        |(k, [x, y, z]): (usize, &[f64; 3])| format!("{} {x} {} {y} {} {z} ", 10 + k, 20 + k, 30 + k);
    format!("0 3DFACE 8 0 {}{more} ", corners.iter().enumerate().map(corner).collect::<String>())
}

/// Many programs export a mesh as nothing but 3DFACE.
#[test]
fn faces_are_a_stencil_with_their_corners_in_common() {
    let [a, b, c, d, e] = [[0., 0., 0.], [10., 0., 0.], [10., 5., 2.], [0., 5., 2.], [5., 9., 3.]];
    // A triangle repeats its last corner; a face of two corners has no area.
    let text = face([a, b, c, d], "") + &face([d, c, e, e], "") + &face([a, b, b, a], "");
    let imported = of(&text);
    assert_eq!(imported.wireframe.edge_count(), 0);
    assert_eq!(corners(&imported), [a, b, c, d, e]);
    assert_eq!(faces(&imported), [vec![0, 1, 2, 3], vec![3, 2, 4]]);
    assert_eq!(notes(&imported.notes), ["1 face without area dropped"]);
    // Four sides and two more: the side between them is one.
    assert_eq!(with_face_edges(&drawing(&text)).wireframe.edge_count(), 6);
}

#[test]
fn a_side_that_no_face_shows_is_no_edge() {
    let [a, b, c, d] = [[0., 0., 0.], [10., 0., 0.], [10., 5., 0.], [0., 5., 0.]];
    // Bits 1, 2, 4, 8 of group 70 hide the sides from corner 1, 2, 3, 4 on. The diagonal c-a is hidden in both faces;
    // a-b in one of two.
    let text = face([a, b, c, c], "70 8") + &face([a, c, d, d], "70 1") + &face([b, a, d, d], "70 1");
    let imported = with_face_edges(&drawing(&text));
    let drawn = edges(&imported);
    assert!(!drawn.contains(&[a, c]), "{drawn:?}");
    assert_eq!(drawn, [[a, b], [a, d], [b, c], [b, d], [c, d]]);
    assert!(notes(&imported.notes).contains(&"1 hidden element left out".to_owned()), "{:?}", imported.notes);
}

/// A tetrahedron as a polyface mesh: positions, then faces with indices from 1; a negative one hides
/// the side that it begins.
const TETRAHEDRON: &str = "0 POLYLINE 8 0 66 1 10 0 20 0 30 0 70 64 71 4 72 4 \
    0 VERTEX 8 0 10 0 20 0 30 0 70 192 0 VERTEX 8 0 10 9 20 0 30 0 70 192 \
    0 VERTEX 8 0 10 0 20 9 30 0 70 192 0 VERTEX 8 0 10 0 20 0 30 9 70 192 \
    0 VERTEX 8 0 10 0 20 0 30 0 70 128 71 1 72 3 73 2 \
    0 VERTEX 8 0 10 0 20 0 30 0 70 128 71 1 72 2 73 4 74 0 \
    0 VERTEX 8 0 10 0 20 0 30 0 70 128 71 -2 72 3 73 4 \
    0 VERTEX 8 0 10 0 20 0 30 0 70 128 71 3 72 1 73 4 0 SEQEND ";

#[test]
fn a_polyface_mesh_is_a_stencil() {
    let imported = of(TETRAHEDRON);
    let [a, b, c, d] = [[0.; 3], [9., 0., 0.], [0., 9., 0.], [0., 0., 9.]];
    assert_eq!(placed(&imported), [[a, c, b], [a, b, d], [b, c, d], [c, a, d]]);
    assert_eq!(corners(&imported).len(), 4);
    assert_eq!(notes(&imported.notes), [""; 0]);
    // The hidden side of 2 and 3 is shown by the first face.
    assert_eq!(with_face_edges(&drawing(TETRAHEDRON)).wireframe.edge_count(), 6);
    for (from, to, code) in
        [("71 -2 72 3", "71 -2 72 9", "read-index"), ("71 -2 72 3", "71 -2 72 x", "read-number")]
    {
        assert_eq!(import("a.dxf", drawing(&TETRAHEDRON.replace(from, to))).unwrap_err().code(), code);
    }
}

#[test]
fn a_polygon_mesh_is_a_grid_of_faces() {
    let vertices: String =
        (0..6).map(|k| format!("0 VERTEX 8 0 10 {} 20 {} 30 {k} 70 64 ", k / 3, k % 3)).collect();
    // Two rows of three; 32 closes the rows, 1 the columns.
    for (flags, count) in [(16, 2), (16 | 32, 3), (16 | 1, 4), (16 | 1 | 32, 6)] {
        let text = format!("0 POLYLINE 8 0 66 1 10 0 20 0 30 0 70 {flags} 71 2 72 3 {vertices} 0 SEQEND ");
        let imported = of(&text);
        assert_eq!(faces(&imported).len(), count, "{flags}");
        assert_eq!(placed(&imported)[0], [[0., 0., 0.], [0., 1., 1.], [1., 1., 4.], [1., 0., 3.]]);
        assert_eq!(corners(&imported).len(), 6);
    }
    let short = "0 POLYLINE 8 0 70 16 71 4 72 3 0 VERTEX 8 0 10 0 20 0 70 64 0 SEQEND";
    assert_eq!(import("a.dxf", drawing(short)).unwrap_err().code(), "read-truncated");
    let huge = "0 POLYLINE 8 0 70 16 71 32767 72 32767 0 VERTEX 8 0 10 0 20 0 70 64 0 SEQEND";
    assert_eq!(import("a.dxf", drawing(huge)).unwrap_err().code(), "read-truncated");
}

#[test]
fn faces_are_put_in_with_their_block_and_left_out_with_their_layer() {
    let triangle = "0 3DFACE 8 skin 10 0 20 0 30 0 11 4 21 0 31 0 12 0 22 3 32 1 13 0 23 3 33 1";
    let blocks = section("BLOCKS", &format!("0 BLOCK 2 part 10 0 20 0 70 0 {triangle} 0 ENDBLK"));
    let line = "0 LINE 8 wire 10 0 20 0 11 1 21 0";
    let text = blocks + &drawing(&format!("0 INSERT 2 part 10 10 20 0 30 0 41 -1 {line}"));
    let imported = import("a.dxf", &text).unwrap();
    // Mirrored in x, so that the corners go round the other way and look outwards again.
    assert_eq!(placed(&imported), [[[10., 0., 0.], [10., 3., 1.], [6., 0., 0.]]]);
    assert_eq!(edges(&imported), chain(&[[0.; 3], [1., 0., 0.]]));
    assert_eq!(
        notes(&imported.notes),
        ["1 block or part inserted where it is used", "1 face kept as stencil, not as edges"]
    );
    assert!(with_layers("a.dxf", &text, &["wire"]).stencil.is_none());
}
