//! What the editor asks, passed on.
#![allow(clippy::needless_pass_by_value, reason = "a command is given its state by value")]

use std::sync::Arc;

use tauri::State;
use tauri::ipc::{Channel, Response};
use wirebend_api::{ApiErrorReport, Workspace};

use crate::EventChannel;

type Shared<'a> = State<'a, Arc<Workspace>>;

/// Runs what may take long on a thread of its own, so that nothing else waits for it.
async fn blocking<T: Send + 'static>(work: impl FnOnce() -> T + Send + 'static) -> tauri::Result<T> {
    tauri::async_runtime::spawn_blocking(work).await
}

/// Why nothing came back.
fn failed(error: &tauri::Error) -> ApiErrorReport {
    tracing::error!("{error}");
    ApiErrorReport::failure(format!("the program failed on this: {error}; its log file has more"))
}

/// Sends a request to the workspace and returns its JSON unchanged.
#[tauri::command]
pub(crate) async fn ask(workspace: Shared<'_>, ask: serde_json::Value) -> Result<Response, ApiErrorReport> {
    let workspace = Arc::clone(&workspace);
    let answered = blocking(move || workspace.ask_value(ask)).await.map_err(|error| failed(&error))?;
    answered.map(|answer| Response::new(answer.get().to_owned()))
}

/// Stops the machine.
#[tauri::command]
pub(crate) async fn stop(workspace: Shared<'_>) -> Result<(), ApiErrorReport> {
    let workspace = Arc::clone(&workspace);
    blocking(move || workspace.stop()).await.map_err(|error| failed(&error))
}

/// The surface of a stencil of the open design, as bytes.
#[tauri::command]
pub(crate) async fn stencil_mesh(workspace: Shared<'_>, stencil: u32) -> Result<Response, ApiErrorReport> {
    let workspace = Arc::clone(&workspace);
    let bytes = blocking(move || workspace.stencil_mesh(stencil)).await.map_err(|error| failed(&error))?;
    Ok(Response::new(bytes))
}

/// From now on what the workspace reports goes to this channel.
#[tauri::command]
pub(crate) fn listen(event_channel: State<'_, Arc<EventChannel>>, channel: Channel<serde_json::Value>) {
    event_channel.to(channel);
}
