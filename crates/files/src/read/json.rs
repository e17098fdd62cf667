//! JSON files of frames.

use serde::de::DeserializeOwned;
use wirebend_error::ErrorRemedy;

use super::error::{Location, ReadError};
use super::text::Source;
use crate::document::without_place;

/// Reads a value; `expected` says what the file should be.
///
/// # Errors
/// [`ReadError::Syntax`] with the line, and the entry in it: programs write all of a frame on one line.
pub(super) fn parse<T: DeserializeOwned>(
    bytes: &[u8],
    source: Source<'_>,
    expected: &str,
) -> Result<T, ReadError> {
    let wrong = |error: &serde_json::Error, path: Option<String>| ReadError::Syntax {
        file: source.name.to_owned(),
        place: match path {
            Some(path) => Location::Entry { line: error.line(), path },
            None => Location::Line(error.line()),
        },
        found: without_place(error),
        expected: expected.into(),
        remedy: Box::new(ErrorRemedy::CorrectFile),
    };
    let mut json = serde_json::Deserializer::from_slice(bytes);
    let value = serde_path_to_error::deserialize(&mut json).map_err(|error| {
        let path = error.path();
        wrong(error.inner(), path.iter().next().map(|_| path.to_string()))
    })?;
    json.end().map_err(|error| wrong(&error, None))?;
    Ok(value)
}
