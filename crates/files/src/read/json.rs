//! JSON files of frames.

use serde::de::DeserializeOwned;
use wirebend_error::ErrorRemedy;

use super::error::{Location, ReadError};
use super::text::Source;
use crate::document::without_place;

/// Reads a value; `expected` says what the file should be.
///
/// # Errors
/// [`ReadError::Syntax`] with the line.
pub(super) fn parse<T: DeserializeOwned>(
    bytes: &[u8],
    source: Source<'_>,
    expected: &str,
) -> Result<T, ReadError> {
    serde_json::from_slice(bytes).map_err(|error| ReadError::Syntax {
        file: source.name.to_owned(),
        place: Location::Line(error.line()),
        found: without_place(&error),
        expected: expected.into(),
        remedy: Box::new(ErrorRemedy::CorrectFile),
    })
}
