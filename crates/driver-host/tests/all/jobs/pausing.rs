//! Pause points: the machine stands there, and is sent nothing more, until a person has said that the wire goes on.

use serde_json::{Value, json};
use wirebend_driver_host::jobs::{ConfirmedPause, JobError, JobRun, Journal, PauseAfter, Resume, WireJob};
use wirebend_driver_host::{PermitKind, SessionError};

use super::shop::{Shop, heading, work};
use super::{Ticking, all_made, drive};
use crate::permits;

/// More often than a step takes.
const LOOKS: usize = 100;

fn pause(after: u32, note: &str) -> PauseAfter {
    PauseAfter { after, note: note.to_owned() }
}

/// A wire that waits after its second and its fourth step.
fn begun(shop: &Shop, settings: Value) -> JobRun {
    let path = shop.journal_path();
    let journal = if path.exists() {
        Journal::open(&path).unwrap()
    } else {
        Journal::create(&path, heading(), "noon".to_owned()).unwrap()
    };
    let session = shop.session(settings, journal.state().token.clone().as_deref());
    let pauses = vec![pause(2, "turn the part"), pause(4, "clip the joint")];
    JobRun::new(session, journal, WireJob { pauses, ..work() }, Box::new(Ticking::default())).unwrap()
}

/// Until it waits, and then for a while.
fn wait(run: &mut JobRun) -> PauseAfter {
    for _ in 0..10 * LOOKS {
        run.advance().unwrap();
        if run.waits_at().is_some() {
            break;
        }
    }
    for _ in 0..LOOKS {
        run.advance().unwrap();
    }
    run.waits_at().unwrap_or_else(|| panic!("it does not wait: {:?}", run.overview())).clone()
}

fn go_on(run: &mut JobRun, kind: PermitKind) -> Result<(), JobError> {
    let permit = permits::yes(run.session(), kind);
    run.go_on(permit)
}

#[test]
fn nothing_is_sent_past_a_pause_point_before_a_person_says_so() {
    let folder = tempfile::tempdir().unwrap();
    let shop = Shop::at(folder.path());
    let mut run = begun(&shop, json!({}));
    assert!(matches!(go_on(&mut run, PermitKind::Continue), Err(JobError::NotWaiting)));
    shop.look_and_start(&mut run);
    assert_eq!(wait(&mut run), pause(2, "turn the part"));
    assert_eq!((run.overview().sent, shop.made()), (2, vec![1, 2]));
    let other = go_on(&mut run, PermitKind::Wire);
    assert!(matches!(other, Err(JobError::Session(SessionError::NotPermitted { .. }))), "{other:?}");
    assert_eq!(run.waits_at().map(|pause| pause.after), Some(2));
    go_on(&mut run, PermitKind::Continue).unwrap();
    assert!(matches!(go_on(&mut run, PermitKind::Continue), Err(JobError::NotWaiting)), "one yes is for one");
    assert_eq!(wait(&mut run), pause(4, "clip the joint"));
    assert_eq!(shop.made(), [1, 2, 3, 4]);
    go_on(&mut run, PermitKind::Continue).unwrap();
    drive(&mut run);
    assert_eq!(shop.made(), all_made());
    let confirmed = |after, note: &str| ConfirmedPause { at: "noon".into(), after, note: note.into() };
    assert_eq!(run.record().unwrap().pauses, [confirmed(2, "turn the part"), confirmed(4, "clip the joint")]);
}

/// A person who has turned the part would turn it again.
#[test]
fn a_wire_that_resumes_waits_only_where_nobody_has_said_that_it_goes_on() {
    let folder = tempfile::tempdir().unwrap();
    let shop = Shop::at(folder.path());
    let mut run = begun(&shop, json!({"faults": [{"at": 3, "how": "reset"}]}));
    shop.look_and_start(&mut run);
    wait(&mut run);
    run.stop().1.unwrap();
    drive(&mut run);
    drop(run);
    // Nobody has said that the part was turned: it waits again.
    let mut run = begun(&shop, json!({"faults": [{"at": 3, "how": "reset"}]}));
    assert_eq!(run.resume_from(), Resume::Arm { from: 3 });
    assert_eq!(run.pause_ahead(), Some(&pause(2, "turn the part")));
    shop.look_and_start(&mut run);
    assert_eq!(wait(&mut run).after, 2);
    go_on(&mut run, PermitKind::Continue).unwrap();
    drive(&mut run);
    drop(run);
    let mut run = begun(&shop, json!({}));
    assert_eq!(run.pause_ahead(), Some(&pause(4, "clip the joint")));
    shop.look_and_start(&mut run);
    assert_eq!(wait(&mut run).after, 4);
    assert_eq!(shop.made(), [1, 2, 3, 4]);
}

#[test]
fn a_yes_to_resume_is_for_the_pause_point_that_was_told_with_it() {
    let folder = tempfile::tempdir().unwrap();
    let shop = Shop::at(folder.path());
    let mut run = begun(&shop, json!({}));
    shop.look_and_start(&mut run);
    wait(&mut run);
    run.stop().1.unwrap();
    drive(&mut run);
    drop(run);
    let mut run = begun(&shop, json!({}));
    super::home(run.session());
    let permit = permits::yes(run.session(), PermitKind::Wire);
    run.start_past_pause(permit, 2).unwrap();
    assert_eq!(wait(&mut run).after, 4);
}

#[test]
fn pause_points_that_cannot_be_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let shop = Shop::at(folder.path());
    for wrong in [vec![pause(0, "a")], vec![pause(5, "a")], vec![pause(2, "a"), pause(2, "b")]] {
        let path = shop.journal_path();
        let _ = std::fs::remove_file(&path);
        let journal = Journal::create(&path, heading(), "noon".to_owned()).unwrap();
        let session = shop.session(json!({}), None);
        let job = WireJob { pauses: wrong, ..work() };
        let refused = JobRun::new(session, journal, job, Box::new(Ticking::default())).err().unwrap();
        assert!(matches!(refused, JobError::Steps { .. }), "{refused}");
    }
}
