//! Numbers out of buffers, each range checked before anything is made for it.

use nalgebra::Point3;
use wirebend_error::ErrorRemedy;

use super::super::beside::Beside;
use super::super::error::{Location, ReadError};
use super::super::text::Source;
use super::file::{Accessor, EMBEDDED, Root, embedded};

const HELP: ErrorRemedy = ErrorRemedy::ExportAgain;

/// The buffers of a file, decoded when they are first used.
pub(super) struct Data<'a> {
    pub(super) source: Source<'a>,
    pub(super) root: &'a Root,
    binary: Option<&'a [u8]>,
    beside: Beside<'a>,
    decoded: Vec<Option<Vec<u8>>>,
}

/// How numbers lie in bytes.
#[derive(Clone, Copy)]
struct Layout {
    /// One of the format's codes.
    component: u32,
    normalized: bool,
    /// How many numbers an entry has.
    width: usize,
}

impl<'a> Data<'a> {
    pub(super) fn new(
        source: Source<'a>,
        root: &'a Root,
        binary: Option<&'a [u8]>,
        beside: Beside<'a>,
    ) -> Self {
        Self { source, root, binary, beside, decoded: root.buffers.iter().map(|_| None).collect() }
    }

    /// An entry of a list of the file.
    pub(super) fn get<T>(&self, list: &'a [T], index: usize, what: &'static str) -> Result<&'a T, ReadError> {
        list.get(index).ok_or_else(|| ReadError::Index {
            file: self.source.name.to_owned(),
            place: Location::File,
            found: index.to_string(),
            what,
            have: format!("they count from 0 and there are {}", list.len()),
        })
    }

    /// How many entries an accessor has.
    pub(super) fn count(&self, accessor: usize) -> Result<usize, ReadError> {
        Ok(self.get(&self.root.accessors, accessor, "accessor")?.count)
    }

    /// Positions, in the numbers of the file.
    pub(super) fn points(&mut self, index: usize) -> Result<Vec<Point3<f64>>, ReadError> {
        let numbers = self.numbers(index, "VEC3", 3)?;
        let points: Vec<Point3<f64>> = numbers.chunks_exact(3).map(Point3::from_slice).collect();
        match points.iter().position(|point| !point.coords.iter().all(|c| c.is_finite())) {
            None => Ok(points),
            Some(k) => Err(ReadError::Number {
                file: self.source.name.to_owned(),
                place: Location::Item("vertex", k),
                found: format!("{:?}", points[k].coords.as_slice()),
                expected: "finite position",
            }),
        }
    }

    /// Indices of vertices, of which there are `have`.
    pub(super) fn indices(&mut self, index: usize, have: usize) -> Result<Vec<u32>, ReadError> {
        let component = self.get(&self.root.accessors, index, "accessor")?.component_type;
        if !matches!(component, 5121 | 5123 | 5125) {
            let expected = "indices of type 5121, 5123 or 5125";
            let place = Location::Item("accessor", index);
            return Err(self.source.syntax(place, &component.to_string(), expected, HELP));
        }
        let numbers = self.numbers(index, "SCALAR", 1)?;
        let count = u32::try_from(have).unwrap_or(u32::MAX);
        let bad = numbers.iter().find(|number| !(0.0..f64::from(count)).contains(*number));
        if let Some(bad) = bad {
            return Err(ReadError::Index {
                file: self.source.name.to_owned(),
                place: Location::Item("accessor", index),
                found: bad.to_string(),
                what: "vertex",
                have: format!("they count from 0 and there are {have}"),
            });
        }
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // whole and in range
        Ok(numbers.into_iter().map(|number| number as u32).collect())
    }

    /// All numbers of an accessor, one entry after another. Without a view they are 0.
    fn numbers(&mut self, index: usize, shape: &str, width: usize) -> Result<Vec<f64>, ReadError> {
        let root = self.root;
        let accessor: &Accessor = self.get(&root.accessors, index, "accessor")?;
        let place = Location::Item("accessor", index);
        if accessor.shape != shape {
            return Err(self.source.syntax(place, &accessor.shape, format!("type {shape}"), HELP));
        }
        self.source.room(place.clone(), accessor.count.saturating_sub(1), "entries of an accessor")?;
        let layout = Layout { component: accessor.component_type, normalized: accessor.normalized, width };
        let mut numbers = match accessor.buffer_view {
            Some(view) => self.at(index, view, accessor.byte_offset, accessor.count, layout)?,
            None => vec![0.0; accessor.count * width],
        };
        let Some(sparse) = &accessor.sparse else { return Ok(numbers) };
        if sparse.count > accessor.count {
            let found = format!("{} entries changed", sparse.count);
            return Err(self.source.syntax(place, &found, format!("{} at most", accessor.count), HELP));
        }
        let component = sparse.indices.component_type.unwrap_or_default();
        let whole = Layout { component, normalized: false, width: 1 };
        let (places, values) = (&sparse.indices, &sparse.values);
        let places = self.at(index, places.buffer_view, places.byte_offset, sparse.count, whole)?;
        let values = self.at(index, values.buffer_view, values.byte_offset, sparse.count, layout)?;
        for (at, value) in places.into_iter().zip(values.chunks_exact(width)) {
            #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
            // what is out of range is refused
            let begin = (at as usize).saturating_mul(width);
            let Some(changed) = numbers.get_mut(begin..begin.saturating_add(width)) else {
                let expected = "the place of an entry";
                return Err(self.source.syntax(place, &at.to_string(), expected, HELP));
            };
            changed.copy_from_slice(value);
        }
        Ok(numbers)
    }

    /// Numbers from an offset in a view on.
    fn at(
        &mut self,
        accessor: usize,
        view: usize,
        offset: usize,
        count: usize,
        layout: Layout,
    ) -> Result<Vec<f64>, ReadError> {
        let (root, place) = (self.root, Location::Item("accessor", accessor));
        let view = self.get(&root.buffer_views, view, "buffer view")?;
        let Some(size) = size(layout.component) else {
            let expected = "a component type from 5120 to 5126";
            return Err(self.source.syntax(place, &layout.component.to_string(), expected, HELP));
        };
        let entry = size * layout.width;
        let stride = view.byte_stride.filter(|stride| *stride > 0).unwrap_or(entry);
        let source = self.source;
        let bytes = self.buffer(view.buffer)?;
        let end = view.byte_offset.saturating_add(view.byte_length);
        let bytes = bytes.get(view.byte_offset..end).and_then(|bytes| bytes.get(offset..));
        let needed = count.saturating_sub(1).saturating_mul(stride).saturating_add(entry);
        let held = bytes.map_or(0, <[u8]>::len);
        let Some(bytes) = bytes.filter(|bytes| count == 0 || needed <= bytes.len()) else {
            let announced = format!("{count} entries need {needed} bytes");
            return Err(source.truncated(place, announced, format!("there are {held}")));
        };
        let entries = (0..count).flat_map(|k| bytes[k * stride..k * stride + entry].chunks_exact(size));
        Ok(entries.map(|bytes| number(bytes, layout)).collect())
    }

    fn buffer(&mut self, index: usize) -> Result<&[u8], ReadError> {
        let root = self.root;
        let buffer = self.get(&root.buffers, index, "buffer")?;
        match (&buffer.uri, self.binary) {
            (Some(uri), _) => {
                let decoded = match self.decoded[index].take() {
                    Some(decoded) => decoded,
                    None => self.bytes(uri, index)?,
                };
                Ok(self.decoded[index].insert(decoded))
            }
            (None, Some(binary)) if index == 0 => Ok(binary),
            (None, _) => {
                let place = Location::Item("buffer", index);
                Err(self.source.syntax(
                    place,
                    "no bytes",
                    "bytes in the file",
                    ErrorRemedy::ExportAs { form: ".glb".to_owned() },
                ))
            }
        }
    }

    /// The bytes of a buffer with an address: in the JSON, or in a file of their own.
    fn bytes(&mut self, uri: &str, buffer: usize) -> Result<Vec<u8>, ReadError> {
        if let Some(data) = uri.strip_prefix(EMBEDDED) {
            return embedded(data, buffer, self.source);
        }
        if let Some(bytes) = self.beside.read(uri)? {
            return Ok(bytes);
        }
        let uris = self.root.buffers.iter().filter_map(|buffer| buffer.uri.as_deref());
        Err(self.beside.missing(self.source.name, uris.filter(|uri| !uri.starts_with(EMBEDDED))))
    }
}

/// Bytes of a component.
fn size(component: u32) -> Option<usize> {
    Some(match component {
        5120 | 5121 => 1,
        5122 | 5123 => 2,
        5125 | 5126 => 4,
        _ => return None,
    })
}

/// One component, as many bytes as it has. A normalized whole number is a share of its largest value.
fn number(bytes: &[u8], layout: Layout) -> f64 {
    let share = |value: f64, max: f64| if layout.normalized { (value / max).max(-1.0) } else { value };
    match (layout.component, bytes) {
        (5120, &[a]) => share(a.cast_signed().into(), 127.0),
        (5121, &[a]) => share(a.into(), 255.0),
        (5122, &[a, b]) => share(i16::from_le_bytes([a, b]).into(), 32_767.0),
        (5123, &[a, b]) => share(u16::from_le_bytes([a, b]).into(), 65_535.0),
        (5125, &[a, b, c, d]) => u32::from_le_bytes([a, b, c, d]).into(),
        (_, &[a, b, c, d]) => f32::from_le_bytes([a, b, c, d]).into(),
        _ => f64::NAN,
    }
}
