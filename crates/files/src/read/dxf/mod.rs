//! DXF, ASCII or binary: the lines and curves of a drawing.
//!
//! LINE, LWPOLYLINE, POLYLINE (plane and in space, with bulges), ARC, CIRCLE, ELLIPSE, SPLINE and HELIX are read,
//! in blocks, too; 3DFACE and the meshes of POLYLINE are a stencil. All else is counted. The groups are read here and not by a crate, since those that there are drop
//! what they do not know in silence and cannot name the line of a wrong number.
//!
//! Coordinates are right-handed with z up, as in the file. Entities with an extrusion have axes of their own: one of
//! 0, 0, -1 mirrors x.

mod blocks;
mod entity;
mod faces;
mod fit;
mod letters;
mod pairs;
mod record;
mod shape;
mod skin;
mod spline;

use nalgebra::{Affine3, Point3};

use self::blocks::{Block, Content, Entity, Plotter};
use self::entity::{Corner, affine, bulged, shape};
use self::faces::{Head, Mesh};
use self::letters::Letters;
use self::pairs::{BINARY, Pairs};
use self::record::{Record, Records};
use self::shape::Shape;
use super::Imported;
use super::drawing::Drawing;
use super::error::{Location, ReadError};
use super::format::Format;
use super::note::NoteKind;
use super::options::ReadOptions;
use super::outline::{Outline, Pen};
use super::text::{Source, lines};
use wirebend_error::ErrorRemedy;

/// Whether the bytes begin as every binary file does.
pub(super) fn is_binary(bytes: &[u8]) -> bool {
    bytes.starts_with(BINARY)
}

/// Whether a text begins with a section, behind comments.
pub(super) fn looks_like(text: &str) -> bool {
    let mut lines = lines(text).map(|(_, line)| line.trim());
    loop {
        match (lines.next(), lines.next()) {
            (Some("999"), Some(_)) => {}
            (code, value) => return code == Some("0") && value == Some("SECTION"),
        }
    }
}

/// Reads a drawing; what is in no section of entities or blocks is looked at for units and layers only.
pub(super) fn read(bytes: &[u8], source: Source<'_>, options: &ReadOptions) -> Result<Imported, ReadError> {
    let letters = Letters::of(bytes);
    let text = if is_binary(bytes) { "".into() } else { letters.text(bytes) };
    let pairs =
        if is_binary(bytes) { Pairs::binary(bytes, letters, source) } else { Pairs::text(&text, source) };
    let mut records = Records::new(source, pairs)?;
    let mut scan = Scan::new(source, options.units.is_some());
    while let Some(record) = records.next()? {
        if record.kind == "EOF" {
            break;
        }
        scan.record(&record)?;
    }
    let content = scan.finish()?;
    let drawing = Drawing { unit_mm: scan.unit_mm, ..Drawing::default() };
    let pen = Pen::new(source, drawing, options);
    let mut plotter = Plotter::new(pen, &content, &options.layers)?;
    plotter.draw(&content.entities, &Affine3::identity(), None)?;
    plotter.finish()?.finish(Format::Dxf, source, options)
}

/// Millimetres of the values of `$INSUNITS`; 0 is no unit.
fn unit_mm(value: i64) -> Option<f64> {
    const UNITS: [f64; 17] = [
        0.0,
        25.4,
        304.8,
        1_609_344.0,
        1.0,
        10.0,
        1e3,
        1e6,
        25.4e-6,
        25.4e-3,
        914.4,
        1e-7,
        1e-6,
        1e-3,
        1e2,
        1e4,
        1e5,
    ];
    // The foot of the United States' surveys is 1200/3937 m.
    let survey = (value == 21).then_some(1.2e6 / 3937.0);
    usize::try_from(value).ok().and_then(|value| UNITS.get(value).copied()).or(survey)
}

/// Goes through the records of a file.
struct Scan<'a> {
    source: Source<'a>,
    /// The section, in upper case, and where it began.
    section: Option<(String, Location)>,
    unit_mm: Option<f64>,
    /// Whether the user gave the unit, so that an unknown one in the file is no error.
    unit_given: bool,
    content: Content,
    /// The block that is open: its name and itself.
    block: Option<(String, Block)>,
    /// The polyline whose vertices follow.
    polyline: Option<Polyline>,
    count: usize,
}

/// A polyline of old: the entity that it becomes, and its vertices so far.
struct Polyline {
    entity: Entity,
    corners: Vec<Corner>,
    /// What it is instead of a line.
    mesh: Option<Mesh>,
    closed: bool,
    in_space: bool,
    map: Affine3<f64>,
    elevation: f64,
}

impl<'a> Scan<'a> {
    fn new(source: Source<'a>, unit_given: bool) -> Self {
        Self {
            source,
            section: None,
            unit_mm: None,
            unit_given,
            content: Content::default(),
            block: None,
            polyline: None,
            count: 0,
        }
    }

    fn record(&mut self, record: &Record<'_>) -> Result<(), ReadError> {
        match record.kind.as_str() {
            "SECTION" => return self.begin(record),
            "ENDSEC" => {
                self.end_polyline();
                self.end_block();
                self.section = None;
                return Ok(());
            }
            _ => {}
        }
        match self.section.as_ref().map(|(name, _)| name.as_str()) {
            Some("TABLES") if record.kind == "LAYER" => self.layer(record),
            Some("BLOCKS") => match record.kind.as_str() {
                "BLOCK" => {
                    self.end_block();
                    let name = record.name(2).ok_or_else(|| record.lacks(2))?;
                    // A block of 4 is another file, one of 8 laid over.
                    let (base, elsewhere) = (record.point(10)?, record.flag(4 | 8)?);
                    self.block = Some((name, Block { base, elsewhere, entities: Vec::new() }));
                    Ok(())
                }
                "ENDBLK" => {
                    self.end_polyline();
                    self.end_block();
                    Ok(())
                }
                _ => self.entity(record),
            },
            Some("ENTITIES") => self.entity(record),
            _ => Ok(()),
        }
    }

    fn begin(&mut self, record: &Record<'_>) -> Result<(), ReadError> {
        let name = record.text(2).ok_or_else(|| record.lacks(2))?.to_ascii_uppercase();
        if name == "HEADER" {
            let mut pairs = record.pairs.iter();
            let variable = pairs.find(|pair| pair.code == 9 && pair.text() == "$INSUNITS");
            if let (Some(_), Some(value)) = (variable, pairs.next()) {
                let unit = unit_mm(value.whole(self.source)?);
                if unit.is_none() && !self.unit_given {
                    let remedy = ErrorRemedy::ChooseUnit;
                    let (place, expected) = (value.place.clone(), "a unit from 1 to 16, 21 or 0 for none");
                    return Err(self.source.syntax(place, &value.text(), expected, remedy));
                }
                self.unit_mm = unit.filter(|unit| *unit > 0.0);
            }
        }
        self.section = Some((name, record.place.clone()));
        Ok(())
    }

    /// A negative colour is a layer that is off, a flag of 1 one that is frozen.
    fn layer(&mut self, record: &Record<'_>) -> Result<(), ReadError> {
        let name = record.name(2).ok_or_else(|| record.lacks(2))?;
        let on = record.whole(62)?.unwrap_or(7) >= 0 && !record.flag(1)?;
        self.content.layers.insert(name, on);
        Ok(())
    }

    fn entity(&mut self, record: &Record<'_>) -> Result<(), ReadError> {
        self.source.room(record.place.clone(), self.count, "entities")?;
        self.count += 1;
        match (record.kind.as_str(), &mut self.polyline) {
            ("VERTEX", Some(polyline)) => {
                if let Err(error) = polyline.vertex(record) {
                    polyline.broken(error);
                }
                return Ok(());
            }
            ("SEQEND", _) => {
                self.end_polyline();
                return Ok(());
            }
            _ => self.end_polyline(),
        }
        let paper = record.whole(67)? == Some(1);
        let invisible = record.whole(60)? == Some(1);
        let hidden = if paper { Some(NoteKind::PaperIgnored) } else { None };
        let hidden = hidden.or(invisible.then_some(NoteKind::HiddenIgnored));
        let layer = record.name(8).unwrap_or_else(|| "0".to_owned());
        let place = record.place.clone();
        if record.kind != "POLYLINE" {
            let shape = shape(record);
            self.put(Entity { place, layer, hidden, shape });
            return Ok(());
        }
        // A polyline without vertices is counted as a point.
        let entity = Entity { place, layer, hidden, shape: Shape::Ignored(NoteKind::PointsIgnored) };
        self.polyline = Some(Polyline::new(record, entity));
        Ok(())
    }

    fn put(&mut self, entity: Entity) {
        match &mut self.block {
            Some((_, block)) => block.entities.push(entity),
            // Nothing stands between blocks but what belongs to none.
            None => self.content.entities.push(entity),
        }
    }

    fn end_polyline(&mut self) {
        if let Some(polyline) = self.polyline.take() {
            self.put(polyline.finish(self.source));
        }
    }

    fn end_block(&mut self) {
        if let Some((name, block)) = self.block.take() {
            self.content.blocks.insert(name, block);
        }
    }

    /// # Errors
    /// [`ReadError::Truncated`] when a section has no end.
    fn finish(&mut self) -> Result<Content, ReadError> {
        if let Some((name, place)) = &self.section {
            let announced = format!("section {name} begins");
            return Err(self.source.truncated(place.clone(), announced, "it has no ENDSEC".into()));
        }
        Ok(std::mem::take(&mut self.content))
    }
}

impl Polyline {
    fn new(record: &Record<'_>, entity: Entity) -> Self {
        let (map, corners) = (Affine3::identity(), Vec::new());
        let mut polyline =
            Self { entity, corners, mesh: None, closed: false, in_space: false, map, elevation: 0.0 };
        if let Err(error) = polyline.begin(record) {
            polyline.broken(error);
        }
        polyline
    }

    fn begin(&mut self, record: &Record<'_>) -> Result<(), ReadError> {
        self.mesh = Mesh::of(record)?;
        (self.closed, self.in_space) = (record.flag(1)?, record.flag(8)?);
        if !self.in_space && self.mesh.is_none() {
            self.map = affine(&record.axes()?);
        }
        self.elevation = record.real(30)?.unwrap_or_default();
        Ok(())
    }

    /// The first error is reported if its entity is drawn.
    fn broken(&mut self, error: ReadError) {
        if !matches!(self.entity.shape, Shape::Broken(_)) {
            self.entity.shape = Shape::broken(error);
        }
    }

    /// Vertices of 16 steer a curve that others, of 8, follow.
    fn vertex(&mut self, record: &Record<'_>) -> Result<(), ReadError> {
        if let Some(mesh) = &mut self.mesh {
            return mesh.vertex(record);
        }
        if record.flag(16)? {
            return Ok(());
        }
        let point = record.point(10)?;
        let z = if self.in_space { point.z } else { self.elevation };
        self.corners.push((Point3::new(point.x, point.y, z), record.real(42)?.unwrap_or_default()));
        Ok(())
    }

    fn finish(mut self, source: Source<'_>) -> Entity {
        if matches!(self.entity.shape, Shape::Broken(_)) {
            return self.entity;
        }
        if let Some(mesh) = self.mesh {
            let head = Head { source, place: self.entity.place.clone() };
            self.entity.shape = mesh.finish(&head).unwrap_or_else(Shape::broken);
            return self.entity;
        }
        let outline = if self.in_space {
            Outline::polyline(self.corners.iter().map(|(point, _)| *point), self.closed)
        } else {
            bulged(&self.corners, self.closed)
        };
        if let Some(outline) = outline {
            self.entity.shape = Shape::Outline(outline.mapped(&self.map));
        }
        self.entity
    }
}
