//! Words about profiles.

/// Why there is no change of a profile to take back.
#[must_use]
pub fn nothing_to_revert(id: &str, changed_elsewhere: bool) -> String {
    if changed_elsewhere {
        format!("the file of '{id}' was changed by something else after its last change by this program")
    } else {
        format!("this program has not changed '{id}' since it was made")
    }
}
