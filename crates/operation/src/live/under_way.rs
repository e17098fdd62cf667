//! A machine that may still be running what a program that is gone has sent it: its port is not opened before that is over, since
//! opening it resets many boards, in the middle of a bend as well.

use std::path::Path;
use std::time::{Duration, Instant, SystemTime};

use wirebend_driver_host::jobs::{Entry, EntryKind, Heading, Journal, JournalState, Written, stamped};
use wirebend_error::{ErrorCode, ErrorRemedy, ProblemReport};

use crate::FrontEnd;
use crate::error::LiveProblem;
use crate::runs::RunsFolder;
use crate::{MachineEvent, Wait};
use wirebend_planning::Installation;

/// How much longer than reckoned steps may take: rates of a machine are seldom measured.
const SLOWER: f64 = 1.5;
/// Stamps are whole seconds, and a machine that notices that its host is gone takes one.
const MARGIN: Duration = Duration::from_secs(3);
/// A step without an estimate of how long it takes. None of the machines with a profile needs as long.
const UNKNOWN: Duration = Duration::from_mins(1);
/// Between two looks.
const LOOK: Duration = Duration::from_millis(50);

/// Steps that a machine may still be running.
#[derive(Debug, PartialEq)]
struct UnderWay {
    name: String,
    /// The first and the last.
    steps: [u32; 2],
    /// When they are over at the latest.
    ends: SystemTime,
}

/// Waits until a machine at a port has done all that a journal says it was sent, and reports that. Refuses one that a program
/// is at work with. `own`: the journal that the caller has opened.
pub(super) fn wait_until_it_stands(
    app: &Installation,
    port: &str,
    own: Option<&Path>,
    progress: &dyn FrontEnd,
) -> Result<(), LiveProblem> {
    let now = SystemTime::now();
    let Some(under_way) = on(app, port, own, now)? else { return Ok(()) };
    let left = under_way.ends.duration_since(now).unwrap_or_default();
    let message = under_way.told(port, left);
    progress.event(&MachineEvent::Warning(ProblemReport::new(
        ErrorCode::StillMoving,
        message,
        vec![ErrorRemedy::CutPower],
    )));
    let begun = Instant::now();
    loop {
        match progress.wait() {
            Wait::GoesOn if begun.elapsed() < left => {}
            Wait::GoesOn | Wait::IsOver => return Ok(()),
            Wait::GivenUp => return Err(LiveProblem::Declined),
        }
        progress.stage(&format!(
            "waiting until the machine stands: {} s",
            left.saturating_sub(begun.elapsed()).as_secs() + 1
        ));
        std::thread::sleep(LOOK);
    }
}

/// What a machine at a port may be running; `None` where it is known to stand.
fn on(
    app: &Installation,
    port: &str,
    own: Option<&Path>,
    now: SystemTime,
) -> Result<Option<UnderWay>, LiveProblem> {
    // Without a place for journals no wire was begun.
    let Ok(folder) = RunsFolder::of(app) else { return Ok(None) };
    let Some(all) = is_device(port).then(|| folder.all().ok()).flatten() else { return Ok(None) };
    let mut latest: Option<UnderWay> = None;
    for kept in &all {
        let Ok(written) = &kept.read else { continue };
        let Heading { port: begun_at, name, .. } = &written.state.heading;
        if begun_at != port {
            continue;
        }
        let over = written.state.is_over();
        if !over && own != Some(&kept.path) && Journal::is_in_use(&kept.path) {
            return Err(LiveProblem::AtWork { port: port.to_owned(), name: name.clone() });
        }
        let under_way = UnderWay::of(written, now);
        latest = latest.into_iter().chain(under_way).max_by_key(|under_way| under_way.ends);
    }
    Ok(latest)
}

/// Whether a board can be reset by opening it: what is simulated has no such name.
fn is_device(port: &str) -> bool {
    Path::new(port).is_absolute() || port.to_ascii_uppercase().starts_with("COM")
}

impl UnderWay {
    fn of(written: &Written, now: SystemTime) -> Option<Self> {
        let state = &written.state;
        if state.sent <= state.done {
            return None;
        }
        // To give a wire up stops nothing.
        let steps = state.done + 1..=state.sent;
        let since = stamped(since(&written.entries)?)?;
        // A clock that was set back says nothing of when it was.
        let since = since.min(now);
        let takes = steps.clone().map(|n| takes(state, n)).sum::<Duration>().mul_f64(SLOWER) + MARGIN;
        let ends = since.checked_add(takes)?;
        let steps = [*steps.start(), *steps.end()];
        (ends > now).then(|| Self { name: state.heading.name.clone(), steps, ends })
    }

    fn told(&self, port: &str, left: Duration) -> String {
        let Self { name, steps: [first, last], .. } = self;
        let steps = if first == last { format!("step {first}") } else { format!("steps {first} to {last}") };
        format!(
            "the machine at {port} may still be running {steps} of the wire '{name}', which was interrupted, and opening its port could reset it in the middle: \
             waiting up to {} s, until that is over",
            left.as_secs() + 1
        )
    }
}

/// How long a step is reckoned to take.
fn takes(state: &JournalState, n: u32) -> Duration {
    let at = usize::try_from(n).unwrap_or(usize::MAX).wrapping_sub(1);
    let known = state.heading.estimates_s.get(at).copied();
    known.and_then(|seconds| Duration::try_from_secs_f64(seconds).ok()).unwrap_or(UNKNOWN)
}

/// When the machine was last known to have something to run; `None` where it is known to stand since.
fn since(entries: &[Entry]) -> Option<&str> {
    entries.iter().fold(None, |since, entry| match &entry.what {
        EntryKind::Intent { .. }
        | EntryKind::Accepted { .. }
        | EntryKind::Done { .. }
        | EntryKind::Resumed
        | EntryKind::Armed { .. }
        | EntryKind::Connected { resume: Some(_), .. } => Some(entry.at.as_str()),
        EntryKind::Paused
        | EntryKind::Standstill { confirmed: true }
        | EntryKind::Connected { resume: None, .. }
        | EntryKind::Finished => None,
        _ => since,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const BEGUN: &str = "2026-05-01T09:30:00Z";

    /// What is under way so long after the last entry.
    fn after(estimates_s: &[f64], entries: &[EntryKind], seconds: u64) -> Option<UnderWay> {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("wire.journal");
        let heading = Heading {
            name: "bow".to_owned(),
            steps: 4,
            estimates_s: estimates_s.to_vec(),
            ..Heading::default()
        };
        let mut journal = Journal::create(&path, heading, BEGUN.to_owned()).unwrap();
        for what in entries {
            journal.add(Entry { at: BEGUN.to_owned(), what: what.clone() }).unwrap();
        }
        drop(journal);
        let now = stamped(BEGUN).unwrap() + Duration::from_secs(seconds);
        UnderWay::of(&Journal::read(&path).unwrap(), now)
    }

    fn running() -> Vec<EntryKind> {
        vec![
            EntryKind::Connected { identity: String::new(), resume: None },
            EntryKind::Armed { token: None, after: 0, resumed: false },
            EntryKind::Intent { from: 1, to: 3 },
            EntryKind::Accepted { n: 3 },
            EntryKind::Done { n: 1 },
        ]
    }

    /// Steps 2 and 3 take 20 and 30 s: 75 s with what a machine may be slower, and 3 s of margin.
    #[test]
    fn it_is_waited_for_as_long_as_the_steps_can_take() {
        let estimates = [10.0, 20.0, 30.0, 40.0];
        let under_way = after(&estimates, &running(), 77).expect("a machine that moves");
        assert_eq!(under_way.steps, [2, 3]);
        assert_eq!(under_way.ends, stamped(BEGUN).unwrap() + Duration::from_secs(78));
        assert_eq!(after(&estimates, &running(), 78), None);
    }

    /// A clock that was set back, as by the battery of an old computer.
    #[test]
    fn a_journal_of_tomorrow_is_waited_for_from_now() {
        let under_way = after(&[1.0; 4], &running(), 0).unwrap();
        let now = stamped(BEGUN).unwrap();
        assert_eq!(under_way.ends.duration_since(now).unwrap(), Duration::from_secs(6));
    }

    #[test]
    fn steps_that_nobody_has_reckoned_take_long() {
        assert!(after(&[], &running(), 182).is_some());
        assert_eq!(after(&[], &running(), 184), None);
    }

    #[test]
    fn a_machine_that_is_known_to_stand_is_not_waited_for() {
        let stopped = EntryKind::Stopped { by: None };
        let still = |more: &[EntryKind]| after(&[30.0; 4], &[running(), more.to_vec()].concat(), 1).is_none();
        assert!(still(&[EntryKind::Paused]), "it holds");
        assert!(still(&[stopped.clone(), EntryKind::Standstill { confirmed: true }]));
        assert!(
            still(&[EntryKind::Connected { identity: String::new(), resume: None }]),
            "it has answered since"
        );
        assert!(still(&[EntryKind::Done { n: 2 }, EntryKind::Done { n: 3 }]), "it has nothing more");
        assert!(!still(std::slice::from_ref(&stopped)), "the program was ended before it was known");
        assert!(!still(&[stopped, EntryKind::Standstill { confirmed: false }]));
        assert!(!still(&[EntryKind::Paused, EntryKind::Resumed]));
        assert!(!still(&[EntryKind::Abandoned]), "that stops nothing");
        assert!(!still(&[EntryKind::Connected {
            identity: String::new(),
            resume: Some(wirebend_driver_host::api::ResumeState { accepted: 3, done: 1 })
        }]));
    }

    #[test]
    fn what_is_simulated_is_no_device() {
        let names = ["sim", "sim:10", "anywhere", "/dev/ttyACM0", "COM3"];
        assert_eq!(names.map(is_device), [false, false, false, true, true]);
    }
}
