//! PLY, ASCII or binary: faces are a stencil, the `edge` element a wireframe.

use std::borrow::Cow;
use std::io::Cursor;

use nalgebra::Point3;
use ply_rs_bw::parser::{ParseError, Parser, Reader};
use ply_rs_bw::ply::{
    ElementDef, Encoding, Header, Property, PropertyAccess, PropertyAccessResult, PropertyType, ScalarType,
};
use wirebend_error::ErrorRemedy;

use super::Imported;
use super::drawing::Drawing;
use super::error::{Location, ReadError};
use super::format::Format;
use super::note::NoteKind;
use super::options::ReadOptions;
use super::text::Source;

/// The properties that are read, of whichever element.
const READ: [&str; 7] = ["x", "y", "z", "vertex1", "vertex2", "vertex_indices", "vertex_index"];

/// One entry of any element: what of it is read.
#[derive(Debug, Default)]
struct Entry {
    at: [Option<f64>; 3],
    ends: [Option<i64>; 2],
    corners: Vec<i64>,
}

impl PropertyAccess for Entry {
    fn new() -> Self {
        Self::default()
    }

    fn set_property(&mut self, name: &str, property: Property) -> PropertyAccessResult {
        match name {
            "x" => self.at[0] = real(&property),
            "y" => self.at[1] = real(&property),
            "z" => self.at[2] = real(&property),
            "vertex1" => self.ends[0] = whole(&property),
            "vertex2" => self.ends[1] = whole(&property),
            "vertex_indices" | "vertex_index" => match wholes(property) {
                Some(corners) => self.corners = corners,
                None => return PropertyAccessResult::UnsupportedType,
            },
            _ => return PropertyAccessResult::Ignored,
        }
        PropertyAccessResult::Set
    }
}

fn whole(property: &Property) -> Option<i64> {
    Some(match *property {
        Property::Char(v) => v.into(),
        Property::UChar(v) => v.into(),
        Property::Short(v) => v.into(),
        Property::UShort(v) => v.into(),
        Property::Int(v) => v.into(),
        Property::UInt(v) => v.into(),
        _ => return None,
    })
}

fn real(property: &Property) -> Option<f64> {
    match *property {
        Property::Float(v) => Some(v.into()),
        Property::Double(v) => Some(v),
        #[allow(clippy::cast_precision_loss)] // at most 32 bits
        _ => whole(property).map(|v| v as f64),
    }
}

fn wholes(property: Property) -> Option<Vec<i64>> {
    Some(match property {
        Property::ListChar(list) => list.into_iter().map(i64::from).collect(),
        Property::ListUChar(list) => list.into_iter().map(i64::from).collect(),
        Property::ListShort(list) => list.into_iter().map(i64::from).collect(),
        Property::ListUShort(list) => list.into_iter().map(i64::from).collect(),
        Property::ListInt(list) => list.into_iter().map(i64::from).collect(),
        Property::ListUInt(list) => list.into_iter().map(i64::from).collect(),
        _ => return None,
    })
}

/// The file with a header of UTF-8, where it has another: other bytes are in its comments, or an error follows.
fn with_text_header(bytes: &[u8]) -> Option<Vec<u8>> {
    const END: &[u8] = b"end_header";
    let end = bytes.windows(END.len()).position(|word| word == END)?;
    let (header, rest) = bytes.split_at(end);
    let text = String::from_utf8_lossy(header);
    matches!(text, Cow::Owned(_)).then(|| [text.as_bytes(), rest].concat())
}

/// Reads vertices, faces and edges; other elements and properties are counted and ignored.
pub(super) fn read(bytes: &[u8], source: Source<'_>, options: &ReadOptions) -> Result<Imported, ReadError> {
    let parser = Parser::<Entry>::new();
    let readable = with_text_header(bytes);
    let bytes = readable.as_deref().unwrap_or(bytes);
    let mut input = Reader::new(Cursor::new(bytes));
    let mut header = parser.read_header(&mut input).map_err(|error| refuse(source, &error))?;
    let plain = without_odd_numbers(bytes, position(&input), &header);
    let bytes = plain.as_deref().unwrap_or(bytes);
    if plain.is_some() {
        input = Reader::new(Cursor::new(bytes));
        header = parser.read_header(&mut input).map_err(|error| refuse(source, &error))?;
    }
    let mut drawing = Drawing::default();
    let named = header.comments.len() + header.obj_infos.len();
    drawing.notes.add(NoteKind::CommentsIgnored, named);
    let mut corners = 0;
    for (_, element) in &header.elements {
        let left = bytes.len().saturating_sub(position(&input));
        check_count(element, header.encoding, left, source)?;
        let entries = parser
            .read_payload_for_element(&mut input, element, &header)
            .map_err(|error| refuse(source, &error))?;
        let count = drawing.points.len();
        for (k, entry) in entries.into_iter().enumerate() {
            match element.name.as_str() {
                "vertex" => drawing.points.push(point(source, k, &entry)?),
                "face" => {
                    corners += entry.corners.len();
                    source.room(Location::Item("face", k), corners / 8, "corners of faces")?;
                    let face = entry.corners.iter().map(|&corner| index(source, "face", k, corner, count));
                    drawing.faces.push(face.collect::<Result<_, _>>()?);
                }
                "edge" => {
                    let [Some(a), Some(b)] = entry.ends else {
                        let remedy = ErrorRemedy::ExportAgain;
                        let expected = "two whole numbers";
                        return Err(source.syntax(
                            Location::Item("edge", k),
                            "other properties",
                            expected,
                            remedy,
                        ));
                    };
                    drawing
                        .edges
                        .push((index(source, "edge", k, a, count)?, index(source, "edge", k, b, count)?));
                }
                _ => drawing.notes.add(NoteKind::StatementsIgnored, 1),
            }
        }
        let ignored = element.properties.iter().filter(|(name, _)| !READ.contains(&name.as_str())).count();
        drawing.notes.add(NoteKind::AttributesIgnored, ignored.saturating_mul(element.count));
    }
    let end = position(&input).min(bytes.len());
    drawing.notes.add(NoteKind::TrailingIgnored, bytes[end..].trim_ascii().len());
    check_indices(&drawing, source)?;
    drawing.finish(Format::Ply, source, options)
}

/// How far the bytes have been read.
fn position(input: &Reader<Cursor<&[u8]>>) -> usize {
    usize::try_from(input.get_ref().position()).unwrap_or(usize::MAX)
}

/// A text with 0 for what is no finite number in the columns that are not read, in whatever spelling: the parser takes
/// none of them. None where there is nothing to replace.
fn without_odd_numbers(bytes: &[u8], at: usize, header: &Header) -> Option<Vec<u8>> {
    let is_odd = |word: &[u8]| {
        let size = word.strip_prefix(b"-").unwrap_or(word);
        ["nan", "inf", "1.#"]
            .iter()
            .any(|odd| size.get(..3).is_some_and(|start| start.eq_ignore_ascii_case(odd.as_bytes())))
    };
    let (head, body) = bytes.split_at_checked(at)?;
    if header.encoding != Encoding::Ascii || !body.split(u8::is_ascii_whitespace).any(is_odd) {
        return None;
    }
    let mut text = head.to_vec();
    let mut lines = body.split_inclusive(|&byte| byte == b'\n');
    for (_, element) in &header.elements {
        for line in lines.by_ref().take(element.count) {
            let mut words = line.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty());
            for (name, property) in &element.properties {
                let is_read = READ.contains(&name.as_str());
                let mut count = 1;
                if let PropertyType::List(..) = property.data_type {
                    let word = words.next().unwrap_or_default();
                    count =
                        std::str::from_utf8(word).ok().and_then(|word| word.parse().ok()).unwrap_or_default();
                    text.extend([word, b" "].concat());
                }
                for word in words.by_ref().take(count) {
                    let word = if is_odd(word) && !is_read { b"0" } else { word };
                    text.extend([word, b" "].concat());
                }
            }
            // What is too much stays for the parser to refuse.
            text.extend(words.flat_map(|word| [word, b" "].concat()));
            text.push(b'\n');
        }
    }
    text.extend(lines.flatten());
    Some(text)
}

/// Refuses a count that the bytes left cannot hold, before anything is made for it.
fn check_count(
    element: &ElementDef,
    encoding: Encoding,
    left: usize,
    source: Source<'_>,
) -> Result<(), ReadError> {
    let place = Location::File;
    // In text every entry has a line of its own.
    let min: usize = match encoding {
        Encoding::Ascii => 1,
        _ => element.properties.iter().map(|(_, property)| min_bytes(&property.data_type)).sum(),
    };
    if min == 0 && element.count > 0 {
        let remedy = ErrorRemedy::ExportWithout { part: "this element".to_owned() };
        let found = format!("element {} {} without properties", element.name, element.count);
        return Err(source.syntax(place, &found, "an element with properties", remedy));
    }
    // The last line of a text may have no end.
    if element.count > 0 && element.count > (left + 1) / min {
        let announced = format!("{} entries of {} are announced", element.count, element.name);
        return Err(source.truncated(place, announced, format!("only {left} bytes are left")));
    }
    source.room(place, element.count.saturating_sub(1), "entries of an element")
}

fn min_bytes(data: &PropertyType) -> usize {
    let size = |scalar: &ScalarType| match scalar {
        ScalarType::Char | ScalarType::UChar => 1,
        ScalarType::Short | ScalarType::UShort => 2,
        ScalarType::Int | ScalarType::UInt | ScalarType::Float => 4,
        ScalarType::Double => 8,
    };
    match data {
        PropertyType::Scalar(scalar) | PropertyType::List(scalar, _) => size(scalar),
    }
}

fn point(source: Source<'_>, k: usize, entry: &Entry) -> Result<Point3<f64>, ReadError> {
    let place = Location::Item("vertex", k);
    let [Some(x), Some(y), Some(z)] = entry.at else {
        let remedy = ErrorRemedy::ExportAgain;
        return Err(source.syntax(place, "a vertex without position", "the properties x, y and z", remedy));
    };
    match [x, y, z].into_iter().find(|c| !c.is_finite()) {
        None => Ok(Point3::new(x, y, z)),
        Some(bad) => Err(ReadError::Number {
            file: source.name.to_owned(),
            place,
            found: bad.to_string(),
            expected: "finite number",
        }),
    }
}

fn index(
    source: Source<'_>,
    what: &'static str,
    k: usize,
    index: i64,
    count: usize,
) -> Result<u32, ReadError> {
    u32::try_from(index).map_err(|_| no_vertex(source, what, k, index, count))
}

fn no_vertex(source: Source<'_>, what: &'static str, k: usize, index: i64, count: usize) -> ReadError {
    ReadError::Index {
        file: source.name.to_owned(),
        place: Location::Item(what, k),
        found: index.to_string(),
        what: "vertex",
        have: format!("they count from 0 and there are {count}"),
    }
}

/// Faces may come before the vertices, so this is checked last.
fn check_indices(drawing: &Drawing, source: Source<'_>) -> Result<(), ReadError> {
    let count = drawing.points.len();
    let bad = |&&corner: &&u32| corner as usize >= count;
    for (k, face) in drawing.faces.iter().enumerate() {
        if let Some(&corner) = face.iter().find(bad) {
            return Err(no_vertex(source, "face", k, corner.into(), count));
        }
    }
    for (k, &(a, b)) in drawing.edges.iter().enumerate() {
        if let Some(&end) = [a, b].iter().find(bad) {
            return Err(no_vertex(source, "edge", k, end.into(), count));
        }
    }
    Ok(())
}

fn refuse(source: Source<'_>, error: &ParseError) -> ReadError {
    let message = error.to_string();
    let place = error.line().map_or(Location::File, Location::Line);
    if error.kind() == std::io::ErrorKind::UnexpectedEof {
        return source.truncated(place, "more entries are announced".into(), "the file ends".into());
    }
    let message =
        message.split("\n\t").nth(1).unwrap_or(&message).trim_start_matches("String: ").trim_matches('\'');
    source.syntax(place, message, "a PLY header, then numbers as it says", ErrorRemedy::CorrectFile)
}
