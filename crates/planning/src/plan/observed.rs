//! What a plan tells of itself while it is made.

use std::collections::BTreeMap;
use std::time::Instant;

use wirebend_core::plan::{PlanObserver, Stage};
use wirebend_core::search::SearchProgress;

use crate::{BestSoFar, Progress};

/// What a plan tells of itself: progress, and what each stage took.
pub(super) struct Observed<'a> {
    progress: &'a dyn Progress,
    /// ms.
    took: &'a mut BTreeMap<&'static str, f64>,
    last: Instant,
    searching: bool,
    trying: bool,
    best: Option<BestSoFar>,
}

impl<'a> Observed<'a> {
    /// `took` gets the ms of each stage.
    pub fn new(progress: &'a dyn Progress, took: &'a mut BTreeMap<&'static str, f64>) -> Self {
        Self { progress, took, last: Instant::now(), searching: false, trying: false, best: None }
    }
}

impl PlanObserver for Observed<'_> {
    fn done(&mut self, stage: Stage) {
        *self.took.entry(stage_name(stage)).or_default() += self.last.elapsed().as_secs_f64() * 1000.0;
        self.last = Instant::now();
    }

    fn searching(&mut self, SearchProgress { checks, best }: SearchProgress, of: u64) -> bool {
        if !std::mem::replace(&mut self.searching, true) {
            self.progress.search("searching for a program without collisions");
        }
        // That of the part before is settled.
        let best = best.map(BestSoFar::from);
        if best != self.best {
            self.best = best;
            self.progress.best(best);
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
