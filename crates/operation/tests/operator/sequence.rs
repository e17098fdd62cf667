//! All wires of a design, one after the other.

use wirebend_operation::{Answer, Order, OrderName, Phase, QuestionKind, Repeat, RunHow, RunOutcome};
use wirebend_planning::Input;

use crate::shop::{Seat, Shop};

/// Arms both wires of a design, so many times over, and starts the first.
fn start(seat: &Seat, job: &Input, pieces: u32) {
    let repeat = Repeat { pieces, ..Repeat::default() };
    let order = Order::Arm { wire: None, repeat, accept_settings: false, despite_errors: false };
    seat.operator.order_wire(order, job.clone()).unwrap();
    let asked = seat.says(Answer::Yes);
    assert_eq!(asked.kind, QuestionKind::Arm);
    assert!(asked.lines.iter().any(|line| line.starts_with("wire 1 of 2")), "{:?}", asked.lines);
    seat.until_phase(Phase::Armed);
    seat.operator.order(Order::Start).unwrap();
}

#[test]
fn each_wire_of_each_piece_is_bent_and_asked_about() {
    let shop = Shop::new();
    let (seat, job) = (shop.simulated("sim:max"), shop.job("two-parts.obj", "wirebend-kit"));
    seat.home();
    start(&seat, &job, 2);
    for (n, (wire, left, made)) in
        [(0, &[1][..], 0), (1, &[], 1), (0, &[1], 1), (1, &[], 2)].into_iter().enumerate()
    {
        if n > 0 {
            let asked = seat.until_question();
            assert_eq!(asked.kind, QuestionKind::Piece);
            let which = format!("wire {} of 2", wire + 1);
            assert!(asked.lines.iter().any(|line| line.starts_with(&which)), "{:?}", asked.lines);
            let next = seat.operator.state().wire.unwrap();
            assert_eq!((next.wire, next.made), (wire, 0), "nothing of it is bent yet");
            seat.operator.answer(asked.id, Answer::Yes).unwrap();
        }
        let run = seat.until_run();
        assert_eq!((run.wires[0].wire, run.wires[0].outcome), (wire, RunOutcome::Made));
        assert_eq!((run.left.as_slice(), run.pieces.made, run.pieces.of), (left, made, 2));
    }
    let state = seat.until_phase(Phase::Ready);
    assert!(state.can.contains(&OrderName::Arm) && state.unfinished.is_none());
}

/// A finished wire that is forgotten in the machine is bent into the next one.
#[test]
fn what_was_bent_before_is_asked_about_until_a_person_has_seen_to_it() {
    let shop = Shop::new();
    let (seat, job) = (shop.simulated("sim:max"), shop.job("u-sample.obj", "wirebend-kit"));
    seat.home();
    let told = |answer| {
        seat.arm(&job);
        let asked = seat.says(answer);
        seat.until_state(|state| state.question.is_none() && !state.busy);
        asked.lines.iter().any(|line| line.contains("cut it off and take it out"))
    };
    assert!(!told(Answer::Yes), "nothing was bent");
    seat.operator.order(Order::Start).unwrap();
    seat.until_run();
    seat.until_phase(Phase::Ready);
    assert!(told(Answer::No));
    assert!(told(Answer::Yes), "after a no it is still there");
    seat.operator.order(Order::Disarm).unwrap();
    seat.until_phase(Phase::Ready);
    assert!(!told(Answer::No));
}

/// Were the second one begun over the first, that could not be resumed any more.
#[test]
fn after_a_stop_or_a_no_the_wires_that_follow_are_told() {
    let shop = Shop::new();
    let (seat, job) = (shop.simulated("sim:10"), shop.job("two-parts.obj", "wirebend-kit"));
    seat.home();
    start(&seat, &job, 1);
    seat.until_made(1);
    assert!(seat.operator.stop());
    let run = seat.until_run();
    assert_eq!((run.wires[0].outcome, run.left.as_slice()), (RunOutcome::Stopped, &[1][..]));
    let state = seat.until_phase(Phase::Stopped);
    assert_eq!(state.unfinished.map(|wire| wire.wire), Some(0));
    seat.home();
    let order =
        Order::Arm { wire: None, repeat: Repeat::default(), accept_settings: false, despite_errors: false };
    seat.operator.order_wire(order, job.clone()).unwrap();
    assert_eq!(seat.until_problem().0, "unfinished");
    drop(seat);

    let given_up = shop.run(&job, "sim:max", RunHow::Abandon).unwrap();
    assert_eq!(given_up.wires[0].outcome, RunOutcome::Abandoned);
    let seat = shop.simulated("sim:max");
    seat.home();
    start(&seat, &job, 1);
    assert_eq!(seat.until_run().left, [1]);
    let asked = seat.until_question();
    seat.operator.answer(asked.id, Answer::No).unwrap();
    let state = seat.until_phase(Phase::Ready);
    assert!(state.unfinished.is_none(), "nothing of the second one is bent: {state:?}");
}
