//! For flaws of the drawing: what lies on each other is merged, what is too much is deleted.

use wirebend_core::checks::Code;
use wirebend_files::document::Document;

use super::super::{EditRequest, MergePlace};
use super::{Candidate, Finding};
use wirebend_planning::design::default_weld_mm;

/// What fixes a flaw of the drawing.
pub(super) fn candidates(finding: Finding, all: &[Finding], document: &Document) -> Vec<Candidate> {
    let location = &finding.diagnostic.location;
    match (finding.diagnostic.code(), location.vertices.as_slice(), location.edges.as_slice()) {
        (Code::ZeroLengthEdge, _, &[edge, ..]) => {
            let Some(ends) = document.wireframe.edge(edge) else { return Vec::new() };
            let delete = Candidate {
                title: format!("Delete edge {edge}"),
                edit: EditRequest::Delete { vertices: Vec::new(), edges: vec![edge.0], lines: Vec::new() },
            };
            if ends.a == ends.b {
                vec![delete]
            } else {
                vec![merged(ends.ends().0.0, ends.ends().1.0), delete]
            }
        }
        (Code::ParallelEdges, _, edges) => edges
            .iter()
            .map(|edge| Candidate {
                title: format!("Delete edge {edge}"),
                edit: EditRequest::Delete { vertices: Vec::new(), edges: vec![edge.0], lines: Vec::new() },
            })
            .collect(),
        (Code::CoincidentVertices, &[id, first, ..], _) => {
            let same = |other: &&Finding| other.diagnostic.code() == Code::CoincidentVertices;
            let count = all.iter().filter(same).count();
            let foremost =
                all.iter().find(same).is_some_and(|other| std::ptr::eq(other.diagnostic, finding.diagnostic));
            let mut found = vec![merged(first.0, id.0)];
            if count > 1 && foremost {
                found.push(Candidate {
                    title: format!("Merge all {count} pairs of vertices that lie on each other"),
                    edit: EditRequest::Weld { tolerance_mm: default_weld_mm() },
                });
            }
            found
        }
        (Code::IsolatedVertex, &[vertex, ..], _) => vec![Candidate {
            title: format!("Delete vertex {vertex}"),
            edit: EditRequest::Delete { vertices: vec![vertex.0], edges: Vec::new(), lines: Vec::new() },
        }],
        _ => Vec::new(),
    }
}

pub(super) fn merged(stays: u32, goes: u32) -> Candidate {
    Candidate {
        title: format!("Merge vertices {stays} and {goes}"),
        edit: EditRequest::Merge { vertices: vec![stays, goes], at: MergePlace::First },
    }
}
