//! Which libraries there are, and which of them may be loaded.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use crate::trust::{Fingerprint, TrustStore};

/// Where drivers are looked for.
#[derive(Debug, Clone, Default)]
pub struct Places {
    /// The program's own folders. What is there came with it.
    pub app: Vec<PathBuf>,
    /// The person's folder, where it exists.
    pub user: Option<PathBuf>,
    /// Folders or libraries that were named for this time.
    pub named: Vec<PathBuf>,
}

/// Whose folder a library is in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Place {
    /// The program's.
    App,
    /// The person's.
    User,
    Named,
}

/// Whether a library may be loaded.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum TrustStatus {
    /// It came with the program.
    Shipped,
    /// A person has accepted it as it is.
    Accepted(Fingerprint),
    /// It was not accepted.
    Unknown(Fingerprint),
    /// It was accepted, and is another one now.
    Changed(Fingerprint),
    /// It is not loaded, even if somebody accepts it.
    Refused(LibraryRefusal),
}

/// Why a library is not loaded, even if somebody accepts it.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum LibraryRefusal {
    #[error("it cannot be read: {0}")]
    Unreadable(String),
    #[error("it is no file")]
    NoFile,
    /// Another user could put another library in its place.
    #[error("every user of this computer may write to {}", .0.display())]
    WritableByAll(PathBuf),
}

/// A library that was found.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DiscoveredDriver {
    /// Absolute path without links.
    pub file: PathBuf,
    /// Whose folder it is in.
    pub place: Place,
    /// Whether it may be loaded.
    pub verdict: TrustStatus,
}

/// All libraries, in the order in which they are asked: the program's own first.
#[derive(Debug, Clone, Default)]
pub struct DriverRegistry {
    /// The libraries.
    pub found: Vec<DiscoveredDriver>,
    /// Folders and libraries that were named and cannot be read: what is wrong.
    pub missing: Vec<String>,
}

/// How the file names of the program's own drivers begin, where they lie beside other libraries.
const OWN: &str = "wirebend_driver_";

impl Places {
    /// The program's own folders, seen from its executable: `drivers/` beside it, `lib/wirebend/drivers/` of the
    /// prefix that it is installed in, and its own folder, where only names that begin with
    /// `wirebend_driver_` count.
    #[must_use]
    pub fn of_program(executable: &Path) -> Vec<PathBuf> {
        let Some(folder) = executable.parent() else { return Vec::new() };
        let prefix = folder.parent().unwrap_or(folder);
        vec![folder.join("drivers"), prefix.join("lib/wirebend/drivers"), folder.to_owned()]
    }
}

impl DriverRegistry {
    /// Looks into the places. Nothing is loaded.
    #[must_use]
    pub fn look(places: &Places, trust: &TrustStore) -> Self {
        let mut registry = Self::default();
        for folder in places.app.iter().filter(|folder| folder.is_dir()) {
            let beside = folder.file_name().is_none_or(|name| name != "drivers");
            let all = libraries(folder).unwrap_or_else(|error| {
                registry.missing.push(format!("{}: {error}", folder.display()));
                Vec::new()
            });
            let own = all.into_iter().filter(|file| !beside || stem(file).starts_with(OWN));
            own.for_each(|file| registry.add(&file, Place::App, trust));
        }
        let user = places.user.iter().filter(|folder| folder.is_dir()).map(|folder| (folder, Place::User));
        for (path, place) in user.chain(places.named.iter().map(|path| (path, Place::Named))) {
            match if path.is_dir() { libraries(path) } else { fs::metadata(path).map(|_| vec![path.clone()]) }
            {
                Ok(files) => files.iter().for_each(|file| registry.add(file, place, trust)),
                Err(error) => registry.missing.push(format!("{}: {error}", path.display())),
            }
        }
        registry
    }

    fn add(&mut self, file: &Path, place: Place, trust: &TrustStore) {
        let found = DiscoveredDriver::at(file, place, trust);
        if !self.found.iter().any(|known| known.file == found.file) {
            self.found.push(found);
        }
    }
}

impl DiscoveredDriver {
    /// Judges one library.
    #[must_use]
    pub fn at(file: &Path, place: Place, trust: &TrustStore) -> Self {
        let refused = |error: io::Error| {
            (file.to_owned(), TrustStatus::Refused(LibraryRefusal::Unreadable(error.to_string())))
        };
        let (file, verdict) = match fs::canonicalize(file) {
            Ok(file) => judge(&file, place, trust).map_or_else(refused, |verdict| (file.clone(), verdict)),
            Err(error) => refused(error),
        };
        Self { file, place, verdict }
    }

    /// The id that its file name suggests: `libwirebend_driver_x_y.so` is `x-y`.
    #[must_use]
    pub fn suggested_id(&self) -> Option<String> {
        Some(stem(&self.file).strip_prefix(OWN)?.replace('_', "-"))
    }
}

fn judge(file: &Path, place: Place, trust: &TrustStore) -> io::Result<TrustStatus> {
    if !fs::metadata(file)?.is_file() {
        return Ok(TrustStatus::Refused(LibraryRefusal::NoFile));
    }
    if let Some(path) = writable_by_all(file)? {
        return Ok(TrustStatus::Refused(LibraryRefusal::WritableByAll(path)));
    }
    if place == Place::App {
        return Ok(TrustStatus::Shipped);
    }
    let hash = Fingerprint::of(file)?;
    Ok(match trust.accepted(file) {
        Some(accepted) if accepted == hash => TrustStatus::Accepted(hash),
        Some(_) => TrustStatus::Changed(hash),
        None => TrustStatus::Unknown(hash),
    })
}

/// The file or folder by which every user could put another library in the place of this one. Of a folder above, sticky ones
/// are safe: users can only rename there what is theirs.
#[cfg(unix)]
fn writable_by_all(file: &Path) -> io::Result<Option<PathBuf>> {
    use std::os::unix::fs::PermissionsExt;
    const WORLD: u32 = 0o002;
    const STICKY: u32 = 0o1000;
    for (depth, path) in file.ancestors().enumerate() {
        let mode = fs::metadata(path)?.permissions().mode();
        if mode & WORLD != 0 && (depth < 2 || mode & STICKY == 0) {
            return Ok(Some(path.to_owned()));
        }
    }
    Ok(None)
}

/// Other systems keep a person's folders to that person by default.
#[cfg(not(unix))]
fn writable_by_all(_file: &Path) -> io::Result<Option<PathBuf>> {
    Ok(None)
}

/// The libraries in a folder, by name.
fn libraries(folder: &Path) -> io::Result<Vec<PathBuf>> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.extension().is_some_and(|extension| extension == std::env::consts::DLL_EXTENSION) {
            files.push(path);
        }
    }
    files.sort();
    Ok(files)
}

/// The name of a library without what the system puts around it.
fn stem(file: &Path) -> String {
    let stem = file.file_stem().unwrap_or_default().to_string_lossy();
    stem.strip_prefix(std::env::consts::DLL_PREFIX).unwrap_or(&stem).to_owned()
}
