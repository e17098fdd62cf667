//! Edits tried on a copy of the design.

use std::cell::OnceCell;
use std::rc::Rc;

use wirebend_core::checks::{Diagnostic, Severity};
use wirebend_core::plan::{Machine, WirePlan};
use wirebend_core::route::Share;
use wirebend_files::document::{Document, DocumentChange};

use super::super::check::LiveCheck;
use super::super::{EditRequest, changing};
use super::{Candidate, Finding, search, shares};
use crate::EditorError;
use wirebend_planning::PlanChoices;
use wirebend_planning::design::Opened;
use wirebend_planning::machine::Setup;
use wirebend_planning::text::price;
use wirebend_planning::{Installation, NoProgress};

/// The most edits that are tried.
const MAX_TRIALS: usize = 200;
/// What one finding may try however many there are.
const MIN_SHARE: usize = 4;
/// The most work that trials take together, in units of about a millisecond.
const MAX_WORK: usize = 1500;
/// So many edges are planned in a unit.
const EDGES_A_UNIT: usize = 200;
/// The same where collisions are looked for: an edge takes about a unit, and more time is given.
const MAX_COLLISION_WORK: usize = 6000;

/// The design after an edit, or as it is.
pub(super) struct Trial {
    /// What the edit changes.
    pub change: DocumentChange,
    pub check: LiveCheck,
    pub wires: Vec<WirePlan>,
    /// What is not said of a wire.
    pub design: Vec<Diagnostic>,
}

impl Trial {
    /// All that the checks said, in the order of `check`.
    pub fn findings(&self) -> Vec<Finding<'_>> {
        let of_design = self.design.iter().map(|diagnostic| Finding { diagnostic, wire: None });
        let of_wires = self.wires.iter().flat_map(|wire| {
            wire.diagnostics.iter().map(move |diagnostic| Finding { diagnostic, wire: Some(wire) })
        });
        let mut all: Vec<Finding> = of_design.chain(of_wires).collect();
        all.sort_by_key(|finding| finding.diagnostic.severity);
        all
    }

    pub fn diagnostics(&self) -> impl Iterator<Item = &Diagnostic> {
        self.design.iter().chain(self.wires.iter().flat_map(|wire| &wire.diagnostics))
    }

    pub fn errors(&self) -> usize {
        self.diagnostics().filter(|diagnostic| diagnostic.is_error()).count()
    }

    pub fn warnings(&self) -> usize {
        self.diagnostics().filter(|diagnostic| diagnostic.severity == Severity::Warning).count()
    }
}

/// Tries edits, each once, until enough were tried.
pub(super) struct Trials<'a> {
    document: Document,
    app: &'a Installation,
    setup: &'a Setup,
    /// What was tried; none where the edit or the plan was refused.
    tried: Vec<(EditRequest, Option<Rc<Trial>>)>,
    /// How many errors and warnings the design has.
    errors: usize,
    warnings: usize,
    /// Whether each is looked at for collisions; asked again and again whether it goes on.
    collisions: Option<&'a dyn Fn() -> bool>,
    /// Walks with which nothing is hit, once they were searched for.
    clear_walks: OnceCell<Option<Candidate>>,
    /// The shares of its parts with further wires, once that was asked for.
    further_wires: OnceCell<Vec<Vec<Share>>>,
    /// What a trial takes, and what is left.
    work: usize,
    left: usize,
    /// How many edits may have been tried when the present finding is done.
    until: usize,
}

impl<'a> Trials<'a> {
    /// The design as it is, and the trials of it.
    pub fn begin(
        document: Document,
        app: &'a Installation,
        setup: &'a Setup,
    ) -> Result<(Trial, Self), EditorError> {
        Self::begin_with(document, app, setup, None)
    }

    /// The same with a look for collisions in each, as long as it goes on.
    pub fn with_collisions(
        document: Document,
        app: &'a Installation,
        setup: &'a Setup,
        goes_on: &'a dyn Fn() -> bool,
    ) -> Result<(Trial, Self), EditorError> {
        Self::begin_with(document, app, setup, Some(goes_on))
    }

    fn begin_with(
        document: Document,
        app: &'a Installation,
        setup: &'a Setup,
        collisions: Option<&'a dyn Fn() -> bool>,
    ) -> Result<(Trial, Self), EditorError> {
        let change = changing::unchanged(&document);
        let base = plan(document.clone(), change, setup, collisions)?;
        let edges = document.wireframe.edge_count();
        let work = 1 + if collisions.is_some() { edges } else { edges / EDGES_A_UNIT };
        let (errors, warnings) = (base.errors(), base.warnings());
        let trials = Self {
            document,
            app,
            setup,
            tried: Vec::new(),
            errors,
            warnings,
            collisions,
            clear_walks: OnceCell::new(),
            further_wires: OnceCell::new(),
            work,
            left: if collisions.is_some() { MAX_COLLISION_WORK } else { MAX_WORK },
            until: MAX_TRIALS,
        };
        Ok((base, trials))
    }

    /// The design as it is.
    pub fn document(&self) -> &Document {
        &self.document
    }

    /// What is to become less: errors, and where collisions are looked for, warnings after them.
    pub fn trouble(&self, trial: &Trial) -> (usize, usize) {
        (trial.errors(), if self.collisions.is_some() { trial.warnings() } else { 0 })
    }

    /// The same of the design as it is.
    pub fn trouble_now(&self) -> (usize, usize) {
        (self.errors, if self.collisions.is_some() { self.warnings } else { 0 })
    }

    /// The shares of its parts with one further wire, with two, and so on while they are of use.
    pub fn further_wires(&self) -> &[Vec<Share>] {
        self.further_wires.get_or_init(|| shares::with_further_wires(&self.document))
    }

    /// Walks with which nothing is hit; they are searched for once, for all collisions alike.
    pub fn clear_walks(&self) -> Option<Candidate> {
        let goes_on = self.collisions?;
        let found = || search::without_collisions(&self.document, self.setup, goes_on);
        self.clear_walks.get_or_init(found).clone()
    }

    /// The machine with its wire.
    pub fn machine(&self) -> &Machine {
        &self.setup.model
    }

    /// What the wire of a length costs.
    pub fn price(&self, length: wirebend_core::units::Length) -> Option<String> {
        let cost = self.setup.model.wire.cost(length)?;
        Some(price(cost, self.setup.currency.as_deref()?))
    }

    /// What is left is for so many findings: the next takes no more than its share, and a few where that is less.
    pub fn share(&mut self, findings: usize) {
        let share = (MAX_TRIALS - self.tried.len()) / findings.max(1);
        self.until = MAX_TRIALS.min(self.tried.len() + share.max(MIN_SHARE));
    }

    /// How many edits were tried.
    pub fn count(&self) -> usize {
        self.tried.len()
    }

    /// The design after an edit; none where it cannot be made, or enough was tried.
    pub fn of(&mut self, edit: &EditRequest) -> Option<Rc<Trial>> {
        if let Some((_, trial)) = self.tried.iter().find(|(tried, _)| tried == edit) {
            return trial.clone();
        }
        if self.tried.len() >= self.until || self.left == 0 {
            return None;
        }
        self.left = self.left.saturating_sub(self.work);
        let trial = self.try_edit(edit).map(Rc::new);
        self.tried.push((edit.clone(), trial.clone()));
        trial
    }

    fn try_edit(&self, edit: &EditRequest) -> Option<Trial> {
        let change = changing::change(&self.document, self.app, edit).ok().flatten()?;
        let mut document = self.document.clone();
        document.commit(&change).ok()?;
        if self.collisions.is_some_and(|goes_on| !goes_on()) {
            return None;
        }
        plan(document, change, self.setup, self.collisions).ok()
    }
}

fn plan(
    document: Document,
    change: DocumentChange,
    setup: &Setup,
    collisions: Option<&dyn Fn() -> bool>,
) -> Result<Trial, EditorError> {
    let opened = Opened::of(String::new(), document);
    let mut planned = Installation::plan_with(opened, setup.clone(), &PlanChoices::default(), &NoProgress)?;
    if let Some(goes_on) = collisions {
        planned.find_collisions(&mut |_, _| goes_on());
    }
    Ok(Trial { change, check: LiveCheck::of(&planned), wires: planned.wires, design: planned.design })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_more_is_tried_than_told_and_nothing_twice() {
        let app = Installation::new(&[]).unwrap();
        let setup = app.setup("wirebend-kit", None).unwrap();
        let mut document = Document::new(wirebend_core::wireframe::Wireframe::new());
        let strand = EditRequest::Draw {
            from: None,
            through_mm: vec![[0.0; 3], [60.0, 0.0, 0.0], [60.0, 60.0, 0.0]],
            to: None,
        };
        let change = changing::change(&document, &app, &strand).unwrap().unwrap();
        document.commit(&change).unwrap();
        let (_, mut trials) = Trials::begin(document, &app, &setup).unwrap();
        let moved = |by: u32| EditRequest::Move {
            vertices: vec![2],
            lines: Vec::new(),
            by_mm: [0.0, f64::from(by), 0.0],
        };
        // Three findings: a third each, then half of what is left.
        for (findings, most) in [(3, 66), (2, 133), (1, 200)] {
            trials.share(findings);
            for _ in 0..2 {
                let made = (1..=300).filter(|&by| trials.of(&moved(by)).is_some()).count();
                assert_eq!(made, most);
            }
        }
        trials.share(50);
        assert!(trials.of(&moved(301)).is_none());
        assert!(trials.of(&moved(1)).is_some(), "what was tried is known");
    }
}
