//! What a plan tells of itself while it is made.

use std::collections::BTreeMap;
use std::time::Instant;

use wirebend_core::plan::{PlanObserver, Stage};
use wirebend_core::search::SearchProgress;

use crate::{BestSoFar, FoundSoFar, Progress};

/// What a plan tells of itself: progress, and what each stage took.
pub(super) struct Observed<'a> {
    progress: &'a dyn Progress,
    /// ms.
    took: &'a mut BTreeMap<&'static str, f64>,
    last: Instant,
    /// What the search has found, once it goes on.
    found: Option<FoundSoFar>,
    /// Which part is planned, of how many.
    part: [usize; 2],
    trying: bool,
}

impl<'a> Observed<'a> {
    /// Of part `part[0]` from 1, of `part[1]`. `took` gets the ms of each stage.
    pub fn new(
        progress: &'a dyn Progress,
        part: [usize; 2],
        took: &'a mut BTreeMap<&'static str, f64>,
    ) -> Self {
        Self { progress, took, last: Instant::now(), found: None, part, trying: false }
    }
}

impl PlanObserver for Observed<'_> {
    fn done(&mut self, stage: Stage) {
        *self.took.entry(stage_name(stage)).or_default() += self.last.elapsed().as_secs_f64() * 1000.0;
        self.last = Instant::now();
    }

    fn searching(&mut self, SearchProgress { checks, best }: SearchProgress, of: u64) -> bool {
        if self.found.is_none() {
            self.progress.search("searching for a program without collisions");
        }
        let [part, parts] = self.part;
        let found = FoundSoFar { part, parts, best: best.map(BestSoFar::from) };
        if self.found.replace(found) != Some(found) {
            self.progress.found(found);
        }
        self.progress.advance(checks, of);
        self.progress.goes_on()
    }

    fn trying(&mut self, checks: u64, of: u64) -> bool {
        if !std::mem::replace(&mut self.trying, true) {
            self.progress.search("trying changes that could help");
        }
        self.progress.advance(checks, of);
        self.progress.goes_on()
    }
}

const fn stage_name(stage: Stage) -> &'static str {
    match stage {
        Stage::Doubling => "doubling",
        Stage::Route => "route",
        Stage::Program => "program",
        Stage::Schedule => "schedule",
        Stage::Compensate => "compensate",
        Stage::Search => "search",
        Stage::Contacts => "contacts",
        Stage::Check => "check",
    }
}
