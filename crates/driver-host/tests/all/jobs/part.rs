//! A step that was ended in its middle: only its rest is done, as far as the machine counts or a person says.

use serde_json::{Value, json};
use wirebend_driver_host::api::Step;
use wirebend_driver_host::jobs::{
    EntryKind, JobError, JobRun, Journal, Part, Progress, Resume, StepOutcome, SystemClock, ToldBy, WireJob,
};

use super::shop::{Shop, home, work};
use super::{drive, entries};
use crate::permits;

/// A wire that was stopped when one step was done, with what the machine says of the second. The sum of what is sent of the
/// second step is that step.
fn stopped(shop: &Shop, cut: &Value) -> JobRun {
    stopped_of(shop, cut, work())
}

fn stopped_of(shop: &Shop, cut: &Value, work: WireJob) -> JobRun {
    // It holds when one is done.
    let settings = json!({"cut": cut, "faults": [{"at": 1, "how": "hold"}]});
    let mut run = shop.program_for(settings, Box::new(SystemClock::default()), work);
    home(run.session());
    permits::start(&mut run).unwrap();
    while run.journal_state().done < 1 {
        run.advance().unwrap();
    }
    run.stop().1.unwrap();
    let told = drive(&mut run);
    assert_eq!(told.last(), Some(&Progress::Standstill { confirmed: true }));
    run
}

/// Every step as it was sent to the machine, in order.
fn told(shop: &Shop) -> Vec<Step> {
    serde_json::from_value(shop.machine()["told"].clone()).unwrap()
}

/// What is sent to the machine of the second step after the stop, and where its head was said to stand.
fn rest(shop: &Shop, run: &mut JobRun) -> (Step, f64) {
    let before = told(shop).len();
    home(run.session());
    permits::start(run).unwrap();
    drive(run);
    let all = work().steps;
    assert_eq!(told(shop)[before + 1..], all[2..], "those after it are whole");
    (told(shop)[before], shop.machine()["heads"].as_array().unwrap().last().unwrap().as_f64().unwrap())
}

fn second() -> Step {
    work().steps[1]
}

#[test]
fn only_the_step_under_way_is_in_doubt_where_the_machine_says_which() {
    let folder = tempfile::tempdir().unwrap();
    let shop = Shop::at(folder.path());
    let run = stopped(&shop, &json!({"made": null, "exact": false}));
    assert_eq!(run.resume_from(), Resume::Ask { in_doubt: 2, last: 2 });
    assert_eq!(run.doubtful().unwrap().counted, None);
}

/// Feed and head were at rest, so that the machine knows: the user is not asked.
#[test]
fn a_bend_that_was_stopped_is_made_again_and_nothing_is_fed_twice() {
    let folder = tempfile::tempdir().unwrap();
    let shop = Shop::at(folder.path());
    let Step { feed_mm, rotate_deg, bend_deg, .. } = second();
    let made = Step { bend_deg: bend_deg / 2.0, ..second() };
    let mut run = stopped(&shop, &json!({"made": made, "exact": false}));
    assert_eq!(run.resume_from(), Resume::Arm { from: 2 });
    let before = work().steps[0].rotate_deg;
    let (rest, head) = rest(&shop, &mut run);
    assert_eq!(
        (rest, head),
        (Step { feed_mm: 0.0, rotate_deg: 0.0, bend_deg, approach_deg: None }, before + rotate_deg)
    );
    let part = EntryKind::Part { n: 2, feed_mm, rotate_deg, by: ToldBy::Machine };
    assert!(entries(&shop).iter().any(|entry| entry.what == part));
}

/// The head had come to its place with its play on one side. From zero it comes from the other, unless it goes farther and back.
#[test]
fn a_head_with_play_comes_to_its_place_as_it_did_before() {
    let folder = tempfile::tempdir().unwrap();
    let shop = Shop::at(folder.path());
    let Step { bend_deg, rotate_deg, .. } = second();
    assert!(rotate_deg < 0.0 && work().steps[0].rotate_deg + rotate_deg < 0.0);
    let made = Step { bend_deg: bend_deg / 2.0, ..second() };
    let job = WireJob { head_play_deg: 1.5, ..work() };
    let mut run = stopped_of(&shop, &json!({"made": made, "exact": false}), job);
    let place = work().steps[0].rotate_deg + rotate_deg;
    let (last, head) = rest(&shop, &mut run);
    assert_eq!((last.rotate_deg, head), (-2.5, place + 2.5));
}

/// What turned it to zero may have left its play on either side: it stands before zero first, and comes back with the first step, as far as
/// it can turn.
#[test]
fn a_head_with_play_comes_to_zero_before_a_wire_from_the_side_of_its_first_turn() {
    let first = work().steps.iter().map(|step| step.rotate_deg).find(|turn| *turn != 0.0).unwrap();
    for (head_range_deg, more) in [([-360.0, 360.0], 2.5), ([-1.0, 1.0], 1.0), ([0.0, 0.0], 0.0)] {
        let folder = tempfile::tempdir().unwrap();
        let shop = Shop::at(folder.path());
        let job = WireJob { head_play_deg: 1.5, head_range_deg, ..work() };
        let mut run = shop.program_for(json!({}), Box::new(SystemClock::default()), job);
        home(run.session());
        permits::start(&mut run).unwrap();
        drive(&mut run);
        // What is turned of the first step takes up as much of it.
        let own = (work().steps[0].rotate_deg * first.signum()).max(0.0);
        let expected = (more - own).max(0.0) * first.signum();
        assert_eq!(shop.machine()["heads"], json!([-expected + 0.0]), "{head_range_deg:?}");
        let mut wanted = work().steps;
        wanted[0].rotate_deg += expected;
        assert_eq!(told(&shop), wanted);
        let ends = wanted.iter().map(|step| step.rotate_deg).sum::<f64>() - expected;
        assert!((run.session().head_deg() - ends).abs() < 1e-9);
    }
}

/// An axis that was on its way may have lost steps as it stopped.
#[test]
fn a_feed_that_was_stopped_is_measured_unless_it_stood() {
    for (exact, measured) in [(true, None), (false, None), (false, Some(3.5))] {
        let folder = tempfile::tempdir().unwrap();
        let shop = Shop::at(folder.path());
        let made = Step { feed_mm: 4.0, ..Step::default() };
        let mut run = stopped(&shop, &json!({"made": made, "exact": exact}));
        if exact {
            assert_eq!(run.resume_from(), Resume::Arm { from: 2 });
        } else {
            assert_eq!(run.resume_from(), Resume::Ask { in_doubt: 2, last: 2 });
            let doubtful = run.doubtful().unwrap();
            assert!(doubtful.measure);
            assert_eq!(doubtful.counted, Some(Part { feed_mm: 4.0, rotate_deg: 0.0 }));
            let feed_mm = measured.unwrap_or(4.0);
            let said = StepOutcome::Part(Part { feed_mm, rotate_deg: 0.0 });
            assert_eq!(run.decide(2, said).unwrap(), Resume::Arm { from: 2 });
        }
        let (rest, _) = rest(&shop, &mut run);
        let feed_mm = second().feed_mm - measured.unwrap_or(4.0);
        assert_eq!(rest, Step { feed_mm, ..second() });
    }
}

/// What was in the wire before the second stop counts with what came after it.
#[test]
fn a_step_that_is_stopped_twice_is_made_once() {
    let folder = tempfile::tempdir().unwrap();
    let shop = Shop::at(folder.path());
    let made = Step { feed_mm: 4.0, ..Step::default() };
    let mut run = stopped(&shop, &json!({"made": made, "exact": true}));
    home(run.session());
    permits::start(&mut run).unwrap();
    run.advance().unwrap();
    run.pause().unwrap();
    run.stop().1.unwrap();
    drive(&mut run);
    let doubtful = run.doubtful().unwrap();
    assert_eq!((doubtful.before.feed_mm, doubtful.counted.unwrap().feed_mm), (4.0, 8.0));
    let (rest, _) = rest(&shop, &mut run);
    assert_eq!(rest, Step { feed_mm: second().feed_mm - 8.0, ..second() });
    // The same from the journal alone.
    let state = Journal::read(&shop.journal_path()).unwrap().state;
    assert!(state.is_over() && state.part == Part::default());
}

#[test]
fn no_more_than_the_step_has_can_be_in_the_wire() {
    let folder = tempfile::tempdir().unwrap();
    let shop = Shop::at(folder.path());
    let mut run = stopped(&shop, &json!({"made": null, "exact": false}));
    let Step { feed_mm, rotate_deg, .. } = second();
    for (feed_mm, rotate_deg) in [
        (feed_mm + 2.0, 0.0),
        (-2.0, 0.0),
        (0.0, rotate_deg + 3.0 * rotate_deg.signum()),
        (f64::NAN, 0.0),
        (0.0, f64::INFINITY),
        (1.0, -400.0),
    ] {
        let said = run.decide(2, StepOutcome::Part(Part { feed_mm, rotate_deg }));
        assert!(matches!(said, Err(JobError::NotOfStep { step: 2, .. })), "{feed_mm} {rotate_deg}: {said:?}");
    }
    assert_eq!(run.resume_from(), Resume::Ask { in_doubt: 2, last: 2 }, "nothing was written down");
}

/// A machine that reports another step than the journal knows of is stopped, and settles nothing.
#[test]
fn a_machine_that_contradicts_the_journal_settles_no_step() {
    let folder = tempfile::tempdir().unwrap();
    let shop = Shop::at(folder.path());
    let clock = || Box::new(SystemClock::default());
    let mut run = shop.program(json!({"faults": [{"at": 2, "how": "unplug"}]}), clock());
    home(run.session());
    permits::start(&mut run).unwrap();
    drive(&mut run);
    drop(run);
    shop.change_machine(|machine| machine["done"] = json!(0));
    let mut run = shop.program(json!({"cut": {"made": null, "exact": false}}), clock());
    assert!(matches!(run.resume_from(), Resume::Contradiction(_)), "{:?}", run.resume_from());
    run.stop().1.unwrap();
    drive(&mut run);
    assert!(matches!(run.resume_from(), Resume::Ask { in_doubt: 2, .. }), "{:?}", run.resume_from());
    assert!(!entries(&shop).iter().any(|entry| matches!(entry.what, EntryKind::PartMade { .. })));
}

/// A machine that stands where this step cannot bring it does not show how much of it is done.
#[test]
fn a_place_that_the_step_does_not_come_by_is_not_believed() {
    let Step { feed_mm, bend_deg, .. } = second();
    for made in [
        Step { feed_mm: feed_mm + 5.0, ..Step::default() },
        Step { feed_mm: -5.0, ..Step::default() },
        // Bent too far: no step corrects that.
        Step { bend_deg: bend_deg + 5.0 * bend_deg.signum(), ..second() },
    ] {
        let folder = tempfile::tempdir().unwrap();
        let shop = Shop::at(folder.path());
        let run = stopped(&shop, &json!({"made": made, "exact": true}));
        assert_eq!(run.resume_from(), Resume::Ask { in_doubt: 2, last: 2 }, "{made:?}");
        assert_eq!(run.doubtful().unwrap().counted, None);
    }
}
