//! The window: it passes what the editor asks on to [`wirebend_api::Workspace`], and what that reports back to the editor.
//! Nothing is decided or computed here.

mod adapters;
mod dialogs;
mod environment;
mod event_channel;
mod files;
mod log;
mod on_screen;

use std::ffi::{OsStr, OsString};
use std::io::Write;
use std::process::ExitCode;
use std::sync::Arc;

use anyhow::Context;
use tauri::webview::PageLoadEvent;
use tauri::{Manager, RunEvent, Runtime};
use tauri_plugin_window_state::StateFlags;
use wirebend_api::{Places, Workspace};

pub use event_channel::EventChannel;
pub use files::FilesToOpen;
use log::LogGuard;

/// Runs the program with the arguments of the process.
#[must_use]
pub fn main() -> ExitCode {
    // The process of a driver is this program too, and knows of nothing else.
    let mut words = std::env::args_os().skip(1);
    let first = words.next();
    if first.as_deref().is_some_and(|word| word == wirebend_api::CHILD_COMMAND) {
        return wirebend_api::child_main(&words.collect::<Vec<_>>());
    }
    if let Some(text) = first.as_deref().and_then(OsStr::to_str).and_then(told_at_once) {
        // A reader that has closed the output wants nothing more.
        let _ = writeln!(std::io::stdout(), "{text}");
        return ExitCode::SUCCESS;
    }
    environment::prepare();
    let places = Places::of_person();
    let log = log::begin(places.state.as_deref());
    match run(places, log) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            tracing::error!("{error:#}");
            ExitCode::FAILURE
        }
    }
}

/// What is asked of every program, and opens no window.
fn told_at_once(word: &str) -> Option<&'static str> {
    match word {
        "-h" | "--help" => Some(concat!(
            "The window of WireBend-kit ",
            env!("CARGO_PKG_VERSION"),
            "\n\nUsage: wirebend-kit [FILE]\n\nFILE is a design (.wirebend), a model, a drawing or a table of bends. Without a window: `wirebend --help`."
        )),
        "-V" | "--version" => Some(concat!("wirebend-kit ", env!("CARGO_PKG_VERSION"))),
        _ => None,
    }
}

/// `log` is held until the end: what ends here is the process.
fn run(places: Places, mut log: Option<LogGuard>) -> anyhow::Result<()> {
    let event_channel = Arc::new(EventChannel::default());
    let builder = tauri::Builder::default()
        // It has to be the first: a second process is over before it does anything else.
        .plugin(tauri_plugin_single_instance::init(|app, words, folder| {
            let words: Vec<OsString> = words.into_iter().map(OsString::from).collect();
            files::open_later(app, &files::named(&words, std::path::Path::new(&folder)));
            if let Some(window) = app.get_webview_window("main") {
                let _ = window.unminimize();
                let _ = window.set_focus();
            }
        }))
        .plugin(tauri_plugin_dialog::init())
        .plugin(tauri_plugin_window_state::Builder::new().with_state_flags(kept()).build());
    let words: Vec<OsString> = std::env::args_os().collect();
    let folder = std::env::current_dir().unwrap_or_default();
    let files = FilesToOpen::new(files::named(&words, &folder));
    let app = with_adapters(builder, Arc::clone(&event_channel), files)
        .on_page_load(|webview, page| {
            if page.event() == PageLoadEvent::Finished {
                on_screen::bring_back(&webview.window());
            }
        })
        // Here, since a second process does not come so far: it leaves no journal of a design behind.
        .setup(move |app| {
            match Workspace::new(places, event_channel) {
                Ok(workspace) => {
                    app.manage(Arc::new(workspace));
                    if let Some(window) = app.get_webview_window("main") {
                        environment::stop_by_key(app.handle(), &window)?;
                    }
                }
                Err(error) => dialogs::cannot_start(app.handle(), &error.to_string()),
            }
            Ok(())
        })
        .build(tauri::generate_context!())
        .context("the window cannot be opened")?;
    app.run(move |app, event| {
        files::asked_by_system(app, &event);
        let workspace = app.try_state::<Arc<Workspace>>();
        match (event, workspace) {
            (RunEvent::Exit, workspace) => {
                if let Some(workspace) = workspace {
                    workspace.leave();
                }
                // The last lines are written.
                drop(log.take());
            }
            // The window is gone, and why is still to be read.
            (RunEvent::ExitRequested { code: None, api, .. }, None) => api.prevent_exit(),
            _ => {}
        }
    });
    Ok(())
}

/// Where the window was and how large; not that it was hidden.
fn kept() -> StateFlags {
    StateFlags::POSITION | StateFlags::SIZE | StateFlags::MAXIMIZED
}

/// Everything that the editor may ask for. The workspace is managed by the code that creates it.
pub fn with_adapters<R: Runtime>(
    builder: tauri::Builder<R>,
    event_channel: Arc<EventChannel>,
    files: FilesToOpen,
) -> tauri::Builder<R> {
    builder.manage(event_channel).manage(files).invoke_handler(tauri::generate_handler![
        adapters::ask,
        adapters::stop,
        adapters::stencil_mesh,
        adapters::listen,
        dialogs::pick_file,
        dialogs::pick_save,
        files::files_to_open,
    ])
}
