//! A record: the groups from one of code 0, which names its kind, up to the next.

use std::borrow::Cow;

use nalgebra::{Matrix3, Point3, Vector3};
use wirebend_error::ErrorRemedy;

use super::super::error::{Location, ReadError};
use super::super::text::Source;
use super::letters::unescaped;
use super::pairs::{Pair, Pairs};

/// One entity, table entry, or mark of a section.
#[derive(Debug)]
pub(super) struct Record<'a> {
    pub(super) source: Source<'a>,
    pub(super) place: Location,
    pub(super) kind: String,
    pub(super) pairs: Vec<Pair<'a>>,
}

/// Gives one record after another.
pub(super) struct Records<'a> {
    source: Source<'a>,
    pairs: Pairs<'a>,
    /// The head of the next record.
    head: Option<Pair<'a>>,
}

impl<'a> Records<'a> {
    /// What stands before the first record are comments.
    pub(super) fn new(source: Source<'a>, mut pairs: Pairs<'a>) -> Result<Self, ReadError> {
        let head = loop {
            match pairs.next()? {
                Some(pair) if pair.code == 999 => {}
                Some(pair) if pair.code == 0 => break Some(pair),
                Some(pair) => {
                    let found = format!("{} {}", pair.code, pair.text());
                    let remedy = ErrorRemedy::ExportAs { form: "DXF".to_owned() };
                    return Err(source.syntax(pair.place, &found, "0 SECTION", remedy));
                }
                None => break None,
            }
        };
        Ok(Self { source, pairs, head })
    }

    pub(super) fn next(&mut self) -> Result<Option<Record<'a>>, ReadError> {
        let Some(head) = self.head.take() else { return Ok(None) };
        let kind = head.text().to_ascii_uppercase();
        let mut record = Record { source: self.source, place: head.place, kind, pairs: Vec::new() };
        // What stands behind the last record, if anything, is not of the drawing.
        if record.kind == "EOF" {
            return Ok(Some(record));
        }
        while let Some(pair) = self.pairs.next()? {
            if pair.code == 0 {
                self.head = Some(pair);
                break;
            }
            self.source.room(pair.place.clone(), record.pairs.len(), "groups of an entity")?;
            record.pairs.push(pair);
        }
        Ok(Some(record))
    }
}

impl Record<'_> {
    pub(super) fn find(&self, code: i32) -> Option<&Pair<'_>> {
        self.pairs.iter().find(|pair| pair.code == code)
    }

    pub(super) fn text(&self, code: i32) -> Option<Cow<'_, str>> {
        self.find(code).map(Pair::text)
    }

    /// The name of a layer or a block: those that differ only in case are one.
    pub(super) fn name(&self, code: i32) -> Option<String> {
        self.text(code).map(|name| unescaped(&name).to_lowercase())
    }

    pub(super) fn real(&self, code: i32) -> Result<Option<f64>, ReadError> {
        self.find(code).map(|pair| pair.real(self.source)).transpose()
    }

    pub(super) fn whole(&self, code: i32) -> Result<Option<i64>, ReadError> {
        self.find(code).map(|pair| pair.whole(self.source)).transpose()
    }

    /// Whether a bit of the flags is set; 70 holds them in every record.
    pub(super) fn flag(&self, bit: i64) -> Result<bool, ReadError> {
        Ok(self.whole(70)?.unwrap_or_default() & bit != 0)
    }

    /// A number that has to be there.
    pub(super) fn needed(&self, code: i32) -> Result<f64, ReadError> {
        self.real(code)?.ok_or_else(|| self.lacks(code))
    }

    pub(super) fn lacks(&self, code: i32) -> ReadError {
        let found = format!("{} without group {code}", self.kind);
        let expected = format!("a value of group {code}");
        self.source.syntax(self.place.clone(), &found, expected, ErrorRemedy::ExportAgain)
    }

    /// The point whose x has the code; y and z follow by tens, z is 0 if absent.
    pub(super) fn point(&self, code: i32) -> Result<Point3<f64>, ReadError> {
        let z = self.real(code + 20)?.unwrap_or_default();
        Ok(Point3::new(self.needed(code)?, self.needed(code + 10)?, z))
    }

    /// From the entity's own coordinates to those of the drawing, by the arbitrary axis algorithm of the format: the
    /// extrusion is z, and x is level, or along y × z for an extrusion close to z.
    pub(super) fn axes(&self) -> Result<Matrix3<f64>, ReadError> {
        let [x, y, z] = [210, 220, 230].map(|code| self.real(code));
        let extrusion = Vector3::new(x?.unwrap_or(0.0), y?.unwrap_or(0.0), z?.unwrap_or(1.0));
        let Some(z) = extrusion.try_normalize(1e-12) else {
            let remedy = ErrorRemedy::ExportAgain;
            return Err(self.source.syntax(
                self.place.clone(),
                "0, 0, 0",
                "an extrusion with a length",
                remedy,
            ));
        };
        let close = z.x.abs() < 1.0 / 64.0 && z.y.abs() < 1.0 / 64.0;
        let x = if close { Vector3::y() } else { Vector3::z() }.cross(&z).normalize();
        Ok(Matrix3::from_columns(&[x, z.cross(&x), z]))
    }
}
