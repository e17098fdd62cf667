//! What came of the searches for wires that hit nothing, of all parts of a design together.

use wirebend_core::plan::{Searched, WirePlan};

use super::Planned;
use crate::report::SearchReport;

impl Planned {
    /// What came of them; none where nobody searched, or not for every part.
    pub fn searched(&self) -> Option<SearchReport> {
        let wires = self.wires.iter();
        let searched: Vec<&Searched> = wires.map(|wire| wire.searched.as_ref()).collect::<Option<_>>()?;
        let components = self.opened.document.wireframe.components();
        let part = |wire: &WirePlan| {
            let first = wire.component.edges.first()?;
            components.iter().position(|component| component.edges.binary_search(first).is_ok())
        };
        // The wires of a part come one after the other, and were found by one search.
        let mut parts: Vec<_> = self.wires.iter().map(part).zip(searched).collect();
        parts.dedup_by_key(|(part, _)| *part);
        let (_, first) = parts.first()?;
        Some(SearchReport {
            found: parts.iter().all(|(_, searched)| searched.found),
            steps_checked: parts.iter().map(|(_, searched)| searched.checks).sum(),
            ended: parts.iter().any(|(_, searched)| searched.ended),
            ..SearchReport::from(*first)
        })
    }
}
