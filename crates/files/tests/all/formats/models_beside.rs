//! glTF models whose geometry is in files of their own.

use std::fmt::Write as _;
use std::path::Path;

use expect_test::expect;
use proptest::prelude::*;
use wirebend_files::read::{Imported, ReadError, ReadOptions, read};

use super::drawn::rounded;
use super::models::{QUAD, buffer, scene};
use super::notes;

fn from_folder(text: &str, folder: Option<&Path>) -> Result<Imported, ReadError> {
    let options = ReadOptions { folder: folder.map(Path::to_owned), ..ReadOptions::default() };
    read(text.as_bytes(), "a.gltf", None, &options)
}

/// The quad of the tests of models, with its buffer elsewhere.
fn quad(uri: &str) -> String {
    scene("[{\"mesh\": 0}]", QUAD, &format!("{{\"uri\": \"{uri}\", \"byteLength\": 60}}"))
}

/// Programs write "model.gltf" and "model.bin" unless a person asks for one file.
#[test]
fn a_buffer_beside_the_file_is_read_and_pictures_are_counted() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::create_dir(folder.path().join("parts")).unwrap();
    for (uri, name) in
        [("a.bin", "a.bin"), ("my%20mesh.bin", "my mesh.bin"), ("./parts/b.bin", "parts/b.bin")]
    {
        std::fs::write(folder.path().join(name), buffer()).unwrap();
        // A picture is not read, so that it need not be there.
        let text = quad(uri)
            .replace("\"asset\"", "\"images\": [{\"uri\": \"gone.png\"}, {\"bufferView\": 9}], \"asset\"");
        let imported = from_folder(&text, Some(folder.path())).unwrap();
        let corners: Vec<_> = imported.stencil.as_ref().unwrap().vertices().iter().map(rounded).collect();
        // (x, y, z) in metres is (x, -z, y) in millimetres.
        assert_eq!(corners, [[0.0; 3], [1000.0, 0.0, 0.0], [1000.0, 0.0, 2000.0], [0.0, -500.0, 2000.0]]);
        assert!(notes(&imported.notes).contains(&"2 pictures ignored".to_owned()));
    }
}

#[test]
fn what_is_missing_or_elsewhere_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let inner = folder.path().join("inner");
    std::fs::create_dir_all(inner.join("folder.bin")).unwrap();
    // They are there, and are not the model's to read.
    std::fs::write(folder.path().join("secret.bin"), buffer()).unwrap();
    std::fs::write(inner.join("there.bin"), buffer()).unwrap();
    let absolute = folder.path().join("secret.bin").display().to_string();
    let mut list = String::new();
    for uri in ["gone.bin", "../secret.bin", "%2e%2e/secret.bin", &absolute, "http://a/b.bin", "folder.bin"] {
        let error = from_folder(&quad(uri), Some(&inner)).unwrap_err();
        let said = error.to_string().replace(&absolute, "/secret.bin");
        writeln!(list, "{}: {said} {:?}", error.code(), error.remedies()).unwrap();
    }
    let two = quad("gone.bin\"}, {\"uri\": \"there.bin\"}, {\"uri\": \"lost.bin");
    for error in [from_folder(&two, Some(&inner)), from_folder(&quad("there.bin"), None)] {
        let error = error.unwrap_err();
        writeln!(list, "{error} {:?}", error.remedies()).unwrap();
    }
    expect![[r#"
        read-elsewhere: a.gltf: the geometry is in other files that cannot be read: "gone.bin" (there is no such file beside it) [PutFilesBeside, ExportAs { form: ".glb" }]
        read-elsewhere: a.gltf: the geometry is in other files that cannot be read: "../secret.bin" (only files beside it are read) [PutFilesBeside, ExportAs { form: ".glb" }]
        read-elsewhere: a.gltf: the geometry is in other files that cannot be read: "%2e%2e/secret.bin" (only files beside it are read) [PutFilesBeside, ExportAs { form: ".glb" }]
        read-elsewhere: a.gltf: the geometry is in other files that cannot be read: "/secret.bin" (only files beside it are read) [PutFilesBeside, ExportAs { form: ".glb" }]
        read-elsewhere: a.gltf: the geometry is in other files that cannot be read: "http://a/b.bin" (only files beside it are read) [PutFilesBeside, ExportAs { form: ".glb" }]
        read-elsewhere: a.gltf: the geometry is in other files that cannot be read: "folder.bin" (this is no file) [PutFilesBeside, ExportAs { form: ".glb" }]
        a.gltf: the geometry is in other files that cannot be read: "gone.bin" (there is no such file beside it), "lost.bin" (there is no such file beside it) [PutFilesBeside, ExportAs { form: ".glb" }]
        a.gltf: the geometry is in other files that cannot be read: "there.bin" (its folder is not known) [OpenFromFolder, ExportAs { form: ".glb" }]
    "#]]
    .assert_eq(&list);
}

/// A buffer that is shorter than the model says, or no buffer at all.
#[test]
fn a_buffer_beside_the_file_is_not_believed() {
    let folder = tempfile::tempdir().unwrap();
    for bytes in [&buffer()[..59], b"", b"<html>not found</html>"] {
        std::fs::write(folder.path().join("a.bin"), bytes).unwrap();
        assert_eq!(from_folder(&quad("a.bin"), Some(folder.path())).unwrap_err().code(), "read-truncated");
    }
    let file = std::fs::File::create(folder.path().join("a.bin")).unwrap();
    // No byte of it is on the disk.
    file.set_len(600 << 20).unwrap();
    assert_eq!(from_folder(&quad("a.bin"), Some(folder.path())).unwrap_err().code(), "read-too-large");
}

proptest! {
    /// Whatever a model calls its buffer, and whatever is in it, is a model or an error; and nothing but files in the
    /// folder is read.
    #[test]
    fn any_buffer_beside_the_file(bytes in prop::collection::vec(any::<u8>(), 0..100), uri in "[a-c./%\\\\:2eE0 -]{0,12}") {
        let folder = tempfile::tempdir().unwrap();
        let inner = folder.path().join("a");
        std::fs::create_dir_all(&inner).unwrap();
        // A name that leads here has led out of the folder of the model.
        for name in ["a.b", "b", "c"] {
            std::fs::write(folder.path().join(name), buffer()).unwrap();
        }
        std::fs::write(inner.join("a"), &bytes).unwrap();
        let uri = uri.replace('\\', "\\\\");
        for uri in [uri.as_str(), "a"] {
            match from_folder(&quad(uri), Some(&inner)) {
                Ok(_) => prop_assert!(bytes.len() >= 60, "{}", uri),
                Err(error) => prop_assert!(error.to_string().contains("a.gltf"), "{}", error),
            }
        }
    }
}
