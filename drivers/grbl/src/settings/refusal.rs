//! The error for a setting that is refused.

use wirebend_driver_api::DriverError;

pub(super) fn refuse(what: String, help: impl Into<String>) -> DriverError {
    DriverError::new("settings", what, help)
}
