//! Units in the names of columns.

use wirebend_error::ErrorRemedy;

use super::super::error::{Location, ReadError};
use super::super::options::{LengthUnit, ReadOptions};
use super::super::text::Source;
use super::columns::says_radius;
use super::{Column, Table};

const LENGTHS: &str = "mm, cm, m, inch, ft or µm";
const ANGLES: &str = "deg, rad, mrad, gon or turns";

/// What the name of a column says of its unit.
#[derive(Debug, Default, PartialEq)]
pub(crate) struct Units {
    /// How many mm its unit of length is.
    pub(crate) mm: Option<f64>,
    /// How many degrees its unit of angle is.
    pub(crate) degrees: Option<f64>,
    /// Whether it has a unit that is not read, such as yards or mm/min.
    pub(crate) unread: bool,
}

#[derive(Debug, Clone, Copy)]
enum Unit {
    /// In mm.
    Length(f64),
    /// In degrees.
    Angle(f64),
    Unread,
}

const INCH: Unit = Unit::Length(LengthUnit::Inch.mm());
const FOOT: Unit = Unit::Length(304.8);

impl Table<'_> {
    /// How many mm one is in a column, and whether the person's unit is another than the table names there. A column without a unit has
    /// that of the others. One whose unit is no length, or is not read and not said by the person, is refused.
    pub(crate) fn mm(
        &self,
        source: Source<'_>,
        column: Option<usize>,
        options: &ReadOptions,
    ) -> Result<(f64, bool), ReadError> {
        let column = self.named(column);
        let is_wrong = |column: &Column| {
            let Units { mm, degrees, unread } = column.units;
            unread && options.units.is_none() || degrees.is_some() && mm.is_none() && !says_radius(column)
        };
        if let Some(column) = column.filter(|column| is_wrong(column)) {
            return Err(self.refuse_unit(source, column, "length", LENGTHS));
        }
        let named = column.and_then(|column| column.units.mm).or_else(|| self.unit_mm());
        let wanted = options.units.map(LengthUnit::mm);
        let is_other =
            wanted.zip(named).is_some_and(|(wanted, named)| (wanted - named).abs() > 1e-12 * named);
        let is_unread = column.is_some_and(|column| column.units.unread);
        Ok((wanted.or(named).unwrap_or(1.0) * options.scale, is_other || is_unread))
    }

    /// The first unit of length that the header names, in mm.
    pub(crate) fn unit_mm(&self) -> Option<f64> {
        self.header.iter().flatten().find_map(|column| column.units.mm)
    }

    /// How many degrees one is in a column; one whose unit is no angle, or is not read, is refused.
    pub(crate) fn degrees(&self, source: Source<'_>, column: Option<usize>) -> Result<f64, ReadError> {
        let Some(column) = self.named(column) else { return Ok(1.0) };
        let Units { mm, degrees, unread } = column.units;
        if unread || mm.is_some() && degrees.is_none() {
            return Err(self.refuse_unit(source, column, "angle", ANGLES));
        }
        Ok(degrees.unwrap_or(1.0))
    }

    fn named(&self, column: Option<usize>) -> Option<&Column> {
        self.header.as_ref()?.get(column?)
    }

    fn refuse_unit(&self, source: Source<'_>, column: &Column, kind: &str, known: &str) -> ReadError {
        let expected = format!("a column of {kind}s in {known}, or with no unit in its name");
        let place = Location::Line(self.first_line);
        source.syntax(place, &column.text, expected, ErrorRemedy::CorrectFile)
    }
}

impl Units {
    pub(super) fn of(name: &str) -> Self {
        let name = name.to_lowercase().replace(" / ", "/");
        let words = name.split(is_between).filter(|word| !word.is_empty());
        let rates = name.split(|c: char| is_between(c) && c != '/').filter(|word| is_rate(word));
        let placed = in_brackets(&name).chain(at_end(&name)).filter_map(Unit::placed);
        let anywhere = words.skip(1).filter_map(Unit::anywhere);
        let mut units = Self::default();
        for unit in placed.chain(anywhere).chain(rates.map(|_| Unit::Unread)) {
            match unit {
                Unit::Length(mm) => units.mm = units.mm.or(Some(mm)),
                Unit::Angle(degrees) => units.degrees = units.degrees.or(Some(degrees)),
                Unit::Unread => units.unread = true,
            }
        }
        units
    }
}

impl Unit {
    /// By a word that is a unit wherever it stands.
    fn anywhere(word: &str) -> Option<Self> {
        Some(match word {
            // It is a unit at the end alone: see `at_end`.
            "in" => return None,
            "zoll" => INCH,
            "ft" | "feet" => FOOT,
            // The micro sign, and the letter mu.
            "um" | "\u{b5}m" | "\u{3bc}m" | "micron" | "microns" | "micrometer" | "micrometers"
            | "micrometre" | "micrometres" => Self::Length(1e-3),
            // "Grad" is German for it.
            "deg" | "degree" | "degrees" | "grad" => Self::Angle(1.0),
            "rad" | "radian" | "radians" => Self::Angle(1.0_f64.to_degrees()),
            "mrad" | "milliradian" | "milliradians" => Self::Angle(1e-3_f64.to_degrees()),
            "gon" | "gradian" | "gradians" => Self::Angle(0.9),
            "nm" | "dm" | "km" | "yd" | "yds" | "yard" | "yards" | "px" | "pixel" | "pixels" | "urad"
            | "arcmin" | "arcsec" | "mgon" => Self::Unread,
            _ => Self::Length(LengthUnit::from_word(word)?.mm()),
        })
    }

    /// By a word or a sign where a unit stands; elsewhere it may be another word.
    fn placed(word: &str) -> Option<Self> {
        Some(match word {
            "in" | "\"" | "''" | "″" => INCH,
            "foot" | "'" | "′" => FOOT,
            "°" | "º" => Self::Angle(1.0),
            _ if is_turns(word) => Self::Angle(360.0),
            // "R (turn)" may as well say what R is, and a mil is a length or an angle.
            "turn" | "mil" | "mils" | "thou" | "pt" | "pts" | "steps" | "counts" | "pulses" | "ticks"
            | "%" => Self::Unread,
            _ => return Self::anywhere(word),
        })
    }
}

fn is_turns(word: &str) -> bool {
    matches!(word, "turns" | "rev" | "revs" | "revolution" | "revolutions")
}

fn is_between(c: char) -> bool {
    !c.is_alphanumeric()
}

/// Whether a word is a unit in another, such as mm/min.
fn is_rate(word: &str) -> bool {
    word.split_once('/').is_some_and(|(unit, per)| !per.is_empty() && Unit::anywhere(unit).is_some())
}

fn in_brackets(name: &str) -> impl Iterator<Item = &str> {
    let inside = name.split(['(', '[', '{']).skip(1).filter_map(|rest| rest.split([')', ']', '}']).next());
    inside.map(|inside| inside.trim().trim_end_matches('.'))
}

/// The last word behind `_` or "in", as in "length in steps"; or "in" itself, as in "length in", but not in "length in mm".
fn at_end(name: &str) -> Option<&str> {
    let name = name.trim_end_matches(is_between);
    let (at, mark) = name.char_indices().rfind(|(_, c)| is_between(*c))?;
    let (before, last) = (&name[..at], &name[at + mark.len_utf8()..]);
    let is_behind_in = before.rsplit(is_between).next() == Some("in");
    let is_of_one = mark == ' ' && before.chars().count() == 1;
    (mark == '_' || is_behind_in || last == "in" || (is_of_one && is_turns(last))).then_some(last)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_says_its_unit() {
        let length = |mm| Units { mm: Some(mm), ..Units::default() };
        let angle = |degrees| Units { degrees: Some(degrees), ..Units::default() };
        for (units, names) in [
            (length(1.0), ["L_mm", "Length in mm", "x [mm]", "L/mm", "Length (mm, in plane)"]),
            (length(25.4), ["L (in)", "L (in) abs", "Length in", "L [\"]", "L_in"]),
            (length(304.8), ["L (ft)", "Length in feet", "L_ft_abs", "L [Foot]", "L (')"]),
            (length(0.001), ["x (um)", "x [\u{b5}m]", "x_\u{3bc}m", "x in microns", "x um"]),
            (angle(1.0), ["A [°]", "A_deg", "Bend angle (deg.)", "A in degrees", "A [Grad]"]),
            (angle(0.9), ["A (gon)", "A_gon_abs", "A in gradians", "A / gon", "A, gon"]),
            (angle(360.0), ["R (turns)", "R_rev", "Rotation in revolutions", "R [ turns ]", "A turns"]),
            (
                Units { unread: true, ..Units::default() },
                ["L (yd)", "Length in steps", "L_thou", "R (turn)", "L px"],
            ),
            (
                Units::default(),
                ["Angle (bend)", "Length (in total)", "Bend (in/out)", "Head turn", "Number of turns"],
            ),
            (Units::default(), ["turns", "mm", "bend (outside)", "length (arc)", "steps"]),
        ] {
            for name in names {
                assert_eq!(Units::of(name), units, "{name}");
            }
        }
        for rate in ["Feed (mm/min)", "Feed [mm / s]", "Rotation deg/s"] {
            assert!(Units::of(rate).unread, "{rate}");
        }
        let mrad = Units::of("A [mrad]").degrees.unwrap();
        assert!((mrad * 1000.0 * std::f64::consts::PI - 180.0).abs() < 1e-9, "{mrad}");
    }
}
