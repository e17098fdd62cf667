//! What a person should know of a frame, and of some of its edges.

use std::collections::BTreeMap;

use wirebend_core::wireframe::{EdgeId, VertexId, Wireframe};

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

/// A support that holds nothing is worth knowing of.
pub(crate) fn unused_supports(wireframe: &Wireframe, held: &[VertexId]) -> Option<NoteReport> {
    let unused: Vec<VertexId> =
        held.iter().copied().filter(|&vertex| wireframe.incident(vertex).is_empty()).collect();
    let ids: Vec<String> = unused.iter().take(6).map(ToString::to_string).collect();
    let more = if unused.len() > ids.len() { " and others" } else { "" };
    (!unused.is_empty()).then(|| NoteReport {
        code: "support-unused".into(),
        count: unused.len(),
        message: format!("no strut ends at the support at vertex {}{more}: it holds nothing", ids.join(", ")),
        remedies: Vec::new(),
    })
}

/// Edges between the same vertices are struts in the same place, each of which is computed and built.
pub(crate) fn doubled_struts(wireframe: &Wireframe) -> Option<NoteReport> {
    let mut first: BTreeMap<(VertexId, VertexId), EdgeId> = BTreeMap::new();
    let mut doubled = Vec::new();
    for (id, edge) in wireframe.edges() {
        let earlier = *first.entry(edge.ends()).or_insert(id);
        if earlier != id {
            doubled.push((earlier, id, edge.ends()));
        }
    }
    let (earlier, later, (a, b)) = *doubled.first()?;
    let more = match doubled.len() - 1 {
        0 => String::new(),
        1 => ", and 1 more edge lies on another".to_owned(),
        more => format!(", and {more} more edges lie on others"),
    };
    Some(NoteReport {
        code: "doubled-strut".into(),
        count: doubled.len(),
        message: format!(
            "edges {earlier} and {later} both join vertices {a} and {b}{more}: each is a strut of its own"
        ),
        remedies: Vec::new(),
    })
}
