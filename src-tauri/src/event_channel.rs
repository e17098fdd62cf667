//! What the workspace reports, on its way to the editor.

use std::sync::{Mutex, PoisonError};

use tauri::ipc::Channel;
use wirebend_api::{EventSink, WindowEvent};

/// Passes on what is reported to the page that listens. A page that is loaded anew listens instead of the one before.
#[derive(Default)]
pub struct EventChannel(Mutex<Option<Channel<serde_json::Value>>>);

impl EventChannel {
    pub(crate) fn to(&self, channel: Channel<serde_json::Value>) {
        *self.0.lock().unwrap_or_else(PoisonError::into_inner) = Some(channel);
    }
}

impl EventSink for EventChannel {
    fn emit(&self, event: &WindowEvent) {
        let channel = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let Some(channel) = channel.as_ref() else { return };
        let sent =
            serde_json::to_value(event).map_err(tauri::Error::from).and_then(|value| channel.send(value));
        if let Err(error) = sent {
            tracing::debug!("the editor was not notified: {error}");
        }
    }
}
