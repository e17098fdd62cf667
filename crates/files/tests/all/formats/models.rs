//! 3MF and glTF models, packed by the tests.

use std::io::{Cursor, Write as _};

use base64::Engine as _;
use nalgebra::Point3;
use wirebend_files::read::{Imported, LengthUnit, ReadOptions, read};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipWriter};

use super::drawn::{chain, edges, rounded};
use super::{import, notes};

/// An archive of parts.
pub fn package(parts: &[(&str, &str)], packed: bool) -> Vec<u8> {
    let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
    let method = if packed { CompressionMethod::Deflated } else { CompressionMethod::Stored };
    for (name, text) in parts {
        archive.start_file(*name, SimpleFileOptions::default().compression_method(method)).unwrap();
        archive.write_all(text.as_bytes()).unwrap();
    }
    archive.finish().unwrap().into_inner()
}

pub const TRIANGLE: &str = "<mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"10\" y=\"0\" z=\"0\"/>\
    <vertex x=\"0\" y=\"5\" z=\"0\"/></vertices><triangles><triangle v1=\"0\" v2=\"1\" v3=\"2\"/></triangles></mesh>";

pub fn model(unit: &str, objects: &str, items: &str) -> String {
    format!(
        "<?xml version=\"1.0\"?>\n<model{unit}><resources>\n{objects}\n</resources><build>\n{items}\n</build></model>"
    )
}

pub fn of_model(model: &str) -> Vec<u8> {
    package(&[("3D/3dmodel.model", model)], true)
}

fn corners(imported: &Imported) -> Vec<[f64; 3]> {
    imported.stencil.as_ref().unwrap().vertices().iter().map(rounded).collect()
}

fn faces(imported: &Imported) -> Vec<Vec<u32>> {
    imported.stencil.as_ref().unwrap().faces().to_vec()
}

#[test]
fn a_3mf_model_is_a_stencil_in_its_unit() {
    let object = format!("<object id=\"1\">{TRIANGLE}</object>");
    for (unit, mm) in [
        ("", 1.0),
        (" unit=\"millimeter\"", 1.0),
        (" unit=\"micron\"", 1e-3),
        (" unit=\"inch\"", 25.4),
        (" unit=\"foot\"", 304.8),
    ] {
        let bytes = of_model(&model(unit, &object, "<item objectid=\"1\"/>"));
        let imported = import("a.3mf", &bytes).unwrap();
        assert_eq!(corners(&imported), [[0.0; 3], [10.0 * mm, 0.0, 0.0], [0.0, 5.0 * mm, 0.0]], "{unit}");
        assert_eq!(faces(&imported), [[0, 1, 2]]);
        assert_eq!(notes(&imported.notes), [""; 0]);
    }
    let bytes = package(&[("3d/3DModel.model", &model("", &object, "<item objectid=\"1\"/>"))], false);
    let options =
        ReadOptions { units: Some(LengthUnit::Centimetre), face_edges: true, ..ReadOptions::default() };
    let imported = read(&bytes, "standard input", None, &options).unwrap();
    assert_eq!(imported.wireframe.edge_count(), 3);
    assert_eq!(corners(&imported)[1].to_vec(), [100.0, 0.0, 0.0]);
    assert_eq!(notes(&imported.notes), ["the file names another unit; yours was used"]);
}

#[test]
fn objects_are_put_together_where_they_are_built() {
    let component = "<component objectid=\"1\" transform=\"0 1 0 -1 0 0 0 0 1 100 0 0\"/>";
    let objects = format!(
        "<object id=\"1\">{TRIANGLE}</object><object id=\"2\"><components>{component}\
         <component p:path=\"/3D/Objects/other.model\" objectid=\"9\"/></components></object>"
    );
    // A mirror image in z, then 7 up.
    let items = "<item objectid=\"2\" transform=\"1 0 0 0 1 0 0 0 -1 0 0 7\"/><item objectid=\"1\"/>";
    let other = TRIANGLE.replace("z=\"0\"", "z=\"3\"");
    let other = model("", &format!("<object id=\"9\">{other}</object>"), "");
    let relationships = "<Relationships><Relationship Target=\"/3D/main.model\" \
        Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>";
    let main = model("", &objects, items);
    let parts = [
        ("_rels/.rels", relationships),
        ("3D/main.model", main.as_str()),
        ("3D/Objects/other.model", &other),
    ];
    let imported = import("a.3mf", package(&parts, true)).unwrap();
    // (x, y) goes to (100 - y, x), then z to 7 - z.
    assert_eq!(
        corners(&imported),
        [
            [100.0, 0.0, 7.0],
            [100.0, 10.0, 7.0],
            [95.0, 0.0, 7.0],
            [0.0, 0.0, 4.0],
            [10.0, 0.0, 4.0],
            [0.0, 5.0, 4.0],
            [0.0, 0.0, 0.0],
            [10.0, 0.0, 0.0],
            [0.0, 5.0, 0.0]
        ]
    );
    assert_eq!(faces(&imported), [[0, 2, 1], [3, 5, 4], [6, 7, 8]], "a mirror image looks outwards again");
    assert_eq!(notes(&imported.notes), ["2 blocks or parts inserted where they are used"]);
}

#[test]
fn the_beams_of_a_lattice_are_a_wireframe() {
    let lattice = TRIANGLE.replace("<triangles><triangle v1=\"0\" v2=\"1\" v3=\"2\"/></triangles>", "").replace(
        "</mesh>",
        "<b:beamlattice radius=\"1\"><b:beams><b:beam v1=\"0\" v2=\"1\"/><b:beam v1=\"1\" v2=\"2\"/></b:beams></b:beamlattice></mesh>",
    );
    let metadata = "<metadata name=\"a\">b</metadata>";
    let objects = format!(
        "{metadata}<basematerials><base name=\"a\"/></basematerials><object id=\"1\">{lattice}</object><slicestack/>"
    );
    let bytes = of_model(&model("", &objects, "<item objectid=\"1\"/>"));
    let imported = import("a.3mf", &bytes).unwrap();
    assert!(imported.stencil.is_none());
    assert_eq!(edges(&imported), chain(&[[0.0; 3], [10.0, 0.0, 0.0], [0.0, 5.0, 0.0]]));
    expect_test::expect![[r#"
        1 comment ignored
        1 object, group or material name ignored
        1 colour or other attribute ignored
        1 unknown statement ignored"#]]
    .assert_eq(&notes(&imported.notes).join("\n"));
}

/// Three corners of a triangle, in metres with y up, then indices as shorts.
pub fn buffer() -> Vec<u8> {
    let numbers = [0.0_f32, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 2.0, 0.0, 0.0, 2.0, 0.5];
    let mut bytes: Vec<u8> = numbers.iter().flat_map(|number| number.to_le_bytes()).collect();
    bytes.extend([0_u16, 1, 2, 0, 2, 3].iter().flat_map(|index| index.to_le_bytes()));
    bytes
}

/// A scene of nodes and meshes over [`buffer`]: accessor 0 are four positions, 1 six indices.
pub fn scene(nodes: &str, meshes: &str, buffer: &str) -> String {
    format!(
        "{{\"asset\": {{\"version\": \"2.0\"}}, \"scenes\": [{{\"nodes\": [0]}}], \"nodes\": {nodes}, \"meshes\": {meshes},\n\
         \"accessors\": [{{\"bufferView\": 0, \"componentType\": 5126, \"count\": 4, \"type\": \"VEC3\"}},\n\
         {{\"bufferView\": 1, \"componentType\": 5123, \"count\": 6, \"type\": \"SCALAR\"}}],\n\
         \"bufferViews\": [{{\"buffer\": 0, \"byteLength\": 48}}, {{\"buffer\": 0, \"byteOffset\": 48, \"byteLength\": 12}}],\n\
         \"buffers\": [{buffer}]}}"
    )
}

/// JSON and bytes as a binary file.
pub fn glb(json: &str, binary: &[u8]) -> Vec<u8> {
    let mut json = json.as_bytes().to_vec();
    json.resize(json.len().next_multiple_of(4), b' ');
    let length = |count: usize| u32::try_from(count).unwrap().to_le_bytes();
    let mut bytes = [b"glTF".as_slice(), &length(2), &length(28 + json.len() + binary.len())].concat();
    for (kind, chunk) in [(b"JSON", json.as_slice()), (b"BIN\0", binary)] {
        bytes.extend([&length(chunk.len()), kind.as_slice(), chunk].concat());
    }
    bytes
}

pub const QUAD: &str = "[{\"primitives\": [{\"attributes\": {\"POSITION\": 0}, \"indices\": 1}]}]";

#[test]
fn a_gltf_model_is_in_metres_and_stands_up() {
    let json = scene("[{\"mesh\": 0}]", QUAD, "{\"byteLength\": 60}");
    let imported = import("a.glb", glb(&json, &buffer())).unwrap();
    // (x, y, z) in metres is (x, -z, y) in millimetres.
    let expected = [[0.0; 3], [1000.0, 0.0, 0.0], [1000.0, 0.0, 2000.0], [0.0, -500.0, 2000.0]];
    assert_eq!(corners(&imported), expected);
    assert_eq!(faces(&imported), [[0, 1, 2], [0, 2, 3]]);
    assert_eq!(notes(&imported.notes), ["y is up in the file: the model is turned about x so that z is up"]);
    let data = base64::prelude::BASE64_STANDARD.encode(buffer());
    let uri = format!("{{\"uri\": \"data:application/octet-stream;base64,{data}\", \"byteLength\": 60}}");
    let text = scene("[{\"mesh\": 0}]", QUAD, &uri);
    for name in ["a.gltf", "standard input"] {
        assert_eq!(corners(&import(name, &text).unwrap()), expected);
    }
}

/// A skin, two shapes to morph into, copies elsewhere, and the mesh of another scene: what is not read is counted.
#[test]
fn what_a_gltf_model_has_besides_is_counted() {
    let nodes = "[{\"mesh\": 0, \"skin\": 0, \"extensions\": {\"EXT_mesh_gpu_instancing\": {\"attributes\": {}}}}, {\"mesh\": 0}]";
    let morphs =
        QUAD.replace("\"indices\": 1", "\"indices\": 1, \"targets\": [{\"POSITION\": 0}, {\"POSITION\": 0}]");
    let imported = import("a.glb", glb(&scene(nodes, &morphs, "{}"), &buffer())).unwrap();
    assert_eq!(faces(&imported).len(), 2);
    assert!(notes(&imported.notes).contains(&"5 other elements ignored".to_owned()), "{:?}", imported.notes);
}

#[test]
fn nodes_move_turn_and_scale() {
    // Doubled in x, turned by 90° about y (x to -z, z to x), moved by 1 in z; then mirrored in x by a matrix.
    let nodes = "[{\"children\": [1], \"matrix\": [-1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]},\
        {\"mesh\": 0, \"scale\": [2, 1, 1], \"rotation\": [0, 0.7071067811865476, 0, 0.7071067811865476], \"translation\": [0, 0, 1]}]";
    let imported = import("a.glb", glb(&scene(nodes, QUAD, "{}"), &buffer())).unwrap();
    // (1, 0, 0) to (2, 0, 0), (0, 0, -2), (0, 0, -1), and turned upright (0, 1, 0). (0, 2, 0.5) to (0.5, 2, 0),
    // (0.5, 2, 1), (-0.5, 2, 1), and (-0.5, -1, 2).
    let expected = [[0.0, -1.0, 0.0], [0.0, 1.0, 0.0], [0.0, 1.0, 2.0], [-0.5, -1.0, 2.0]];
    for (corner, metres) in imported.stencil.as_ref().unwrap().vertices().iter().zip(expected) {
        assert!((corner - Point3::from(metres.map(|c| c * 1000.0))).norm() < 1e-6, "{corner}");
    }
    assert_eq!(faces(&imported), [[0, 2, 1], [0, 3, 2]], "a mirror image looks outwards again");
}

#[test]
fn strips_fans_lines_and_points() {
    let of = |mode: u8| {
        let mesh =
            format!("[{{\"primitives\": [{{\"attributes\": {{\"POSITION\": 0}}, \"mode\": {mode}}}]}}]");
        import("a.glb", glb(&scene("[{\"mesh\": 0}]", &mesh, "{}"), &buffer()))
    };
    let ends = |mode| {
        let wireframe = of(mode).unwrap().wireframe;
        wireframe.edges().map(|(_, edge)| [edge.a.0, edge.b.0]).collect::<Vec<_>>()
    };
    assert_eq!(ends(1), [[0, 1], [2, 3]]);
    assert_eq!(ends(2), [[0, 1], [1, 2], [2, 3], [3, 0]]);
    assert_eq!(ends(3), [[0, 1], [1, 2], [2, 3]]);
    assert_eq!(faces(&of(5).unwrap()), [[0, 1, 2], [1, 3, 2]]);
    assert_eq!(faces(&of(6).unwrap()), [[0, 1, 2], [0, 2, 3]]);
    assert_eq!(faces(&of(4).unwrap()), [[0, 1, 2]]);
    assert!(
        notes(&of(4).unwrap().notes).contains(&"1 unknown statement ignored".to_owned()),
        "a corner left over"
    );
    assert_eq!(of(0).unwrap_err().code(), "read-empty");
    assert_eq!(of(7).unwrap_err().code(), "read-syntax");
}

#[test]
fn short_numbers_and_changed_entries() {
    // Positions as normalized bytes: 127 is 1, -127 is -1; a stride of 4; entry 2 is changed to (0, 0, 1).
    let mut bytes = vec![0, 0, 0, 9, 127, 0, 0, 9, 0, 127, 129, 9];
    bytes.extend([2, 0, 0, 127]);
    let json = "{\"asset\": {\"version\": \"2.1\"}, \"extensionsRequired\": [\"KHR_mesh_quantization\"], \"nodes\": [{\"mesh\": 0}],\
        \"meshes\": [{\"primitives\": [{\"attributes\": {\"POSITION\": 0, \"NORMAL\": 0, \"COLOR_0\": 0}}]}],\
        \"accessors\": [{\"bufferView\": 0, \"componentType\": 5120, \"normalized\": true, \"count\": 3, \"type\": \"VEC3\",\
        \"sparse\": {\"count\": 1, \"indices\": {\"bufferView\": 1, \"componentType\": 5121},\
        \"values\": {\"bufferView\": 1, \"byteOffset\": 1}}}],\
        \"bufferViews\": [{\"buffer\": 0, \"byteLength\": 12, \"byteStride\": 4}, {\"buffer\": 0, \"byteOffset\": 12, \"byteLength\": 4}],\
        \"buffers\": [{}]}";
    let imported = import("a.glb", glb(json, &bytes)).unwrap();
    assert_eq!(corners(&imported), [[0.0; 3], [1000.0, 0.0, 0.0], [0.0, -1000.0, 0.0]]);
    expect_test::expect![[r#"
        y is up in the file: the model is turned about x so that z is up
        3 colours or other attributes ignored
        3 normals ignored"#]]
    .assert_eq(&notes(&imported.notes).join("\n"));
}
