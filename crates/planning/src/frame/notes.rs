//! What a person should know of some of a frame's edges.

use crate::report::NoteReport;

/// A note about so many edges, `says` with their number in words; none about none.
pub(super) fn about_edges(
    code: &'static str,
    count: usize,
    says: impl FnOnce(&str) -> String,
) -> Option<NoteReport> {
    let of = if count == 1 { "1 edge".to_owned() } else { format!("{count} edges") };
    (count > 0).then(|| NoteReport { code: code.into(), count, message: says(&of), remedies: Vec::new() })
}
