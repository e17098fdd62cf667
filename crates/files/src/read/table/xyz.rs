//! A table of points: one polyline, closed where the last point repeats the first.

use nalgebra::Point3;
use wirebend_error::ErrorRemedy;

use super::super::Imported;
use super::super::drawing::Drawing;
use super::super::error::ReadError;
use super::super::format::Format;
use super::super::note::NoteKind;
use super::super::options::{LengthUnit, ReadOptions};
use super::super::text::{Source, decode};
use super::Table;

/// Reads columns x, y, z: by their header if there is one, else the only three that there are.
pub(in crate::read) fn read(
    bytes: &[u8],
    source: Source<'_>,
    options: &ReadOptions,
) -> Result<Imported, ReadError> {
    let text = decode(bytes);
    let table = Table::read(&text, source, 0)?;
    let mut drawing = Drawing::default();
    drawing.notes.add(NoteKind::CommentsIgnored, table.comments);
    let columns = columns(&table, source, &mut drawing)?;
    // The points are in the unit of the drawing, whatever each column is in.
    drawing.unit_mm = options.units.map(LengthUnit::mm).or_else(|| table.unit_mm());
    let whole = table.mm(source, None, options)?.0;
    let mut shares = [1.0; 3];
    let mut is_overridden = false;
    for (share, &column) in shares.iter_mut().zip(&columns) {
        let (mm, is_other) = table.mm(source, Some(column), options)?;
        *share = mm / whole;
        is_overridden |= is_other;
    }
    drawing.notes.add(NoteKind::UnitsOverridden, usize::from(is_overridden));
    for row in 0..table.rows.len() {
        let place = table.place(row);
        source.room(place.clone(), row, "points")?;
        let mut point = Point3::origin();
        for (axis, &column) in columns.iter().enumerate() {
            let value = table.value(source, row, column)?.ok_or_else(|| {
                let found = table.rows[row].1.join(" ");
                let remedy = ErrorRemedy::CorrectFile;
                source.syntax(place.clone(), &found, "three numbers", remedy)
            })?;
            point[axis] = value * shares[axis];
        }
        if table.header.is_none() && table.rows[row].1.len() > columns.len() {
            let remedy = ErrorRemedy::NameColumns { columns: "x, y and z".to_owned() };
            return Err(source.syntax(place, &table.rows[row].1.join(" "), "three numbers", remedy));
        }
        drawing.points.push(point);
        drawing.point_lines.push(table.rows[row].0);
    }
    let (Some(&first), Some(&last)) = (drawing.points.first(), drawing.points.last()) else {
        return Err(source.empty("points", &drawing.notes));
    };
    let factor = drawing.factor(options);
    let closed = drawing.points.len() > 3 && (last - first).norm() * factor <= options.weld.mm();
    if closed {
        drawing.points.pop();
        drawing.notes.add(NoteKind::PolylineClosed, 1);
    }
    let count = u32::try_from(drawing.points.len()).unwrap_or(u32::MAX);
    drawing.edges = (1..count).map(|k| (k - 1, k)).collect();
    if closed {
        drawing.edges.push((count - 1, 0));
    }
    drawing.finish(Format::Xyz, source, options)
}

fn columns(table: &Table<'_>, source: Source<'_>, drawing: &mut Drawing) -> Result<[usize; 3], ReadError> {
    let Some(header) = &table.header else {
        return Ok([0, 1, 2]);
    };
    drawing.notes.add(NoteKind::HeaderSkipped, 1);
    let named = ["x", "y", "z"].map(|name| table.column(&[name]));
    if let [Some(x), Some(y), Some(z)] = named {
        drawing.notes.add(NoteKind::ColumnsIgnored, header.len() - 3);
        return Ok([x, y, z]);
    }
    if header.len() == 3 {
        return Ok([0, 1, 2]);
    }
    let found = header.iter().map(|column| column.name.as_str()).collect::<Vec<_>>().join(", ");
    let remedy = ErrorRemedy::NameColumns { columns: "x, y and z".to_owned() };
    Err(source.syntax(super::Location::File, &found, "a header with x, y and z", remedy))
}
