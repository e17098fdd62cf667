//! For collisions: wires that hit nothing, as walks to take.

use std::collections::BTreeSet;

use wirebend_files::document::Document;
use wirebend_planning::design::Opened;
use wirebend_planning::machine::Setup;
use wirebend_planning::{Installation, PlanChoices, Progress};

use super::super::{ChosenWalk, EditRequest};
use super::Candidate;

/// How many steps are checked for each number of wires: some seconds in all.
const EFFORT: u32 = 1000;

/// Goes on as long as somebody wants to know.
struct Wanted<'a>(&'a dyn Fn() -> bool);

impl Progress for Wanted<'_> {
    fn stage(&self, _name: &str) {}

    fn advance(&self, _done: u64, _of: u64) {}

    fn goes_on(&self) -> bool {
        (self.0)()
    }
}

/// Walks with which no wire hits anything, for all collisions of the design alike; none where none are found.
pub(super) fn without_collisions(
    document: &Document,
    setup: &Setup,
    goes_on: &dyn Fn() -> bool,
) -> Option<Candidate> {
    let doubles = !document.doublings.is_empty();
    let mut searched = document.clone();
    // Where edges are doubled, others may be.
    searched.doublings.clear();
    let choices = PlanChoices {
        double: doubles,
        avoid_collisions: true,
        search_effort: Some(EFFORT),
        ..PlanChoices::default()
    };
    let opened = Opened::of(String::new(), searched);
    let planned = Installation::plan_with(opened, setup.clone(), &choices, &Wanted(goes_on)).ok()?;
    if !planned.wires.iter().all(|wire| wire.searched.is_some_and(|searched| searched.found)) {
        return None;
    }
    let mut passed = BTreeSet::new();
    let mut doubled = Vec::new();
    let mut walks = Vec::new();
    for route in planned.wires.iter().filter_map(|wire| wire.route.as_ref()) {
        let edges: Vec<u32> = route.traversals.iter().map(|one| one.edge.0).collect();
        doubled.extend(edges.iter().copied().filter(|&edge| !passed.insert(edge)));
        walks.push(ChosenWalk { start: route.traversals.first()?.from.0, edges });
    }
    let wires = u32::try_from(walks.len()).ok()?;
    let parts = document.wireframe.components();
    let parts = parts.iter().filter(|part| !part.edges.is_empty()).count();
    let is_more = walks.len() > document.wires.get().max(parts);
    let title = if is_more {
        format!("Bend {wires} wires that hit nothing")
    } else {
        "Bend in an order that hits nothing".to_owned()
    };
    let more = is_more.then_some(EditRequest::Wires { wires });
    let doublings = doubles.then_some(EditRequest::Doublings { edges: doubled });
    // Walks come last: other choices of the wires put an end to them.
    let edits = more.into_iter().chain(doublings).chain([EditRequest::Walks { walks }]).collect();
    Some(Candidate { edit: EditRequest::Several { label: "order of the bends".to_owned(), edits }, title })
}
