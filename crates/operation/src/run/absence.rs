//! The program was away while a wire was bent, as when the computer slept: the machine is sent nothing more before a person has said so.

use std::time::{Duration, Instant, SystemTime};

use wirebend_driver_host::Phase;
use wirebend_driver_host::jobs::JobRun;
use wirebend_error::{ErrorCode, ProblemReport};

use crate::live::MachineObserver;
use crate::{LiveProblem, OperationError};

/// A program that was away for longer has not watched the machine, as when the computer slept: the user who said yes may
/// have their hands in it now. A second of silence, after which a machine holds, a busy computer has now and then.
const AWAY: Duration = Duration::from_secs(10);

/// Whether the program has watched the machine all the time. By the time of day, since that runs on while the
/// computer sleeps.
#[derive(Default)]
pub(super) struct Watch {
    looked: Option<SystemTime>,
    /// When it came back.
    away: Option<Instant>,
}

impl Watch {
    /// Whether it has just come back.
    pub(super) fn look(&mut self) -> bool {
        let now = SystemTime::now();
        let before = self.looked.replace(now);
        // A clock that was set back says nothing.
        let gap = before.and_then(|before| now.duration_since(before).ok()).unwrap_or_default();
        let is_back = gap > AWAY;
        if is_back {
            self.away = Some(Instant::now());
        }
        is_back
    }

    /// Whether it was away shortly before.
    pub(super) fn was_away(&self) -> bool {
        self.away.is_some_and(|back| back.elapsed() < AWAY)
    }
}

/// Whether a machine that is sent more would move under the hands of somebody. What is simulated has nobody at it.
pub(super) fn may_surprise(run: &mut JobRun) -> bool {
    run.overview().phase == Phase::Making && run.session().simulated().is_none()
}

/// The program was away while the wire was bent, and the machine has run what it was sent before. It is sent nothing more until a
/// person has said so.
pub(super) fn ask_after_absence(
    run: &mut JobRun,
    observer: &mut MachineObserver,
) -> Result<(), OperationError> {
    let question =
        "this program was away for a while, and the machine runs what it was sent before. May it go on?";
    let said = observer.progress.confirm(question);
    if run.session().last_stop().is_some() {
        return Ok(());
    }
    if said == Some(true) {
        return Ok(());
    }
    let message =
        "this program was away for a while, and it was not confirmed that the wire goes on: it was stopped";
    observer.warn(ProblemReport::new(ErrorCode::Held, message.to_owned(), Vec::new()));
    Ok(run.stop().1.map_err(LiveProblem::from)?)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Were a sleep not noticed, a machine would resume by itself under the hands of the user who opens the lid.
    #[test]
    fn a_program_that_slept_was_away() {
        let mut watch = Watch::default();
        watch.look();
        watch.look();
        assert!(!watch.was_away());
        watch.looked = SystemTime::now().checked_sub(AWAY * 2);
        assert!(watch.look(), "it has come back");
        assert!(!watch.look() && watch.was_away(), "it is here again");
        // A clock that was set back is no sleep.
        let mut watch = Watch { looked: SystemTime::now().checked_add(AWAY * 2), away: None };
        watch.look();
        assert!(!watch.was_away());
    }
}
