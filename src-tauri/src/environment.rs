//! What the system around the window needs.

use tauri::{AppHandle, Runtime, WebviewWindow};

/// Before anything else of the program runs.
pub(crate) fn prepare() {
    #[cfg(target_os = "linux")]
    linux::prepare();
}

/// Ctrl-Space stops the machine even while the editor is busy: the window's own loop hears the key before the page.
///
/// # Errors
/// When the window is not there any more.
pub(crate) fn stop_by_key<R: Runtime>(app: &AppHandle<R>, window: &WebviewWindow<R>) -> tauri::Result<()> {
    #[cfg(target_os = "linux")]
    linux::stop_by_key(app, window)?;
    #[cfg(not(target_os = "linux"))]
    let _ = (app, window);
    Ok(())
}

#[cfg(target_os = "linux")]
mod linux {
    use std::sync::Arc;

    use gtk::gdk::{ModifierType, keys};
    use gtk::glib::Propagation;
    use gtk::prelude::WidgetExt;
    use tauri::{AppHandle, Manager, Runtime, WebviewWindow};
    use wirebend_api::Workspace;

    /// With some graphics drivers the page stays empty unless this is set.
    const RENDERER: &str = "WEBKIT_DISABLE_DMABUF_RENDERER";

    #[allow(unsafe_code, reason = "no other thread runs yet that could read the environment meanwhile")]
    pub fn prepare() {
        if std::env::var_os(RENDERER).is_none() {
            // SAFETY: this is the only thread; it is called first of all.
            unsafe { std::env::set_var(RENDERER, "1") };
        }
    }

    pub fn stop_by_key<R: Runtime>(app: &AppHandle<R>, window: &WebviewWindow<R>) -> tauri::Result<()> {
        let workspace = Arc::clone(&app.state::<Arc<Workspace>>());
        window.gtk_window()?.connect_key_press_event(move |_, event| {
            let held = event.state().contains(ModifierType::CONTROL_MASK);
            if held && event.keyval() == keys::constants::space {
                let workspace = Arc::clone(&workspace);
                std::thread::spawn(move || workspace.stop());
            }
            Propagation::Proceed
        });
        Ok(())
    }
}
