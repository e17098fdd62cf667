//! Wires that are interrupted in every way at every step, and are finished anyway: each step is done exactly once.

#![cfg(unix)] // the driver that misbehaves is

mod part;
mod pausing;
mod record;
pub(crate) mod shop;

use std::cell::Cell;
use std::time::Duration;

use serde_json::{Value, json};
use shop::{STEPS, Shop, TURNS, home, work};
use wirebend_driver_host::api::PausedBy;
use wirebend_driver_host::jobs::{
    Clock, ContradictionKind, Entry, EntryKind, JobError, JobRun, JobState, Journal, Outcome, Progress,
    Resume, Settled, StepOutcome,
};
use wirebend_driver_host::{Phase, SessionError, StoppedBy};

use crate::permits;

/// Each look at it takes a second.
#[derive(Default)]
struct Ticking(Cell<u64>);

impl Clock for Ticking {
    fn now(&self) -> Duration {
        self.0.set(self.0.get() + 1);
        Duration::from_secs(self.0.get())
    }

    fn stamp(&self) -> String {
        "noon".to_owned()
    }
}

/// What stands in the journal.
fn entries(shop: &Shop) -> Vec<Entry> {
    Journal::read(&shop.journal_path()).unwrap().entries
}

/// More often than any of these wires has to be looked at.
const TURNS_OF_THE_LOOP: usize = 1000;

/// Runs the wire as far as it goes.
fn drive(run: &mut JobRun) -> Vec<Progress> {
    let mut told = Vec::new();
    for _ in 0..TURNS_OF_THE_LOOP {
        if run.is_over() {
            return told;
        }
        told.extend(run.advance().unwrap());
    }
    panic!("it does not end: {told:?}");
}

fn all_made() -> Vec<u64> {
    (1..=u64::from(STEPS)).collect()
}

fn head_after(steps: u32) -> f64 {
    TURNS.iter().take(steps as usize).sum()
}

#[test]
fn a_wire_that_nothing_happens_to_is_made() {
    let folder = tempfile::tempdir().unwrap();
    let shop = Shop::at(folder.path());
    let mut run = shop.program(json!({}), Box::new(Ticking::default()));
    assert_eq!(run.resume_from(), Resume::Arm { from: 1 });
    shop.look_and_start(&mut run);
    let told = drive(&mut run);
    let made: Vec<_> = told.iter().filter(|told| matches!(told, Progress::Made { .. })).collect();
    assert_eq!(made.len(), 5, "{told:?}");
    assert_eq!(told.last(), Some(&Progress::Finished));
    let view = run.overview();
    assert_eq!((view.of, view.sent, view.made, view.phase), (5, 5, 5, Phase::Ready));
    assert_eq!((view.standing, view.remaining), (JobState::Finished, Duration::ZERO));
    assert!(!view.elapsed.is_zero());
    // Front ends read the same of the session.
    let wire = run.session().snapshot().wire.unwrap();
    assert_eq!((wire.of, wire.sent, wire.made), (5, 5, 5));
    assert_eq!(wire.remaining, view.remaining);
    assert!(!wire.elapsed.is_zero() && wire.elapsed <= view.elapsed, "{wire:?}");
    assert_eq!(shop.made(), all_made());
    assert_eq!(run.resume_from(), Resume::Nothing(Settled::Finished));
    // What was intended is always written before it is sent, and so before it is taken.
    let order: Vec<_> = entries(&shop).into_iter().map(|entry| entry.what).collect();
    let place = |wanted: &dyn Fn(&EntryKind) -> bool| order.iter().position(wanted).unwrap();
    for n in 1..=STEPS {
        let intended = place(&|what| matches!(what, EntryKind::Intent { to, .. } if *to >= n));
        let taken = place(&|what| matches!(what, EntryKind::Accepted { n: last } if *last >= n));
        let made = place(&|what| *what == EntryKind::Done { n });
        assert!(intended < taken && taken < made, "{order:?}");
    }
}

/// What happens at a step, whether the machine is in its session afterwards, and whether the step was done.
const FAULTS: [(&str, bool, bool); 6] = [
    ("unplug", true, false),
    ("unplug-after", true, true),
    ("reset", false, false),
    ("reset-after", false, true),
    ("crash", true, false),
    ("crash-after", true, true),
];

#[test]
fn whatever_happens_at_whatever_step_each_is_made_once() {
    for (how, same_session, made) in FAULTS {
        for at in 1..=STEPS {
            for alone in 0..3 {
                interrupted_once(how, at, alone, same_session, made);
            }
        }
    }
}

fn interrupted_once(how: &str, at: u32, alone: u32, same_session: bool, made: bool) {
    let case = format!("{how} at {at}, then {alone} alone");
    let folder = tempfile::tempdir().unwrap();
    let shop = Shop::at(folder.path());
    let faults = json!({"faults": [{"at": at, "how": how}]});
    let mut run = shop.program(faults, Box::new(Ticking::default()));
    shop.look_and_start(&mut run);
    let told = drive(&mut run);
    let fault = told.iter().rev().find_map(|told| match told {
        Progress::Fault { in_doubt, .. } => *in_doubt,
        _ => None,
    });
    let Some((first, last)) = fault else { panic!("{case}: {told:?}") };
    // A machine whose driver has died, or cannot reach it, is not known to stand, one that answers the stop is; and that is
    // the last word.
    let stands = matches!(told.last(), Some(Progress::Standstill { confirmed: true }));
    let unknown = matches!(told.last(), Some(Progress::Standstill { confirmed: false }));
    assert!(stands != unknown, "{case}: {told:?}");
    assert_eq!(stands, how.starts_with("reset"), "{case}: {told:?}");
    // What the driver had reported before is known, whatever became of it.
    // Three are taken of the four that are sent: the user is not asked about the fourth.
    assert!(first <= at && at <= last && last - first < 3, "{case}: {first} to {last}");
    assert_eq!(run.overview().phase, Phase::Failed, "{case}");
    drop(run);
    let before = shop.made();
    assert_eq!(
        before.last().copied().unwrap_or_default(),
        u64::from(if made { at } else { at - 1 }),
        "{case}"
    );

    let mut run = shop.program(json!({ "alone": alone }), Box::new(Ticking::default()));
    let possible = run.resume_from();
    match &possible {
        Resume::Reattach { done, .. } => {
            assert!(same_session && u64::from(*done) == shop.made().len() as u64, "{case}");
        }
        Resume::Ask { .. } => assert!(!same_session, "{case}"),
        other => panic!("{case}: {other:?}"),
    }
    if matches!(possible, Resume::Ask { .. }) {
        // Without a word of a person nothing moves.
        home(run.session());
        assert!(matches!(permits::start(&mut run), Err(JobError::InDoubt { .. })), "{case}");
    }
    shop.look_and_start(&mut run);
    drive(&mut run);
    assert_eq!(run.journal_state().standing, JobState::Finished, "{case}");
    assert_eq!(shop.made(), all_made(), "{case}");
    let heads = shop.machine()["heads"].as_array().unwrap().clone();
    let expected = head_after(u32::try_from(shop_after(&shop)).unwrap());
    assert_eq!(heads.last().and_then(Value::as_f64), Some(expected), "{case}");
}

/// After how many steps the wire was armed last.
fn shop_after(shop: &Shop) -> u64 {
    let after = |entry: Entry| match entry.what {
        EntryKind::Armed { after, .. } => Some(u64::from(after)),
        _ => None,
    };
    entries(shop).into_iter().rev().find_map(after).unwrap()
}

#[test]
fn a_wire_survives_one_fault_after_the_other() {
    let folder = tempfile::tempdir().unwrap();
    let shop = Shop::at(folder.path());
    for (how, at) in [("unplug", 1), ("reset-after", 2), ("crash", 3), ("reset", 3), ("unplug-after", 5)] {
        let faults = json!({"faults": [{"at": at, "how": how}]});
        let mut run = shop.program(faults, Box::new(Ticking::default()));
        shop.look_and_start(&mut run);
        let told = drive(&mut run);
        assert!(told.iter().any(|told| matches!(told, Progress::Fault { .. })), "{how} at {at}: {told:?}");
    }
    let mut run = shop.program(json!({}), Box::new(Ticking::default()));
    shop.look_and_start(&mut run);
    drive(&mut run);
    assert_eq!(shop.made(), all_made());
    assert_eq!(run.record().unwrap().outcome, Outcome::Finished);
    assert_eq!(run.record().unwrap().interruptions.len(), 5);
}

/// The machine holds after a second without a program; only a person resumes it.
#[test]
fn nothing_new_moves_before_a_person_says_so() {
    let folder = tempfile::tempdir().unwrap();
    let shop = Shop::at(folder.path());
    let mut run = shop.program(json!({"faults": [{"at": 2, "how": "unplug"}]}), Box::new(Ticking::default()));
    shop.look_and_start(&mut run);
    drive(&mut run);
    drop(run);
    let mut run = shop.program(json!({}), Box::new(Ticking::default()));
    for _ in 0..10 {
        run.advance().unwrap();
    }
    assert_eq!((run.overview().phase, shop.made().len()), (Phase::Interrupted, 1));
    // Homing and arming anew would spoil what is begun.
    assert!(matches!(permits::home(run.session()), Err(SessionError::State { .. })));
    assert!(matches!(run.abandon(), Err(JobError::AtWork)));
    assert!(matches!(run.decide(2, StepOutcome::Made), Err(JobError::AtWork)));
    permits::start(&mut run).unwrap();
    drive(&mut run);
    assert_eq!(shop.made(), all_made());
}

#[test]
fn a_stop_is_written_down_and_the_wire_taken_up_by_a_person() {
    for from_elsewhere in [false, true] {
        let folder = tempfile::tempdir().unwrap();
        let shop = Shop::at(folder.path());
        let mut run = shop.program(json!({}), Box::new(Ticking::default()));
        shop.look_and_start(&mut run);
        run.advance().unwrap();
        if from_elsewhere {
            let handle = run.stop_handle();
            assert_eq!(std::thread::spawn(move || handle.stop()).join().unwrap().by, StoppedBy::Driver);
        } else {
            let (outcome, noted) = run.stop();
            noted.unwrap();
            assert_eq!(outcome.by, StoppedBy::Driver);
        }
        let told = drive(&mut run);
        assert_eq!(told.last(), Some(&Progress::Standstill { confirmed: true }));
        let stands = |entry: &Entry| matches!(entry.what, EntryKind::Standstill { confirmed: true });
        assert_eq!(entries(&shop).iter().filter(|entry| stands(entry)).count(), 1);
        let stops = |entry: &Entry| matches!(entry.what, EntryKind::Stopped { by: Some(StoppedBy::Driver) });
        assert_eq!(entries(&shop).iter().filter(|entry| stops(entry)).count(), 1);
        assert!(matches!(permits::start(&mut run), Err(JobError::InDoubt { .. })));
        assert!(matches!(run.resume(), Err(JobError::NotBegun)));
        shop.look_and_start(&mut run);
        drive(&mut run);
        assert_eq!(shop.made(), all_made());
    }
}

#[test]
fn a_pause_is_told_and_ends_at_a_word() {
    let folder = tempfile::tempdir().unwrap();
    let shop = Shop::at(folder.path());
    let mut run = shop.program(json!({}), Box::new(Ticking::default()));
    shop.look_and_start(&mut run);
    run.advance().unwrap();
    run.pause().unwrap();
    let told = run.advance().unwrap();
    assert!(told.contains(&Progress::Paused { by: PausedBy::Program }), "{told:?}");
    let made = shop.made().len();
    run.advance().unwrap();
    assert_eq!((shop.made().len(), run.overview().standing), (made, JobState::Paused));
    run.resume().unwrap();
    let told = drive(&mut run);
    assert!(told.contains(&Progress::Resumed), "{told:?}");
    assert_eq!(shop.made(), all_made());
}

/// As when the wrong machine is plugged in, or a journal was copied.
#[test]
fn a_machine_that_contradicts_the_journal_is_told_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let shop = Shop::at(folder.path());
    let mut run = shop.program(json!({"faults": [{"at": 3, "how": "unplug"}]}), Box::new(Ticking::default()));
    shop.look_and_start(&mut run);
    drive(&mut run);
    drop(run);
    shop.change_machine(|machine| {
        (machine["done"], machine["accepted"]) = (json!(0), json!(0));
    });
    let mut run = shop.program(json!({}), Box::new(Ticking::default()));
    let JobError::Contradiction(contradiction) = permits::start(&mut run).unwrap_err() else {
        panic!("believed")
    };
    assert_eq!(contradiction.kind, ContradictionKind::MadeLess { machine: 0, journal: 2 });
    assert_eq!(run.overview().phase, Phase::Interrupted);
    // Stopped and homed it is a machine that knows nothing, and a person looks.
    let (_, noted) = run.stop();
    noted.unwrap();
    assert_eq!(drive(&mut run), [Progress::Standstill { confirmed: true }]);
    shop.look_and_start(&mut run);
    drive(&mut run);
    assert_eq!(shop.made(), all_made());
}

#[test]
fn a_journal_is_for_its_own_wire() {
    let folder = tempfile::tempdir().unwrap();
    let shop = Shop::at(folder.path());
    let journal = || {
        Journal::create(&shop.journal_path(), shop::heading(), String::new())
            .or_else(|_| Journal::open(&shop.journal_path()))
            .unwrap()
    };
    let refused = |work| {
        let session = shop.session(json!({}), None);
        JobRun::new(session, journal(), work, Box::new(Ticking::default())).unwrap_err().to_string()
    };
    let mut other = work();
    other.run.job_hash = "b0".repeat(32);
    assert!(refused(other).contains("another wire: its job is 5a5a"));
    let mut second = work();
    second.run.wire += 1;
    assert!(refused(second).contains("its number is 1, and that of the job is 2"));
    let mut fewer = work();
    fewer.steps.pop();
    assert!(refused(fewer).contains("has 5 steps, and 4 are there"));
    let mut odd = work();
    odd.steps[2].bend_deg = f64::NAN;
    assert!(refused(odd).contains("step 3 has a value that is no number"));
}
