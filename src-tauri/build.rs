//! Permissions of the commands, so that a capability has to name each that the window may give.

fn main() {
    let commands = &["ask", "stop", "stencil_mesh", "listen", "pick_file", "pick_save", "files_to_open"];
    let manifest = tauri_build::AppManifest::new().commands(commands);
    if let Err(error) = tauri_build::try_build(tauri_build::Attributes::new().app_manifest(manifest)) {
        println!("cargo::error={error:#}");
    }
}
