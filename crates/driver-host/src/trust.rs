//! Which libraries of other people a person has accepted, by their SHA-256.

use std::collections::BTreeMap;
use std::fmt;
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::str::FromStr;

use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};
use wirebend_error::ErrorRemedy;

/// The SHA-256 of a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(try_from = "String", into = "String")]
pub struct Fingerprint([u8; 32]);

impl Fingerprint {
    /// Of a file's contents.
    ///
    /// # Errors
    /// When the file cannot be read.
    pub fn of(file: &Path) -> io::Result<Self> {
        let mut hash = Sha256::new();
        io::copy(&mut fs::File::open(file)?, &mut HashWriter(&mut hash))?;
        Ok(Self(hash.finalize().into()))
    }
}

struct HashWriter<'a>(&'a mut Sha256);

impl Write for HashWriter<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.update(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

impl fmt::Display for Fingerprint {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.iter().try_for_each(|byte| write!(f, "{byte:02x}"))
    }
}

impl From<Fingerprint> for String {
    fn from(hash: Fingerprint) -> Self {
        hash.to_string()
    }
}

impl TryFrom<String> for Fingerprint {
    type Error = String;

    fn try_from(text: String) -> Result<Self, String> {
        text.parse()
    }
}

impl FromStr for Fingerprint {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let wrong = || format!("'{text}' is no SHA-256: expected 64 hexadecimal digits");
        if text.len() != 64 || !text.is_ascii() {
            return Err(wrong());
        }
        let mut bytes = [0; 32];
        for (byte, digits) in bytes.iter_mut().zip(text.as_bytes().chunks(2)) {
            let digits = std::str::from_utf8(digits).map_err(|_| wrong())?;
            *byte = u8::from_str_radix(digits, 16).map_err(|_| wrong())?;
        }
        Ok(Self(bytes))
    }
}

/// Why the list of accepted libraries cannot be used.
#[derive(Debug, thiserror::Error)]
pub enum TrustError {
    /// It cannot be read or written.
    #[error("{}: the list of accepted drivers cannot be used: {cause}", file.display())]
    Io {
        /// The list.
        file: PathBuf,
        cause: io::Error,
    },
    /// It is a list of another version.
    #[error("{}: this is a list of accepted drivers of version {version}, and this program writes {VERSION}", file.display())]
    Version {
        /// The list.
        file: PathBuf,
        version: u32,
    },
    /// It is not such a list.
    #[error("{}: this is not a list of accepted drivers: {cause}", file.display())]
    Shape {
        /// The list.
        file: PathBuf,
        cause: serde_json::Error,
    },
}

impl TrustError {
    /// What can be done about it.
    #[must_use]
    pub fn remedies(&self) -> Vec<ErrorRemedy> {
        match self {
            Self::Io { .. } => vec![ErrorRemedy::CheckDisk],
            Self::Version { .. } => vec![ErrorRemedy::UpdateProgram, ErrorRemedy::ResetTrust],
            Self::Shape { .. } => vec![ErrorRemedy::ResetTrust],
        }
    }
}

/// The version of the list's format.
const VERSION: u32 = 1;

/// The list of accepted libraries. A library is accepted as it is: another content needs another word.
#[derive(Debug, Clone)]
pub struct TrustStore {
    file: PathBuf,
    accepted: BTreeMap<PathBuf, Fingerprint>,
}

#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Stored {
    version: u32,
    accepted: Vec<Entry>,
}

#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Entry {
    library: PathBuf,
    sha256: Fingerprint,
}

impl TrustStore {
    /// Reads the list; one that is not there yet is empty.
    ///
    /// # Errors
    /// [`TrustError`].
    pub fn open(file: &Path) -> Result<Self, TrustError> {
        let file = file.to_owned();
        let text = match fs::read(&file) {
            Ok(text) => text,
            Err(error) if error.kind() == io::ErrorKind::NotFound => {
                return Ok(Self { file, accepted: BTreeMap::new() });
            }
            Err(cause) => return Err(TrustError::Io { file, cause }),
        };
        match serde_json::from_slice::<Stored>(&text) {
            Ok(Stored { version, .. }) if version != VERSION => Err(TrustError::Version { file, version }),
            Ok(stored) => {
                let accepted =
                    stored.accepted.into_iter().map(|entry| (entry.library, entry.sha256)).collect();
                Ok(Self { file, accepted })
            }
            Err(cause) => Err(TrustError::Shape { file, cause }),
        }
    }

    /// What was accepted under this name (an absolute path without links).
    #[must_use]
    pub fn accepted(&self, library: &Path) -> Option<Fingerprint> {
        self.accepted.get(library).copied()
    }

    /// Accepts a library as it is, and writes the list.
    ///
    /// # Errors
    /// [`TrustError::Io`]; then nothing is accepted.
    pub fn accept(&mut self, library: &Path, hash: Fingerprint) -> Result<(), TrustError> {
        // As it is now: another program may have accepted something since.
        let mut accepted = Self::open(&self.file)?.accepted;
        accepted.insert(library.to_owned(), hash);
        self.save(&accepted).map_err(|cause| TrustError::Io { file: self.file.clone(), cause })?;
        self.accepted = accepted;
        Ok(())
    }

    /// A file is replaced whole: a list that is cut off would forget what was accepted.
    fn save(&self, accepted: &BTreeMap<PathBuf, Fingerprint>) -> io::Result<()> {
        let accepted =
            accepted.iter().map(|(library, &sha256)| Entry { library: library.clone(), sha256 }).collect();
        let folder = self.file.parent().unwrap_or(Path::new("."));
        fs::create_dir_all(folder)?;
        let mut new = tempfile::NamedTempFile::new_in(folder)?;
        serde_json::to_writer_pretty(&mut new, &Stored { version: VERSION, accepted })?;
        new.write_all(b"\n")?;
        new.as_file().sync_all()?;
        new.persist(&self.file)?;
        Ok(())
    }
}
