//! Machines, lines and drivers that fail.

use serde_json::json;
use wirebend_error::ErrorRemedy;
use wirebend_operation::{Answer, Decided, Decision, OrderName, Outcome, Phase, QuestionKind, RunOutcome};

use crate::shop::{Seat, Shop, arm, resume};

fn connected(shop: &Shop) -> Seat {
    let seat = shop.connect("odd", Some("anywhere"));
    seat.until_phase(Phase::Connected);
    seat
}

const ALL: [u64; 8] = [1, 2, 3, 4, 5, 6, 7, 8];

/// Nothing is asked of a driver that is gone, nor of one in the middle of a wire that nobody confirmed.
const UNTIL_CONNECTED_AGAIN: [OrderName; 3] =
    [OrderName::ResumeRun, OrderName::Abandon, OrderName::Disconnect];

/// The controller starts anew in the middle of a wire: what was sent and not reported a person looks at.
#[test]
fn a_wire_is_finished_after_a_reset_with_the_doubt_asked() {
    for (how, made) in [("reset", false), ("reset-after", true)] {
        let shop = Shop::faulty(3, how);
        let (seat, job) = (connected(&shop), shop.cube("odd"));
        seat.start(&job);
        let (code, _) = seat.until_problem();
        assert_eq!(code, "reset");
        let run = seat.until_run();
        assert_eq!((run.wires[0].outcome, run.wires[0].made), (RunOutcome::Failed, 2), "{how}");
        let failed = seat.until_phase(Phase::Failed);
        let left = failed.unfinished.unwrap();
        assert_eq!((left.made, left.of, left.in_doubt.unwrap()[0]), (2, 8, 3));
        assert!(failed.can.contains(&OrderName::ResumeRun) && !failed.can.contains(&OrderName::Arm));
        seat.resume(&job);
        let asked = seat.says(if made { Answer::Made } else { Answer::NotMade });
        assert_eq!((asked.kind, asked.doubt.unwrap().step), (QuestionKind::Doubt, 3));
        // Three steps were taken of the four that were sent: the user is not asked about the fourth.
        let asked = seat.says(Answer::Yes);
        assert_eq!(asked.kind, QuestionKind::Resume);
        // The same happens at step 3 to a user who bends that again.
        if !made {
            assert_eq!(seat.until_problem().0, "reset");
            continue;
        }
        assert_eq!(seat.until_run().wires[0].outcome, RunOutcome::Made);
        seat.until_phase(Phase::Ready);
        assert_eq!(shop.made(), ALL, "each step was done once");
        let record = shop.record();
        assert_eq!((record.outcome, record.decisions.len()), (Outcome::Finished, 1));
    }
}

/// The driver dies; the machine still is in the wire, and resumes it without a doubt.
#[test]
fn a_wire_goes_on_in_the_machine_when_its_driver_has_died() {
    let shop = Shop::faulty(3, "crash-after");
    let (seat, job) = (connected(&shop), shop.cube("odd"));
    seat.start(&job);
    seat.until_problem();
    assert_eq!(seat.until_run().wires[0].outcome, RunOutcome::Failed);
    seat.until_phase(Phase::Failed);
    // Without a yes the machine is left in it.
    seat.resume(&job);
    let asked = seat.says(Answer::No);
    assert!(asked.lines.iter().any(|line| line.contains("still is in this wire")), "{:?}", asked.lines);
    assert_eq!(seat.until_problem().0, "left-in-wire");
    assert_eq!(seat.until_phase(Phase::Failed).can, UNTIL_CONNECTED_AGAIN);
    seat.resume(&job);
    seat.says(Answer::Yes);
    assert_eq!(seat.until_run().wires[0].outcome, RunOutcome::Made);
    seat.until_phase(Phase::Ready);
    assert_eq!(shop.made(), ALL);
}

/// The cable is pulled, and the window closed. The machine waits in its wire: it refuses a program that does not know of that,
/// and resumes with one that does.
#[test]
fn a_machine_that_is_unplugged_is_told_and_goes_on_in_a_new_window() {
    let shop = Shop::faulty(5, "unplug-after");
    let (seat, job) = (connected(&shop), shop.cube("odd"));
    seat.start(&job);
    let report = seat.until_report();
    assert_eq!(report.code, "unplugged");
    let says = |remedy: &ErrorRemedy| matches!(remedy, ErrorRemedy::FollowDriver { advice } if advice.contains("connect again"));
    assert!(report.remedies.iter().any(says), "{report:?}");
    assert_eq!(seat.until_phase(Phase::Failed).can, UNTIL_CONNECTED_AGAIN);
    drop(seat);
    let seat = shop.connect("odd", Some("anywhere"));
    seat.until_problem();
    let failed = seat.until_phase(Phase::Failed);
    assert_eq!(failed.unfinished.map(|left| (left.made, left.of)), Some((4, 8)));
    seat.resume(&job);
    assert_eq!(seat.says(Answer::Yes).kind, QuestionKind::Resume);
    assert_eq!(seat.until_run().wires[0].outcome, RunOutcome::Made);
    assert_eq!(shop.made(), ALL);
}

/// What is said with the order is not asked again.
#[test]
fn a_doubt_is_decided_with_the_order() {
    let shop = Shop::faulty(8, "reset-after");
    let (seat, job) = (connected(&shop), shop.cube("odd"));
    seat.start(&job);
    seat.until_problem();
    seat.until_phase(Phase::Failed);
    let decided = Some(Decided { step: 8, what: Decision::Made });
    seat.operator.order_wire(resume(decided), job.clone()).unwrap();
    // It was the last: nothing moves, and the user is not asked.
    assert_eq!(seat.until_run().wires[0].outcome, RunOutcome::MadeBefore);
    assert_eq!(shop.record().outcome, Outcome::Finished);
    assert_eq!(shop.made(), ALL);
}

/// A person who has pressed the machine's own button may be at it still.
#[test]
fn a_machine_that_was_made_to_hold_goes_on_at_a_persons_word() {
    for (answer, outcome) in [(Answer::Yes, RunOutcome::Made), (Answer::No, RunOutcome::Stopped)] {
        let shop = Shop::faulty(2, "hold");
        let (seat, job) = (connected(&shop), shop.cube("odd"));
        seat.start(&job);
        seat.until_phase(Phase::Holding);
        let asked = seat.says(answer);
        assert_eq!(asked.kind, QuestionKind::Resume);
        assert!(asked.question.contains("at the machine itself"), "{}", asked.question);
        assert_eq!(seat.until_run().wires[0].outcome, outcome);
    }
    // A stop is an answer, too.
    let shop = Shop::faulty(2, "hold");
    let (seat, job) = (connected(&shop), shop.cube("odd"));
    seat.start(&job);
    seat.until_question();
    assert!(seat.operator.stop());
    assert_eq!(seat.until_run().wires[0].outcome, RunOutcome::Stopped);
    seat.until_phase(Phase::Stopped);
    assert_eq!(shop.made(), [1, 2]);
}

/// A machine that hears nothing for too long holds. The rest of a move by hand is not resumed: the user orders it again.
#[test]
fn a_hold_in_a_move_by_hand_ends_it() {
    for (at, order) in
        [(1, json!({"order": "home"})), (2, json!({"order": "jog", "moves": [{"move": "feed", "mm": 5.0}]}))]
    {
        let shop =
            Shop::odd("hostile", |folder| json!({"machine": folder.join("kept"), "holds_by_hand": at}));
        let seat = connected(&shop);
        if at == 2 {
            seat.order(&json!({"order": "home"}));
            seat.says(Answer::Yes);
            seat.until_phase(Phase::Ready);
        }
        seat.order(&order);
        if at == 1 {
            seat.says(Answer::Yes);
        }
        let report = seat.until_report();
        assert_eq!(report.code, "held");
        assert!(report.message.contains("heard nothing"), "{report:?}");
        assert_eq!(report.remedies, [ErrorRemedy::Home]);
        let stopped = seat.until_phase(Phase::Stopped);
        assert!(stopped.can.contains(&OrderName::Home) && !stopped.can.contains(&OrderName::Jog));
        seat.order(&json!({"order": "home"}));
        seat.says(Answer::Yes);
        seat.until_phase(Phase::Ready);
    }
}

/// A user who comes back to a wire that did not begin has to read why: they have not stopped it.
#[test]
fn a_hold_while_a_wire_is_homed_is_told_with_the_wire() {
    let shop = Shop::odd("hostile", |folder| json!({"machine": folder.join("kept"), "holds_by_hand": 1}));
    let (seat, job) = (connected(&shop), shop.cube("odd"));
    seat.start(&job);
    let report = seat.until_report();
    assert_eq!(report.code, "held");
    assert!(report.message.contains("heard nothing"), "{report:?}");
    assert_eq!(report.remedies, [ErrorRemedy::Home]);
    let run = seat.until_run();
    assert_eq!((run.wires[0].outcome, run.wires[0].made), (RunOutcome::Stopped, 0));
    assert_eq!(run.wires[0].problem.as_ref().map(|problem| problem.code.as_str()), Some("held"));
    let stopped = seat.until_phase(Phase::Stopped);
    assert_eq!(stopped.problem.map(|problem| problem.message), Some(report.message));
}

/// A driver that does not stop what holds leaves a machine that may resume by itself: a person has to cut its power.
#[test]
fn a_hold_that_cannot_be_stopped_is_told_as_what_it_is() {
    for order in ["home", "start"] {
        let shop =
            Shop::odd("stop-hang", |folder| json!({"machine": folder.join("kept"), "holds_by_hand": 1}));
        let (seat, job) = (connected(&shop), shop.cube("odd"));
        if order == "home" {
            seat.order(&json!({"order": "home"}));
            seat.says(Answer::Yes);
        } else {
            seat.start(&job);
        }
        let report = seat.until_report();
        assert_eq!(report.code, "driver-ended", "{order}: {report:?}");
        assert!(report.message.contains("held"), "{order}: {report:?}");
        assert!(report.remedies.contains(&ErrorRemedy::CutPower), "{order}: {report:?}");
        let failed = seat.until_phase(Phase::Failed);
        assert_eq!(failed.problem, Some(report), "{order}");
    }
}

/// A machine that is set otherwise is set as its profile says at a person's word; nothing moves, and it has to be homed.
#[test]
fn a_machine_is_set_as_its_profile_says() {
    let shop = Shop::odd("hostile", |folder| json!({"machine": folder.join("kept"), "misset": true}));
    let (seat, job) = (shop.connect("odd", Some("anywhere")), shop.cube("odd"));
    let state = seat.until_phase(Phase::Connected);
    assert_eq!((state.settings.len(), state.can.contains(&OrderName::WriteSettings)), (1, true));
    seat.order(&json!({"order": "write-settings"}));
    let question = seat.says(Answer::No);
    assert_eq!(question.kind, QuestionKind::Settings);
    assert!(question.lines.iter().any(|line| line == "$100: 80 becomes 40"), "{:?}", question.lines);
    assert_eq!(seat.until_phase(Phase::Connected).settings.len(), 1);
    for from in [Phase::Ready, Phase::Stopped] {
        seat.order(&json!({"order": "home"}));
        seat.says(Answer::Yes);
        seat.until_phase(Phase::Ready);
        if from == Phase::Stopped {
            assert!(seat.operator.stop());
            seat.until_phase(Phase::Stopped);
        }
        seat.order(&json!({"order": "write-settings"}));
        seat.says(Answer::Yes);
        let state = seat.until_state(|state| !state.busy && state.question.is_none());
        let after = if from == Phase::Ready { Phase::Connected } else { Phase::Stopped };
        assert_eq!((state.phase, state.settings), (after, Vec::new()));
    }
    // Nothing is in the way of a wire any more.
    seat.arm(&job);
    seat.says(Answer::No);
}

/// A machine that does not keep what was written would bend by other numbers, and the user would not notice.
#[test]
fn settings_that_were_not_taken_are_told() {
    let shop = Shop::odd("connect-differ", |_| json!({}));
    let seat = connected(&shop);
    seat.order(&json!({"order": "write-settings"}));
    seat.says(Answer::Yes);
    assert_eq!(seat.until_problem().0, "settings-differ");
    assert_eq!(seat.until_phase(Phase::Connected).settings.len(), 1);
}

/// A driver that dies while it is asked to move: nothing hangs, and what to do is said.
#[test]
fn a_driver_that_dies_is_told() {
    for conduct in ["home-exit", "home-hang"] {
        let shop = Shop::odd(conduct, |_| json!({}));
        let seat = connected(&shop);
        seat.order(&json!({"order": "home"}));
        seat.says(Answer::Yes);
        let (_, message) = seat.until_problem();
        assert!(message.contains("hostile"), "{message}");
        assert_eq!(seat.until_phase(Phase::Failed).can, UNTIL_CONNECTED_AGAIN);
    }
    let shop = Shop::odd("connect-exit", |_| json!({}));
    let seat = shop.connect("odd", Some("anywhere"));
    seat.until_problem();
    assert_eq!(seat.until_phase(Phase::Failed).can, UNTIL_CONNECTED_AGAIN);
    // A machine that there is not.
    let seat = shop.connect("nobody", None);
    assert!(seat.until_problem().1.contains("nobody"));
    assert!(seat.until_phase(Phase::Failed).can.is_empty());
}

#[test]
fn a_wire_is_not_made_with_other_settings_unasked() {
    let shop = Shop::odd("connect-differ", |_| json!({}));
    let (seat, job) = (shop.connect("odd", Some("anywhere")), shop.cube("odd"));
    let state = seat.until_phase(Phase::Connected);
    assert_eq!((state.settings[0].machine.as_str(), state.settings[0].expected.as_str()), ("80", "40"));
    for _ in 0..2 {
        seat.arm(&job);
        assert_eq!(seat.until_problem().0, "settings-differ");
        seat.until_phase(Phase::Connected);
        seat.operator.order_wire(arm(0, true), job.clone()).unwrap();
        seat.says(Answer::No);
        seat.until_phase(Phase::Connected);
    }
    seat.operator.order_wire(arm(0, true), job.clone()).unwrap();
    seat.says(Answer::Yes);
    seat.until_phase(Phase::Armed);
    seat.order(&json!({"order": "start"}));
    assert_eq!(seat.until_run().wires[0].outcome, RunOutcome::Made);
    seat.until_phase(Phase::Ready);
    // That it was accepted for one says nothing of the next.
    seat.arm(&job);
    assert_eq!(seat.until_problem().0, "settings-differ");
}
