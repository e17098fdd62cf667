//! One model part of a 3MF package: its objects, and what it builds of them.

use std::cell::Cell;
use std::collections::HashMap;

use nalgebra::{Affine3, Matrix4, Point3};
use quick_xml::Reader;
use quick_xml::events::{BytesStart, Event};
use wirebend_error::ErrorRemedy;

use super::super::error::{Location, ReadError};
use super::super::note::{NoteKind, Notes};
use super::super::text::{Source, excerpt};

const HELP: ErrorRemedy = ErrorRemedy::ExportAgain;

/// An object put in, perhaps one of another part.
#[derive(Debug)]
pub(super) struct Use {
    pub(super) place: Location,
    /// The part that holds the object, if it is another one.
    pub(super) path: Option<String>,
    pub(super) object: u32,
    pub(super) map: Affine3<f64>,
}

/// A mesh with its beams, or other objects put together.
#[derive(Debug, Default)]
pub(super) struct Object {
    pub(super) points: Vec<Point3<f64>>,
    pub(super) triangles: Vec<[u32; 3]>,
    pub(super) beams: Vec<(u32, u32)>,
    pub(super) components: Vec<Use>,
}

#[derive(Debug, Default)]
pub(super) struct Part {
    /// The unit of all its lengths, in mm.
    pub(super) unit_mm: f64,
    pub(super) objects: HashMap<u32, Object>,
    pub(super) items: Vec<Use>,
}

/// Reads the text of a part.
pub(super) fn parse(text: &str, source: Source<'_>, notes: &mut Notes) -> Result<Part, ReadError> {
    let mut reader = Reader::from_str(text);
    let mut scan =
        Scan { text, source, at: 0, counted: Cell::new((0, 0)), uses: 0, part: Part::default(), open: None };
    let mut depth = 0_usize;
    loop {
        scan.at = usize::try_from(reader.buffer_position()).unwrap_or(text.len());
        let event = reader.read_event();
        match event {
            Ok(Event::Start(element)) => {
                depth += 1;
                scan.element(&element, notes)?;
            }
            Ok(Event::Empty(element)) => {
                scan.element(&element, notes)?;
                scan.close(element.local_name().as_ref());
            }
            Ok(Event::End(element)) => {
                depth = depth.saturating_sub(1);
                scan.close(element.local_name().as_ref());
            }
            Ok(Event::Eof) if depth == 0 => return Ok(scan.part),
            Ok(Event::Eof) => {
                let announced = format!("{depth} elements begin");
                return Err(source.truncated(scan.place(), announced, "they have no end".into()));
            }
            Ok(_) => {}
            Err(error) => {
                return Err(source.refused(scan.place(), &error, "a 3MF model", HELP));
            }
        }
    }
}

struct Scan<'a> {
    text: &'a str,
    source: Source<'a>,
    /// Where the element begins, in bytes.
    at: usize,
    /// How many bytes were looked at for ends of lines, and how many there were: of a large file each is looked at once.
    counted: Cell<(usize, usize)>,
    /// Components and items so far.
    uses: usize,
    part: Part,
    /// The object that is open, with its id.
    open: Option<(u32, Object)>,
}

impl Scan<'_> {
    fn place(&self) -> Location {
        let (from, lines) = self.counted.get();
        let passed = self.text.get(from..self.at).unwrap_or_default();
        let lines = lines + passed.matches('\n').count();
        let at = from + passed.len();
        self.counted.set((at, lines));
        // The element stands behind the white space before it.
        let rest = self.text.get(at..).unwrap_or_default();
        let blank = &rest[..rest.len() - rest.trim_start().len()];
        Location::Line(lines + blank.matches('\n').count() + 1)
    }

    fn element(&mut self, element: &BytesStart<'_>, notes: &mut Notes) -> Result<(), ReadError> {
        let name = element.local_name();
        match (name.as_ref(), &self.open) {
            ("model", _) => self.part.unit_mm = self.unit(element)?,
            ("object", _) => self.open = Some((self.id(element, "id")?, Object::default())),
            ("vertex", Some(_)) => self.vertex(element)?,
            ("triangle", Some(_)) => self.triangle(element)?,
            ("beam", Some(_)) => self.beam(element)?,
            ("component", Some(_)) => {
                let component = self.put_in(element)?;
                if let Some((_, object)) = &mut self.open {
                    object.components.push(component);
                }
            }
            ("item", None) => {
                let item = self.put_in(element)?;
                self.part.items.push(item);
            }
            (
                "resources" | "build" | "mesh" | "vertices" | "triangles" | "components" | "beamlattice"
                | "beams",
                _,
            ) => {}
            ("metadata" | "metadatagroup", _) => notes.add(NoteKind::CommentsIgnored, 1),
            ("base" | "color" | "tex2coord" | "composite" | "multi" | "texture2d", _) => {
                notes.add(NoteKind::AttributesIgnored, 1);
            }
            (
                "basematerials" | "colorgroup" | "texture2dgroup" | "compositematerials" | "multiproperties",
                _,
            ) => {
                notes.add(NoteKind::NamesIgnored, 1);
            }
            _ => notes.add(NoteKind::StatementsIgnored, 1),
        }
        Ok(())
    }

    fn close(&mut self, name: &str) {
        if name == "object"
            && let Some((id, object)) = self.open.take()
        {
            self.part.objects.insert(id, object);
        }
    }

    /// The value of an attribute, whatever its prefix.
    fn attribute(&self, element: &BytesStart<'_>, name: &str) -> Result<Option<String>, ReadError> {
        for attribute in element.attributes() {
            let attribute = attribute.map_err(|error| {
                self.source.refused(self.place(), &error, "an attribute and its value", HELP)
            })?;
            if attribute.key.local_name().as_ref() == name {
                return Ok(Some(attribute.value.into_owned()));
            }
        }
        Ok(None)
    }

    fn needed(&self, element: &BytesStart<'_>, name: &str) -> Result<String, ReadError> {
        self.attribute(element, name)?.ok_or_else(|| {
            let found = format!("{} without {name}", element.local_name().as_ref());
            self.source.syntax(self.place(), &found, format!("an attribute {name}"), HELP)
        })
    }

    fn number(&self, text: &str) -> Result<f64, ReadError> {
        text.trim().parse().ok().filter(|number: &f64| number.is_finite()).ok_or_else(|| ReadError::Number {
            file: self.source.name.to_owned(),
            place: self.place(),
            found: excerpt(text),
            expected: "finite number",
        })
    }

    fn id(&self, element: &BytesStart<'_>, name: &str) -> Result<u32, ReadError> {
        let text = self.needed(element, name)?;
        text.trim().parse().map_err(|_| ReadError::Number {
            file: self.source.name.to_owned(),
            place: self.place(),
            found: excerpt(&text),
            expected: "whole number",
        })
    }

    fn unit(&self, element: &BytesStart<'_>) -> Result<f64, ReadError> {
        let unit = self.attribute(element, "unit")?;
        Ok(match unit.as_deref() {
            Some("micron") => 1e-3,
            Some("millimeter") | None => 1.0,
            Some("centimeter") => 10.0,
            Some("meter") => 1e3,
            Some("inch") => 25.4,
            Some("foot") => 304.8,
            Some(other) => {
                let expected = "a unit: micron, millimeter, centimeter, meter, inch or foot";
                return Err(self.source.syntax(self.place(), other, expected, HELP));
            }
        })
    }

    fn vertex(&mut self, element: &BytesStart<'_>) -> Result<(), ReadError> {
        let axis = |name| self.number(&self.needed(element, name)?);
        let point = Point3::new(axis("x")?, axis("y")?, axis("z")?);
        let count = self.open.as_ref().map_or(0, |(_, object)| object.points.len());
        self.room(count, "vertices")?;
        if let Some((_, object)) = &mut self.open {
            object.points.push(point);
        }
        Ok(())
    }

    /// Does not look for the line unless it has to.
    fn room(&self, count: usize, what: &'static str) -> Result<(), ReadError> {
        self.source.room(Location::File, count, what).or_else(|_| self.source.room(self.place(), count, what))
    }

    /// An index of a vertex that stands before, from 0.
    fn corner(&self, element: &BytesStart<'_>, name: &str) -> Result<u32, ReadError> {
        let index = self.id(element, name)?;
        let count = self.open.as_ref().map_or(0, |(_, object)| object.points.len());
        if (index as usize) < count {
            return Ok(index);
        }
        let have = format!("they count from 0 and there are {count}");
        let (file, place, found) = (self.source.name.to_owned(), self.place(), index.to_string());
        Err(ReadError::Index { file, place, found, what: "vertex", have })
    }

    fn triangle(&mut self, element: &BytesStart<'_>) -> Result<(), ReadError> {
        let corner = |name| self.corner(element, name);
        let corners = [corner("v1")?, corner("v2")?, corner("v3")?];
        self.room(self.open.as_ref().map_or(0, |(_, object)| object.triangles.len()), "triangles")?;
        if let Some((_, object)) = &mut self.open {
            object.triangles.push(corners);
        }
        Ok(())
    }

    fn beam(&mut self, element: &BytesStart<'_>) -> Result<(), ReadError> {
        let ends = (self.corner(element, "v1")?, self.corner(element, "v2")?);
        self.room(self.open.as_ref().map_or(0, |(_, object)| object.beams.len()), "edges")?;
        if let Some((_, object)) = &mut self.open {
            object.beams.push(ends);
        }
        Ok(())
    }

    fn put_in(&mut self, element: &BytesStart<'_>) -> Result<Use, ReadError> {
        let (place, what) = (self.place(), "components and items");
        self.source.room_within(place.clone(), self.uses, what)?;
        self.uses += 1;
        let object = self.id(element, "objectid")?;
        let path = self.attribute(element, "path")?;
        let map = match self.attribute(element, "transform")? {
            Some(text) => self.transform(&text)?,
            None => Affine3::identity(),
        };
        Ok(Use { place, path, object, map })
    }

    /// Twelve numbers: the images of x, y and z, and of the origin.
    fn transform(&self, text: &str) -> Result<Affine3<f64>, ReadError> {
        let numbers =
            text.split_whitespace().map(|word| self.number(word)).collect::<Result<Vec<f64>, _>>()?;
        if numbers.len() != 12 {
            return Err(self.source.syntax(self.place(), text, "a transform of twelve numbers", HELP));
        }
        let mut matrix = Matrix4::identity();
        for (k, number) in numbers.into_iter().enumerate() {
            matrix[(k % 3, k / 3)] = number;
        }
        Ok(Affine3::from_matrix_unchecked(matrix))
    }
}
