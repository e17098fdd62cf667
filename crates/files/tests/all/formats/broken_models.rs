//! Broken and hostile 3MF and glTF models, likewise.

use std::fmt::Write as _;
use std::io::{Cursor, Write as _};

use expect_test::expect;
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipWriter};

use super::broken_drawings::check;
use super::import;
use super::models::{QUAD, TRIANGLE, buffer, glb, model, of_model, package, scene};

#[test]
fn threemf() {
    let object = format!("<object id=\"1\">{TRIANGLE}</object>");
    let build = "<item objectid=\"1\"/>";
    let around = "<object id=\"1\"><components><component objectid=\"2\"/></components></object>\
        <object id=\"2\"><components><component objectid=\"1\"/></components></object>";
    let deep: String = (1..80)
        .map(|k| {
            format!(
                "<object id=\"{k}\"><components><component objectid=\"{}\"/></components></object>\n",
                k + 1
            )
        })
        .collect();
    let models = [
        model("", "", ""),
        model("", &object, ""),
        model("", &object, "<item objectid=\"4\"/>"),
        model(" unit=\"parsec\"", &object, build),
        model("", &object.replace("v3=\"2\"", "v3=\"3\""), build),
        model("", &object.replace("x=\"10\"", "x=\"ten\""), build),
        model("", &object.replace("x=\"10\"", "x=\"1e400\""), build),
        model("", &object.replace("x=\"10\" ", ""), build),
        model("", &object.replace("x=\"10\" ", "x=10 "), build),
        model("", &object, "<item objectid=\"1\" transform=\"1 0 0\"/>"),
        model("", &object, "<item objectid=\"1\" path=\"/3D/gone.model\"/>"),
        model("", around, build),
        model("", &deep, build),
        "<model><resources>".to_owned(),
        "<model></resources>".to_owned(),
        String::new(),
    ];
    check(
        "a.3mf",
        &models.map(|model| of_model(&model)),
        &expect![[r#"
            read-empty: a.3mf: no objects to build in it [CheckRightFile]
            read-empty: a.3mf: no objects to build in it [CheckRightFile]
            read-index: a.3mf (3D/3dmodel.model), line 5: "4" names no object: the part has 1 [CorrectFile]
            read-syntax: a.3mf (3D/3dmodel.model), line 2: found "parsec", expected a unit: micron, millimeter, centimeter, meter, inch or foot [ExportAgain]
            read-index: a.3mf (3D/3dmodel.model), line 3: 3 names no vertex: they count from 0 and there are 3 [CorrectFile]
            read-number: a.3mf (3D/3dmodel.model), line 3: "ten" is not a finite number [CorrectFile]
            read-number: a.3mf (3D/3dmodel.model), line 3: "1e400" is not a finite number [CorrectFile]
            read-syntax: a.3mf (3D/3dmodel.model), line 3: found "vertex without x", expected an attribute x [ExportAgain]
            read-syntax: a.3mf (3D/3dmodel.model), line 3: found position 9: attribute value must be enclosed in `"` or `'`, expected an attribute and its value [ExportAgain]
            read-syntax: a.3mf (3D/3dmodel.model), line 5: found "1 0 0", expected a transform of twelve numbers [ExportAgain]
            read-syntax: a.3mf: found "no part 3D/gone.model", expected a package with a model [CheckRightFile]
            read-loop: a.3mf (3D/3dmodel.model), line 3: object 1 holds itself [ExportResolved]
            read-too-deep: a.3mf (3D/3dmodel.model), line 66: objects in objects are more than 64 deep [ExportResolved]
            read-truncated: a.3mf (3D/3dmodel.model), line 1: 2 elements begin, but they have no end: the file is cut off or damaged [ExportAgain]
            read-syntax: a.3mf (3D/3dmodel.model), line 1: found ill-formed document: expected `</model>`, but `</resources>` was found, expected a 3MF model [ExportAgain]
            read-empty: a.3mf: no objects to build in it [CheckRightFile]
        "#]],
    );
    let whole = of_model(&model("", &object, build));
    let files = [b"PK".to_vec(), whole[..whole.len() / 2].to_vec(), package(&[("a.txt", "a")], false)];
    check(
        "a.3mf",
        &files,
        &expect![[r#"
            read-syntax: a.3mf: found invalid Zip archive: Could not find EOCD, expected a 3MF package, which is a zip archive [ExportAgain]
            read-syntax: a.3mf: found invalid Zip archive: Could not find EOCD, expected a 3MF package, which is a zip archive [ExportAgain]
            read-syntax: a.3mf: found "no part 3D/3dmodel.model", expected a package with a model [CheckRightFile]
        "#]],
    );
}

/// A model of as many MiB of blanks, packed.
fn blanks(mib: usize) -> Vec<u8> {
    let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
    let options = SimpleFileOptions::default().compression_method(CompressionMethod::Deflated);
    archive.start_file("3D/3dmodel.model", options).unwrap();
    let chunk = vec![b' '; 1 << 20];
    (0..mib).for_each(|_| archive.write_all(&chunk).unwrap());
    archive.finish().unwrap().into_inner()
}

#[test]
fn a_package_is_not_unpacked_without_end() {
    // 600 MB of blanks are 600 kB once packed.
    let bytes = blanks(600);
    assert!(bytes.len() < 1 << 20);
    check(
        "a.3mf",
        &[bytes],
        &expect![[r#"
            read-too-large: a.3mf has 536870913 bytes, the limit is 536870912 [SimplifyModel]
        "#]],
    );
    let mut objects = format!("<object id=\"0\">{TRIANGLE}</object>");
    for k in 1..=30 {
        let ten = format!("<component objectid=\"{}\"/>", k - 1).repeat(10);
        write!(objects, "<object id=\"{k}\"><components>{ten}</components></object>").unwrap();
    }
    let grown = import("a.3mf", of_model(&model("", &objects, "<item objectid=\"30\"/>"))).unwrap_err();
    assert_eq!(grown.code(), "read-too-many", "{grown}");
}

#[test]
fn gltf() {
    let mesh = "[{\"mesh\": 0}]";
    let whole = scene(mesh, QUAD, "{}");
    let change = |from: &str, to: &str| {
        assert!(whole.contains(from));
        glb(&whole.replace(from, to), &buffer())
    };
    let deep: Vec<String> = (1..300).map(|k| format!("{{\"children\": [{k}]}}")).collect();
    let bad_index = [&buffer()[..58], &[9, 0]].concat();
    let not_finite = [&f32::NAN.to_le_bytes(), &buffer()[4..]].concat();
    let files = [
        change("\"2.0\"", "\"1.0\""),
        change("\"count\": 4", "\"count\": 5"),
        change("\"count\": 4", "\"count\": 4000000000"),
        change("\"count\": 4", "\"count\": 18446744073709551615"),
        change("\"count\": 4", "\"count\": -1"),
        change("\"byteLength\": 48", "\"byteLength\": 99999"),
        change("\"byteOffset\": 48", "\"byteOffset\": 18446744073709551615"),
        change("\"buffer\": 0, \"byteLength\"", "\"buffer\": 7, \"byteLength\""),
        change("\"bufferView\": 0", "\"bufferView\": 2"),
        change("5126", "5130"),
        change("5123", "5126"),
        change("VEC3", "VEC4"),
        change("\"indices\": 1", "\"indices\": 2"),
        change("{\"mesh\": 0}", "{\"mesh\": 1}"),
        change("[{\"mesh\": 0}]", "[{\"children\": [0]}]"),
        change("[{\"mesh\": 0}]", "[]"),
        change("\"asset\"", "\"extensionsRequired\": [\"KHR_draco_mesh_compression\"], \"asset\""),
        change("[{}]", "[{\"uri\": \"bunny.bin\"}]"),
        change("[{}]", "[{\"uri\": \"data:application/octet-stream;base64,###\"}]"),
        glb(&scene(&format!("[{}, {{\"mesh\": 0}}]", deep.join(", ")), QUAD, "{}"), &buffer()),
        glb(&whole, &bad_index),
        glb(&whole, &not_finite),
        glb(&whole, &buffer())[..40].to_vec(),
        glb(&whole, &buffer())[..16].to_vec(),
        whole.clone().into_bytes(),
        b"{\"asset\": 3}".to_vec(),
        b"{".to_vec(),
    ];
    check(
        "a.glb",
        &files,
        &expect![[r#"
            read-syntax: a.glb: found "1.0", expected asset version 2.0 [ExportAs { form: "glTF 2.0" }]
            read-truncated: a.glb, accessor 0: 5 entries need 60 bytes, but there are 48: the file is cut off or damaged [ExportAgain]
            read-too-many: a.glb, mesh 0: more than 5000000 vertices [SimplifyModel]
            read-too-many: a.glb, mesh 0: more than 5000000 vertices [SimplifyModel]
            read-syntax: a.glb, line 2: found invalid value: integer `-1`, expected usize at line 2 column 66, expected a glTF object as JSON [ExportAgain]
            read-truncated: a.glb, accessor 0: 4 entries need 48 bytes, but there are 0: the file is cut off or damaged [ExportAgain]
            read-truncated: a.glb, accessor 1: 6 entries need 12 bytes, but there are 0: the file is cut off or damaged [ExportAgain]
            read-index: a.glb: 7 names no buffer: they count from 0 and there are 1 [CorrectFile]
            read-index: a.glb: 2 names no buffer view: they count from 0 and there are 2 [CorrectFile]
            read-syntax: a.glb, accessor 0: found "5130", expected a component type from 5120 to 5126 [ExportAgain]
            read-syntax: a.glb, accessor 1: found "5126", expected indices of type 5121, 5123 or 5125 [ExportAgain]
            read-syntax: a.glb, accessor 0: found "VEC4", expected type VEC3 [ExportAgain]
            read-index: a.glb: 2 names no accessor: they count from 0 and there are 2 [CorrectFile]
            read-index: a.glb: 1 names no mesh: they count from 0 and there are 1 [CorrectFile]
            read-loop: a.glb, node 0: node 0 holds itself [ExportResolved]
            read-index: a.glb: 0 names no node: they count from 0 and there are 0 [CorrectFile]
            read-unsupported: a.glb: a model that requires "KHR_draco_mesh_compression" is not read [ExportWithout { part: "compression and extensions" }]
            read-elsewhere: a.glb: the geometry is in other files that cannot be read: "bunny.bin" (its folder is not known) [OpenFromFolder, ExportAs { form: ".glb" }]
            read-syntax: a.glb, buffer 0: found "application/octet-stream;base64,###", expected a data address with base64 [ExportAgain]
            read-too-deep: a.glb, node 256: nodes in nodes are more than 256 deep [ExportResolved]
            read-index: a.glb, accessor 1: 9 names no vertex: they count from 0 and there are 4 [CorrectFile]
            read-number: a.glb, vertex 0: [NaN, 0.0, 0.0] is not a finite position [CorrectFile]
            read-truncated: a.glb, byte 12: a chunk of 436 bytes, but there are 20: the file is cut off or damaged [ExportAgain]
            read-truncated: a.glb, byte 12: a chunk has 8 bytes and what they announce, but there are 4: the file is cut off or damaged [ExportAgain]
            read-syntax: a.glb, buffer 0: found "no bytes", expected bytes in the file [ExportAs { form: ".glb" }]
            read-syntax: a.glb, line 1: found invalid type: integer `3`, expected struct Asset at line 1 column 11, expected a glTF object as JSON [ExportAgain]
            read-syntax: a.glb, line 1: found EOF while parsing an object at line 1 column 1, expected a glTF object as JSON [ExportAgain]
        "#]],
    );
    assert!(import("a.gltf", "[".repeat(100_000)).is_err());
}

/// Likewise: components that are put in, and primitives that draw nothing.
#[test]
fn small_models_do_not_ask_for_much_work() {
    let components = "<component objectid=\"1\"/>".repeat(300_000);
    let object = format!("<object id=\"2\"><components>{components}</components></object>");
    let error = import("a.3mf", of_model(&model("", &object, "<item objectid=\"2\"/>")))
        .map(|i| i.notes)
        .unwrap_err();
    assert!(error.to_string().contains("components and items"), "{error}");

    let primitives = vec!["{\"attributes\":{}}"; 1000].join(",");
    let children = vec!["1"; 1000].join(",");
    let text = format!(
        "{{\"asset\":{{\"version\":\"2.0\"}},\"scenes\":[{{\"nodes\":[0]}}],\
         \"nodes\":[{{\"children\":[{children}]}},{{\"mesh\":0}}],\"meshes\":[{{\"primitives\":[{primitives}]}}]}}"
    );
    let error = import("a.gltf", &text).map(|imported| imported.notes).unwrap_err();
    assert!(error.to_string().contains("nodes and primitives"), "{error}");
}
