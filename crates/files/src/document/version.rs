//! Formats and versions: what is opened, migrated or refused.

use serde::Deserialize;
use serde::de::DeserializeOwned;
use serde_json::Value;

use super::error::DocumentError;
use crate::encoding::utf8;

/// From one version of a format to the next.
pub(crate) type Migration = fn(Value) -> Result<Value, serde_json::Error>;

/// A format and how it came to its present version, which is one more than there are migrations.
pub(crate) struct History {
    /// The value of the key "format".
    pub(crate) format: &'static str,
    /// What a document of it is called.
    pub(crate) title: &'static str,
    /// Entry k makes version k + 2 of version k + 1.
    pub(crate) migrations: &'static [Migration],
}

/// What every version of every format has.
#[derive(Deserialize)]
struct Head {
    format: String,
    version: u64,
}

impl History {
    pub(crate) const fn current(&self) -> u64 {
        self.migrations.len() as u64 + 1
    }

    /// Reads a document of the present version, or of an older one, which is migrated.
    ///
    /// # Errors
    /// [`DocumentError::Empty`], [`DocumentError::Json`], [`DocumentError::WrongFormat`], [`DocumentError::Newer`] and
    /// [`DocumentError::NoSuchVersion`].
    pub(crate) fn open<T: DeserializeOwned>(&self, bytes: &[u8], file: &str) -> Result<T, DocumentError> {
        let bytes = &*utf8(bytes);
        if bytes.trim_ascii().is_empty() {
            return Err(DocumentError::Empty { file: file.to_owned(), expected: self.title });
        }
        let json = |error: serde_json::Error| DocumentError::Json {
            file: file.to_owned(),
            line: error.line(),
            column: error.column(),
            message: without_place(&error),
        };
        let head: Head = serde_json::from_slice(bytes).map_err(json)?;
        let file = || file.to_owned();
        if head.format != self.format {
            return Err(DocumentError::WrongFormat {
                file: file(),
                found: head.format,
                expected: self.format,
            });
        }
        if head.version > self.current() {
            return Err(DocumentError::Newer { file: file(), version: head.version, known: self.current() });
        }
        let Some(older) = head.version.checked_sub(1) else {
            return Err(DocumentError::NoSuchVersion { file: file(), version: head.version });
        };
        // Without a migration the bytes are read as they are, and errors keep their line.
        if head.version == self.current() {
            return serde_json::from_slice(bytes).map_err(json);
        }
        let mut value: Value = serde_json::from_slice(bytes).map_err(json)?;
        let done = usize::try_from(older).unwrap_or(usize::MAX);
        for migration in self.migrations.iter().skip(done) {
            value = migration(value).map_err(json)?;
        }
        serde_json::from_value(value).map_err(json)
    }
}

/// The message of an error without its line and column, which are given on their own.
pub(crate) fn without_place(error: &serde_json::Error) -> String {
    let message = error.to_string();
    let place = format!(" at line {} column {}", error.line(), error.column());
    message.strip_suffix(&place).unwrap_or(&message).to_owned()
}
