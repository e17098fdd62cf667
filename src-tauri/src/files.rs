//! Files that the system asks to open: by an argument, a double click, or a second start of the program.

use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use tauri::{AppHandle, Emitter, Manager, Runtime, State};

/// Files that wait until the editor is there.
#[derive(Debug, Default)]
pub struct FilesToOpen(Mutex<Waiting>);

#[derive(Debug, Default)]
struct Waiting {
    files: Vec<PathBuf>,
    /// The editor has asked once: it hears of later ones by an event.
    asked: bool,
}

impl FilesToOpen {
    /// Files of the first start.
    #[must_use]
    pub fn new(files: Vec<PathBuf>) -> Self {
        Self(Mutex::new(Waiting { files, asked: false }))
    }

    /// The files that wait, once.
    fn take(&self) -> Vec<PathBuf> {
        let mut waiting = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        waiting.asked = true;
        std::mem::take(&mut waiting.files)
    }

    /// Whether the editor hears of it itself; otherwise it waits.
    fn add(&self, file: &Path) -> bool {
        let mut waiting = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if !waiting.asked {
            waiting.files.push(file.to_owned());
        }
        waiting.asked
    }
}

/// The files that a command line names after the program, seen from the folder that it was given in.
pub(crate) fn named(words: &[OsString], folder: &Path) -> Vec<PathBuf> {
    let is_option = |word: &OsString| word.as_encoded_bytes().starts_with(b"-");
    words.iter().skip(1).filter(|word| !is_option(word)).map(|word| folder.join(word)).collect()
}

/// The files that were named before the editor was there.
#[allow(clippy::needless_pass_by_value, reason = "a command is given its state by value")]
#[tauri::command]
pub(crate) fn files_to_open(files: State<'_, FilesToOpen>) -> Vec<PathBuf> {
    files.take()
}

/// Opens files once the editor is there.
pub(crate) fn open_later<R: Runtime>(app: &AppHandle<R>, files: &[PathBuf]) {
    let waiting = app.state::<FilesToOpen>();
    for file in files.iter().filter(|file| waiting.add(file)) {
        if let Err(error) = app.emit("open-file", file) {
            tracing::error!("{} was not opened: {error}", file.display());
        }
    }
}

/// On a Mac, files come as an event and not as an argument.
pub(crate) fn asked_by_system<R: Runtime>(app: &AppHandle<R>, event: &tauri::RunEvent) {
    #[cfg(any(target_os = "macos", target_os = "ios"))]
    if let tauri::RunEvent::Opened { urls } = event {
        open_later(app, &urls.iter().filter_map(|url| url.to_file_path().ok()).collect::<Vec<_>>());
    }
    #[cfg(not(any(target_os = "macos", target_os = "ios")))]
    let _ = (app, event);
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A relative name means the folder that the second start was made in, not that of the first.
    #[test]
    fn names_are_seen_from_the_folder_of_their_command_line() {
        let words = ["wirebend-kit", "--flag", "a.wirebend", "/there/c.obj"].map(OsString::from);
        let expected = vec![PathBuf::from("/here/a.wirebend"), PathBuf::from("/there/c.obj")];
        assert_eq!(named(&words, Path::new("/here")), expected);
    }

    /// A file that is not named in this encoding would end the program before its window is there.
    #[cfg(unix)]
    #[test]
    fn a_name_of_any_bytes_is_a_name() {
        use std::os::unix::ffi::OsStringExt;
        let name = OsString::from_vec(b"caf\xe9.wirebend".to_vec());
        let words = [OsString::from("wirebend-kit"), name.clone()];
        assert_eq!(named(&words, Path::new("/here")), [Path::new("/here").join(name)]);
    }

    /// A file would be opened twice, or never.
    #[test]
    fn a_file_waits_or_is_told_and_never_both() {
        let files = FilesToOpen::new(vec![PathBuf::from("first")]);
        assert!(!files.add(Path::new("second")));
        assert_eq!(files.take(), [PathBuf::from("first"), PathBuf::from("second")]);
        assert!(files.add(Path::new("third")));
        assert!(files.take().is_empty());
    }
}
