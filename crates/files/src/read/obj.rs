//! Wavefront OBJ: `l` lines are a wireframe, faces a stencil.
//!
//! `tobj` reads the numbers. It does not say three things, so the file is handed to it statement by statement:
//! - It keeps only vertices that a face uses, in the order of first use. A face of one point follows each vertex, so all
//!   are kept in the order of the file.
//! - It does not tell an `l` from an `f` of as many vertices. It keeps their order, so this side remembers which is which.
//! - Its errors name no line. Once something is wrong, the first wrong statement is looked for here, with line and word.

use std::fmt::Write as _;

use nalgebra::Point3;
use wirebend_error::ErrorRemedy;

use super::Imported;
use super::drawing::Drawing;
use super::error::{Location, ReadError};
use super::format::Format;
use super::note::NoteKind;
use super::options::ReadOptions;
use super::text::{Source, decode, lines};

const MIN_POLYLINE: usize = 2;
const MIN_FACE: usize = 3;

/// Reads points, lines and polygons; negative indices count back from the last vertex so far.
pub(super) fn read(bytes: &[u8], source: Source<'_>, options: &ReadOptions) -> Result<Imported, ReadError> {
    let text = decode(bytes);
    let mut file = File::new(source);
    each_statement(&text, |line, statement| file.add(line, statement))?;
    let refused = match file.drawing() {
        Ok(drawing) => return drawing.finish(Format::Obj, source, options),
        Err(refused) => refused,
    };
    let mut vertices = 0;
    each_statement(&text, |line, statement| check(source, line, statement, &mut vertices))?;
    Err(source.library("tobj", &refused))
}

/// Calls `with` for each statement, with the line where it ends. A backslash continues a line on the next one, but not a
/// comment.
fn each_statement(
    text: &str,
    mut with: impl FnMut(usize, &str) -> Result<(), ReadError>,
) -> Result<(), ReadError> {
    let mut joined = String::new();
    for (line, text) in lines(text) {
        let continued = if text.contains('#') { None } else { text.trim_end().strip_suffix('\\') };
        if let Some(begin) = continued {
            joined.push_str(begin);
            joined.push(' ');
        } else if joined.is_empty() {
            with(line, text)?;
        } else {
            joined.push_str(text);
            with(line, &std::mem::take(&mut joined))?;
        }
    }
    with(lines(text).count(), &joined)
}

/// The keyword of a statement and its words, without a comment.
fn words(statement: &str) -> (&str, Vec<&str>) {
    let mut words = code(statement).split_whitespace();
    (words.next().unwrap_or_default(), words.collect())
}

fn code(statement: &str) -> &str {
    statement.split('#').next().unwrap_or_default()
}

/// The index of a vertex; what follows a slash are a texture coordinate and a normal, which are not read.
fn index(word: &str) -> &str {
    word.split('/').next().unwrap_or_default()
}

/// What a statement draws.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Drawn {
    Vertex,
    Polyline,
    Face,
}

struct File<'a> {
    source: Source<'a>,
    drawing: Drawing,
    /// The statements for `tobj`.
    text: String,
    /// What each face of `tobj` is: one for each vertex, polyline and face of the file.
    drawn: Vec<Drawn>,
    edges: usize,
    faces: usize,
    /// Whether a statement has too few words or too many.
    is_wrong: bool,
}

impl<'a> File<'a> {
    fn new(source: Source<'a>) -> Self {
        let (drawing, text, drawn) = (Drawing::default(), String::new(), Vec::new());
        Self { source, drawing, text, drawn, edges: 0, faces: 0, is_wrong: false }
    }

    /// Takes a statement for `tobj`, or notes what is not read.
    fn add(&mut self, line: usize, statement: &str) -> Result<(), ReadError> {
        let (keyword, words) = words(statement);
        let ignored = match keyword {
            "v" => return self.vertex(line, &words),
            "f" => {
                self.source.room(Location::Line(line), self.faces, "faces")?;
                self.faces += 1;
                self.is_wrong |= words.len() < MIN_FACE;
                self.corners(Drawn::Face, 'f', &words);
                return Ok(());
            }
            "l" => {
                self.edges += words.len().saturating_sub(1);
                self.source.room(Location::Line(line), self.edges.saturating_sub(1), "edges")?;
                self.is_wrong |= words.len() < MIN_POLYLINE;
                self.corners(Drawn::Polyline, 'l', &words);
                return Ok(());
            }
            "" if !statement.contains('#') => return Ok(()),
            "" => NoteKind::CommentsIgnored,
            "vn" => NoteKind::NormalsIgnored,
            "vt" => NoteKind::TextureIgnored,
            "p" => NoteKind::PointsIgnored,
            "o" | "g" | "s" | "mtllib" | "usemtl" => NoteKind::NamesIgnored,
            _ => NoteKind::StatementsIgnored,
        };
        self.drawing.notes.add(ignored, 1);
        Ok(())
    }

    fn vertex(&mut self, line: usize, words: &[&str]) -> Result<(), ReadError> {
        self.source.room(Location::Line(line), self.drawing.point_lines.len(), "vertices")?;
        // A weight divides, three or four more numbers are a colour.
        let read = match words.len() {
            count @ (3 | 4) => count,
            6 | 7 => {
                self.drawing.notes.add(NoteKind::AttributesIgnored, 1);
                3
            }
            _ => {
                self.is_wrong = true;
                return Ok(());
            }
        };
        let _ = writeln!(self.text, "v {}\nf -1", words[..read].join(" "));
        self.drawing.point_lines.push(line);
        self.drawn.push(Drawn::Vertex);
        Ok(())
    }

    fn corners(&mut self, drawn: Drawn, keyword: char, words: &[&str]) {
        self.text.push(keyword);
        for word in words {
            self.text.push(' ');
            // To `tobj`, a slash alone is an index that names no vertex.
            self.text.push_str(Some(index(word)).filter(|index| !index.is_empty()).unwrap_or("/"));
        }
        self.text.push('\n');
        self.drawn.push(drawn);
    }

    /// What `tobj` reads of it, or what is wrong, without a place.
    fn drawing(mut self) -> Result<Drawing, String> {
        if self.is_wrong {
            return Err("a statement has too few words, or too many".to_owned());
        }
        let no_materials = |_: &std::path::Path| Err(tobj::LoadError::OpenFileFailed);
        let (models, _) =
            tobj::load_obj_buf(&mut self.text.as_bytes(), &tobj::LoadOptions::default(), no_materials)
                .map_err(|error| error.to_string())?;
        // Without names of objects and materials, all is one model.
        let mesh = models.into_iter().next().map(|model| model.mesh).unwrap_or_default();
        if !mesh.positions.iter().all(|coordinate| coordinate.is_finite()) {
            return Err("a position is not finite".to_owned());
        }
        self.drawing.points = mesh.positions.chunks_exact(3).map(Point3::from_slice).collect();
        let mut indices = mesh.indices.into_iter();
        let mut known = 0;
        for (drawn, arity) in self.drawn.into_iter().zip(mesh.face_arities) {
            known += u32::from(drawn == Drawn::Vertex);
            let corners: Vec<u32> = indices.by_ref().take(arity as usize).collect();
            if corners.iter().any(|&corner| corner >= known) {
                return Err("an index names a vertex that comes later".to_owned());
            }
            match drawn {
                Drawn::Vertex => {}
                Drawn::Polyline => {
                    self.drawing.edges.extend(corners.windows(2).map(|pair| (pair[0], pair[1])));
                }
                Drawn::Face => self.drawing.faces.push(corners),
            }
        }
        Ok(self.drawing)
    }
}

/// Refuses a wrong statement; `vertices` counts those so far.
fn check(source: Source<'_>, line: usize, statement: &str, vertices: &mut usize) -> Result<(), ReadError> {
    let (keyword, words) = words(statement);
    let refuse = |expected: &str| {
        Err(source.syntax(Location::Line(line), code(statement), expected, ErrorRemedy::CorrectFile))
    };
    match keyword {
        "v" => {
            if !matches!(words.len(), 3 | 4 | 6 | 7) {
                return refuse("three numbers after v");
            }
            let read = if words.len() == 4 { 4 } else { 3 };
            let numbers = words[..read]
                .iter()
                .map(|word| source.number(line, word))
                .collect::<Result<Vec<f64>, _>>()?;
            let weight = numbers.get(3).copied().unwrap_or(1.0);
            if !numbers[..3].iter().all(|coordinate| (coordinate / weight).is_finite()) {
                return refuse("a weight, the fourth number, that leaves a finite position");
            }
            *vertices += 1;
        }
        "f" if words.len() < MIN_FACE => {
            return refuse("three or more indices after f");
        }
        "l" if words.len() < MIN_POLYLINE => {
            return refuse("two or more indices after l");
        }
        "f" | "l" => {
            words
                .iter()
                .try_for_each(|word| source.index(line, index(word), "vertex", *vertices, true).map(drop))?;
        }
        _ => {}
    }
    Ok(())
}
