//! Whether a stop is why something failed.

use std::time::{Duration, Instant};

use wirebend_driver_host::{Session, SessionError, StopOutcome};

use crate::error::LiveProblem;

/// A driver that does not pass a stop on is ended within a part of this.
const STOPPING: Duration = Duration::from_millis(300);
/// Between two looks at a machine that had nothing to report.
pub const PAUSE: Duration = Duration::from_millis(10);

/// How a stop went, if there was one. A stop is on its way before it is noted how it went: what else fails meanwhile
/// is its doing.
pub fn stop_of(session: &Session) -> Option<StopOutcome> {
    let begun = Instant::now();
    while session.last_stop().is_none() && begun.elapsed() < STOPPING {
        std::thread::sleep(PAUSE);
    }
    session.last_stop()
}

/// Why a session refused something. After a stop, that is the reason.
pub(crate) fn refused(session: &Session, error: SessionError, during: &'static str) -> LiveProblem {
    if stop_of(session).is_some() { LiveProblem::Stopped { during } } else { error.into() }
}
