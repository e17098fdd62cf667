//! How a file's format is detected.

use wirebend_error::ErrorRemedy;

use super::error::ReadError;
use super::format::Format;
use super::gcode;
use super::table::Table;
use super::text::{decode, lines, utf8};

/// How much of a text is looked at.
const SNIFFED: usize = 1 << 20;

/// The format of a file: from its extension where only one format has it, else from its content.
///
/// # Errors
/// [`ReadError::EmptyFile`], [`ReadError::GCode`], [`ReadError::Order`], and [`ReadError::UnknownFormat`], which lists the formats.
pub fn detect(name: &str, bytes: &[u8]) -> Result<Format, ReadError> {
    let extension = name.rsplit_once('.').map(|(_, extension)| extension.to_ascii_lowercase());
    let by_name: Vec<Format> = Format::ALL
        .into_iter()
        .filter(|format| extension.as_deref().is_some_and(|ext| format.extensions().contains(&ext)))
        .collect();
    let by_content = sniff(bytes);
    match (by_name.as_slice(), by_content) {
        // JSON says itself which it is; what does not gets the error of a reader, with a line.
        ([Format::Assembly, ..], Some(found @ (Format::Wirebend | Format::Conmech | Format::Moves))) => {
            Ok(found)
        }
        ([Format::Assembly, ..], _) if is_order(bytes) => Err(ReadError::Order { file: name.to_owned() }),
        ([Format::Assembly, ..], _) => Ok(Format::Assembly),
        (&[only], _) => Ok(only),
        (_, Some(format)) => Ok(format),
        // A table without any number still gets the error of its reader, with a line.
        ([Format::Xyz, ..], None) if extension.as_deref() != Some("txt") => Ok(by_columns(bytes)),
        _ if is_blank(bytes) => Err(ReadError::EmptyFile { file: name.to_owned() }),
        _ if gcode::is_named(extension.as_deref()) || is_gcode(bytes) => {
            Err(ReadError::GCode { file: name.to_owned() })
        }
        _ => Err(ReadError::UnknownFormat { file: name.to_owned() }),
    }
}

/// The format of a table in which not only numbers are, by the names of its columns.
fn by_columns(bytes: &[u8]) -> Format {
    let text = decode(&bytes[..bytes.len().min(SNIFFED)]);
    let table = Table::parse(&text);
    if table.header.is_some() && super::program::lra::looks_like(&table) { Format::Lra } else { Format::Xyz }
}

/// Whether nothing is in a file but space.
pub(super) fn is_blank(bytes: &[u8]) -> bool {
    utf8(bytes).trim_ascii().is_empty()
}

/// Whether a file is an order of struts, as FrameFab writes it.
fn is_order(bytes: &[u8]) -> bool {
    decode(&bytes[..bytes.len().min(SNIFFED)]).contains("\"sequenced_elements\"")
}

/// Whether a file is G-code, whatever its name.
pub(super) fn is_gcode(bytes: &[u8]) -> bool {
    let text = decode(&bytes[..bytes.len().min(SNIFFED)]);
    !text.contains('\0') && gcode::looks_like(&text)
}

/// The binary formats that begin with a word of their own.
fn by_magic(bytes: &[u8]) -> Option<Format> {
    if super::dxf::is_binary(bytes) {
        return Some(Format::Dxf);
    }
    if bytes.starts_with(b"glTF") {
        return Some(Format::Gltf);
    }
    // An archive without a model gets the error of the reader.
    bytes.starts_with(b"PK\x03\x04").then_some(Format::ThreeMf)
}

/// What a file is that is no model whatever its name, and what to do: the kinds that are dropped by mistake, which their readers would
/// call damaged.
pub(super) fn foreign(bytes: &[u8]) -> Option<(&'static str, ErrorRemedy)> {
    const MAGIC: [(&[u8], &str); 10] = [
        (b"\x89PNG\r\n\x1a\n", "a PNG picture"),
        (b"\xff\xd8\xff", "a JPEG picture"),
        (b"GIF87a", "a GIF picture"),
        (b"GIF89a", "a GIF picture"),
        (b"%PDF-", "a PDF document"),
        (b"ID3", "an MP3 recording"),
        (b"\xff\xfb", "an MP3 recording"),
        (b"\x1f\x8b", "an archive (gzip)"),
        (b"7z\xbc\xaf\x27\x1c", "an archive (7z)"),
        (b"\x7fELF", "a program"),
    ];
    if super::stl::is_binary(bytes) {
        return None;
    }
    if bytes.starts_with(b"\xff\xfe\0\0") || bytes.starts_with(b"\0\0\xfe\xff") {
        return Some(("a text in UTF-32", ErrorRemedy::ExportAs { form: "UTF-8 text".to_owned() }));
    }
    let found = MAGIC.iter().find(|(magic, _)| bytes.starts_with(magic));
    found.map(|&(_, what)| (what, ErrorRemedy::OpenModel))
}

/// The format that the content looks like.
fn sniff(bytes: &[u8]) -> Option<Format> {
    let is_ply = |bytes: &[u8]| bytes.starts_with(b"ply\n") || bytes.starts_with(b"ply\r");
    if is_ply(bytes) {
        return Some(Format::Ply);
    }
    if let Some(format) = by_magic(bytes) {
        return Some(format);
    }
    if super::stl::is_binary(bytes) {
        return Some(Format::Stl);
    }
    let text = decode(&bytes[..bytes.len().min(SNIFFED)]);
    if is_ply(text.as_bytes()) {
        return Some(Format::Ply);
    }
    if text.contains('\0') {
        return None;
    }
    if text.trim_start().starts_with('{') {
        // A job is no wireframe, which the reader of documents says best.
        if text.contains("\"wirebend\"") || text.contains("\"wbjob\"") {
            return Some(Format::Wirebend);
        }
        if text.contains("\"wbmoves\"") {
            return Some(Format::Moves);
        }
        if text.contains("\"node_list\"") {
            return Some(Format::Assembly);
        }
        if text.contains("\"end_node_inds\"") {
            return Some(Format::Conmech);
        }
        return text.contains("\"asset\"").then_some(Format::Gltf);
    }
    if text.trim_start().starts_with('<') {
        return text.contains("<svg").then_some(Format::Svg);
    }
    if super::dxf::looks_like(&text) {
        return Some(Format::Dxf);
    }
    let mut points = 0;
    for (_, line) in lines(&text).filter(|(_, line)| !line.trim().is_empty()) {
        let mut words = line.split_whitespace();
        let first = words.next().unwrap_or_default();
        let number = words.next().is_some_and(|word| word.parse::<f64>().is_ok());
        match (first, number) {
            ("solid" | "facet", _) => return Some(Format::Stl),
            ("v", true) => points += 1,
            ("p" | "c" | "g", true) if points > 0 => return Some(Format::Pwf),
            ("vn" | "vt" | "f" | "l", true) if points > 0 => return Some(Format::Obj),
            ("F" | "R" | "B" | "f" | "r" | "b", true) if points == 0 => return Some(Format::Kit),
            _ if number && super::program::pensa::is_command(first) => return Some(Format::Pensa),
            _ => {}
        }
    }
    if points > 0 {
        return Some(Format::Obj);
    }
    let table = Table::parse(&text);
    table
        .is_numeric()
        .then(|| if super::program::lra::looks_like(&table) { Format::Lra } else { Format::Xyz })
}
