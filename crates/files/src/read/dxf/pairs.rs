//! The pairs of a group code and a value that a DXF file is made of, as text or binary.

use std::borrow::Cow;

use wirebend_error::ErrorRemedy;

use super::super::error::{Location, ReadError};
use super::super::text::{Source, excerpt, lines};
use super::letters::Letters;

/// What every binary file begins with.
pub(super) const BINARY: &[u8] = b"AutoCAD Binary DXF\r\n\x1a\0";

const EXPECTED: &str = "a group code, which is a whole number from -5 to 1071";
const HELP: ErrorRemedy = ErrorRemedy::CorrectFile;

/// A value: text from a text file, whatever it means; what the code says from a binary one.
#[derive(Debug, Clone)]
pub(super) enum Value<'a> {
    Text(Cow<'a, str>),
    Real(f64),
    Whole(i64),
}

#[derive(Debug, Clone)]
pub(super) struct Pair<'a> {
    /// Of the value.
    pub(super) place: Location,
    pub(super) code: i32,
    pub(super) value: Value<'a>,
}

impl Pair<'_> {
    pub(super) fn text(&self) -> Cow<'_, str> {
        match &self.value {
            Value::Text(text) => Cow::Borrowed(text.trim()),
            Value::Real(number) => number.to_string().into(),
            Value::Whole(number) => number.to_string().into(),
        }
    }

    pub(super) fn real(&self, source: Source<'_>) -> Result<f64, ReadError> {
        let number = match &self.value {
            Value::Text(text) => text.trim().parse().ok(),
            Value::Real(number) => Some(*number),
            #[allow(clippy::cast_precision_loss)] // no number of a drawing has so many digits
            Value::Whole(number) => Some(*number as f64),
        };
        number.filter(|number: &f64| number.is_finite()).ok_or_else(|| self.no(source, "finite number"))
    }

    pub(super) fn whole(&self, source: Source<'_>) -> Result<i64, ReadError> {
        let number = match &self.value {
            Value::Text(text) => text.trim().parse().ok(),
            Value::Whole(number) => Some(*number),
            Value::Real(_) => None,
        };
        number.ok_or_else(|| self.no(source, "whole number"))
    }

    fn no(&self, source: Source<'_>, expected: &'static str) -> ReadError {
        let found = excerpt(&self.text());
        ReadError::Number { file: source.name.to_owned(), place: self.place.clone(), found, expected }
    }
}

/// Gives one pair after another.
pub(super) struct Pairs<'a> {
    source: Source<'a>,
    input: Input<'a>,
}

enum Input<'a> {
    Text(Box<dyn Iterator<Item = (usize, &'a str)> + 'a>),
    Binary(Binary<'a>),
}

impl<'a> Pairs<'a> {
    pub(super) fn text(text: &'a str, source: Source<'a>) -> Self {
        Self { source, input: Input::Text(Box::new(lines(text))) }
    }

    /// The bytes behind [`BINARY`].
    pub(super) fn binary(bytes: &'a [u8], letters: Letters, source: Source<'a>) -> Self {
        // The first group is 0 SECTION; before release 13 a code had one byte.
        let wide = bytes.get(BINARY.len() + 1) == Some(&0);
        Self { source, input: Input::Binary(Binary { bytes, letters, at: BINARY.len(), wide }) }
    }

    /// None at the end of the file.
    pub(super) fn next(&mut self) -> Result<Option<Pair<'a>>, ReadError> {
        match &mut self.input {
            Input::Text(lines) => text_pair(lines, self.source),
            Input::Binary(binary) => binary.pair(self.source),
        }
    }
}

fn text_pair<'a>(
    lines: &mut impl Iterator<Item = (usize, &'a str)>,
    source: Source<'_>,
) -> Result<Option<Pair<'a>>, ReadError> {
    let Some((line, code)) = lines.next() else { return Ok(None) };
    let Ok(number) = code.trim().parse::<i32>() else {
        // Only blank lines may stand behind the last pair.
        if code.trim().is_empty() && lines.all(|(_, line)| line.trim().is_empty()) {
            return Ok(None);
        }
        return Err(source.syntax(Location::Line(line), code, EXPECTED, HELP));
    };
    if !(-5..=1071).contains(&number) {
        return Err(source.syntax(Location::Line(line), code, EXPECTED, HELP));
    }
    let Some((line, value)) = lines.next() else {
        let announced = format!("a value of group {number} has to follow");
        return Err(source.truncated(Location::Line(line), announced, "the file ends".into()));
    };
    Ok(Some(Pair { place: Location::Line(line), code: number, value: Value::Text(value.into()) }))
}

struct Binary<'a> {
    bytes: &'a [u8],
    letters: Letters,
    at: usize,
    wide: bool,
}

impl<'a> Binary<'a> {
    fn take(&mut self, count: usize, source: Source<'_>) -> Result<&'a [u8], ReadError> {
        let end = self.at.saturating_add(count);
        let Some(bytes) = self.bytes.get(self.at..end) else {
            let left = self.bytes.len().saturating_sub(self.at);
            let announced = format!("{count} bytes of a group have to follow");
            return Err(source.truncated(Location::Byte(self.at), announced, format!("there are {left}")));
        };
        self.at = end;
        Ok(bytes)
    }

    /// A little-endian number of up to 8 bytes with its sign.
    fn whole(&mut self, count: usize, source: Source<'_>) -> Result<i64, ReadError> {
        let bytes = self.take(count, source)?;
        let unsigned = bytes.iter().rev().fold(0_u64, |sum, &byte| sum << 8 | u64::from(byte));
        let unused = 64 - 8 * u32::try_from(count).unwrap_or(8);
        Ok((unsigned << unused).cast_signed() >> unused)
    }

    fn code(&mut self, source: Source<'_>) -> Result<i32, ReadError> {
        let place = Location::Byte(self.at);
        let code = if self.wide { self.whole(2, source)? } else { i64::from(self.take(1, source)?[0]) };
        // One byte of 255 announces two bytes, for the codes from 1000 on.
        let code = if !self.wide && code == 255 { self.whole(2, source)? } else { code };
        match i32::try_from(code) {
            Ok(code) if (-5..=1071).contains(&code) => Ok(code),
            _ => Err(source.syntax(place, &code.to_string(), EXPECTED, ErrorRemedy::ExportAgain)),
        }
    }

    fn pair(&mut self, source: Source<'_>) -> Result<Option<Pair<'a>>, ReadError> {
        if self.at >= self.bytes.len() {
            return Ok(None);
        }
        let code = self.code(source)?;
        let place = Location::Byte(self.at);
        let value = match code {
            10..=59 | 110..=149 | 210..=239 | 460..=469 | 1010..=1059 => {
                let bits = self.whole(8, source)?;
                Value::Real(f64::from_bits(bits.cast_unsigned()))
            }
            60..=79 | 170..=179 | 270..=289 | 370..=389 | 400..=409 | 1060..=1070 => {
                Value::Whole(self.whole(2, source)?)
            }
            90..=99 | 420..=429 | 440..=459 | 1071 => Value::Whole(self.whole(4, source)?),
            160..=169 => Value::Whole(self.whole(8, source)?),
            290..=299 => Value::Whole(self.whole(1, source)?),
            310..=319 | 1004 => {
                let count = self.take(1, source)?[0];
                self.take(count.into(), source)?;
                Value::Text(Cow::Borrowed(""))
            }
            _ => {
                let rest = &self.bytes[self.at..];
                let length = rest.iter().position(|&byte| byte == 0).unwrap_or(rest.len());
                let text = self.letters.text(self.take(length, source)?);
                self.take(1, source)?;
                Value::Text(text)
            }
        };
        Ok(Some(Pair { place, code, value }))
    }
}
