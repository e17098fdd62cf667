//! What a plan is made with: the request's choices, and the document's where it has none.

use wirebend_core::plan::DoublingChoice;
use wirebend_core::route::{Route, Share, doublings, share_out};
use wirebend_core::search::{Objective, SearchOptions};
use wirebend_core::wireframe::{Component, EdgeId, VertexId};
use wirebend_files::document::{Document, Walk};

use crate::PlanningError;
use crate::choices::PlanChoices;
use crate::report::NoteReport;

/// What was chosen of the wires: in the request, else in the document.
pub(super) struct WireChoice {
    pub wires: usize,
    pub closed: bool,
    pub reversed: bool,
}

impl WireChoice {
    pub fn of(document: &Document, choices: &PlanChoices) -> Result<Self, PlanningError> {
        // A closed wire is the only one of its part.
        let several = choices.wires.filter(|&wires| wires > 1);
        if let Some(wires) = several.filter(|_| choices.closed) {
            return Err(PlanningError::ClosedWires { wires });
        }
        let closed = choices.closed || document.closed && several.is_none();
        let wires = choices.wires.map_or(document.wires.get(), |wires| wires as usize);
        let wires = if closed { 1 } else { wires };
        Ok(Self { wires, closed, reversed: choices.reverse != document.reversed })
    }
}

/// The wanted start, where it is in this part of the design.
pub(super) fn start_in(part: &Component, start: Option<VertexId>) -> Option<VertexId> {
    start.filter(|vertex| part.vertices.binary_search(vertex).is_ok())
}

/// How the wires of a design are shared out to its parts, and what is doubled then at least: one wire for each part, and each
/// further one where it saves most.
pub fn wires_of_parts(
    document: &Document,
    parts: &[&Component],
    start: Option<VertexId>,
    wires: usize,
) -> Vec<Share> {
    let further = wires.saturating_sub(parts.len());
    if further == 0 {
        return parts.iter().map(|_| Share::default()).collect();
    }
    let curves = parts.iter().map(|part| {
        // Why there is no doubling, the plan of the part says.
        doublings(&document.wireframe, part, start_in(part, start), further + 1).unwrap_or_default()
    });
    share_out(curves.collect(), further)
}

/// The walks that the document has for a part of the design, where nothing else is chosen for them and they pass all of its edges.
pub(super) fn chosen_walks(
    document: &Document,
    part: &Component,
    choices: &PlanChoices,
    replaced: &mut Replaced,
) -> Vec<Route> {
    let PlanChoices { detours, wires, closed, start, reverse, keep_order, avoid_collisions, .. } = choices;
    let otherwise = *detours || *closed || *reverse || *keep_order || *avoid_collisions;
    let here = |edge: &EdgeId| part.edges.binary_search(edge).is_ok();
    let walks: Vec<&Walk> = document.walks.iter().filter(|walk| walk.edges.iter().any(here)).collect();
    if otherwise || wires.is_some() || start.is_some() || walks.is_empty() {
        return Vec::new();
    }
    let mut passed: Vec<EdgeId> = walks.iter().flat_map(|walk| walk.edges.iter().copied()).collect();
    passed.sort_unstable();
    passed.dedup();
    let routes: Option<Vec<Route>> =
        walks.iter().map(|walk| Route::along(&document.wireframe, walk.start, &walk.edges)).collect();
    let routes = routes.filter(|_| passed == part.edges).unwrap_or_default();
    if routes.is_empty() {
        replaced.walks += walks.len();
    }
    routes
}

/// What the document has accepted and what is not used.
#[derive(Default)]
pub(super) struct Replaced {
    /// Walks that do not pass all edges of their part.
    walks: usize,
    /// With them there is no route.
    routeless: usize,
    /// So many wires need less.
    dearer: usize,
}

impl Replaced {
    pub fn notes(&self) -> impl Iterator<Item = NoteReport> {
        let note = |(count, why): (usize, &str)| NoteReport {
            code: "doublings-replaced".into(),
            count,
            message: format!(
                "{} {why}: the cheapest ones are used instead",
                if count == 1 {
                    "1 accepted doubling".to_owned()
                } else {
                    format!("{count} accepted doublings")
                }
            ),
            remedies: Vec::new(),
        };
        let dearer = (self.dearer, "add more length than so many wires need");
        let walks = (self.walks > 0).then(|| NoteReport {
            code: "walks-replaced".into(),
            count: self.walks,
            message:
                "the chosen walks do not run along all edges of the design without a gap: they are found anew"
                    .to_owned(),
            remedies: Vec::new(),
        });
        let all = [(self.routeless, "leave no route"), dearer].into_iter();
        all.filter(|(count, _)| *count > 0).map(note).chain(walks)
    }
}

/// The doublings that the document has accepted, where they make a route possible from the wanted start or nothing
/// else was asked for; else the cheapest. Further wires that are asked for are to save doublings, accepted ones, too.
pub(super) fn doubling_choice(
    document: &Document,
    component: &Component,
    choices: &PlanChoices,
    chosen: &WireChoice,
    (start, share): (Option<VertexId>, &Share),
    replaced: &mut Replaced,
) -> DoublingChoice {
    let here = |edge: &EdgeId| component.edges.binary_search(edge).is_ok();
    let accepted: Vec<EdgeId> = document.doublings.iter().copied().filter(here).collect();
    let odd = document.wireframe.odd_vertices(component, &accepted);
    // An open wire whose ends are odd begins at one of them.
    let begins = start.is_none_or(|start| odd.is_empty() || odd.contains(&start));
    let ends = if chosen.closed { 0 } else { 2 * share.wires };
    if choices.double && choices.avoid_collisions && accepted.is_empty() {
        return DoublingChoice::Cheapest;
    }
    if choices.double && (!begins || odd.len() > ends) {
        replaced.routeless += accepted.len();
        return DoublingChoice::Cheapest;
    }
    let further = choices.double && choices.wires.is_some() && share.wires > 1;
    let least = share.doubling.as_ref().filter(|_| further);
    let added = accepted.iter().map(|&edge| document.wireframe.edge_length(edge)).sum();
    if least.is_some_and(|least| !least.is_matched_by(added)) {
        replaced.dearer += accepted.len();
        return DoublingChoice::Cheapest;
    }
    DoublingChoice::Accepted(accepted)
}

/// How many wires the search for a part of the design may use: where a number of wires is chosen, the share of the part and the wires that
/// are left over, which save nothing that is doubled.
pub(super) struct Allowance {
    is_chosen: bool,
    spare: usize,
}

impl Allowance {
    pub fn of(choices: &PlanChoices, chosen: &WireChoice, shares: &[Share]) -> Self {
        let shared: usize = shares.iter().map(|share| share.wires).sum();
        let is_chosen = choices.wires.is_some() || chosen.wires > 1;
        Self { is_chosen, spare: chosen.wires.saturating_sub(shared) }
    }

    /// How to search, where that is wanted.
    pub fn search(&self, choices: &PlanChoices, share: &Share) -> Option<SearchOptions> {
        let usual = SearchOptions::default();
        choices.avoid_collisions.then(|| SearchOptions {
            effort: choices.search_effort.map_or(usual.effort, u64::from),
            seed: choices.search_seed.unwrap_or(usual.seed),
            objective: choices.search_weights.map_or(Objective::InOrder, Objective::from),
            max_wires: if self.is_chosen { share.wires + self.spare } else { usual.max_wires },
        })
    }

    /// So many wires are used for a part.
    pub fn use_up(&mut self, share: &Share, used: usize) {
        self.spare = self.spare.saturating_sub(used.saturating_sub(share.wires));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every front end has the same rule, whatever it leaves to a person to choose.
    #[test]
    fn a_closed_wire_is_refused_beside_others() {
        let mut document = Document::new(wirebend_core::wireframe::Wireframe::new());
        let chosen = |document: &Document, closed, wires| {
            let choices = PlanChoices { wires, closed, ..PlanChoices::default() };
            WireChoice::of(document, &choices).map(|chosen| (chosen.closed, chosen.wires))
        };
        let refused = chosen(&document, true, Some(3)).unwrap_err().to_string();
        assert!(refused.contains("closed route") && refused.contains("number of wires is 3"), "{refused}");
        assert_eq!(chosen(&document, true, Some(1)).unwrap(), (true, 1));
        assert_eq!(chosen(&document, true, None).unwrap(), (true, 1));
        document.closed = true;
        assert_eq!(chosen(&document, false, Some(1)).unwrap(), (true, 1), "one wire may stay closed");
        assert_eq!(chosen(&document, false, Some(3)).unwrap(), (false, 3));
    }
}
