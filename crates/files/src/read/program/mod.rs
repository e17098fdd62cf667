//! Programs of other tools: from commands to steps, and from steps to the wireframe they make.

pub(super) mod kit;
pub(super) mod lra;
pub(super) mod moves;
mod path;
pub(super) mod pensa;
mod rounding;

use nalgebra::Point3;
use wirebend_core::bend::{Convention, Frame, NominalProgram, Step, replay};
use wirebend_core::units::{Angle, Length};
use wirebend_core::wireframe::VertexId;
use wirebend_error::ErrorRemedy;

pub use self::path::{PathWireframe, wireframe_of_path};
pub(crate) use self::rounding::Rounding;
use super::Imported;
use super::error::{Location, MOST_BEND_DEG, ReadError};
use super::format::Format;
use super::note::{NoteKind, Notes};
use super::options::ReadOptions;
use super::text::{Source, last_place};

/// A program as its file wrote it, and the path that it makes.
#[derive(Debug, Clone, PartialEq)]
pub struct ImportedProgram {
    /// The steps, with feeds from corner to corner, in our signs. A feed of 0 stands between two
    /// bends that follow one another.
    pub program: NominalProgram,
    /// Where the wire goes, in mm: the start, then the end of each feed. Starts at the origin
    /// along x; the first bend without a rotation before it turns towards y.
    pub path: Vec<Point3<f64>>,
    /// The path as vertices of the wireframe, without repeats in a row.
    pub traversal: Vec<VertexId>,
    /// Whether a comment says that a driver of this program wrote it: then it is what a machine was told, compensated
    /// and in the machine's signs.
    pub told: bool,
    /// Id of the machine that it is of, where its file says so: then it is in canonical signs.
    pub machine: Option<String>,
    /// So near corners of it are one: as was asked for, or as far as rounded figures miss.
    pub weld: Length,
}

/// Whether a comment is the first line of what drivers write for a machine: the hash of the design.
fn names_design(comment: &str) -> bool {
    let words: Vec<&str> = comment.split_whitespace().collect();
    matches!(words.as_slice(), ["design", hash] if hash.len() == 64 && hash.bytes().all(|b| b.is_ascii_hexdigit()))
}

/// Puts single commands together into steps, whatever their order.
///
/// Rotations add up until a bend uses them; a rotation and a feed may change places, since both
/// are along the tangent. A bend ends a step, so two bends in a row give a step with a feed of 0.
#[derive(Debug, Default)]
pub(crate) struct Commands {
    steps: Vec<Step>,
    lines: Vec<usize>,
    bent_in: Vec<Option<usize>>,
    step: Step,
    /// Whether `step` holds a feed already.
    fed: bool,
    /// As [`ImportedProgram::told`].
    told: bool,
    rounding: Rounding,
    /// What the last digit of feeds stands for, in the unit of the file.
    place: f64,
}

/// The steps of a program, the line of each, and how its figures are rounded.
#[derive(Debug, Default)]
pub(crate) struct Written {
    pub(crate) steps: Vec<Step>,
    /// None where the file has none.
    pub(crate) lines: Vec<usize>,
    /// The line of the bend of each, where that is another.
    pub(crate) bent_in: Vec<Option<usize>>,
    pub(crate) rounding: Rounding,
}

impl Commands {
    fn close(&mut self) {
        self.steps.push(std::mem::take(&mut self.step));
        self.fed = false;
    }

    fn note_line(&mut self, line: usize) {
        if self.lines.len() == self.steps.len() {
            self.lines.push(line);
        }
    }

    pub(crate) fn feed(&mut self, line: usize, feed: Length) {
        if self.fed {
            self.close();
        }
        self.note_line(line);
        self.step.feed = feed;
        self.fed = true;
    }

    pub(crate) fn rotate(&mut self, line: usize, angle: Angle) {
        self.note_line(line);
        self.step.rotate += angle;
    }

    pub(crate) fn bend(&mut self, line: usize, angle: Angle) {
        self.note_line(line);
        self.step.bend = angle;
        self.bent_in.resize(self.steps.len(), None);
        self.bent_in.push(Some(line));
        self.close();
    }

    /// A feed as it is written, in mm after `factor`.
    pub(crate) fn read_feed(
        &mut self,
        source: Source<'_>,
        line: usize,
        word: &str,
        factor: f64,
    ) -> Result<(), ReadError> {
        self.feed(line, feed_of(source, line, word, factor)?);
        let place = last_place(word);
        if self.rounding.length_mm <= 0.0 || place < self.place {
            (self.place, self.rounding.length_mm) = (place, place * factor);
        }
        Ok(())
    }

    /// A rotation or a bend as it is written, in degrees.
    pub(crate) fn read_angle(
        &mut self,
        source: Source<'_>,
        line: usize,
        word: &str,
        take: fn(&mut Self, usize, Angle),
    ) -> Result<(), ReadError> {
        take(self, line, angle_of(source, line, word)?);
        let (place, known) = (last_place(word), &mut self.rounding.angle_deg);
        *known = if *known > 0.0 { known.min(place) } else { place };
        Ok(())
    }

    pub(crate) fn len(&self) -> usize {
        self.steps.len()
    }

    /// A comment, which may say who wrote the program.
    pub(crate) fn comment(&mut self, text: &str) {
        self.told |= names_design(text);
    }

    /// Whether a driver of this program wrote it.
    pub(crate) const fn told(&self) -> bool {
        self.told
    }

    /// The steps and the line of each. A rotation that no bend follows is dropped and counted.
    pub(crate) fn finish(mut self, notes: &mut Notes) -> Written {
        // Angles that happen to be whole are no rounder than the feeds.
        self.rounding.angle_deg = self.rounding.angle_deg.min(self.place);
        if self.step.rotate != Angle::ZERO {
            notes.add(NoteKind::RotationsUnused, 1);
            self.step.rotate = Angle::ZERO;
        }
        if self.fed {
            self.close();
        }
        Written { steps: self.steps, lines: self.lines, bent_in: self.bent_in, rounding: self.rounding }
    }
}

impl Written {
    /// The same in our signs, from those of a machine.
    fn counted(self, convention: Convention) -> Self {
        let steps = self.steps.into_iter().map(|step| convention.apply(step)).collect();
        Self { steps, ..self }
    }
}

/// A feed of 0 or more, in mm after `factor`.
fn feed_of(source: Source<'_>, line: usize, word: &str, factor: f64) -> Result<Length, ReadError> {
    let value = source.number(line, word)?;
    let refuse = || {
        let remedy = ErrorRemedy::CorrectFile;
        source.syntax(Location::Line(line), word, "a feed of 0 or more", remedy)
    };
    if value < 0.0 {
        return Err(refuse());
    }
    Length::from_mm(value * factor).map_err(|_| refuse())
}

/// An angle, from degrees.
fn angle_of(source: Source<'_>, line: usize, word: &str) -> Result<Angle, ReadError> {
    let value = source.number(line, word)?;
    Ok(Angle::from_deg(value).unwrap_or_default())
}

/// Replays steps and makes the wireframe.
pub(crate) fn finish(
    format: Format,
    source: Source<'_>,
    options: &ReadOptions,
    Written { steps, lines, bent_in, rounding }: Written,
    told: bool,
    mut notes: Notes,
) -> Result<Imported, ReadError> {
    if steps.iter().all(|step| step.feed == Length::ZERO) {
        return Err(source.empty("feed of more than 0", &notes));
    }
    // As a corner it would be a smaller bend to the other side. How far an axis was told to go is another matter.
    let beyond = |step: &Step| !(told || options.commanded) && step.bend.abs().deg() > MOST_BEND_DEG;
    if let Some(index) = steps.iter().position(beyond) {
        let line = bent_in.get(index).copied().flatten().or_else(|| lines.get(index).copied());
        let place = line.map_or(Location::Item("step", index + 1), Location::Line);
        return Err(ReadError::NoCorner {
            file: source.name.to_owned(),
            place,
            bend_deg: steps[index].bend.deg(),
        });
    }
    if steps.last().is_some_and(|step| step.bend != Angle::ZERO) {
        notes.add(NoteKind::EndsOnBend, 1);
    }
    let path = replay(Frame::default(), &steps);
    // Rounded figures lead past the corners to which they come back, unless a person says what is one.
    let misses = Length::from_mm(rounding.misses(&path)).unwrap_or_default();
    let weld =
        if options.weld == ReadOptions::default().weld { options.weld.max(misses) } else { options.weld };
    let PathWireframe { wireframe, traversal, corners } =
        wireframe_of_path(&path, weld).map_err(|(point, error)| {
            let line = lines.get(point.saturating_sub(1)).copied();
            let place = line.map_or(Location::Item("point", point), Location::Line);
            ReadError::Wireframe { file: source.name.to_owned(), place, error }
        })?;
    notes.add(NoteKind::VerticesMerged, path.len().saturating_sub(corners));
    let merged = (traversal.len().saturating_sub(1)).saturating_sub(wireframe.edge_count());
    notes.add(NoteKind::EdgesMerged, merged);
    let program = ImportedProgram {
        program: NominalProgram::from_steps(steps),
        path,
        traversal,
        told,
        machine: None,
        weld,
    };
    Ok(Imported {
        format,
        wireframe,
        stencil: None,
        program: Some(program),
        frame: None,
        document: None,
        layers: Vec::new(),
        curves: None,
        notes: notes.into_vec(),
    })
}
