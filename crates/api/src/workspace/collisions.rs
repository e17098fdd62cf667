//! The check of the open design for collisions: beside the other checks, and given up as soon as a later one is asked for.

use std::time::{Duration, Instant};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_planning::collisions::Collisions;

use super::Workspace;
use crate::{ApiError, Moved, Progress};

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
}
