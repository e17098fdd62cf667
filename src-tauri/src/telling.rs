//! What the desk tells, on its way to the editor.

use std::sync::{Mutex, PoisonError};

use tauri::ipc::Channel;
use wirebend_app::{Listener, Tell};

/// Passes on what is told to the page that listens. A page that is loaded anew listens instead of the one before.
#[derive(Default)]
pub struct Telling(Mutex<Option<Channel<serde_json::Value>>>);

impl Telling {
    pub(crate) fn to(&self, channel: Channel<serde_json::Value>) {
        *self.0.lock().unwrap_or_else(PoisonError::into_inner) = Some(channel);
    }
}

impl Listener for Telling {
    fn hear(&self, tell: &Tell) {
        let channel = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let Some(channel) = channel.as_ref() else { return };
        let sent =
            serde_json::to_value(tell).map_err(tauri::Error::from).and_then(|value| channel.send(value));
        if let Err(error) = sent {
            tracing::debug!("the editor was not told: {error}");
        }
    }
}
