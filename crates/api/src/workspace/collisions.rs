//! The check of the open design for collisions: beside the other checks, and given up as soon as a later one is asked for.

use std::cell::Cell;
use std::time::{Duration, Instant};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_planning::collisions::Collisions;

use super::Workspace;
use super::latest::Search;
use crate::{ApiError, AvoidedCollisions, Moved, Progress, SearchSettings};

/// What is over sooner is not reported as work.
const QUICK: Duration = Duration::from_millis(300);
/// From one report to the next.
const BETWEEN: Duration = Duration::from_millis(100);

/// Checks the design for collisions, with some vertices elsewhere than they are. One that is under way is stopped.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct CheckCollisions {
    /// Vertices that are being dragged.
    #[serde(default)]
    pub moved: Vec<Moved>,
}

/// Stops the check for collisions that is under way, and the search for what would fix them.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct StopCollisions {}

/// Nothing is looked for any more.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct CollisionsStopped {}

/// Searches for wires of the design that hit nothing. A search that is under way is ended.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct AvoidCollisions {
    /// How.
    #[serde(default)]
    pub settings: SearchSettings,
}

/// Ends the search for wires that hit nothing: it answers with the best that it has.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct StopAvoiding {}

/// No search goes on any more.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct AvoidingStopped {}

impl Workspace {
    pub(crate) fn collisions(
        &self,
        asked: &CheckCollisions,
        progress: &dyn Progress,
    ) -> Result<Collisions, ApiError> {
        let check = self.collision_checks.begin();
        let found = self.open().collision_check(&self.installation(), &asked.moved)?;
        let mut next = Instant::now() + QUICK;
        Ok(found.run(&mut |done, of| {
            if Instant::now() >= next {
                next = Instant::now() + BETWEEN;
                progress.advance(done as u64, of as u64);
            }
            self.collision_checks.is_last(check)
        })?)
    }

    pub(crate) fn stop_collisions(
        &self,
        _: &StopCollisions,
        _: &dyn Progress,
    ) -> Result<CollisionsStopped, ApiError> {
        self.collision_checks.begin();
        Ok(CollisionsStopped {})
    }

    pub(crate) fn avoid_collisions(
        &self,
        asked: &AvoidCollisions,
        progress: &dyn Progress,
    ) -> Result<AvoidedCollisions, ApiError> {
        let searches = &self.clear_searches;
        let search = Search { progress, searches, own: searches.begin(), next: Cell::default() };
        let app = self.installation();
        let found = self.open().fix_search(&app)?;
        Ok(found.avoid_collisions(&app, &asked.settings, &search)?)
    }

    pub(crate) fn stop_avoiding(
        &self,
        _: &StopAvoiding,
        _: &dyn Progress,
    ) -> Result<AvoidingStopped, ApiError> {
        self.clear_searches.begin();
        Ok(AvoidingStopped {})
    }
}
