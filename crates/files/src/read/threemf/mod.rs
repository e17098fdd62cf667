//! 3MF: a stencil of all objects that the model builds; the beams of a lattice are a wireframe.
//!
//! A package is an archive with XML in it. Objects may be put together from others, also of other parts of the
//! package, as slicers write them. Axes are right-handed with z up, as in the file.

mod part;

use std::collections::HashMap;
use std::io::{Cursor, Read as _};

use nalgebra::Affine3;
use quick_xml::Reader;
use quick_xml::events::Event;
use zip::ZipArchive;

use self::part::{Part, Use, parse};
use super::Imported;
use super::drawing::Drawing;
use super::error::{Location, ReadError};
use super::format::Format;
use super::note::NoteKind;
use super::options::ReadOptions;
use super::text::{Source, decode, excerpt};
use wirebend_error::ErrorRemedy;

/// How many bytes a package may hold once it is unpacked: as large a file as is read of a mesh.
const MAX_UNPACKED: u64 = 512 << 20;
/// How deep objects may hold objects.
const MAX_DEPTH: usize = 64;
/// Where the model is if the package does not say.
const USUAL_PART: &str = "3D/3dmodel.model";

/// Reads the objects that are built, each where it is put.
pub(super) fn read(bytes: &[u8], source: Source<'_>, options: &ReadOptions) -> Result<Imported, ReadError> {
    let archive = ZipArchive::new(Cursor::new(bytes)).map_err(|error| {
        let remedy = ErrorRemedy::ExportAgain;
        source.refused(Location::File, &error, "a 3MF package, which is a zip archive", remedy)
    })?;
    let mut package =
        Package { archive, source, left: MAX_UNPACKED, parts: HashMap::new(), drawing: Drawing::default() };
    let first = package.first_part()?;
    let model = package.take_part(&first)?;
    package.drawing.unit_mm = Some(model.unit_mm);
    if model.items.is_empty() {
        return Err(source.empty("objects to build", &package.drawing.notes));
    }
    let mut assembly = Assembly { package, open: Vec::new(), met: 0 };
    assembly.package.parts.insert(first.clone(), model);
    let items = assembly.package.parts.get_mut(&first).map(|part| std::mem::take(&mut part.items));
    for item in items.unwrap_or_default() {
        assembly.put(&first, &item, &Affine3::identity())?;
    }
    assembly.package.drawing.finish(Format::ThreeMf, source, options)
}

/// The archive, and the parts that were read.
struct Package<'a> {
    archive: ZipArchive<Cursor<&'a [u8]>>,
    source: Source<'a>,
    /// How many bytes may still be unpacked.
    left: u64,
    parts: HashMap<String, Part>,
    drawing: Drawing,
}

impl Package<'_> {
    /// The bytes of a part; none where there is no such part.
    fn unpack(&mut self, name: &str) -> Result<Option<Vec<u8>>, ReadError> {
        // Names of parts are the same in capitals.
        let index = self.archive.index_for_name(name).or_else(|| {
            let same = |index: &usize| {
                matches!(self.archive.name_for_index(*index), Some(Ok(own)) if own.eq_ignore_ascii_case(name))
            };
            (0..self.archive.len()).find(same)
        });
        let Some(index) = index else { return Ok(None) };
        let refuse = |message: &str| {
            let found = format!("{name}: {message}");
            let remedy = ErrorRemedy::ExportWithout { part: "a password".to_owned() };
            self.source.refused(Location::File, &found, "a part that can be unpacked", remedy)
        };
        let file = self.archive.by_index(index).map_err(|error| refuse(&error.to_string()))?;
        let mut bytes = Vec::new();
        // What an archive says of a size is not believed.
        file.take(self.left + 1).read_to_end(&mut bytes).map_err(|error| refuse(&error.to_string()))?;
        let Some(left) = self.left.checked_sub(bytes.len() as u64) else {
            let file = self.source.name.to_owned();
            return Err(ReadError::TooLarge { file, bytes: MAX_UNPACKED + 1, limit: MAX_UNPACKED });
        };
        self.left = left;
        Ok(Some(bytes))
    }

    /// The part that the package names as its model.
    fn first_part(&mut self) -> Result<String, ReadError> {
        let bytes = self.unpack("_rels/.rels")?.unwrap_or_default();
        let text = decode(&bytes);
        let mut reader = Reader::from_str(&text);
        while let Ok(event) = reader.read_event() {
            let element = match &event {
                Event::Start(element) | Event::Empty(element) => element,
                Event::Eof => break,
                _ => continue,
            };
            let value = |name: &str| {
                let mut all = element.attributes().filter_map(Result::ok);
                all.find(|attribute| attribute.key.local_name().as_ref() == name).map(|found| found.value)
            };
            if let (true, Some(target)) =
                (value("Type").is_some_and(|kind| kind.ends_with("/3dmodel")), value("Target"))
            {
                return Ok(part_name(&target));
            }
        }
        Ok(USUAL_PART.to_owned())
    }

    fn take_part(&mut self, name: &str) -> Result<Part, ReadError> {
        let Some(bytes) = self.unpack(name)? else {
            let (found, remedy) = (format!("no part {name}"), ErrorRemedy::CheckRightFile);
            return Err(self.source.syntax(Location::File, &found, "a package with a model", remedy));
        };
        let inner = format!("{} ({name})", self.source.name);
        parse(&decode(&bytes), Source { name: &inner }, &mut self.drawing.notes)
    }
}

fn part_name(path: &str) -> String {
    path.trim_start_matches('/').to_owned()
}

/// Puts objects where they are built.
struct Assembly<'a> {
    package: Package<'a>,
    /// The objects that are open, by part and id.
    open: Vec<(String, u32)>,
    /// Objects put in: objects of objects can be many.
    met: usize,
}

impl Assembly<'_> {
    fn put(&mut self, part: &str, put: &Use, map: &Affine3<f64>) -> Result<(), ReadError> {
        let source = self.package.source;
        let part = put.path.as_deref().map_or_else(|| part.to_owned(), part_name);
        let file = || format!("{} ({part})", source.name);
        source.room_within(put.place.clone(), self.met, "objects, with those within")?;
        self.met += 1;
        if !self.package.parts.contains_key(&part) {
            let read = self.package.take_part(&part)?;
            self.package.parts.insert(part.clone(), read);
        }
        let key = (part.clone(), put.object);
        if self.open.contains(&key) {
            let (place, name) = (put.place.clone(), put.object.to_string());
            return Err(ReadError::Loop { file: file(), place, what: "object", name });
        }
        if self.open.len() == MAX_DEPTH {
            let (place, what) = (put.place.clone(), "objects in objects are");
            return Err(ReadError::TooDeep { file: file(), place, what, limit: MAX_DEPTH });
        }
        // Taken out while it is worked on, since the objects within are looked up in the same place.
        let object = self.package.parts.get_mut(&part).and_then(|part| part.objects.remove(&put.object));
        let Some(object) = object else {
            let have = self.package.parts.get(&part).map_or(0, |part| part.objects.len());
            let (place, found) = (put.place.clone(), excerpt(&put.object.to_string()));
            let have = format!("the part has {have}");
            return Err(ReadError::Index { file: file(), place, found, what: "object", have });
        };
        let map = map * put.map;
        self.mesh(&object, &map, &put.place)?;
        self.open.push(key);
        for component in &object.components {
            self.package.drawing.notes.add(NoteKind::BlocksExploded, 1);
            self.put(&part, component, &map)?;
        }
        self.open.pop();
        self.package.parts.entry(part).or_default().objects.insert(put.object, object);
        Ok(())
    }

    fn mesh(&mut self, object: &part::Object, map: &Affine3<f64>, place: &Location) -> Result<(), ReadError> {
        let (source, drawing) = (self.package.source, &mut self.package.drawing);
        source.room(place.clone(), drawing.points.len() + object.points.len(), "vertices")?;
        source.room(place.clone(), drawing.faces.len() + object.triangles.len(), "triangles")?;
        source.room(place.clone(), drawing.edges.len() + object.beams.len(), "edges")?;
        let first = u32::try_from(drawing.points.len()).unwrap_or(u32::MAX);
        drawing.points.extend(object.points.iter().map(|point| map * point));
        // A mirror image has its faces turned over, so that they look outwards again.
        let mirrored = map.matrix().fixed_view::<3, 3>(0, 0).determinant() < 0.0;
        drawing.faces.extend(object.triangles.iter().map(|&[a, b, c]| {
            let corners = if mirrored { [a, c, b] } else { [a, b, c] };
            corners.map(|corner| first + corner).to_vec()
        }));
        drawing.edges.extend(object.beams.iter().map(|&(a, b)| (first + a, first + b)));
        Ok(())
    }
}
