//! A stop at any time, and an end at any time.

use std::cell::RefCell;

use serde_json::json;
use wirebend_driver_host::StoppedBy;
use wirebend_error::ErrorRemedy;
use wirebend_operation::{
    Answer, OperatorEvent, OrderName, Phase, Question, QuestionKind, RunOutcome, RunResponse,
};
use wirebend_planning::Input;

use crate::shop::{Seat, Shop};

/// Stops, and waits until that is reported and over.
#[track_caller]
fn stopped(seat: &Seat) -> StoppedBy {
    assert!(seat.operator.stop());
    let by = until_stopped(seat);
    seat.until_phase(Phase::Stopped);
    by
}

#[track_caller]
fn until_stopped(seat: &Seat) -> StoppedBy {
    seat.until(|event| match event {
        OperatorEvent::Stopped { by, .. } => Some(*by),
        _ => None,
    })
}

/// How often a stop may come between two steps, or after the last one: this program is told of a step when it is over, and on a busy
/// computer late.
const TRIES: usize = 10;

/// A wire that was stopped in the middle of a step, and what was reported of it.
#[track_caller]
fn stopped_in_a_step() -> (Shop, Seat, Input, RunResponse) {
    for _ in 0..TRIES {
        let shop = Shop::new();
        let (seat, job) = (shop.simulated("sim:10"), shop.cube("wirebend-kit"));
        seat.start(&job);
        seat.until_made(2);
        if seat.operator.stop() {
            let run = seat.until_run();
            if run.wires[0].in_doubt.is_some() {
                seat.until_phase(Phase::Stopped);
                return (shop, seat, job, run);
            }
        }
    }
    panic!("none of {TRIES} stops came within a step");
}

#[test]
fn a_machine_is_stopped_in_every_phase_and_goes_on_after_homing() {
    let shop = Shop::new();
    let (seat, job) = (shop.simulated("sim:10"), shop.cube("wirebend-kit"));
    assert_eq!(stopped(&seat), StoppedBy::Driver, "at rest");

    seat.order(&json!({"order": "home"}));
    seat.until_phase(Phase::Homing);
    assert_eq!(stopped(&seat), StoppedBy::Driver, "homing");
    seat.home();

    // Each takes a real machine nine seconds.
    let feeds = vec![json!({"move": "feed", "mm": 1000.0}); 50];
    seat.order(&json!({"order": "jog", "moves": feeds}));
    seat.until_phase(Phase::Moving);
    assert_eq!(stopped(&seat), StoppedBy::Driver, "moving");

    seat.arm(&job);
    let question = seat.until_question();
    assert!(seat.operator.stop(), "while a person is asked");
    let answer = seat.until(|event| match event {
        OperatorEvent::Answered { id, answer } if *id == question.id => Some(*answer),
        _ => None,
    });
    assert_eq!(answer, Answer::No);
    seat.until_phase(Phase::Stopped);
    assert!(seat.operator.answer(question.id, Answer::Yes).is_err());

    seat.start(&job);
    seat.until_phase(Phase::Homing);
    assert!(seat.operator.stop());
    let run = seat.until_run();
    assert_eq!((run.wires[0].outcome, run.wires[0].made), (RunOutcome::Stopped, 0), "homing for a wire");
    assert_eq!(run.wires[0].resume, None, "nothing was sent");
    until_stopped(&seat);
    seat.until_phase(Phase::Stopped);

    seat.start(&job);
    seat.until_phase(Phase::Making);
    assert!(seat.operator.stop());
    let run = seat.until_run();
    assert_eq!(
        (run.wires[0].outcome, run.wires[0].stopped_by),
        (RunOutcome::Stopped, Some(StoppedBy::Driver))
    );
    seat.until_phase(Phase::Stopped);
    seat.home();
}

/// An order and a stop in the same moment: whichever the machine hears of first, it does not move afterwards.
#[test]
fn what_was_ordered_before_a_stop_does_not_move_a_machine_after_it() {
    let shop = Shop::new();
    let seat = shop.simulated("sim:10");
    for round in 0..9 {
        seat.order(&json!({"order": "home"}));
        match round % 3 {
            0 => {}
            1 => drop(seat.until_state(|state| state.busy)),
            _ => drop(seat.until_phase(Phase::Homing)),
        }
        assert_eq!(stopped(&seat), StoppedBy::Driver);
        // Were it on its way, it would be homed in a while, and another order refused until then.
        seat.order(&json!({"order": "jog", "moves": [{"move": "home"}]}));
        seat.until_phase(Phase::Homing);
        assert_eq!(stopped(&seat), StoppedBy::Driver);
    }
}

/// A person waits for that before they put their hands in the machine.
#[test]
fn a_machine_is_told_to_stand_before_its_order_is_over() {
    let shop = Shop::new();
    let (seat, job) = (shop.simulated("sim:10"), shop.cube("wirebend-kit"));
    seat.start(&job);
    seat.until_phase(Phase::Making);
    assert!(seat.operator.stop());
    let told = RefCell::new(Vec::new());
    seat.until(|event| match event {
        OperatorEvent::State(state) => {
            told.borrow_mut().push((state.phase, state.busy));
            None
        }
        OperatorEvent::RunEnded(_) => Some(()),
        _ => None,
    });
    assert_eq!(told.into_inner().last(), Some(&(Phase::Stopped, true)));
    let state = seat.until_phase(Phase::Stopped);
    assert!(state.can.contains(&OrderName::Home), "{state:?}");
}

/// It resumes where it was stopped, on the same connection: the wire is in the machine still.
#[test]
fn a_stopped_wire_is_gone_on_with_on_the_same_connection() {
    let (shop, seat, job, run) = stopped_in_a_step();
    let [first, last] = run.wires[0].in_doubt.unwrap();
    assert_eq!(first, run.wires[0].made + 1);
    assert_eq!(seat.operator.state().unfinished.unwrap().in_doubt, Some([first, last]));
    // The answer is not known: nothing moves, and nothing is decided.
    seat.resume(&job);
    let doubt = seat.says(Answer::No).doubt.unwrap();
    assert_eq!((doubt.step, doubt.last, doubt.of), (first, last, 8));
    assert_eq!(seat.until_problem().0, "in-doubt");
    seat.until_phase(Phase::Stopped);
    seat.resume(&job);
    seat.says(Answer::NotMade);
    let question = seat.says(Answer::Yes);
    assert!(question.lines.iter().any(|line| line.contains(&format!("resumes at step {first}"))));
    seat.until_phase(Phase::Homing);
    assert_eq!(seat.until_run().wires[0].outcome, RunOutcome::Made);
    assert_eq!(seat.until_phase(Phase::Ready).unfinished, None);
    let record = shop.record();
    assert_eq!((record.made, record.interruptions.len(), record.decisions.len()), (8, 1, 1));
}

/// What was moved meanwhile is in the wire, and the wire that comes after it has nothing to do with that.
#[test]
fn moves_by_hand_before_a_wire_goes_on_are_told() {
    let (_shop, seat, job, _) = stopped_in_a_step();
    seat.home();
    seat.order(&json!({"order": "jog", "moves": [{"move": "feed", "mm": 20.0}]}));
    seat.until_state(|state| state.phase == Phase::Ready && !state.busy);
    let told =
        |question: &Question| question.lines.iter().any(|line| line.contains("since it was interrupted"));
    seat.resume(&job);
    seat.says(Answer::NotMade);
    assert!(told(&seat.says(Answer::No)));
    seat.until_state(|state| state.question.is_none() && !state.busy);
    seat.resume(&job);
    // What was said of the step counts; whether it was right is asked.
    let said = seat.says(Answer::Yes);
    assert_eq!(said.kind, QuestionKind::Said, "{said:?}");
    assert!(said.question.contains("You have said before: nothing of step"), "{said:?}");
    assert!(told(&seat.says(Answer::Yes)), "a no changes nothing");
    assert_eq!(seat.until_run().wires[0].outcome, RunOutcome::Made);
    seat.until_phase(Phase::Ready);
    seat.arm(&job);
    assert!(!seat.says(Answer::No).lines.iter().any(|line| line.contains("by hand")));
}

/// Before there is anything to stop, a stop is kept until there is.
#[test]
fn a_machine_that_is_being_connected_is_stopped() {
    let shop = Shop::odd("poll-hang", |_| json!({}));
    let seat = shop.connect("odd", Some("anywhere"));
    assert!(seat.operator.stop());
    until_stopped(&seat);
    // Whether the driver was still able to pass it on, or had to be ended for it.
    let (code, _) = seat.until_problem();
    assert!(["stopped", "driver-ended", "stop-not-confirmed"].contains(&code.as_str()), "{code}");
    let state = seat.until_phase(Phase::Failed);
    assert_eq!(state.problem.map(|problem| problem.code), Some(code));
    assert!(!seat.operator.stop(), "nothing is connected any more");
    // And the next one is connected.
    drop(seat);
    Shop::new().simulated("sim:max");
}

/// A driver that does not pass a stop on is ended, and a person hears what that means.
#[test]
fn a_driver_that_does_not_stop_is_ended() {
    let shop = Shop::odd("stop-hang", |_| json!({}));
    let seat = shop.connect("odd", Some("anywhere"));
    seat.until_phase(Phase::Connected);
    assert!(seat.operator.stop());
    assert_eq!(until_stopped(&seat), StoppedBy::EndOfDriver);
    let report = seat.until_report();
    assert_eq!(report.code, "driver-ended");
    assert!(report.remedies.contains(&ErrorRemedy::CutPower), "{report:?}");
    seat.until_phase(Phase::Failed);
}

/// A window that is closed does not leave a machine moving, nor wait for it.
#[test]
fn dropping_an_operator_stops_what_moves_and_closes_the_port() {
    let shop = Shop::new();
    let (seat, job) = (shop.simulated("sim:10"), shop.cube("wirebend-kit"));
    seat.home();
    seat.start(&job);
    seat.until_phase(Phase::Making);
    let Seat { operator, .. } = seat;
    drop(operator);
    // It has not waited for the end of the wire, and what was heard last is on the disk.
    let record = shop.record();
    assert!(record.made < 8, "{record:?}");
    assert_eq!(record.interruptions.last().map(|last| last.what.as_str()), Some("stopped"));
    // While a person is asked, too.
    let seat = shop.simulated("sim:max");
    let other = shop.job("house.obj", "wirebend-kit");
    seat.arm(&other);
    seat.until_question();
    let Seat { operator, .. } = seat;
    drop(operator);
}
