//! The system's dialogs for files.

use std::path::{Path, PathBuf};

use serde::Deserialize;
use tauri::{AppHandle, Manager, Runtime};
use tauri_plugin_dialog::{DialogExt, FilePath, MessageDialogButtons, MessageDialogKind};

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

/// A file to write; none where the person has chosen none. They are asked before a file is replaced.
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
    let Some(whole) = with_end(&path, &kind.extensions) else { return Some(path) };
    if !whole.exists() {
        return Some(whole);
    }
    // The system has asked about another name.
    let name = whole.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let question = app
        .dialog()
        .message(format!("There is a file {name} already. Replace it?"))
        .title("Replace the file?")
        .kind(MessageDialogKind::Warning)
        .buttons(MessageDialogButtons::YesNo);
    let yes = tauri::async_runtime::spawn_blocking(move || question.blocking_show()).await.ok()?;
    yes.then_some(whole)
}

/// The name with the first extension, where it has none of them; dots in it are part of the name.
fn with_end(path: &Path, extensions: &[String]) -> Option<PathBuf> {
    let name = path.file_name()?;
    let shown = name.to_string_lossy().to_lowercase();
    let has = |extension: &String| shown.ends_with(&format!(".{}", extension.to_lowercase()));
    let first = extensions.first().filter(|_| !extensions.iter().any(has))?;
    let mut whole = name.to_owned();
    if !shown.ends_with('.') {
        whole.push(".");
    }
    whole.push(first);
    Some(path.with_file_name(whole))
}

/// Says why the program cannot start, and ends it once that is read.
pub(crate) fn cannot_start<R: Runtime>(app: &AppHandle<R>, why: &str) {
    tracing::error!("the program cannot start: {why}");
    // A page without anything to ask would only fail.
    if let Some(window) = app.get_webview_window("main") {
        let _ = window.destroy();
    }
    let app = app.clone();
    app.dialog()
        .message(why)
        .title("WireBend-kit cannot start")
        .kind(MessageDialogKind::Error)
        .show(move |_| app.exit(1));
}

fn words(kind: &FileKind) -> Vec<&str> {
    kind.extensions.iter().map(String::as_str).collect()
}

fn chosen(path: Option<FilePath>) -> Option<PathBuf> {
    path?.into_path().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A file without the end of its kind is not found again; one with two ends is not what a person has typed.
    #[test]
    fn a_name_gets_its_end_once() {
        let kinds = |list: &[&str]| list.iter().map(|&one| one.to_owned()).collect::<Vec<_>>();
        let end = |name: &str, list: &[&str]| with_end(&Path::new("/here").join(name), &kinds(list));
        let other = |name: &str| Some(Path::new("/here").join(name));
        assert_eq!(end("phone", &["wirebend"]), other("phone.wirebend"));
        assert_eq!(end("phone.v2", &["wirebend"]), other("phone.v2.wirebend"));
        assert_eq!(end("phone.", &["wirebend"]), other("phone.wirebend"));
        assert_eq!(end("phone.wirebend", &["wirebend"]), None);
        assert_eq!(end("PHONE.WIREBEND", &["wirebend"]), None);
        assert_eq!(end("wire.gcode", &["nc", "gcode"]), None);
        assert_eq!(end("wire.txt", &["nc", "gcode"]), other("wire.txt.nc"));
        assert_eq!(end("wire", &[]), None);
    }
}
