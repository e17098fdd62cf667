//! STL, ASCII or binary: a stencil of triangles. Corners with the same coordinates are one vertex.

use std::cell::Cell;
use std::collections::HashMap;
use std::io::{self, Read, Seek, SeekFrom};

use nalgebra::Point3;
use wirebend_error::ErrorRemedy;

use super::Imported;
use super::drawing::Drawing;
use super::error::{Location, ReadError};
use super::format::Format;
use super::note::NoteKind;
use super::options::ReadOptions;
use super::text::Source;

/// A binary file is a head of 80 bytes, a count and 50 bytes a triangle.
const HEAD: usize = 84;
const TRIANGLE: usize = 50;

/// How many triangles a binary file announces; `None` when it is too short to be one.
fn announced(bytes: &[u8]) -> Option<usize> {
    let count = bytes.get(HEAD - 4..HEAD)?.try_into().ok()?;
    usize::try_from(u32::from_le_bytes(count)).ok()
}

/// Whether the size is just that of a binary file. Some of those start with "solid" like text.
pub(super) fn is_binary(bytes: &[u8]) -> bool {
    announced(bytes).is_some_and(|count| count.checked_mul(TRIANGLE) == Some(bytes.len() - HEAD))
}

/// Reads all solids of a file into one stencil. Normals and attributes are counted and ignored.
pub(super) fn read(bytes: &[u8], source: Source<'_>, options: &ReadOptions) -> Result<Imported, ReadError> {
    let mut drawing = Drawing::default();
    let mut corners = HashMap::new();
    if bytes.is_empty() {
        return Err(source.empty("triangles", &drawing.notes));
    }
    if is_text(bytes) {
        text(bytes, source, &mut drawing, &mut corners)?;
    } else {
        binary(bytes, source, &mut drawing, &mut corners)?;
    }
    if drawing.faces.is_empty() {
        return Err(source.empty("triangles", &drawing.notes));
    }
    drawing.notes.add(NoteKind::NormalsIgnored, drawing.faces.len());
    drawing.finish(Format::Stl, source, options)
}

fn is_text(bytes: &[u8]) -> bool {
    !is_binary(bytes) && opens_solid(bytes.trim_ascii_start())
}

fn opens_solid(bytes: &[u8]) -> bool {
    bytes.get(..5).is_some_and(|word| word.eq_ignore_ascii_case(b"solid"))
}

/// Whether a line begins a triangle, with three words for its normal.
fn is_facet(line: &[u8]) -> bool {
    let mut words = line.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty());
    let is =
        |word: Option<&[u8]>, name: &str| word.is_some_and(|word| word.eq_ignore_ascii_case(name.as_bytes()));
    is(words.next(), "facet") && is(words.next(), "normal") && words.count() == 3
}

type Corners = HashMap<[u32; 3], u32>;

/// The first line of a text that is not blank, and its number from 1; `None` where a byte is no text.
fn first_line(bytes: &[u8]) -> Option<(usize, &str)> {
    let text = std::str::from_utf8(bytes).ok()?;
    let is_plain = |c: char| !c.is_control() || c.is_ascii_whitespace();
    let mut lines = (1..).zip(text.lines());
    text.chars().all(is_plain).then(|| lines.find(|(_, line)| !line.trim().is_empty()).unwrap_or((1, "")))
}

fn binary(
    bytes: &[u8],
    source: Source<'_>,
    drawing: &mut Drawing,
    corners: &mut Corners,
) -> Result<(), ReadError> {
    let held = bytes.len().saturating_sub(HEAD) / TRIANGLE;
    if announced(bytes).is_none_or(|count| held < count)
        && let Some((number, line)) = first_line(bytes)
    {
        let expected = "solid, with which an STL in text begins";
        let remedy = ErrorRemedy::OpenModel;
        return Err(source.syntax(Location::Line(number), line.trim_start(), expected, remedy));
    }
    let Some(count) = announced(bytes) else {
        let announced = "a binary STL starts with 84 bytes".to_owned();
        return Err(source.truncated(Location::File, announced, format!("there are {}", bytes.len())));
    };
    if held < count {
        let announced = format!("{count} triangles are announced");
        return Err(source.truncated(
            Location::Byte(HEAD - 4),
            announced,
            format!("there is room for {held}"),
        ));
    }
    drawing.notes.add(NoteKind::TrailingIgnored, bytes.len() - HEAD - count * TRIANGLE);
    let mut input = Input { bytes, at: 0, start: 0, line: None };
    let triangles =
        stl_io::create_stl_reader(&mut input).map_err(|error| source.library("stl_io", &error))?;
    for (k, triangle) in triangles.enumerate() {
        let place = Location::Byte(HEAD + k * TRIANGLE);
        let triangle = triangle.map_err(|error| source.library("stl_io", &error))?;
        add(drawing, corners, source, &place, &triangle)?;
    }
    Ok(())
}

fn text(
    bytes: &[u8],
    source: Source<'_>,
    drawing: &mut Drawing,
    corners: &mut Corners,
) -> Result<(), ReadError> {
    let line = Cell::new(0);
    let mut start = 0;
    // A file may hold several solids, one after another.
    while !bytes[start..].trim_ascii().is_empty() {
        let refuse = |error: &io::Error| {
            if error.kind() == io::ErrorKind::UnexpectedEof {
                return source.truncated(
                    Location::Line(line.get()),
                    "a solid begins".into(),
                    error.to_string(),
                );
            }
            let found =
                bytes.split(|&byte| byte == b'\n').nth(line.get().saturating_sub(1)).unwrap_or_default();
            let expected = "solid, facet normal, outer loop, three vertices, endloop, endfacet, endsolid";
            let found = String::from_utf8_lossy(found);
            source.syntax(Location::Line(line.get()), &found, expected, ErrorRemedy::CorrectFile)
        };
        let begin = start + bytes[start..].iter().take_while(|byte| byte.is_ascii_whitespace()).count();
        line.set(line.get() + bytes[start..begin].split(|&byte| byte == b'\n').count() - 1);
        if !opens_solid(&bytes[begin..]) {
            // `stl_io` would take it for a binary file.
            line.set(line.get() + 1);
            return Err(refuse(&io::ErrorKind::InvalidData.into()));
        }
        let mut input = Input { bytes, at: begin, start: begin, line: Some((&line, line.get())) };
        let triangles = stl_io::create_stl_reader(&mut input).map_err(|error| refuse(&error))?;
        for triangle in triangles {
            let triangle = triangle.map_err(|error| refuse(&error))?;
            add(drawing, corners, source, &Location::Line(line.get()), &triangle)?;
        }
        start = input.at;
    }
    Ok(())
}

fn add(
    drawing: &mut Drawing,
    corners: &mut Corners,
    source: Source<'_>,
    place: &Location,
    triangle: &stl_io::Triangle,
) -> Result<(), ReadError> {
    source.room(place.clone(), drawing.faces.len(), "triangles")?;
    let mut face = Vec::with_capacity(3);
    for corner in triangle.vertices {
        if let Some(bad) = corner.0.iter().find(|c| !c.is_finite()) {
            return Err(ReadError::Number {
                file: source.name.to_owned(),
                place: place.clone(),
                found: bad.to_string(),
                expected: "finite number",
            });
        }
        // Adding zero makes -0 and 0 the same bits.
        let bits = corner.0.map(|c| (c + 0.0).to_bits());
        let next = drawing.points.len();
        let index = *corners.entry(bits).or_insert(u32::try_from(next).unwrap_or(u32::MAX));
        if index as usize == next {
            source.room(place.clone(), next, "vertices")?;
            drawing.points.push(Point3::from(corner.0.map(f64::from)));
        }
        face.push(index);
    }
    drawing.faces.push(face);
    Ok(())
}

/// The bytes as `stl_io` wants them. Text is given a line at a time, so that the line of an error is
/// known, in lower case, without bytes that are no text, and with a blank behind "solid". The head
/// of a binary file is blanked, since one that starts with "solid" would be taken for text.
struct Input<'a> {
    bytes: &'a [u8],
    at: usize,
    start: usize,
    /// For text, the lines given out so far, and how many there were before `start`.
    line: Option<(&'a Cell<usize>, usize)>,
}

impl Read for Input<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let rest = &self.bytes[self.at..];
        let Some((line, _)) = self.line else {
            let length = rest.len().min(buffer.len());
            buffer[..length].copy_from_slice(&rest[..length]);
            let head = (HEAD - 4).saturating_sub(self.at).min(length);
            buffer[..head].fill(0);
            self.at += length;
            return Ok(length);
        };
        let length = rest.iter().position(|&byte| byte == b'\n').map_or(rest.len(), |end| end + 1);
        let opening = b"solid \n";
        if self.at == self.start && opens_solid(rest) {
            let given = opening.len().min(buffer.len());
            buffer[..given].copy_from_slice(&opening[..given]);
            self.at += length;
            line.set(line.get() + 1);
            return Ok(given);
        }
        // A program that has no normal writes what its language calls that. They are not read.
        let facet = b"facet normal 0 0 0\n";
        if is_facet(&rest[..length]) && length <= rest.len() {
            let given = facet.len().min(buffer.len());
            buffer[..given].copy_from_slice(&facet[..given]);
            self.at += length;
            line.set(line.get() + 1);
            return Ok(given);
        }
        let length = length.min(buffer.len());
        for (to, &from) in buffer.iter_mut().zip(&rest[..length]) {
            *to = if from.is_ascii() { from.to_ascii_lowercase() } else { b'?' };
        }
        line.set(line.get() + usize::from(length > 0 && (rest[length - 1] == b'\n' || length == rest.len())));
        self.at += length;
        Ok(length)
    }
}

impl Seek for Input<'_> {
    /// Only to the start, which is all that a probe needs.
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        if to != SeekFrom::Start(0) {
            return Err(io::ErrorKind::Unsupported.into());
        }
        self.at = self.start;
        if let Some((line, before)) = self.line {
            line.set(before);
        }
        Ok(0)
    }
}
