//! Files that the file which is read names: they are looked for in its folder and the folders in that, and nowhere else.

use std::path::{Component, Path, PathBuf};

use super::error::ReadError;
use super::read_up_to;
use super::text::excerpt;

/// How many bytes of such files are read for one model: as many as of a mesh.
const MAX_BYTES: u64 = 512 << 20;
/// How many names an error lists.
const MAX_LISTED: usize = 20;

/// The folder of a file.
#[derive(Debug)]
pub(super) struct Beside<'a> {
    /// None for bytes that come from no folder.
    folder: Option<&'a Path>,
    /// How many bytes may still be read.
    left: u64,
}

impl<'a> Beside<'a> {
    pub(super) fn new(folder: Option<&'a Path>) -> Self {
        Self { folder, left: MAX_BYTES }
    }

    /// The bytes of a file, named by a relative URI; none where [`Self::find`] does not find it.
    ///
    /// # Errors
    /// [`ReadError::Io`] and [`ReadError::TooLarge`].
    pub(super) fn read(&mut self, uri: &str) -> Result<Option<Vec<u8>>, ReadError> {
        let Ok(path) = self.find(uri) else { return Ok(None) };
        let bytes = read_up_to(&path, self.left)?;
        self.left = self.left.saturating_sub(bytes.len() as u64);
        Ok(Some(bytes))
    }

    /// Where a file is, or why it is not read.
    fn find(&self, uri: &str) -> Result<PathBuf, &'static str> {
        let relative = relative(uri)?;
        let path = self.folder.ok_or("its folder is not known")?.join(relative);
        // A pipe or a device would be read without end.
        match std::fs::metadata(&path) {
            Ok(found) if found.is_file() => Ok(path),
            Ok(_) => Err("this is no file"),
            Err(_) => Err("there is no such file beside it"),
        }
    }

    /// Of the files that a file names those that cannot be read.
    pub(super) fn missing<'b>(&self, file: &str, uris: impl Iterator<Item = &'b str>) -> ReadError {
        let missing = uris.filter_map(|uri| Some((uri, self.find(uri).err()?)));
        let mut listed: Vec<String> = missing.map(|(uri, why)| format!("{} ({why})", excerpt(uri))).collect();
        if let Some(more) = listed.len().checked_sub(MAX_LISTED).filter(|more| *more > 0) {
            listed.truncate(MAX_LISTED);
            listed.push(format!("{more} more"));
        }
        let from_folder = self.folder.is_some();
        ReadError::Elsewhere { file: file.to_owned(), missing: listed.join(", "), from_folder }
    }
}

/// A URI as a path within a folder.
fn relative(uri: &str) -> Result<PathBuf, &'static str> {
    const OUTSIDE: &str = "only files beside it are read";
    let name = decoded(uri).ok_or("this is no file name")?;
    // A colon is behind a scheme or a drive; a backslash parts folders on some computers.
    if name.contains([':', '\\', '\0']) {
        return Err(OUTSIDE);
    }
    let path = PathBuf::from(name);
    let within = |part: Component<'_>| matches!(part, Component::Normal(_) | Component::CurDir);
    if path.components().next().is_none() || !path.components().all(within) {
        return Err(OUTSIDE);
    }
    Ok(path)
}

/// Without the %20 and the like of a URI.
fn decoded(uri: &str) -> Option<String> {
    let mut bytes = Vec::with_capacity(uri.len());
    let mut parts = uri.split('%');
    bytes.extend(parts.next().unwrap_or_default().bytes());
    for part in parts {
        let (digits, rest) = part.split_at_checked(2)?;
        if !digits.bytes().all(|digit| digit.is_ascii_hexdigit()) {
            return None;
        }
        bytes.push(u8::from_str_radix(digits, 16).ok()?);
        bytes.extend(rest.bytes());
    }
    String::from_utf8(bytes).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_is_in_the_folder_is_named() {
        for (uri, path) in
            [("a.bin", "a.bin"), ("my%20mesh.bin", "my mesh.bin"), ("./parts/%C3%A4.bin", "./parts/ä.bin")]
        {
            assert_eq!(relative(uri), Ok(PathBuf::from(path)));
        }
        let outside = [
            "",
            "/a.bin",
            "../a.bin",
            "parts/../../a.bin",
            "%2e%2e/a.bin",
            "..\\a.bin",
            "file:///a.bin",
            "C:a.bin",
            "http://a/b.bin",
            "%2Fa.bin",
            "a%00.bin",
            "a%zz.bin",
            "a%+1.bin",
            "a%4",
            "%ff.bin",
        ];
        for uri in outside {
            assert!(relative(uri).is_err(), "{uri}");
        }
    }
}
