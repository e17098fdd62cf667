//! The system's dialogs for files.

use std::path::{Path, PathBuf};

use serde::Deserialize;
use tauri::{AppHandle, Runtime};
use tauri_plugin_dialog::{DialogExt, FilePath};

/// A kind of files.
#[derive(Debug, Deserialize)]
pub(crate) struct FileKind {
    name: String,
    /// Without the dot.
    extensions: Vec<String>,
}

/// A file to open; none where the person has chosen none.
#[tauri::command]
pub(crate) async fn pick_file<R: Runtime>(app: AppHandle<R>, kinds: Vec<FileKind>) -> Option<PathBuf> {
    let mut dialog = app.dialog().file();
    for kind in &kinds {
        dialog = dialog.add_filter(&kind.name, &words(kind));
    }
    chosen(tauri::async_runtime::spawn_blocking(move || dialog.blocking_pick_file()).await.ok()?)
}

/// A file to write; none where the person has chosen none. The dialog asks before a file is replaced.
#[tauri::command]
pub(crate) async fn pick_save<R: Runtime>(
    app: AppHandle<R>,
    suggested: String,
    kind: FileKind,
) -> Option<PathBuf> {
    let mut dialog = app.dialog().file().add_filter(&kind.name, &words(&kind));
    let suggested = Path::new(&suggested);
    if let Some(folder) = suggested.parent().filter(|folder| folder.is_dir()) {
        dialog = dialog.set_directory(folder);
    }
    if let Some(name) = suggested.file_name() {
        dialog = dialog.set_file_name(name.to_string_lossy());
    }
    let path = chosen(tauri::async_runtime::spawn_blocking(move || dialog.blocking_save_file()).await.ok()?)?;
    // A name that was typed without its end gets it.
    match (path.extension(), kind.extensions.first()) {
        (None, Some(extension)) => Some(path.with_extension(extension)),
        _ => Some(path),
    }
}

fn words(kind: &FileKind) -> Vec<&str> {
    kind.extensions.iter().map(String::as_str).collect()
}

fn chosen(path: Option<FilePath>) -> Option<PathBuf> {
    path?.into_path().ok()
}
