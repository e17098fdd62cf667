//! A search for wires that hit nothing as a person asks for it: how it is made, what came of it, and what helps where nothing was found.

use std::cell::Cell;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_core::checks::{Diagnostic, Fact};
use wirebend_planning::report::{DiagnosticReport, HelpReport, SearchWeights};
use wirebend_planning::{Installation, PlanChoices, PlanningError, Progress};

use super::search::{Part, SearchedDesign, Steps};
use super::trials::{Trial, Trials};
use super::{Candidate, Fix, FixSearch, FixTotals, is_collision, verdict};
use crate::EditorError;

/// How to search; what is left out is as on the command line.
#[derive(Debug, Clone, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SearchSettings {
    /// How many steps may be checked for each number of wires; absent, 20,000.
    #[serde(default)]
    #[schemars(range(min = 1))]
    pub effort: Option<u32>,
    /// Where chance begins; absent, 1.
    #[serde(default)]
    pub seed: Option<u64>,
    /// What makes one program better than another; absent: fewest wires, then the least doubled length, then the least time.
    #[serde(default)]
    pub weights: Option<SearchWeights>,
    /// How many wires there may be; absent, as many as the design has, and where it has one, up to 32.
    #[serde(default)]
    #[schemars(range(min = 1))]
    pub wires: Option<u32>,
}

/// What came of a search for wires that hit nothing.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct AvoidedCollisions {
    /// Whether wires were found that hit nothing.
    pub found: bool,
    /// How many steps were checked.
    pub steps_checked: u64,
    /// Whether a person has ended the search, or the trials after it, before it was done.
    pub ended: bool,
    /// The best wires, where they hit less than the design's, or as much and come near less often; tried with a check for collisions.
    pub best: Option<Fix>,
    /// For each part of the design without a program what was in the way.
    pub unfound: Vec<DiagnosticReport>,
    /// What was tried and helps.
    pub helps: Vec<HelpFix>,
}

/// A change that helps, as an edit.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct HelpFix {
    pub help: HelpReport,
    /// The same as an edit that takes the walks that were found with it; tried with a check for collisions.
    pub fix: Fix,
}

impl SearchSettings {
    fn choices(&self) -> Result<PlanChoices, PlanningError> {
        let wrong =
            |name, value: String, expected| PlanningError::Value { input: None, name, value, expected };
        let zero = |count: Option<u32>| count == Some(0);
        if zero(self.effort) {
            return Err(wrong("the effort of the search", "0".to_owned(), "at least 1 step"));
        }
        if zero(self.wires) {
            return Err(wrong("the number of wires", "0".to_owned(), "at least 1"));
        }
        if self.weights == Some(SearchWeights::default()) {
            let expected = "a weight for wires, doubled length or time";
            return Err(wrong("the sum of the weights", "0".to_owned(), expected));
        }
        Ok(PlanChoices {
            wires: self.wires,
            search_effort: self.effort,
            search_seed: self.seed,
            search_weights: self.weights,
            ..PlanChoices::default()
        })
    }
}

impl FixSearch {
    /// Searches for wires that hit nothing. Where `progress` does not go on, it ends with the best that it has.
    ///
    /// # Errors
    /// [`EditorError::Planning`] for settings that make no sense, and where the design cannot be planned.
    pub fn avoid_collisions(
        self,
        app: &Installation,
        settings: &SearchSettings,
        progress: &dyn Progress,
    ) -> Result<AvoidedCollisions, EditorError> {
        let choices = settings.choices()?;
        // What was found is tried, also once the search was ended.
        let (base, mut trials) = Trials::with_collisions(self.document.clone(), app, &self.setup, &|| true)?;
        let steps = Steps { progress, searches: Cell::new(false) };
        let searched = SearchedDesign::of(&self.document, &self.setup, choices, &steps)?;
        progress.stage("checking what was found");
        let met = |trial: &Trial| {
            let FixTotals { collisions, near, .. } = FixTotals::of(trial);
            collisions.zip(near)
        };
        let mends = base.check.diagnostics.iter().find(|said| is_collision(said.code)).cloned();
        let best = mends.zip(searched.best()).and_then(|(mends, candidate)| {
            let trial = trials.of(&candidate.edit)?;
            let (now, then) = (met(&base)?, met(&trial)?);
            if then >= now || !verdict::is_no_worse(&base, &trial, true) {
                return None;
            }
            let title = if then.0 == now.0 {
                "Bend in an order that comes near less often".to_owned()
            } else {
                candidate.title
            };
            Some(Fix::new(mends, Candidate { title, ..candidate }, &base, &trials, &trial))
        });
        let parts = searched.parts();
        let unfound = parts.iter().filter_map(|part| Some((part, part.unfound()?)));
        let unfound: Vec<(&Part, &Diagnostic)> = unfound.collect();
        let mut helps = Vec::new();
        for (part, diagnostic) in &unfound {
            let Fact::NoClearProgram { helps: tried, .. } = &diagnostic.fact else { continue };
            for help in &tried.found {
                let Some(candidate) = searched.helped(part, help) else { continue };
                let fix = helping(part, candidate, diagnostic, (&base, &mut trials));
                helps.extend(fix.map(|fix| HelpFix { help: HelpReport::from(help), fix }));
            }
        }
        let of_all = searched.planned.searched();
        let unfound: Vec<DiagnosticReport> =
            unfound.iter().map(|(_, diagnostic)| DiagnosticReport::from(*diagnostic)).collect();
        let trials_ended = unfound.iter().filter_map(|said| said.search.as_ref()).any(|search| search.ended);
        Ok(AvoidedCollisions {
            found: searched.found(),
            steps_checked: of_all.as_ref().map_or(0, |search| search.steps_checked),
            ended: trials_ended || of_all.is_some_and(|search| search.ended),
            best,
            unfound,
            helps,
        })
    }
}

/// A change as a fix, where no wire of its part hits anything after it and no error is new.
fn helping(
    part: &Part,
    candidate: Candidate,
    diagnostic: &Diagnostic,
    (base, trials): (&Trial, &mut Trials),
) -> Option<Fix> {
    let trial = trials.of(&candidate.edit)?;
    let mut of_part = trial.wires.iter().filter(|wire| {
        wire.component.edges.iter().any(|edge| part.component.edges.binary_search(edge).is_ok())
    });
    let is_clear = of_part.all(|wire| wire.contacts.as_ref().is_some_and(Vec::is_empty));
    let is_good = is_clear && verdict::is_no_worse(base, &trial, true);
    is_good.then(|| Fix::new(DiagnosticReport::from(diagnostic), candidate, base, trials, &trial))
}
