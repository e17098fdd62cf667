//! Homing, moves by hand, recordings.

use serde_json::{Value, json};
use wirebend_error::ErrorRemedy;
use wirebend_operation::{
    Answer, MachineEvent, Move, OperatorEvent, Order, OrderName, Phase, QuestionKind, RunOutcome,
};
use wirebend_planning::Output;

use crate::shop::{Seat, Shop};

fn jog(moves: &Value, record: bool) -> Value {
    json!({"order": "jog", "moves": moves, "record": record})
}

/// The moves that are reported until the machine is at rest.
fn jogged(seat: &Seat) -> Vec<Move> {
    let mut made = Vec::new();
    loop {
        match seat.next() {
            OperatorEvent::Jogged { made: one } => made.push(one),
            OperatorEvent::State(state) if state.phase == Phase::Ready && !state.busy => return made,
            OperatorEvent::Problem(problem) => panic!("{}", problem.message),
            OperatorEvent::Question(asked) => panic!("nothing moves, and a person is asked {asked:?}"),
            _ => {}
        }
    }
}

#[test]
fn a_machine_is_homed_jogged_recorded_and_replayed_on_one_connection() {
    let shop = Shop::new();
    let seat = shop.connect("wirebend-kit", Some("sim:max"));
    let state = seat.until_phase(Phase::Connected);
    assert_eq!((state.simulated, state.driver.as_deref()), (true, Some("wirebend-kit")));
    assert!(state.identity.unwrap().contains("firmware"), "the identity is reported");
    assert!(!state.can.contains(&OrderName::Jog) && state.can.contains(&OrderName::Home), "{:?}", state.can);

    seat.order(&json!({"order": "home"}));
    seat.until_phase(Phase::Homing);
    assert!(seat.until_phase(Phase::Ready).can.contains(&OrderName::Jog));
    seat.order(&jog(&json!([{"move": "feed", "mm": 10.0}]), false));
    assert_eq!(jogged(&seat), [Move::Feed { mm: 10.0 }]);
    let moves = json!([{"move": "home"}, {"move": "feed", "mm": 10.0}, {"move": "rotate", "deg": -90.0},
        {"move": "bend", "deg": 45.0}, {"move": "feed", "mm": -5.0}]);
    for one in moves.as_array().unwrap() {
        seat.order(&jog(&json!([one]), true));
        assert_eq!(json!(jogged(&seat)), json!([one]));
    }
    let state = seat.operator.state();
    assert_eq!(state.recorded, 5, "the first was not to be recorded");
    let at = state.position.unwrap();
    // Where it feeds from counts from the start of the controller's session.
    assert!((at.rotate_deg + 90.0).abs() < 0.1 && at.bend_deg.abs() < 0.1, "{at:?}");

    let file = shop.folder.path().join("a.wbmoves");
    let output = Output { path: file.clone(), force: false };
    assert_eq!(json!(seat.operator.recorded()), moves);
    seat.operator.save_recording(&output).unwrap();
    assert_eq!(seat.operator.save_recording(&output).unwrap_err().code(), "exists");
    seat.operator.clear_recording();
    assert_eq!(seat.operator.save_recording(&output).unwrap_err().code(), "nothing-recorded");
    let saved: Value = serde_json::from_slice(&std::fs::read(&file).unwrap()).unwrap();
    assert_eq!((&saved["moves"], &saved["machine"]), (&moves, &json!("wirebend-kit")));

    seat.until_state(|state| state.recorded == 0);
    seat.operator.order(Order::Replay { file: Some(file), other_machine: false }).unwrap();
    // Also where nothing moves a person sees first what a file holds.
    let asked = seat.until_question();
    assert_eq!(asked.kind, QuestionKind::Move);
    assert!(asked.lines.iter().any(|line| line.starts_with("moves: ")), "{asked:?}");
    seat.operator.answer(asked.id, Answer::Yes).unwrap();
    assert_eq!(json!(jogged(&seat)), moves);
    seat.order(&json!({"order": "disconnect"}));
    let closed = seat.until_phase(Phase::Closed);
    assert!(closed.can.is_empty());
    assert_eq!(seat.refused(Order::Home).0, "not-now");
}

/// Many moves at one word: the word for moves one by one does not count for them.
#[test]
fn what_was_just_recorded_is_replayed_only_after_a_question() {
    let shop = Shop::new();
    let seat = shop.simulated("sim:max");
    seat.home();
    seat.order(&jog(&json!([{"move": "rotate", "deg": 30.0}]), true));
    jogged(&seat);
    seat.operator.order(Order::Replay { file: None, other_machine: false }).unwrap();
    let asked = seat.until_question();
    assert_eq!(asked.kind, QuestionKind::Move);
    assert!(asked.lines.iter().any(|line| line == "moves: rotate 30°"), "{asked:?}");
    seat.operator.answer(asked.id, Answer::No).unwrap();
    seat.until_state(|state| state.question.is_none() && !state.busy);
    seat.operator.order(Order::Replay { file: None, other_machine: false }).unwrap();
    seat.operator.answer(seat.until_question().id, Answer::Yes).unwrap();
    seat.until_phase(Phase::Homing);
    seat.until_phase(Phase::Ready);
    let at = seat.operator.state().position.unwrap();
    assert!((at.rotate_deg - 30.0).abs() < 0.1, "turned once, not twice: {at:?}");
    assert_eq!(seat.operator.state().recorded, 1, "a replay is not recorded");
    seat.operator.clear_recording();
    seat.until_state(|state| state.recorded == 0);
    seat.operator.order(Order::Replay { file: None, other_machine: false }).unwrap();
    assert_eq!(seat.until_problem().0, "nothing-recorded");
}

/// A recording counts from the reference: a machine whose head was turned since then homes first.
#[test]
fn a_recording_begins_at_the_reference() {
    let shop = Shop::new();
    let seat = shop.simulated("sim:max");
    seat.home();
    seat.order(&jog(&json!([{"move": "rotate", "deg": 30.0}]), true));
    jogged(&seat);
    let file = shop.folder.path().join("a.wbmoves");
    seat.operator.save_recording(&Output { path: file.clone(), force: false }).unwrap();
    seat.operator.order(Order::Replay { file: Some(file), other_machine: false }).unwrap();
    seat.operator.answer(seat.until_question().id, Answer::Yes).unwrap();
    seat.until_phase(Phase::Homing);
    seat.until_phase(Phase::Moving);
    seat.until_phase(Phase::Ready);
    let at = seat.operator.state().position.unwrap();
    assert!((at.rotate_deg - 30.0).abs() < 0.1, "turned once, not twice: {at:?}");
}

/// Each move of the cube, its bends with the peg in. Afterwards the head is where they leave it, and a wire homes first.
#[test]
fn a_dry_run_makes_each_move_of_a_wire_without_wire() {
    let shop = Shop::new();
    let (seat, job) = (shop.simulated("sim:max"), shop.cube("wirebend-kit"));
    seat.home();
    let dry = |wire| Order::DryRun { wire, accept_settings: false, despite_errors: false };
    seat.operator.order_wire(dry(0), job.clone()).unwrap();
    // On a simulated machine too: who practises there learns what a real one asks.
    let asked = seat.says(Answer::Yes);
    assert!(asked.lines.iter().any(|line| line.contains("remove the wire")), "{asked:?}");
    // Its lines as the firmware has them: feed, rotation and bend, of which each has one.
    let (mut moves, mut moving) = ([0; 3], false);
    loop {
        match seat.next() {
            OperatorEvent::Machine(MachineEvent::Console { to_machine: true, text }) => {
                let Some((letter, fields)) = text.split('*').next().and_then(|line| line.split_at_checked(1))
                else {
                    continue;
                };
                assert_ne!(letter, "M", "it would bend: {text}");
                if letter == "Y" {
                    let (_number, steps) = fields.split_once(',').expect("a line has moves");
                    let steps = steps.split(',').map(|field| field.parse::<i64>().unwrap());
                    steps.enumerate().for_each(|(axis, by)| moves[axis] += i32::from(by != 0));
                }
            }
            OperatorEvent::State(state) => {
                moving |= state.phase == Phase::Moving;
                if moving && state.phase == Phase::Ready && !state.busy {
                    break;
                }
            }
            OperatorEvent::Jogged { made } => panic!("it would be drawn as bent by hand: {made}"),
            OperatorEvent::Problem(problem) => panic!("{}", problem.message),
            _ => {}
        }
    }
    assert_eq!((moves[0], moves[2]), (8, 7), "{moves:?}");
    assert_eq!(seat.operator.state().recorded, 0);
    // There was no wire in it.
    seat.arm(&job);
    let asked = seat.says(Answer::Yes);
    assert!(!asked.lines.iter().any(|line| line.contains("fed or bent by hand")), "{asked:?}");
    seat.until_phase(Phase::Armed);
    seat.order(&json!({"order": "start"}));
    seat.until_phase(Phase::Homing);
    assert_eq!(seat.until_run().wires[0].outcome, RunOutcome::Made);
    seat.until_state(|state| !state.busy);
    seat.operator.order_wire(dry(7), job).unwrap();
    assert_eq!(seat.until_problem().0, "no-wire");
}

#[test]
fn what_makes_no_sense_now_is_refused_with_what_to_do() {
    let shop = Shop::new();
    let seat = shop.simulated("sim:max");
    let feed = || Order::Jog { moves: vec![Move::Feed { mm: 1.0 }], record: false };
    for (order, said) in [
        (feed(), "moving by hand is not possible while the machine is not homed"),
        (Order::Start, "starting a wire is not possible while the machine is not homed"),
        (Order::Pause, "pausing is not possible while the machine is not homed"),
    ] {
        let error = seat.operator.order(order).unwrap_err();
        assert_eq!((error.code().as_str(), error.to_string()), ("not-now", said.to_owned()));
        assert_eq!(error.remedies(), [ErrorRemedy::Home]);
    }
    assert_eq!(seat.operator.answer(1, Answer::Yes).unwrap_err().code(), "no-question");
    // One that finds its reference first knows where it is.
    seat.order(&jog(&json!([{"move": "home"}, {"move": "feed", "mm": 1.0}]), false));
    assert_eq!(jogged(&seat).len(), 2);
    // What is no move is refused where the others are done.
    seat.order(&jog(&json!([]), false));
    assert_eq!(seat.until_problem().0, "value");
    seat.until_phase(Phase::Ready);
    seat.order(&jog(&json!([{"move": "bend", "deg": 170.0}]), false));
    let (_, message) = seat.until_problem();
    assert!(message.contains("155"), "{message}");
    let state = seat.until_phase(Phase::Ready);
    assert!(state.problem.is_some_and(|problem| problem.message == message), "it is reported with the state");
    // And the machine can be moved anyway.
    seat.order(&jog(&json!([{"move": "feed", "mm": 1.0}]), false));
    assert_eq!(jogged(&seat).len(), 1);
}

/// On a machine that moves, a person is asked once; after a stop they are asked again.
#[test]
fn a_real_machine_is_moved_at_a_persons_word() {
    let shop = Shop::odd("hostile", |_| json!({}));
    let seat = shop.connect("odd", Some("anywhere"));
    assert!(!seat.until_phase(Phase::Connected).simulated);
    seat.order(&json!({"order": "home"}));
    let question = seat.says(Answer::No);
    assert_eq!((question.kind, question.question.as_str()), (QuestionKind::Move, "May the machine move?"));
    assert!(question.lines.iter().any(|line| line.contains("moves: home")), "{:?}", question.lines);
    assert_eq!(seat.until_phase(Phase::Connected).question, None);
    seat.order(&json!({"order": "home"}));
    let question = seat.until_question();
    assert_eq!(seat.refused(Order::Home).0, "question-open");
    assert_eq!(seat.operator.answer(question.id, Answer::Made).unwrap_err().code(), "wrong-answer");
    seat.operator.answer(question.id, Answer::Yes).unwrap();
    seat.until_phase(Phase::Ready);
    let feed = jog(&json!([{"move": "feed", "mm": 1.0}]), false);
    // `jogged` fails at a question.
    seat.order(&feed);
    assert_eq!(jogged(&seat).len(), 1);
    assert!(seat.operator.stop());
    seat.until_phase(Phase::Stopped);
    seat.order(&json!({"order": "home"}));
    seat.says(Answer::Yes);
    seat.until_phase(Phase::Ready);
}
