//! For collisions: wires that hit nothing, as walks to take.

use std::cell::Cell;
use std::collections::BTreeSet;

use wirebend_core::checks::{Code, Diagnostic};
use wirebend_core::plan::WirePlan;
use wirebend_core::route::Route;
use wirebend_core::search::{Change, Help, MovedVertex};
use wirebend_core::units::Length;
use wirebend_core::wireframe::Component;
use wirebend_files::document::Document;
use wirebend_planning::design::Opened;
use wirebend_planning::machine::Setup;
use wirebend_planning::plan::Planned;
use wirebend_planning::{FoundSoFar, Installation, PlanChoices, PlanningError, Progress};

use super::super::{ChosenWalk, EditRequest, Placed};
use super::{Candidate, shown_mm};

/// How many steps are checked for each number of wires, where a person has not asked for a search: some seconds in all.
const QUICK_EFFORT: u32 = 1000;

/// Goes on as long as somebody wants to know.
struct Wanted<'a>(&'a dyn Fn() -> bool);

impl Progress for Wanted<'_> {
    fn stage(&self, _name: &str) {}

    fn advance(&self, _done: u64, _of: u64) {}

    fn goes_on(&self) -> bool {
        (self.0)()
    }
}

/// Tells of a plan how far its searches are, and nothing else.
pub(super) struct Steps<'a> {
    pub progress: &'a dyn Progress,
    pub searches: Cell<bool>,
}

impl Progress for Steps<'_> {
    fn stage(&self, name: &str) {
        self.searches.set(false);
        self.progress.stage(name);
    }

    fn search(&self, name: &str) {
        self.searches.set(true);
        self.progress.search(name);
    }

    fn advance(&self, done: u64, of: u64) {
        if self.searches.get() {
            self.progress.advance(done, of);
        }
    }

    fn found(&self, found: FoundSoFar) {
        self.progress.found(found);
    }

    fn goes_on(&self) -> bool {
        self.progress.goes_on()
    }
}

/// Walks with which no wire hits anything, for all collisions of the design alike; none where none are found.
pub(super) fn without_collisions(
    document: &Document,
    setup: &Setup,
    goes_on: &dyn Fn() -> bool,
) -> Option<Candidate> {
    let choices = PlanChoices { search_effort: Some(QUICK_EFFORT), ..PlanChoices::default() };
    let searched = SearchedDesign::of(document, setup, choices, &Wanted(goes_on)).ok()?;
    searched.found().then(|| searched.best()).flatten()
}

/// A design with the wires that a search has given it.
pub(super) struct SearchedDesign<'a> {
    document: &'a Document,
    pub planned: Planned,
    /// Whether edges may be doubled.
    doubles: bool,
}

/// A part of the design with the wires that are bent for it.
pub(super) struct Part<'a> {
    pub component: Component,
    pub wires: Vec<&'a WirePlan>,
}

impl Part<'_> {
    fn walks(&self) -> impl Iterator<Item = &Route> {
        self.wires.iter().filter_map(|wire| wire.route.as_ref())
    }

    /// That nothing was found for it.
    pub fn unfound(&self) -> Option<&Diagnostic> {
        let mut said = self.wires.iter().flat_map(|wire| &wire.diagnostics);
        said.find(|said| said.code() == Code::NoClearProgram)
    }
}

impl<'a> SearchedDesign<'a> {
    pub fn of(
        document: &'a Document,
        setup: &Setup,
        choices: PlanChoices,
        progress: &dyn Progress,
    ) -> Result<Self, PlanningError> {
        let doubles = !document.doublings.is_empty();
        let mut searched = document.clone();
        // Where edges are doubled, others may be.
        searched.doublings.clear();
        let choices = PlanChoices { double: doubles, avoid_collisions: true, ..choices };
        let opened = Opened::of(String::new(), searched);
        let planned = Installation::plan_with(opened, setup.clone(), &choices, progress)?;
        Ok(Self { document, planned, doubles })
    }

    /// Whether no wire hits anything.
    pub fn found(&self) -> bool {
        self.planned.wires.iter().all(|wire| wire.searched.is_some_and(|searched| searched.found))
    }

    /// Its parts that are bent.
    pub fn parts(&self) -> Vec<Part<'_>> {
        let components = self.document.wireframe.components();
        let bent = components.into_iter().filter(|component| !component.edges.is_empty());
        let part = |component: Component| {
            let is_here = |wire: &&WirePlan| {
                let first = wire.component.edges.first();
                first.is_some_and(|edge| component.edges.binary_search(edge).is_ok())
            };
            Part { wires: self.planned.wires.iter().filter(is_here).collect(), component }
        };
        bent.map(part).collect()
    }

    /// The wires that it has: such that hit nothing where they were found, else those that hit least of the ones that were there.
    pub fn best(&self) -> Option<Candidate> {
        let parts = self.parts();
        let walks: Vec<&Route> = parts.iter().flat_map(Part::walks).collect();
        if walks.len() < self.planned.wires.len() {
            return None;
        }
        let title = match (self.found(), self.more_than_now(walks.len())) {
            (false, _) => "Bend in an order that hits less".to_owned(),
            (true, false) => "Bend in an order that hits nothing".to_owned(),
            (true, true) => wires_that_hit_nothing(walks.len()),
        };
        Some(Candidate { edit: self.edit(None, &walks)?, title })
    }

    /// A change that helps a part, with the walks that were found then; the other parts have the wires that were found for them.
    pub fn helped(&self, part: &Part, help: &Help) -> Option<Candidate> {
        let parts = self.parts();
        let others = parts.iter().filter(|other| other.component != part.component);
        let walks: Vec<&Route> = others.flat_map(Part::walks).chain(&help.routes).collect();
        let (title, before) = match &help.change {
            Change::MoreWires => (wires_that_hit_nothing(walks.len()), None),
            Change::Doubled { edges, added } => {
                let names: Vec<String> = edges.iter().map(ToString::to_string).collect();
                let noun = if edges.len() == 1 { "edge" } else { "edges" };
                let title =
                    format!("Run the wire along {noun} {} twice (+{})", names.join(", "), shown(*added));
                (title, None)
            }
            Change::Moved(MovedVertex { vertex, to, by }) => {
                let positions = vec![Placed { vertex: vertex.0, at_mm: to.coords.into() }];
                (format!("Move vertex {vertex} by {}", shown(*by)), Some(EditRequest::Place { positions }))
            }
        };
        Some(Candidate { edit: self.edit(before, &walks)?, title })
    }

    fn more_than_now(&self, wires: usize) -> bool {
        wires > self.document.wires.get().max(self.parts().len())
    }

    /// Takes walks, as one change.
    fn edit(&self, before: Option<EditRequest>, routes: &[&Route]) -> Option<EditRequest> {
        let mut passed = BTreeSet::new();
        let mut doubled: Vec<u32> = Vec::new();
        let mut walks = Vec::new();
        for route in routes {
            let edges: Vec<u32> = route.traversals.iter().map(|one| one.edge.0).collect();
            doubled.extend(edges.iter().copied().filter(|&edge| !passed.insert(edge)));
            walks.push(ChosenWalk { start: route.traversals.first()?.from.0, edges });
        }
        let wires = u32::try_from(walks.len()).ok()?;
        let more = self.more_than_now(walks.len()).then_some(EditRequest::Wires { wires });
        let is_doubled = self.doubles || !doubled.is_empty();
        let doublings = is_doubled.then_some(EditRequest::Doublings { edges: doubled });
        // Walks come last: other choices of the wires put an end to them.
        let edits = before.into_iter().chain(more).chain(doublings);
        let edits = edits.chain([EditRequest::Walks { walks }]).collect();
        Some(EditRequest::Several { label: "order of the bends".to_owned(), edits })
    }
}

fn wires_that_hit_nothing(wires: usize) -> String {
    format!("Bend {wires} wires that hit nothing")
}

fn shown(length: Length) -> String {
    shown_mm(length.mm())
}
