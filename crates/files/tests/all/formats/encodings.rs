//! Text in UTF-16, as Windows' editors, PowerShell and spreadsheets save it, reads as it does in UTF-8.

use wirebend_error::ErrorRemedy;
use wirebend_files::document::Document;
use wirebend_files::read::{Format, ReadOptions, detect, read};

use super::any_bytes::valid_files;
use super::{import, notes};

/// With a byte order mark, the low byte first or the high one.
pub fn utf16(text: &str, low_first: bool) -> Vec<u8> {
    let words = std::iter::once(0xfeff).chain(text.encode_utf16());
    words.flat_map(|word: u16| if low_first { word.to_le_bytes() } else { word.to_be_bytes() }).collect()
}

#[test]
fn every_text_is_read_from_utf_16() {
    let mut formats = Vec::new();
    for (format, bytes) in valid_files() {
        let Ok(text) = std::str::from_utf8(&bytes) else { continue };
        if text.contains('\0') {
            continue;
        }
        let expected = read(&bytes, "file", Some(format), &ReadOptions::default()).unwrap();
        for low_first in [true, false] {
            let wide = utf16(text, low_first);
            let imported = read(&wide, "file", Some(format), &ReadOptions::default())
                .unwrap_or_else(|error| panic!("{format}: {error}"));
            assert_eq!(imported.wireframe, expected.wireframe, "{format}");
            assert_eq!(imported.stencil, expected.stencil, "{format}");
            assert_eq!(imported.notes, expected.notes, "{format}");
            assert_eq!(
                detect("standard input", &wide).ok(),
                detect("standard input", &bytes).ok(),
                "{format}"
            );
        }
        let with_mark = [b"\xef\xbb\xbf", bytes.as_slice()].concat();
        assert!(read(&with_mark, "file", Some(format), &ReadOptions::default()).is_ok(), "{format}");
        formats.push(format);
    }
    formats.dedup();
    let binary_only = [Format::ThreeMf];
    for format in Format::ALL {
        assert!(formats.contains(&format) || binary_only.contains(&format), "{format} was not tried");
    }
    let project = Document::default().to_bytes().unwrap();
    let wide = utf16(std::str::from_utf8(&project).unwrap(), true);
    assert_eq!(Document::open(&wide, "a.wirebend").unwrap(), Document::default());
}

#[test]
fn an_error_in_utf_16_names_the_same_line() {
    let error = import("a.obj", utf16("v 0 0 0\r\nv 1 0 0\r\nl 1 3\r\n", true)).unwrap_err();
    assert_eq!(error.line(), Some(3));
    // 32 bits a character are called what they are.
    let wide: Vec<u8> = "\u{feff}v 0 0 0\n".chars().flat_map(|c| u32::from(c).to_le_bytes()).collect();
    let error = import("a.obj", wide).unwrap_err();
    assert_eq!(error.to_string(), "a.obj: found a text in UTF-32, expected Wavefront OBJ");
    assert_eq!(error.remedies(), [ErrorRemedy::ExportAs { form: "UTF-8 text".to_owned() }]);
}

/// What a spreadsheet saves as "Unicode text": tabs, UTF-16 and a mark.
#[test]
fn a_table_of_a_spreadsheet_is_read() {
    let table = utf16("X [mm]\tY [mm]\tZ [mm]\r\n0\t0\t0\r\n1,5\t0\t0\r\n", true);
    let imported = import("points.txt", table).unwrap();
    assert_eq!((imported.format, imported.wireframe.edge_count()), (Format::Xyz, 1));
    assert_eq!(notes(&imported.notes), ["the first row is a header"]);
}

/// Names of people in comments, as exporters write them that know of no encoding.
#[test]
fn other_letters_in_the_head_of_a_ply_are_in_nobodys_way() {
    let head = b"ply\nformat ascii 1.0\ncomment M\xfcller\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\n";
    let edges =
        b"element edge 1\nproperty int vertex1\nproperty int vertex2\nend_header\n0 0 0\n10 0 0\n0 1\n";
    let imported = import("a.ply", [&head[..], edges].concat()).unwrap();
    assert_eq!((imported.format, imported.wireframe.edge_count()), (Format::Ply, 1));
}

/// A column of remarks makes no points of lengths, rotations and angles.
#[test]
fn a_table_of_bends_may_have_words_beside_them() {
    let table = "L (mm);R;A;Bemerkung\n50;0;90;erster Bogen\n40;90;45;zweiter\n30;;;Ende\n";
    let imported = import("a.csv", table).unwrap();
    assert_eq!((imported.format, imported.wireframe.edge_count()), (Format::Lra, 3));
}

/// "Träger" and "Trüger" differ in a letter that is not ASCII, "表" is two bytes of which the second is a backslash in ASCII.
#[test]
fn the_layers_of_a_drawing_are_named_in_its_code_page() {
    let drawing = |page: &str, layers: [&[u8]; 2]| {
        let header = if page.is_empty() {
            String::new()
        } else {
            format!("0\nSECTION\n2\nHEADER\n9\n$DWGCODEPAGE\n3\n{page}\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n")
        };
        let mut bytes = (header + "0\nSECTION\n2\nENTITIES\n").into_bytes();
        for (layer, x) in layers.into_iter().zip([1, 2]) {
            bytes.extend(b"0\nLINE\n8\n");
            bytes.extend(layer);
            bytes.extend(format!("\n10\n0\n20\n0\n11\n{x}\n21\n0\n").bytes());
        }
        bytes.extend(b"0\nENDSEC\n0\nEOF\n");
        bytes
    };
    let german: [&[u8]; 2] = [b"Tr\xe4ger", b"Tr\xfcger"];
    for (page, layers, wanted) in [
        ("ANSI_1252", german, "Träger"),
        ("", german, "träger"),
        ("ANSI_1251", [b"\xea\xf0\xf3\xe3", b"\xea\xf0\xf3\xea"], "КРУГ"),
        ("ansi_932", [b"\x95\x5c", b"\x95\x5d"], "表"),
        ("ANSI_1252", ["Träger".as_bytes(), "Trüger".as_bytes()], "Träger"),
        ("ANSI_1252", [b"Tr\\U+00E4ger", b"Tr\\U+00FCger"], "Träger"),
    ] {
        let options = ReadOptions { layers: vec![wanted.to_owned()], ..ReadOptions::default() };
        let imported = read(&drawing(page, layers), "a.dxf", None, &options)
            .unwrap_or_else(|error| panic!("{page}, {wanted}: {error}"));
        assert_eq!(imported.wireframe.edge_count(), 1, "{page}, {wanted}");
        assert!((imported.wireframe.total_length().mm() - 1.0).abs() < 1e-12, "{page}, {wanted}");
    }
    // A file of release 2007 with one byte that is no letter: the others are read as they are.
    let of = String::from_utf8(drawing("ANSI_1252", ["Träger".as_bytes(), b"b"])).unwrap();
    let modern = of.replace("9\n$DWGCODEPAGE", "9\n$ACADVER\n1\nAC1021\n9\n$DWGCODEPAGE");
    let bytes = [modern.as_bytes(), b"\xff\n"].concat();
    let options = ReadOptions { layers: vec!["Träger".to_owned()], ..ReadOptions::default() };
    assert_eq!(read(&bytes, "a.dxf", None, &options).unwrap().wireframe.edge_count(), 1);
    // A page that nobody knows, and what only looks like a letter.
    for (page, layer) in [("ANSI_1361", b"a\xe4".as_slice()), ("ANSI_1252", b"a\\U+D800"), ("", b"\\U+")] {
        let imported = read(&drawing(page, [layer, b"b"]), "a.dxf", None, &ReadOptions::default());
        assert_eq!(imported.unwrap().wireframe.edge_count(), 2, "{page}");
    }
}
