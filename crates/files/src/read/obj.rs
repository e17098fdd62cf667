//! Wavefront OBJ: `l` lines are a wireframe, faces a stencil.
//!
//! `tobj` reads the mesh. It gives errors without lines and numbers vertices by first use, so every
//! line is checked here first, `tobj` gets what passed, and its vertices are mapped back.

use std::fmt::Write as _;

use nalgebra::Point3;

use super::Imported;
use super::drawing::Drawing;
use super::error::{Place, ReadError};
use super::format::Format;
use super::note::NoteKind;
use super::options::ReadOptions;
use super::text::{Source, decode, lines};

/// Reads points, lines and polygons; negative indices count back from the last vertex so far.
pub(super) fn read(bytes: &[u8], source: Source<'_>, options: &ReadOptions) -> Result<Imported, ReadError> {
    let mut scan = Scan {
        source,
        drawing: Drawing::default(),
        mesh: String::new(),
        met: Vec::new(),
        faces: 0,
        order: Vec::new(),
    };
    let text = decode(bytes);
    let mut joined = String::new();
    for (line, text) in lines(&text) {
        // A backslash continues the line on the next one, but not a comment.
        let continued = if text.contains('#') { None } else { text.trim_end().strip_suffix('\\') };
        if let Some(begin) = continued {
            joined.push_str(begin);
            joined.push(' ');
        } else if joined.is_empty() {
            scan.line(line, text)?;
        } else {
            joined.push_str(text);
            scan.line(line, &std::mem::take(&mut joined))?;
        }
    }
    scan.line(lines(&text).count(), &joined)?;
    scan.mesh()?.finish(Format::Obj, source, options)
}

struct Scan<'a> {
    source: Source<'a>,
    drawing: Drawing,
    /// The vertices and faces for `tobj`, and nothing else.
    mesh: String,
    faces: usize,
    /// Whether a face uses a vertex, and the vertices in the order of first use by a face.
    met: Vec<bool>,
    order: Vec<u32>,
}

impl Scan<'_> {
    fn line(&mut self, line: usize, text: &str) -> Result<(), ReadError> {
        let (code, comment) = text.split_at(text.find('#').unwrap_or(text.len()));
        let mut words = code.split_whitespace();
        let keyword = words.next().unwrap_or_default();
        let words: Vec<&str> = words.collect();
        let ignored = match keyword {
            "v" => return self.vertex(line, code, &words),
            "f" => return self.face(line, code, &words),
            "l" => return self.polyline(line, code, &words),
            "" if comment.is_empty() => return Ok(()),
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

    fn vertex(&mut self, line: usize, code: &str, words: &[&str]) -> Result<(), ReadError> {
        let source = self.source;
        source.room(Place::Line(line), self.drawing.points.len(), "vertices")?;
        let number = |word: &str| source.number(line, word);
        let point = match *words {
            [x, y, z] => Point3::new(number(x)?, number(y)?, number(z)?),
            // A weight divides, three or four more numbers are a colour.
            [x, y, z, w] => Point3::new(number(x)?, number(y)?, number(z)?) / number(w)?,
            [x, y, z, _, _, _] | [x, y, z, _, _, _, _] => {
                self.drawing.notes.add(NoteKind::AttributesIgnored, 1);
                Point3::new(number(x)?, number(y)?, number(z)?)
            }
            _ => {
                let help = "a vertex is v x y z; correct the line";
                return Err(source.syntax(Place::Line(line), code, "three numbers after v", help));
            }
        };
        if !point.coords.iter().all(|c| c.is_finite()) {
            let help = "correct the weight, the fourth number";
            return Err(source.syntax(Place::Line(line), code, "a finite position", help));
        }
        self.drawing.points.push(point);
        self.drawing.point_lines.push(line);
        self.met.push(false);
        Ok(())
    }

    fn index(&self, line: usize, word: &str) -> Result<u32, ReadError> {
        // What follows a slash are a texture coordinate and a normal, which are not read.
        let vertex = word.split('/').next().unwrap_or_default();
        self.source.index(line, vertex, "vertex", self.drawing.points.len(), true)
    }

    fn face(&mut self, line: usize, code: &str, words: &[&str]) -> Result<(), ReadError> {
        self.source.room(Place::Line(line), self.faces, "faces")?;
        if words.len() < 3 {
            let help = "a face has at least 3 vertices; correct the line";
            return Err(self.source.syntax(Place::Line(line), code, "three or more indices after f", help));
        }
        self.mesh.push('f');
        for word in words {
            let index = self.index(line, word)?;
            if !std::mem::replace(&mut self.met[index as usize], true) {
                self.order.push(index);
            }
            let _ = write!(self.mesh, " {}", index + 1);
        }
        self.mesh.push('\n');
        self.faces += 1;
        Ok(())
    }

    fn polyline(&mut self, line: usize, code: &str, words: &[&str]) -> Result<(), ReadError> {
        if words.len() < 2 {
            let help = "a line has at least 2 vertices; correct the line";
            return Err(self.source.syntax(Place::Line(line), code, "two or more indices after l", help));
        }
        let ends = words.iter().map(|word| self.index(line, word)).collect::<Result<Vec<u32>, _>>()?;
        for pair in ends.windows(2) {
            self.source.room(Place::Line(line), self.drawing.edges.len(), "edges")?;
            self.drawing.edges.push((pair[0], pair[1]));
        }
        Ok(())
    }

    /// Lets `tobj` read the faces and gives them the vertices of the file.
    fn mesh(mut self) -> Result<Drawing, ReadError> {
        if self.faces == 0 {
            return Ok(self.drawing);
        }
        let mut text = String::new();
        for point in &self.drawing.points {
            let _ = writeln!(text, "v {:?} {:?} {:?}", point.x, point.y, point.z);
        }
        text.push_str(&self.mesh);
        let options = tobj::LoadOptions::default();
        let no_materials = |_: &std::path::Path| Err(tobj::LoadError::OpenFileFailed);
        let (models, _) = tobj::load_obj_buf(&mut text.as_bytes(), &options, no_materials)
            .map_err(|error| self.source.library("tobj", &error))?;
        for model in models {
            let mut corners = model.mesh.indices.iter();
            let triangles = vec![3; model.mesh.indices.len() / 3];
            let arities =
                if model.mesh.face_arities.is_empty() { &triangles } else { &model.mesh.face_arities };
            for &arity in arities {
                let face =
                    corners.by_ref().take(arity as usize).map(|&k| self.order.get(k as usize).copied());
                let face = face.collect::<Option<Vec<u32>>>();
                self.drawing
                    .faces
                    .push(face.ok_or_else(|| self.source.library("tobj", &"it counts differently"))?);
            }
        }
        Ok(self.drawing)
    }
}
